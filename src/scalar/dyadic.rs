//! Dyadic rationals: whole numbers times powers of two, computed with
//! exactly. Unlike fractions they need no greatest common divisors.

use std::borrow::Cow;
use std::cmp::Ordering;
use std::ops::Neg;

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use num_traits::One;

use super::rounding::{Leading, Rounding, ratio_to_f64};

/// `mantissa` × 2^`exponent`.
///
/// The same number has many forms; [`normalised`](Self::normalised) gives the
/// one with an odd mantissa.
#[derive(Clone, Debug)]
pub(crate) struct Dyadic {
    mantissa: BigInt,
    exponent: i64,
}

/// Below the exponent of every number that is not zero, and far enough from
/// the ends of the type for sums and differences.
const BELOW_ALL: i64 = i64::MIN / 4;

impl Dyadic {
    pub(crate) fn new(mantissa: BigInt, exponent: i64) -> Self {
        Self { mantissa, exponent }
    }

    pub(crate) fn zero() -> Self {
        Self::new(BigInt::ZERO, 0)
    }

    /// A finite binary64 number, exactly.
    pub(crate) fn from_f64(number: f64) -> Self {
        debug_assert!(number.is_finite());
        let fraction = number.to_bits() & ((1 << 52) - 1);
        let biased = (number.to_bits() >> 52 & 0x7ff) as i64;
        let magnitude = fraction | u64::from(biased > 0) << 52;
        let sign = if number < 0.0 {
            Sign::Minus
        } else {
            Sign::Plus
        };
        let mantissa = BigInt::from_biguint(sign, magnitude.into());
        Self::new(mantissa, biased.max(1) - 1075).normalised()
    }

    /// The same number with an odd mantissa, or zero times one.
    pub(crate) fn normalised(self) -> Self {
        match self.mantissa.trailing_zeros() {
            None => Self::zero(),
            Some(0) => self,
            Some(zeros) => Self::new(self.mantissa >> zeros, self.exponent + zeros as i64),
        }
    }

    pub(crate) fn mantissa(&self) -> &BigInt {
        &self.mantissa
    }

    pub(crate) fn exponent(&self) -> i64 {
        self.exponent
    }

    #[inline]
    pub(crate) fn is_zero(&self) -> bool {
        self.mantissa.sign() == Sign::NoSign
    }

    #[inline]
    pub(crate) fn sign(&self) -> Ordering {
        match self.mantissa.sign() {
            Sign::Minus => Ordering::Less,
            Sign::NoSign => Ordering::Equal,
            Sign::Plus => Ordering::Greater,
        }
    }

    /// The exponent of the smallest power of two above the magnitude; far
    /// below all others for zero.
    #[inline]
    pub(crate) fn top(&self) -> i64 {
        if self.is_zero() {
            BELOW_ALL
        } else {
            self.mantissa.bits() as i64 + self.exponent
        }
    }

    /// The leading bits of the magnitude.
    #[inline]
    pub(crate) fn leading(&self) -> Leading {
        Leading::of(self.mantissa.magnitude(), self.exponent)
    }

    /// The binary64 neighbour.
    pub(crate) fn to_f64(&self, rounding: Rounding) -> f64 {
        self.leading()
            .to_f64(self.mantissa.sign() == Sign::Minus, rounding)
    }

    pub(crate) fn to_rational(&self) -> BigRational {
        let Self { mantissa, exponent } = self.clone().normalised();
        if exponent >= 0 {
            BigRational::from_integer(mantissa << exponent)
        } else {
            // In lowest terms: the mantissa is odd.
            BigRational::new_raw(mantissa, BigInt::one() << -exponent)
        }
    }

    /// Removes the bits that weigh less than 2^`exponent`, which lowers the
    /// number by less than 2^`exponent`, and tells whether any was set.
    #[inline]
    pub(crate) fn floor_at(&mut self, exponent: i64) -> bool {
        let excess = exponent - self.exponent;
        if excess <= 0 {
            return false;
        }
        let zeros = self.mantissa.trailing_zeros();
        self.mantissa >>= excess;
        self.exponent = exponent;
        zeros.is_some_and(|zeros| (zeros as i64) < excess)
    }

    /// The mantissa that goes with another exponent, rounded down where that
    /// is higher.
    #[inline]
    fn mantissa_at(&self, exponent: i64) -> Cow<'_, BigInt> {
        match self.exponent - exponent {
            0 => Cow::Borrowed(&self.mantissa),
            up @ 1.. => Cow::Owned(&self.mantissa << up),
            down => Cow::Owned(&self.mantissa >> -down),
        }
    }

    /// Brings the number to an exponent at which it is exact, and hands out
    /// its mantissa and the other's one there.
    #[inline]
    fn align<'a>(&mut self, other: &'a Self, floor: i64) -> (&mut BigInt, Cow<'a, BigInt>) {
        let exponent = self.exponent.min(other.exponent).max(floor);
        match self.exponent - exponent {
            0 => {}
            up @ 1.. => self.mantissa <<= up,
            down => self.mantissa >>= -down,
        }
        self.exponent = exponent;
        (&mut self.mantissa, other.mantissa_at(exponent))
    }

    /// The sum, where bits of either number below 2^`floor` may be removed:
    /// this lowers each by less than 2^`floor`.
    #[inline]
    pub(crate) fn add_floored(mut self, other: &Self, floor: i64) -> Self {
        if other.is_zero() {
            return self;
        }
        if self.is_zero() {
            return other.clone();
        }
        let (mantissa, term) = self.align(other, floor);
        *mantissa += &*term;
        self
    }

    /// The sum, exactly.
    pub(crate) fn add(self, other: &Self) -> Self {
        self.add_floored(other, BELOW_ALL)
    }

    /// The product, exactly.
    #[inline]
    pub(crate) fn mul(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::zero();
        }
        Self::new(
            &self.mantissa * &other.mantissa,
            self.exponent + other.exponent,
        )
    }

    /// The difference, exactly.
    pub(crate) fn sub(self, other: &Self) -> Self {
        self.add(&-other.clone())
    }

    /// Half of the number.
    pub(crate) fn halved(self) -> Self {
        Self::new(self.mantissa, self.exponent - 1)
    }

    /// The binary64 neighbour of the quotient by a positive number.
    pub(crate) fn divided_by(&self, divisor: &Self, rounding: Rounding) -> f64 {
        let shift = self.exponent - divisor.exponent;
        let [up, down] = [shift.max(0), (-shift).max(0)];
        let quotient = BigRational::new_raw(&self.mantissa << up, &divisor.mantissa << down);
        ratio_to_f64(&quotient, rounding)
    }

    /// The order of two numbers.
    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        let by_sign = self.sign().cmp(&other.sign());
        by_sign.then_with(|| match self.sign() {
            Ordering::Less => other.compare_magnitude(self),
            Ordering::Equal => Ordering::Equal,
            Ordering::Greater => self.compare_magnitude(other),
        })
    }

    /// The order of the magnitudes of two numbers of the same sign.
    fn compare_magnitude(&self, other: &Self) -> Ordering {
        self.top().cmp(&other.top()).then_with(|| {
            let exponent = self.exponent.min(other.exponent);
            let (a, b) = (self.mantissa_at(exponent), other.mantissa_at(exponent));
            a.magnitude().cmp(b.magnitude())
        })
    }
}

impl Neg for Dyadic {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.mantissa, self.exponent)
    }
}

impl From<i32> for Dyadic {
    fn from(integer: i32) -> Self {
        Self::new(integer.into(), 0).normalised()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn dyadic() -> impl Strategy<Value = Dyadic> {
        (any::<i128>(), 0..128_u32, -200..200_i64)
            .prop_map(|(bits, shift, exponent)| Dyadic::new((bits >> shift).into(), exponent))
    }

    #[test]
    fn binary64_is_taken_over_exactly() {
        let smallest = Dyadic::from_f64(f64::from_bits(1));
        assert_eq!((smallest.mantissa, smallest.exponent), (1.into(), -1074));
        let largest = Dyadic::from_f64(f64::MIN);
        let mantissa = 1 - (BigInt::one() << 53);
        assert_eq!((largest.mantissa, largest.exponent), (mantissa, 971));
        assert_eq!(
            Dyadic::from_f64(-0.75).to_rational(),
            BigRational::new((-3).into(), 4.into())
        );
        assert!(Dyadic::from_f64(-0.0).is_zero());
    }

    #[test]
    fn flooring_goes_down_and_tells_losses() {
        let mut number = Dyadic::new((-5).into(), 0);
        assert!(number.floor_at(2));
        assert_eq!(number.to_rational(), BigRational::from_integer((-8).into()));
        assert!(!number.floor_at(3));
        assert_eq!(number.to_rational(), BigRational::from_integer((-8).into()));
        assert_eq!(number.top(), 4);
    }

    proptest! {
        #[test]
        fn arithmetic_is_that_of_rationals(a in dyadic(), b in dyadic()) {
            let (x, y) = (a.to_rational(), b.to_rational());
            prop_assert_eq!(a.compare(&b), x.cmp(&y));
            prop_assert_eq!(a.compare(&a.clone().normalised()), Ordering::Equal);
            prop_assert_eq!(a.mul(&b).to_rational(), &x * &y);
            prop_assert_eq!((-a.clone()).to_rational(), -&x);
            prop_assert_eq!(a.add(&b).to_rational(), x + y);
        }

        #[test]
        fn floored_sums_are_a_little_low(a in dyadic(), b in dyadic(), floor in -250..250_i64) {
            let exact = a.clone().add(&b).to_rational();
            let excess = exact - a.add_floored(&b, floor).to_rational();
            let limit = Dyadic::new(BigInt::one(), floor + 1).to_rational();
            prop_assert!(excess >= BigRational::default() && excess < limit);
        }

        #[test]
        fn every_finite_binary64_returns(bits in any::<u64>()) {
            let number = f64::from_bits(bits);
            prop_assume!(number.is_finite());
            for rounding in [Rounding::Down, Rounding::Nearest, Rounding::Up] {
                prop_assert_eq!(Dyadic::from_f64(number).to_f64(rounding), number);
            }
        }
    }
}
