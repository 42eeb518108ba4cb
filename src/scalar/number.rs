//! Numbers as they were written: what a scene gives, before any arithmetic
//! rounds it.

use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;

use super::Interval;
use super::parse::parse_rational;
use super::rounding::{Rounding, ratio_to_f64};

/// A number as it was written: a binary64 number, or an exact rational one.
///
/// Text is read exactly, in any of these forms, each with an optional sign:
///
/// | form | example |
/// |---|---|
/// | integer | `3` |
/// | fraction | `-1/3` |
/// | decimal | `0.1` (a tenth), `1e-30` |
/// | hexadecimal | `0x1.8p+1` (three) |
///
/// Numbers are equal if they were written as the same binary64 number or as
/// the same rational; the binary64 number 0.5 and the rational 1/2 differ.
///
/// # Examples
///
/// ```
/// use carom::scalar::Number;
///
/// let tenth: Number = "0.1".parse()?;
/// assert_eq!(tenth.to_string(), "1/10");
/// assert_eq!(tenth.to_f64(), 0.1);
/// assert_ne!(tenth.to_rational(), Number::try_from(0.1)?.to_rational());
/// # Ok::<(), carom::scalar::NumberError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Number(Repr);

#[derive(Clone, Debug, PartialEq)]
enum Repr {
    /// A finite number, not negative zero.
    Binary64(f64),
    /// In lowest terms; boxed, as it is rare and large.
    Rational(Box<BigRational>),
}

/// Why a number was refused.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NumberError {
    /// There is no text.
    #[error("expected a number, found an empty text")]
    Empty,
    /// The text is none of the forms.
    #[error(
        "expected an integer (3), a fraction (-1/3), a decimal (0.1, 1e-30) \
         or a hexadecimal number (0x1.8p+1)"
    )]
    Malformed,
    /// A fraction's denominator is zero.
    #[error("expected a denominator other than zero")]
    ZeroDenominator,
    /// The text is too long for any sensible number.
    #[error("expected at most {max} characters, found {0}", max = Number::MAX_LENGTH)]
    TooLong(usize),
    /// A NaN or an infinity.
    #[error("expected a finite number, found {0}")]
    NotFinite(String),
    /// The magnitude is absurdly large or small.
    #[error(
        "expected zero or a magnitude between 2^-{max} and 2^{max}",
        max = Number::RANGE
    )]
    OutOfRange,
}

impl Number {
    /// In a binary64 run a nonzero number must have a magnitude between
    /// 2^-200 and 2^200, so that no product of four of them overflows or
    /// vanishes.
    pub const BINARY64_RANGE: i32 = 200;

    /// A nonzero number must have a magnitude between 2^-4096 and 2^4096.
    pub const RANGE: i32 = 4096;

    /// The length of the longest text that is read, in bytes.
    pub const MAX_LENGTH: usize = 16_384;

    /// The binary64 number, if it was written as one.
    pub fn as_binary64(&self) -> Option<f64> {
        match &self.0 {
            Repr::Binary64(number) => Some(*number),
            Repr::Rational(_) => None,
        }
    }

    /// The number, exactly.
    pub fn to_rational(&self) -> BigRational {
        match &self.0 {
            // Always Some: the number is finite.
            Repr::Binary64(number) => BigRational::from_float(*number).unwrap_or_default(),
            Repr::Rational(ratio) => (**ratio).clone(),
        }
    }

    /// The nearest binary64 number, of two equally near ones the even one;
    /// beyond the largest, an infinity.
    pub fn to_f64(&self) -> f64 {
        match &self.0 {
            Repr::Binary64(number) => *number,
            Repr::Rational(ratio) => ratio_to_f64(ratio, Rounding::Nearest),
        }
    }

    /// The same number, written as a binary64 number if it is one.
    #[must_use]
    pub fn in_binary64(self) -> Self {
        let rounded = self.to_f64();
        match BigRational::from_float(rounded) {
            Some(exact) if exact == self.to_rational() => Self(Repr::Binary64(rounded)),
            _ => self,
        }
    }

    /// The nearest binary64 numbers below and above, which are equal if the
    /// number is itself one.
    pub(super) fn hull(&self) -> Interval {
        let (lo, hi) = match &self.0 {
            Repr::Binary64(number) => (*number, *number),
            Repr::Rational(ratio) => (
                ratio_to_f64(ratio, Rounding::Down),
                ratio_to_f64(ratio, Rounding::Up),
            ),
        };
        Interval::new(lo, hi)
    }

    /// The order of the number against zero.
    pub fn sign(&self) -> Ordering {
        let zero = Ordering::Equal;
        match &self.0 {
            Repr::Binary64(number) => number.partial_cmp(&0.0).unwrap_or(zero),
            Repr::Rational(ratio) => ratio.numer().cmp(&BigInt::ZERO),
        }
    }

    /// Whether the number is above zero.
    pub fn is_positive(&self) -> bool {
        self.sign() == Ordering::Greater
    }

    /// Whether the number is zero.
    pub fn is_zero(&self) -> bool {
        self.sign() == Ordering::Equal
    }

    /// Whether the number is zero or has a magnitude from 2^-`range` to
    /// 2^`range`, where the range is less than 1022.
    pub fn is_within(&self, range: i32) -> bool {
        let largest = f64::from(range).exp2();
        match &self.0 {
            Repr::Binary64(number) => {
                *number == 0.0 || (largest.recip()..=largest).contains(&number.abs())
            }
            Repr::Rational(ratio) => is_within(ratio, range),
        }
    }

    /// A fraction in lowest terms with a positive denominator.
    fn from_lowest_terms(ratio: BigRational) -> Result<Self, NumberError> {
        if is_within(&ratio, Self::RANGE) {
            Ok(Self(Repr::Rational(Box::new(ratio))))
        } else {
            Err(NumberError::OutOfRange)
        }
    }
}

/// Whether a number is zero or has a magnitude from 2^-`range` to 2^`range`.
fn is_within(ratio: &BigRational, range: i32) -> bool {
    let (numerator, denominator) = (ratio.numer().magnitude(), ratio.denom().magnitude());
    ratio.is_zero() || *numerator <= denominator << range && *denominator <= numerator << range
}

impl From<i64> for Number {
    fn from(integer: i64) -> Self {
        let ratio = BigRational::from_integer(integer.into());
        Self(Repr::Rational(Box::new(ratio)))
    }
}

impl From<i32> for Number {
    fn from(integer: i32) -> Self {
        Self::from(i64::from(integer))
    }
}

impl TryFrom<f64> for Number {
    type Error = NumberError;

    /// A finite number. There is one zero: negative zero becomes it.
    fn try_from(number: f64) -> Result<Self, NumberError> {
        if number.is_finite() {
            Ok(Self(Repr::Binary64(number + 0.0)))
        } else {
            Err(NumberError::NotFinite(number.to_string()))
        }
    }
}

impl TryFrom<BigRational> for Number {
    type Error = NumberError;

    /// A number within [`RANGE`](Self::RANGE).
    fn try_from(ratio: BigRational) -> Result<Self, NumberError> {
        // Made from raw parts, a ratio may be anything.
        let (numerator, denominator) = ratio.into_raw();
        if denominator.is_zero() {
            return Err(NumberError::ZeroDenominator);
        }
        Self::from_lowest_terms(BigRational::new(numerator, denominator))
    }
}

impl fmt::Display for Number {
    /// A rational as an integer or a fraction in lowest terms, which is read
    /// back as the same number; a binary64 number with as few digits as
    /// identify it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Repr::Binary64(number) => write!(f, "{number:?}"),
            Repr::Rational(ratio) => ratio.fmt(f),
        }
    }
}

impl FromStr for Number {
    type Err = NumberError;

    fn from_str(text: &str) -> Result<Self, NumberError> {
        match text.len() {
            0 => return Err(NumberError::Empty),
            1..=Self::MAX_LENGTH => {}
            length => return Err(NumberError::TooLong(length)),
        }
        Self::from_lowest_terms(parse_rational(text)?)
    }
}

#[cfg(test)]
mod tests {
    use num_traits::One;
    use proptest::prelude::*;

    use super::*;

    fn ratio(numerator: i64, denominator: i64) -> BigRational {
        BigRational::new(numerator.into(), denominator.into())
    }

    fn power(exponent: u32) -> BigRational {
        BigRational::from_integer(BigInt::one() << exponent)
    }

    #[test]
    fn is_small() {
        assert!(size_of::<Number>() <= 16);
    }

    #[test]
    fn zero_has_no_sign() {
        let zero = Number::try_from(-0.0).unwrap();
        assert!(zero.is_zero() && !zero.is_positive());
        assert!(zero.to_f64().is_sign_positive());
        assert_eq!(zero.to_rational(), ratio(0, 1));
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for number in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let refusal = Number::try_from(number).unwrap_err();
            assert_eq!(refusal, NumberError::NotFinite(number.to_string()));
        }
        let raw = BigRational::new_raw(1.into(), 0.into());
        assert_eq!(Number::try_from(raw), Err(NumberError::ZeroDenominator));
    }

    #[test]
    fn the_range_includes_its_ends() {
        let largest = power(4096);
        let above = &largest + ratio(1, 1);
        for number in [largest.clone(), largest.recip(), -largest] {
            assert!(Number::try_from(number).is_ok());
        }
        for number in [above.clone(), above.recip(), -above] {
            assert_eq!(Number::try_from(number), Err(NumberError::OutOfRange));
        }
    }

    #[test]
    fn the_binary64_range_includes_its_ends() {
        let largest = 200_f64.exp2();
        for number in [largest, -largest, largest.recip(), 0.0, 1.0] {
            let number = Number::try_from(number).unwrap();
            assert!(number.is_within(200));
            assert!(
                Number::try_from(number.to_rational())
                    .unwrap()
                    .is_within(200)
            );
        }
        for number in [largest.next_up(), -largest.recip().next_down()] {
            let number = Number::try_from(number).unwrap();
            assert!(!number.is_within(200));
            assert!(
                !Number::try_from(number.to_rational())
                    .unwrap()
                    .is_within(200)
            );
        }
        // It rounds to 2^200, but is above.
        let above = Number::try_from(power(200) + ratio(1, 3)).unwrap();
        assert!(!above.is_within(200));
    }

    #[test]
    fn raw_parts_are_brought_to_lowest_terms() {
        let raw = BigRational::new_raw(4.into(), (-6).into());
        let number = Number::try_from(raw).unwrap();
        assert_eq!(number, "-2/3".parse().unwrap());
        assert_eq!(number.to_string(), "-2/3");
        assert_eq!(number.sign(), Ordering::Less);
    }

    #[test]
    fn numbers_are_equal_as_written() {
        let written = |text: &str| text.parse::<Number>().unwrap();
        assert_eq!(written("0.5"), written("1/2"));
        assert_ne!(written("0.5"), Number::try_from(0.5).unwrap());
        assert_eq!(Number::from(3), Number::from(3_i64));
        assert_eq!(Number::from(3), written("3"));
    }

    #[test]
    fn what_is_a_binary64_can_be_written_as_one() {
        let written = |text: &str| text.parse::<Number>().unwrap().in_binary64();
        assert_eq!(written("-3/4").as_binary64(), Some(-0.75));
        assert_eq!(written("0").as_binary64(), Some(0.0));
        for text in ["1/3", "0x1.00000000000008p0", "1e400"] {
            assert_eq!(written(text), text.parse().unwrap());
        }
    }

    #[test]
    fn hulls_are_points_or_neighbours() {
        let hull = |text: &str| text.parse::<Number>().unwrap().hull();
        assert_eq!(hull("0.75"), Interval::new(0.75, 0.75));
        // The binary64 number 0.1 lies above a tenth.
        assert_eq!(hull("0.1"), Interval::new(0.1_f64.next_down(), 0.1));
        assert_eq!(hull("-0.1"), Interval::new(-0.1, -0.1_f64.next_down()));
        assert_eq!(hull("1e400"), Interval::new(f64::MAX, f64::INFINITY));
        assert_eq!(
            Number::try_from(0.1).unwrap().hull(),
            Interval::new(0.1, 0.1)
        );
    }

    proptest! {
        #[test]
        fn rationals_are_displayed_as_they_are_read(numerator: i64, denominator in 1..i64::MAX) {
            let number = Number::try_from(ratio(numerator, denominator)).unwrap();
            prop_assert_eq!(number.to_string().parse(), Ok(number));
        }

        #[test]
        fn binary64_is_displayed_as_it_is_read(bits: u64) {
            let number = f64::from_bits(bits);
            prop_assume!(number.is_finite());
            let displayed = Number::try_from(number).unwrap().to_string();
            prop_assert_eq!(displayed.parse::<f64>(), Ok(number));
        }
    }
}
