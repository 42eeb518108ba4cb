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

    /// A number between two bounds.
    pub(crate) fn enclosing([lo, hi]: [BigRational; 2], bits: u32) -> Self {
        if lo == hi {
            return Self::from_rational(lo, bits);
        }
        let half = (&hi - &lo) / BigRational::from_integer(2.into());
        let shift = 64 + half.denom().bits().saturating_sub(half.numer().bits());
        let radius = (half.numer() << shift) / half.denom() + 1;
        let radius = Radius::above(&Dyadic::new(radius, -(shift as i64)));
        let around = Ball::around(Dyadic::zero(), radius);
        let middle = Ball::from_ratio(&(lo + half), precision(bits));
        Self::plain(
            Value::Ball(middle.add(around.view(), precision(bits))),
            bits,
        )
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
mod tests {
    use std::cmp::Ordering::{Equal, Greater, Less};

    use num_bigint::BigInt;
    use num_traits::One;
    use proptest::prelude::*;

    use super::*;

    fn exact(text: &str) -> Exact {
        Exact::from_number(&text.parse().unwrap(), 100)
    }

    fn rational(numerator: i64, denominator: i64) -> BigRational {
        BigRational::new(numerator.into(), denominator.into())
    }

    /// The rational that a number is held as.
    fn held(number: &Exact) -> Option<BigRational> {
        let (lo, hi) = number.enclosure()?;
        (lo == hi && number.is_rational()).then_some(lo)
    }

    fn fraction() -> impl Strategy<Value = BigRational> {
        let denominator = prop_oneof![1..1000_i64, (0..40_u32).prop_map(|shift| 1 << shift)];
        (-10_000..10_000_i64, denominator).prop_map(|(n, d)| rational(n, d))
    }

    fn from_ratio(ratio: &BigRational) -> Exact {
        Exact::from_number(&Number::try_from(ratio.clone()).unwrap(), 100)
    }

    #[test]
    fn numbers_are_taken_over_exactly() {
        for text in ["0", "3", "-1/3", "0.1", "0x1p-1000", "1e300"] {
            let number: Number = text.parse().unwrap();
            assert_eq!(held(&exact(text)), Some(number.to_rational()));
        }
        let binary = Exact::from_number(&Number::try_from(0.1).unwrap(), 0);
        assert_eq!(held(&binary), BigRational::from_float(0.1));
        assert_eq!(binary.hull(), Interval::new(0.1, 0.1));
        assert_eq!(binary.accuracy(), None);
    }

    #[test]
    fn roots_of_squares_are_rational() {
        let table = [
            ("0", "0"),
            ("9", "3"),
            ("1/4", "1/2"),
            ("4/9", "2/3"),
            ("0.0001", "0.01"),
        ];
        for (square, root) in table {
            assert_eq!(held(&exact(square).sqrt()), held(&exact(root)));
        }
        for number in ["2", "1/2", "8", "4/3", "3/4", "17", "1/10"] {
            assert!(!exact(number).sqrt().is_rational(), "{number}");
        }
    }

    /// √2 to 40 digits, from tables.
    #[test]
    fn roots_of_others_are_enclosed() {
        let root = exact("2").sqrt();
        assert_eq!(
            root.compare(&exact("1.4142135623730950488016887242")),
            Ok(Greater)
        );
        assert_eq!(
            root.compare(&exact("1.4142135623730950488016887243")),
            Ok(Less)
        );
        assert_eq!(root.to_f64(), std::f64::consts::SQRT_2);
        assert!(root.accuracy().is_some_and(|bits| bits >= 98));
        assert!(root.square().compare(&exact("2")).is_err());
        let doubt = (root.square() - exact("2")).sign().unwrap_err();
        assert_eq!(doubt, Undecided::sign(100));
    }

    #[test]
    fn zero_is_exact() {
        let (zero, root) = (Exact::from_integer(0), exact("2").sqrt());
        let unknown = exact("1") / &zero;
        for number in [&root, &unknown, &exact("1/3")] {
            assert_eq!((zero.clone() * number).sign(), Ok(Equal));
            assert_eq!((number.clone() * &zero).sign(), Ok(Equal));
            let sum = number.clone() + &zero;
            assert_eq!(sum.enclosure(), number.enclosure());
            let difference = zero.clone() - number;
            assert_eq!(difference.enclosure(), (-number.clone()).enclosure());
        }
        assert_eq!((zero / root).sign(), Ok(Equal));
    }

    #[test]
    fn division_by_what_may_be_zero_tells_nothing() {
        let maybe_zero = exact("2").sqrt().square() - exact("2");
        for divisor in [Exact::from_integer(0), maybe_zero] {
            for dividend in [exact("0"), exact("1"), exact("1/3"), exact("3").sqrt()] {
                let quotient = dividend / &divisor;
                assert!(quotient.sign().is_err());
                assert_eq!(quotient.enclosure(), None);
                assert_eq!(quotient.hull(), Interval::UNBOUNDED);
                assert!(!quotient.is_rational());
            }
        }
    }

    #[test]
    fn long_rationals_become_enclosures() {
        for text in ["1/3", "5", "3/1024", "7/5"] {
            let mut power = exact(text);
            let mut truth = held(&power).unwrap();
            while power.is_rational() {
                power = power.clone() * &power;
                truth = &truth * &truth;
                let length = truth.numer().bits() + truth.denom().bits();
                assert_eq!(
                    power.is_rational(),
                    length <= Exact::RATIONAL_BITS,
                    "{text}"
                );
                let (lo, hi) = power.enclosure().unwrap();
                assert!(lo <= truth && truth <= hi);
            }
            assert!(power.accuracy().is_some_and(|bits| bits >= 95));
        }
    }

    #[test]
    fn the_higher_precision_is_carried_on() {
        let three = Exact::from_integer(3);
        let low = Exact::from_number(&Number::from(2), 64);
        let high = Exact::from_number(&Number::from(2), 1000);
        let accuracy = |number: Exact| number.sqrt().accuracy().unwrap();
        assert!((62..=66).contains(&accuracy(three.clone() * &low - &three)));
        assert!((998..=1002).contains(&accuracy(low + high + &three)));
        assert!(accuracy(three) >= 100);
    }

    #[test]
    fn close_numbers_are_told_apart() {
        let tiny = BigRational::new(BigInt::one(), BigInt::one() << 2000_u32);
        let third = rational(1, 3);
        let (a, b) = (from_ratio(&third), from_ratio(&(&third + tiny)));
        assert_eq!(a.compare(&b), Ok(Less));
        assert_eq!(b.compare(&a), Ok(Greater));
        assert_eq!(a.compare(&a), Ok(Equal));
    }

    proptest! {
        #[test]
        fn rationals_stay_exact(x in fraction(), y in fraction()) {
            let (a, b) = (from_ratio(&x), from_ratio(&y));
            prop_assert_eq!(held(&(a.clone() + &b)), Some(&x + &y));
            prop_assert_eq!(held(&(a.clone() - &b)), Some(&x - &y));
            prop_assert_eq!(held(&(a.clone() * &b)), Some(&x * &y));
            prop_assert_eq!(held(&a.square()), Some(&x * &x));
            prop_assert_eq!(held(&a.square().sqrt()), Some(if x < rational(0, 1) { -&x } else { x.clone() }));
            prop_assert_eq!(a.compare(&b), Ok(x.cmp(&y)));
            prop_assert_eq!(a.sign(), Ok(x.cmp(&rational(0, 1))));
            let power = Exact::difference_of_products(&a, &b, &b, &b);
            prop_assert_eq!(held(&power), Some(&x * &y - &y * &y));
            if y != rational(0, 1) {
                prop_assert_eq!(held(&(a / b)), Some(x / y));
            }
        }

        /// (√x ± y) for all kinds of y against bounds of √x.
        #[test]
        fn mixed_operations_enclose(x in 2..1000_u32, y in fraction()) {
            let root = exact(&x.to_string()).sqrt();
            let b = from_ratio(&y);
            let (lo, hi) = root.enclosure().unwrap();
            let within = |result: Exact, ends: [BigRational; 2]| {
                let (from, to) = result.enclosure().unwrap();
                ends.iter().all(|end| from <= *end && *end <= to)
            };
            prop_assert!(within(root.clone() + &b, [&lo + &y, &hi + &y]));
            prop_assert!(within(b.clone() + &root, [&lo + &y, &hi + &y]));
            prop_assert!(within(root.clone() - &b, [&lo - &y, &hi - &y]));
            prop_assert!(within(b.clone() - &root, [&y - &lo, &y - &hi]));
            prop_assert!(within(root.clone() * &b, [&lo * &y, &hi * &y]));
            prop_assert!(within(b.clone() * &root, [&lo * &y, &hi * &y]));
            prop_assert!(within(b.clone() / &root, [&y / &lo, &y / &hi]));
            if y != rational(0, 1) {
                prop_assert!(within(root / b, [&lo / &y, &hi / &y]));
            }
        }

        #[test]
        fn comparisons_with_enclosures_are_true(x in 2..1000_i64, y in fraction()) {
            let root = exact(&x.to_string()).sqrt();
            let order = from_ratio(&y).compare(&root);
            let square_order = (&y * &y).cmp(&rational(x, 1));
            let expected = if y < rational(0, 1) { Less } else { square_order };
            prop_assert_eq!(order, Ok(expected));
        }
    }
}
