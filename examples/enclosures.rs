//! How many bits exact arithmetic loses an impact, how many the dynamics
//! themselves lose, and what that costs.
//!
//! ```text
//! cargo run --release --example enclosures [DISCS…]
//! ```
//!
//! For gases of 3, 10 and 30 discs, or of as many as the arguments say: a run
//! with fewer bits than a step as a whole takes, runs with more, and how far
//! two runs part whose starts differ by 2^-1024 in one coordinate. What an
//! enclosure loses is what the state at the end lacks of the bits it was
//! computed with.

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

/// The impacts of a run.
const IMPACTS: u32 = 600;

/// The bits of a run: too few for steps, just enough, and more.
const BITS: [u32; 4] = [Exact::STEP_BITS - 1, Exact::STEP_BITS, 2048, 4096];

/// The exponent of the difference between two starts.
const NUDGE: u32 = 1024;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let counts: Result<Vec<u32>, _> = std::env::args().skip(1).map(|text| text.parse()).collect();
    let counts = match counts? {
        none if none.is_empty() => vec![3, 10, 30],
        counts => counts,
    };
    println!("discs   bits  impacts  us an impact  bits lost an impact");
    for discs in counts {
        let scene = generate::gas(42, discs, 0.3)?;
        for bits in BITS {
            let began = Instant::now();
            let outcome = follow(&scene, bits, IMPACTS)?;
            let micros = began.elapsed().as_secs_f64() * 1e6;
            let impacts = outcome.impacts.len() as f64;
            let lost = bits - outcome.certain_bits().unwrap_or(bits);
            let (cost, rate) = (micros / impacts, f64::from(lost) / impacts);
            println!("{discs:5} {bits:6} {impacts:8} {cost:13.1} {rate:20.3}");
        }
        println!("{discs:5} the dynamics {:38.3}", divergence(&scene)?);
    }
    Ok(())
}

/// The bits an impact by which two runs part.
fn divergence(scene: &Scene) -> Result<f64, Box<dyn std::error::Error>> {
    let bits = 2 * NUDGE;
    let one = follow(scene, bits, IMPACTS)?;
    let other = follow(&nudged(scene, NUDGE)?, bits, IMPACTS)?;
    let apart = distance(&one.end, &other.end) + i64::from(NUDGE);
    Ok(apart as f64 / f64::from(IMPACTS))
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
        ..Options::default()
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
