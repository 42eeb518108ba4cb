//! Runs of so many impacts, and how far two of them part that start next to each
//! other.

use std::ops::ControlFlow;

use carom::arithmetic::{Arithmetic, Budget};
use carom::body::Disc;
use carom::run::{Options, Outcome, run};
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::Scene;
use carom::simulation::Algorithm;
use num_bigint::BigInt;
use num_rational::BigRational;

pub(crate) type Failure = Box<dyn std::error::Error>;

/// A run of so many impacts, with so many bits where that matters.
pub(crate) fn follow<S: Arithmetic>(
    scene: &Scene,
    bits: u32,
    impacts: u32,
) -> Result<Outcome<S>, Failure> {
    let options = Options {
        until: Some(Number::from(1_000_000)),
        max_events: impacts.into(),
        budget: Budget {
            first_bits: bits,
            most_bits: bits,
        },
        ..Options::default()
    };
    let go_on = &mut |_| ControlFlow::Continue(());
    Ok(run::<S>(scene, Algorithm::Timeline, &options, go_on)?)
}

/// The bits an impact by which a run and one like it part, whose starts differ
/// by 2^-`nudge` in one coordinate.
pub(crate) fn divergence(
    scene: &Scene,
    outcome: &Outcome<Exact>,
    nudge: u32,
) -> Result<f64, Failure> {
    let impacts = u32::try_from(outcome.impacts.len())?;
    let other = follow(&nudged(scene, nudge)?, outcome.precision, impacts)?;
    let apart = distance(&outcome.end, &other.end) + i64::from(nudge);
    Ok(apart as f64 / f64::from(impacts))
}

/// The same scene with one coordinate larger by 2^-`bits`.
fn nudged(scene: &Scene, bits: u32) -> Result<Scene, Failure> {
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
