//! Rational isometries of the plane about a point.

use num_rational::BigRational;
use num_traits::{One, Zero};

/// A point or a vector.
pub(super) type Vector = [BigRational; 2];

/// A rotation or a reflection that fixes a point.
pub(super) struct Isometry {
    /// The linear part, row by row.
    matrix: [Vector; 2],
    /// Where it maps the origin.
    shift: Vector,
}

impl Isometry {
    /// A rotation about a point by so many right angles.
    pub(super) fn rotation(centre: &Vector, quarters: u32) -> Self {
        let [zero, one] = [BigRational::zero(), BigRational::one()];
        let [cos, sin] = match quarters % 4 {
            0 => [one, zero],
            1 => [zero, one],
            2 => [-one, zero],
            _ => [zero, -one],
        };
        Self::about(centre, [[cos.clone(), -&sin], [sin, cos]])
    }

    /// The reflection about a point that maps the one vector from there onto
    /// the other, of the same length.
    pub(super) fn bisector(centre: &Vector, from: &Vector, to: &Vector) -> Self {
        let across = [&from[0] - &to[0], &from[1] - &to[1]];
        Self::reflection(centre, &across)
    }

    /// The reflection in the line through a point along a vector.
    pub(super) fn axis(centre: &Vector, along: &Vector) -> Self {
        Self::reflection(centre, &[-&along[1], along[0].clone()])
    }

    /// The reflection in the line through a point across a vector d:
    /// x - 2 (d·x / d·d) d.
    fn reflection(centre: &Vector, across: &Vector) -> Self {
        let [dx, dy] = across;
        let factor = BigRational::from_integer((-2).into()) / dot(across, across);
        let mixed = &factor * dx * dy;
        let matrix = [
            [BigRational::one() + &factor * dx * dx, mixed.clone()],
            [mixed, BigRational::one() + factor * dy * dy],
        ];
        Self::about(centre, matrix)
    }

    fn about(centre: &Vector, matrix: [Vector; 2]) -> Self {
        let image = matrix.each_ref().map(|row| dot(row, centre));
        let shift = difference(centre, &image);
        Self { matrix, shift }
    }

    /// The image of a point.
    pub(super) fn point(&self, point: &Vector) -> Vector {
        let [x, y] = self.vector(point);
        [x + &self.shift[0], y + &self.shift[1]]
    }

    /// The image of a vector.
    pub(super) fn vector(&self, vector: &Vector) -> Vector {
        self.matrix.each_ref().map(|row| dot(row, vector))
    }
}

pub(super) fn dot(a: &Vector, b: &Vector) -> BigRational {
    &a[0] * &b[0] + &a[1] * &b[1]
}

pub(super) fn difference(a: &Vector, b: &Vector) -> Vector {
    [&a[0] - &b[0], &a[1] - &b[1]]
}
