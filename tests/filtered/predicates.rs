//! Single decisions near their degeneracies, against fractions: whether two
//! discs meet and, to the last bit, when; and which of two meetings is first.

use std::cmp::Ordering;

use carom::body::{Disc, Mass};
use carom::filtered::Moment;
use carom::kernel::{Approach, Flight, Kernel, Met, Time};
use carom::scalar::Filtered;
use carom::vec2::Vec2;
use proptest::prelude::*;

use super::fraction::{Surd, ratio};
use super::reference::approach;
use crate::common::strategy::cases;

/// Two discs: where the second one is from the first, how it moves, the sum of
/// the radii, and a place far away or near for both.
#[derive(Clone, Copy, Debug)]
struct Query {
    offset: [f64; 2],
    velocity: [f64; 2],
    reach: f64,
    origin: [f64; 2],
    since: f64,
}

impl Query {
    fn discs(&self) -> [Disc<Filtered>; 2] {
        let disc = |[x, y]: [f64; 2], velocity: [f64; 2]| Disc {
            position: Vec2::new(x, y).map(|number| Filtered::new(*number)),
            velocity: Vec2::from(velocity).map(|number| Filtered::new(*number)),
            radius: Filtered::new(self.reach / 2.0),
            mass: Mass::Finite(Filtered::new(1.0)),
            last: None,
        };
        let [x, y] = self.origin;
        let there = [x + self.offset[0], y + self.offset[1]];
        [disc([x, y], [0.0; 2]), disc(there, self.velocity)]
    }

    fn decided(&self) -> Option<Met<Moment>> {
        let [early, late] = &self.discs();
        let since = Filtered::new(self.since);
        let flight = |disc| Flight {
            disc,
            since: &since,
            pull: &(),
        };
        let approach = Approach {
            early: flight(early),
            late: flight(late),
            together: true,
        };
        let Ok(met) = Filtered::meet_discs(&approach);
        met
    }

    /// The time by the textbook's quadratic of the stored numbers.
    fn expected(&self) -> Option<Surd> {
        let [early, late] = self.discs();
        let exact = |vector: Vec2<Filtered>| [vector.x, vector.y].map(|n| ratio(n.get()));
        let [from, to] = [exact(early.position), exact(late.position)];
        let offset = [&to[0] - &from[0], &to[1] - &from[1]];
        let reach = ratio(early.radius.get()) + ratio(late.radius.get());
        let delay = approach(&offset, &exact(late.velocity), &reach)?;
        Some(delay.mapped(&ratio(1.0), &ratio(self.since)))
    }

    fn check(&self) -> Result<(), TestCaseError> {
        let (found, expected) = (self.decided(), self.expected());
        let found = found.filter(|met| !met.graze);
        prop_assert_eq!(found.is_some(), expected.is_some(), "{:?}", self);
        if let (Some(met), Some(time)) = (found, expected) {
            prop_assert_eq!(met.time.value().get(), time.rounded(), "{:?}", self);
        }
        Ok(())
    }
}

fn nudged(number: f64, ulps: i32) -> f64 {
    let step = if ulps < 0 {
        f64::next_down
    } else {
        f64::next_up
    };
    (0..ulps.abs()).fold(number, |number, _| step(number))
}

fn vector(size: f64) -> impl Strategy<Value = [f64; 2]> {
    [-size..size, -size..size]
}

fn origin() -> impl Strategy<Value = [f64; 2]> {
    prop_oneof![Just([0.0, 0.0]), vector(10.0), vector(1e12)]
}

/// Any two discs.
fn any_query() -> impl Strategy<Value = Query> {
    (
        vector(8.0),
        vector(2.0),
        0.01..6.0_f64,
        origin(),
        0.0..100.0_f64,
    )
        .prop_map(|(offset, velocity, reach, origin, since)| Query {
            offset,
            velocity,
            reach,
            origin,
            since,
        })
}

/// The distance at which the second disc passes, give or take some ulps, is the
/// sum of the radii.
fn tangent() -> impl Strategy<Value = Query> {
    (any_query(), -3..=3_i32).prop_map(|(query, ulps)| {
        let ([x, y], [vx, vy]) = (query.offset, query.velocity);
        let miss = (x * vy - y * vx).abs() / vx.hypot(vy);
        let reach = nudged(miss.max(1e-300), ulps);
        Query { reach, ..query }
    })
}

/// The discs touch, give or take some ulps.
fn touching() -> impl Strategy<Value = Query> {
    (any_query(), -3..=3_i32).prop_map(|(query, ulps)| {
        let [x, y] = query.offset;
        let reach = nudged(x.hypot(y), ulps);
        Query { reach, ..query }
    })
}

/// Sizes, speeds and times of all scales.
fn scaled() -> impl Strategy<Value = Query> {
    let exponent = || -400..=400_i32;
    (prop_oneof![any_query(), tangent()], exponent(), exponent()).prop_map(
        |(query, size, speed)| {
            let [size, speed] = [size, speed].map(|exponent| f64::from(exponent).exp2());
            Query {
                offset: query.offset.map(|x| x * size),
                velocity: query.velocity.map(|v| v * speed),
                reach: query.reach * size,
                origin: [0.0; 2],
                since: 0.0,
            }
        },
    )
}

/// Two pairs that meet at nearly the same time: the second one is the first
/// with one number nudged, or turned by a right angle.
fn near_ties() -> impl Strategy<Value = [Query; 2]> {
    (any_query(), 0..3_usize, -2..=2_i32).prop_map(|(query, what, ulps)| {
        let mut other = query;
        match what {
            0 => other.offset[0] = nudged(query.offset[0], ulps),
            1 => other.velocity[1] = nudged(query.velocity[1], ulps),
            _ => {
                let turned = |[x, y]: [f64; 2]| [-y, x];
                other.offset = turned(query.offset);
                other.velocity = turned(query.velocity);
                other.reach = nudged(query.reach, ulps);
                other.origin = turned(query.origin);
            }
        }
        [query, other]
    })
}

fn order(queries: &[Query; 2]) -> Option<(Ordering, Ordering)> {
    let [one, two] = queries.each_ref().map(Query::decided);
    let Ok(found) = one?.time.order(&two?.time);
    let [one, two] = queries.each_ref().map(Query::expected);
    Some((found, one?.compare_algebraically(&two?)))
}

proptest! {
    #![proptest_config(cases(10_000))]

    #[test]
    fn any_two_discs(query in any_query()) {
        query.check()?;
    }

    #[test]
    fn passes_close_to_tangency(query in tangent()) {
        query.check()?;
    }

    #[test]
    fn discs_that_nearly_touch(query in touching()) {
        query.check()?;
    }

    #[test]
    fn times_that_are_nearly_equal(queries in near_ties()) {
        if let Some((found, expected)) = order(&queries) {
            prop_assert_eq!(found, expected, "{:?}", queries);
        }
    }
}

proptest! {
    #![proptest_config(cases(3000))]

    #[test]
    fn all_scales(query in scaled()) {
        query.check()?;
    }
}
