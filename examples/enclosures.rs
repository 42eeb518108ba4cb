//! How many bits exact arithmetic loses an impact, and how many the dynamics
//! themselves lose; and what that costs.
//!
//! ```text
//! cargo run --release --example enclosures [DISCS [IMPACTS [BITS]]]
//! ```
//!
//! The loss of an enclosure is what the state at the end lacks of the bits it
//! was computed with. That of the dynamics is how far two runs part whose
//! starts differ by 2^-BITS/2 in one coordinate.

use std::ops::ControlFlow;
use std::time::Instant;

use carom::arithmetic::Budget;
use carom::body::Disc;
use carom::run::{Options, Outcome, run};
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::{Scene, generate};
use carom::simulation::Algorithm;
use num_bigint::BigInt;
use num_rational::BigRational;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Result<Vec<u32>, _> =
        std::env::args().skip(1).map(|text| text.parse()).collect();
    let arguments = arguments?;
    let argument = |index: usize, default| arguments.get(index).copied().unwrap_or(default);
    let (discs, impacts) = (argument(0, 10), argument(1, 1000));
    let bits = argument(2, 2048);
    let scene = generate::gas(42, discs, 0.3)?;
    let began = Instant::now();
    let outcome = follow(&scene, bits, impacts)?;
    let elapsed = began.elapsed().as_secs_f64();
    let reached = outcome.impacts.len();
    let lost = i64::from(bits) - outcome.certain_bits().map_or(0, i64::from);
    println!(
        "{discs} discs, {bits} bits: {reached} impacts in {elapsed:.3} s ({:.1} us each), {lost} bits lost, {:.3} an impact ({:?})",
        elapsed * 1e6 / reached as f64,
        lost as f64 / reached as f64,
        outcome.status,
    );
    if argument(3, 1) == 1 {
        let other = follow(&nudged(&scene, bits / 2)?, bits, impacts)?;
        let same = outcome
            .impacts
            .iter()
            .zip(&other.impacts)
            .take_while(|(one, other)| one.pair == other.pair)
            .count();
        let apart = distance(&outcome.end, &other.end) + i64::from(bits / 2);
        println!(
            "{same} impacts in common, the dynamics lose {apart} bits, {:.3} an impact",
            apart as f64 / reached as f64
        );
    }
    Ok(())
}

/// A run of so many impacts, with so many bits.
fn follow(
    scene: &Scene,
    bits: u32,
    impacts: u32,
) -> Result<Outcome<Exact>, Box<dyn std::error::Error>> {
    let options = Options {
        until: Some(Number::from(1_000_000)),
        max_events: impacts.into(),
        budget: Budget {
            first_bits: bits,
            most_bits: bits,
        },
        digits: 20,
    };
    let go_on = &mut |_| ControlFlow::Continue(());
    Ok(run::<Exact>(scene, Algorithm::Timeline, &options, go_on)?)
}

/// The same scene with one coordinate larger by 2^-`bits`.
fn nudged(scene: &Scene, bits: u32) -> Result<Scene, Box<dyn std::error::Error>> {
    let mut builder = scene.to_builder().without_discs();
    for (index, disc) in scene.discs().iter().enumerate() {
        let [x, y] = disc.position.clone();
        let nudge = BigRational::new(1.into(), BigInt::from(1) << bits);
        let x = match index {
            0 => Number::try_from(x.to_rational() + nudge)?,
            _ => x,
        };
        let made = carom::scene::Disc::at([x, y], disc.radius.clone());
        builder = builder.disc(made.velocity(disc.velocity.clone()));
    }
    Ok(builder.build()?)
}

/// The exponent of the largest difference.
fn distance(one: &[Disc<Exact>], other: &[Disc<Exact>]) -> i64 {
    let pairs = one.iter().zip(other);
    let differences = pairs.flat_map(|(one, other)| {
        let [one, other] = [numbers(one), numbers(other)];
        one.into_iter()
            .zip(other)
            .map(|(one, other)| (one.clone() - other).enclosure())
    });
    let exponents = differences.map(|ends| {
        ends.map_or(0, |(_, hi)| {
            hi.numer().bits() as i64 - hi.denom().bits() as i64
        })
    });
    exponents.max().unwrap_or(0)
}

fn numbers(disc: &Disc<Exact>) -> [&Exact; 4] {
    let Disc {
        position, velocity, ..
    } = disc;
    [&position.x, &position.y, &velocity.x, &velocity.y]
}
