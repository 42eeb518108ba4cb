//! Matched, missed, spurious and misordered impacts of one frame.
//!
//! Impacts match as the k-th impact of their pair within the frame. Order
//! matters only between impacts that share a disc; a matched impact is
//! misordered if, for one of its discs, it stands before a matched one that
//! the truth puts ahead of it.

use std::collections::HashMap;
use std::ops::AddAssign;

use crate::body::{BodyId, Pair};
use crate::impact::Impact;
use crate::scalar::Scalar;
use crate::scene::Scene;

/// What a judgement needs of an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Logged {
    /// The two bodies.
    pub pair: Pair,
    /// The time, as the nearest binary64.
    pub time: f64,
    /// The number of its group of simultaneous impacts.
    pub tie: Option<u32>,
}

impl Logged {
    /// Whether both bodies are those of a scene, the first one a disc and the other one
    /// not the same.
    pub fn is_of(&self, scene: &Scene) -> bool {
        let is_of = |body| match body {
            BodyId::Disc(index) => (index as usize) < scene.discs().len(),
            BodyId::Wall(index) => (index as usize) < scene.walls().len(),
        };
        let Pair { a, b } = self.pair;
        matches!(a, BodyId::Disc(_)) && a != b && is_of(a) && is_of(b)
    }
}

impl<S: Scalar> From<&Impact<S>> for Logged {
    fn from(impact: &Impact<S>) -> Self {
        Self {
            pair: impact.pair,
            time: impact.time.to_f64(),
            tie: impact.tie,
        }
    }
}

/// How many impacts agree with the truth, and how many do not.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    /// Impacts in both.
    pub matched: u64,
    /// Impacts in the truth only.
    pub missed: u64,
    /// Impacts in the candidate only.
    pub spurious: u64,
    /// Matched impacts in another order that matters.
    pub misordered: u64,
    /// The largest error of a matched impact's time.
    pub time_error: f64,
    /// The same in ulps of the true time.
    pub time_error_ulps: f64,
    /// The largest distance of a disc from where it should be at the end.
    pub position_error: f64,
    /// The largest relative error of the kinetic energy at the end.
    pub energy_error: f64,
    /// The pairs that overlap at the end, by however little.
    pub overlaps: u64,
    /// How deep the deepest of them is.
    pub overlap_depth: f64,
}

impl Tally {
    /// The impacts that are missed, spurious or misordered.
    pub fn wrong(&self) -> u64 {
        self.missed + self.spurious + self.misordered
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.matched += other.matched;
        self.missed += other.missed;
        self.spurious += other.spurious;
        self.misordered += other.misordered;
        self.time_error = self.time_error.max(other.time_error);
        self.time_error_ulps = self.time_error_ulps.max(other.time_error_ulps);
        self.position_error = self.position_error.max(other.position_error);
        self.energy_error = self.energy_error.max(other.energy_error);
        self.overlaps += other.overlaps;
        self.overlap_depth = self.overlap_depth.max(other.overlap_depth);
    }
}

/// Judges the impacts of a frame against the true ones.
pub fn compare_frame(truth: &[Logged], candidate: &[Logged]) -> Tally {
    let matches = match_up(truth, candidate);
    let mut tally = Tally {
        matched: matches.len() as u64,
        missed: (truth.len() - matches.len()) as u64,
        spurious: (candidate.len() - matches.len()) as u64,
        misordered: count_misordered(truth, candidate, &matches),
        ..Tally::default()
    };
    for &(t, c) in &matches {
        let error = (candidate[c].time - truth[t].time).abs();
        tally.time_error = tally.time_error.max(error);
        tally.time_error_ulps = tally.time_error_ulps.max(error / ulp(truth[t].time));
    }
    tally
}

/// The distance of a binary64 to the next.
pub(super) fn ulp(x: f64) -> f64 {
    x.abs().next_up() - x.abs()
}

/// The k-th impact of each pair in one with that in the other, by the
/// candidate's order.
pub(super) fn match_up(truth: &[Logged], candidate: &[Logged]) -> Vec<(usize, usize)> {
    let mut places: HashMap<Pair, Vec<usize>> = HashMap::new();
    for (index, impact) in truth.iter().enumerate().rev() {
        places.entry(impact.pair).or_default().push(index);
    }
    let matches = candidate.iter().enumerate();
    matches
        .filter_map(|(c, impact)| Some((places.get_mut(&impact.pair)?.pop()?, c)))
        .collect()
}

/// Counts the matches that come before one which the truth puts ahead.
fn count_misordered(truth: &[Logged], candidate: &[Logged], matches: &[(usize, usize)]) -> u64 {
    let mut earliest: HashMap<BodyId, usize> = HashMap::new();
    let mut misordered = 0;
    for &(t, c) in matches.iter().rev() {
        let Pair { a, b } = candidate[c].pair;
        let discs = [a, b]
            .into_iter()
            .filter(|body| matches!(body, BodyId::Disc(_)));
        let mut too_early = false;
        for disc in discs {
            let ahead = earliest.entry(disc).or_insert(t);
            too_early |= *ahead < t && !simultaneous(&truth[*ahead], &truth[t]);
            *ahead = t.min(*ahead);
        }
        misordered += u64::from(too_early);
    }
    misordered
}

/// Whether two impacts are proven to happen at the same time, so that their
/// order is a convention.
fn simultaneous(one: &Logged, other: &Logged) -> bool {
    one.tie.is_some() && one.tie == other.tie
}
