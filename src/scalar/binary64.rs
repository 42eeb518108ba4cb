//! Binary64: every result rounds to nearest, every decision is made on the
//! rounded numbers.

use std::cmp::Ordering;
use std::convert::Infallible;

use num_rational::BigRational;

use super::{Interval, Number, Scalar};

impl Scalar for f64 {
    type Doubt = Infallible;
    type Precision = ();

    const ROUNDS: bool = true;
    const IS_DEAR: bool = false;

    fn from_number(number: &Number, (): ()) -> Self {
        number.to_f64()
    }

    fn from_integer(integer: i32) -> Self {
        Self::from(integer)
    }

    /// A NaN, which numbers within [`Number::BINARY64_RANGE`] do not give
    /// rise to, would count as zero.
    #[inline]
    fn sign(&self) -> Result<Ordering, Infallible> {
        self.compare(&0.0)
    }

    #[inline]
    fn compare(&self, other: &Self) -> Result<Ordering, Infallible> {
        Ok(self.partial_cmp(other).unwrap_or(Ordering::Equal))
    }

    #[inline]
    fn square(&self) -> Self {
        self * self
    }

    #[inline]
    fn sqrt(&self) -> Self {
        Self::sqrt(*self)
    }

    /// Kahan's algorithm: at most 1.5 ulps from the true value, whatever
    /// cancels (Jeannerod, Louvet, Muller: Further analysis of Kahan's
    /// algorithm for the accurate computation of 2 × 2 determinants, 2013).
    #[inline]
    fn difference_of_products(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        let cd = c * d;
        let rounding = (-c).mul_add(*d, cd);
        a.mul_add(*b, -cd) + rounding
    }

    /// Squares and sums with their rounding errors carried along (Ogita,
    /// Rump, Oishi: Accurate sum and dot product, 2005): the result is as if
    /// computed with twice the digits and rounded once.
    #[inline]
    fn power(x: &Self, y: &Self, r: &Self) -> Self {
        let (xx, x_rest) = square_with_rest(*x);
        let (yy, y_rest) = square_with_rest(*y);
        let (rr, r_rest) = square_with_rest(*r);
        let (partial, partial_rest) = sum_with_rest(xx, -rr);
        let (total, total_rest) = sum_with_rest(partial, yy);
        total + (partial_rest + total_rest + (x_rest + y_rest - r_rest))
    }

    #[inline]
    fn not_before(self, floor: &Self) -> Self {
        self.max(*floor)
    }

    fn to_f64(&self) -> f64 {
        *self
    }

    #[inline]
    fn hull(&self) -> Interval {
        Interval::new(*self, *self)
    }

    fn enclosure(&self) -> Option<(BigRational, BigRational)> {
        None
    }
}

/// A square and what its rounding left out.
#[inline]
fn square_with_rest(x: f64) -> (f64, f64) {
    let square = x * x;
    (square, x.mul_add(x, -square))
}

/// A sum and what its rounding left out (Knuth's two-sum).
#[inline]
fn sum_with_rest(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}
