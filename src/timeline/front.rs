//! Which forecast comes true next.
//!
//! The *front* are the forecasts that may be the earliest, by their bounds.
//! Those that no longer hold are made anew, and what bounds do not tell apart
//! is computed and compared.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::Timeline;
use super::arbiter::{Arbiter, Foreseen, Timed};
use super::forecast::{Effort, Forecast};
use super::meeting::Meeting;
use crate::body::{End, Pair};
use crate::kernel::{Kernel, Time};
use crate::scalar::{Doubt, Interval};

/// A forecast as a candidate for the next impact.
#[derive(Clone, Debug)]
pub(super) struct Candidate {
    pub(super) disc: usize,
    names: (Pair, Option<End>),
}

impl<S: Timed> Timeline<S> {
    /// The disc whose forecast comes true next, if that is not after a limit.
    pub(super) fn first(&mut self, limit: &S) -> Result<Option<usize>, S::Doubt> {
        let latest = limit.hull().hi().min(f64::MAX);
        while self.queue.least() <= latest {
            self.collect_front();
            self.look_ahead();
            if self.refresh()? {
                continue;
            }
            self.nominate();
            if self.candidates.len() > 1 && self.compute_front()? {
                continue;
            }
            let first = self.choose()?;
            if let Some(is_due) = self.is_due(first, limit)? {
                self.note_margin(first);
                return Ok(is_due.then_some(first));
            }
        }
        Ok(None)
    }

    /// Notes how far the next forecast is from the first one, where bounds tell
    /// them apart.
    fn note_margin(&mut self, first: usize) {
        if S::ROUNDS || self.candidates.len() > 1 {
            return;
        }
        let Some(next) = &self.forecasts[first] else {
            return;
        };
        let end = next.bounds.hi();
        let margin = |key: f64| (key - end) / end;
        // Discs that leave their neighbours are in the queue as well.
        if margin(self.queue.least_but(first)) < self.closest {
            let others = self.forecasts.iter().enumerate();
            let others = others.filter(|(disc, _)| *disc != first);
            let keys = others.filter_map(|(_, next)| {
                let next = next.as_ref().filter(|next| !next.is_leaving())?;
                Some(next.bounds.lo())
            });
            let margin = margin(keys.fold(f64::INFINITY, f64::min));
            if margin > 0.0 {
                self.closest = self.closest.min(margin);
            }
        }
    }

    /// Collects the discs whose forecasts may come true no later than that
    /// with the least lower bound.
    fn collect_front(&mut self) {
        let forecasts = &self.forecasts;
        let end = |disc: usize| {
            let next = forecasts[disc].as_ref();
            next.map_or(f64::NEG_INFINITY, |next| next.bounds.hi())
        };
        self.queue.collect_front(end, &mut self.front);
    }

    /// Makes one forecast of the front anew, if one no longer holds, or does
    /// not go far enough. One that is still contested when it may come true
    /// ends the run.
    fn refresh(&mut self) -> Result<bool, S::Doubt> {
        // Mostly there is nothing to do, which one look at the front tells.
        let is_in_doubt = |timeline: &Self, disc, next: &Forecast<S>| {
            let is_vague = next.is_open() || next.is_leaving() || next.contested.is_some();
            is_vague || timeline.is_void(disc, next)
        };
        if self.find(is_in_doubt).is_none() {
            return Ok(false);
        }
        if let Some(disc) = self.find(|timeline, disc, next| timeline.is_void(disc, next)) {
            self.forecast(disc, Effort::Bounds)?;
            return Ok(true);
        }
        if let Some(disc) = self.find(|_, _, next| next.is_open()) {
            self.forecast(disc, Effort::Numbers)?;
            return Ok(true);
        }
        if let Some(disc) = self.find(|_, _, next| next.is_leaving()) {
            self.renew(disc)?;
            return Ok(true);
        }
        let Some(disc) = self.find(|_, _, next| next.contested.is_some()) else {
            return Ok(false);
        };
        self.forecast(disc, Effort::Numbers)?;
        let still = self.forecasts[disc].as_ref();
        match still.and_then(|next| next.contested.clone()) {
            Some(doubt) => Err(doubt),
            None => Ok(true),
        }
    }

    /// Looks further for a disc that leaves its neighbours. None of the others'
    /// forecasts comes true before.
    fn renew(&mut self, disc: usize) -> Result<(), S::Doubt> {
        let time = self.queue.least();
        self.forecaster.renew(&self.flights, disc, time);
        self.forecast(disc, Effort::Bounds)
    }

    /// The first disc of the front with such a forecast.
    #[inline]
    fn find(&self, is_sought: impl Fn(&Self, usize, &Forecast<S>) -> bool) -> Option<usize> {
        let is_sought = |disc: &usize| {
            let next = self.forecasts[*disc].as_ref();
            next.is_some_and(|next| is_sought(self, *disc, next))
        };
        self.front.iter().copied().find(is_sought)
    }

    /// Whether a forecast does not hold any more.
    #[inline]
    fn is_void(&self, disc: usize, next: &Forecast<S>) -> bool {
        let has_grazed = |feature| self.has_grazed(disc, feature);
        next.is_stale(&self.flights) || next.is_graze() && next.feature().is_some_and(has_grazed)
    }

    /// Makes the front candidates, each pair once and in the order of names.
    fn nominate(&mut self) {
        self.candidates.clear();
        for &disc in &self.front {
            let next = self.forecasts[disc].as_ref();
            if let Some(feature) = next.and_then(Forecast::feature) {
                let names = self.flights.world.names(disc, feature);
                self.candidates.push(Candidate { disc, names });
            }
        }
        if let [first, second] = &self.candidates[..]
            && first.names == second.names
        {
            self.candidates.truncate(1);
        }
        if self.candidates.len() > 1 {
            self.candidates.sort_by_key(|candidate| candidate.names);
            self.candidates.dedup_by_key(|candidate| candidate.names);
        }
    }

    /// Computes what of the candidates is known by bounds alone, and tells
    /// whether there was any.
    fn compute_front(&mut self) -> Result<bool, S::Doubt> {
        let mut computed = false;
        for candidate in 0..self.candidates.len() {
            computed |= self.compute(self.candidates[candidate].disc)?;
        }
        Ok(computed)
    }

    /// Computes a forecast, if it is known by bounds alone.
    pub(super) fn compute(&mut self, disc: usize) -> Result<bool, S::Doubt> {
        match &mut self.forecasts[disc] {
            Some(next) if next.meeting().is_none() => {
                next.compute(&self.flights, disc, &mut self.arbiter)?;
                self.queue.set(disc, next.bounds.lo());
                Ok(true)
            }
            _ => Ok(false),
        }
    }

    /// The candidate that comes first; of those at one time, by name.
    fn choose(&mut self) -> Result<usize, S::Doubt> {
        let mut first = &self.candidates[0];
        for candidate in &self.candidates[1..] {
            let [met, earliest] = [candidate, first].map(|one| met_by(&self.forecasts, one).1);
            match met.time.order(&earliest.time) {
                Ok(Equal) => {}
                Ok(order) => {
                    if !S::ROUNDS {
                        self.closest = self.closest.min(met.apart(earliest));
                    }
                    if order == Less {
                        first = candidate;
                    }
                }
                Err(_) => return self.choose_by_proof(),
            }
        }
        Ok(first.disc)
    }

    /// A candidate that none precedes, where numbers do not decide every
    /// order.
    fn choose_by_proof(&mut self) -> Result<usize, S::Doubt> {
        let mut doubt = None;
        for place in 0..self.candidates.len() {
            match self.is_preceded(place) {
                Ok(false) => {
                    self.note_ties(place);
                    return Ok(self.candidates[place].disc);
                }
                Ok(true) => {}
                Err(open) => doubt = doubt.or(Some(open)),
            }
        }
        // One is preceded by none, unless a decision is open.
        doubt.map_or(Ok(self.candidates[0].disc), Err)
    }

    fn is_preceded(&mut self, place: usize) -> Result<bool, S::Doubt> {
        for other in 0..self.candidates.len() {
            if other != place && self.order(other, place)? == Less {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The order of two candidates in time; none has to be if they commute.
    fn order(&mut self, one: usize, other: usize) -> Result<Ordering, S::Doubt> {
        let [one, other] = [one, other].map(|place| self.candidates[place].clone());
        let [first, second] = [&one, &other].map(|one| met_by(&self.forecasts, one));
        let order = self.flights.order(first, second, &mut self.arbiter);
        order.or_else(|doubt| {
            let commute = !one.names.0.shares_disc(&other.names.0);
            let apart = first.1.time.value() - &second.1.time.value();
            if commute && is_negligible(&apart.hull(), self.negligible) {
                return Ok(Equal);
            }
            let (first, second) = (one.names.0, other.names.0);
            Err(doubt.asking(|| format!("whether {first} or {second} meet first")))
        })
    }

    /// Notes which candidates it takes a proof to know as simultaneous with
    /// the first one. Tangent passes change nothing, whatever their order.
    fn note_ties(&mut self, first: usize) {
        for other in 0..self.candidates.len() {
            if other != first && self.are_tied(first, other) {
                self.tied.push(self.candidates[other].disc);
            }
        }
    }

    fn are_tied(&mut self, one: usize, other: usize) -> bool {
        let [one, other] = [one, other].map(|place| &self.candidates[place]);
        let [one, other] = [one, other].map(|one| met_by(&self.forecasts, one));
        let [first, second] = [one.1, other.1];
        !first.graze
            && !second.graze
            && (first.moment.is_none() || first.moment != second.moment)
            && first.time.order(&second.time).is_err()
            && matches!(self.flights.order(one, other, &mut self.arbiter), Ok(Equal))
    }

    /// Whether a forecast comes true no later than a limit; none if it had to
    /// be computed for that.
    fn is_due(&mut self, disc: usize, limit: &S) -> Result<Option<bool>, S::Doubt> {
        let next = self.forecasts[disc].as_ref();
        let next = next.expect("a candidate has a forecast");
        if next.bounds.hi() <= limit.hull().lo() {
            return Ok(Some(true));
        }
        let Some(meeting) = next.meeting() else {
            return self.compute(disc).map(|_| None);
        };
        let order = meeting.time.order_to(limit).or_else(|doubt| {
            let doubt = doubt.asking(|| format!("whether d{disc} meets anything before the end"));
            let met = Foreseen::meeting(disc, meeting);
            self.arbiter.order_to(&self.flights, &met, limit, doubt)
        })?;
        Ok(Some(order != Greater))
    }
}

/// The disc of a candidate among several, and what it meets.
fn met_by<'a, S: Kernel>(
    forecasts: &'a [Option<Forecast<S>>],
    candidate: &Candidate,
) -> (usize, &'a Meeting<S>) {
    let next = forecasts[candidate.disc].as_ref();
    let meeting = next.and_then(Forecast::meeting);
    (candidate.disc, meeting.expect("candidates are computed"))
}

/// Whether a number is surely between a limit and its negative.
pub(super) fn is_negligible(apart: &Interval, limit: f64) -> bool {
    -limit <= apart.lo() && apart.hi() <= limit
}
