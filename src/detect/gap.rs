//! Whether bodies are apart, touch or overlap where they are.

use std::cmp::Ordering;

use super::segment::{End, Nearest, Segment};
use crate::scalar::Scalar;
use crate::vec2::Vec2;

/// The sign of the distance of a point at `offset` from a circle of radius
/// `reach`: greater outside, equal on it.
///
/// # Errors
///
/// An enclosure of an intermediate value contains zero.
pub fn gap_circle<S: Scalar>(offset: &Vec2<S>, reach: &S) -> Result<Ordering, S::Doubt> {
    S::power(&offset.x, &offset.y, reach).sign()
}

/// The sign of the distance of a disc from a segment, and the end point that
/// is nearest, unless the interior is.
///
/// # Errors
///
/// An enclosure of an intermediate value contains zero.
pub fn gap_segment<S: Scalar>(
    centre: &Vec2<S>,
    radius: &S,
    segment: &Segment<S>,
) -> Result<(Ordering, Option<End>), S::Doubt> {
    let offset = centre.minus(&segment.from);
    match segment.nearest(&offset)? {
        Nearest::Foot(end) => {
            // Squared, so that it does not matter on which side.
            let side = offset.cross(&segment.along).square();
            let reach = radius.square() * &segment.length_squared;
            Ok((side.compare(&reach)?, end))
        }
        Nearest::Beyond(end) => {
            let gap = gap_circle(&segment.end(end).minus(centre), radius)?;
            Ok((gap, Some(end)))
        }
    }
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering::{Equal, Greater, Less};

    use super::*;
    use crate::scalar::{Exact, Number};

    fn vector(x: i32, y: i32) -> Vec2<Exact> {
        Vec2::new(Exact::from_integer(x), Exact::from_integer(y))
    }

    /// A segment from (0, 0) to (4, 0) and a disc of radius 5 about points of
    /// the 3-4-5 triangle beside it.
    #[test]
    fn discs_and_segments() {
        let (from, to) = (vector(0, 0), vector(4, 0));
        let segment = Segment::new(from.clone(), to.clone(), to.minus(&from));
        let radius = Exact::from_number(&Number::from(5), 64);
        let table = [
            ((2, 5), Equal, None),
            ((2, -5), Equal, None),
            ((0, 5), Equal, Some(End::From)),
            ((-3, 4), Equal, Some(End::From)),
            ((7, -4), Equal, Some(End::To)),
            ((8, -4), Greater, Some(End::To)),
            ((1, 4), Less, None),
        ];
        for ((x, y), gap, end) in table {
            let found = gap_segment(&vector(x, y), &radius, &segment);
            assert_eq!(found, Ok((gap, end)), "({x}, {y})");
        }
    }
}
