//! carom itself.

use std::convert::Infallible;
use std::time::Instant;

use carom::arithmetic::Arithmetic;
use carom::frame::BroadPhase;
use carom::scalar::Filtered;
use carom::scene::Scene;
use carom::simulation::{Algorithm, Simulation};
use carom::timeline::Timeline;
use carom::world::World;

/// Impacts a second of the timeline in binary64.
pub fn pace(scene: &Scene, impacts: u64) -> f64 {
    pace_in::<f64>(scene, impacts, f64::MAX)
}

/// The same where every decision is exact.
pub fn filtered_pace(scene: &Scene, impacts: u64) -> f64 {
    // Beyond the end of any run here.
    let end = Filtered::new(1e9);
    pace_in::<Filtered>(scene, impacts, end)
}

fn pace_in<S>(scene: &Scene, impacts: u64, end: S) -> f64
where
    S: Arithmetic<Precision = (), Doubt = Infallible>,
{
    let Ok(mut timeline) = Timeline::new(World::<S>::new(scene, ()), &end);
    let begun = Instant::now();
    for _ in 0..impacts {
        let Ok(impact) = timeline.next_impact(&end);
        assert!(impact.is_some(), "a gas never comes to rest");
    }
    impacts as f64 / begun.elapsed().as_secs_f64()
}

/// Milliseconds that the timeline takes for a frame.
pub fn frame_of_timeline(scene: &Scene) -> f64 {
    frame::<f64>(scene, Algorithm::Timeline)
}

/// The same where every decision is exact.
pub fn frame_of_filtered(scene: &Scene) -> f64 {
    frame::<Filtered>(scene, Algorithm::Timeline)
}

/// Milliseconds that one pass over all pairs takes, as the paper has it.
pub fn frame_of_single(scene: &Scene) -> f64 {
    frame::<f64>(scene, Algorithm::Single)
}

fn frame<S>(scene: &Scene, algorithm: Algorithm) -> f64
where
    S: Arithmetic<Precision = (), Doubt = Infallible>,
{
    let frames = scene.frame().count;
    let begun = Instant::now();
    let Ok(simulation) = Simulation::<S>::new(scene, algorithm, ());
    let mut simulation = simulation.with_broad_phase(BroadPhase::AllPairs);
    for _ in 0..frames {
        let Ok(_impacts) = simulation.next_frame();
    }
    begun.elapsed().as_secs_f64() * 1e3 / frames as f64
}
