//! Discs that are stuck from the start, and discs that get out.

use carom::arithmetic::Arithmetic;
use carom::run::{Accumulation, Options, Outcome, Status};
use carom::scalar::{Exact, Filtered};
use carom::scene::{Disc, Scene, SceneBuilder};
use carom::simulation::Algorithm;
use num_traits::Zero;

use crate::common::attempt;

fn run<S: Arithmetic>(scene: &Scene) -> Outcome<S> {
    attempt(scene, Algorithm::Timeline, &Options::default())
}

/// The end of a run that is stuck at time zero.
fn stuck<S: Arithmetic>(scene: &Scene) -> Accumulation {
    let outcome = run::<S>(scene);
    match outcome.status {
        Status::Accumulation(found) => {
            assert!(found.limit.iter().all(Zero::is_zero));
            found
        }
        other => panic!("{}: {other:?} after {}", S::NAME, outcome.impacts.len()),
    }
}

/// In every arithmetic, between these bodies; proven where all is.
fn assert_stuck(scene: SceneBuilder, word: &[&str]) {
    let scene = scene.build().expect("a scene");
    let found = [
        stuck::<f64>(&scene),
        stuck::<Filtered>(&scene),
        stuck::<Exact>(&scene),
    ];
    for found in &found {
        let pairs = found
            .word
            .iter()
            .map(|pair| format!("{} {}", pair.a, pair.b));
        assert_eq!(pairs.collect::<Vec<_>>(), word);
    }
    assert_eq!(found.map(|found| found.proven), [false, false, true]);
}

/// A disc in the triangle of sides 3, 4 and 5, whose inscribed circle has radius 1.
fn triangle(radius: &str) -> SceneBuilder {
    Scene::builder("triangle")
        .disc(Disc::at([1, 1], radius).velocity(["1/3", "1/7"]))
        .wall([0, 0], [4, 0])
        .wall([0, 3], [0, 0])
        .wall([4, 0], [0, 3])
}

#[test]
fn a_triangle_without_room() {
    let walls = ["d0 w0", "d0 w1", "d0 w2"];
    assert_stuck(triangle("1"), &walls);
    assert_stuck(triangle("11/10"), &walls);
}

/// With a little room it goes from wall to wall, as often as it may.
#[test]
fn a_triangle_with_room() {
    let scene = triangle("9/10").build().expect("a scene");
    assert!(matches!(run::<Exact>(&scene).status, Status::Complete));
}

/// Walls at 9/10 on both sides of a disc of radius 1.
fn channel(velocity: [i32; 2]) -> SceneBuilder {
    Scene::builder("channel")
        .disc(Disc::at([0, 0], 1).velocity(velocity))
        .wall(["-9", "-9/10"], ["9", "-9/10"])
        .wall(["-9", "9/10"], ["9", "9/10"])
}

#[test]
fn a_channel_without_room() {
    assert_stuck(channel([1, 1]), &["d0 w0", "d0 w1"]);
    let along = channel([1, 0]).build().expect("a scene");
    let outcome = run::<Exact>(&along);
    assert!(matches!(outcome.status, Status::Complete));
    assert_eq!(outcome.impacts.len(), 0);
}

/// Along the bisector of a wedge into its corner. The walls are at ±β, tan β = 1/50, and
/// after n impacts the velocity is at π - 2 n β to the bisector, on one side or the other;
/// it is out when that is less than β: for n = 79 first, since π / 2β = 78.55.
#[test]
fn a_wedge_is_left_after_many_impacts_at_once() {
    let scene = Scene::builder("wedge")
        .disc(Disc::at([50, 0], 2).velocity([-1, 0]))
        .wall([0, 0], [100, 2])
        .wall([0, 0], [100, -2]);
    let scene = scene.build().expect("a scene");
    let outcome = run::<Exact>(&scene);
    assert!(matches!(outcome.status, Status::Complete));
    assert_eq!(outcome.impacts.len(), 79);
    assert_eq!(run::<f64>(&scene).impacts.len(), 79);
}

/// A fixed disc and two walls, in no order that repeats.
#[test]
fn between_a_disc_and_two_walls() {
    let scene = Scene::builder("corner")
        .disc(Disc::at(["1.458", "-3.848"], "0.668").infinite_mass())
        .disc(Disc::at(["1.221", "-4.056"], "0.972").velocity(["0.687", "2.471"]))
        .wall(["1.11", "-4.271"], ["-5.449", "4.377"])
        .wall(["4.211", "4.882"], ["1.48", "-4.541"]);
    assert_stuck(scene, &["d0 d1", "d1 w0", "d1 w1"]);
}
