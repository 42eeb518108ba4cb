//! A hundred discs, poured into a box, settle: `scenes/pile.json`.

use std::fs;
use std::path::PathBuf;

use carom::arithmetic::Arithmetic;
use carom::body::{Disc, Mass};
use carom::run::{Options, Outcome, Status};
use carom::scalar::{Filtered, Number};
use carom::scene::{Restitution, Scene};
use carom::simulation::Algorithm;

use crate::common::attempt;

fn pile() -> Scene {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("scenes/pile.json");
    Scene::from_json(&fs::read_to_string(path).unwrap()).unwrap()
}

/// What an impact has to be faster than to lose anything.
fn slow(scene: &Scene) -> f64 {
    match &scene.effects().restitution {
        Restitution::Newton {
            elastic_below: Some(speed),
            ..
        } => speed.to_f64(),
        other => panic!("{other:?}"),
    }
}

fn until<S: Arithmetic>(scene: &Scene, time: i32) -> Outcome<S> {
    let options = Options {
        until: Some(Number::from(time)),
        ..Options::default()
    };
    let outcome = attempt::<S>(scene, Algorithm::Timeline, &options);
    assert_eq!(outcome.status, Status::Complete);
    outcome
}

fn kinetic<S: Arithmetic>(discs: &[Disc<S>]) -> f64 {
    let energy = |disc: &Disc<S>| {
        let Mass::Finite(mass) = &disc.mass else {
            return 0.0;
        };
        mass.to_f64() * disc.velocity.norm_squared().to_f64() / 2.0
    };
    discs.iter().map(energy).sum()
}

/// The largest overlap of two discs, or of a disc and the floor or a side.
fn overlap<S: Arithmetic>(scene: &Scene, discs: &[Disc<S>]) -> f64 {
    let place = |disc: &Disc<S>| [disc.position.x.to_f64(), disc.position.y.to_f64()];
    let mut largest = f64::NEG_INFINITY;
    for (index, disc) in discs.iter().enumerate() {
        let ([x, y], radius) = (place(disc), disc.radius.to_f64());
        for other in &discs[index + 1..] {
            let [other_x, other_y] = place(other);
            let apart = (x - other_x).hypot(y - other_y);
            largest = largest.max(radius + other.radius.to_f64() - apart);
        }
        let side = scene.walls()[1].from[0].to_f64().abs();
        largest = largest.max(radius - y).max(x.abs() + radius - side);
    }
    largest
}

/// Nothing freezes, nothing sinks, and by some time the energy is within so many
/// orders of magnitude of what slow impacts do not take: m v² / 2 a disc, for
/// that speed v.
fn settles<S: Arithmetic>(time: i32, orders: i32) {
    let scene = pile();
    let left = slow(&scene).powi(2) / 2.0 * scene.discs().len() as f64;
    let fallen = kinetic(&until::<S>(&scene, 1).end);
    let outcome = until::<S>(&scene, time);
    let moving = kinetic(&outcome.end);
    assert!(moving < 10_f64.powi(orders) * left, "{moving}");
    assert!(fallen > 1000.0 * left);
    assert!(overlap(&scene, &outcome.end) < 1e-12);
    let late = outcome.impacts.iter().rev().take(100 * 100);
    let moving = late.flat_map(|impact| [impact.pair.a, impact.pair.b]);
    let moving: std::collections::BTreeSet<_> = moving.collect();
    assert!(moving.len() > scene.discs().len(), "all of them, and walls");
}

#[test]
fn in_binary64() {
    settles::<f64>(6, 1);
}

/// Half of the time, for it takes longer to compute.
#[test]
fn in_filtered() {
    settles::<Filtered>(3, 2);
}
