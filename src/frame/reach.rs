//! Where a body may get to within a time: what the broad phase looks at.
//!
//! Within a frame a disc moves on a straight line (D19), so all of it keeps within
//! the box about its two ends. The box is made larger by a margin of
//!
//! m = 2^-22 r + 2^-44 s,
//!
//! where r is the disc's radius and s the largest magnitude in the box. Two bodies
//! whose boxes are apart do not meet in that time, whatever the
//! arithmetic:
//!
//! - `exact` and `filtered` decide for numbers that are within the box's: they
//!   find that the two do not meet, for so it is.
//! - `f64` computes a time t, and the two are found to meet if that is within the
//!   frame. With u = 2^-53, two discs at d of each other with the velocity v and the
//!   sum R of their radii: by the errors of [`meet_circle`](crate::detect::meet_circle)
//!   the root √D is wrong by at most √(9u) |v| R + u √D, and d·v by 2u |d||v|. The
//!   denominator of t is at least |d·v|, and t itself at most |d·v| / v², so
//!   that |v| t is wrong by at most 2 √(9u) R + 9u |d|: also in tangency, where the
//!   reference is not the true root but the time when they are nearest. So at t
//!   the two are no further from each other than R + 2^-23 R + 9u |d|. The same
//!   holds for a wall's end point, and at its interior the distance is wrong by
//!   some 16u |d|, from the products alone. What else rounds (d and v as
//!   differences, the way to the start on clocks that differ, the time that is left)
//!   comes to a few u of the numbers that s bounds. All together is less than half
//!   of what the two margins are.
//! - That two bodies overlap where they are is found with the same products.
//!
//! These errors are relative as long as no product overflows or vanishes. If
//! a magnitude is beyond [`Number::BINARY64_RANGE`], the body may be anywhere.
//! The box itself is computed to a few u of s.

use crate::body::Disc;
use crate::broad_phase::Area;
use crate::detect::Segment;
use crate::scalar::{Interval, Number, Scalar};
use crate::vec2::Vec2;

/// The part of a radius by which its body may seem to be elsewhere.
const OF_RADIUS: f64 = f64::from_bits((1023 - 22) << 52);

/// The part of the largest magnitude.
const OF_SIZE: f64 = f64::from_bits((1023 - 44) << 52);

/// Magnitudes beyond this one, or below its inverse, are not trusted.
const LIMIT: f64 = f64::from_bits((1023 + Number::BINARY64_RANGE as u64) << 52);

/// Where a disc may get to within a time.
pub(super) fn of_disc<S: Scalar>(disc: &Disc<S>, time: f64) -> Area {
    let Disc {
        position,
        velocity,
        radius,
        ..
    } = disc;
    let (position, velocity) = (position.map(S::hull), velocity.map(S::hull));
    let radius = radius.hull();
    if S::ROUNDS && ![velocity.x, velocity.y, radius].iter().all(is_moderate) {
        return Area::WHOLE;
    }
    let way = |velocity: Interval| {
        let way = [velocity.lo() * time, velocity.hi() * time];
        [way[0].min(0.0), way[1].max(0.0)]
    };
    let end = |position: Interval, velocity: Interval| {
        let [back, forth] = way(velocity);
        [position.lo() + back, position.hi() + forth]
    };
    let ends = [end(position.x, velocity.x), end(position.y, velocity.y)];
    around(ends, radius.hi())
}

/// Where a wall is.
pub(super) fn of_wall<S: Scalar>(wall: &Segment<S>) -> Area {
    let [from, to] = [&wall.from, &wall.to].map(|end: &Vec2<S>| end.map(S::hull));
    let hull =
        |one: Interval, other: Interval| [one.lo().min(other.lo()), one.hi().max(other.hi())];
    around([hull(from.x, to.x), hull(from.y, to.y)], 0.0)
}

/// What is no further than a radius, and the margin, from the points between ends
/// in both coordinates.
fn around(ends: [[f64; 2]; 2], radius: f64) -> Area {
    let magnitudes = ends.as_flattened().iter().map(|end| end.abs());
    let size = radius + magnitudes.fold(0.0, f64::max);
    if size >= LIMIT {
        return Area::WHOLE;
    }
    let reach = radius + (OF_RADIUS * radius + OF_SIZE * size);
    let [x, y] = ends;
    Area::new([x[0] - reach, y[0] - reach], [x[1] + reach, y[1] + reach])
}

/// Whether a number, given as bounds that are one, is zero or of a magnitude that
/// products bear.
fn is_moderate(number: &Interval) -> bool {
    let size = number.magnitude();
    size == 0.0 || (1.0 / LIMIT..LIMIT).contains(&size)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::body::{End, Mass};
    use crate::kernel::{Approach, Flight, Kernel};

    fn disc(position: [f64; 2], velocity: [f64; 2], radius: f64) -> Disc<f64> {
        Disc {
            position: position.into(),
            velocity: velocity.into(),
            radius,
            mass: Mass::Finite(1.0),
            last: None,
        }
    }

    fn flight(disc: &Disc<f64>) -> Flight<'_, f64> {
        Flight {
            disc,
            since: &0.0,
            pull: &(),
        }
    }

    /// Whether two discs are found to meet within a time.
    fn discs_meet([early, late]: [&Disc<f64>; 2], time: f64) -> bool {
        let [early, late] = [early, late].map(flight);
        let together = true;
        let Ok(met) = f64::meet_discs(&Approach {
            early,
            late,
            together,
        });
        met.is_some_and(|met| met.time <= time)
    }

    fn wall_is_met(disc: &Disc<f64>, wall: &Segment<f64>, time: f64) -> bool {
        let Ok(met) = f64::meet_wall(flight(disc), wall, |_: End| false);
        met.is_some_and(|met| met.time <= time)
    }

    fn segment(from: [f64; 2], to: [f64; 2]) -> Segment<f64> {
        let (from, to) = (Vec2::from(from), Vec2::from(to));
        Segment::new(from, to, to.minus(&from))
    }

    /// Just more or less than one: it is about boxes that are all but together.
    fn nearly_one() -> impl Strategy<Value = f64> {
        let part = prop_oneof![Just(0.0), (-52.0..-1.0_f64).prop_map(f64::exp2)];
        (part, any::<bool>())
            .prop_map(|(part, is_more)| if is_more { 1.0 + part } else { 1.0 - part })
    }

    /// Sizes that are alike, or differ very much.
    fn size() -> impl Strategy<Value = f64> {
        prop_oneof![0.5..2.0_f64, (-30.0..30.0_f64).prop_map(f64::exp2)]
    }

    /// Mirrored, or with its coordinates exchanged.
    fn turned([x, y]: [f64; 2], turn: u8) -> [f64; 2] {
        match turn % 4 {
            0 => [x, y],
            1 => [-x, y],
            2 => [y, x],
            _ => [y, -x],
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(5000))]

        /// One flies past the other, all but parallel to an axis, or up to it.
        #[test]
        fn discs_apart_do_not_meet(
            radii in [size(), size()],
            (way, aside, along) in (size(), nearly_one(), prop_oneof![0.0..1.0_f64, nearly_one()]),
            (slope, time) in (prop_oneof![Just(0.0), (-60.0..1.0_f64).prop_map(f64::exp2)], size()),
            (place, turn) in ([-4.0..4.0_f64, -4.0..4.0_f64], 0..4_u8),
        ) {
            let reach = radii[0] + radii[1];
            let still = disc(turned(place, turn), [0.0; 2], radii[0]);
            for offset in [[way + reach, reach * aside], [(way + reach) * along.max(0.1), 0.0]] {
                let position = [place[0] + offset[0], place[1] + offset[1]];
                let velocity = [-way / time, slope * way / time];
                let [position, velocity] = [position, velocity].map(|vector| turned(vector, turn));
                let moving = disc(position, velocity, radii[1]);
                let areas = [&still, &moving].map(|disc| of_disc(disc, time));
                let pairs = [[&still, &moving], [&moving, &still]];
                let meet = pairs.iter().any(|pair| discs_meet(*pair, time));
                prop_assert!(areas[0].overlaps(&areas[1]) || !meet);
            }
        }

        /// Past a wall along an axis, past its end, or up to it.
        #[test]
        fn discs_apart_do_not_meet_walls(
            (radius, length, way) in (size(), size(), size()),
            (aside, slope) in (nearly_one(), prop_oneof![Just(0.0), (-60.0..1.0_f64).prop_map(f64::exp2)]),
            time in size(),
            (place, turn) in ([-4.0..4.0_f64, -4.0..4.0_f64], 0..4_u8),
        ) {
            let wall = segment(turned(place, turn), turned([place[0] + length, place[1]], turn));
            let courses = [
                ([length + way, radius * aside], [-way, -slope * way]),
                ([length + radius * aside, way], [slope * way, -way]),
                ([length / 2.0, radius + way * aside], [slope * way, -way]),
                ([length + radius + way * aside, slope * radius], [-way, 0.0]),
            ];
            for (offset, velocity) in courses {
                let position = [place[0] + offset[0], place[1] + offset[1]];
                let velocity = velocity.map(|way| way / time);
                let disc = disc(turned(position, turn), turned(velocity, turn), radius);
                let is_apart = !of_disc(&disc, time).overlaps(&of_wall(&wall));
                prop_assert!(!is_apart || !wall_is_met(&disc, &wall, time));
            }
        }

        /// Most of the pairs above are of this kind: their boxes are not much larger
        /// than they have to be.
        #[test]
        fn boxes_are_tight(radius in size(), place in [-4.0..4.0_f64, -4.0..4.0_f64], way in size()) {
            let one = disc(place, [way, 0.0], radius);
            let far = radius * (1.0 + 1e-6) + 1e-12 * (way + 4.0);
            let ends = [[place[0] + way + radius + far, place[1]], [place[0], place[1] + radius + far]];
            for end in ends {
                let other = disc(end, [0.0; 2], radius);
                prop_assert!(!of_disc(&one, 1.0).overlaps(&of_disc(&other, 1.0)));
            }
        }
    }

    #[test]
    fn what_products_do_not_bear_is_everywhere() {
        for number in [1e-61, 1e61, f64::MAX, f64::INFINITY, f64::NAN] {
            assert_eq!(
                of_disc(&disc([0.0; 2], [number, 0.0], 1.0), 1.0),
                Area::WHOLE
            );
            assert_eq!(of_disc(&disc([0.0; 2], [0.0; 2], number), 0.0), Area::WHOLE);
        }
        for number in [1e61, f64::MAX, f64::INFINITY, f64::NAN] {
            assert_eq!(
                of_disc(&disc([0.0, number], [0.0; 2], 1.0), 1.0),
                Area::WHOLE
            );
            assert_eq!(of_wall(&segment([0.0; 2], [number, 0.0])), Area::WHOLE);
        }
        for time in [1e61, f64::MAX, f64::INFINITY] {
            let disc = disc([0.0; 2], [1.0, 0.0], 1.0);
            assert_eq!(of_disc(&disc, time), Area::WHOLE);
        }
    }
}
