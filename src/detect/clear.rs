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

/// Squares between these limits have products without overflow or underflow.
const LEAST: f64 = f64::from_bits((1023 - 500) << 52);
const MOST: f64 = f64::from_bits((1023 + 500) << 52);

/// The least squared distance of points that is known well enough, if their
/// coordinates add up to `far` at most: a difference of such numbers, or of what
/// is computed from them in a few steps, errs by some units in the last place of
/// the largest one.
pub(crate) fn least_clear(far: f64) -> f64 {
    let least = far * 1e-8;
    (least * least).max(LEAST)
}

/// Whether a point that moves surely stays out of a circle about the origin for
/// a time, if its squared distance from there is at least `least`.
#[inline(always)]
pub(crate) fn stays_clear(
    [x, y]: [f64; 2],
    least: f64,
    [vx, vy]: [f64; 2],
    reach: f64,
    time: f64,
) -> bool {
    let distance = x * x + y * y;
    let speed = vx * vx + vy * vy;
    let approach = x * vx + y * vy;
    let room = distance * (1.0 - MARGIN) - reach * reach;
    let way = speed * time;
    let is_safe = (room > 0.0) & (distance > least) & (distance < MOST);
    let recedes = approach >= 0.0;
    let is_early = (way < -approach) & (room + time * (2.0 * approach + way) > 0.0);
    let is_moderate = (speed > LEAST) & (speed < MOST);
    let passes = is_moderate & (way >= -approach) & (room * speed > approach * approach);
    // As likely as not each: quicker without branches.
    is_safe & (recedes | is_early | passes)
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
            let is_clear = stays_clear([x, y], least_clear(x.abs() + y.abs()), velocity, reach, time);
            prop_assert!(!is_clear || delay.is_none_or(|delay| delay > time));
        }

        /// With a little to spare, the other way round.
        #[test]
        fn what_is_not_met_is_clear(angle in 0.0..7.0_f64, part in 0.0..0.99_f64, reach in 0.1..10.0_f64) {
            let [x, y] = [angle.cos(), angle.sin()].map(|part| 20.0 * part);
            let velocity = [-x / 20.0, -y / 20.0];
            let time = part * (20.0 - reach);
            prop_assert!(stays_clear([x, y], LEAST, velocity, reach, time));
        }
    }

    /// Squares that overflow or vanish prove nothing.
    #[test]
    fn extremes_are_left_open() {
        for scale in [1e-200, 1e200] {
            let offset = [4.0 * scale, 0.0];
            assert!(!stays_clear(offset, LEAST, [scale, 0.0], scale, 1.0));
        }
        assert!(!stays_clear([4.0, 0.0], LEAST, [-1e200, 1e200], 1.0, 1.0));
        assert!(!stays_clear(
            [4.0, 0.0],
            least_clear(1e9),
            [0.0, 1.0],
            1.0,
            1.0
        ));
    }
}
