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
//!
//! All that a disc can meet lies between the lines. One that starts outside *enters*
//! there, when it crosses its line: at the foot, which is the meeting; or beyond an
//! end, which it then may meet later, unless it is as far as r past that already and
//! only goes further. Numbers that round see the ends from where it enters, not from
//! where it starts: a disc that comes down along a wall passes its far end at a
//! tangent, nearly, and would meet it by rounding while it is beside the interior.

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

/// When a disc of a radius, of which the way is seen from the wall's first end point,
/// meets a wall.
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
    let mut lines = [way.line(Less, touched)?, way.line(Greater, touched)?];
    lines.sort_by_key(|line| line.sign == Less);
    let [own, other] = lines;
    if own.sign == Less {
        return way.meet_between(&[own, other], touched);
    }
    if matches!(own.gap.only_grows(own.zeros), Ok(true)) {
        return Ok(None);
    }
    match way.enter(&own, touched)? {
        Entry::Never => Ok(None),
        Entry::Interior(met) => Ok(Some(met)),
        Entry::Beyond(end, time) => way.meet_beyond(end, time, &other, touched),
    }
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
struct Line<G> {
    gap: G,
    side: Ordering,
    sign: Ordering,
    zeros: usize,
}

/// How a disc gets between the lines of a wall.
enum Entry<S> {
    Never,
    /// It touches the interior.
    Interior(Encounter<S>),
    /// Past this end, after some time.
    Beyond(End, S),
}

impl<S: Scalar, T: Trajectory<S>> Way<'_, S, T> {
    /// What is known of the gap on one side, also by construction where the disc
    /// touches the interior.
    fn line(&self, side: Ordering, touched: Touched) -> Result<Line<T::Line>, S::Doubt> {
        let gap = self.path.component(|power| power.cross(&self.wall.along));
        let gap = if side == Less { gap.negated() } else { gap };
        let gap = gap.raised(&-(self.radius.clone() * &self.wall.length));
        let sign = match touched {
            Touched::Interior { .. } if self.side.sign()? == side => Equal,
            _ => gap.sign(0)?,
        };
        let skims = touched == Touched::Interior { skims: true };
        let zeros = if skims { 2 } else { 1 };
        Ok(Line {
            gap,
            side,
            sign,
            zeros,
        })
    }

    /// How the disc gets between the lines, if it starts on one or outside.
    fn enter(&self, line: &Line<T::Line>, touched: Touched) -> Result<Entry<S>, S::Doubt> {
        let met = match line.sign {
            Greater => line.gap.descent(0)?,
            Equal | Less => line.gap.meet_from_contact(line.zeros)?,
        };
        let Some(met) = met else {
            return Ok(Entry::Never);
        };
        match touched {
            Touched::Interior { .. } if line.sign == Equal && met.overlap => {
                return Ok(Entry::Interior(met));
            }
            // An end point is touched, not the interior.
            Touched::End { end, .. } if met.overlap => return Ok(Entry::Beyond(end, met.delay)),
            _ => {}
        }
        Ok(match self.wall.nearest(&self.path.at(&met.delay))? {
            Nearest::Foot(end) => Entry::Interior(Encounter { end, ..met }),
            Nearest::Beyond(end) => Entry::Beyond(end, met.delay),
        })
    }

    /// What a disc meets that has got between the lines, past an end, at a time.
    fn meet_beyond(&self, end: End, time: S, other: &Line<T::Line>, touched: Touched) -> Met<S> {
        let after = self.path.after(&time);
        if self.goes_on_past(&after, end) {
            return Ok(None);
        }
        let first = self.meet_line(other, touched)?;
        let entry = S::ROUNDS.then_some((after, time));
        self.meet_ends(touched, entry.as_ref(), first)
    }

    /// What a disc meets that starts between the lines.
    fn meet_between(&self, lines: &[Line<T::Line>; 2], touched: Touched) -> Met<S> {
        let nearest = self.wall.nearest(self.path.offset());
        if let Ok(Nearest::Beyond(end)) = nearest
            && self.goes_on_past(self.path, end)
        {
            return Ok(None);
        }
        let [one, other] = lines.each_ref().map(|line| self.meet_line(line, touched));
        self.meet_ends(touched, None, earlier(one?, other?)?)
    }

    /// Whether it is certain that a disc on a path is past an end by its radius, and
    /// never comes back.
    fn goes_on_past(&self, path: &T, end: End) -> bool {
        let along = path.component(|power| power.dot(&self.wall.along));
        let reach = self.radius.clone() * &self.wall.length;
        let gap = match end {
            End::From => along.negated().raised(&-reach),
            End::To => along.raised(&-(reach + &self.wall.length_squared)),
        };
        matches!(gap.sign(0), Ok(Equal | Greater)) && matches!(gap.only_grows(1), Ok(true))
    }

    /// When the disc touches the interior, coming back to a line that it is past.
    fn meet_line(&self, line: &Line<T::Line>, touched: Touched) -> Met<S> {
        let Some(met) = self.descent_from_within(line)? else {
            return Ok(None);
        };
        if matches!(touched, Touched::End { .. }) && met.overlap {
            return Ok(None);
        }
        Ok(match self.wall.nearest(&self.path.at(&met.delay))? {
            Nearest::Foot(end) => Some(Encounter { end, ..met }),
            Nearest::Beyond(_) => None,
        })
    }

    /// When a disc comes back that is nearer to the line than its radius, or on
    /// the other side. If it overlaps the wall, that is now, unless it parts.
    fn descent_from_within(&self, Line { gap, side, .. }: &Line<T::Line>) -> Met<S> {
        let is_here = self.side.sign()? == *side
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

    /// The first of a meeting and those with end points: as seen from where the disc
    /// gets between the lines, if that is given.
    fn meet_ends(
        &self,
        touched: Touched,
        entry: Option<&(T, S)>,
        mut first: Option<Encounter<S>>,
    ) -> Met<S> {
        let ends = [End::From, End::To].into_iter();
        for end in ends.filter(|end| !touched.bars(*end)) {
            let point = self.wall.end(end).minus(&self.wall.from);
            let path = self.path.seen_from(&point);
            let met = match (touched.at(end), entry) {
                (Some(true), _) => circle::leave(&path)?,
                (Some(false), _) => circle::meet_again(&path)?,
                (None, Some((late, time))) => self.meet_late(&late.seen_from(&point), time)?,
                (None, None) => self.meet_end(&path, end, first.as_ref())?,
            };
            first = earlier(first, met.map(|met| met.at(end)))?;
        }
        Ok(first)
    }

    /// When the disc touches an end point, seen from a time on at which it may touch
    /// it at the soonest.
    fn meet_late(&self, path: &T, time: &S) -> Met<S> {
        let met = circle::meet(path, self.radius)?;
        Ok(met.map(|met| match met.overlap {
            true => Encounter::impact(time.clone()),
            false => Encounter {
                delay: met.delay + time,
                ..met
            },
        }))
    }

    /// When the disc touches an end point, if that may be before something else.
    fn meet_end(&self, path: &T, end: End, other: Option<&Encounter<S>>) -> Met<S> {
        let is_later = other.is_some_and(|other| self.is_surely_apart(path, &other.delay));
        if is_later || self.overlaps_beside(path, end)? {
            return Ok(None);
        }
        circle::meet(path, self.radius)
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

#[cfg(test)]
mod tests {
    use super::super::air::{Air, Rate};
    use super::super::medium::{Medium, Vacuum};
    use super::super::number::Falling;
    use super::*;
    use crate::vec2::Vec2;

    const RADIUS: f64 = 0.1;

    fn vector<M>(x: f64, y: f64) -> Vec2<Falling<f64, M>> {
        Vec2::new(Falling::new(x), Falling::new(y))
    }

    /// Whether a disc that falls along a wall meets its far end alone, and the wall.
    fn met_falling<M: Medium<f64>>(pull: f64, drag: &M::Drag) -> [bool; 2] {
        let (from, to) = (vector(0.0, 0.0), vector(0.0, -4.0));
        let wall = Segment::new(from, to, to.minus(&from));
        let centre = vector(RADIUS.next_up(), 1.0);
        let velocity = vector(-2_f64.powi(-60), 0.0);
        let path = M::way(centre, velocity, &vector(0.0, -pull), drag);
        let (radius, barred) = (Falling::new(RADIUS), [false; 2]);
        let end = circle::meet(&path.seen_from(&to), &radius);
        let met = meet(&path, &radius, &wall, Touched::Nothing { barred });
        [end, met].map(|met| met.is_ok_and(|met| met.is_some()))
    }

    /// The disc nears the line of the wall by 2^-60 a second, so it gets there after 16,
    /// but passes the wall's end at 4 after √10, or soon thereafter in air. The distance
    /// from that end comes down to the radius by rounding.
    #[test]
    fn past_the_far_end() {
        assert_eq!(met_falling::<Vacuum>(1.0, &()), [true, false]);
        let [_, met] = met_falling::<Air>(64.0, &Rate(Falling::new(1.0 / 64.0)));
        assert!(!met);
    }
}
