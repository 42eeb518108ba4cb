//! A gas of discs over a long run, in binary64 and in filtered arithmetic: how
//! far the energy drifts, and how deep bodies overlap by rounding.
//!
//! ```text
//! cargo run --release --example long_run -- [DISCS] [IMPACTS] [ARITHMETIC]
//! ```

use std::convert::Infallible;
use std::time::Instant;

use carom::arithmetic::Arithmetic;
use carom::body::{Disc, Mass};
use carom::scalar::{Filtered, Scalar};
use carom::scene::Scene;
use carom::scene::generate::gas;
use carom::timeline::Timeline;
use carom::vec2::Vec2;
use carom::world::World;

/// So often the state is looked at.
const AUDITS: u64 = 10;

/// What becomes of a gas.
#[derive(Default)]
struct Record {
    impacts: u64,
    drift: f64,
    /// The largest overlaps, in ulps of the largest coordinate.
    between_discs: f64,
    with_walls: f64,
}

fn main() {
    let number = |place: usize, default: u64| {
        let argument = std::env::args().nth(place);
        argument.map_or(default, |text| text.parse().expect("a number"))
    };
    let (discs, impacts) = (number(1, 1000), number(2, 1_000_000));
    let scene = gas(42, discs as u32, 0.5).expect("a valid scene");
    println!("{discs} discs at packing 0.5, {impacts} impacts");
    println!("arithmetic  impacts/s  energy drift  overlap of discs, of walls [ulps]");
    let chosen = std::env::args().nth(3);
    let is_chosen = |name| chosen.as_ref().is_none_or(|chosen| chosen == name);
    if is_chosen(f64::NAME) {
        follow::<f64>(&scene, impacts);
    }
    if is_chosen(Filtered::NAME) {
        follow::<Filtered>(&scene, impacts);
    }
}

fn follow<S: Arithmetic<Precision = (), Doubt = Infallible>>(scene: &Scene, impacts: u64) {
    let world = World::<S>::new(scene, ());
    let size = world.walls[1].segment.to.x.to_f64();
    let before = energy(&world.discs);
    let Ok(mut timeline) = Timeline::new(world, &S::from_integer(i32::MAX));
    let (mut record, mut seconds) = (Record::default(), 0.0);
    for _ in 0..AUDITS {
        let begun = Instant::now();
        for _ in 0..impacts / AUDITS {
            let Ok(impact) = timeline.next_impact(&S::from_integer(i32::MAX));
            record.impacts += u64::from(impact.is_some());
        }
        seconds += begun.elapsed().as_secs_f64();
        let now = timeline.now().clone();
        record.audit(&timeline.discs_at(&now), before, size);
    }
    println!(
        "{:10}  {:9.0}  {:12.1e}  {:16.1}  {:9.1}",
        S::NAME,
        record.impacts as f64 / seconds,
        record.drift,
        record.between_discs,
        record.with_walls,
    );
}

impl Record {
    fn audit<S: Scalar>(&mut self, discs: &[Disc<S>], energy_before: f64, size: f64) {
        let drift = (energy(discs) / energy_before - 1.0).abs();
        self.drift = self.drift.max(drift);
        let ulp = size.next_up() - size;
        for (place, disc) in discs.iter().enumerate() {
            let (position, radius) = (disc.position.map(S::to_f64), disc.radius.to_f64());
            let walls = [position.x, position.y, size - position.x, size - position.y];
            for distance in walls {
                self.with_walls = self.with_walls.max((radius - distance) / ulp);
            }
            for other in &discs[place + 1..] {
                let overlap = radius + other.radius.to_f64() - distance(disc, other);
                self.between_discs = self.between_discs.max(overlap / ulp);
            }
        }
    }
}

fn distance<S: Scalar>(one: &Disc<S>, other: &Disc<S>) -> f64 {
    let Vec2 { x, y } = other.position.minus(&one.position).map(S::to_f64);
    x.hypot(y)
}

fn energy<S: Scalar>(discs: &[Disc<S>]) -> f64 {
    let energy = |disc: &Disc<S>| match &disc.mass {
        Mass::Finite(mass) => mass.to_f64() * disc.velocity.norm_squared().to_f64() / 2.0,
        Mass::Infinite => 0.0,
    };
    discs.iter().map(energy).sum()
}
