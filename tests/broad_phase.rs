//! The ways to find what a disc may meet lead to the same impacts: here on the
//! timeline.

mod frames;

use crate::common::strategy::cases;
use crate::common::{attempt, name};
use carom::arithmetic::Arithmetic;
use carom::run::{Options, Outcome, Status};
use carom::scalar::{Exact, Filtered};
use carom::scene::{Disc, DiscBuilder, Scene};
use carom::simulation::Algorithm;
use carom::timeline::BroadPhase;
use proptest::prelude::*;

const MOST_IMPACTS: u64 = 150;

fn run<S: Arithmetic>(scene: &Scene, broad_phase: BroadPhase) -> Outcome<S> {
    let options = Options {
        max_events: MOST_IMPACTS,
        broad_phase,
        ..Options::default()
    };
    attempt(scene, Algorithm::Timeline, &options)
}

/// What must not depend on the broad phase.
fn told<S: Arithmetic>(outcome: &Outcome<S>) -> (Vec<(String, u64)>, u64, Status) {
    let impacts = outcome.impacts.iter();
    let impacts = impacts.map(|impact| (name(impact), impact.time.to_f64().to_bits()));
    (impacts.collect(), outcome.grazes, outcome.status.clone())
}

fn assert_same<S: Arithmetic>(scene: &Scene) {
    let [all, grid] = [BroadPhase::AllPairs, BroadPhase::Grid].map(|phase| run::<S>(scene, phase));
    assert_eq!(told(&all), told(&grid), "{}", S::NAME);
}

/// How the discs of a scene differ.
#[derive(Clone, Copy, Debug)]
enum Kind {
    Alike,
    /// Radii of 1 : 100.
    Mixed,
    /// Among others that are alike, one that is large, one that is fast, one of
    /// infinite mass that moves, and one that does not.
    Odd,
}

/// A disc somewhere in a cell of four by four, of which many are in a row.
fn disc(cell: usize, kind: Kind) -> impl Strategy<Value = DiscBuilder> {
    let numbers = ([0.0..1.0_f64, 0.0..1.0_f64], [-1.0..1.0_f64, -1.0..1.0_f64]);
    (numbers, 0.0..1.0_f64).prop_map(move |((place, velocity), size)| {
        let radius = match kind {
            Kind::Mixed => 1.5 * 100_f64.powf(-size),
            Kind::Alike | Kind::Odd => 1.0,
        };
        let [column, row] = [cell % 7, cell / 7].map(|index| index as f64 * 4.0 + 1.5);
        let position = [column + place[0], row + place[1]];
        let disc = |radius, velocity: [f64; 2]| Disc::at(position, radius).velocity(velocity);
        match (kind, cell) {
            (Kind::Odd, 8) => disc(2.0, velocity).mass(7),
            (Kind::Odd, 10) => disc(1.0, velocity.map(|speed| 400.0 * speed)),
            (Kind::Odd, 12) => disc(1.0, velocity).infinite_mass(),
            (Kind::Odd, 22) => disc(1.0, [0.0; 2]).infinite_mass(),
            _ => disc(radius, velocity),
        }
    })
}

/// Some forty discs, in a box or in the open, with a few walls across.
fn scene(kind: Kind) -> impl Strategy<Value = Scene> {
    let discs: Vec<_> = (0..42).map(|cell| disc(cell, kind)).collect();
    let end = || [-10.0..40.0_f64, -10.0..40.0_f64];
    let walls = prop::collection::vec((end(), end()), 0..4);
    (discs, walls, any::<bool>(), [-1e4..1e4_f64, -1e4..1e4_f64]).prop_map(
        |(discs, walls, is_boxed, [x, y])| {
            let mut scene = Scene::builder("test").frame(20, 1);
            for disc in discs {
                scene = scene.disc(disc);
            }
            if is_boxed {
                scene = scene.walls_around([-0.5, -0.5], [30.0, 26.0]);
            }
            for (from, to) in walls {
                scene = scene.wall(from, to);
            }
            scene = scene.wall([x, y], [y - 1.0, x]);
            scene.build().expect("a valid scene")
        },
    )
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn discs_alike(scene in scene(Kind::Alike)) {
        assert_same::<f64>(&scene);
        assert_same::<Filtered>(&scene);
    }

    #[test]
    fn mixed_radii(scene in scene(Kind::Mixed)) {
        assert_same::<f64>(&scene);
        assert_same::<Filtered>(&scene);
    }

    #[test]
    fn odd_discs(scene in scene(Kind::Odd)) {
        assert_same::<f64>(&scene);
        assert_same::<Filtered>(&scene);
    }
}

proptest! {
    #![proptest_config(cases(6))]

    #[test]
    fn exactly(scene in prop_oneof![scene(Kind::Alike), scene(Kind::Mixed), scene(Kind::Odd)]) {
        assert_same::<Exact>(&scene);
    }
}

/// Discs that fly apart for ever end the run at once, however long it lasts.
#[test]
fn the_open_has_an_end() {
    let mut scene = Scene::builder("test").frame("1e30", 1);
    for index in 0..40 {
        let place = f64::from(index) * 3.0;
        scene = scene.disc(Disc::at([place, 0.0], 1).velocity([place, 1.0]));
    }
    let outcome = run::<f64>(&scene.build().unwrap(), BroadPhase::Grid);
    assert_eq!(
        (outcome.impacts.len(), outcome.status),
        (0, Status::Complete)
    );
}
