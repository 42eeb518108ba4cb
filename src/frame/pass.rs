//! One pass: of all collisions on the objects' clocks, those that come first.
//!
//! A pair is valid if both objects reach the collision within what is left of
//! their frame. A valid collision is kept if it is the earliest for both its
//! objects; bodies of infinite mass and walls, which a collision does not
//! change, have no say (D9). Losers get no second choice in the pass (P3.3,
//! D7).

use std::cmp::Ordering::{Equal, Greater, Less};

use super::Frame;
use super::bounded::Bounded;
use super::candidates::Candidates;
use super::clock::{Clocked, Clocks, Collision};
use crate::body::Feature;
use crate::impact::{Impact, Place, Step};
use crate::kernel::{Kernel, Time};
use crate::scalar::{Doubt, Interval};
use crate::vec2::Vec2;
use crate::world::{Obstacle, World};

/// A frame on its way through its passes.
pub(super) struct Passing<'a, S: Kernel> {
    bodies: Bounded<'a, S>,
    frame: &'a Frame<S>,
    clocked: Clocked<S>,
    /// The same in binary64 bounds, where the arithmetic wants the filter.
    bounds: Option<Clocked<Interval>>,
    /// Whether the velocity has changed in this frame (P4.3).
    modified: Vec<bool>,
    /// Whether the object collided in the latest pass.
    collided: Vec<bool>,
    /// Whether the object's last collision joined clocks that differ.
    askew: Vec<bool>,
    pass: u32,
    /// How many times have been given names.
    moments: u64,
}

impl<'a, S: Kernel> Passing<'a, S> {
    pub(super) fn new(
        world: &'a mut World<S>,
        frame: &'a Frame<S>,
        clocks: Clocks,
        candidates: &'a mut Candidates,
    ) -> Self {
        let count = world.discs.len();
        let clocked = Clocked::new(count, frame.duration.clone(), clocks);
        Self {
            bounds: S::IS_DEAR.then(|| clocked.hull()),
            bodies: Bounded::new(world, candidates, &frame.duration),
            frame,
            clocked,
            modified: vec![false; count],
            collided: vec![false; count],
            askew: vec![false; count],
            pass: 0,
            moments: 0,
        }
    }

    /// Moves apart what overlaps at the start of the frame (P3.5).
    pub(super) fn resolve_overlaps(&mut self) -> Result<(), S::Doubt> {
        self.bodies.resolve_overlaps()
    }

    /// Finds the collisions of one pass and applies those that come first.
    pub(super) fn pass(&mut self) -> Result<Vec<Impact<S>>, S::Doubt> {
        self.pass += 1;
        let found = self.detect()?;
        let kept = self.keep_first(found)?;
        self.collided.fill(false);
        kept.into_iter()
            .map(|collision| self.respond(&collision))
            .collect()
    }

    /// Moves on whoever did not collide in the latest pass (D10).
    pub(super) fn move_on(self) {
        let Self {
            bodies,
            clocked,
            collided,
            askew,
            ..
        } = self;
        let end = clocked.end();
        for disc in (0..collided.len()).filter(|&disc| !collided[disc]) {
            let clock = clocked.clock(disc);
            bodies.world.advance_disc(disc, clock, &end);
            if askew[disc] {
                // The two went on for different times: they may meet again.
                bodies.world.discs[disc].last = None;
            }
        }
    }

    /// All valid collisions, by the order of the pairs.
    fn detect(&mut self) -> Result<Vec<Collision<S>>, S::Doubt> {
        let is_tested = |disc: usize| self.pass == 1 || self.modified[disc];
        self.bodies.list_pairs(is_tested);
        let mut found = Vec::new();
        self.bodies.pairs().try_for_each(|(disc, obstacle)| {
            if self.is_tested(disc, obstacle) && !self.bodies.world.is_barred(disc, obstacle) {
                found.extend(self.test(disc, obstacle)?);
            }
            Ok(())
        })?;
        Ok(found)
    }

    /// In the first pass every pair is, later those with a modified object (D8).
    #[inline]
    fn is_tested(&self, disc: usize, obstacle: Obstacle) -> bool {
        let modified = |obstacle| matches!(obstacle, Obstacle::Disc(other) if self.modified[other]);
        self.pass == 1 || self.modified[disc] || modified(obstacle)
    }

    #[inline]
    fn test(&self, disc: usize, obstacle: Obstacle) -> Result<Option<Collision<S>>, S::Doubt> {
        if let Some(feature) = self.bodies.world.contact(disc, obstacle) {
            let approaches = self.bodies.world.approaches_here(disc, feature)?;
            return Ok(approaches.then(|| self.clocked.touching(disc, feature)));
        }
        if let (Some(clocked), Some(world)) = (&self.bounds, self.bodies.bounds())
            && matches!(clocked.test(world, disc, obstacle), Ok(None))
        {
            return Ok(None);
        }
        let tested = self.clocked.test(self.bodies.world, disc, obstacle);
        tested.map_err(|doubt| doubt.asking(|| obstacle.ask(disc, "collide")))
    }

    /// Keeps a collision if it is the earliest for both its objects.
    fn keep_first(&self, found: Vec<Collision<S>>) -> Result<Vec<Collision<S>>, S::Doubt> {
        let mut first: Vec<Option<usize>> = vec![None; self.modified.len()];
        for (index, collision) in found.iter().enumerate() {
            for (object, ..) in self.moved(collision) {
                let earlier = match first[object] {
                    None => true,
                    Some(other) => self.precedes(collision, &found[other])?,
                };
                if earlier {
                    first[object] = Some(index);
                }
            }
        }
        let is_first = |index, collision: &Collision<S>| {
            self.moved(collision)
                .all(|(object, ..)| first[object] == Some(index))
        };
        let kept = found.into_iter().enumerate();
        Ok(kept
            .filter(|(index, collision)| is_first(*index, collision))
            .map(|(_, collision)| collision)
            .collect())
    }

    /// Whether a collision comes before one found earlier in the pass.
    fn precedes(&self, one: &Collision<S>, other: &Collision<S>) -> Result<bool, S::Doubt> {
        if one.disc == other.disc && one.feature == other.feature {
            return Ok(false);
        }
        let names =
            |collision: &Collision<S>| self.bodies.world.names(collision.disc, collision.feature);
        let order = one.when.order(&other.when).map_err(|doubt| {
            let (one, other) = (names(one).0, names(other).0);
            doubt.asking(|| format!("whether {one} or {other} collide first"))
        })?;
        Ok(match order {
            Less => true,
            Equal => names(one) < names(other),
            Greater => false,
        })
    }

    /// Moves the objects of a collision to it, and lets them collide.
    fn respond(&mut self, collision: &Collision<S>) -> Result<Impact<S>, S::Doubt> {
        let (disc, feature) = (collision.disc, collision.feature);
        for (object, side) in self.moved(collision) {
            if !self.clocked.is_there(object, collision, side) {
                let (since, when) = (&collision.since[side], &collision.when);
                self.bodies.world.advance_disc(object, since, when);
            }
        }
        let place = self.place(collision);
        let contact = self.bodies.world.collide(disc, feature, place)?;
        self.note(collision);
        let names = self.bodies.world.names(disc, feature);
        let [time, other_time] = &collision.times;
        let absolute = |clock: &S| self.frame.start.clone() + clock;
        let differs = self.partner(feature).is_some() && !collision.same_time;
        Ok(Impact {
            other_time: differs.then(|| absolute(other_time)),
            step: Some(Step {
                frame: self.frame.number,
                pass: self.pass,
            }),
            ..Impact::new(absolute(time), names, contact)
        })
    }

    /// Where the two are when they collide.
    fn place(&self, collision: &Collision<S>) -> Place<S> {
        let other = match collision.feature {
            Feature::Disc(other) => self.position_brought(other as usize, collision, 1),
            Feature::Wall(_) | Feature::Corner(_) => Vec2::zero(),
        };
        Place {
            centre: self.position_brought(collision.disc, collision, 0),
            other,
            overlap: collision.overlap,
        }
    }

    /// Where an object is that has moved to a collision, or does not stop.
    fn position_brought(&self, disc: usize, collision: &Collision<S>, side: usize) -> Vec2<S> {
        if self.is_movable(disc) || self.clocked.is_there(disc, collision, side) {
            return self.bodies.world.discs[disc].position.clone();
        }
        let since = &collision.since[side];
        self.bodies.world.position_at(disc, since, &collision.when)
    }

    /// The objects that a collision changes, each with whether it is the
    /// first or the second one.
    fn moved(&self, collision: &Collision<S>) -> impl Iterator<Item = (usize, usize)> + use<S> {
        let own = self.is_movable(collision.disc).then_some(collision.disc);
        let other = self.partner(collision.feature);
        let own = own.map(|disc| (disc, 0));
        own.into_iter().chain(other.map(|disc| (disc, 1)))
    }

    /// The other object, if a collision changes it.
    fn partner(&self, feature: Feature) -> Option<usize> {
        match feature {
            Feature::Disc(other) => Some(other as usize).filter(|&disc| self.is_movable(disc)),
            Feature::Wall(_) | Feature::Corner(_) => None,
        }
    }

    fn is_movable(&self, disc: usize) -> bool {
        self.bodies.world.discs[disc].is_movable()
    }

    /// Remembers what a collision has changed.
    fn note(&mut self, collision: &Collision<S>) {
        let askew = self.is_askew(collision);
        if self.is_lasting(collision) {
            let world = &mut self.bodies.world;
            world.join(collision.disc, collision.feature);
        }
        let moments = collision.moments([self.moments + 1, self.moments + 2]);
        self.moments += 2;
        for (object, side) in self.moved(collision) {
            let (time, moment) = (&collision.times[side], moments[side]);
            self.modified[object] = true;
            self.collided[object] = true;
            self.askew[object] = askew;
            self.bodies.update(object);
            self.clocked.set(object, time.clone(), moment);
            if let Some(bounds) = &mut self.bounds {
                bounds.set(object, time.hull(), moment);
            }
        }
    }

    /// Whether the two, moving on to the end of the frame, do so for
    /// different times.
    fn is_askew(&self, collision: &Collision<S>) -> bool {
        let Feature::Disc(other) = collision.feature else {
            return false;
        };
        let rests =
            [collision.disc, other as usize].map(|disc| self.bodies.world.rests_for_ever(disc));
        rests == [false, false] && !collision.same_time
    }

    /// Whether the two stay where they touch until one moves on.
    fn is_lasting(&self, collision: &Collision<S>) -> bool {
        let passes_by = |disc| !self.is_movable(disc) && !self.bodies.world.rests_for_ever(disc);
        let other = match collision.feature {
            Feature::Disc(other) => Some(other as usize),
            Feature::Wall(_) | Feature::Corner(_) => None,
        };
        !passes_by(collision.disc) && !other.is_some_and(passes_by)
    }
}
