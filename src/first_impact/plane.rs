//! Rational vectors, and discs as points in motion.

use num_rational::BigRational;

use crate::scalar::Number;
use crate::scene::Disc;

/// A rational vector.
pub(super) type Vector = [BigRational; 2];

/// A point in motion, with a radius about it.
pub(super) struct Motion {
    pub(super) position: Vector,
    pub(super) velocity: Vector,
    pub(super) radius: BigRational,
}

impl Motion {
    pub(super) fn of(disc: &Disc) -> Self {
        Self {
            position: point(&disc.position),
            velocity: point(&disc.velocity),
            radius: disc.radius.to_rational(),
        }
    }

    /// The same motion, seen from another.
    pub(super) fn seen_from(self, other: &Self) -> Self {
        Self {
            position: minus(&self.position, &other.position),
            velocity: minus(&self.velocity, &other.velocity),
            radius: self.radius,
        }
    }
}

pub(super) fn point(coordinates: &[Number; 2]) -> Vector {
    coordinates.each_ref().map(Number::to_rational)
}

pub(super) fn minus([x, y]: &Vector, [other_x, other_y]: &Vector) -> Vector {
    [x - other_x, y - other_y]
}

pub(super) fn dot([x, y]: &Vector, [other_x, other_y]: &Vector) -> BigRational {
    x * other_x + y * other_y
}

pub(super) fn cross([x, y]: &Vector, [other_x, other_y]: &Vector) -> BigRational {
    x * other_y - y * other_x
}
