//! Points and directions whose coordinates are dyadic, computed with exactly.

use std::cmp::Ordering;

use crate::scalar::{Dyadic, Filtered, Rounding};
use crate::vec2::Vec2;

/// A point or a direction in the plane.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    pub(crate) x: Dyadic,
    pub(crate) y: Dyadic,
}

impl Point {
    pub(crate) fn new([x, y]: [f64; 2]) -> Self {
        Self {
            x: Dyadic::from_f64(x),
            y: Dyadic::from_f64(y),
        }
    }

    pub(crate) fn of(vector: &Vec2<Filtered>) -> Self {
        Self::new([vector.x.get(), vector.y.get()])
    }

    /// The nearest binary64 coordinates.
    pub(crate) fn rounded(&self) -> Vec2<Filtered> {
        let nearest = |coordinate: &Dyadic| Filtered::new(coordinate.to_f64(Rounding::Nearest));
        Vec2::new(nearest(&self.x), nearest(&self.y))
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self {
            x: self.x.clone().add(&other.x),
            y: self.y.clone().add(&other.y),
        }
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self {
            x: self.x.clone().sub(&other.x),
            y: self.y.clone().sub(&other.y),
        }
    }

    pub(crate) fn scaled(&self, factor: &Dyadic) -> Self {
        Self {
            x: self.x.mul(factor),
            y: self.y.mul(factor),
        }
    }

    pub(crate) fn reversed(&self) -> Self {
        Self {
            x: -self.x.clone(),
            y: -self.y.clone(),
        }
    }

    /// The vector turned by a right angle, counterclockwise.
    pub(crate) fn perpendicular(&self) -> Self {
        Self {
            x: -self.y.clone(),
            y: self.x.clone(),
        }
    }

    pub(crate) fn dot(&self, other: &Self) -> Dyadic {
        self.x.mul(&other.x).add(&self.y.mul(&other.y))
    }

    pub(crate) fn cross(&self, other: &Self) -> Dyadic {
        self.x.mul(&other.y).sub(&self.y.mul(&other.x))
    }

    pub(crate) fn squared(&self) -> Dyadic {
        self.dot(self)
    }

    /// The order of the length against another number that is not negative.
    pub(crate) fn compare_length(&self, length: &Dyadic) -> Ordering {
        self.squared().compare(&length.mul(length))
    }
}
