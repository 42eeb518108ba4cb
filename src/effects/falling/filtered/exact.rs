//! When bodies meet of which some fall, decided with whole numbers alone.
//!
//! The formulas are those of [`circle`](super::super::circle) and
//! [`segment`](super::super::segment). A wall's line is met where s² - r² L² comes
//! down to zero, for the side s: on either side no more than once. All times are
//! zeros of polynomials with dyadic coefficients ([`Algebraic`]), and so is what
//! decides whether the interior is touched then: the sign of the foot there.
//!
//! What has collided, and parts, does not approach by construction: if the
//! numbers say so, which happens where the other body moves and is of infinite
//! mass, they move along each other.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::body::{Body, Course, Parted};
use super::parabola::{Parabola, Quadratic};
use crate::detect::End;
use crate::effects::falling::segment::Touched;
use crate::filtered::Line;
use crate::roots::algebraic::Algebraic;
use crate::roots::{Descent, Polynomial};
use crate::scalar::Dyadic;

/// A meeting, and the end point of a wall that is touched.
#[derive(Clone, Debug)]
pub(super) struct Meeting {
    pub(super) delay: Delay,
    pub(super) end: Option<End>,
}

/// When bodies meet.
#[derive(Clone, Debug)]
pub(super) enum Delay {
    /// They touch and approach.
    Now,
    /// They overlap and approach.
    Inside,
    /// They touch, and are pressed together.
    Rest,
    After(Algebraic),
    /// The same, in tangency.
    Graze(Algebraic),
}

impl Delay {
    /// How long it is, if not nothing.
    pub(super) fn time(&self) -> Option<&Algebraic> {
        match self {
            Self::Now | Self::Inside | Self::Rest => None,
            Self::After(time) | Self::Graze(time) => Some(time),
        }
    }

    fn order(&self, other: &Self) -> Ordering {
        match (self.time(), other.time()) {
            (Some(one), Some(other)) => one.order(other),
            (one, other) => one.is_some().cmp(&other.is_some()),
        }
    }
}

impl From<Descent<Algebraic>> for Delay {
    fn from(descent: Descent<Algebraic>) -> Self {
        match descent.graze {
            true => Self::Graze(descent.time),
            false => Self::After(descent.time),
        }
    }
}

impl Meeting {
    fn of(delay: Delay) -> Self {
        Self { delay, end: None }
    }

    fn at(end: End) -> impl Fn(Delay) -> Self {
        move |delay| Self {
            delay,
            end: Some(end),
        }
    }
}

/// Where a course leads to, and when, counted from its start.
pub(super) fn meeting(course: &Course) -> Option<Meeting> {
    match course {
        Course::Known => None,
        Course::Discs { pair, parted } => discs(pair, *parted).map(Meeting::of),
        Course::Wall(disc, line, touched) => wall(disc, line, *touched),
        Course::Leaving(disc, line) => leave_wall(disc, line),
    }
}

fn discs(pair: &[Body; 2], parted: Parted) -> Option<Delay> {
    let [one, other] = pair.each_ref().map(|disc| Dyadic::from_f64(disc.radius));
    let gap = Parabola::between(pair).gap(&one.add(&other));
    match parted {
        Parted::No => meet(&gap),
        Parted::Yes => meet_again(&gap),
        Parted::Skimming => leave(&gap),
    }
}

fn meet(gap: &Polynomial<Dyadic>) -> Option<Delay> {
    let [constant, linear, ..] = &gap.0;
    match (constant.sign(), linear.sign()) {
        (Greater, _) => descent(gap),
        (Less, Less) => Some(Delay::Inside),
        (Equal, Less) => Some(Delay::Now),
        _ => meet_again(gap),
    }
}

/// The same for what touches by construction, or overlaps, and does not approach.
fn meet_again(gap: &Polynomial<Dyadic>) -> Option<Delay> {
    match gap.0[1].sign() {
        Greater => descent(&divided(gap, 1)),
        Less | Equal => leave(gap),
    }
}

/// The same for what moves in tangency at first.
fn leave(gap: &Polynomial<Dyadic>) -> Option<Delay> {
    let [_, _, square, cube, _] = &gap.0;
    match (square.sign(), cube.sign()) {
        (Less, _) | (Equal, Less) => Some(Delay::Rest),
        (Greater, _) => descent(&divided(gap, 2)),
        (Equal, Greater) => descent(&divided(gap, 3)),
        (Equal, Equal) => None,
    }
}

/// What a gap is without its first terms, divided by a power of the time.
pub(super) fn divided(gap: &Polynomial<Dyadic>, power: usize) -> Polynomial<Dyadic> {
    let coefficient = |place: usize| gap.0.get(place + power).cloned();
    Polynomial(std::array::from_fn(|place| {
        coefficient(place).unwrap_or_else(Dyadic::zero)
    }))
}

fn descent(f: &Polynomial<Dyadic>) -> Option<Delay> {
    Algebraic::first_descent(f).map(Delay::from)
}

/// The first of two meetings.
fn earlier(one: Option<Meeting>, other: Option<Meeting>) -> Option<Meeting> {
    match (one, other) {
        (Some(one), Some(other)) => Some(match other.delay.order(&one.delay) {
            Less => other,
            Equal | Greater => one,
        }),
        (one, other) => one.or(other),
    }
}

fn wall(disc: &Body, line: &Line, touched: Touched) -> Option<Meeting> {
    let way = Way::new(disc, line, touched);
    let sides = [Less, Greater];
    if sides.into_iter().any(|side| way.parts_for_good(side)) {
        return None;
    }
    let sides = sides.map(|side| way.meet_line(side));
    let ends = [End::From, End::To].into_iter();
    let ends = ends.filter(|end| !touched.bars(*end));
    let ends = ends.map(|end| way.meet_end(end).map(Meeting::at(end)));
    sides.into_iter().chain(ends).fold(None, earlier)
}

/// A disc's way, seen from a wall.
struct Way<'a> {
    disc: &'a Body,
    line: &'a Line,
    touched: Touched,
    side: Quadratic,
    foot: Quadratic,
    length_squared: Dyadic,
    radius: Dyadic,
    /// When the disc comes to the line from either side.
    entries: Vec<Descent<Algebraic>>,
}

impl<'a> Way<'a> {
    fn new(disc: &'a Body, line: &'a Line, touched: Touched) -> Self {
        let (side, foot) = sides(disc, line);
        let (length_squared, radius) = (line.along().squared(), Dyadic::from_f64(disc.radius));
        let reach_squared = radius.mul(&radius).mul(&length_squared);
        Self {
            disc,
            line,
            touched,
            entries: Algebraic::descents(&side.squared_above(&reach_squared)),
            side,
            foot,
            length_squared,
            radius,
        }
    }

    /// When the disc, coming from one side, touches the interior.
    fn meet_line(&self, side: Ordering) -> Option<Meeting> {
        let state = self.state(side);
        let delay = match state {
            Greater => self.entry(side),
            Equal => self.after_contact(side),
            Less => self.after_overlap(side),
        }?;
        match (self.touched, delay.time()) {
            (Touched::Interior { .. }, None) if state == Equal => {
                return Some(Meeting::of(delay));
            }
            // An end point is touched, not the interior.
            (Touched::End { .. }, None) => return None,
            _ => {}
        }
        match self.nearest(&delay) {
            Foot::At(end) => Some(Meeting { delay, end }),
            Foot::Beyond(_) => None,
        }
    }

    /// Whether the disc is on one side, and never comes nearer to the line: so it
    /// does not meet the end points either.
    fn parts_for_good(&self, side: Ordering) -> bool {
        let [_, speed, bend] = self.gap(side).0.map(|number| number.sign());
        self.state(side) != Less && speed != Less && bend != Less
    }

    /// The distance from the line on one side, times the wall's length.
    fn gap(&self, side: Ordering) -> Quadratic {
        let mut gap = self.side.on(side);
        if matches!(self.touched, Touched::Interior { skims: true }) {
            gap.0[1] = Dyadic::zero();
        }
        gap
    }

    /// The order of the distance from the line on one side against the radius.
    fn state(&self, side: Ordering) -> Ordering {
        let start = &self.side.0[0];
        if start.sign() != side {
            return Less;
        }
        if matches!(self.touched, Touched::Interior { .. }) {
            return Equal;
        }
        let reach_squared = self.radius.mul(&self.radius).mul(&self.length_squared);
        start.mul(start).compare(&reach_squared)
    }

    /// When the disc comes to the line from one side.
    fn entry(&self, side: Ordering) -> Option<Delay> {
        let polynomial = self.side.polynomial();
        let is_there = |entry: &&Descent<Algebraic>| entry.time.sign_of(&polynomial) == side;
        self.entries.iter().find(is_there).cloned().map(Delay::from)
    }

    fn after_contact(&self, side: Ordering) -> Option<Delay> {
        fall_from_contact(&self.gap(side))
    }

    /// When a disc comes back that is nearer to the line than its radius, or on
    /// the other side. If it overlaps the wall, that is now, unless it parts.
    fn after_overlap(&self, side: Ordering) -> Option<Delay> {
        let is_here = self.side.0[0].sign() == side && matches!(self.nearest_now(), Foot::At(_));
        if is_here && self.side.on(side).0[1].sign() == Less {
            return Some(Delay::Inside);
        }
        let back = self.entry(side);
        if is_here && back.is_none() {
            return self.after_contact(side);
        }
        back
    }

    /// When the disc touches an end point.
    fn meet_end(&self, end: End) -> Option<Delay> {
        let gap = end_gap(self.disc, self.line, end, &self.radius);
        match self.touched {
            Touched::End { end: at, skims } if at == end => match skims {
                true => leave(&gap),
                false => meet_again(&gap),
            },
            _ if self.overlaps_beside(&gap, end) => None,
            _ => meet(&gap),
        }
    }

    /// Whether the disc overlaps the end point, but the interior is nearer.
    fn overlaps_beside(&self, gap: &Polynomial<Dyadic>, end: End) -> bool {
        gap.0[0].sign() != Greater && !matches!(self.nearest_now(), Foot::Beyond(at) if at == end)
    }

    fn nearest_now(&self) -> Foot {
        let [from_start, to_end] = self.places();
        foot_of(from_start.0[0].sign(), || to_end.0[0].sign())
    }

    /// What of the wall is opposite the disc after a delay.
    fn nearest(&self, delay: &Delay) -> Foot {
        let Some(time) = delay.time() else {
            return self.nearest_now();
        };
        let [from_start, to_end] = self.places();
        let sign = |place: &Quadratic| time.sign_of(&place.polynomial());
        foot_of(sign(&from_start), || sign(&to_end))
    }

    /// How far the foot is from the start, and how far to the end.
    fn places(&self) -> [Quadratic; 2] {
        let foot = self.foot.clone();
        [foot.clone(), foot.below(&self.length_squared)]
    }
}

/// Where the perpendicular from a point meets the line of a wall.
enum Foot {
    /// On the wall, possibly exactly at an end point.
    At(Option<End>),
    Beyond(End),
}

/// From the signs of the distances from the start, and to the end.
fn foot_of(from_start: Ordering, to_end: impl FnOnce() -> Ordering) -> Foot {
    match from_start {
        Less => Foot::Beyond(End::From),
        Equal => Foot::At(Some(End::From)),
        Greater => match to_end() {
            Less => Foot::Beyond(End::To),
            Equal => Foot::At(Some(End::To)),
            Greater => Foot::At(None),
        },
    }
}

/// A disc's way across and along a wall.
pub(super) fn sides(disc: &Body, line: &Line) -> (Quadratic, Quadratic) {
    let way = Parabola::of(disc).seen_from(line.from);
    (way.side(line), way.foot(line))
}

/// The gap between a disc and an end point.
pub(super) fn end_gap(disc: &Body, line: &Line, end: End, radius: &Dyadic) -> Polynomial<Dyadic> {
    Parabola::of(disc).seen_from(line.end(end)).gap(radius)
}

/// How far a disc is from the end of a wall, along it and times its length.
pub(super) fn place(disc: &Body, line: &Line, end: End) -> Quadratic {
    let (_, foot) = sides(disc, line);
    match end {
        End::From => foot,
        End::To => foot.below(&line.along().squared()),
    }
}

fn leave_wall(disc: &Body, line: &Line) -> Option<Meeting> {
    let falls = [End::To, End::From].map(|end| fall(&place(disc, line, end)).map(Meeting::at(end)));
    falls.into_iter().fold(None, earlier)
}

/// When what is not below zero gets there.
fn fall(place: &Quadratic) -> Option<Delay> {
    let delay = match place.0[0].sign() {
        Greater => descent(&place.polynomial()),
        Less | Equal => fall_from_contact(place),
    };
    delay.filter(|delay| !matches!(delay, Delay::Graze(_)))
}

/// When what is at zero, and does not fall, comes back to zero.
fn fall_from_contact(place: &Quadratic) -> Option<Delay> {
    let [_, speed, bends] = &place.0;
    match (speed.sign(), bends.sign()) {
        (Less, _) => Some(Delay::Now),
        (Equal, Less) => Some(Delay::Rest),
        (Greater, Less) => descent(&place.divided()),
        (_, Equal | Greater) => None,
    }
}
