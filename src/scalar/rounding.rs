//! Rounding to binary64: correctly, in a chosen direction, subnormals and
//! overflow included.

use num_bigint::{BigUint, Sign};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::Zero;

/// Which of the two neighbouring binary64 numbers to take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rounding {
    /// The lower one.
    Down,
    /// The nearer one, at equal distance the even one.
    Nearest,
    /// The upper one.
    Up,
}

/// A magnitude known by its leading 64 bits: `bits` × 2^`exponent`, or `more`
/// than that by less than one unit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Leading {
    /// The topmost bit is set, unless the magnitude is zero.
    pub(crate) bits: u64,
    /// The weight of the lowest of the bits.
    pub(crate) exponent: i64,
    /// Whether some lower bit is set.
    pub(crate) more: bool,
}

/// The weight of the lowest bit of every subnormal number.
const MIN_EXPONENT: i64 = -1074;

/// The weight of the lowest bit of the largest numbers.
const MAX_EXPONENT: i64 = 971;

/// The bits that a binary64 number has no room for, of 64.
const EXCESS: i64 = 11;

impl Leading {
    /// The leading bits of `magnitude` × 2^`exponent`.
    #[inline]
    pub(crate) fn of(magnitude: &BigUint, exponent: i64) -> Self {
        let mut digits = magnitude.iter_u64_digits().rev();
        let top = digits.next().unwrap_or(0);
        let next = digits.next().unwrap_or(0);
        let zeros = top.leading_zeros() % 64;
        let length = magnitude.bits();
        Self {
            bits: (top << zeros) | (next >> 1 >> (63 - zeros)),
            exponent: exponent + length as i64 - 64,
            more: length > 64 && magnitude.trailing_zeros().unwrap_or(0) < length - 64,
        }
    }

    /// The leading bits of `magnitude` × 2^`exponent`.
    #[inline]
    pub(crate) fn of_u128(magnitude: u128, exponent: i64) -> Self {
        let zeros = magnitude.leading_zeros() % 128;
        let aligned = magnitude << zeros;
        Self {
            bits: (aligned >> 64) as u64,
            exponent: exponent + 64 - i64::from(zeros),
            more: aligned as u64 != 0,
        }
    }

    /// The binary64 neighbour of this magnitude with a sign.
    #[inline]
    pub(crate) fn to_f64(self, negative: bool, rounding: Rounding) -> f64 {
        let rounding = if negative {
            rounding.mirrored()
        } else {
            rounding
        };
        let magnitude = self.magnitude_to_f64(rounding);
        if negative { -magnitude } else { magnitude }
    }

    fn magnitude_to_f64(self, rounding: Rounding) -> f64 {
        let dropped = EXCESS.max(MIN_EXPONENT - self.exponent);
        let exponent = self.exponent + dropped;
        if exponent > MAX_EXPONENT && self.bits != 0 {
            return beyond_largest(rounding);
        }
        // At most 53 bits, and a power of two that leaves them all in place:
        // both conversion and product are exact, or overflow as they should.
        self.drop_bits(dropped, rounding) as f64 * power_of_two(exponent)
    }

    /// What remains of the bits without their lowest ones, rounded.
    fn drop_bits(self, dropped: i64, rounding: Rounding) -> u64 {
        let (kept, half) = match dropped {
            0..64 => (self.bits >> dropped, 1 << (dropped - 1)),
            64 => (0, 1 << 63),
            // Far below half a unit.
            _ => return u64::from(rounding == Rounding::Up && (self.bits != 0 || self.more)),
        };
        let rest = self.bits & (half | (half - 1));
        let up = match rounding {
            Rounding::Down => false,
            Rounding::Up => rest != 0 || self.more,
            Rounding::Nearest => rest > half || rest == half && (self.more || kept % 2 == 1),
        };
        kept + u64::from(up)
    }
}

impl Rounding {
    /// The direction for a magnitude whose sign is negative.
    fn mirrored(self) -> Self {
        match self {
            Self::Down => Self::Up,
            Self::Nearest => Self::Nearest,
            Self::Up => Self::Down,
        }
    }
}

/// The neighbour of a magnitude above the largest number.
fn beyond_largest(rounding: Rounding) -> f64 {
    match rounding {
        Rounding::Down => f64::MAX,
        Rounding::Nearest | Rounding::Up => f64::INFINITY,
    }
}

/// 2^`exponent`, which must be a binary64 number.
#[inline]
pub(super) fn power_of_two(exponent: i64) -> f64 {
    match u64::try_from(exponent + 1022) {
        Ok(normal) => f64::from_bits((normal + 1) << 52),
        Err(_) => f64::from_bits(1 << (exponent - MIN_EXPONENT)),
    }
}

/// The binary64 nearest to a rational number, an infinity beyond the largest.
#[cfg(feature = "json")]
pub(crate) fn nearest_binary64(ratio: &BigRational) -> f64 {
    ratio_to_f64(ratio, Rounding::Nearest)
}

/// The binary64 neighbour of a rational number.
pub(crate) fn ratio_to_f64(ratio: &BigRational, rounding: Rounding) -> f64 {
    let (numerator, denominator) = (ratio.numer().magnitude(), ratio.denom().magnitude());
    // The quotient gets at least 65 bits, so that the remainder lies below
    // its leading 64.
    let shift = 66 + denominator.bits() as i64 - numerator.bits() as i64;
    let (quotient, remainder) = if shift >= 0 {
        (numerator << shift).div_rem(denominator)
    } else {
        numerator.div_rem(&(denominator << -shift))
    };
    let mut leading = Leading::of(&quotient, -shift);
    leading.more |= !remainder.is_zero();
    leading.to_f64(ratio.numer().sign() == Sign::Minus, rounding)
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;
    use num_traits::{One, Signed};
    use proptest::prelude::*;

    use super::*;

    fn nearest(ratio: &BigRational) -> f64 {
        ratio_to_f64(ratio, Rounding::Nearest)
    }

    /// A binary64 number that may also be subnormal or huge.
    fn finite() -> impl Strategy<Value = f64> {
        any::<u64>()
            .prop_map(f64::from_bits)
            .prop_filter("finite", |x| x.is_finite())
    }

    fn rational(number: f64) -> BigRational {
        BigRational::from_float(number).unwrap()
    }

    /// The exact decimal expansion of a dyadic number.
    fn decimal(dyadic: &BigRational) -> String {
        let twos = dyadic.denom().trailing_zeros().unwrap() as u32;
        format!("{}e-{twos}", dyadic.numer() * BigInt::from(5).pow(twos))
    }

    #[test]
    fn overflow_and_underflow() {
        let power = |exponent: usize| BigRational::from_integer(BigInt::one() << exponent);
        let limit = power(1024) - power(970);
        let below_limit = &limit - power(0);
        assert_eq!(nearest(&below_limit), f64::MAX);
        assert_eq!(nearest(&limit), f64::INFINITY);
        assert_eq!(nearest(&-limit.clone()), f64::NEG_INFINITY);
        assert_eq!(ratio_to_f64(&limit, Rounding::Down), f64::MAX);
        assert_eq!(ratio_to_f64(&power(5000), Rounding::Down), f64::MAX);
        assert_eq!(ratio_to_f64(&-power(5000), Rounding::Up), f64::MIN);
        assert_eq!(nearest(&power(5000)), f64::INFINITY);

        let least = f64::from_bits(1);
        let half = power(1075).recip();
        assert_eq!(nearest(&half), 0.0);
        assert_eq!(nearest(&(&half * (power(0) + power(60).recip()))), least);
        assert_eq!(nearest(&power(5000).recip()), 0.0);
        assert_eq!(ratio_to_f64(&power(5000).recip(), Rounding::Up), least);
        assert_eq!(ratio_to_f64(&-power(5000).recip(), Rounding::Down), -least);
        assert_eq!(nearest(&BigRational::zero()), 0.0);
    }

    proptest! {
        #[test]
        fn decimals_round_as_in_the_standard_library(
            digits in "[0-9]{1,40}",
            exponent in -380..330_i32,
        ) {
            let text = format!("{digits}e{exponent}");
            let number: crate::scalar::Number = text.parse().unwrap();
            prop_assert_eq!(number.to_f64(), text.parse::<f64>().unwrap());
        }

        #[test]
        fn subnormal_decimals_round_as_in_the_standard_library(
            digits in "[1-9][0-9]{0,20}",
            place in 305..330_i32,
        ) {
            let text = format!("-0.{digits}e-{place}");
            let number: crate::scalar::Number = text.parse().unwrap();
            prop_assert_eq!(number.to_f64(), text.parse::<f64>().unwrap());
        }

        #[test]
        fn halfway_cases_round_to_even(x in finite(), nudge in -1..=1_i32) {
            prop_assume!(x.abs() < f64::MAX);
            let middle = (rational(x) + rational(x.next_up())) / BigInt::from(2);
            let nudge = middle.abs() * BigRational::new(nudge.into(), BigInt::one() << 150);
            let number = middle + nudge;
            prop_assert_eq!(nearest(&number), decimal(&number).parse::<f64>().unwrap());
        }

        #[test]
        fn directions_enclose(x in finite(), thirds in 1..3_i32) {
            prop_assume!(x < f64::MAX);
            let (lo, hi) = (rational(x), rational(x.next_up()));
            let between = &lo + (&hi - &lo) * BigRational::new(thirds.into(), 3.into());
            prop_assert_eq!(ratio_to_f64(&between, Rounding::Down), x);
            prop_assert_eq!(ratio_to_f64(&between, Rounding::Up), x.next_up());
            prop_assert_eq!(ratio_to_f64(&lo, Rounding::Down), x);
            prop_assert_eq!(ratio_to_f64(&lo, Rounding::Up), x);
        }

        #[test]
        fn leading_bits_agree_whatever_their_origin(n in any::<u128>(), exponent in -1200..1000_i64) {
            let (short, long) = (Leading::of_u128(n, exponent), Leading::of(&n.into(), exponent));
            prop_assert_eq!((short.bits, short.more), (long.bits, long.more));
            for rounding in [Rounding::Down, Rounding::Nearest, Rounding::Up] {
                prop_assert_eq!(short.to_f64(true, rounding), long.to_f64(true, rounding));
            }
        }
    }
}
