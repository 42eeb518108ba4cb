//! A number of bodies that fall.

use std::cmp::Ordering;
use std::marker::PhantomData;
use std::ops::{Add, Div, Mul, Neg, Sub};

use num_rational::BigRational;

use super::medium::{Marker, Vacuum};
use crate::roots::{Descent, Fades, Fading, Polynomial, Roots};
use crate::scalar::{Decay, Interval, Number, Scalar};

/// A number as it is, of bodies that gravity pulls through a [`Medium`](super::Medium).
///
/// It computes and decides as the number that it holds does. What sets it apart
/// is its [`Kernel`](crate::kernel::Kernel), in which bodies fall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Falling<S, M = Vacuum>(pub S, PhantomData<M>);

impl<S, M> Falling<S, M> {
    /// The number of a body that falls.
    #[inline]
    pub fn new(number: S) -> Self {
        Self(number, PhantomData)
    }
}

impl<S: Scalar, M: Marker> Scalar for Falling<S, M> {
    type Doubt = S::Doubt;
    type Precision = S::Precision;

    const ROUNDS: bool = S::ROUNDS;
    /// Bounds of straight motion rule out nothing.
    const IS_DEAR: bool = false;

    fn from_number(number: &Number, precision: S::Precision) -> Self {
        Self::new(S::from_number(number, precision))
    }

    fn from_integer(integer: i32) -> Self {
        Self::new(S::from_integer(integer))
    }

    #[inline]
    fn sign(&self) -> Result<Ordering, S::Doubt> {
        self.0.sign()
    }

    fn is_surely_zero(&self) -> bool {
        self.0.is_surely_zero()
    }

    #[inline]
    fn compare(&self, other: &Self) -> Result<Ordering, S::Doubt> {
        self.0.compare(&other.0)
    }

    #[inline]
    fn square(&self) -> Self {
        Self::new(self.0.square())
    }

    #[inline]
    fn sqrt(&self) -> Self {
        Self::new(self.0.sqrt())
    }

    #[inline]
    fn difference_of_products(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        Self::new(S::difference_of_products(&a.0, &b.0, &c.0, &d.0))
    }

    #[inline]
    fn power(x: &Self, y: &Self, r: &Self) -> Self {
        Self::new(S::power(&x.0, &y.0, &r.0))
    }

    fn bare(&self) -> Self {
        Self::new(self.0.bare())
    }

    #[inline]
    fn not_before(self, floor: &Self) -> Self {
        Self::new(self.0.not_before(&floor.0))
    }

    fn to_f64(&self) -> f64 {
        self.0.to_f64()
    }

    #[inline]
    fn hull(&self) -> Interval {
        self.0.hull()
    }

    fn enclosure(&self) -> Option<(BigRational, BigRational)> {
        self.0.enclosure()
    }
}

impl<S: Roots, M: Marker> Roots for Falling<S, M> {
    fn descent(f: &Polynomial<Self>) -> Result<Option<Descent<Self>>, S::Doubt> {
        let f = Polynomial(f.0.clone().map(|number| number.0));
        Ok(S::descent(&f)?.map(|met| met.map(Self::new)))
    }
}

impl<S: Decay, M: Marker> Decay for Falling<S, M> {
    fn decay(&self) -> Self {
        Self::new(self.0.decay())
    }

    fn undecay(&self) -> Self {
        Self::new(self.0.undecay())
    }
}

impl<S: Fades, M: Marker> Fades for Falling<S, M> {
    fn decay_and_lag(&self) -> [Self; 2] {
        self.0.decay_and_lag().map(Self::new)
    }

    fn descent(f: &Fading<Self>, zeros: usize) -> Result<Option<Descent<Self>>, S::Doubt> {
        let f = f.map(|number| number.0.clone());
        Ok(S::descent(&f, zeros)?.map(|met| met.map(Self::new)))
    }
}

macro_rules! operator {
    ($operator:ident, $method:ident) => {
        impl<S: Scalar, M: Marker> $operator for Falling<S, M> {
            type Output = Self;

            #[inline]
            fn $method(self, other: Self) -> Self {
                Self::new(self.0.$method(other.0))
            }
        }

        impl<S: Scalar, M: Marker> $operator<&Self> for Falling<S, M> {
            type Output = Self;

            #[inline]
            fn $method(self, other: &Self) -> Self {
                Self::new(self.0.$method(&other.0))
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<S: Scalar, M: Marker> Neg for Falling<S, M> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.0)
    }
}
