//! The frame algorithms find the same, bit for bit, in every broad phase.

use carom::arithmetic::{Arithmetic, Budget};
use carom::frame::{BroadPhase, Passes};
use carom::run::Options;
use carom::scalar::{Exact, Filtered};
use carom::scene::{Disc, DiscBuilder, Restitution, Scene, SceneBuilder};
use carom::simulation::Algorithm;
use proptest::prelude::*;

use crate::common::attempt;
use crate::common::strategy::{cases, vector, within};

const ALGORITHMS: [Algorithm; 5] = [
    Algorithm::Retroactive { substeps: 3 },
    Algorithm::Single,
    Algorithm::Multiple(Passes::Count(2)),
    Algorithm::Multiple(Passes::Count(6)),
    Algorithm::Synchronised(Passes::Count(3)),
];

/// All that comes of a run, to the last bit: the impacts with their
/// circumstances, the end, and what was left open after how many attempts.
fn told<S: Arithmetic>(scene: &Scene, algorithm: Algorithm, phase: BroadPhase) -> String {
    let budget = Budget {
        most_bits: 256,
        ..Budget::default()
    };
    let options = Options {
        contacts: true,
        budget,
        frame_broad_phase: phase,
        ..Options::default()
    };
    format!("{:?}", attempt::<S>(scene, algorithm, &options))
}

fn assert_same<S: Arithmetic>(scene: &Scene) {
    for algorithm in ALGORITHMS {
        let all = told::<S>(scene, algorithm, BroadPhase::AllPairs);
        for phase in [BroadPhase::Grid, BroadPhase::Bsp] {
            let other = told::<S>(scene, algorithm, phase);
            assert_eq!(all, other, "{algorithm:?}, {phase:?}, {}", S::NAME);
        }
    }
}

fn assert_same_in_binary64(scene: &Scene) {
    assert_same::<f64>(scene);
    assert_same::<Filtered>(scene);
}

/// A disc anywhere, also on others; some large, small, fast, slow or immovable.
fn disc() -> impl Strategy<Value = DiscBuilder> {
    let radius = prop_oneof![
        6 => within(0.5, 1.0),
        2 => Just(0.5),
        1 => within(2.0, 8.0),
        1 => (-20..-4_i32).prop_map(|exponent| f64::from(exponent).exp2()),
    ];
    let speed = prop_oneof![
        6 => Just(1.0),
        1 => Just(0.0),
        1 => Just(100.0),
        1 => (-40..20_i32).prop_map(|exponent| f64::from(exponent).exp2()),
    ];
    let numbers = (vector(14.0), radius, vector(3.0), speed);
    let mass = prop_oneof![8 => within(0.25, 4.0).prop_map(Some), 1 => Just(None)];
    (numbers, mass).prop_map(|((position, radius, velocity, speed), mass)| {
        let velocity = velocity.map(|coordinate| coordinate * speed);
        let disc = Disc::at(position, radius).velocity(velocity);
        match mass {
            Some(mass) => disc.mass(mass),
            None => disc.infinite_mass(),
        }
    })
}

/// Discs of one size on a lattice, which touch and meet at the same times.
fn bead() -> impl Strategy<Value = DiscBuilder> {
    let lattice = || [-5..=5_i32, -5..=5_i32];
    (lattice(), [-2..=2_i32, -2..=2_i32]).prop_map(|(place, velocity)| {
        let place = place.map(|coordinate| f64::from(coordinate) * 2.0);
        Disc::at(place, 1).velocity(velocity.map(f64::from))
    })
}

/// A box, mostly, with walls across.
fn around(discs: Vec<DiscBuilder>) -> impl Strategy<Value = SceneBuilder> {
    let walls = prop::collection::vec((vector(16.0), vector(16.0)), 0..5);
    (walls, prop::bool::weighted(0.8)).prop_map(move |(walls, is_boxed)| {
        let mut scene = Scene::builder("test").discs(discs.clone());
        if is_boxed {
            scene = scene.walls_around([-15.0; 2], [15.0; 2]);
        }
        let walls = walls.into_iter().filter(|(from, to)| from != to);
        walls.fold(scene, |scene, (from, to)| scene.wall(from, to))
    })
}

/// What acts and what is lost.
fn effects() -> impl Strategy<Value = (Option<[f64; 2]>, Option<f64>, Restitution)> {
    let loss = prop_oneof![
        2 => Just(Restitution::Elastic),
        1 => Just(Restitution::Newton {
            coefficient: "1/2".parse().unwrap(),
            walls: None,
            elastic_below: None,
        }),
    ];
    let gravity = prop::option::weighted(0.3, vector(10.0));
    let drag = prop::option::weighted(0.3, within(0.125, 0.5));
    (gravity, drag, loss)
}

/// Scenes of so many discs for so many frames.
fn scene(
    disc: impl Strategy<Value = DiscBuilder>,
    discs: std::ops::Range<usize>,
    frames: u64,
) -> impl Strategy<Value = Scene> {
    let bodies = prop::collection::vec(disc, discs).prop_flat_map(around);
    let duration = prop::sample::select(vec![1.0 / 64.0, 0.25, 1.0]);
    (bodies, duration, effects()).prop_map(move |(scene, duration, (gravity, drag, loss))| {
        let mut scene = scene.frame(duration, frames).restitution(loss);
        if let Some(gravity) = gravity {
            scene = scene.gravity(gravity);
        }
        if let Some(drag) = drag {
            scene = scene.linear_drag(drag);
        }
        scene.build().expect("a valid scene")
    })
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn anything(scene in scene(disc(), 12..60, 8)) {
        assert_same_in_binary64(&scene);
    }

    #[test]
    fn on_a_lattice(scene in scene(bead(), 12..40, 6)) {
        assert_same_in_binary64(&scene);
    }
}

proptest! {
    #![proptest_config(cases(8))]

    #[test]
    fn exactly(
        anything in scene(disc(), 12..25, 2),
        lattice in scene(bead(), 12..25, 2),
    ) {
        assert_same::<Exact>(&anything);
        assert_same::<Exact>(&lattice);
    }
}

/// Too few bodies for any broad phase, and too many in one place.
#[test]
fn degenerate_scenes() {
    let still = |count: usize| vec![Disc::at([1.0, 1.0], 1); count];
    let moving = |index: i32| Disc::at([1.0, 1.0], 1).velocity([f64::from(index), 1.0]);
    let far = |index: i32| {
        let place = [f64::from(index) * 1e58, -1e59];
        Disc::at(place, 1e57).velocity([-1e58, f64::from(index) * 1e55])
    };
    let crowds = [
        vec![],
        still(1),
        still(30),
        (0..30).map(moving).collect(),
        (0..30).map(far).collect(),
    ];
    for discs in crowds {
        let empty = || Scene::builder("test").discs(discs.clone()).frame(1, 3);
        let walled = empty().walls_around([-1e60; 2], [1e60; 2]);
        for scene in [empty(), walled] {
            let scene = scene.build().expect("a valid scene");
            assert_same_in_binary64(&scene);
            assert_same::<Exact>(&scene);
        }
    }
}

/// Only exact arithmetic takes numbers like these.
#[test]
fn beyond_all_binary64() {
    let disc = |index: i32| {
        let place = format!("{index}e300");
        Disc::at([&*place, "0"], "1e299").velocity(["-1e300", "1e-300"])
    };
    let scene = Scene::builder("test").discs((0..30).map(disc));
    let scene = scene.wall(["-1e310", "0"], ["-1e310", "1e310"]).frame(1, 3);
    assert_same::<Exact>(&scene.build().expect("a valid scene"));
}
