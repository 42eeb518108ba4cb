//! How long a binary64 run takes.

use std::convert::Infallible;
use std::time::{Duration, Instant};

use carom::arithmetic::Arithmetic;
use carom::frame::BroadPhase;
use carom::scene::Scene;
use carom::simulation::{Algorithm, Simulation};

/// A run is repeated until all together have taken so long.
const ENOUGH_TIME: Duration = Duration::from_millis(500);

/// And so often at the most.
const ENOUGH_RUNS: usize = 25;

/// The median of the times that runs of all frames take.
pub(super) fn median_cost<S: Arithmetic<Precision = (), Doubt = Infallible>>(
    scene: &Scene,
    algorithm: Algorithm,
    phase: BroadPhase,
) -> Duration {
    let begun = Instant::now();
    let mut costs = Vec::new();
    while costs.is_empty() || costs.len() < ENOUGH_RUNS && begun.elapsed() < ENOUGH_TIME {
        costs.push(cost::<S>(scene, algorithm, phase));
    }
    costs.sort();
    costs[costs.len() / 2]
}

fn cost<S: Arithmetic<Precision = (), Doubt = Infallible>>(
    scene: &Scene,
    algorithm: Algorithm,
    phase: BroadPhase,
) -> Duration {
    let begun = Instant::now();
    let Ok(simulation) = Simulation::<S>::new(scene, algorithm, ());
    let mut simulation = simulation.with_broad_phase(phase);
    for _ in 0..scene.frame().count {
        let Ok(_impacts) = simulation.next_frame();
    }
    begun.elapsed()
}
