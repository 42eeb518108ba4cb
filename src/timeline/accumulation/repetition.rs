//! A word of pairs that repeats while its intervals shrink.
//!
//! Nothing here is proven. The latest impacts must repeat one word for
//! [`PERIODS`] periods, the last durations of a period must shrink by a ratio
//! r that has settled, and what is left of a geometric series, d r / (1 - r)
//! after a period of duration d, must be at most [`NEGLIGIBLE`] of the run's
//! duration. Shrinking that itself slows down, as that of 1/n², is thus not
//! recognised until very late. A word that repeats for [`STALLED`] impacts at
//! one time, or at what binary64 makes one, accumulates there.

use std::collections::VecDeque;

use super::Accumulation;
use crate::body::Pair;
use crate::impact::Impact;
use crate::kernel::Kernel;

/// The longest word that is looked for.
const LONGEST: usize = 12;

/// For how many periods a word must have repeated.
const PERIODS: usize = 4;

/// How many impacts of a word at one time are taken for infinitely many.
const STALLED: usize = 64;

/// The durations of a period that are compared.
const DURATIONS: usize = 3;

/// The part of the run that may be left to the limit.
const NEGLIGIBLE: f64 = 1e-10;

/// How much a settled ratio may still change, as a part of its distance to 1.
const UNSETTLED: f64 = 1.0 / 16.0;

/// The latest impacts, the last one in front.
#[derive(Clone, Debug)]
pub(super) struct Repetition<S> {
    latest: VecDeque<(Pair, S)>,
    negligible: f64,
}

impl<S: Kernel> Repetition<S> {
    /// For a run of some duration.
    pub(super) fn within(duration: &S) -> Self {
        Self {
            latest: VecDeque::new(),
            negligible: duration.to_f64() * NEGLIGIBLE,
        }
    }

    pub(super) fn note(&mut self, impact: &Impact<S>) {
        self.latest.truncate(STALLED.max(LONGEST * PERIODS) - 1);
        self.latest.push_front((impact.pair, impact.time.clone()));
    }

    /// The accumulation that the latest impacts suggest.
    pub(super) fn accumulation(&self) -> Option<Accumulation<S>> {
        let period = (2..=LONGEST).find(|&period| self.repeats(period, period * PERIODS))?;
        let limit = self.stall(period).or_else(|| self.extrapolate(period))?;
        let word = self.latest.range(..period).rev();
        Some(Accumulation {
            limit: [limit.clone(), limit],
            proven: false,
            word: word.map(|(pair, _)| *pair).collect(),
        })
    }

    /// Whether each of the latest pairs is that one period before.
    fn repeats(&self, period: usize, count: usize) -> bool {
        self.latest.len() >= count
            && (period..count).all(|index| self.latest[index].0 == self.latest[index - period].0)
    }

    /// The time at which a word goes on and on.
    fn stall(&self, period: usize) -> Option<S> {
        let count = STALLED.max(period * PERIODS);
        let stalls = self.repeats(period, count) && self.time_since(count - 1) <= 0.0;
        stalls.then(|| self.latest[0].1.clone())
    }

    /// The limit of a geometric series.
    fn extrapolate(&self, period: usize) -> Option<S> {
        let ends: [f64; DURATIONS + 1] =
            std::array::from_fn(|index| self.time_since(index * period));
        let [last, middle, first] = std::array::from_fn(|index| ends[index + 1] - ends[index]);
        let (ratio, before) = (last / middle, middle / first);
        let left = last * ratio / (1.0 - ratio);
        let has_settled = (ratio - before).abs() <= UNSETTLED * (1.0 - ratio);
        let is_near = ratio > 0.0 && ratio < 1.0 && left <= self.negligible;
        (has_settled && is_near).then(|| self.ahead(period))
    }

    /// How long ago an impact was, to binary64.
    fn time_since(&self, index: usize) -> f64 {
        (self.latest[0].1.clone() - &self.latest[index].1).to_f64()
    }

    /// The time of the latest impact and the rest of the series.
    fn ahead(&self, period: usize) -> S {
        let [end, middle, first] = [0, 1, 2].map(|index| self.latest[index * period].1.clone());
        let (last, before) = (end.clone() - &middle, middle - &first);
        end + last.square() / (before - &last)
    }
}
