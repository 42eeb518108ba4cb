//! Vectors in the plane, over any [`Scalar`].

use std::ops::Neg;

use crate::scalar::Scalar;

/// A point or a direction in the plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vec2<S> {
    /// The first coordinate.
    pub x: S,
    /// The second coordinate.
    pub y: S,
}

impl<S> Vec2<S> {
    /// The vector with these coordinates.
    pub fn new(x: S, y: S) -> Self {
        Self { x, y }
    }

    /// The vector whose coordinates are made from this one's.
    pub fn map<T>(&self, make: impl Fn(&S) -> T) -> Vec2<T> {
        Vec2::new(make(&self.x), make(&self.y))
    }
}

impl<S: Scalar> Vec2<S> {
    /// The null vector.
    pub fn zero() -> Self {
        Self::new(S::from_integer(0), S::from_integer(0))
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self::new(self.x.clone() + &other.x, self.y.clone() + &other.y)
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        Self::new(self.x.clone() - &other.x, self.y.clone() - &other.y)
    }

    /// The vector, longer by a factor.
    #[must_use]
    pub fn scaled(&self, factor: &S) -> Self {
        self.map(|coordinate| coordinate.clone() * factor)
    }

    /// Where a point gets in a time at a constant velocity.
    #[must_use]
    pub fn moved(&self, velocity: &Self, time: &S) -> Self {
        self.plus(&velocity.scaled(time))
    }

    /// The vector turned by a right angle, counterclockwise.
    #[must_use]
    pub fn perpendicular(&self) -> Self {
        Self::new(-self.y.clone(), self.x.clone())
    }

    /// The scalar product.
    pub fn dot(&self, other: &Self) -> S {
        self.x.clone() * &other.x + self.y.clone() * &other.y
    }

    /// The signed area that the two vectors span: positive where `other`
    /// lies counterclockwise of this one.
    pub fn cross(&self, other: &Self) -> S {
        S::difference_of_products(&self.x, &other.y, &self.y, &other.x)
    }

    /// The square of the length.
    pub fn norm_squared(&self) -> S {
        self.x.square() + self.y.square()
    }
}

impl<S: Scalar> Neg for Vec2<S> {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}

impl<S: Scalar> Default for Vec2<S> {
    fn default() -> Self {
        Self::zero()
    }
}

impl<S> From<[S; 2]> for Vec2<S> {
    fn from([x, y]: [S; 2]) -> Self {
        Self::new(x, y)
    }
}

impl<S> From<Vec2<S>> for [S; 2] {
    fn from(vector: Vec2<S>) -> Self {
        [vector.x, vector.y]
    }
}
