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

mod flight;
mod forecast;
mod nested;
mod step;

use std::cmp::Ordering::{self, Equal, Greater, Less};

use crate::body::{Disc, End, Feature, Pair};
use crate::impact::{Contact, Impact};
use crate::scalar::{Doubt, Scalar};
use crate::world::World;
use flight::{Flights, Meeting};
use forecast::{Forecast, Forecaster, Partners};
use nested::Nested;

/// The exact, event-driven run of a scene.
#[derive(Clone, Debug)]
pub struct Timeline<S: Scalar> {
    flights: Flights<S>,
    forecaster: Forecaster,
    forecasts: Vec<Option<Forecast<S>>>,
    /// What each disc has grazed since it last changed, and the partner's
    /// turn then.
    grazed: Vec<Vec<(Feature, u64)>>,
    nested: Nested,
    now: S,
    turn: u64,
    grazes: u64,
    negligible: f64,
}

/// A forecast as a candidate for the next impact.
struct Candidate {
    disc: usize,
    names: (Pair, Option<End>),
}

impl<S: Scalar> Timeline<S> {
    /// The run of a world from time zero to `until`.
    ///
    /// # Errors
    ///
    /// It cannot be decided what the discs meet first.
    pub fn new(world: World<S>, until: &S) -> Result<Self, S::Doubt> {
        let count = world.discs.len();
        let nested = Nested::find(&world);
        let flights = Flights::new(world);
        let mut timeline = Self {
            forecaster: Forecaster::new(&flights, until),
            flights,
            forecasts: vec![None; count],
            grazed: vec![Vec::new(); count],
            nested,
            now: S::from_integer(0),
            turn: 0,
            grazes: 0,
            negligible: until.hull().hi() * 2f64.powi(-1000),
        };
        for disc in 0..count {
            timeline.forecast_with(disc, Partners::Later)?;
        }
        Ok(timeline)
    }

    /// The next impact, if it is not after `limit`.
    ///
    /// # Errors
    ///
    /// It cannot be decided which impact is the next.
    pub fn next_impact(&mut self, limit: &S) -> Result<Option<Impact<S>>, S::Doubt> {
        while let Some(disc) = self.first(limit)? {
            let Some(forecast) = self.forecasts[disc].take() else {
                break;
            };
            if forecast.meeting.graze {
                self.pass(disc, &forecast)?;
            } else {
                return self.resolve(disc, forecast).map(Some);
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

    /// The disc whose forecast comes true next.
    fn first(&mut self, limit: &S) -> Result<Option<usize>, S::Doubt> {
        let latest = limit.hull().hi();
        loop {
            let Some(end) = self.end_of_first(latest) else {
                return Ok(None);
            };
            if self.refresh(end)? {
                continue;
            }
            let first = self.choose(&self.candidates(end))?;
            return Ok(self.is_due(first, limit)?.then_some(first));
        }
    }

    /// The upper bound of the forecast with the least lower bound.
    fn end_of_first(&self, latest: f64) -> Option<f64> {
        let bounds = self.forecasts.iter().flatten().map(|next| next.bounds);
        let first = bounds.min_by(|one, other| one.lo().total_cmp(&other.lo()))?;
        (first.lo() <= latest).then_some(first.hi())
    }

    /// The discs whose forecasts may come true before a time.
    fn front(&self, end: f64) -> impl Iterator<Item = (usize, &Forecast<S>)> {
        let forecasts = self.forecasts.iter().enumerate();
        forecasts.filter_map(move |(disc, next)| {
            let next = next.as_ref()?;
            (next.bounds.lo() <= end).then_some((disc, next))
        })
    }

    /// Makes one forecast of the front anew, if one no longer holds. One that
    /// is still contested when it may come true ends the run.
    fn refresh(&mut self, end: f64) -> Result<bool, S::Doubt> {
        let stale = self.front(end).find(|(disc, next)| {
            next.is_stale(&self.flights)
                || next.meeting.graze && self.has_grazed(*disc, next.meeting.feature)
        });
        if let Some((disc, _)) = stale {
            self.forecast(disc)?;
            return Ok(true);
        }
        let contested = self.front(end).find_map(|(disc, next)| {
            let doubt = next.contested.clone()?;
            Some((disc, doubt))
        });
        let Some((disc, _)) = contested else {
            return Ok(false);
        };
        self.forecast(disc)?;
        let still = self.forecasts[disc].as_ref();
        match still.and_then(|next| next.contested.clone()) {
            Some(doubt) => Err(doubt),
            None => Ok(true),
        }
    }

    /// The candidates of the front, each pair once.
    fn candidates(&self, end: f64) -> Vec<Candidate> {
        let mut candidates: Vec<_> = self
            .front(end)
            .map(|(disc, next)| Candidate {
                disc,
                names: self.flights.world.names(disc, next.meeting.feature),
            })
            .collect();
        if candidates.len() > 1 {
            candidates.sort_by_key(|candidate| candidate.names);
            candidates.dedup_by_key(|candidate| candidate.names);
        }
        candidates
    }

    /// The candidate that comes first; of those at one time, by name.
    fn choose(&self, candidates: &[Candidate]) -> Result<usize, S::Doubt> {
        let mut first = &candidates[0];
        for candidate in &candidates[1..] {
            match self.time(candidate.disc).compare(self.time(first.disc)) {
                Ok(Less) => first = candidate,
                Ok(Equal | Greater) => {}
                Err(_) => return self.choose_among_commuting(candidates),
            }
        }
        Ok(first.disc)
    }

    /// A candidate that none precedes, where not every order is decided.
    fn choose_among_commuting(&self, candidates: &[Candidate]) -> Result<usize, S::Doubt> {
        let mut doubt = None;
        for candidate in candidates {
            match self.is_preceded(candidate, candidates) {
                Ok(false) => return Ok(candidate.disc),
                Ok(true) => {}
                Err(open) => doubt = doubt.or(Some(open)),
            }
        }
        // One is preceded by none, unless a decision is open.
        doubt.map_or(Ok(candidates[0].disc), Err)
    }

    fn is_preceded(&self, one: &Candidate, all: &[Candidate]) -> Result<bool, S::Doubt> {
        for other in all {
            if one.names != other.names && self.order(other, one)? == Less {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The order of two candidates in time; none has to be if they commute.
    fn order(&self, one: &Candidate, other: &Candidate) -> Result<Ordering, S::Doubt> {
        let [first, second] = [one, other].map(|candidate| self.time(candidate.disc));
        first.compare(second).or_else(|doubt| {
            let commute = !one.names.0.shares_disc(&other.names.0);
            if commute && self.is_negligible(&(first.clone() - second)) {
                return Ok(Equal);
            }
            let (first, second) = (one.names.0, other.names.0);
            Err(doubt.asking(|| format!("whether {first} or {second} meet first")))
        })
    }

    fn is_negligible(&self, apart: &S) -> bool {
        let apart = apart.hull();
        -self.negligible <= apart.lo() && apart.hi() <= self.negligible
    }

    fn time(&self, disc: usize) -> &S {
        let next = self.forecasts[disc].as_ref();
        &next.expect("a candidate has a forecast").meeting.time
    }

    fn is_due(&self, disc: usize, limit: &S) -> Result<bool, S::Doubt> {
        let order = self.time(disc).compare(limit);
        let asking = || format!("whether d{disc} meets anything before the end");
        Ok(order.map_err(|doubt| doubt.asking(asking))? != Greater)
    }

    /// Notes a tangent pass, after which the disc goes on.
    fn pass(&mut self, disc: usize, forecast: &Forecast<S>) -> Result<(), S::Doubt> {
        let feature = forecast.meeting.feature;
        self.grazes += 1;
        self.note_graze(disc, feature);
        if let Feature::Disc(other) = feature {
            self.note_graze(other as usize, Feature::Disc(disc as u32));
        }
        self.forecast(disc)
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
    fn resolve(&mut self, disc: usize, forecast: Forecast<S>) -> Result<Impact<S>, S::Doubt> {
        let meeting = forecast.meeting;
        let (disc, feature) = in_order(disc, meeting.feature);
        self.turn += 1;
        let (time, contact) = match self.leap(disc, feature, &meeting) {
            Some(leapt) => leapt,
            None => self.walk(disc, feature, meeting)?,
        };
        let world = &mut self.flights.world;
        world.contacts.join(disc, feature);
        self.nested.part(world, disc, feature);
        let (pair, end) = world.names(disc, feature);
        for changed in self.movable(disc, feature) {
            self.grazed[changed].clear();
            self.forecaster.update(&self.flights, changed);
        }
        for changed in self.movable(disc, feature) {
            self.forecast(changed)?;
        }
        self.now = time.clone();
        Ok(Impact {
            time,
            other_time: None,
            pair,
            end,
            tie: None,
            step: None,
            contact,
        })
    }

    /// Takes the bodies of an impact to its time, and lets them collide.
    fn walk(
        &mut self,
        disc: usize,
        feature: Feature,
        meeting: Meeting<S>,
    ) -> Result<(S, Contact<S>), S::Doubt> {
        let time = meeting.time.not_before(&self.now);
        // A rounded time may have been lifted: it is none that has a name.
        let named = meeting.moment.filter(|_| !S::ROUNDS);
        let moment = named.unwrap_or(self.turn);
        for changed in self.movable(disc, feature) {
            self.flights.bring(changed, &time, moment, self.turn);
        }
        let place = self.flights.place(disc, feature, &time, meeting.overlap);
        let contact = self.flights.world.collide(disc, feature, place)?;
        Ok((time, contact))
    }

    /// The same in one step, where the arithmetic knows one that is better.
    fn leap(
        &mut self,
        disc: usize,
        feature: Feature,
        meeting: &Meeting<S>,
    ) -> Option<(S, Contact<S>)> {
        if meeting.overlap {
            return None;
        }
        let time = self.flights.leap(disc, feature, self.turn)?;
        S::rebase(self.flights.numbers());
        let place = self.flights.place(disc, feature, &time, false);
        let contact = self.flights.world.collided(disc, feature, place);
        Some((time.bare(), contact.map(S::bare)))
    }

    /// The discs that an impact changes.
    fn movable(&self, disc: usize, feature: Feature) -> impl Iterator<Item = usize> + use<S> {
        let other = match feature {
            Feature::Disc(other) => Some(other as usize),
            Feature::Wall(_) | Feature::Corner(_) => None,
        };
        let discs = &self.flights.world.discs;
        let changes = |index: &usize| discs[*index].is_movable();
        let changed = [Some(disc).filter(changes), other.filter(changes)];
        changed.into_iter().flatten()
    }

    fn forecast(&mut self, disc: usize) -> Result<(), S::Doubt> {
        self.forecast_with(disc, Partners::All)
    }

    fn forecast_with(&mut self, disc: usize, partners: Partners) -> Result<(), S::Doubt> {
        let (flights, grazed, nested) = (&self.flights, &self.grazed[disc], &self.nested);
        let skips = |feature, overlap| {
            let grazed =
                !grazed.is_empty() && grazed.contains(&(feature, flights.turn_of(feature)));
            grazed || overlap && nested.holds(&flights.world, disc, feature)
        };
        self.forecasts[disc] = if flights.world.discs[disc].is_movable() {
            self.forecaster.forecast(flights, disc, partners, skips)?
        } else {
            None
        };
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
