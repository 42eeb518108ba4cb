//! A disc that moves towards a wall: a two-sided segment with its end points.
//!
//! The disc's centre meets the points at distance r from the segment: two
//! parallel lines, closed by a half circle about each end point. With u along
//! the segment, q the centre from its first end point and L = |u|, the side
//! and distance of the centre are h = q × u (times L), and the lines are met
//! after (|h| - r L) / |v × u|. The foot q·u of the perpendicular then tells
//! whether the interior (0 < q·u < L²) is touched. Otherwise only the
//! half circle on the foot's side can be met, for the strip between the lines
//! can be left towards the segment only through it.
//!
//! It is met no sooner than the line. That is a matter of course, but for rounding:
//! of a disc that passes along the segment and comes to the line beyond the far end,
//! the path is tangent to that end's circle too, nearly, and a rounded D puts the
//! disc on it while it still is beside the interior. So rounded numbers are asked
//! whether the disc still approaches the end when it crosses the line, and the end is
//! not met before.
//!
//! A segment is convex, so a disc that has left it, or slides along it, in
//! free motion never meets it again: its end points included.

use std::cmp::Ordering::{self, Equal, Greater, Less};
use std::fmt;

use super::{Encounter, meet_circle};
use crate::scalar::Scalar;
use crate::vec2::Vec2;

/// One of a wall's two end points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum End {
    /// The point `from`.
    From,
    /// The point `to`.
    To,
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::From => "from",
            Self::To => "to",
        })
    }
}

/// A wall's geometry, with what every test of it needs.
#[derive(Clone, Debug)]
pub struct Segment<S> {
    /// The first end point.
    pub from: Vec2<S>,
    /// The other end point.
    pub to: Vec2<S>,
    /// The vector from the first end point to the other.
    pub along: Vec2<S>,
    /// The length.
    pub length: S,
    /// The square of the length.
    pub length_squared: S,
}

impl<S> Segment<S> {
    /// The same segment in another arithmetic.
    pub fn map<T>(&self, make: impl Fn(&S) -> T) -> Segment<T> {
        Segment {
            from: self.from.map(&make),
            to: self.to.map(&make),
            along: self.along.map(&make),
            length: make(&self.length),
            length_squared: make(&self.length_squared),
        }
    }
}

impl<S: Scalar> Segment<S> {
    /// The segment between two points that differ by `along`.
    pub fn new(from: Vec2<S>, to: Vec2<S>, along: Vec2<S>) -> Self {
        let length_squared = along.norm_squared();
        Self {
            from,
            to,
            along,
            length: length_squared.sqrt(),
            length_squared,
        }
    }

    /// One of the end points.
    pub fn end(&self, end: End) -> &Vec2<S> {
        match end {
            End::From => &self.from,
            End::To => &self.to,
        }
    }

    /// Whether it is certain that another segment is part of the same line.
    pub(crate) fn is_in_line_with(&self, other: &Self) -> bool {
        let across = |vector: &Vec2<S>| self.along.cross(vector).is_surely_zero();
        across(&other.along) && across(&other.from.minus(&self.from))
    }

    /// Whether another segment continues this one, in the same line, beyond an
    /// end point.
    pub(crate) fn goes_on_in(&self, other: &Self, end: End) -> Result<bool, S::Doubt> {
        if !self.is_in_line_with(other) {
            return Ok(false);
        }
        let beyond = |point: &Vec2<S>| {
            let way = point.minus(self.end(end)).dot(&self.along).sign()?;
            Ok(if end == End::From { way.reverse() } else { way })
        };
        let (one, two) = (beyond(&other.from)?, beyond(&other.to)?);
        Ok(one.max(two) == Greater && one.min(two) != Greater)
    }

    /// Whether it is certain that the perpendicular from a point meets the
    /// segment between its end points.
    pub(crate) fn is_surely_beside(&self, point: &Vec2<S>) -> bool {
        let nearest = self.nearest(&point.minus(&self.from));
        matches!(nearest, Ok(Nearest::Foot(None)))
    }

    /// The part of the segment that is nearest to a point whose offset from
    /// the first end point is given.
    pub(crate) fn nearest(&self, offset: &Vec2<S>) -> Result<Nearest, S::Doubt> {
        let foot = offset.dot(&self.along);
        Ok(match foot.sign()? {
            Less => Nearest::Beyond(End::From),
            Equal => Nearest::Foot(Some(End::From)),
            Greater => match foot.compare(&self.length_squared)? {
                Less => Nearest::Foot(None),
                Equal => Nearest::Foot(Some(End::To)),
                Greater => Nearest::Beyond(End::To),
            },
        })
    }
}

/// Where the perpendicular from a point meets a segment's line.
pub(crate) enum Nearest {
    /// On the segment, possibly exactly at an end point.
    Foot(Option<End>),
    /// Outside the segment, on the side of this end point.
    Beyond(End),
}

/// When a disc at `centre` meets a segment, moving at `velocity` relative to
/// it. The end points for which `barred` holds are known not to be met.
///
/// # Error in binary64
///
/// Let u = 2^-53 and g = (|h| - r L) / (|h| + r L), which is 0 in contact. For
/// the offset from the first end point and the direction as given:
///
/// - On which side the centre is, and **whether it approaches** the line, is
///   always right: both cross products are computed to 2u of themselves.
/// - Whether the line is **touched or overlapped** is right where |g| > 3u, as
///   r L is computed to 3u. An approach that is mistaken for an overlap is an
///   impact all the same, now instead of soon.
/// - **The time** to the line has an error of at most 7u/g of itself: the gap has
///   one of 3u/g + u, the other cross product of 2u, the division of u.
/// - Whether the **interior or an end** is touched follows from the foot at that
///   time, so it is right unless the foot is as close to the end as the centre
///   gets in the error of the time, or closer than some units in the last place of
///   the coordinates.
///
/// For the end points see [`meet_circle`].
///
/// # Errors
///
/// An enclosure of an intermediate value contains zero.
pub fn meet_segment<S: Scalar>(
    centre: &Vec2<S>,
    velocity: &Vec2<S>,
    radius: &S,
    segment: &Segment<S>,
    barred: impl Fn(End) -> bool,
) -> Result<Option<Encounter<S>>, S::Doubt> {
    let offset = centre.minus(&segment.from);
    let side = offset.cross(&segment.along);
    let drift = velocity.cross(&segment.along);
    let side_sign = side.sign()?;
    let approaches = opposite(side_sign, drift.sign()?);
    let gap = magnitude(side, side_sign) - radius.clone() * &segment.length;
    let meet_end = |end| {
        if barred(end) {
            return Ok(None);
        }
        let met = meet_circle(&centre.minus(segment.end(end)), velocity, radius)?;
        Ok(met.map(|encounter| encounter.at(end)))
    };
    if gap.sign()? == Less {
        return match segment.nearest(&offset)? {
            Nearest::Foot(end) => Ok(approaches.then(|| with_end(Encounter::inside(), end))),
            Nearest::Beyond(end) => meet_end(end),
        };
    }
    if !approaches {
        return Ok(None);
    }
    let delay = gap / magnitude(drift, side_sign.reverse());
    match segment.nearest(&offset.moved(velocity, &delay))? {
        Nearest::Foot(end) => Ok(Some(with_end(Encounter::impact(delay), end))),
        Nearest::Beyond(end) => {
            let met = meet_end(end)?;
            let offset = centre.minus(segment.end(end));
            met.map_or(Ok(None), |met| met_beyond(met, &offset, velocity, delay))
        }
    }
}

/// An end point is met, if it is, no sooner than the line beyond it, which a centre
/// at an offset from that end crosses after a delay.
fn met_beyond<S: Scalar>(
    met: Encounter<S>,
    offset: &Vec2<S>,
    velocity: &Vec2<S>,
    crossing: S,
) -> Result<Option<Encounter<S>>, S::Doubt> {
    if !S::ROUNDS {
        return Ok(Some(met));
    }
    let place = offset.moved(velocity, &crossing);
    if place.dot(velocity).sign()? != Less {
        return Ok(None);
    }
    if met.delay.compare(&crossing)? == Less {
        return Ok(Some(with_end(Encounter::impact(crossing), met.end)));
    }
    Ok(Some(met))
}

fn with_end<S: Scalar>(encounter: Encounter<S>, end: Option<End>) -> Encounter<S> {
    Encounter { end, ..encounter }
}

/// Whether two signs differ and neither is zero.
fn opposite(a: Ordering, b: Ordering) -> bool {
    a != Equal && b == a.reverse()
}

fn magnitude<S: Scalar>(value: S, sign: Ordering) -> S {
    if sign == Less { -value } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The disc comes down on the line of the wall by 2^-60 a second, so it gets there
    /// after 16, at 5.4, past the wall's end at 4. The discriminant of that end's circle
    /// is a rounding that is greater than zero.
    #[test]
    fn past_the_far_end() {
        let (from, to) = (Vec2::new(0.0, 0.0), Vec2::new(4.0, 0.0));
        let segment = Segment::new(from, to, to.minus(&from));
        let (radius, fall) = (0.1_f64, 2_f64.powi(-60));
        let (centre, velocity) = (Vec2::new(-1.0, radius.next_up()), Vec2::new(0.4, -fall));
        let end = meet_circle(&centre.minus(&to), &velocity, &radius);
        assert!(end.is_ok_and(|met| met.is_some()));
        let met = meet_segment(&centre, &velocity, &radius, &segment, |_| false);
        assert!(met.is_ok_and(|met| met.is_none()));
    }
}
