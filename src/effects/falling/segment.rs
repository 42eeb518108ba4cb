//! A disc on a parabola that meets a wall.
//!
//! With q the centre from the wall's first end point, u along the wall and L its
//! length, the side h = q × u is a quadratic in time. The wall's lines are met
//! from outside where σ h - r L falls to zero, for σ = 1 and σ = -1: at most once
//! each, for a quadratic a t² + b t + c descends at no more than one of its roots,
//! (-b - √D) / 2a. If then the foot of the perpendicular is between the end
//! points, the interior is touched. The end points are met as circles are. The
//! first of all these is the meeting: the points no further than r from a segment
//! are convex, so that a line is crossed at the foot, and a circle beyond it,
//! before anything else is.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::arc::Arc;
use super::circle;
use crate::detect::{Encounter, End, Nearest, Segment};
use crate::roots::Roots;
use crate::scalar::Scalar;
use crate::vec2::Vec2;

type Met<S> = Result<Option<Encounter<S>>, <S as Scalar>::Doubt>;

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
pub(super) fn meet<S: Roots>(
    arc: &Arc<S>,
    radius: &S,
    wall: &Segment<S>,
    touched: Touched,
) -> Met<S> {
    let way = Way::new(arc, radius, wall);
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
pub(super) fn leave<S: Roots>(arc: &Arc<S>, wall: &Segment<S>) -> Met<S> {
    let [c, b, a] = arc.powers().map(|power| power.dot(&wall.along));
    let left = Gap {
        a: -a.clone(),
        b: -b.clone(),
        c: wall.length_squared.clone() - &c,
    };
    let mut first = None;
    for (end, gap) in [(End::To, left), (End::From, Gap { a, b, c })] {
        let met = gap.fall()?.map(|met| met.at(end));
        first = earlier(first, met)?;
    }
    Ok(first.map(|met| Encounter { rest: true, ..met }))
}

/// How long a disc, seen the same way, bounces on a wall that it has just hit, if
/// each impact leaves so much of its speed.
pub(super) fn bouncing<S: Scalar>(arc: &Arc<S>, wall: &Segment<S>, kept: &S) -> Option<S> {
    let [_, b, a] = arc.powers().map(|power| power.cross(&wall.along));
    let falls = matches!(
        (a.sign(), b.sign()),
        (Ok(Less), Ok(Greater)) | (Ok(Greater), Ok(Less))
    );
    let flown = -b / a;
    falls.then(|| flown / (S::from_integer(1) - kept))
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
struct Way<'a, S> {
    arc: &'a Arc<S>,
    radius: &'a S,
    wall: &'a Segment<S>,
    /// The coefficients of the side, the constant first.
    side: [S; 3],
}

/// The distance from a line on one of its sides, less the radius, all times the
/// wall's length: a t² + b t + c.
struct Gap<S> {
    a: S,
    b: S,
    c: S,
}

impl<'a, S: Roots> Way<'a, S> {
    fn new(arc: &'a Arc<S>, radius: &'a S, wall: &'a Segment<S>) -> Self {
        let across = |vector: &Vec2<S>| vector.cross(&wall.along);
        Self {
            side: arc.powers().map(across),
            arc,
            radius,
            wall,
        }
    }

    fn gap(&self, side: Ordering) -> Gap<S> {
        let [c, b, a] = self.side.clone().map(|number| match side {
            Less => -number,
            Equal | Greater => number,
        });
        let reach = self.radius.clone() * &self.wall.length;
        Gap { a, b, c: c - reach }
    }

    /// The gap on one side, and its sign: with what of them is known where the disc
    /// touches the interior.
    fn gap_known(&self, side: Ordering, touched: Touched) -> Result<(Gap<S>, Ordering), S::Doubt> {
        let gap = match touched {
            Touched::Interior { skims: true } => self.gap(side).turning(),
            _ => self.gap(side),
        };
        let sign = match touched {
            Touched::Interior { .. } if self.side[0].sign()? == side => Equal,
            _ => gap.c.sign()?,
        };
        Ok((gap, sign))
    }

    /// Whether the disc is on one side, and never comes nearer to the line: so it
    /// does not meet the end points either.
    fn parts_for_good(&self, side: Ordering, touched: Touched) -> Result<bool, S::Doubt> {
        let (gap, sign) = self.gap_known(side, touched)?;
        Ok(sign != Less && gap.b.sign()? != Less && gap.a.sign()? != Less)
    }

    /// When the disc, coming from one side, touches the interior.
    fn meet_line(&self, side: Ordering, touched: Touched) -> Met<S> {
        let (gap, sign) = self.gap_known(side, touched)?;
        let met = match sign {
            Greater => gap.descent()?,
            Equal => gap.descent_from_contact()?,
            Less => self.descent_from_within(&gap, side)?,
        };
        let Some(met) = met else { return Ok(None) };
        match touched {
            Touched::Interior { .. } if sign == Equal && met.overlap => return Ok(Some(met)),
            // An end point is touched, not the interior.
            Touched::End { .. } if met.overlap => return Ok(None),
            _ => {}
        }
        Ok(match self.wall.nearest(&self.arc.at(&met.delay))? {
            Nearest::Foot(end) => Some(Encounter { end, ..met }),
            Nearest::Beyond(_) => None,
        })
    }

    /// When a disc comes back that is nearer to the line than its radius, or on
    /// the other side. If it overlaps the wall, that is now, unless it parts.
    fn descent_from_within(&self, gap: &Gap<S>, side: Ordering) -> Met<S> {
        let is_here = self.side[0].sign()? == side
            && matches!(self.wall.nearest(&self.arc.offset)?, Nearest::Foot(_));
        if is_here && gap.b.sign()? == Less {
            return Ok(Some(Encounter::inside()));
        }
        let back = gap.descent_after_ascent()?;
        if is_here && back.is_none() {
            return gap.descent_from_contact();
        }
        Ok(back)
    }

    /// When the disc touches an end point, if that may be before something else.
    fn meet_end(&self, end: End, touched: Option<bool>, other: Option<&Encounter<S>>) -> Met<S> {
        let point = self.wall.end(end).minus(&self.wall.from);
        let arc = self.arc.seen_from(&point);
        let is_later = other.is_some_and(|other| self.is_surely_apart(&arc, &other.delay));
        let met = match touched {
            Some(true) => circle::leave(&arc)?,
            Some(false) => circle::meet_again(&arc)?,
            None if is_later || self.overlaps_beside(&arc, end)? => None,
            None => circle::meet(&arc, self.radius)?,
        };
        Ok(met.map(|met| met.at(end)))
    }

    /// Whether the disc overlaps the end point, but the interior is nearer.
    fn overlaps_beside(&self, arc: &Arc<S>, end: End) -> Result<bool, S::Doubt> {
        let gap = S::power(&arc.offset.x, &arc.offset.y, self.radius);
        if matches!(gap.sign(), Ok(Greater)) {
            return Ok(false);
        }
        let nearest = self.wall.nearest(&self.arc.offset)?;
        Ok(!matches!(nearest, Nearest::Beyond(beyond) if beyond == end))
    }

    /// Whether it is certain that the disc does not get to a point before some
    /// time: |d| > r + |v| t + |h| t².
    fn is_surely_apart(&self, arc: &Arc<S>, time: &S) -> bool {
        let length = |vector: &Vec2<S>| {
            let [x, y] = [vector.x.hull(), vector.y.hull()];
            (x.square() + y.square()).sqrt()
        };
        let time = time.hull();
        let way = length(&arc.velocity) * time + length(&arc.half_pull) * time.square();
        length(&arc.offset).lo() > (self.radius.hull() + way).hi()
    }
}

impl<S: Scalar> Gap<S> {
    /// The gap of a disc that neither approaches nor parts at first.
    fn turning(self) -> Self {
        let b = S::from_integer(0);
        Self { b, ..self }
    }

    /// When what is above zero comes to zero.
    fn descent(&self) -> Met<S> {
        let bends = self.a.sign()?;
        if bends != Less && self.b.sign()? != Less {
            return Ok(None);
        }
        let discriminant = self.discriminant();
        match discriminant.sign()? {
            Less => return Ok(None),
            Equal => return Ok(Some(Encounter::graze(self.turn()))),
            Greater => {}
        }
        let root = discriminant.sqrt();
        Ok(Some(Encounter::impact(if self.b.to_f64() > 0.0 {
            self.late_root(root)
        } else {
            S::from_integer(2) * &self.c / (root - &self.b)
        })))
    }

    /// When what is at zero, and does not fall, comes back to zero.
    fn descent_from_contact(&self) -> Met<S> {
        let (speed, bends) = (self.b.sign()?, self.a.sign()?);
        Ok(match (speed, bends) {
            (Less, _) => Some(Encounter::now()),
            (Equal, Less) => Some(Encounter::rest()),
            (Greater, Less) => Some(Encounter::impact(self.b.clone() / -self.a.clone())),
            (_, Equal | Greater) => None,
        })
    }

    /// When what is below zero comes down to zero, from above.
    fn descent_after_ascent(&self) -> Met<S> {
        if self.a.sign()? != Less || self.b.sign()? != Greater {
            return Ok(None);
        }
        let discriminant = self.discriminant();
        Ok(match discriminant.sign()? {
            Greater => Some(Encounter::impact(self.late_root(discriminant.sqrt()))),
            Less | Equal => None,
        })
    }

    /// When what is not below zero gets there.
    fn fall(&self) -> Met<S> {
        let met = match self.c.sign()? {
            Greater => self.descent()?,
            Less | Equal => self.descent_from_contact()?,
        };
        Ok(met.filter(|met| !met.graze))
    }

    /// b² - 4 a c.
    fn discriminant(&self) -> S {
        let four = S::from_integer(4) * &self.a;
        S::difference_of_products(&self.b, &self.b, &four, &self.c)
    }

    /// When it is least, or greatest.
    fn turn(&self) -> S {
        -self.b.clone() / (S::from_integer(2) * &self.a)
    }

    /// The later root of a quadratic that bends down.
    fn late_root(&self, root: S) -> S {
        (root + &self.b) / (S::from_integer(-2) * &self.a)
    }
}
