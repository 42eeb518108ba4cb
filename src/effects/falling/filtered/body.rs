//! Bodies that may fall, in the numbers that are stored.

use crate::detect::{End, Segment};
use crate::effects::Falling;
use crate::effects::falling::segment::Touched;
use crate::filtered::Line;
use crate::kernel::Flight;
use crate::scalar::Filtered;
use crate::vec2::Vec2;

/// A disc in flight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Body {
    pub(super) position: [f64; 2],
    pub(super) velocity: [f64; 2],
    pub(super) pull: [f64; 2],
    pub(super) radius: f64,
    pub(super) since: f64,
}

/// What leads to a meeting.
#[derive(Clone, Copy, Debug)]
pub(super) enum Course {
    /// Nothing: the time is known.
    Known,
    /// Two discs, the one that is known since the later time last.
    Discs { pair: [Body; 2], parted: Parted },
    /// A disc that comes to a wall.
    Wall(Body, Line, Touched),
    /// A disc that a wall holds, and that gets to the end of it.
    Leaving(Body, Line),
}

/// Whether two discs have parted where they start from, and if so whether they
/// move at a right angle to their line of centres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Parted {
    No,
    Yes,
    Skimming,
}

impl Course {
    /// The time from which on it is followed.
    pub(super) fn start(&self) -> f64 {
        match self {
            Self::Known => 0.0,
            Self::Discs {
                pair: [_, disc], ..
            }
            | Self::Wall(disc, ..)
            | Self::Leaving(disc, _) => disc.since,
        }
    }
}

/// The coordinates of a vector.
#[inline]
pub(super) fn coordinates(vector: &Vec2<Falling<Filtered>>) -> [f64; 2] {
    [vector.x.0.get(), vector.y.0.get()]
}

/// A vector of stored coordinates.
#[inline]
pub(super) fn stored(coordinates: [f64; 2]) -> Vec2<Falling<Filtered>> {
    let [x, y] = coordinates.map(|number| Falling::new(Filtered::new(number)));
    Vec2::new(x, y)
}

/// The end points of a wall.
#[inline]
pub(super) fn line(wall: &Segment<Falling<Filtered>>) -> Line {
    let [from, to] = [End::From, End::To].map(|end| coordinates(wall.end(end)));
    Line { from, to }
}

impl Body {
    #[inline]
    pub(super) fn of(flight: Flight<'_, Falling<Filtered>>) -> Self {
        Self {
            position: coordinates(&flight.disc.position),
            velocity: coordinates(&flight.disc.velocity),
            pull: coordinates(&flight.pull.acting),
            radius: flight.disc.radius.0.get(),
            since: flight.since.0.get(),
        }
    }
}
