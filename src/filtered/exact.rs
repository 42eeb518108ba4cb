//! When bodies meet, decided with whole numbers alone.
//!
//! The formulas are those of [`detect`](crate::detect): with the discriminant
//! D = (v·v) R² - (d × v)² two discs meet after (-d·v - √D) / (v·v), and a disc
//! meets a wall's line after (|h| - r √(u·u)) / |v × u|. Both are [`Surd`]s.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::course::{Course, Line, Ray};
use super::plane::Point;
use super::surd::{Surd, sign_of_root};
use crate::detect::End;
use crate::scalar::Dyadic;

/// When two bodies meet.
#[derive(Clone, Debug)]
pub(super) enum Meeting {
    Never,
    /// They touch or overlap, and approach.
    Now {
        /// Whether they overlap.
        inside: bool,
    },
    /// In tangency.
    Graze(Surd),
    At(Surd),
}

/// What of a wall is met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// The interior, or exactly where the perpendicular from an end is.
    Interior(Option<End>),
    /// An end point, by the circle about it.
    End(End),
}

impl Part {
    /// The end point by whose circle the part is met.
    pub(super) fn circle(self) -> Option<End> {
        match self {
            Self::Interior(_) => None,
            Self::End(end) => Some(end),
        }
    }

    /// The end point that is touched.
    pub(super) fn end(self) -> Option<End> {
        match self {
            Self::Interior(end) => end,
            Self::End(end) => Some(end),
        }
    }
}

impl Meeting {
    /// The same, counted from a time.
    fn since(self, time: f64) -> Self {
        let start = Dyadic::from_f64(time);
        match self {
            Self::Graze(delay) => Self::Graze(delay.plus(&start)),
            Self::At(delay) => Self::At(delay.plus(&start)),
            other => other,
        }
    }
}

/// When two discs meet, of which the second one is known since the later time.
pub(super) fn discs([early, late]: &[Ray; 2]) -> Meeting {
    let offset = Point::new(late.position).minus(&early.at(late.since));
    let velocity = Point::new(late.velocity).minus(&Point::new(early.velocity));
    let reach = Dyadic::from_f64(early.radius).add(&Dyadic::from_f64(late.radius));
    circle(&offset, &velocity, &reach).since(late.since)
}

/// When a disc meets a point.
pub(super) fn point(disc: &Ray, point: [f64; 2]) -> Meeting {
    let offset = Point::new(disc.position).minus(&Point::new(point));
    let velocity = Point::new(disc.velocity);
    circle(&offset, &velocity, &Dyadic::from_f64(disc.radius)).since(disc.since)
}

fn circle(offset: &Point, velocity: &Point, reach: &Dyadic) -> Meeting {
    let approach = offset.dot(velocity);
    if approach.sign() != Less {
        return Meeting::Never;
    }
    match offset.compare_length(reach) {
        Less => return Meeting::Now { inside: true },
        Equal => return Meeting::Now { inside: false },
        Greater => {}
    }
    let (divisor, moment) = (velocity.squared(), offset.cross(velocity));
    let strength = divisor.mul(reach).mul(reach);
    let radicand = strength.sub(&moment.mul(&moment));
    let sign = radicand.sign();
    let delay = Surd {
        rational: -approach,
        factor: Dyadic::from(-1),
        radicand,
        divisor,
    };
    match sign {
        Less => Meeting::Never,
        Equal => Meeting::Graze(delay),
        Greater => Meeting::At(delay),
    }
}

/// When a disc meets a wall, but for the end points that are `barred`, and what
/// of the wall.
pub(super) fn wall(disc: &Ray, line: &Line, barred: impl Fn(End) -> bool) -> (Meeting, Part) {
    let way = Way::new(disc, line);
    let meet_end = |end| {
        let meeting = if barred(end) {
            Meeting::Never
        } else {
            point(disc, line.end(end))
        };
        (meeting, Part::End(end))
    };
    if way.gap == Less {
        return match way.nearest_now() {
            Foot::At(end) if way.approaches => (Meeting::Now { inside: true }, Part::Interior(end)),
            Foot::At(end) => (Meeting::Never, Part::Interior(end)),
            Foot::Beyond(end) => meet_end(end),
        };
    }
    if !way.approaches {
        return (Meeting::Never, Part::Interior(None));
    }
    let delay = way.delay();
    match way.nearest_after(&delay) {
        Foot::At(end) if way.gap == Equal => (Meeting::Now { inside: false }, Part::Interior(end)),
        Foot::At(end) => (Meeting::At(delay).since(disc.since), Part::Interior(end)),
        Foot::Beyond(end) => meet_end(end),
    }
}

/// What of a wall a disc overlaps.
pub(super) fn overlap(disc: &Ray, line: &Line) -> Option<Part> {
    let way = Way::new(disc, line);
    if way.gap != Less {
        return None;
    }
    match way.nearest_now() {
        Foot::At(end) => Some(Part::Interior(end)),
        Foot::Beyond(end) => {
            let offset = Point::new(disc.position).minus(&Point::new(line.end(end)));
            let order = offset.compare_length(&Dyadic::from_f64(disc.radius));
            (order == Less).then_some(Part::End(end))
        }
    }
}

/// Whether a disc moves towards the line of a wall.
pub(super) fn approaches(disc: &Ray, line: &Line) -> bool {
    Way::new(disc, line).approaches
}

/// The time of a meeting that is known to come.
pub(super) fn time(course: &Course) -> Option<Surd> {
    match course {
        Course::Known => None,
        Course::Discs(pair) => discs(pair).time(),
        Course::Point(disc, place) => point(disc, *place).time(),
        Course::Wall(disc, line) => {
            let delay = Way::new(disc, line).delay();
            Some(delay.plus(&Dyadic::from_f64(disc.since)))
        }
    }
}

impl Meeting {
    fn time(self) -> Option<Surd> {
        match self {
            Self::Never | Self::Now { .. } => None,
            Self::Graze(time) | Self::At(time) => Some(time),
        }
    }
}

/// A disc's way towards the line of a wall.
struct Way {
    /// The disc's centre from the wall's first end point.
    offset: Point,
    velocity: Point,
    along: Point,
    /// The distance from the line, and how fast it falls, both times the
    /// wall's length.
    distance: Dyadic,
    closing: Dyadic,
    /// The square of the radius times the length.
    reach_squared: Dyadic,
    /// The order of the distance against the radius.
    gap: Ordering,
    approaches: bool,
}

/// Where the perpendicular from a point meets the line of a wall.
enum Foot {
    /// On the wall, possibly exactly at an end point.
    At(Option<End>),
    Beyond(End),
}

impl Way {
    fn new(disc: &Ray, line: &Line) -> Self {
        let offset = Point::new(disc.position).minus(&Point::new(line.from));
        let velocity = Point::new(disc.velocity);
        let along = line.along();
        let radius = Dyadic::from_f64(disc.radius);
        let reach_squared = radius.mul(&radius).mul(&along.squared());
        let (side, drift) = (offset.cross(&along), velocity.cross(&along));
        let (distance, closing) = if side.sign() == Less {
            (-side, drift)
        } else {
            (side, -drift)
        };
        Self {
            gap: distance.mul(&distance).compare(&reach_squared),
            approaches: !distance.is_zero() && closing.sign() == Greater,
            offset,
            velocity,
            along,
            distance,
            closing,
            reach_squared,
        }
    }

    /// The time until the disc touches the line, which it approaches.
    fn delay(&self) -> Surd {
        Surd {
            rational: self.distance.clone(),
            factor: Dyadic::from(-1),
            radicand: self.reach_squared.clone(),
            divisor: self.closing.clone(),
        }
    }

    fn nearest_now(&self) -> Foot {
        let foot = self.offset.dot(&self.along);
        foot_of(foot.sign(), || foot.compare(&self.along.squared()))
    }

    /// The same after a delay.
    fn nearest_after(&self, delay: &Surd) -> Foot {
        let along = &self.along;
        let foot = delay.mapped(&self.velocity.dot(along), &self.offset.dot(along));
        let sign = sign_of_root(&foot.rational, &foot.factor, &foot.radicand);
        foot_of(sign, || foot.order_to(&along.squared()))
    }
}

/// From the place of the foot along the wall, against its start and its end.
fn foot_of(from_start: Ordering, from_end: impl FnOnce() -> Ordering) -> Foot {
    match from_start {
        Less => Foot::Beyond(End::From),
        Equal => Foot::At(Some(End::From)),
        Greater => match from_end() {
            Less => Foot::At(None),
            Equal => Foot::At(Some(End::To)),
            Greater => Foot::Beyond(End::To),
        },
    }
}
