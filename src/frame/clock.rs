//! The objects' clocks within a frame, and collisions on them.

use std::cmp::Ordering::{self, Greater, Less};

use crate::body::Feature;
use crate::detect::Encounter;
use crate::scalar::{Interval, Scalar};
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
pub(super) struct Collision<S> {
    pub(super) disc: usize,
    pub(super) feature: Feature,
    /// How long each of the two moves until then: the paper's `collidetime`
    /// (P4.2, D3).
    pub(super) spans: [S; 2],
    /// What each clock shows then.
    pub(super) times: [S; 2],
    /// The names of these times, where they are those of before.
    moments: [Option<u64>; 2],
    /// Whether both clocks are known to show the same time then.
    pub(super) same_time: bool,
    /// What collisions are ordered by: a time, not a distance (D6).
    pub(super) order: S,
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

impl<S: Scalar> Clocked<S> {
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

    /// What is left of an object's frame (P4.4): a time, not a length (D4).
    pub(super) fn left(&self, disc: usize) -> S {
        self.duration.clone() - self.clock(disc)
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
        let Some(met) = collision(world.meet_wall(disc, wall)?) else {
            return Ok(None);
        };
        if met.delay.compare(&self.left(disc))? == Greater {
            return Ok(None);
        }
        let feature = world.feature(wall, met.end);
        Ok(Some(self.at_delay(disc, feature, met)))
    }

    #[inline]
    fn test_local(
        &self,
        world: &World<S>,
        disc: usize,
        other: usize,
    ) -> Result<Option<Collision<S>>, S::Doubt> {
        let [first, second] = [disc, other].map(|index| &world.discs[index]);
        let offset = second.position.minus(&first.position);
        let velocity = second.velocity.minus(&first.velocity);
        let Some(met) = collision(world.meet_discs((disc, other), &offset, &velocity)?) else {
            return Ok(None);
        };
        for object in [disc, other] {
            if met.delay.compare(&self.left(object))? == Greater {
                return Ok(None);
            }
        }
        Ok(Some(self.at_delay(disc, Feature::Disc(other as u32), met)))
    }

    fn test_synchronised(
        &self,
        world: &World<S>,
        disc: usize,
        other: usize,
    ) -> Result<Option<Collision<S>>, S::Doubt> {
        let [first, second] = [disc, other].map(|index| &world.discs[index]);
        let late = self.later(disc, other)?;
        let waits = [disc, other].map(|index| self.wait(index, late));
        let offset = second
            .position
            .moved(&second.velocity, &waits[1])
            .minus(&first.position.moved(&first.velocity, &waits[0]));
        let velocity = second.velocity.minus(&first.velocity);
        let Some(met) = collision(world.meet_discs((disc, other), &offset, &velocity)?) else {
            return Ok(None);
        };
        let time = self.clock(late).clone() + &met.delay;
        if time.compare(&self.duration)? == Greater {
            return Ok(None);
        }
        Ok(Some(Collision {
            disc,
            feature: Feature::Disc(other as u32),
            spans: waits.map(|wait| wait + &met.delay),
            times: [time.clone(), time.clone()],
            moments: [met.overlap.then_some(self.moments[late]); 2],
            same_time: true,
            order: time,
            overlap: met.overlap,
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

    /// How long an object moves on until its clock shows what a later one does.
    fn wait(&self, disc: usize, late: usize) -> S {
        if self.moments[disc] == self.moments[late] {
            return S::from_integer(0);
        }
        self.clock(late).clone() - self.clock(disc)
    }

    /// The collision of a pair that touches and approaches.
    pub(super) fn touching(&self, disc: usize, feature: Feature) -> Collision<S> {
        self.at_delay(disc, feature, Encounter::now())
    }

    /// The collision in which both objects move for the same time.
    fn at_delay(&self, disc: usize, feature: Feature, met: Encounter<S>) -> Collision<S> {
        let partner = match feature {
            Feature::Disc(other) => other as usize,
            Feature::Wall(_) | Feature::Corner(_) => disc,
        };
        let times = [disc, partner].map(|object| self.clock(object).clone() + &met.delay);
        let order = match self.clocks {
            Clocks::Local => met.delay.clone(),
            Clocks::Synchronised => times[0].clone(),
        };
        let moments = [disc, partner].map(|object| self.moments[object]);
        let equal = || times[0].compare(&times[1]).is_ok_and(Ordering::is_eq);
        Collision {
            disc,
            feature,
            spans: [met.delay.clone(), met.delay],
            moments: moments.map(|moment| met.overlap.then_some(moment)),
            same_time: moments[0] == moments[1] || equal(),
            times,
            order,
            overlap: met.overlap,
        }
    }
}

impl<S: Scalar> Collision<S> {
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
fn collision<S>(met: Option<Encounter<S>>) -> Option<Encounter<S>> {
    met.filter(|encounter| !encounter.graze)
}
