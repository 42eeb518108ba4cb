//! A disc that falls back to a wall again and again, ever less high.
//!
//! Between two impacts on a wall's interior the normal motion is that of a
//! thrown ball: a flight takes a time proportional to the speed, of which each
//! impact leaves a part e. So the flights are a geometric series, of which the
//! sum is that of the first one, divided by 1 - e.
//!
//! It is told as soon as the rest of the series is [`CLOSE`] to nothing, seen
//! from the start of the run, and nothing else can happen in it: no other disc
//! meets anything, and the disc's box, of what it can cover in that time, touches
//! no other body and stays beside the wall.

use super::Accumulation;
use super::alone::{is_apart, stays_beside};
use crate::body::{BodyId, Feature, Pair};
use crate::respond::Restitution;
use crate::scalar::{Interval, Scalar};
use crate::timeline::{Timed, Timeline};
use crate::vec2::Vec2;
use crate::world::Obstacle;

/// The part of the time so far that may be left.
const CLOSE: f64 = 1.0 / (1_u64 << 40) as f64;

impl<S: Timed> Timeline<S> {
    /// The end of the bounces of a pair that has just collided, if there is one
    /// soon.
    pub(super) fn bounces(&self, pair: Pair) -> Option<Accumulation<S>> {
        let (BodyId::Disc(disc), BodyId::Wall(wall)) = (pair.a, pair.b) else {
            return None;
        };
        let (disc, wall) = (disc as usize, wall as usize);
        let world = &self.flights.world;
        let Restitution::Newton {
            walls: kept,
            elastic_below: None,
            ..
        } = &world.restitution
        else {
            return None;
        };
        if world.discs[disc].last != Some(Feature::Wall(wall as u32)) {
            return None;
        }
        let flight = world.flight(disc, &self.flights.starts[disc].since);
        let left = S::bouncing(flight, &world.walls[wall].segment, kept)?;
        let limit = left.clone().map(|left| self.now.clone() + &left);
        let is_close = left[1].hull().hi() <= CLOSE * limit[1].hull().lo();
        (is_close && self.bounces_alone(disc, wall, &limit[1])).then(|| Accumulation {
            limit,
            proven: !S::ROUNDS,
            word: vec![pair],
        })
    }

    /// Whether a disc meets nothing but a wall before a time, and nobody else
    /// anything.
    fn bounces_alone(&self, disc: usize, wall: usize, limit: &S) -> bool {
        let end = limit.hull().hi();
        let span = (end - self.now.hull().lo()).max(0.0);
        let mut world = self.flights.world.hull();
        for body in 0..world.discs.len() {
            let [here, there] = [&self.now, limit].map(|time| self.flights.disc_at(body, time));
            let gain = there.velocity.minus(&here.velocity);
            let [speed, gain] = [&here.velocity, &gain].map(length);
            let reach = 2.0 * (speed + gain) * span + f64::MIN_POSITIVE;
            let around = Interval::new(-reach, reach);
            world.discs[body].position = here.position.map(|coordinate| coordinate.hull() + around);
        }
        let is_it = |other| other == Obstacle::Wall(wall) || other == Obstacle::Disc(disc);
        self.others_are_free(|other| other == disc, end)
            && is_apart(&world, disc, is_it)
            && stays_beside(&world, disc, wall)
    }
}

fn length<S: Scalar>(vector: &Vec2<S>) -> f64 {
    vector.map(S::hull).norm_squared().sqrt().hi()
}
