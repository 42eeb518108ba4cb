//! The shadowing horizon: for how many impacts a run in binary64 follows the
//! true course of events, over many seeds.
//!
//! ```text
//! cargo run --release --example shadowing [SEEDS]
//! ```
//!
//! The true run loses so many bits an impact (what its enclosures lose, which is
//! little more than the dynamics do: see the example `enclosures`). A binary64
//! run starts with 53, so it should follow the truth for 53 divided by that,
//! until the error of some disc is as large as what decides its next impact.

use std::ops::ControlFlow;

use carom::arithmetic::{Arithmetic, Budget};
use carom::judge::{Logged, first_difference};
use carom::run::{Options, Outcome, run};
use carom::scalar::{Exact, Number};
use carom::scene::{Scene, generate};
use carom::simulation::Algorithm;

type Failure = Box<dyn std::error::Error>;

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
    /// The bits that the true run loses an impact.
    rate: f64,
}

fn main() -> Result<(), Failure> {
    let seeds = match std::env::args().nth(1) {
        Some(text) => text.parse()?,
        None => 100,
    };
    println!("                         impacts followed (quantiles)       bits an  predicted");
    println!("scene             seeds    min    10%    50%    90%    max   impact     50%");
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
        let truth: Outcome<Exact> = follow(&scene, self.impacts)?;
        let candidate: Outcome<f64> = follow(&scene, self.impacts)?;
        let lost = truth.precision - truth.certain_bits().unwrap_or(truth.precision);
        let [truth, candidate] = [logged(&truth), logged(&candidate)];
        let followed = first_difference(&truth, &candidate).map(|first| first.followed);
        Ok(Horizon {
            followed: followed.unwrap_or(truth.len()) as f64,
            rate: f64::from(lost) / truth.len() as f64,
        })
    }

    fn print(&self, horizons: &[Horizon]) {
        let followed = sorted(horizons.iter().map(|horizon| horizon.followed));
        let rates = sorted(horizons.iter().map(|horizon| horizon.rate));
        let digits = f64::from(f64::MANTISSA_DIGITS);
        let predicted = sorted(horizons.iter().map(|horizon| digits / horizon.rate));
        let [min, low, half, high, max] =
            [0.0, 0.1, 0.5, 0.9, 1.0].map(|part| quantile(&followed, part));
        let (name, seeds) = (self.name, horizons.len());
        let [rate, predicted] = [&rates, &predicted].map(|values| quantile(values, 0.5));
        println!(
            "{name:17} {seeds:5} {min:6} {low:6} {half:6} {high:6} {max:6} {rate:8.3} {predicted:7.0}"
        );
    }
}

/// The first impacts of a scene.
fn follow<S: Arithmetic>(scene: &Scene, impacts: u32) -> Result<Outcome<S>, Failure> {
    let options = Options {
        until: Some(Number::from(1_000_000)),
        max_events: impacts.into(),
        budget: Budget {
            first_bits: Exact::STEP_BITS,
            ..Budget::default()
        },
        ..Options::default()
    };
    let go_on = &mut |_| ControlFlow::Continue(());
    Ok(run::<S>(scene, Algorithm::Timeline, &options, go_on)?)
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
