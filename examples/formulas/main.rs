//! The usual formulas for the time at which two discs meet against the stable
//! one, all in binary64, and all against whole numbers.
//!
//! ```text
//! cargo run --release --example formulas [QUERIES [NEAR]]
//! ```
//!
//! For so many queries of each kind, or `NEAR` of those that nearly touch or
//! nearly miss: how many verdicts (whether the two meet) are wrong; where verdict
//! and truth are a hit, how many times are not the binary64 nearest to the true
//! one, and the median and the largest error in ulps; and what a query costs. The
//! numbers of a query are taken as they are: binary64.

mod exact;
mod queries;
mod score;
mod whole;
mod wide;

use carom::body::{Disc, Mass};
use carom::detect::meet_circle;
use carom::kernel::{Approach, Flight, Kernel, Time};
use carom::scalar::Filtered;
use carom::vec2::Vec2;
use exact::Query;
use queries::{KINDS, Kind};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use score::Table;

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

/// Queries that are made at a time.
const BATCH: usize = 10_000;

/// Makes queries of a kind, batch by batch, and judges what is found.
fn judge(kind: &Kind, count: usize) {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let mut batch = |left: usize| -> Vec<_> {
        (0..left.min(BATCH))
            .map(|_| (kind.make)(&mut random))
            .collect()
    };
    let mut queries = batch(count);
    let mut table = Table::new(&queries);
    let mut left = count;
    while !queries.is_empty() {
        queries.iter().for_each(|query| table.add(query));
        left -= queries.len();
        queries = batch(left);
    }
    table.print(kind, count);
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let numbers = std::env::args().skip(1).map(|text| text.parse());
    let numbers = numbers.collect::<Result<Vec<usize>, _>>()?;
    let count = numbers.first().copied().unwrap_or(10_000);
    let near = numbers.get(1).copied().unwrap_or(count);
    println!("{}", score::HEAD);
    for kind in &KINDS {
        judge(kind, if kind.is_near { near } else { count });
    }
    Ok(())
}
