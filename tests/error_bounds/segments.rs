//! A disc and the interior of a wall, on a lattice, where differences of
//! coordinates are exact.

use carom::detect::{Segment, meet_segment};
use carom::vec2::Vec2;
use num_rational::BigRational;
use num_traits::Signed;
use proptest::prelude::*;

use super::exact::{fraction, root};
use super::{unit, whole};
use crate::common::strategy::{cases, vector};

/// A disc that flies over a wall.
#[derive(Clone, Debug)]
struct Flight {
    centre: [f64; 2],
    velocity: [f64; 2],
    radius: f64,
    from: [f64; 2],
    along: [f64; 2],
}

/// A part of a wall between its ends, with few bits.
fn part() -> impl Strategy<Value = f64> {
    (1..64).prop_map(|steps| f64::from(steps) / 64.0)
}

/// From over one point of the wall, at a height that is given as a part of its
/// length, towards another point of it or away; with a radius that leaves some
/// part of the height, down to 2^-50.
fn flight(approaches: bool) -> impl Strategy<Value = Flight> {
    let wall = (vector(16.0), vector(16.0)).prop_filter("a point", |(_, along)| *along != [0.0; 2]);
    let places = (part(), part(), part(), prop::bool::ANY);
    let gap = (-50.0..-0.1).prop_map(f64::exp2);
    (wall, places, gap).prop_map(
        move |((from, along), (start, target, height, below), gap)| {
            let [x, y] = along;
            let height = if below { -height } else { height };
            let place = |part: f64, height: f64| [part * x - height * y, part * y + height * x];
            let sink = if approaches { -height } else { height };
            Flight {
                centre: [0, 1].map(|axis| from[axis] + place(start, height)[axis]),
                velocity: place(target - start, sink),
                radius: height.abs() * x.hypot(y) * (1.0 - gap),
                from,
                along,
            }
        },
    )
}

/// What fractions say of a flight towards its wall.
struct Truth {
    time: BigRational,
    /// (h - r L) / (h + r L), with the distance h / L from the line.
    gap: BigRational,
}

impl Flight {
    /// The time at which the line of the wall is met.
    fn solve(&self) -> Truth {
        let exact = |vector: [f64; 2]| vector.map(fraction);
        let ([x, y], [u, v]) = (exact(self.centre), exact(self.velocity));
        let ([from_x, from_y], [along_x, along_y]) = (exact(self.from), exact(self.along));
        let side = ((x - from_x) * &along_y - (y - from_y) * &along_x).abs();
        let drift = (u * &along_y - v * &along_x).abs();
        let length = root(&(&along_x * &along_x + &along_y * &along_y));
        let reach = fraction(self.radius) * length;
        Truth {
            time: (&side - &reach) / drift,
            gap: (&side - &reach) / (side + reach),
        }
    }

    fn compute(&self) -> Option<(f64, bool)> {
        let [from, along] = [self.from, self.along].map(Vec2::from);
        let segment = Segment::new(from, from.plus(&along), along);
        let [centre, velocity] = [self.centre, self.velocity].map(Vec2::from);
        let Ok(met) = meet_segment(&centre, &velocity, &self.radius, &segment, |_| false);
        met.map(|met| (met.delay, met.end.is_none()))
    }
}

proptest! {
    #![proptest_config(cases(5_000))]

    /// Whether the wall is met is right, and so is that its interior is; the
    /// error of the time is at most 7u/g of it, where g > 3u.
    #[test]
    fn times_are_within_the_bound(flight in flight(true)) {
        let truth = flight.solve();
        let met = flight.compute();
        prop_assert!(met.is_some_and(|(_, is_interior)| is_interior));
        let delay = met.map_or(0.0, |(delay, _)| delay);
        if truth.gap > whole(3) * unit() {
            let error = (fraction(delay) - &truth.time).abs();
            prop_assert!(error <= whole(7) * unit() / truth.gap * truth.time, "{}", delay);
        }
    }

    /// What does not approach does not meet, however near it is.
    #[test]
    fn what_leaves_does_not_meet(flight in flight(false)) {
        prop_assert!(flight.compute().is_none());
    }
}
