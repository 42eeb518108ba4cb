//! Bodies that overlap where they are, whether they move or not (P2.2).

use std::cmp::Ordering::{Equal, Greater, Less};

use super::segment::{End, Nearest, Segment};
use crate::scalar::Scalar;
use crate::vec2::Vec2;

/// A disc that intersects something.
#[derive(Clone, Debug)]
pub struct Overlap<S> {
    /// The wall's end point that is nearest, unless its interior is.
    pub end: Option<End>,
    /// How to move the two apart. Concentric discs and a centre on a wall
    /// give no direction.
    pub separation: Option<Separation<S>>,
}

/// The shortest way to move two bodies apart.
#[derive(Clone, Debug)]
pub struct Separation<S> {
    /// From the disc towards what it intersects, of any length.
    pub direction: Vec2<S>,
    /// How far apart to move the two, as a multiple of `direction`.
    pub lack: S,
}

/// Whether the centre of a circle of radius `reach` is closer than that to a
/// point at `offset`.
///
/// # Errors
///
/// An enclosure of an intermediate value contains zero.
#[inline]
pub fn overlap_circle<S: Scalar>(
    offset: &Vec2<S>,
    reach: &S,
) -> Result<Option<Overlap<S>>, S::Doubt> {
    for coordinate in [&offset.x, &offset.y] {
        if coordinate.compare(reach)? != Less || (-coordinate.clone()).compare(reach)? != Less {
            return Ok(None);
        }
    }
    if S::power(&offset.x, &offset.y, reach).sign()? != Less {
        return Ok(None);
    }
    Overlap::with_circle(offset, reach).map(Some)
}

/// Whether a disc intersects a segment.
///
/// # Errors
///
/// An enclosure of an intermediate value contains zero.
pub fn overlap_segment<S: Scalar>(
    centre: &Vec2<S>,
    radius: &S,
    segment: &Segment<S>,
) -> Result<Option<Overlap<S>>, S::Doubt> {
    let offset = centre.minus(&segment.from);
    let side = offset.cross(&segment.along);
    let reach = radius.clone() * &segment.length;
    if side.compare(&reach)? != Less || (-side.clone()).compare(&reach)? != Less {
        return Ok(None);
    }
    match segment.nearest(&offset)? {
        Nearest::Foot(end) => Overlap::from_line(side, &reach, segment, end).map(Some),
        Nearest::Beyond(end) => {
            let overlap = overlap_circle(&segment.end(end).minus(centre), radius)?;
            let end = Some(end);
            Ok(overlap.map(|overlap| Overlap { end, ..overlap }))
        }
    }
}

impl<S> Overlap<S> {
    /// The same overlap in another arithmetic.
    pub(crate) fn map<T>(&self, make: impl Fn(&S) -> T) -> Overlap<T> {
        let separation = self.separation.as_ref();
        Overlap {
            end: self.end,
            separation: separation.map(|separation| Separation {
                direction: separation.direction.map(&make),
                lack: make(&separation.lack),
            }),
        }
    }
}

impl<S: Scalar> Overlap<S> {
    /// The overlap, which is decided, of a circle of radius `reach` and a point
    /// at `offset` from its centre.
    pub(crate) fn with_circle(offset: &Vec2<S>, reach: &S) -> Result<Self, S::Doubt> {
        let distance_squared = offset.norm_squared();
        let is_concentric = distance_squared.sign()? == Equal;
        let separation = || Separation {
            direction: offset.clone(),
            lack: reach.clone() / distance_squared.sqrt() - S::from_integer(1),
        };
        Ok(Self {
            end: None,
            separation: (!is_concentric).then(separation),
        })
    }

    /// The overlap, which is decided, of a disc and the interior of a segment,
    /// or exactly what is opposite an end.
    pub(crate) fn with_line(
        centre: &Vec2<S>,
        radius: &S,
        segment: &Segment<S>,
        end: Option<End>,
    ) -> Result<Self, S::Doubt> {
        let side = centre.minus(&segment.from).cross(&segment.along);
        let reach = radius.clone() * &segment.length;
        Self::from_line(side, &reach, segment, end)
    }

    /// The same from the side and the radius, both times the length.
    fn from_line(
        side: S,
        reach: &S,
        segment: &Segment<S>,
        end: Option<End>,
    ) -> Result<Self, S::Doubt> {
        let across = segment.along.perpendicular();
        let (direction, distance) = match side.sign()? {
            Less => (-across, -side),
            Equal => {
                let separation = None;
                return Ok(Self { end, separation });
            }
            Greater => (across, side),
        };
        let lack = (reach.clone() - distance) / &segment.length_squared;
        let separation = Some(Separation { direction, lack });
        Ok(Self { end, separation })
    }
}
