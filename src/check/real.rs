//! Exact numbers and vectors for judging binary64 states: whole numbers times
//! powers of two, which sums and products never leave. Nothing is divided, no
//! root is taken, so every comparison is decided.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use crate::scalar::{Dyadic, Rounding};

/// A number that a binary64 state gives rise to, exactly.
#[derive(Clone, Debug)]
pub(super) struct Real(Dyadic);

impl Real {
    pub(super) fn zero() -> Self {
        Self(Dyadic::zero())
    }

    pub(super) fn square(&self) -> Self {
        self * self
    }

    pub(super) fn sign(&self) -> Ordering {
        self.0.sign()
    }

    pub(super) fn to_f64(&self) -> f64 {
        self.0.to_f64(Rounding::Nearest)
    }
}

impl From<f64> for Real {
    /// A finite number: states that are not are refused before.
    fn from(number: f64) -> Self {
        Self(Dyadic::from_f64(number))
    }
}

impl PartialEq for Real {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Real {}

impl PartialOrd for Real {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Real {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.compare(&other.0)
    }
}

impl Add for &Real {
    type Output = Real;

    fn add(self, other: Self) -> Real {
        Real(self.0.clone().add(&other.0))
    }
}

impl Sub for &Real {
    type Output = Real;

    fn sub(self, other: Self) -> Real {
        Real((-other.0.clone()).add(&self.0))
    }
}

impl Mul for &Real {
    type Output = Real;

    fn mul(self, other: Self) -> Real {
        Real(self.0.mul(&other.0))
    }
}

/// A point or a vector.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Point {
    pub(super) x: Real,
    pub(super) y: Real,
}

impl Point {
    pub(super) fn origin() -> Self {
        Self::from([0.0; 2])
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        let (x, y) = (&self.x - &other.x, &self.y - &other.y);
        Self { x, y }
    }

    pub(super) fn moved(&self, velocity: &Self, time: &Real) -> Self {
        Self {
            x: &self.x + &(&velocity.x * time),
            y: &self.y + &(&velocity.y * time),
        }
    }

    pub(super) fn dot(&self, other: &Self) -> Real {
        &(&self.x * &other.x) + &(&self.y * &other.y)
    }

    pub(super) fn cross(&self, other: &Self) -> Real {
        &(&self.x * &other.y) - &(&self.y * &other.x)
    }

    pub(super) fn norm_squared(&self) -> Real {
        self.dot(self)
    }
}

impl From<[f64; 2]> for Point {
    fn from([x, y]: [f64; 2]) -> Self {
        let (x, y) = (Real::from(x), Real::from(y));
        Self { x, y }
    }
}
