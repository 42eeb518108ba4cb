//! Error bounds: numbers of 32 bits that are never rounded the wrong way.
//!
//! After the magnitude bounds of Arb (Johansson: Arb: efficient
//! arbitrary-precision midpoint-radius interval arithmetic, 2017).

use num_bigint::BigInt;

use super::dyadic::Dyadic;
use super::rounding::power_of_two;

/// A bound of something that is not negative: `mantissa` × 2^`exponent`,
/// with the topmost bit of the mantissa set unless the bound is zero.
///
/// An upper bound, and operations round up, except where a name ends in
/// `down`. A bound too large to be of use becomes [`Self::UNKNOWN`], one too
/// small is lifted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Radius {
    // First, for the derived order.
    exponent: i64,
    mantissa: u32,
}

/// Exponents of bounds, other than of the two special ones, reach from the
/// negative of this up to this.
///
/// It caps the memory that any enclosure can ask for.
pub(crate) const MAX_EXPONENT: i64 = 1 << 24;

/// So far from all other exponents that no operation leads back; yet sums of
/// a few do not overflow.
const SPECIAL_EXPONENT: i64 = 1 << 60;

/// The mantissa of a power of two.
const ONE: u32 = 1 << 31;

impl Radius {
    /// Nothing is in error.
    pub(crate) const ZERO: Self = Self {
        exponent: -SPECIAL_EXPONENT,
        mantissa: 0,
    };

    /// So large a bound that it says nothing. Every sum with it is like it,
    /// and every product but that with zero.
    pub(crate) const UNKNOWN: Self = Self {
        exponent: SPECIAL_EXPONENT,
        mantissa: ONE,
    };

    pub(crate) fn is_zero(self) -> bool {
        self.mantissa == 0
    }

    #[inline]
    pub(crate) fn is_unknown(self) -> bool {
        self.exponent > MAX_EXPONENT
    }

    /// The exponent of the smallest power of two above the bound; far below
    /// all others for zero.
    #[inline]
    pub(crate) fn top(self) -> i64 {
        self.exponent + 32
    }

    /// At least `bits` × 2^`exponent`.
    #[inline]
    pub(crate) fn up(bits: u64, exponent: i64) -> Self {
        if bits == 0 {
            return Self::ZERO;
        }
        let zeros = bits.leading_zeros();
        let aligned = bits << zeros;
        let exponent = exponent + 32 - i64::from(zeros);
        let (truncated, rest) = ((aligned >> 32) as u32, aligned as u32);
        match truncated.checked_add(u32::from(rest != 0)) {
            Some(mantissa) => Self::clamped_up(mantissa, exponent),
            None => Self::clamped_up(ONE, exponent + 1),
        }
    }

    #[inline]
    fn clamped_up(mantissa: u32, exponent: i64) -> Self {
        if exponent > MAX_EXPONENT {
            Self::UNKNOWN
        } else if exponent < -MAX_EXPONENT {
            Self {
                exponent: -MAX_EXPONENT,
                mantissa: ONE,
            }
        } else {
            Self { exponent, mantissa }
        }
    }

    /// At most `bits` × 2^`exponent`.
    #[inline]
    fn down(bits: u64, exponent: i64) -> Self {
        let zeros = bits.leading_zeros() % 64;
        let exponent = exponent + 32 - i64::from(zeros);
        if bits == 0 || exponent < -MAX_EXPONENT {
            return Self::ZERO;
        }
        let mantissa = if exponent > MAX_EXPONENT {
            ONE
        } else {
            (bits << zeros >> 32) as u32
        };
        Self {
            exponent: exponent.min(MAX_EXPONENT),
            mantissa,
        }
    }

    /// 2^`exponent`.
    #[inline]
    pub(crate) fn power_of_two(exponent: i64) -> Self {
        Self::clamped_up(ONE, exponent - 31)
    }

    /// At least the magnitude of a number.
    #[inline]
    pub(crate) fn above(number: &Dyadic) -> Self {
        let leading = number.leading();
        // The lowest of 64 bits stands for all that follow it.
        Self::up(leading.bits | u64::from(leading.more), leading.exponent)
    }

    /// At least the magnitude of a binary64 number.
    pub(crate) fn magnitude(number: f64) -> Self {
        if !number.is_finite() {
            return Self::UNKNOWN;
        }
        let fraction = number.to_bits() & ((1 << 52) - 1);
        let biased = (number.to_bits() >> 52 & 0x7ff) as i64;
        Self::up(fraction | u64::from(biased > 0) << 52, biased.max(1) - 1075)
    }

    /// The bound in units of 2 to its [`top`](Self::top), exactly.
    pub(crate) fn fraction(self) -> f64 {
        f64::from(self.mantissa) * power_of_two(-32)
    }

    /// At most the magnitude of a number.
    #[inline]
    pub(crate) fn below_down(number: &Dyadic) -> Self {
        let leading = number.leading();
        Self::down(leading.bits, leading.exponent)
    }

    /// The bound itself.
    pub(crate) fn to_dyadic(self) -> Dyadic {
        Dyadic::new(BigInt::from(self.mantissa), self.exponent)
    }

    /// At least the bound in units of 2^`exponent`, which must not be less
    /// than 2^-64 times the [`top`](Self::top).
    #[inline]
    pub(crate) fn in_units(self, exponent: i64) -> u64 {
        let wide = u64::from(self.mantissa) << 32;
        match exponent - (self.exponent - 32) {
            shift @ 0..64 => wide.div_ceil(1 << shift),
            _ => u64::from(wide != 0),
        }
    }

    /// The mantissa with 31 more bits, and at least the smaller bound's
    /// mantissa at the same exponent.
    #[inline]
    fn aligned(larger: Self, smaller: Self) -> (u64, u64) {
        let wide = u64::from(smaller.mantissa) << 31;
        let shifted = match larger.exponent - smaller.exponent {
            shift @ 0..63 => wide.div_ceil(1 << shift),
            _ => u64::from(wide != 0),
        };
        (u64::from(larger.mantissa) << 31, shifted)
    }

    #[inline]
    pub(crate) fn add(self, other: Self) -> Self {
        let (larger, smaller) = if self < other {
            (other, self)
        } else {
            (self, other)
        };
        let (a, b) = Self::aligned(larger, smaller);
        Self::up(a + b, larger.exponent - 31)
    }

    /// At most the difference of a lower bound and an upper one; zero where
    /// that is negative.
    #[inline]
    pub(crate) fn sub_down(self, other: Self) -> Self {
        if self <= other {
            return Self::ZERO;
        }
        let (a, b) = Self::aligned(self, other);
        Self::down(a - b, self.exponent - 31)
    }

    /// At most the sum of two lower bounds.
    pub(crate) fn add_down(self, other: Self) -> Self {
        let (larger, smaller) = if self < other {
            (other, self)
        } else {
            (self, other)
        };
        let (a, b) = Self::aligned(larger, smaller);
        // Aligning rounded the smaller one up, by less than one unit.
        Self::down(a + b.saturating_sub(1), larger.exponent - 31)
    }

    #[inline]
    pub(crate) fn mul(self, other: Self) -> Self {
        let product = u64::from(self.mantissa) * u64::from(other.mantissa);
        Self::up(product, self.exponent + other.exponent)
    }

    /// The quotient by a lower bound, unknown where that is zero.
    #[inline]
    pub(crate) fn div(self, lower: Self) -> Self {
        if lower.is_zero() {
            return Self::UNKNOWN;
        }
        let dividend = u64::from(self.mantissa) << 32;
        let quotient = dividend.div_ceil(u64::from(lower.mantissa));
        Self::up(quotient, self.exponent - 32 - lower.exponent)
    }

    /// 32 to 64 bits and half the exponent that goes with them.
    fn halved_exponent(self) -> (u64, i64) {
        let odd = self.exponent & 1;
        let bits = u64::from(self.mantissa) << (32 - odd);
        (bits, (self.exponent - 32 + odd) / 2)
    }

    pub(crate) fn sqrt(self) -> Self {
        let (bits, exponent) = self.halved_exponent();
        let root = bits.isqrt();
        Self::up(root + u64::from(root * root < bits), exponent)
    }

    /// At most the square root of a lower bound.
    pub(crate) fn sqrt_down(self) -> Self {
        let (bits, exponent) = self.halved_exponent();
        Self::down(bits.isqrt(), exponent)
    }

    /// Half the bound, or as small a bound as there is.
    pub(crate) fn half(self) -> Self {
        Self::up(u64::from(self.mantissa), self.exponent - 1)
    }
}

#[cfg(test)]
mod tests {
    use num_rational::BigRational;
    use num_traits::One;
    use proptest::prelude::*;

    use super::*;

    fn radius() -> impl Strategy<Value = Radius> {
        let bits = prop_oneof![any::<u64>(), any::<u32>().prop_map(u64::from), 0..4_u64];
        (bits, -100..100_i64).prop_map(|(bits, exponent)| Radius::up(bits, exponent))
    }

    fn value(radius: Radius) -> BigRational {
        if radius.is_zero() {
            BigRational::default()
        } else {
            radius.to_dyadic().to_rational()
        }
    }

    /// Whether a bound is at most 2^-28 too large.
    fn is_just_above(bound: Radius, truth: &BigRational) -> bool {
        let slack = BigRational::new(1.into(), (1 << 28).into());
        value(bound) >= *truth && value(bound) <= truth * (BigRational::one() + slack)
    }

    fn is_just_below(bound: Radius, truth: &BigRational) -> bool {
        let slack = BigRational::new(1.into(), (1 << 28).into());
        value(bound) <= *truth && value(bound) >= truth * (BigRational::one() - slack)
    }

    #[test]
    fn rounding_carries_into_a_new_bit() {
        assert_eq!(Radius::up(u64::MAX, 0), Radius::power_of_two(64));
        assert_eq!(Radius::up(1 << 63 | 1, 0).mantissa, ONE + 1);
        assert_eq!(Radius::down(u64::MAX, 0).mantissa, u32::MAX);
        assert_eq!(Radius::up(3, -1).in_units(0), 2);
    }

    #[test]
    fn extremes_keep_their_meaning() {
        let tiny = Radius::power_of_two(-MAX_EXPONENT);
        let huge = Radius::power_of_two(MAX_EXPONENT);
        assert!(huge.mul(huge).is_unknown());
        assert!(!tiny.mul(tiny).is_zero());
        assert!(Radius::down(1, -2 * MAX_EXPONENT).is_zero());
        assert!(!Radius::down(1, 2 * MAX_EXPONENT).is_unknown());
        for other in [Radius::ZERO, tiny, huge, Radius::UNKNOWN] {
            assert!(Radius::UNKNOWN.add(other).is_unknown());
            assert!(other.sub_down(Radius::UNKNOWN).is_zero());
            assert_eq!(Radius::UNKNOWN.mul(other).is_unknown(), !other.is_zero());
            assert!(other.div(Radius::ZERO).is_unknown());
            assert_eq!(other.add(Radius::ZERO), other);
        }
        assert!(Radius::UNKNOWN.div(tiny).is_unknown());
        assert!(Radius::UNKNOWN.sqrt().is_unknown());
        assert!(Radius::UNKNOWN.half().is_unknown());
        assert!(Radius::ZERO.sqrt().is_zero());
        assert!(Radius::ZERO.half().is_zero());
    }

    proptest! {
        #[test]
        fn operations_round_the_right_way(a in radius(), b in radius()) {
            let (x, y) = (value(a), value(b));
            prop_assert_eq!(a.cmp(&b), x.cmp(&y));
            prop_assert!(is_just_above(a.add(b), &(&x + &y)));
            prop_assert!(is_just_below(a.add_down(b), &(&x + &y)));
            prop_assert!(is_just_above(a.mul(b), &(&x * &y)));
            if !b.is_zero() {
                prop_assert!(is_just_above(a.div(b), &(&x / &y)));
            }
            prop_assert_eq!(value(a.half()) * BigRational::from_integer(2.into()), x);
        }

        #[test]
        fn differences_stay_below(a in radius(), b in radius()) {
            let difference = value(a) - value(b);
            let bound = value(a.sub_down(b));
            prop_assert!(bound <= difference.clone().max(BigRational::default()));
            // All but the last bits of the larger one count.
            prop_assert!(bound >= difference - value(a) / BigRational::from_integer((1 << 28).into()));
        }

        #[test]
        fn roots_enclose(a in radius()) {
            let (upper, lower) = (value(a.sqrt()), value(a.sqrt_down()));
            prop_assert!(is_just_above(a.sqrt().mul(a.sqrt()), &value(a)));
            prop_assert!(&upper * &upper >= value(a));
            prop_assert!(&lower * &lower <= value(a));
        }

        #[test]
        fn bounds_of_numbers(bits in any::<i128>(), shift in 0..128_u32, exponent in -200..200_i64) {
            let number = Dyadic::new((bits >> shift).into(), exponent);
            let positive = bits >= 0;
            let magnitude = if positive { number.to_rational() } else { -number.to_rational() };
            prop_assert!(is_just_above(Radius::above(&number), &magnitude));
            prop_assert!(is_just_below(Radius::below_down(&number), &magnitude));
        }
    }
}
