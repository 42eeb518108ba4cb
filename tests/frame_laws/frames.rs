//! What holds of every frame.

use carom::arithmetic::{Arithmetic, Budget};
use carom::body::{Disc, Mass};
use carom::frame::Passes;
use carom::impact::Impact;
use carom::run::Options;
use carom::scalar::{Exact, Scalar};
use carom::scene::Scene;
use carom::simulation::{Algorithm, Simulation};
use proptest::prelude::*;

use super::ALL;
use crate::common::agree::contains_zero;
use crate::common::strategy::{cases, cluster, lossy};
use crate::common::{attempt, complete, numbers};

fn framed(scene: &Scene) -> Scene {
    scene.to_builder().frame("1/2", 12).build().unwrap()
}

/// Momentum and twice the energy.
fn conserved(discs: &[Disc<Exact>]) -> [Exact; 3] {
    let mut sums = [0; 3].map(Exact::from_integer);
    for disc in discs {
        let Mass::Finite(mass) = &disc.mass else {
            unreachable!("all masses are finite");
        };
        let [.., vx, vy] = numbers(disc);
        let energy = vx.square() + vy.square();
        for (sum, part) in sums.iter_mut().zip([vx, vy, energy]) {
            *sum = sum.clone() + part * mass;
        }
    }
    sums
}

/// By frame, then pass, then pair; impacts at the same end of one frame's pass
/// stand by the pair alone.
fn in_order<S>(impacts: &[Impact<S>]) -> bool {
    impacts.is_sorted_by_key(|impact| (impact.step, impact.pair))
}

/// The times on both clocks are within the frame.
fn within_frame(impact: &Impact<f64>, duration: f64) -> bool {
    let step = impact.step.unwrap();
    let start = step.frame as f64 * duration;
    let times = [Some(impact.time), impact.other_time];
    times
        .into_iter()
        .flatten()
        .all(|time| (start..=start + duration).contains(&time))
}

fn impacts<S: Arithmetic>(scene: &Scene, algorithm: Algorithm) -> Vec<Impact<S>> {
    complete::<S>(scene, algorithm).impacts
}

proptest! {
    #![proptest_config(cases(50))]

    /// Every pass exchanges momentum and energy, and makes none: whatever is
    /// missed or invented. A run with one more pass shows that pass; one that
    /// ends undecided, the passes up to there.
    #[test]
    fn every_pass_conserves(scene in cluster()) {
        let scene = framed(&scene);
        let budget = Budget { most_bits: 512, ..Budget::default() };
        let options = Options { budget, ..Options::default() };
        let passes = (1..=4).map(Passes::Count);
        let more = passes.flat_map(|count| [Algorithm::Multiple(count), Algorithm::Synchronised(count)]);
        for algorithm in ALL.into_iter().chain(more) {
            let outcome = attempt::<Exact>(&scene, algorithm, &options);
            let sums = conserved(&outcome.start).into_iter().zip(conserved(&outcome.end));
            for (before, after) in sums {
                prop_assert!(contains_zero(&(before - &after)), "{algorithm:?}");
            }
        }
    }

    #[test]
    fn the_log_is_in_order(scene in lossy()) {
        let scene = framed(&scene);
        for algorithm in ALL {
            prop_assert!(in_order(&impacts::<Exact>(&scene, algorithm)));
            let impacts = impacts::<f64>(&scene, algorithm);
            prop_assert!(in_order(&impacts));
            prop_assert!(impacts.iter().all(|impact| within_frame(impact, 0.5)));
        }
    }

    /// A run is its frames.
    #[test]
    fn frame_by_frame(scene in lossy()) {
        let scene = framed(&scene);
        for algorithm in ALL {
            let whole = complete::<f64>(&scene, algorithm);
            let mut simulation = Simulation::<f64>::new(&scene, algorithm, ()).unwrap();
            let frames = 0..scene.frame().count;
            let impacts = frames.flat_map(|_| simulation.next_frame().unwrap());
            let times: Vec<_> = impacts.map(|impact| impact.time).collect();
            let expected: Vec<_> = whole.impacts.iter().map(|impact| impact.time).collect();
            prop_assert_eq!(times, expected);
            let end: Vec<_> = simulation.discs().iter().map(numbers).collect();
            let expected: Vec<_> = whole.end.iter().map(numbers).collect();
            prop_assert_eq!(end, expected);
        }
    }
}
