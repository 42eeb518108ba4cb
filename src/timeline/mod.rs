//! The timeline: always the next impact of all, in order (P6.1).
//!
//! Between impacts every body moves freely, so a body is kept at the time of
//! its own last impact and is not touched in between. The next impact is the
//! first of the bodies' forecasts. Binary64 bounds of their times find it;
//! where bounds overlap, the arithmetic decides, and where it cannot, the run
//! ends rather than guess. Two exceptions need no decision: a pair that both
//! its discs have forecast, and impacts that share no disc and are closer
//! than 2^-1000 of the duration. The latter commute.
//!
//! Simultaneous impacts follow the `sequential` rule (D17), one pair at a time,
//! or on request another: see [`Simultaneous`].

mod accumulation;
mod ahead;
mod arbiter;
mod cluster;
mod flight;
mod forecast;
mod front;
mod meeting;
mod neighbours;
mod nested;
mod notes;
mod periodic;
mod queue;
mod resolve;
mod rest;
mod step;
mod sweep;
mod ties;

use std::collections::{BTreeSet, VecDeque};
use std::fmt;

use crate::body::{Disc, Feature};
use crate::impact::Impact;
use crate::symmetry::Symmetry;
use crate::world::{Obstacle, World};
use accumulation::{Jams, Watch};
use ahead::Ahead;
use arbiter::Arbiter;
pub use arbiter::Timed;
use flight::Flights;
use forecast::{Effort, Forecast, Forecaster};
use front::Candidate;
use nested::Nested;
use notes::Notes;
use queue::Queue;

pub use accumulation::Accumulation;
pub use neighbours::BroadPhase;
pub use periodic::Periodic;
pub(crate) use periodic::count_overlaps;

/// How simultaneous impacts that share a disc are resolved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Simultaneous {
    /// One pair at a time, in the order of their names, until no touching pair
    /// approaches (D17).
    #[default]
    Sequential,
    /// All at once, in a way that keeps the energy and the symmetry of the
    /// scene: see [`reflect_cluster`](crate::respond::reflect_cluster).
    Reflect,
}

impl fmt::Display for Simultaneous {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sequential => "sequential",
            Self::Reflect => "reflect",
        })
    }
}

/// What may be chosen for a run.
#[derive(Clone, Copy, Debug, Default)]
pub struct Setup<'a> {
    /// The rule for simultaneous impacts that share a disc.
    pub simultaneous: Simultaneous,
    /// How neighbours are found.
    pub broad_phase: BroadPhase,
    /// Symmetries that the world is known to have.
    pub symmetries: &'a [Symmetry],
}

/// 2^-1000, the part of the duration by which the times of impacts may differ of which
/// it is of no account which one is the first.
const NEGLIGIBLE: f64 = f64::from_bits((1023 - 1000) << 52);

/// Whom a disc's forecast considers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Partners {
    /// Everything.
    All,
    /// At the start, when all discs are forecast in turn, only what is left of
    /// the pairs: later discs, and what makes no forecasts of its own.
    Later,
}

impl Partners {
    #[inline]
    fn include<S: Timed>(self, world: &World<S>, disc: usize, obstacle: Obstacle) -> bool {
        match obstacle {
            Obstacle::Disc(other) if self == Self::Later => {
                other > disc || !world.discs[other].is_movable()
            }
            _ => true,
        }
    }
}

/// The exact, event-driven run of a scene, in a plane that does not repeat (for one that
/// does see [`Periodic`]).
#[derive(Clone, Debug)]
pub struct Timeline<S: Timed> {
    flights: Flights<S>,
    arbiter: S::Arbiter,
    forecaster: Forecaster,
    forecasts: Vec<Option<Forecast<S>>>,
    /// The forecasts' lower bounds.
    queue: Queue,
    /// The discs whose forecasts may be the first, and what they come to.
    front: Vec<usize>,
    ahead: Ahead,
    candidates: Vec<Candidate>,
    /// The discs of which it took a proof that what they meet first happens at
    /// the time of the first impact of all.
    tied: Vec<usize>,
    /// What each disc has grazed since it last changed, and the partner's
    /// turn then.
    grazed: Notes,
    /// What each disc has parted from when a cluster was resolved, and the
    /// partner's turn then.
    parted: Notes,
    nested: Nested,
    rule: Simultaneous,
    /// The times at which clusters jam, by their names.
    jammed: BTreeSet<u64>,
    /// Impacts that have been resolved and not told yet.
    pending: VecDeque<Impact<S>>,
    now: S,
    turn: u64,
    grazes: u64,
    rests: u64,
    /// How often discs have come to rest, or grazed, at the present time.
    pauses: usize,
    /// The least relative difference of the first two different times, at any
    /// impact.
    closest: f64,
    negligible: f64,
    /// What looks for accumulations, where there may be any.
    watch: Option<Watch<S>>,
    /// What looks for discs that are stuck from the start.
    jams: Jams,
}

impl<S: Timed> Timeline<S> {
    /// The run of a world from time zero to `until`.
    ///
    /// # Errors
    ///
    /// It cannot be decided what the discs meet first.
    pub fn new(world: World<S>, until: &S) -> Result<Self, S::Doubt> {
        Self::with_setup(world, until, &Setup::default())
    }

    /// The same, set up otherwise than by default.
    ///
    /// # Errors
    ///
    /// It cannot be decided what the discs meet first.
    pub fn with_setup(world: World<S>, until: &S, setup: &Setup<'_>) -> Result<Self, S::Doubt> {
        let count = world.discs.len();
        let nested = Nested::find(&world);
        let arbiter = S::Arbiter::new(&world, setup.symmetries);
        let watch = Watch::over(&world, until);
        let flights = Flights::new(world);
        let mut timeline = Self {
            forecaster: Forecaster::new(&flights, until, setup.broad_phase),
            flights,
            arbiter,
            forecasts: vec![None; count],
            queue: Queue::new(count),
            front: Vec::new(),
            ahead: Ahead::new::<S>(count),
            candidates: Vec::new(),
            tied: Vec::new(),
            grazed: Notes::default(),
            parted: Notes::default(),
            rule: setup.simultaneous,
            jammed: BTreeSet::new(),
            pending: VecDeque::new(),
            nested,
            now: S::from_integer(0),
            turn: 0,
            grazes: 0,
            rests: 0,
            pauses: 0,
            closest: f64::INFINITY,
            negligible: until.hull().hi() * NEGLIGIBLE,
            watch,
            jams: Jams::default(),
        };
        for disc in 0..count {
            timeline.forecast_with(disc, Partners::Later, Effort::Bounds)?;
        }
        Ok(timeline)
    }

    /// The next impact, if it is not after `limit`. There is none if
    /// infinitely many precede that (see [`accumulation`](Self::accumulation)).
    ///
    /// # Errors
    ///
    /// It cannot be decided which impact is the next.
    pub fn next_impact(&mut self, limit: &S) -> Result<Option<Impact<S>>, S::Doubt> {
        loop {
            if self.pending.is_empty() && self.accumulates(limit) {
                return Ok(None);
            }
            if let Some(impact) = self.pending.pop_front() {
                self.observe(&impact);
                return Ok(Some(impact));
            }
            let Some(disc) = self.first(limit)? else {
                return Ok(None);
            };
            if !self.tied.is_empty() {
                self.gather(disc)?;
                continue;
            }
            if !S::IS_STRAIGHT && self.rest(disc)? {
                continue;
            }
            if self.resolve_at_once(disc)? {
                continue;
            }
            let Some(next) = self.forecasts[disc].take() else {
                return Ok(None);
            };
            if next.is_graze() {
                self.pass(disc, &next)?;
            } else {
                let impact = self.resolve(disc, next)?;
                self.observe(&impact);
                return Ok(Some(impact));
            }
        }
    }

    /// How many tangent passes there were so far.
    pub fn grazes(&self) -> u64 {
        self.grazes
    }

    /// How many contacts became resting so far.
    pub fn rests(&self) -> u64 {
        self.rests
    }

    /// The least difference, relative to either, of two different times of which
    /// it had to be found out which is the first; or less, if bounds were
    /// enough. Exact arithmetic only.
    pub fn closest_call(&self) -> Option<f64> {
        let closest = self.closest.min(self.forecaster.closest());
        closest.is_finite().then_some(closest)
    }

    /// How many discs there are.
    pub fn disc_count(&self) -> usize {
        self.forecasts.len()
    }

    /// The time of the latest impact.
    pub fn now(&self) -> &S {
        &self.now
    }

    /// The discs as they are kept: each where its own last impact left it, with
    /// the time of that.
    pub fn bodies(&self) -> impl Iterator<Item = (&Disc<S>, &S)> {
        let starts = self.flights.starts.iter().map(|start| &start.since);
        self.flights.world.discs.iter().zip(starts)
    }

    /// The discs as they are at a time: not before the latest impact, nor
    /// after the next one.
    pub fn discs_at(&self, time: &S) -> Vec<Disc<S>> {
        let discs = 0..self.forecasts.len();
        discs.map(|disc| self.flights.disc_at(disc, time)).collect()
    }

    /// Notes a tangent pass, after which the disc goes on.
    fn pass(&mut self, disc: usize, forecast: &Forecast<S>) -> Result<(), S::Doubt> {
        self.grazes += 1;
        if !S::IS_STRAIGHT {
            return self.skim(disc, forecast);
        }
        if let Some(feature) = forecast.feature() {
            self.note_graze(disc, feature);
            if let Feature::Disc(other) = feature {
                self.note_graze(other as usize, Feature::Disc(disc as u32));
            }
        }
        self.forecast(disc, Effort::Bounds)
    }

    fn note_graze(&mut self, disc: usize, feature: Feature) {
        let turn = self.flights.turn_of(feature);
        self.grazed.add(disc, feature, turn);
    }

    fn has_grazed(&self, disc: usize, feature: Feature) -> bool {
        let turn = self.flights.turn_of(feature);
        self.grazed.of(disc).contains(&(feature, turn))
    }

    /// The discs that an impact changes.
    fn movable(&self, disc: usize, feature: Feature) -> impl Iterator<Item = usize> + use<S> {
        self.changed(disc, feature).into_iter().flatten()
    }

    /// Those of its first and of its second body that an impact changes.
    fn changed(&self, disc: usize, feature: Feature) -> [Option<usize>; 2] {
        let other = match feature {
            Feature::Disc(other) => Some(other as usize),
            Feature::Wall(_) | Feature::Corner(_) => None,
        };
        let discs = &self.flights.world.discs;
        let changes = |index: &usize| discs[*index].is_movable();
        [Some(disc).filter(changes), other.filter(changes)]
    }

    fn forecast(&mut self, disc: usize, effort: Effort) -> Result<(), S::Doubt> {
        self.forecast_with(disc, Partners::All, effort)
    }

    fn forecast_with(
        &mut self,
        disc: usize,
        partners: Partners,
        effort: Effort,
    ) -> Result<(), S::Doubt> {
        let (flights, grazed, nested) = (&self.flights, self.grazed.of(disc), &self.nested);
        let skips = |obstacle, feature, inside| {
            let grazed =
                !grazed.is_empty() && grazed.contains(&(feature, flights.turn_of(feature)));
            grazed || inside && nested.holds(disc, obstacle)
        };
        let next = if flights.world.discs[disc].is_movable() {
            let parted = self.parted.of(disc);
            let world = &flights.world;
            let wanted = |obstacle| {
                let holds = |&(feature, turn): &(Feature, u64)| {
                    flights.turn_of(feature) == turn && world.is_part_of(feature, obstacle)
                };
                partners.include(world, disc, obstacle)
                    && (parted.is_empty() || !parted.iter().any(holds))
            };
            let arbiter = &mut self.arbiter;
            self.forecaster
                .forecast(flights, disc, effort, arbiter, (wanted, skips))?
        } else {
            None
        };
        let key = next.as_ref().map_or(f64::INFINITY, |next| next.bounds.lo());
        self.queue.set(disc, key);
        self.forecasts[disc] = next;
        Ok(())
    }
}
