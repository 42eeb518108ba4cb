//! What proof costs: the exact timeline's time against the number of impacts and
//! against the bits.

use std::ops::ControlFlow::Continue;
use std::time::Instant;

use carom::arithmetic::Budget;
use carom::run::{Options, Status, run};
use carom::scalar::Exact;
use carom::scene::Scene;
use carom::simulation::Algorithm;

use crate::cli::compare::truth::Truth;

/// A scene's first part is run if that can be expected to take so many seconds.
const PATIENCE: f64 = 3.0;

/// The bits are doubled so often.
const DOUBLINGS: u32 = 4;

/// An exact run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Proof {
    pub(super) impacts: usize,
    /// The bits that it took.
    pub(super) bits: u32,
    /// With the attempts that had too few bits.
    pub(super) seconds: f64,
}

/// The runs that show what proof costs.
#[derive(Clone, Debug)]
pub(super) struct Growth {
    /// Ever more of the scene.
    pub(super) longer: Vec<Proof>,
    /// The same part of it with ever more bits than it takes.
    pub(super) wider: Vec<Proof>,
}

impl Growth {
    /// Runs a scene's first parts; none if there is nothing to see.
    pub(super) fn run(scene: &Scene, truth: &Truth, part: &Scene, budget: &Budget) -> Option<Self> {
        let frames = scene.frame().count;
        let expected = truth.cost.as_secs_f64();
        let counts = (0..6).rev().map(|halvings| frames >> halvings);
        let affordable = counts
            .filter(|count| *count > 0 && expected * *count as f64 / frames as f64 <= PATIENCE);
        let longer = affordable.filter_map(|count| {
            let duration = scene.frame().duration.clone();
            let scene = scene.to_builder().frame(duration, count).build().ok()?;
            prove(&scene, *budget)
        });
        let growth = Self {
            longer: longer.filter(|proof| proof.impacts > 0).collect(),
            wider: widened(part, budget),
        };
        (growth.longer.len() > 1).then_some(growth)
    }
}

fn widened(scene: &Scene, budget: &Budget) -> Vec<Proof> {
    let Some(least) = prove(scene, *budget).filter(|proof| proof.impacts > 0) else {
        return Vec::new();
    };
    let bits = (0..=DOUBLINGS).map(|doublings| least.bits << doublings);
    let bits = bits.filter(|bits| *bits <= budget.most_bits);
    let runs = bits.filter_map(|first_bits| {
        let budget = Budget {
            first_bits,
            ..*budget
        };
        prove(scene, budget)
    });
    runs.collect()
}

fn prove(scene: &Scene, budget: Budget) -> Option<Proof> {
    let options = Options {
        budget,
        max_events: u64::MAX,
        ..Options::default()
    };
    let begun = Instant::now();
    let outcome = run::<Exact>(scene, Algorithm::Timeline, &options, &mut |_| Continue(()));
    let outcome = outcome.ok()?;
    let seconds = begun.elapsed().as_secs_f64();
    (outcome.status == Status::Complete).then_some(Proof {
        impacts: outcome.impacts.len(),
        bits: outcome.precision,
        seconds,
    })
}
