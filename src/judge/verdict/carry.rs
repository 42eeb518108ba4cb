//! How far binary64 carries the order of impacts.
//!
//! What a good program in binary64 can do is what two of them do: the timeline in
//! [`f64`], and in [`Filtered`], whose every decision is exact for its numbers. Where
//! one of them leaves the truth is the horizon: beyond that, no program is to blame. Up
//! to there the errors of their times tell what binary64 resolves.

use std::ops::ControlFlow;

use crate::arithmetic::Arithmetic;
use crate::judge::difference::first_difference;
use crate::judge::matching::match_up;
use crate::judge::tally::{Logged, ulp};
use crate::run::{Options, run};
use crate::scalar::Filtered;
use crate::scene::Scene;
use crate::simulation::Algorithm;

/// A program may err by so much more than these.
const LENIENCE: f64 = 16.0;

/// What is computed from exact numbers may err by so many ulps.
pub(super) const ROUNDING: f64 = 8.0;

/// How far binary64 follows the truth.
#[derive(Clone, Debug)]
pub(super) struct Carry {
    /// The time from which it does not.
    pub(super) horizon: f64,
    /// The largest error of a time so far, at each time at which that grows.
    errors: Vec<(f64, f64)>,
}

impl Carry {
    /// Runs a scene in binary64, up to the end that the options name.
    pub(super) fn find(scene: &Scene, options: &Options, truth: &[Logged]) -> Self {
        let mut carry = Self {
            horizon: f64::INFINITY,
            errors: Vec::new(),
        };
        carry.follow::<f64>(scene, options, truth);
        carry.follow::<Filtered>(scene, options, truth);
        carry.errors.sort_by(|one, other| one.0.total_cmp(&other.0));
        let mut largest = 0.0_f64;
        for (_, error) in &mut carry.errors {
            largest = largest.max(*error);
            *error = largest;
        }
        carry
    }

    /// Takes a run into account, if the arithmetic can do it.
    fn follow<S: Arithmetic>(&mut self, scene: &Scene, options: &Options, truth: &[Logged]) {
        let go_on = &mut |_| ControlFlow::Continue(());
        let Ok(outcome) = run::<S>(scene, Algorithm::Timeline, options, go_on) else {
            return;
        };
        let log: Vec<_> = outcome.impacts.iter().map(Logged::from).collect();
        if let Some(difference) = first_difference(truth, &log) {
            self.horizon = self.horizon.min(difference.time);
        }
        let pairs = match_up(truth, &log).into_iter();
        let times = pairs.map(|(t, c)| (truth[t].time, log[c].time));
        let errors = times.map(|(time, computed)| (time, (computed - time).abs()));
        self.errors
            .extend(errors.filter(|(time, _)| *time < self.horizon));
    }

    /// The least difference of two times that binary64 resolves at a time.
    pub(super) fn resolution(&self, time: f64) -> f64 {
        let known = self.errors.partition_point(|(when, _)| *when <= time);
        let error = known.checked_sub(1).map_or(0.0, |last| self.errors[last].1);
        (ROUNDING * ulp(time)).max(LENIENCE * error)
    }
}
