//! The shadowing horizon: for how many impacts a run in binary64 follows the
//! true course of events, over many seeds.
//!
//! ```text
//! cargo run --release --example shadowing [SEEDS]
//! ```
//!
//! A binary64 run starts with 53 bits and loses them at the rate of the dynamics,
//! at which two true runs part that start next to each other. So it should follow
//! the truth for 53 divided by that, or somewhat less: until the error of some disc
//! is as large as what decides its next impact. The other prediction is by what
//! the enclosures of the true run lose, which is more (see the example
//! `enclosures`). For 5 to 20 discs the median was found between the two, for the
//! 150 of Table 1, any of which may be the first to go astray, a tenth below both.

mod dynamics;

use carom::arithmetic::Arithmetic;
use carom::judge::{Logged, first_difference};
use carom::run::Outcome;
use carom::scalar::{Exact, Number};
use carom::scene::{Scene, generate};
use dynamics::{Failure, divergence, follow};

/// Scenes that differ by a seed.
struct Kind {
    name: &'static str,
    make: fn(u64) -> Result<Scene, Failure>,
    /// Many more than can be followed.
    impacts: u32,
    /// How much longer than a small scene one takes: it gets fewer seeds.
    effort: u64,
}

const KINDS: [Kind; 6] = [
    gas("5 discs", |seed| Ok(generate::gas(seed, 5, 0.3)?), 600),
    gas("10 discs", |seed| Ok(generate::gas(seed, 10, 0.3)?), 800),
    gas("20 discs", |seed| Ok(generate::gas(seed, 20, 0.3)?), 1200),
    gas(
        "20 discs, dense",
        |seed| Ok(generate::gas(seed, 20, 0.6)?),
        2400,
    ),
    Kind {
        name: "Table 1, a third",
        make: |seed| Ok(generate::table1(seed, &"33/100".parse()?)?),
        impacts: 6000,
        effort: 10,
    },
    Kind {
        name: "Table 1",
        make: |seed| Ok(generate::table1(seed, &Number::from(1))?),
        impacts: 6000,
        effort: 10,
    },
];

const fn gas(name: &'static str, make: fn(u64) -> Result<Scene, Failure>, impacts: u32) -> Kind {
    Kind {
        name,
        make,
        impacts,
        effort: 1,
    }
}

/// How far binary64 follows one scene.
struct Horizon {
    /// The impacts that it follows.
    followed: f64,
    /// The bits that the enclosures lose an impact.
    enclosed: f64,
    /// The bits by which runs part.
    parted: f64,
}

/// The exponent of the difference between two starts.
const NUDGE: u32 = 768;

fn main() -> Result<(), Failure> {
    let seeds = match std::env::args().nth(1) {
        Some(text) => text.parse()?,
        None => 100,
    };
    println!(
        "                         impacts followed (quantiles)      bits an impact  predicted"
    );
    println!(
        "scene             seeds    min    10%    50%    90%    max   encl. dynam.  encl. dynam."
    );
    for kind in &KINDS {
        let seeds = (seeds / kind.effort).max(1);
        let horizons: Result<Vec<_>, _> = (0..seeds).map(|seed| kind.horizon(seed)).collect();
        kind.print(&horizons?);
    }
    Ok(())
}

impl Kind {
    fn horizon(&self, seed: u64) -> Result<Horizon, Failure> {
        let scene = (self.make)(seed)?;
        let truth: Outcome<Exact> = follow(&scene, Exact::STEP_BITS, self.impacts)?;
        let candidate: Outcome<f64> = follow(&scene, Exact::STEP_BITS, self.impacts)?;
        let parted = divergence(&scene, &truth, NUDGE)?;
        let lost = truth.precision - truth.certain_bits().unwrap_or(truth.precision);
        let [truth, candidate] = [logged(&truth), logged(&candidate)];
        let followed = first_difference(&truth, &candidate).map(|first| first.followed);
        Ok(Horizon {
            followed: followed.unwrap_or(truth.len()) as f64,
            enclosed: f64::from(lost) / truth.len() as f64,
            parted,
        })
    }

    fn print(&self, horizons: &[Horizon]) {
        let followed = sorted(horizons.iter().map(|horizon| horizon.followed));
        let rates = [
            sorted(horizons.iter().map(|horizon| horizon.enclosed)),
            sorted(horizons.iter().map(|horizon| horizon.parted)),
        ];
        let [enclosed, parted] = rates.map(|rates| quantile(&rates, 0.5));
        let predicted = [enclosed, parted].map(|rate| f64::from(f64::MANTISSA_DIGITS) / rate);
        let [min, low, half, high, max] =
            [0.0, 0.1, 0.5, 0.9, 1.0].map(|part| quantile(&followed, part));
        let (name, seeds) = (self.name, horizons.len());
        print!("{name:17} {seeds:5} {min:6} {low:6} {half:6} {high:6} {max:6}");
        let [first, second] = predicted;
        println!(" {enclosed:7.3} {parted:6.3} {first:6.0} {second:6.0}");
    }
}

fn logged<S: Arithmetic>(outcome: &Outcome<S>) -> Vec<Logged> {
    outcome.impacts.iter().map(Logged::from).collect()
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<_> = values.collect();
    values.sort_by(f64::total_cmp);
    values
}

/// The value below which this part of them is.
fn quantile(sorted: &[f64], part: f64) -> f64 {
    let last = sorted.len() - 1;
    sorted[(part * last as f64).round() as usize]
}
