//! Exact numbers: rationals as long as they last, proven enclosures beyond.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::Arc;

use num_rational::BigRational;

use super::ball::Ball;
use super::dyadic::Dyadic;
use super::form::{self, Enclosed, Form};
use super::radius::Radius;
use super::step::Step;
use super::value::{Value, precision};
use super::{Interval, Number, Scalar, Undecided};

/// A number that is known exactly, or enclosed and proven to lie within.
///
/// Results are rational, without any rounding, as long as their operands are
/// and [`RATIONAL_BITS`](Self::RATIONAL_BITS) are enough; then, and at every
/// root of what is not the square of a rational, they become midpoint-radius
/// enclosures. Zero is the exception to the rule that an enclosure stays one:
/// zero times anything is zero, and adding zero changes nothing.
///
/// A number carries the bits of the enclosures that come from it: those it
/// was made with, or for a result, the most that any operand carries.
///
/// The quotient by zero, or by an enclosure that contains zero, is an
/// enclosure of all numbers: it decides nothing. Whoever divides decides the
/// sign of the divisor first.
///
/// # Examples
///
/// ```
/// use std::cmp::Ordering;
/// use carom::scalar::{Exact, Number, Scalar};
///
/// let two = Exact::from_number(&Number::from(2), 128);
/// let root = two.sqrt();
/// assert!(!root.is_rational());
/// let close = Exact::from_number(&"1.4142135623730950488".parse()?, 128);
/// assert_eq!(root.compare(&close), Ok(Ordering::Greater));
/// assert!(root.square().compare(&two).is_err(), "enclosures cannot tell equality");
/// # Ok::<(), carom::scalar::NumberError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Exact {
    value: Value,
    /// The bits of enclosures, or zero: those of what it meets.
    pub(super) bits: u32,
    /// How the error hangs together with that of others, as far as known.
    pub(super) form: Option<Arc<Form>>,
}

impl Exact {
    /// The bits of the numerator and the denominator of a rational, together,
    /// up to which it is computed with as such. A longer one becomes an
    /// enclosure.
    pub const RATIONAL_BITS: u64 = 4096;

    /// From so many bits on a [`Step`] is taken as a whole, which loses far
    /// fewer bits. It costs about twice as much at so few of them, so runs of
    /// about a thousand impacts of ten discs are done sooner without.
    pub const STEP_BITS: u32 = 1536;

    /// A fraction in lowest terms of any size; one longer than
    /// [`RATIONAL_BITS`](Self::RATIONAL_BITS) is enclosed.
    pub(crate) fn from_rational(ratio: BigRational, bits: u32) -> Self {
        Self::plain(Value::from_ratio(ratio, bits), bits)
    }

    /// A number of which nothing is known.
    pub(crate) fn unknown(bits: u32) -> Self {
        Self::plain(Value::Ball(Ball::unknown()), bits)
    }

    /// The numbers from one to another.
    pub(crate) fn spanning([low, high]: [Dyadic; 2], bits: u32) -> Self {
        let error = Radius::above(&high.clone().sub(&low).halved());
        let ball = Ball::around(low.add(&high).halved(), error);
        Self::plain(Value::Ball(ball.shortened(precision(bits))), bits)
    }

    /// Whether the number is known exactly, as a rational.
    pub fn is_rational(&self) -> bool {
        self.value.is_exact()
    }

    /// The bits of the enclosures that come from this number.
    pub(crate) fn precision(&self) -> u32 {
        precision(self.bits)
    }

    /// How many leading bits of the number are certain: some n such that the
    /// error is at most 2^-n times the number; none if there is no error.
    pub fn accuracy(&self) -> Option<i64> {
        match &self.value {
            Value::Dyadic(_) | Value::Ratio(_) => None,
            Value::Ball(ball) => ball.view().accuracy(),
        }
    }

    /// An enclosure of the number of about so many bits, or the number itself
    /// where that is known exactly. What is computed from it has no more bits.
    #[must_use]
    pub fn shortened(self, bits: u32) -> Self {
        let value = match self.value {
            Value::Ball(ball) => Value::Ball(ball.shortened(bits)),
            exact => exact,
        };
        Self::plain(value, self.bits.min(bits))
    }

    /// A number of which no more is known than its value.
    fn plain(value: Value, bits: u32) -> Self {
        let form = None;
        Self { value, bits, form }
    }

    /// A dyadic number; one longer than [`RATIONAL_BITS`](Self::RATIONAL_BITS) is
    /// enclosed.
    pub(crate) fn from_dyadic(number: Dyadic, bits: u32) -> Self {
        Self::plain(Value::from_dyadic(number, bits), bits)
    }

    /// The numbers at most so far from a midpoint.
    pub(crate) fn around(middle: Dyadic, error: Radius, bits: u32) -> Self {
        Self::plain(Value::Ball(Ball::around(middle, error)), bits)
    }

    /// The number about a midpoint that a form tells of.
    pub(super) fn with_form(middle: Dyadic, form: Form, bits: u32) -> Self {
        let (ball, form) = form.around(middle);
        Self {
            value: Value::Ball(ball),
            bits,
            form: Some(Arc::new(form)),
        }
    }

    /// Another number, which is known exactly: the midpoint.
    pub(super) fn middle(&self) -> Self {
        let middle = self.to_ball().into_middle();
        Self::plain(Value::Ball(Ball::around(middle, Radius::ZERO)), self.bits)
    }

    /// What a basis is made of, unless the number is not one with a form.
    fn enclosed(&mut self) -> Option<Enclosed<'_>> {
        match (&self.value, &mut self.form) {
            (Value::Ball(ball), Some(form)) => Some(Enclosed { ball, form }),
            _ => None,
        }
    }

    /// Bounds, unless nothing is known.
    pub(crate) fn ends(&self) -> Option<[Dyadic; 2]> {
        let ball = self.to_ball();
        let error = ball.view().radius();
        if error.is_unknown() {
            return None;
        }
        let (middle, error) = (ball.into_middle(), error.to_dyadic());
        Some([middle.clone().sub(&error), middle.add(&error)])
    }

    pub(super) fn to_ball(&self) -> Ball {
        self.value.to_ball(self.bits)
    }

    /// The same number; what comes from it is computed with so many bits.
    pub(crate) fn with_bits(self, bits: u32) -> Self {
        Self { bits, ..self }
    }

    /// The form of the error.
    pub(super) fn error(&self) -> Arc<Form> {
        let unknown = || Arc::new(Form::unknown(self.to_ball().view().radius()));
        self.form.clone().unwrap_or_else(unknown)
    }

    /// The bits that a result of two operands carries.
    fn common_bits(&self, other: &Self) -> u32 {
        self.bits.max(other.bits)
    }

    /// Applies an operation to two values.
    fn combine(&self, other: &Self, operation: impl FnOnce(&Value, &Value, u32) -> Value) -> Self {
        let bits = self.common_bits(other);
        Self::plain(operation(&self.value, &other.value, bits), bits)
    }
}

impl Scalar for Exact {
    type Doubt = Undecided;
    type Precision = u32;

    const ROUNDS: bool = false;
    const IS_DEAR: bool = true;

    /// The number itself, or where it is longer than
    /// [`RATIONAL_BITS`](Self::RATIONAL_BITS), an enclosure of so many bits.
    fn from_number(number: &Number, bits: u32) -> Self {
        let value = match number.as_binary64() {
            Some(binary) => Value::from_dyadic(Dyadic::from_f64(binary), bits),
            None => Value::from_ratio(number.to_rational(), bits),
        };
        Self::plain(value, bits)
    }

    fn from_integer(integer: i32) -> Self {
        Self::plain(Value::Dyadic(Dyadic::from(integer)), 0)
    }

    fn sign(&self) -> Result<Ordering, Undecided> {
        let undecided = || Undecided::sign(precision(self.bits));
        self.value.sign().ok_or_else(undecided)
    }

    /// Always decided for two numbers held as rationals.
    fn compare(&self, other: &Self) -> Result<Ordering, Undecided> {
        let bits = precision(self.common_bits(other));
        let order = self.value.compare(&other.value, bits);
        order.ok_or_else(|| Undecided::sign(bits))
    }

    fn square(&self) -> Self {
        Self::plain(self.value.square(self.bits), self.bits)
    }

    /// Rational for the square of a rational. What an enclosure has below
    /// zero is cut off.
    fn sqrt(&self) -> Self {
        Self::plain(self.value.sqrt(self.bits), self.bits)
    }

    /// By the plain formula: what cancels shows in the radius.
    fn difference_of_products(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        a.combine(b, Value::mul) - c.combine(d, Value::mul)
    }

    /// In mean-value form, from [`STEP_BITS`](Self::STEP_BITS) on.
    fn step<P: Step>(input: impl FnOnce() -> P::Input<Self>) -> Option<P::Output<Self>> {
        form::step::<P>(&input())
    }

    /// With a symbol for each number, when rests have grown.
    fn rebase<'a>(numbers: impl Iterator<Item = &'a mut Self>) {
        form::rebase(numbers.filter_map(Self::enclosed).collect());
    }

    fn bare(&self) -> Self {
        Self::plain(self.value.clone(), self.bits)
    }

    fn not_before(self, _: &Self) -> Self {
        self
    }

    fn to_f64(&self) -> f64 {
        self.value.to_f64()
    }

    /// For a rational the nearest bounds there are.
    fn hull(&self) -> Interval {
        self.value.hull()
    }

    /// None for a quotient by what may be zero.
    fn enclosure(&self) -> Option<(BigRational, BigRational)> {
        self.value.ends()
    }
}

impl Add<&Self> for Exact {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        let bits = self.common_bits(other);
        Self::plain(self.value.add(&other.value, bits), bits)
    }
}

impl Sub<&Self> for Exact {
    type Output = Self;

    /// Turning signs in place is cheaper than to copy the right operand.
    fn sub(self, other: &Self) -> Self {
        -(-self + other)
    }
}

impl Mul<&Self> for Exact {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        self.combine(other, Value::mul)
    }
}

impl Div<&Self> for Exact {
    type Output = Self;

    fn div(self, other: &Self) -> Self {
        self.combine(other, Value::div)
    }
}

impl Neg for Exact {
    type Output = Self;

    fn neg(self) -> Self {
        Self::plain(-self.value, self.bits)
    }
}

/// The operators with their right operand by value.
macro_rules! forward_by_value {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Exact {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                $operator::$method(self, &other)
            }
        }
    )*};
}

forward_by_value!(Add add, Sub sub, Mul mul, Div div);

#[cfg(test)]
mod tests;
