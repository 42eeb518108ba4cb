//! What the tests of whole runs share.

// Each test uses a part of it.
#![allow(dead_code, reason = "each test uses a part of this")]

pub(crate) mod agree;
pub(crate) mod strategy;
pub(crate) mod tolerance;

use std::ops::ControlFlow;

use carom::arithmetic::Arithmetic;
use carom::impact::Impact;
use carom::run::{Options, Outcome, Status, run};
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::{Scene, SceneBuilder};
use carom::simulation::Algorithm;
use num_rational::BigRational;

/// More than any scene of these tests has: a run that goes on and on fails.
const MOST_IMPACTS: u64 = 10_000;

/// An empty scene of one frame that lasts so long.
pub(crate) fn lasting(duration: &str) -> SceneBuilder {
    Scene::builder("test").frame(duration, 1)
}

/// The rational that a text says, such as `"-3/4"`.
pub(crate) fn ratio(text: &str) -> BigRational {
    text.parse::<Number>().expect(text).to_rational()
}

/// The whole run of a scene, which must be decided.
pub(crate) fn complete<S: Arithmetic>(scene: &Scene, algorithm: Algorithm) -> Outcome<S> {
    let options = Options {
        max_events: MOST_IMPACTS,
        contacts: true,
        ..Options::default()
    };
    let outcome = attempt(scene, algorithm, &options);
    assert_eq!(outcome.status, Status::Complete, "{algorithm:?}");
    outcome
}

/// The run of a scene, however it ends.
pub(crate) fn attempt<S: Arithmetic>(
    scene: &Scene,
    algorithm: Algorithm,
    options: &Options,
) -> Outcome<S> {
    let mut go_on = |_| ControlFlow::Continue(());
    run(scene, algorithm, options, &mut go_on).expect("nothing unsupported")
}

/// The exact timeline of a scene.
pub(crate) fn exactly(scene: &Scene) -> Outcome<Exact> {
    complete(scene, Algorithm::Timeline)
}

/// The timeline of a scene in binary64.
pub(crate) fn in_binary64(scene: &Scene) -> Outcome<f64> {
    complete(scene, Algorithm::Timeline)
}

/// What an impact is of: `"d0 d3"`, `"d0 w1"` or `"d0 w1 to"`.
pub(crate) fn name<S>(impact: &Impact<S>) -> String {
    let end = impact.end.map(|end| format!(" {end}")).unwrap_or_default();
    format!("{} {}{end}", impact.pair.a, impact.pair.b)
}

/// What the impacts of a log are of.
pub(crate) fn names<S>(impacts: &[Impact<S>]) -> Vec<String> {
    impacts.iter().map(name).collect()
}

/// The numbers of a disc: position, then velocity.
pub(crate) fn numbers<S: Scalar>(disc: &carom::body::Disc<S>) -> [S; 4] {
    let (position, velocity) = (disc.position.clone(), disc.velocity.clone());
    [position.x, position.y, velocity.x, velocity.y]
}
