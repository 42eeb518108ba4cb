//! What surely does not meet for some time: plain binary64 with a margin that
//! is beyond all rounding.
//!
//! With the relative position d and the relative velocity v the squared distance
//! f(t) = |d + v t|² falls until t₀ = -d·v / (v·v), to d·d - (d·v)² / (v·v). A point
//! stays clear of a circle of radius R for as long as f exceeds R² by a millionth of
//! d·d: for ever, or up to the smaller root s of the quadratic that says so. The last
//! few roundings, in s and in what it is computed from, change f there by 8 · 2^-53 d·d,
//! which the margin covers as well.
//!
//! If d is known to within 2^-24 of its length, and v to a few units in the last
//! place, that is true: all errors together are less than 4 · 2^-24 d·d, for the
//! way up to t₀ is no longer than d.
//!
//! And it is what the formulas of [`meet_circle`](super::meet_circle) come to for
//! the same d, v and R. With u = 2^-53 they err by 8 u (v·v) R² in the
//! discriminant D = (v·v)² σ², where t₀ - σ is the time of the impact. If f exceeds R²
//! for ever, D is negative by a millionth of (d·d) (v·v), and found to be.
//! Otherwise (t₀ - s)² exceeds σ² by a millionth of d·d / (v·v), so what is computed
//! for σ, wrong by much less, leaves an impact later than s by some ten-millionths
//! of |d| / |v|; and both gap and approach, which exceed a millionth of d·d and a
//! thousandth of |d| |v|, are certain to ten digits.

/// The part of the squared distance that exceeds all errors.
const MARGIN: f64 = 1e-6;

/// Coordinates up to this have products, and products of these, without overflow.
const MOST: f64 = f64::from_bits((1023 + 100) << 52);

/// A product of squares that is larger than this is not wrong by what vanishes, if
/// coordinates are no larger than [`MOST`].
const LEAST: f64 = f64::from_bits((1023 - 700) << 52);

/// How much the squared distance of points must exceed that at which they touch, so that
/// it is known well enough, if their coordinates, and those of their velocities, add up to
/// `far` and to `fast` at most: a difference of such numbers, or of what is computed from
/// them in a few steps, errs by some units in the last place of the largest one.
pub(crate) fn least_room(far: f64, fast: f64) -> f64 {
    if far < MOST && fast < MOST {
        let least = far * 1e-8;
        (least * least).max(LEAST)
    } else {
        f64::INFINITY
    }
}

/// A point that moves past a circle about the origin, by the squares and products that
/// tell for how long it surely stays clear.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Passage {
    /// By how much the squared distance exceeds all that counts as touching.
    room: f64,
    /// The product of offset and velocity: negative where the two approach.
    approach: f64,
    /// The square of the velocity.
    speed: f64,
}

impl Passage {
    /// A point at an offset from a circle of radius `reach`.
    #[inline(always)]
    pub(crate) fn of([x, y]: [f64; 2], [vx, vy]: [f64; 2], reach: f64) -> Self {
        let distance = x * x + y * y;
        Self {
            room: distance * (1.0 - MARGIN) - reach * reach,
            approach: x * vx + y * vy,
            speed: vx * vx + vy * vy,
        }
    }

    /// Whether the point surely stays clear for ever, if the room is known where it is more
    /// than `least`. If not, that says nothing: so it is where nothing moves.
    #[inline(always)]
    pub(crate) fn is_clear(&self, least: f64) -> bool {
        let approach = if self.approach < 0.0 {
            self.approach
        } else {
            0.0
        };
        // As likely as not each: quicker without branches.
        (self.room > least) & (approach * approach + LEAST < self.room * self.speed)
    }

    /// For how long the point surely stays clear. What overflows, or is not a number,
    /// proves nothing.
    #[inline(always)]
    pub(crate) fn clear_for(&self, least: f64) -> f64 {
        let product = self.room * self.speed;
        let discriminant = self.approach * self.approach - product;
        if self.room <= least {
            0.0
        } else if self.approach >= 0.0 {
            f64::INFINITY
        } else if product > LEAST && product < f64::INFINITY {
            let time = self.room / (discriminant.max(0.0).sqrt() - self.approach);
            if time > 0.0 { time } else { 0.0 }
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::detect::meet_circle;
    use crate::vec2::Vec2;

    /// From far away, and from close by: with little room left, or none.
    fn offset() -> impl Strategy<Value = ([f64; 2], f64)> {
        let length = prop_oneof![1.0..1e3_f64, (-40.0..0.0_f64).prop_map(|e| 1.0 + e.exp2())];
        (0.0..7.0_f64, length, 1e-3..1e3_f64).prop_map(|(angle, length, reach)| {
            let length = length * reach;
            ([length * angle.cos(), length * angle.sin()], reach)
        })
    }

    /// For how long a point surely stays clear.
    fn clear_for(offset: [f64; 2], velocity: [f64; 2], reach: f64, least: f64) -> f64 {
        let passage = Passage::of(offset, velocity, reach);
        match passage.is_clear(least) {
            true => f64::INFINITY,
            false => passage.clear_for(least),
        }
    }

    proptest! {
        /// What is clear for some time is not met before by the formulas, also
        /// where the path all but touches the circle.
        #[test]
        fn what_is_clear_is_not_met(
            ([x, y], reach) in offset(),
            aside in prop_oneof![-2.0..2.0_f64, (-40.0..-1.0_f64).prop_map(|e| 1.0 + e.exp2())],
            speed in 1e-3..1e3_f64,
        ) {
            let squared = x * x + y * y;
            let across = aside * reach / squared.sqrt();
            let along = (1.0 - across * across).max(0.0).sqrt();
            let length = speed / squared.sqrt();
            let velocity = [
                (-x * along - y * across) * length,
                (-y * along + x * across) * length,
            ];
            let Ok(met) = meet_circle(&[x, y].into(), &Vec2::from(velocity), &reach);
            let clear = clear_for([x, y], velocity, reach, least_room(x.abs() + y.abs(), speed * 1.5));
            prop_assert!(met.is_none_or(|met| met.delay > clear || met.overlap && clear == 0.0));
        }

        /// With a little to spare, the other way round.
        #[test]
        fn what_is_not_met_is_clear(angle in 0.0..7.0_f64, reach in 0.1..10.0_f64) {
            let [x, y] = [angle.cos(), angle.sin()].map(|part| 20.0 * part);
            let velocity = [-x / 20.0, -y / 20.0];
            prop_assert!(clear_for([x, y], velocity, reach, LEAST) > 0.999 * (20.0 - reach));
            prop_assert!(clear_for([x, y], [y, -x], reach, LEAST) == f64::INFINITY);
            prop_assert!(clear_for([x, y], [x, y], reach, LEAST) == f64::INFINITY);
        }
    }

    /// Where numbers may overflow or vanish, nothing is said.
    #[test]
    fn extremes_are_left_open() {
        let least = |far, fast| least_room(far, fast);
        for scale in [1e-200, 1e200] {
            let offset = [4.0 * scale, 0.0];
            let least = least(4.0 * scale, scale);
            assert_eq!(clear_for(offset, [-scale, 0.0], scale, least), 0.0);
        }
        let [near, fast] = [[4.0, 0.0], [-1e200, 1e200]];
        assert_eq!(clear_for(near, fast, 1.0, least(4.0, 2e200)), 0.0);
        assert_eq!(clear_for(near, [0.0, 1.0], 1.0, least(1e9, 1.0)), 0.0);
        assert_eq!(
            clear_for(near, [-1e-200, 1e-200], 1.0, least(4.0, 1.0)),
            0.0
        );
    }
}
