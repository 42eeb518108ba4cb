//! A disc that falls and meets a wall.
//!
//! With q the centre from the wall's first end point, u along the wall and L its
//! length, the side is h = q × u. The wall's lines are met from outside where
//! σ h - r L falls to zero, for σ = 1 and σ = -1: at most once each, for the
//! acceleration across a line has the same sign all the time. (In a vacuum the
//! side is a quadratic a t² + b t + c, which descends at no more than one of its
//! roots, (-b - √D) / 2a.) If then the foot of the perpendicular is between the end
//! points, the interior is touched. The end points are met as circles are. The
//! first of all these is the meeting: the points no further than r from a segment
//! are convex, so that a line is crossed at the foot, and a circle beyond it,
//! before anything else is.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::circle;
use super::gap::{Gap, LineGap, Met};
use super::trajectory::{Trajectory, length};
use crate::detect::{Encounter, End, Nearest, Segment};
use crate::scalar::Scalar;

/// What of a wall a disc touches by construction, and does not approach.
/// Where the disc `skims` it, it moves at a right angle to the normal. A disc that
/// touches nothing is known not to meet the end points that are `barred`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Touched {
    Nothing { barred: [bool; 2] },
    Interior { skims: bool },
    End { end: End, skims: bool },
}

impl Touched {
    /// The interior or an end point, which the disc may skim.
    pub(super) fn of(end: Option<End>, skims: bool) -> Self {
        match end {
            Some(end) => Self::End { end, skims },
            None => Self::Interior { skims },
        }
    }

    /// Whether an end point is known not to be met.
    pub(super) fn bars(self, end: End) -> bool {
        matches!(self, Self::Nothing { barred } if barred[end as usize])
    }

    /// Whether it is an end point, and if so whether the disc skims it.
    fn at(self, point: End) -> Option<bool> {
        match self {
            Self::End { end, skims } if end == point => Some(skims),
            _ => None,
        }
    }
}

/// When a disc, of which the way is seen from the wall's first end point, meets
/// a wall.
pub(super) fn meet<S: Scalar, T: Trajectory<S>>(
    path: &T,
    radius: &S,
    wall: &Segment<S>,
    touched: Touched,
) -> Met<S> {
    let way = Way {
        path,
        radius,
        wall,
        side: path.offset().cross(&wall.along),
    };
    let sides = [Less, Greater];
    for side in sides {
        if way.parts_for_good(side, touched)? {
            return Ok(None);
        }
    }
    let mut first = None;
    for side in sides {
        let met = way.meet_line(side, touched)?;
        first = earlier(first, met)?;
    }
    for end in [End::From, End::To]
        .into_iter()
        .filter(|end| !touched.bars(*end))
    {
        let met = way.meet_end(end, touched.at(end), first.as_ref())?;
        first = earlier(first, met)?;
    }
    Ok(first)
}

/// When a disc, seen the same way, gets to the end of a wall along which it moves.
pub(super) fn leave<S: Scalar>(path: &impl Trajectory<S>, wall: &Segment<S>) -> Met<S> {
    let gone = || path.component(|power| power.dot(&wall.along));
    let left = gone().negated().raised(&wall.length_squared);
    let mut first = None;
    for (end, gap) in [(End::To, left), (End::From, gone())] {
        let met = fall(&gap)?.map(|met| met.at(end));
        first = earlier(first, met)?;
    }
    Ok(first.map(|met| Encounter { rest: true, ..met }))
}

/// When what is not below zero gets there.
fn fall<S: Scalar>(gap: &impl Gap<S>) -> Met<S> {
    let met = match gap.sign(0)? {
        Greater => gap.descent(0)?,
        Less | Equal => gap.meet_from_contact(1)?,
    };
    Ok(met.filter(|met| !met.graze))
}

/// The first of two meetings.
fn earlier<S: Scalar>(one: Option<Encounter<S>>, other: Option<Encounter<S>>) -> Met<S> {
    Ok(match (one, other) {
        (Some(one), Some(other)) => match other.delay.compare(&one.delay)? {
            Less => Some(other),
            Equal | Greater => Some(one),
        },
        (one, other) => one.or(other),
    })
}

/// A disc's way, seen from a wall.
struct Way<'a, S, T> {
    path: &'a T,
    radius: &'a S,
    wall: &'a Segment<S>,
    /// On which side it starts, and how far from the line, times the length.
    side: S,
}

/// The gap on one side of a wall at the start, times the wall's length: its sign,
/// and how many derivatives are known to be zero if it is.
struct Known<G> {
    gap: G,
    sign: Ordering,
    zeros: usize,
}

impl<S: Scalar, T: Trajectory<S>> Way<'_, S, T> {
    /// What is known of the gap on one side, also by construction where the disc
    /// touches the interior.
    fn gap(&self, side: Ordering, touched: Touched) -> Result<Known<T::Line>, S::Doubt> {
        let gap = self.path.component(|power| power.cross(&self.wall.along));
        let gap = if side == Less { gap.negated() } else { gap };
        let gap = gap.raised(&-(self.radius.clone() * &self.wall.length));
        let sign = match touched {
            Touched::Interior { .. } if self.side.sign()? == side => Equal,
            _ => gap.sign(0)?,
        };
        let skims = touched == Touched::Interior { skims: true };
        let zeros = if skims { 2 } else { 1 };
        Ok(Known { gap, sign, zeros })
    }

    /// Whether the disc is on one side, and never comes nearer to the line: so it
    /// does not meet the end points either.
    fn parts_for_good(&self, side: Ordering, touched: Touched) -> Result<bool, S::Doubt> {
        let Known { gap, sign, zeros } = self.gap(side, touched)?;
        Ok(sign != Less && gap.only_grows(zeros)?)
    }

    /// When the disc, coming from one side, touches the interior.
    fn meet_line(&self, side: Ordering, touched: Touched) -> Met<S> {
        let Known { gap, sign, zeros } = self.gap(side, touched)?;
        let met = match sign {
            Greater => gap.descent(0)?,
            Equal => gap.meet_from_contact(zeros)?,
            Less => self.descent_from_within(&gap, side)?,
        };
        let Some(met) = met else { return Ok(None) };
        match touched {
            Touched::Interior { .. } if sign == Equal && met.overlap => return Ok(Some(met)),
            // An end point is touched, not the interior.
            Touched::End { .. } if met.overlap => return Ok(None),
            _ => {}
        }
        Ok(match self.wall.nearest(&self.path.at(&met.delay))? {
            Nearest::Foot(end) => Some(Encounter { end, ..met }),
            Nearest::Beyond(_) => None,
        })
    }

    /// When a disc comes back that is nearer to the line than its radius, or on
    /// the other side. If it overlaps the wall, that is now, unless it parts.
    fn descent_from_within(&self, gap: &T::Line, side: Ordering) -> Met<S> {
        let is_here = self.side.sign()? == side
            && matches!(self.wall.nearest(self.path.offset())?, Nearest::Foot(_));
        if is_here && gap.sign(1)? == Less {
            return Ok(Some(Encounter::inside()));
        }
        let back = gap.descent(0)?;
        if is_here && back.is_none() {
            return gap.meet_from_contact(1);
        }
        Ok(back)
    }

    /// When the disc touches an end point, if that may be before something else.
    fn meet_end(&self, end: End, touched: Option<bool>, other: Option<&Encounter<S>>) -> Met<S> {
        let point = self.wall.end(end).minus(&self.wall.from);
        let path = self.path.seen_from(&point);
        let is_later = other.is_some_and(|other| self.is_surely_apart(&path, &other.delay));
        let met = match touched {
            Some(true) => circle::leave(&path)?,
            Some(false) => circle::meet_again(&path)?,
            None if is_later || self.overlaps_beside(&path, end)? => None,
            None => circle::meet(&path, self.radius)?,
        };
        Ok(met.map(|met| met.at(end)))
    }

    /// Whether the disc overlaps the end point, but the interior is nearer.
    fn overlaps_beside(&self, path: &T, end: End) -> Result<bool, S::Doubt> {
        let gap = S::power(&path.offset().x, &path.offset().y, self.radius);
        if matches!(gap.sign(), Ok(Greater)) {
            return Ok(false);
        }
        let nearest = self.wall.nearest(self.path.offset())?;
        Ok(!matches!(nearest, Nearest::Beyond(beyond) if beyond == end))
    }

    /// Whether it is certain that the disc does not get to a point before some
    /// time.
    fn is_surely_apart(&self, path: &T, time: &S) -> bool {
        let range = path.range(time.hull());
        length(path.offset()).lo() > (self.radius.hull() + range).hi()
    }
}
