//! The enclosures of the timeline: they hold the truth, and lose little more
//! than the dynamics do.
//!
//! From [`Exact::STEP_BITS`] on an impact is computed as a whole. What it gives
//! is held against the plain enclosures of fewer bits, which know nothing of
//! that, and against the same with many more bits.

#![cfg(feature = "cli")]

use std::ops::ControlFlow;

use carom::arithmetic::Budget;
use carom::body::Disc;
use carom::run::{Options, Outcome, Status, run};
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::{self, Restitution, Scene, generate};
use carom::simulation::Algorithm;

/// The first impacts, with so many bits.
fn follow(scene: &Scene, bits: u32, impacts: u64) -> Outcome<Exact> {
    let options = Options {
        until: Some(Number::from(1_000_000)),
        max_events: impacts,
        budget: Budget {
            first_bits: bits,
            most_bits: bits,
        },
        ..Options::default()
    };
    let go_on = &mut |_| ControlFlow::Continue(());
    let outcome = run::<Exact>(scene, Algorithm::Timeline, &options, go_on).unwrap();
    assert_eq!(outcome.status, Status::EventLimit);
    outcome
}

fn numbers(disc: &Disc<Exact>) -> [&Exact; 4] {
    let Disc {
        position, velocity, ..
    } = disc;
    [&position.x, &position.y, &velocity.x, &velocity.y]
}

/// Times and the numbers of the state at the end.
fn all_numbers(outcome: &Outcome<Exact>) -> impl Iterator<Item = &Exact> {
    let times = outcome.impacts.iter().map(|impact| &impact.time);
    times.chain(outcome.end.iter().flat_map(numbers))
}

/// Whether all bounds of one run lie within those of another.
fn assert_within(fine: &Outcome<Exact>, coarse: &Outcome<Exact>) {
    let pairs = |outcome: &Outcome<Exact>| -> Vec<_> {
        outcome
            .impacts
            .iter()
            .map(|impact| (impact.pair, impact.end))
            .collect()
    };
    assert_eq!(pairs(fine), pairs(coarse));
    for (fine, coarse) in all_numbers(fine).zip(all_numbers(coarse)) {
        let (fine, coarse) = (fine.enclosure().unwrap(), coarse.enclosure().unwrap());
        assert!(coarse.0 <= fine.0 && fine.1 <= coarse.1);
    }
}

fn lost(outcome: &Outcome<Exact>) -> u32 {
    outcome.precision - outcome.certain_bits().unwrap()
}

#[test]
fn plain_enclosures_hold_the_tighter_ones() {
    for seed in 0..6 {
        let scene = generate::gas(seed, 6, 0.3).unwrap();
        let plain = follow(&scene, Exact::STEP_BITS - 1, 250);
        let tight = follow(&scene, 2 * Exact::STEP_BITS, 250);
        assert_within(&tight, &plain);
        assert!(
            lost(&tight) < lost(&plain) / 2,
            "{} {}",
            lost(&tight),
            lost(&plain)
        );
    }
}

#[test]
fn tight_enclosures_hold_those_of_many_more_bits() {
    for seed in 0..4 {
        let scene = generate::gas(seed, 8, 0.3).unwrap();
        let coarse = follow(&scene, Exact::STEP_BITS, 800);
        assert_within(&follow(&scene, 4 * Exact::STEP_BITS, 800), &coarse);
    }
}

/// Different radii and masses, a disc that nothing deflects, a loss at every
/// impact but slow ones, and walls whose end points stick out.
#[test]
fn all_kinds_of_impacts_are_enclosed() {
    let scene = Scene::builder("all kinds")
        .disc(scene::Disc::at(["1", "1"], "1/2").velocity(["3", "1/3"]))
        .disc(
            scene::Disc::at(["3", "5/2"], "1/3")
                .velocity(["-2", "1/7"])
                .mass("1/3"),
        )
        .disc(
            scene::Disc::at(["5", "4"], "2/3")
                .velocity(["1/5", "-2"])
                .mass("7/3"),
        )
        .disc(scene::Disc::at(["1", "5"], "1/4").velocity(["1", "-1"]))
        .disc(scene::Disc::at(["7/2", "9/2"], "1/2").infinite_mass())
        .walls_around([0, 0], [7, 6])
        .wall(["3", "0"], ["16/5", "4/3"])
        .wall(["0", "4"], ["2/3", "19/5"])
        .restitution(Restitution::Newton {
            coefficient: "99/100".parse().unwrap(),
            walls: Some(Number::from(1)),
            elastic_below: Some("1/2".parse().unwrap()),
        })
        .build()
        .unwrap();
    let plain = follow(&scene, Exact::STEP_BITS - 1, 200);
    let tight = follow(&scene, Exact::STEP_BITS, 200);
    assert!(tight.impacts.iter().any(|impact| impact.end.is_some()));
    assert_within(&follow(&scene, 4 * Exact::STEP_BITS, 200), &tight);
    assert_within(&follow(&scene, 4 * Exact::STEP_BITS, 200), &plain);
    assert!(lost(&tight) < lost(&plain));
}
