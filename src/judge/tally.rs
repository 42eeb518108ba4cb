//! What is counted of impacts that are held against the truth.

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

/// The distance of a binary64 to the next.
pub(super) fn ulp(x: f64) -> f64 {
    x.abs().next_up() - x.abs()
}
