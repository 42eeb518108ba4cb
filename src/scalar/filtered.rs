//! A stored binary64 number, of which whole decisions are taken exactly.

use std::cmp::Ordering;
use std::convert::Infallible;
use std::ops::{Add, Div, Mul, Neg, Sub};

use num_rational::BigRational;

use super::{Interval, Number, Scalar};

/// A binary64 number as it is stored between impacts.
///
/// Its own operations round like those of [`f64`]. What sets it apart is its
/// [`Kernel`](crate::kernel::Kernel), which takes the decisions of a collision from
/// the stored numbers as wholes, exactly: see [`filtered`](crate::filtered).
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Filtered(f64);

impl Filtered {
    /// The number, to be stored. One beyond the largest, such as the place of a
    /// disc that is faster than that in the time given, is stored as the largest.
    #[inline]
    pub const fn new(number: f64) -> Self {
        Self(number.clamp(f64::MIN, f64::MAX))
    }

    /// The number that is stored.
    #[inline]
    pub const fn get(self) -> f64 {
        self.0
    }
}

impl Scalar for Filtered {
    type Doubt = Infallible;
    type Precision = ();

    const ROUNDS: bool = true;
    const IS_DEAR: bool = false;

    fn from_number(number: &Number, (): ()) -> Self {
        Self(number.to_f64())
    }

    fn from_integer(integer: i32) -> Self {
        Self(integer.into())
    }

    #[inline]
    fn sign(&self) -> Result<Ordering, Infallible> {
        self.0.sign()
    }

    #[inline]
    fn compare(&self, other: &Self) -> Result<Ordering, Infallible> {
        self.0.compare(&other.0)
    }

    #[inline]
    fn square(&self) -> Self {
        Self(self.0.square())
    }

    #[inline]
    fn sqrt(&self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline]
    fn difference_of_products(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        Self(f64::difference_of_products(&a.0, &b.0, &c.0, &d.0))
    }

    #[inline]
    fn power(x: &Self, y: &Self, r: &Self) -> Self {
        Self(f64::power(&x.0, &y.0, &r.0))
    }

    #[inline]
    fn not_before(self, floor: &Self) -> Self {
        Self(self.0.not_before(&floor.0))
    }

    fn to_f64(&self) -> f64 {
        self.0
    }

    #[inline]
    fn hull(&self) -> Interval {
        self.0.hull()
    }

    fn enclosure(&self) -> Option<(BigRational, BigRational)> {
        None
    }
}

macro_rules! operator {
    ($operator:ident, $method:ident) => {
        impl $operator for Filtered {
            type Output = Self;

            #[inline]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }

        impl $operator<&Self> for Filtered {
            type Output = Self;

            #[inline]
            fn $method(self, other: &Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Filtered {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}
