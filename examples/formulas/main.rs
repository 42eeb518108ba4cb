//! The usual formulas for the time at which two discs meet against the stable
//! one, all in binary64, and all against fractions.
//!
//! ```text
//! cargo run --release --example formulas [QUERIES]
//! ```
//!
//! For so many queries of each kind: how many verdicts (whether the two meet)
//! are wrong, the largest and the median error of the time where verdict and
//! truth are a hit, in ulps, and what a query costs. The numbers of a query are
//! taken as they are: binary64.

mod exact;
mod queries;

use std::hint::black_box;
use std::time::Instant;

use carom::body::{Disc, Mass};
use carom::detect::meet_circle;
use carom::kernel::{Approach, Flight, Kernel, Time};
use carom::scalar::Filtered;
use carom::vec2::Vec2;
use exact::{Query, Truth};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use queries::KINDS;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// A way to find the time of impact, if there is one.
struct Formula {
    name: &'static str,
    solve: fn(&Query) -> Option<f64>,
}

const FORMULAS: [Formula; 4] = [
    Formula {
        name: "b² - ac",
        solve: quadratic,
    },
    Formula {
        name: "closest point",
        solve: closest_point,
    },
    Formula {
        name: "carom",
        solve: stable,
    },
    Formula {
        name: "filtered",
        solve: filtered,
    },
];

fn dot([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    a * c + b * d
}

/// The quadratic with c = d·d - R², as in textbooks.
fn quadratic(query: &Query) -> Option<f64> {
    let Query {
        offset,
        velocity,
        reach,
    } = *query;
    let a = dot(velocity, velocity);
    let b = dot(offset, velocity);
    let c = dot(offset, offset) - reach * reach;
    let discriminant = b * b - a * c;
    if b >= 0.0 || discriminant <= 0.0 {
        return None;
    }
    let time = (-b - discriminant.sqrt()) / a;
    (time >= 0.0).then_some(time)
}

/// From the point of the path that is closest to the centre back by half the
/// chord.
fn closest_point(query: &Query) -> Option<f64> {
    let Query {
        offset,
        velocity,
        reach,
    } = *query;
    let speed_squared = dot(velocity, velocity);
    let middle = -dot(offset, velocity) / speed_squared;
    let closest = [0, 1].map(|axis| offset[axis] + velocity[axis] * middle);
    let half_squared = reach * reach - dot(closest, closest);
    if middle <= 0.0 || half_squared <= 0.0 {
        return None;
    }
    let time = middle - (half_squared / speed_squared).sqrt();
    (time >= 0.0).then_some(time)
}

/// That of this crate.
fn stable(query: &Query) -> Option<f64> {
    let Query {
        offset,
        velocity,
        reach,
    } = query;
    let Ok(met) = meet_circle(&Vec2::from(*offset), &Vec2::from(*velocity), reach);
    met.filter(|met| !met.graze).map(|met| met.delay)
}

/// That of filtered arithmetic, with the time rounded.
fn filtered(query: &Query) -> Option<f64> {
    let disc = |position: [f64; 2], velocity: [f64; 2]| Disc {
        position: Vec2::from(position.map(Filtered::new)),
        velocity: Vec2::from(velocity.map(Filtered::new)),
        radius: Filtered::new(query.reach / 2.0),
        mass: Mass::Finite(Filtered::new(1.0)),
        last: None,
    };
    let discs = [disc([0.0; 2], [0.0; 2]), disc(query.offset, query.velocity)];
    let since = &Filtered::new(0.0);
    let [early, late] = discs.each_ref().map(|disc| Flight {
        disc,
        since,
        pull: &(),
    });
    let Ok(met) = Filtered::meet_discs(&Approach {
        early,
        late,
        together: true,
    });
    let met = met.filter(|met| !met.graze);
    met.map(|met| met.time.value().get())
}

/// How a formula did.
struct Score {
    wrong: usize,
    /// In ulps, sorted.
    errors: Vec<f64>,
    nanos: f64,
}

fn judge(formula: &Formula, queries: &[Query], truths: &[Truth]) -> Score {
    let mut score = Score {
        wrong: 0,
        errors: Vec::new(),
        nanos: cost(formula, queries),
    };
    for (query, truth) in queries.iter().zip(truths) {
        let time = (formula.solve)(query);
        score.wrong += usize::from(time.is_some() != truth.time.is_some());
        let error = time.and_then(|time| truth.ulps(time));
        score.errors.extend(error);
    }
    score.errors.sort_by(f64::total_cmp);
    score
}

/// The time that a query takes in the fastest of some rounds, in nanoseconds.
fn cost(formula: &Formula, queries: &[Query]) -> f64 {
    let rounds = (0..20).map(|_| {
        let began = Instant::now();
        for query in queries {
            black_box((formula.solve)(black_box(query)));
        }
        began.elapsed().as_secs_f64()
    });
    rounds.fold(f64::INFINITY, f64::min) * 1e9 / queries.len() as f64
}

impl Score {
    fn print(&self, formula: &Formula, count: usize) {
        let wrong = 100.0 * self.wrong as f64 / count as f64;
        let worst = self.errors.last().copied().unwrap_or_default();
        let (name, nanos, median) = (formula.name, self.nanos, median(&self.errors));
        println!("  {name:14} {wrong:8.2} {median:9.2e} {worst:9.2e} {nanos:6.1}");
    }
}

/// The middle one of sorted numbers.
fn median(sorted: &[f64]) -> f64 {
    sorted.get(sorted.len() / 2).copied().unwrap_or_default()
}

/// How close queries are to tangency or to contact: half of them are closer than
/// this power of two.
fn closeness(truths: &[Truth], measure: fn(&Truth) -> &BigRational) -> f64 {
    let sizes = truths.iter().map(|truth| measure(truth).abs().to_f64());
    let mut powers: Vec<_> = sizes.map(|size| size.unwrap_or_default().log2()).collect();
    powers.sort_by(f64::total_cmp);
    median(&powers)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let count = match std::env::args().nth(1) {
        Some(text) => text.parse()?,
        None => 10_000,
    };
    println!("formula           wrong %    median     worst     ns");
    for kind in &KINDS {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        let queries: Vec<_> = (0..count).map(|_| (kind.make)(&mut random)).collect();
        let truths: Vec<_> = queries.iter().map(Query::solve).collect();
        let tangency = closeness(&truths, |truth| &truth.discriminant);
        let contact = closeness(&truths, |truth| &truth.gap);
        println!(
            "{}: 2^{tangency:.0} from tangency, 2^{contact:.0} from contact",
            kind.name
        );
        for formula in &FORMULAS {
            judge(formula, &queries, &truths).print(formula, count);
        }
    }
    Ok(())
}
