//! Intervals that carry their partial derivatives along.
//!
//! Automatic differentiation in forward mode (Rall: Automatic Differentiation,
//! 1981; Moore: Methods and Applications of Interval Analysis, 1979): with
//! every value come bounds of its derivatives by each variable over the whole
//! box of the variables. Values and decisions are those of [`Interval`].

use std::array::from_fn;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use num_rational::BigRational;

use super::{Interval, Number, Scalar, Undecided};

/// Bounds of a function's value and of its partial derivatives.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gradient {
    value: Interval,
    partials: [Interval; Self::VARIABLES],
}

impl Gradient {
    /// How many variables there can be: position, velocity and time of two
    /// discs.
    pub(crate) const VARIABLES: usize = 10;

    /// What does not depend on any variable.
    pub(crate) fn constant(value: Interval) -> Self {
        let partials = [Interval::ZERO; Self::VARIABLES];
        Self { value, partials }
    }

    /// The variable of this index.
    pub(crate) fn variable(value: Interval, index: usize) -> Self {
        let mut variable = Self::constant(value);
        variable.partials[index] = Interval::point(1.0);
        variable
    }

    /// Bounds of the derivatives.
    pub(crate) fn partials(&self) -> &[Interval; Self::VARIABLES] {
        &self.partials
    }

    /// A function of this one, of which the derivative is given.
    fn chain(&self, value: Interval, derivative: Interval) -> Self {
        let partials = self.partials.map(|partial| partial * derivative);
        Self { value, partials }
    }

    /// (a b)' = a' b + b' a.
    fn product(&self, other: &Self) -> Self {
        self.combine(other, self.value * other.value, |a, b| {
            a * other.value + b * self.value
        })
    }

    /// (a / b)' = (a' - (a / b) b') / b.
    fn quotient(&self, other: &Self) -> Self {
        let quotient = self.value / other.value;
        self.combine(other, quotient, |a, b| (a - quotient * b) / other.value)
    }

    /// A function of two others, whose partial derivatives are made from
    /// theirs.
    fn combine(
        &self,
        other: &Self,
        value: Interval,
        make: impl Fn(Interval, Interval) -> Interval,
    ) -> Self {
        let partials = from_fn(|index| make(self.partials[index], other.partials[index]));
        Self { value, partials }
    }
}

impl Scalar for Gradient {
    type Doubt = Undecided;
    type Precision = ();

    const ROUNDS: bool = false;
    const IS_DEAR: bool = false;

    fn from_number(number: &Number, (): ()) -> Self {
        Self::constant(Interval::from_number(number, ()))
    }

    fn from_integer(integer: i32) -> Self {
        Self::constant(Interval::from_integer(integer))
    }

    fn sign(&self) -> Result<Ordering, Undecided> {
        self.value.sign()
    }

    fn compare(&self, other: &Self) -> Result<Ordering, Undecided> {
        self.value.compare(&other.value)
    }

    /// (a²)' = 2 a a'.
    fn square(&self) -> Self {
        self.chain(self.value.square(), self.value + self.value)
    }

    /// (√a)' = a' / (2 √a), of which nothing is known about zero.
    fn sqrt(&self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, Interval::point(0.5) / root)
    }

    fn difference_of_products(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        *a * b - *c * d
    }

    fn not_before(self, _: &Self) -> Self {
        self
    }

    fn to_f64(&self) -> f64 {
        self.value.to_f64()
    }

    fn hull(&self) -> Interval {
        self.value
    }

    fn enclosure(&self) -> Option<(BigRational, BigRational)> {
        self.value.enclosure()
    }
}

impl Add<&Self> for Gradient {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        self.combine(other, self.value + other.value, |a, b| a + b)
    }
}

impl Sub<&Self> for Gradient {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        self.combine(other, self.value - other.value, |a, b| a - b)
    }
}

impl Mul<&Self> for Gradient {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        self.product(other)
    }
}

impl Div<&Self> for Gradient {
    type Output = Self;

    fn div(self, other: &Self) -> Self {
        self.quotient(other)
    }
}

impl Neg for Gradient {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: -self.value,
            partials: self.partials.map(Neg::neg),
        }
    }
}

/// The operators with their right operand by value.
macro_rules! forward_by_value {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Gradient {
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
    use num_traits::Zero;
    use proptest::prelude::*;

    use super::*;
    use crate::scalar::Exact;

    /// A function of three variables that uses every operation but roots.
    fn rational<T: Scalar>([x, y, z]: &[T; 3]) -> T {
        let product = T::difference_of_products(x, y, z, z) - x;
        (product + T::power(x, z, y)) / (y.square() + T::from_integer(1)) * z - -x.clone()
    }

    fn exact(number: f64) -> Exact {
        Exact::from_number(&Number::try_from(number).unwrap(), 64)
    }

    fn value(number: &Exact) -> BigRational {
        let (lo, hi) = number.enclosure().unwrap();
        assert_eq!(lo, hi);
        lo
    }

    fn contains(interval: Interval, number: &BigRational) -> bool {
        interval
            .enclosure()
            .is_none_or(|(lo, hi)| lo <= *number && *number <= hi)
    }

    fn slope(from: &BigRational, to: &BigRational, step: &BigRational) -> BigRational {
        (to - from) / step
    }

    /// At (3, 4): of x y it is (4, 3), of x / y (1/4, -3/16), of x² (6, 0), of
    /// √(x + 1) = 2 it is (1/4, 0).
    #[test]
    fn by_hand() {
        let [x, y] =
            [(3.0, 0), (4.0, 1)].map(|(at, index)| Gradient::variable(Interval::point(at), index));
        let partials =
            |function: Gradient| [function.partials[0].to_f64(), function.partials[1].to_f64()];
        assert_eq!(partials(x * y), [4.0, 3.0]);
        assert_eq!(partials(x / y), [0.25, -0.1875]);
        assert_eq!(partials(x.square()), [6.0, 0.0]);
        assert_eq!(
            partials((x + Gradient::from_integer(1)).sqrt()),
            [0.25, 0.0]
        );
        assert_eq!(partials(-x - y), [-1.0, -1.0]);
    }

    #[test]
    fn nothing_is_known_of_a_root_about_zero() {
        let about_zero = Gradient::variable(Interval::new(0.0, 1.0), 0);
        assert_eq!(about_zero.sqrt().partials[0], Interval::UNBOUNDED);
    }

    proptest! {
        /// Between two points that differ in one variable, the derivative by
        /// it takes the mean slope somewhere.
        #[test]
        fn difference_quotients_lie_within(
            from in prop::array::uniform3(-4.0..4.0_f64),
            step in -1.0..1.0_f64,
            index in 0..3_usize,
        ) {
            let mut to = from;
            to[index] += step;
            let boxed: [Gradient; 3] = from_fn(|at| {
                let hull = Interval::new(from[at].min(to[at]), from[at].max(to[at]));
                Gradient::variable(hull, at)
            });
            let bounds = rational(&boxed);
            let [start, end] = [from, to].map(|point| value(&rational(&point.map(exact))));
            prop_assert!(contains(bounds.hull(), &start) && contains(bounds.hull(), &end));
            let step = value(&exact(to[index])) - value(&exact(from[index]));
            if !step.is_zero() {
                let slope = slope(&start, &end, &step);
                prop_assert!(contains(bounds.partials()[index], &slope));
            }
        }

        /// (√b - √a) / (b - a) for squares a and b.
        #[test]
        fn slopes_of_roots(from in 1..1_000_u32, to in 1..1_000_u32) {
            prop_assume!(from != to);
            let [a, b] = [from, to].map(|root| f64::from(root * root));
            let root = Gradient::variable(Interval::new(a.min(b), a.max(b)), 0).sqrt();
            let slope = BigRational::new(1.into(), (from + to).into());
            prop_assert!(contains(root.partials()[0], &slope));
        }
    }
}
