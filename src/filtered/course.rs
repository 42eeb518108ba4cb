//! Bodies on their way to a meeting, in the numbers that are stored.

use super::float::{Float, Twofold, UNDERFLOW};
use super::plane::Point;
use super::screen::Rounded;
use super::surd::Surd;
use crate::body::Disc;
use crate::detect::{End, Segment};
use crate::kernel::Flight;
use crate::scalar::{Dyadic, Filtered};
use crate::vec2::Vec2;

/// A disc in flight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ray {
    pub(super) position: [f64; 2],
    pub(super) velocity: [f64; 2],
    pub(super) radius: f64,
    pub(super) since: f64,
}

/// The two end points of a wall.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    pub(crate) from: [f64; 2],
    pub(crate) to: [f64; 2],
}

/// What leads to a meeting.
#[derive(Clone, Copy, Debug)]
pub(super) enum Course {
    /// Nothing: the time is known.
    Known,
    /// Two discs, the one that is known since the later time last.
    Discs([Ray; 2]),
    /// A disc and the interior of a wall.
    Wall(Ray, Line),
    /// A disc and a point.
    Point(Ray, [f64; 2]),
}

impl Course {
    /// The time from which on it is followed, unless there is none.
    #[inline]
    pub(super) fn start(&self) -> Option<f64> {
        match self {
            Self::Known => None,
            Self::Discs([_, disc]) | Self::Wall(disc, _) | Self::Point(disc, _) => Some(disc.since),
        }
    }
}

/// The coordinates of a vector.
#[inline]
pub(super) fn coordinates(vector: &Vec2<Filtered>) -> [f64; 2] {
    [vector.x.get(), vector.y.get()]
}

impl Ray {
    #[inline]
    pub(super) fn of(flight: Flight<'_, Filtered>) -> Self {
        Self::standing(flight.disc, flight.since.get())
    }

    /// A disc that is where it says at some time.
    #[inline]
    pub(super) fn standing(disc: &Disc<Filtered>, since: f64) -> Self {
        Self {
            position: coordinates(&disc.position),
            velocity: coordinates(&disc.velocity),
            radius: disc.radius.get(),
            since,
        }
    }

    /// Where the disc is at another time, exactly.
    pub(super) fn at(&self, time: f64) -> Point {
        let flown = Dyadic::from_f64(time).sub(&Dyadic::from_f64(self.since));
        Point::new(self.position).plus(&Point::new(self.velocity).scaled(&flown))
    }

    /// The same to two words, after a flight, and how far off that may be.
    pub(super) fn after(&self, flown: Rounded<Twofold>) -> [Rounded<Twofold>; 2] {
        [0, 1].map(|place| {
            let (start, speed) = (self.position[place], self.velocity[place]);
            let way = Twofold::new(speed) * flown.value;
            let size = start.abs() + way.head().abs();
            Rounded {
                value: Twofold::new(start) + way,
                error: speed.abs() * flown.error + 4.0 * Twofold::UNIT * size + UNDERFLOW,
            }
        })
    }

    /// Where it is at a time, rounded.
    pub(super) fn rounded_at(&self, time: &Surd) -> Vec2<Filtered> {
        let flown = time.plus(&-Dyadic::from_f64(self.since));
        let coordinate = |place: usize| {
            let [start, speed] = [self.position, self.velocity].map(|vector| vector[place]);
            let place = flown.mapped(&Dyadic::from_f64(speed), &Dyadic::from_f64(start));
            Filtered::new(place.to_f64())
        };
        Vec2::new(coordinate(0), coordinate(1))
    }
}

impl Line {
    #[inline]
    pub(super) fn of(wall: &Segment<Filtered>) -> Self {
        Self {
            from: coordinates(&wall.from),
            to: coordinates(&wall.to),
        }
    }

    /// How a disc comes to meet the interior, or an end point.
    #[inline]
    pub(super) fn course(&self, disc: Ray, end: Option<End>) -> Course {
        match end {
            None => Course::Wall(disc, *self),
            Some(end) => Course::Point(disc, self.end(end)),
        }
    }

    #[inline]
    pub(crate) fn end(&self, end: End) -> [f64; 2] {
        match end {
            End::From => self.from,
            End::To => self.to,
        }
    }

    /// The vector from the first end point to the other, exactly.
    pub(crate) fn along(&self) -> Point {
        Point::new(self.to).minus(&Point::new(self.from))
    }
}
