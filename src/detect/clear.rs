//! What surely does not meet for some time: plain binary64 with a margin that
//! is beyond all rounding.
//!
//! With the relative position d and the relative velocity v the squared distance
//! f(t) = |d + v t|² falls until t₀ = -d·v / (v·v). So its least value within a
//! time s is f(s), or f(t₀) = d·d - (d·v)² / (v·v) where s is later than that. A
//! point stays clear of a circle of radius R if that least value exceeds R² by
//! a millionth of d·d. Neither division nor root is needed.
//!
//! If d is known to within 2^-24 of its length, and v to a few units in the last
//! place, that is true: all errors together are less than 4 · 2^-24 d·d, for the
//! way up to t₀ is no longer than d.
//!
//! And it is what the formulas of [`meet_circle`](super::meet_circle) come to for
//! the same d, v and R. With u = 2^-53 they err by 8 u (v·v) R² in the
//! discriminant D = (v·v)² σ², where t₀ - σ is the time of the impact. If s is
//! after t₀, D is negative by a millionth of (d·d) (v·v), and found to be.
//! Otherwise (t₀ - s)² exceeds σ² by a millionth of d·d / (v·v), so what is computed
//! for σ, wrong by much less, leaves an impact later than s by some ten-millionths
//! of |d| / |v|; and both gap and approach, which exceed a millionth of d·d and a
//! thousandth of |d| |v|, are certain to ten digits.

/// The part of the squared distance that exceeds all errors.
const MARGIN: f64 = 1e-6;

/// Numbers up to this have squares, and these products, without overflow.
const MOST: f64 = f64::from_bits((1023 + 120) << 52);

/// Squares from this on have products without underflow.
const LEAST: f64 = f64::from_bits((1023 - 500) << 52);

/// The least squared distance of points that is known well enough, if their
/// coordinates add up to `far` at most: a difference of such numbers, or of what
/// is computed from them in a few steps, errs by some units in the last place of
/// the largest one. Infinity if that is too far.
pub(crate) fn least_clear(far: f64) -> f64 {
    let least = far * 1e-8;
    if far < MOST {
        (least * least).max(LEAST)
    } else {
        f64::INFINITY
    }
}

/// How a point that moves passes a circle about the origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Passage {
    /// d·d.
    distance: f64,
    /// v·v.
    speed: f64,
    /// d·v.
    approach: f64,
    /// R².
    reach: f64,
}

impl Passage {
    /// From the position, the velocity and the radius of the circle, none of which
    /// is beyond what [`least_clear`] takes for too far.
    #[inline(always)]
    pub(crate) fn new([x, y]: [f64; 2], [vx, vy]: [f64; 2], reach: f64) -> Self {
        Self {
            distance: x * x + y * y,
            speed: vx * vx + vy * vy,
            approach: x * vx + y * vy,
            reach: reach * reach,
        }
    }

    /// How much of the squared distance is left, less the margin.
    #[inline(always)]
    fn room(&self) -> f64 {
        self.distance * (1.0 - MARGIN) - self.reach
    }

    /// Whether the point surely stays outside for ever, its squared distance being at
    /// least `least`: it recedes, or passes aside. Either is as good as random, so there
    /// are no branches on that, and but one comparison.
    #[inline(always)]
    pub(crate) fn is_clear(&self, least: f64) -> bool {
        let room = self.room();
        let recedes = lesser(room, self.approach);
        let aside = room * self.speed - self.approach * self.approach;
        let aside = lesser(aside, self.speed - LEAST);
        lesser(self.distance - least, greater(recedes, aside)) >= 0.0
    }

    /// Whether the point surely stays outside for a time.
    #[inline(always)]
    pub(crate) fn is_clear_for(&self, least: f64, time: f64) -> bool {
        let (room, way) = (self.room(), self.speed * time);
        let is_early = way < -self.approach;
        let nearest = room + time * (2.0 * self.approach + way);
        let is_outside = (room > 0.0) & (self.distance > least);
        is_outside & is_early & (nearest > 0.0) | self.is_clear(least)
    }

    /// After which time the point gets to the circle, or infinity: a guess, as
    /// good as it rounds.
    #[inline(always)]
    pub(crate) fn likely_delay(&self) -> f64 {
        let gap = self.distance - self.reach;
        let discriminant = self.approach * self.approach - self.speed * gap;
        if discriminant >= 0.0 && self.approach < 0.0 {
            gap / (discriminant.sqrt() - self.approach)
        } else {
            f64::INFINITY
        }
    }
}

/// The lesser of two numbers: one instruction, which `f64::min` is not.
#[inline(always)]
fn lesser(one: f64, other: f64) -> f64 {
    if one < other { one } else { other }
}

/// The greater of two numbers.
#[inline(always)]
fn greater(one: f64, other: f64) -> f64 {
    if one > other { one } else { other }
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

    proptest! {
        /// What is clear up to a time is not met before by the formulas, also
        /// where the path all but touches the circle, or the time is that of the
        /// impact.
        #[test]
        fn what_is_clear_is_not_met(
            ([x, y], reach) in offset(),
            aside in prop_oneof![-2.0..2.0_f64, (-40.0..-1.0_f64).prop_map(|e| 1.0 + e.exp2())],
            speed in 1e-3..1e3_f64,
            part in prop_oneof![0.0..3.0_f64, (-40.0..-1.0_f64).prop_map(|e| 1.0 - e.exp2())],
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
            let delay = met.map(|met| met.delay);
            let time = part * delay.unwrap_or(squared.sqrt() / speed);
            let (passage, least) = (Passage::new([x, y], velocity, reach), least_clear(x.abs() + y.abs()));
            prop_assert!(!passage.is_clear_for(least, time) || delay.is_none_or(|delay| delay > time));
            prop_assert!(!passage.is_clear(least) || delay.is_none());
        }

        /// With a little to spare, the other way round.
        #[test]
        fn what_is_not_met_is_clear(angle in 0.0..7.0_f64, part in 0.0..0.99_f64, reach in 0.1..10.0_f64) {
            let [x, y] = [angle.cos(), angle.sin()].map(|part| 20.0 * part);
            let velocity = [-x / 20.0, -y / 20.0];
            let time = part * (20.0 - reach);
            let passage = Passage::new([x, y], velocity, reach);
            prop_assert!(passage.is_clear_for(LEAST, time));
            approx::assert_relative_eq!(passage.likely_delay(), 20.0 - reach, max_relative = 1e-12);
        }
    }

    /// What passes aside, or recedes, does not come back.
    #[test]
    fn what_passes_is_clear_for_ever() {
        for velocity in [[-1.0, 0.8], [1.0, 0.0], [0.0, 0.0]] {
            let passage = Passage::new([4.0, 0.0], velocity, 2.0);
            assert!(passage.is_clear(LEAST) && passage.likely_delay() == f64::INFINITY);
        }
        // Tangent at 1/2 of the distance: sin 30°.
        let tangent = [-(0.75_f64.sqrt()), 0.5];
        assert!(!Passage::new([4.0, 0.0], tangent, 2.0).is_clear(LEAST));
    }

    /// What is close for such numbers, and squares that vanish, prove nothing.
    #[test]
    fn extremes_are_left_open() {
        let tiny = Passage::new([4e-200, 0.0], [1e-200, 0.0], 1e-200);
        assert!(!tiny.is_clear(LEAST) && !tiny.is_clear_for(LEAST, 1.0));
        let slow = Passage::new([4.0, 0.0], [-1e-170, 1e-160], 1.0);
        assert!(!slow.is_clear(LEAST) && slow.is_clear_for(LEAST, 1.0));
        let far = Passage::new([4.0, 0.0], [0.0, 1.0], 1.0);
        assert!(!far.is_clear_for(least_clear(1e9), 1.0));
        assert_eq!(least_clear(1e40), f64::INFINITY);
    }
}
