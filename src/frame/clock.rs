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
    /// What collisions are ordered by: a time, not a distance (D6).
    pub(super) order: S,
    pub(super) overlap: bool,
}

/// Where each object is within the frame.
#[derive(Clone, Debug)]
pub(super) struct Clocked<S> {
    /// The paper's `timepassed` (P4.1), zero at first (D1), times the duration.
    timepassed: Vec<S>,
    duration: S,
    clocks: Clocks,
}

impl<S: Scalar> Clocked<S> {
    pub(super) fn new(count: usize, duration: S, clocks: Clocks) -> Self {
        Self {
            timepassed: vec![S::from_integer(0); count],
            duration,
            clocks,
        }
    }

    pub(super) fn hull(&self) -> Clocked<Interval> {
        Clocked {
            timepassed: self.timepassed.iter().map(S::hull).collect(),
            duration: self.duration.hull(),
            clocks: self.clocks,
        }
    }

    pub(super) fn clock(&self, disc: usize) -> &S {
        &self.timepassed[disc]
    }

    pub(super) fn set(&mut self, disc: usize, time: S) {
        self.timepassed[disc] = time;
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
        let start = later(self.clock(disc), self.clock(other))?;
        let waits = [disc, other].map(|index| start.clone() - self.clock(index));
        let offset = second
            .position
            .moved(&second.velocity, &waits[1])
            .minus(&first.position.moved(&first.velocity, &waits[0]));
        let velocity = second.velocity.minus(&first.velocity);
        let Some(met) = collision(world.meet_discs((disc, other), &offset, &velocity)?) else {
            return Ok(None);
        };
        let time = start + &met.delay;
        if time.compare(&self.duration)? == Greater {
            return Ok(None);
        }
        Ok(Some(Collision {
            disc,
            feature: Feature::Disc(other as u32),
            spans: waits.map(|wait| wait + &met.delay),
            times: [time.clone(), time.clone()],
            order: time,
            overlap: met.overlap,
        }))
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
        Collision {
            disc,
            feature,
            spans: [met.delay.clone(), met.delay],
            times,
            order,
            overlap: met.overlap,
        }
    }
}

impl<S: Scalar> Collision<S> {
    /// Whether the clocks of the two are not known to agree.
    pub(super) fn joins_different_times(&self) -> bool {
        !self.times[0]
            .compare(&self.times[1])
            .is_ok_and(Ordering::is_eq)
    }
}

/// A tangent pass is no collision.
fn collision<S>(met: Option<Encounter<S>>) -> Option<Encounter<S>> {
    met.filter(|encounter| !encounter.graze)
}

fn later<S: Scalar>(one: &S, other: &S) -> Result<S, S::Doubt> {
    let later = if one.compare(other)? == Less {
        other
    } else {
        one
    };
    Ok(later.clone())
}
