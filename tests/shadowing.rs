//! For how long a run in binary64 follows the true one: as long as its 53 bits
//! last, at the rate at which the true run loses bits.

#![cfg(feature = "cli")]

use std::ops::ControlFlow;

use carom::arithmetic::{Arithmetic, Budget};
use carom::judge::{Logged, first_difference};
use carom::run::{Options, Outcome, Status, run};
use carom::scalar::{Exact, Number};
use carom::scene::{Scene, generate};
use carom::simulation::Algorithm;

/// Several times as many as can be followed.
const IMPACTS: u32 = 600;

fn follow<S: Arithmetic>(scene: &Scene) -> Outcome<S> {
    let options = Options {
        until: Some(Number::from(1_000_000)),
        max_events: IMPACTS.into(),
        budget: Budget {
            first_bits: Exact::STEP_BITS,
            most_bits: Exact::STEP_BITS,
        },
        ..Options::default()
    };
    let go_on = &mut |_| ControlFlow::Continue(());
    let outcome = run(scene, Algorithm::Timeline, &options, go_on).unwrap();
    assert_eq!(outcome.status, Status::EventLimit);
    outcome
}

fn logged<S: Arithmetic>(outcome: &Outcome<S>) -> Vec<Logged> {
    outcome.impacts.iter().map(Logged::from).collect()
}

/// The bits that the true run has lost an impact, and the impacts after which
/// binary64 leaves it.
fn horizon(seed: u64) -> (f64, f64) {
    let scene = generate::gas(seed, 5, 0.3).unwrap();
    let (truth, candidate) = (follow::<Exact>(&scene), follow::<f64>(&scene));
    let lost = Exact::STEP_BITS - truth.certain_bits().unwrap();
    let first = first_difference(&logged(&truth), &logged(&candidate));
    let followed = first.expect("chaos").followed;
    (f64::from(lost) / f64::from(IMPACTS), followed as f64)
}

/// An error grows to 2^-13 of the box in the first 40 bits: until then only a
/// decision as close as that can go wrong. After another 40 it would be far larger
/// than the box, even if the run lost only two thirds of what its enclosures do:
/// no course of events survives that.
#[test]
fn it_lasts_as_long_as_the_bits() {
    for seed in 0..12 {
        let (rate, followed) = horizon(seed);
        let spent = rate * followed;
        assert!((40.0..80.0).contains(&spent), "seed {seed}: {spent} bits");
    }
}

/// The prediction is right on the average, to a tenth: 53 bits.
#[test]
fn the_mean_is_that_of_the_digits() {
    let seeds = 0..12;
    let count = f64::from(seeds.end);
    let spent = seeds.map(|seed| {
        let (rate, followed) = horizon(seed as u64);
        rate * followed
    });
    let mean = spent.sum::<f64>() / count;
    let digits = f64::from(f64::MANTISSA_DIGITS);
    assert!((mean / digits - 1.0).abs() < 0.1, "{mean}");
}
