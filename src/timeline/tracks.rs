//! Which discs surely do not meet soon, where numbers are binary64: the motions of
//! all of them side by side, so that most pairs take but a few operations.

use super::flight::Flights;
use crate::detect::{Passage, least_clear};
use crate::kernel::Kernel;

/// How the discs move.
#[derive(Clone, Debug)]
pub(super) struct Tracks {
    /// None where they are of no use.
    tracks: Vec<Track>,
    /// The latest time since when any of them moves so.
    now: f64,
    /// The largest number so far that says how one moves, of a position the sum of
    /// both coordinates.
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

    /// The largest of its numbers, of the position the sum of both.
    fn far(&self) -> f64 {
        let Self {
            position: [x, y],
            velocity: [vx, vy],
            since,
            radius,
        } = self;
        let far = x.abs() + y.abs();
        far.max(vx.abs().max(vy.abs()))
            .max(since.abs().max(*radius))
    }

    #[inline(always)]
    fn at(&self, time: f64) -> [f64; 2] {
        let flown = time - self.since;
        [0, 1].map(|axis| self.position[axis] + self.velocity[axis] * flown)
    }

    /// The same motion from another time on.
    #[inline(always)]
    fn from(&self, time: f64) -> Self {
        Self {
            position: self.at(time),
            since: time,
            ..*self
        }
    }

    /// How another disc passes this one from now on.
    #[inline(always)]
    fn passed_by(&self, other: &Self) -> Passage {
        let place = other.at(self.since);
        let offset = [0, 1].map(|axis| place[axis] - self.position[axis]);
        let velocity = [0, 1].map(|axis| other.velocity[axis] - self.velocity[axis]);
        Passage::new(offset, velocity, self.radius + other.radius)
    }
}

/// A disc that another one may meet, and how it passes from now on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passer {
    pub(super) disc: u32,
    passage: Passage,
}

impl Tracks {
    /// The motions of discs in flight.
    pub(super) fn new<S: Kernel>(flights: &Flights<S>) -> Self {
        let discs = 0..flights.world.discs.len();
        let mut tracks = Self {
            tracks: Vec::new(),
            now: 0.0,
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
        if track.since > self.now {
            self.now = track.since;
        }
        let far = track.far();
        if far > self.far {
            // Where one of two discs is, and so the way of the other to where it is
            // then, is no further than that.
            self.far = far;
            self.least = least_clear(4.0 * far);
        }
    }

    /// Whether they are of use.
    #[inline]
    pub(super) fn are_kept(&self) -> bool {
        !self.tracks.is_empty()
    }

    /// Lists those of some discs that one may meet from now on, and leaves no others
    /// of these. It meets neither itself nor the one that it has `parted` from.
    #[inline]
    pub(super) fn list_passers(
        &self,
        disc: usize,
        parted: Option<u32>,
        others: &mut Vec<u32>,
        list: &mut Vec<Passer>,
    ) {
        let track = self.tracks[disc].from(self.now);
        let own = disc as u32;
        self.drop_clear(&track, [own, parted.unwrap_or(own)], others);
        list.clear();
        list.extend(others.iter().map(|&other| Passer {
            disc: other,
            passage: track.passed_by(&self.tracks[other as usize]),
        }));
    }

    /// Drops the discs that surely never meet one that moves so, and two more. Which ones
    /// do is as good as random: so there are no branches on that.
    fn drop_clear(&self, track: &Track, [one, two]: [u32; 2], others: &mut Vec<u32>) {
        let mut left = 0;
        for place in 0..others.len() {
            let other = others[place];
            let passage = track.passed_by(&self.tracks[other as usize]);
            others[left] = other;
            let may_meet = (other != one) & (other != two) & !passage.is_clear(self.least);
            left += usize::from(may_meet);
        }
        others.truncate(left);
    }

    /// When a disc meets one that it passes, or infinity: a guess.
    #[inline]
    pub(super) fn likely_time(&self, passer: &Passer) -> f64 {
        self.now + passer.passage.likely_delay()
    }

    /// Whether a disc surely does not meet one that it passes up to a time, by far more
    /// than a time rounds.
    #[inline]
    pub(super) fn is_clear(&self, passer: &Passer, until: f64) -> bool {
        let until = until + 8.0 * f64::EPSILON * until.abs();
        passer.passage.is_clear_for(self.least, until - self.now)
    }
}
