//! How an exact number is held, and how the three ways mix.

use std::borrow::Cow;
use std::cmp::Ordering;
use std::ops::Neg;

use num_bigint::BigInt;
use num_rational::BigRational;

use super::ball::{Ball, BallRef};
use super::dyadic::Dyadic;
use super::isqrt::exact_sqrt;
use super::rounding::{Rounding, ratio_to_f64};
use super::{Exact, Interval};

/// The bits of an enclosure where no operand says how many.
const DEFAULT_BITS: u32 = 128;

/// The bits of an enclosure made by operands that carry so many.
pub(crate) fn precision(bits: u32) -> u32 {
    if bits == 0 { DEFAULT_BITS } else { bits }
}

/// A number in the cheapest form that loses nothing.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    /// Normalised.
    Dyadic(Dyadic),
    /// In lowest terms, and not dyadic.
    Ratio(Box<BigRational>),
    /// All else.
    Ball(Ball),
}

impl Value {
    /// A dyadic number, unless it has become too long.
    pub(crate) fn from_dyadic(number: Dyadic, bits: u32) -> Self {
        let number = number.normalised();
        let length = number.mantissa().bits() + number.exponent().unsigned_abs() + 1;
        if length > Exact::RATIONAL_BITS {
            return Self::Ball(Ball::from_dyadic(number, precision(bits)));
        }
        Self::Dyadic(number)
    }

    /// A fraction in lowest terms, unless it has become too long.
    pub(crate) fn from_ratio(ratio: BigRational, bits: u32) -> Self {
        let shift = ratio.denom().trailing_zeros().unwrap_or(0);
        if ratio.denom().bits() == shift + 1 {
            let (numerator, _) = ratio.into_raw();
            return Self::from_dyadic(Dyadic::new(numerator, -(shift as i64)), bits);
        }
        if ratio.numer().bits() + ratio.denom().bits() > Exact::RATIONAL_BITS {
            return Self::Ball(Ball::from_ratio(&ratio, precision(bits)));
        }
        Self::Ratio(Box::new(ratio))
    }

    fn is_zero(&self) -> bool {
        matches!(self, Self::Dyadic(number) if number.is_zero())
    }

    fn is_certainly_nonzero(&self) -> bool {
        self.sign().is_some_and(Ordering::is_ne)
    }

    /// The sign, where it is certain.
    pub(crate) fn sign(&self) -> Option<Ordering> {
        match self {
            Self::Dyadic(number) => Some(number.sign()),
            Self::Ratio(ratio) => Some(ratio.numer().cmp(&BigInt::ZERO)),
            Self::Ball(ball) => ball.view().sign(),
        }
    }

    /// The number as a fraction, if it is held as a rational.
    fn ratio(&self) -> Option<Cow<'_, BigRational>> {
        match self {
            Self::Dyadic(number) => Some(Cow::Owned(number.to_rational())),
            Self::Ratio(ratio) => Some(Cow::Borrowed(ratio)),
            Self::Ball(_) => None,
        }
    }

    /// Looks at the number as a ball.
    #[inline]
    fn with_ball<T>(&self, bits: u32, look: impl FnOnce(BallRef<'_>) -> T) -> T {
        match self {
            Self::Dyadic(number) => look(BallRef::exact(number)),
            Self::Ratio(ratio) => look(Ball::from_ratio(ratio, precision(bits)).view()),
            Self::Ball(ball) => look(ball.view()),
        }
    }

    /// Computes with two numbers as balls.
    #[inline]
    fn with_balls<T>(
        &self,
        other: &Self,
        bits: u32,
        look: impl FnOnce(BallRef<'_>, BallRef<'_>) -> T,
    ) -> T {
        self.with_ball(bits, |a| other.with_ball(bits, |b| look(a, b)))
    }

    /// The number as a ball.
    pub(crate) fn to_ball(&self, bits: u32) -> Ball {
        self.with_ball(bits, |ball| ball.to_ball())
    }

    /// Whether the number is known without error.
    pub(crate) fn is_exact(&self) -> bool {
        match self {
            Self::Dyadic(_) | Self::Ratio(_) => true,
            Self::Ball(ball) => ball.view().is_exact(),
        }
    }

    /// The nearest binary64 number, for a ball to its middle.
    pub(crate) fn to_f64(&self) -> f64 {
        match self {
            Self::Dyadic(number) => number.to_f64(Rounding::Nearest),
            Self::Ratio(ratio) => ratio_to_f64(ratio, Rounding::Nearest),
            Self::Ball(ball) => ball.view().to_f64(),
        }
    }

    /// Binary64 bounds.
    pub(crate) fn hull(&self) -> Interval {
        match self {
            Self::Dyadic(number) => BallRef::exact(number).hull(),
            Self::Ratio(ratio) => Interval::new(
                ratio_to_f64(ratio, Rounding::Down),
                ratio_to_f64(ratio, Rounding::Up),
            ),
            Self::Ball(ball) => ball.view().hull(),
        }
    }

    /// Rational bounds, unless nothing is known.
    pub(crate) fn ends(&self) -> Option<(BigRational, BigRational)> {
        match self {
            Self::Ball(ball) => ball.view().ends(),
            rational => rational.ratio().map(|ratio| {
                let ratio = ratio.into_owned();
                (ratio.clone(), ratio)
            }),
        }
    }

    /// The order of two numbers, where it is certain.
    pub(crate) fn compare(&self, other: &Self, bits: u32) -> Option<Ordering> {
        if let (Self::Dyadic(a), Self::Dyadic(b)) = (self, other) {
            return Some(a.compare(b));
        }
        let (a, b) = (self.hull(), other.hull());
        if a.hi() < b.lo() {
            Some(Ordering::Less)
        } else if a.lo() > b.hi() {
            Some(Ordering::Greater)
        } else {
            self.compare_closely(other, bits)
        }
    }

    /// The order of numbers whose binary64 bounds overlap.
    fn compare_closely(&self, other: &Self, bits: u32) -> Option<Ordering> {
        match ratios(self, other) {
            Some((a, b)) => Some(compare_ratios(&a, &b)),
            None => self.with_balls(other, bits, |a, b| a.sub(b, precision(bits)).view().sign()),
        }
    }

    /// The sum; adding zero changes nothing.
    pub(crate) fn add(self, other: &Self, bits: u32) -> Self {
        match (self, other) {
            (zero, value) if zero.is_zero() => value.clone(),
            (value, zero) if zero.is_zero() => value,
            (Self::Dyadic(a), Self::Dyadic(b)) => Self::from_dyadic(a.add(b), bits),
            (Self::Ball(a), b) => Self::Ball(b.with_ball(bits, |b| a.add(b, precision(bits)))),
            (a, b) => match ratios(&a, b) {
                Some((a, b)) => Self::from_ratio(&*a + &*b, bits),
                None => Self::Ball(a.with_balls(b, bits, |a, b| a.add(b, precision(bits)))),
            },
        }
    }

    /// The product; zero times anything is zero.
    pub(crate) fn mul(&self, other: &Self, bits: u32) -> Self {
        match (self, other) {
            (a, b) if a.is_zero() || b.is_zero() => Self::Dyadic(Dyadic::zero()),
            (Self::Dyadic(a), Self::Dyadic(b)) => Self::from_dyadic(a.mul(b), bits),
            (a, b) => match ratios(a, b) {
                Some((a, b)) => Self::from_ratio(&*a * &*b, bits),
                None => Self::Ball(a.with_balls(b, bits, |a, b| a.mul(b, precision(bits)))),
            },
        }
    }

    /// The quotient; by what may be zero, any number.
    pub(crate) fn div(&self, other: &Self, bits: u32) -> Self {
        match (self, other) {
            (_, b) if !b.is_certainly_nonzero() => Self::Ball(Ball::unknown()),
            (a, _) if a.is_zero() => Self::Dyadic(Dyadic::zero()),
            (a, b) => match ratios(a, b) {
                Some((a, b)) => Self::from_ratio(&*a / &*b, bits),
                None => Self::Ball(a.with_balls(b, bits, |a, b| a.div(b, precision(bits)))),
            },
        }
    }

    /// The square, not below zero.
    pub(crate) fn square(&self, bits: u32) -> Self {
        match self {
            Self::Dyadic(a) => Self::from_dyadic(a.mul(a), bits),
            Self::Ratio(ratio) => Self::from_ratio(ratio_square(ratio), bits),
            Self::Ball(ball) => Self::Ball(ball.view().square(precision(bits))),
        }
    }

    /// The square root; what a ball has below zero is cut off.
    pub(crate) fn sqrt(&self, bits: u32) -> Self {
        let enclosed = |a: BallRef<'_>| Self::Ball(a.sqrt(precision(bits)));
        self.rational_sqrt(bits)
            .unwrap_or_else(|| self.with_ball(bits, enclosed))
    }

    /// The root of the square of a rational.
    fn rational_sqrt(&self, bits: u32) -> Option<Self> {
        match self {
            Self::Dyadic(number) if number.exponent() % 2 == 0 => {
                let root = sqrt_of_square(number.mantissa())?;
                Some(Self::from_dyadic(
                    Dyadic::new(root, number.exponent() / 2),
                    bits,
                ))
            }
            Self::Ratio(ratio) => {
                let numerator = sqrt_of_square(ratio.numer())?;
                let denominator = sqrt_of_square(ratio.denom())?;
                // Roots of coprime squares are coprime.
                Some(Self::from_ratio(
                    BigRational::new_raw(numerator, denominator),
                    bits,
                ))
            }
            _ => None,
        }
    }
}

impl Neg for Value {
    type Output = Self;

    fn neg(self) -> Self {
        match self {
            Self::Dyadic(number) => Self::Dyadic(-number),
            Self::Ratio(ratio) => Self::Ratio(Box::new(-*ratio)),
            Self::Ball(ball) => Self::Ball(-ball),
        }
    }
}

/// Two numbers as fractions, if both are held as rationals.
fn ratios<'a>(a: &'a Value, b: &'a Value) -> Option<(Cow<'a, BigRational>, Cow<'a, BigRational>)> {
    match (a, b) {
        (Value::Ball(_), _) | (_, Value::Ball(_)) => None,
        (a, b) => Some((a.ratio()?, b.ratio()?)),
    }
}

/// By cross-multiplication, which takes two products; the order that the
/// ratios come with takes a division for each term of a continued fraction.
fn compare_ratios(a: &BigRational, b: &BigRational) -> Ordering {
    (a.numer() * b.denom()).cmp(&(b.numer() * a.denom()))
}

/// In lowest terms, since the number squared is.
fn ratio_square(ratio: &BigRational) -> BigRational {
    BigRational::new_raw(ratio.numer() * ratio.numer(), ratio.denom() * ratio.denom())
}

fn sqrt_of_square(integer: &BigInt) -> Option<BigInt> {
    // None for a negative number.
    Some(exact_sqrt(&integer.to_biguint()?)?.into())
}
