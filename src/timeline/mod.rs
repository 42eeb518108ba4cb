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
//! Simultaneous impacts follow the `sequential` rule (D17): one pair at a time,
//! in the order of their names, until no touching pair approaches.

mod accumulation;
mod arbiter;
mod flight;
mod forecast;
mod front;
mod nested;
mod queue;
mod sweep;
mod ties;

use crate::body::{Disc, Feature};
use crate::impact::Impact;
use crate::symmetry::Symmetry;
use crate::world::World;
use accumulation::Watch;
pub use arbiter::Timed;
use arbiter::{Arbiter, Foreseen};
use flight::{Flights, Meeting};
use forecast::{Effort, Forecast, Forecaster, Outlook, Partners};
use front::Candidate;
use nested::Nested;
use queue::Queue;

pub use accumulation::Accumulation;

/// The exact, event-driven run of a scene.
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
    candidates: Vec<Candidate>,
    /// The discs of which it took a proof that what they meet first happens at
    /// the time of the first impact of all.
    tied: Vec<usize>,
    /// What each disc has grazed since it last changed, and the partner's
    /// turn then.
    grazed: Vec<Vec<(Feature, u64)>>,
    nested: Nested,
    now: S,
    turn: u64,
    grazes: u64,
    negligible: f64,
    /// What looks for accumulations, where there may be any.
    watch: Option<Watch<S>>,
}

impl<S: Timed> Timeline<S> {
    /// The run of a world from time zero to `until`.
    ///
    /// # Errors
    ///
    /// It cannot be decided what the discs meet first.
    pub fn new(world: World<S>, until: &S) -> Result<Self, S::Doubt> {
        Self::with_symmetries(world, until, &[])
    }

    /// The run of a world that is known to have these symmetries.
    ///
    /// # Errors
    ///
    /// It cannot be decided what the discs meet first.
    pub(crate) fn with_symmetries(
        world: World<S>,
        until: &S,
        symmetries: &[Symmetry],
    ) -> Result<Self, S::Doubt> {
        let count = world.discs.len();
        let nested = Nested::find(&world);
        let arbiter = S::Arbiter::new(&world, symmetries);
        let watch = Watch::over(&world, until);
        let flights = Flights::new(world);
        let mut timeline = Self {
            forecaster: Forecaster::new(&flights, until),
            flights,
            arbiter,
            forecasts: vec![None; count],
            queue: Queue::new(count),
            front: Vec::new(),
            candidates: Vec::new(),
            tied: Vec::new(),
            grazed: vec![Vec::new(); count],
            nested,
            now: S::from_integer(0),
            turn: 0,
            grazes: 0,
            negligible: until.hull().hi() * 2f64.powi(-1000),
            watch,
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
        if self.accumulates(limit) {
            return Ok(None);
        }
        while let Some(disc) = self.first(limit)? {
            self.compute(disc)?;
            if !self.tied.is_empty() {
                self.gather(disc)?;
                continue;
            }
            let next = self.forecasts[disc].take();
            let Some(Outlook::Computed(meeting, _)) = next.map(|next| next.outlook) else {
                break;
            };
            if meeting.graze {
                self.pass(disc, meeting.feature)?;
            } else {
                let impact = self.resolve(disc, meeting)?;
                self.observe(&impact);
                return Ok(Some(impact));
            }
        }
        Ok(None)
    }

    /// How many tangent passes there were so far.
    pub fn grazes(&self) -> u64 {
        self.grazes
    }

    /// How many discs there are.
    pub fn disc_count(&self) -> usize {
        self.forecasts.len()
    }

    /// The time of the latest impact.
    pub fn now(&self) -> &S {
        &self.now
    }

    /// The discs as they are at a time: not before the latest impact, nor
    /// after the next one.
    pub fn discs_at(&self, time: &S) -> Vec<Disc<S>> {
        let discs = 0..self.forecasts.len();
        discs.map(|disc| self.flights.disc_at(disc, time)).collect()
    }

    /// Notes a tangent pass, after which the disc goes on.
    fn pass(&mut self, disc: usize, feature: Feature) -> Result<(), S::Doubt> {
        self.grazes += 1;
        self.note_graze(disc, feature);
        if let Feature::Disc(other) = feature {
            self.note_graze(other as usize, Feature::Disc(disc as u32));
        }
        self.forecast(disc, Effort::Bounds)
    }

    fn note_graze(&mut self, disc: usize, feature: Feature) {
        let turn = self.flights.turn_of(feature);
        self.grazed[disc].push((feature, turn));
    }

    fn has_grazed(&self, disc: usize, feature: Feature) -> bool {
        let turn = self.flights.turn_of(feature);
        self.grazed[disc].contains(&(feature, turn))
    }

    /// Resolves an impact, and forecasts what comes of it.
    fn resolve(&mut self, disc: usize, meeting: Meeting<S>) -> Result<Impact<S>, S::Doubt> {
        let (disc, feature) = in_order(disc, meeting.feature);
        let meeting = Meeting { feature, ..meeting };
        self.turn += 1;
        // A rounded time may have been lifted: it is none that has a name.
        let named = meeting.moment.filter(|_| !S::ROUNDS);
        let moment = named.unwrap_or(self.turn);
        let met = Foreseen {
            disc,
            meeting: &meeting,
        };
        let changed = self.changed(disc, feature);
        self.arbiter.note(&met, changed, moment);
        let time = meeting.time.not_before(&self.now);
        for changed in self.movable(disc, feature) {
            self.flights.bring(changed, &time, moment, self.turn);
        }
        let place = self.flights.place(disc, feature, &time, meeting.overlap);
        let world = &mut self.flights.world;
        let contact = world.collide(disc, feature, place)?;
        world.contacts.join(disc, feature);
        self.nested.part(world, disc, feature);
        let (pair, end) = world.names(disc, feature);
        for changed in self.movable(disc, feature) {
            self.grazed[changed].clear();
            self.forecaster.update(&self.flights, changed);
        }
        for changed in self.movable(disc, feature) {
            self.forecast(changed, Effort::Bounds)?;
        }
        self.now = time.clone();
        Ok(Impact {
            time,
            moment: Some(moment),
            other_time: None,
            pair,
            end,
            tie: None,
            step: None,
            contact: Some(Box::new(contact)),
        })
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
        let (flights, grazed, nested) = (&self.flights, &self.grazed[disc], &self.nested);
        let skips = |feature, overlap| {
            let grazed =
                !grazed.is_empty() && grazed.contains(&(feature, flights.turn_of(feature)));
            grazed || overlap && nested.holds(&flights.world, disc, feature)
        };
        let next = if flights.world.discs[disc].is_movable() {
            let arbiter = &mut self.arbiter;
            let scope = (partners, effort);
            self.forecaster
                .forecast(flights, disc, scope, arbiter, skips)?
        } else {
            None
        };
        let key = next.as_ref().map_or(f64::INFINITY, |next| next.bounds.lo());
        self.queue.set(disc, key);
        self.forecasts[disc] = next;
        Ok(())
    }
}

/// Of two discs the lower first.
fn in_order(disc: usize, feature: Feature) -> (usize, Feature) {
    match feature {
        Feature::Disc(other) if (other as usize) < disc => {
            (other as usize, Feature::Disc(disc as u32))
        }
        _ => (disc, feature),
    }
}
