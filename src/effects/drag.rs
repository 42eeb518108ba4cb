//! Linear drag, v' = -k v, in the timeline.
//!
//! In the *warped* time s = (1 - e^(-k t)) / k motion is straight: a disc moves
//! along with its velocity times e^(k t), which drag does not change. All discs
//! share the factor, and what an impact does to velocities is linear in them. So
//! the course in warped time is that of the same scene without drag, in the same
//! order, decided as exactly; only the times of the log and the velocities are
//! translated. Warped time never gets to 1/k: what is met no earlier is never
//! met.
//!
//! A moving body of infinite mass feels no drag, and what is a slow impact in one
//! time is none in the other: with these, and with gravity, discs fall through
//! [`Air`](super::Air).

use super::Course;
use crate::body::Disc;
use crate::impact::{Contact, Impact};
use crate::scalar::Decay;
use crate::timeline::{Accumulation, Setup, Timed, Timeline};
use crate::world::World;

/// A timeline in warped time.
#[derive(Clone, Debug)]
pub struct Dragged<S: Timed> {
    timeline: Timeline<S>,
    rate: S,
    /// The limit that was asked for last, and its warped time.
    limit: (S, S),
    /// The time of the latest impact: a logarithm is dear.
    now: S,
}

impl<S: Timed + Decay> Dragged<S> {
    /// The course of a world under drag of some rate.
    ///
    /// # Errors
    ///
    /// It cannot be decided what the discs meet first.
    pub fn new(world: World<S>, rate: S, until: &S, setup: &Setup<'_>) -> Result<Self, S::Doubt> {
        let end = warped(until, &rate);
        Ok(Self {
            timeline: Timeline::with_setup(world, &end, setup)?,
            rate,
            limit: (until.clone(), end),
            now: S::from_integer(0),
        })
    }

    fn warped(&self, time: &S) -> S {
        let (limit, warped_limit) = &self.limit;
        match time.compare(limit) {
            Ok(order) if order.is_eq() => warped_limit.clone(),
            _ => warped(time, &self.rate),
        }
    }

    /// The time at which warped time is as given.
    fn unwarped(&self, warped: &S) -> S {
        if warped.is_surely_zero() {
            return warped.clone();
        }
        let part = warped.clone() * &self.rate;
        part.undecay() / &self.rate
    }

    /// What is left of velocities at a warped time.
    fn left(&self, warped: &S) -> S {
        S::from_integer(1) - warped.clone() * &self.rate
    }
}

fn warped<S: Decay>(time: &S, rate: &S) -> S {
    (time.clone() * rate).decay() / rate
}

impl<S: Timed + Decay> Course<S> for Dragged<S> {
    fn next_impact(&mut self, limit: &S) -> Result<Option<Impact<S>>, S::Doubt> {
        self.limit = (limit.clone(), self.warped(limit));
        let Some(impact) = self.timeline.next_impact(&self.limit.1)? else {
            return Ok(None);
        };
        self.now = self.unwarped(&impact.time);
        let left = self.left(&impact.time);
        let slowed = |contact: &Contact<S>| Contact {
            velocity: contact.velocity.scaled(&left),
            other_velocity: contact
                .other_velocity
                .as_ref()
                .map(|other| other.scaled(&left)),
            ..contact.clone()
        };
        Ok(Some(Impact {
            time: self.now.clone(),
            contact: impact.contact.as_ref().map(slowed),
            ..impact
        }))
    }

    fn disc_count(&self) -> usize {
        self.timeline.disc_count()
    }

    fn now(&self) -> S {
        self.now.clone()
    }

    fn discs_at(&self, time: &S) -> Vec<Disc<S>> {
        let warped = self.warped(time);
        let left = self.left(&warped);
        let discs = self.timeline.discs_at(&warped).into_iter();
        let slowed = |disc: Disc<S>| match disc.is_movable() {
            true => Disc {
                velocity: disc.velocity.scaled(&left),
                ..disc
            },
            false => disc,
        };
        discs.map(slowed).collect()
    }

    fn grazes(&self) -> u64 {
        self.timeline.grazes()
    }

    fn rests(&self) -> u64 {
        0
    }

    fn closest_call(&self) -> Option<f64> {
        self.timeline.closest_call()
    }

    fn accumulation(&self) -> Option<Accumulation<S>> {
        let found = self.timeline.accumulation()?;
        Some(found.map(|limit| self.unwarped(limit)))
    }

    fn duplicate(&self) -> Box<dyn Course<S>> {
        Box::new(self.clone())
    }
}
