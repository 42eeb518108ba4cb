//! The objects' clocks within a frame, and collisions on them.

use std::cmp::Ordering::{self, Greater, Less};

use crate::body::Feature;
use crate::kernel::{Approach, Kernel, Met, Time};
use crate::scalar::Interval;
use crate::world::{Obstacle, World};

/// How the clocks of a pair are read when it is tested.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Clocks {
    /// Each object starts where it is, whatever its clock shows (D5).
    Local,
    /// The object whose clock is behind is first moved on to the other's.
    Synchronised,
}

/// A valid collision of a disc with something.
#[derive(Clone, Debug)]
pub(super) struct Collision<S: Kernel> {
    pub(super) disc: usize,
    pub(super) feature: Feature,
    /// When: on local clocks the time since each of the two was where it is,
    /// the paper's `collidetime` (P4.2, D3). Collisions are ordered by it: a
    /// time, not a distance (D6).
    pub(super) when: S::Time,
    /// Since when, counted like this, each of the two is where it is.
    pub(super) since: [S; 2],
    /// What each clock shows then.
    pub(super) times: [S; 2],
    /// The names of these times, where they are those of before.
    moments: [Option<u64>; 2],
    /// Whether both clocks are known to show the same time then.
    pub(super) same_time: bool,
    pub(super) overlap: bool,
}

/// Where each object is within the frame.
#[derive(Clone, Debug)]
pub(super) struct Clocked<S> {
    /// The paper's `timepassed` (P4.1), zero at first (D1), times the duration.
    timepassed: Vec<S>,
    /// Names of the times that the clocks show: equal names are equal times,
    /// also where the arithmetic could not prove it.
    moments: Vec<u64>,
    duration: S,
    clocks: Clocks,
}

impl<S: Kernel> Clocked<S> {
    pub(super) fn new(count: usize, duration: S, clocks: Clocks) -> Self {
        Self {
            timepassed: vec![S::from_integer(0); count],
            moments: vec![0; count],
            duration,
            clocks,
        }
    }

    pub(super) fn hull(&self) -> Clocked<Interval> {
        Clocked {
            timepassed: self.timepassed.iter().map(S::hull).collect(),
            moments: self.moments.clone(),
            duration: self.duration.hull(),
            clocks: self.clocks,
        }
    }

    pub(super) fn clock(&self, disc: usize) -> &S {
        &self.timepassed[disc]
    }

    pub(super) fn set(&mut self, disc: usize, time: S, moment: u64) {
        self.timepassed[disc] = time;
        self.moments[disc] = moment;
    }

    /// Whether one of the two objects of a collision is where it happens.
    pub(super) fn is_there(&self, object: usize, collision: &Collision<S>, side: usize) -> bool {
        collision.moments[side] == Some(self.moments[object])
    }

    /// The end of the frame, up to which what is left of it is a time, not a
    /// length (P4.4, D4).
    pub(super) fn end(&self) -> S::Time {
        S::Time::at(self.duration.clone())
    }

    /// The collision of a pair, if both objects reach it within the frame.
    #[inline]
    pub(super) fn test(
        &self,
        world: &World<S>,
        disc: usize,
        obstacle: Obstacle,
    ) -> Result<Option<Collision<S>>, S::Doubt> {
        match obstacle {
            Obstacle::Wall(wall) => self.test_wall(world, disc, wall),
            Obstacle::Disc(other) => match self.clocks {
                Clocks::Local => self.test_local(world, disc, other),
                Clocks::Synchronised => self.test_synchronised(world, disc, other),
            },
        }
    }

    fn test_wall(
        &self,
        world: &World<S>,
        disc: usize,
        wall: usize,
    ) -> Result<Option<Collision<S>>, S::Doubt> {
        let start = self.start(disc);
        let Some(met) = collision(world.meet_wall(disc, &start, wall)?) else {
            return Ok(None);
        };
        if !self.is_within_frame(disc, &met.time)? {
            return Ok(None);
        }
        let feature = world.feature(wall, met.end);
        Ok(Some(self.at(met, disc, feature)))
    }

    #[inline]
    fn test_local(
        &self,
        world: &World<S>,
        disc: usize,
        other: usize,
    ) -> Result<Option<Collision<S>>, S::Doubt> {
        let start = S::from_integer(0);
        let [early, late] = [disc, other].map(|index| world.flight(index, &start));
        let approach = Approach {
            early,
            late,
            together: true,
        };
        let Some(met) = collision(S::meet_discs(&approach)?) else {
            return Ok(None);
        };
        for object in [disc, other] {
            if !self.is_within_frame(object, &met.time)? {
                return Ok(None);
            }
        }
        Ok(Some(self.at(met, disc, Feature::Disc(other as u32))))
    }

    fn test_synchronised(
        &self,
        world: &World<S>,
        disc: usize,
        other: usize,
    ) -> Result<Option<Collision<S>>, S::Doubt> {
        let late = self.later(disc, other)?;
        let early = if late == disc { other } else { disc };
        let flight = |index| world.flight(index, self.clock(index));
        let approach = Approach {
            early: flight(early),
            late: flight(late),
            together: self.moments[early] == self.moments[late],
        };
        let Some(met) = collision(S::meet_discs(&approach)?) else {
            return Ok(None);
        };
        if met.time.order_to(&self.duration)? == Greater {
            return Ok(None);
        }
        let time = met.time.value();
        Ok(Some(Collision {
            disc,
            feature: Feature::Disc(other as u32),
            since: [disc, other].map(|index| self.clock(index).clone()),
            times: [time.clone(), time],
            moments: [met.overlap.then_some(self.moments[late]); 2],
            same_time: true,
            overlap: met.overlap,
            when: met.time,
        }))
    }

    /// Of two objects, one whose clock is not behind the other's.
    fn later(&self, disc: usize, other: usize) -> Result<usize, S::Doubt> {
        if self.moments[disc] == self.moments[other] {
            return Ok(disc);
        }
        let order = self.clock(disc).compare(self.clock(other))?;
        Ok(if order == Less { other } else { disc })
    }

    /// The time from which an object is tested on its own.
    fn start(&self, disc: usize) -> S {
        match self.clocks {
            Clocks::Local => S::from_integer(0),
            Clocks::Synchronised => self.clock(disc).clone(),
        }
    }

    /// Whether an object reaches a collision within its frame.
    #[inline]
    fn is_within_frame(&self, disc: usize, when: &S::Time) -> Result<bool, S::Doubt> {
        let order = match self.clocks {
            Clocks::Local => when.order_to_rest(&self.duration, self.clock(disc))?,
            Clocks::Synchronised => when.order_to(&self.duration)?,
        };
        Ok(order != Greater)
    }

    /// The collision of a pair that touches and approaches.
    pub(super) fn touching(&self, disc: usize, feature: Feature) -> Collision<S> {
        self.at(Met::at_once(&self.start(disc)), disc, feature)
    }

    /// The collision in which both objects move for the same time.
    fn at(&self, met: Met<S::Time>, disc: usize, feature: Feature) -> Collision<S> {
        let partner = match feature {
            Feature::Disc(other) => other as usize,
            Feature::Wall(_) | Feature::Corner(_) => disc,
        };
        let objects = [disc, partner];
        let times = match self.clocks {
            Clocks::Local => objects.map(|object| met.time.value_after(self.clock(object))),
            Clocks::Synchronised => [met.time.value(), met.time.value()],
        };
        let moments = objects.map(|object| self.moments[object]);
        let equal = || times[0].compare(&times[1]).is_ok_and(Ordering::is_eq);
        Collision {
            disc,
            feature,
            since: objects.map(|object| self.start(object)),
            moments: moments.map(|moment| met.overlap.then_some(moment)),
            same_time: moments[0] == moments[1] || equal(),
            times,
            overlap: met.overlap,
            when: met.time,
        }
    }
}

impl<S: Kernel> Collision<S> {
    /// The names of the times that the two clocks show then, with two that
    /// are new.
    pub(super) fn moments(&self, new: [u64; 2]) -> [u64; 2] {
        let [own, other] = if self.same_time { [new[0]; 2] } else { new };
        [
            self.moments[0].unwrap_or(own),
            self.moments[1].unwrap_or(other),
        ]
    }
}

/// A tangent pass is no collision.
fn collision<T>(met: Option<Met<T>>) -> Option<Met<T>> {
    met.filter(|met| !met.graze)
}
