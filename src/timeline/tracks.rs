//! Which discs surely do not meet soon, where numbers are binary64: the motions of
//! all of them side by side, so that most pairs take but a few operations.

use super::flight::Flights;
use crate::detect::{least_clear, stays_clear};
use crate::kernel::Kernel;

/// How the discs move.
#[derive(Clone, Debug)]
pub(super) struct Tracks {
    /// None where they are of no use.
    tracks: Vec<Track>,
    /// The largest sum of a position's coordinates so far.
    far: f64,
    /// The squared distance from which on two discs may be told apart.
    least: f64,
}

/// How a disc moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Track {
    position: [f64; 2],
    velocity: [f64; 2],
    since: f64,
    radius: f64,
}

impl Track {
    #[inline]
    fn of<S: Kernel>(flights: &Flights<S>, disc: usize) -> Self {
        let body = &flights.world.discs[disc];
        let numbers = |vector: &crate::vec2::Vec2<S>| [vector.x.to_f64(), vector.y.to_f64()];
        Self {
            position: numbers(&body.position),
            velocity: numbers(&body.velocity),
            since: flights.starts[disc].since.to_f64(),
            radius: body.radius.to_f64(),
        }
    }

    #[inline(always)]
    fn at(&self, time: f64) -> [f64; 2] {
        let flown = time - self.since;
        [0, 1].map(|axis| self.position[axis] + self.velocity[axis] * flown)
    }

    /// Whether another disc surely does not touch this one up to a time.
    #[inline(always)]
    fn stays_clear_of(&self, other: &Self, least: f64, until: f64) -> bool {
        let since = if self.since > other.since {
            self.since
        } else {
            other.since
        };
        let (place, other_place) = (self.at(since), other.at(since));
        let offset = [0, 1].map(|axis| other_place[axis] - place[axis]);
        let velocity = [0, 1].map(|axis| other.velocity[axis] - self.velocity[axis]);
        let reach = self.radius + other.radius;
        stays_clear(offset, least, velocity, reach, until - since)
    }
}

impl Tracks {
    /// The motions of discs in flight.
    pub(super) fn new<S: Kernel>(flights: &Flights<S>) -> Self {
        let discs = 0..flights.world.discs.len();
        let mut tracks = Self {
            tracks: Vec::new(),
            far: 0.0,
            least: least_clear(0.0),
        };
        if S::GLIDES {
            tracks.tracks = discs.clone().map(|disc| Track::of(flights, disc)).collect();
            discs.for_each(|disc| tracks.update(flights, disc));
        }
        tracks
    }

    /// Takes note of a disc whose motion has changed.
    #[inline]
    pub(super) fn update<S: Kernel>(&mut self, flights: &Flights<S>, disc: usize) {
        if !S::GLIDES {
            return;
        }
        let track = Track::of(flights, disc);
        self.tracks[disc] = track;
        let far = track.position[0].abs() + track.position[1].abs();
        if far > self.far {
            // Where one of two discs is, and so the way of the other to where it is
            // then, is no further than that.
            self.far = far;
            self.least = least_clear(4.0 * far);
        }
    }

    /// How a disc moves, where that is of use.
    #[inline]
    pub(super) fn of(&self, disc: usize) -> Option<&Track> {
        self.tracks.get(disc)
    }

    /// Whether two discs surely do not touch up to a time, by far more than a
    /// time rounds.
    #[inline(always)]
    pub(super) fn are_clear(&self, track: &Track, other: usize, until: f64) -> bool {
        let until = until + 8.0 * f64::EPSILON * until.abs();
        track.stays_clear_of(&self.tracks[other], self.least, until)
    }
}
