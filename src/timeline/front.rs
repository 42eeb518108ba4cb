//! Which forecast comes true next.
//!
//! The *front* are the forecasts that may be the earliest, by their bounds.
//! Those that no longer hold are made anew, and what bounds do not tell apart
//! is computed and compared.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::Timeline;
use super::forecast::Forecast;
use crate::body::{End, Pair};
use crate::scalar::{Doubt, Scalar};

/// A forecast as a candidate for the next impact.
#[derive(Clone, Debug)]
pub(super) struct Candidate {
    disc: usize,
    names: (Pair, Option<End>),
}

impl<S: Scalar> Timeline<S> {
    /// The disc whose forecast comes true next, if that is not after a limit.
    pub(super) fn first(&mut self, limit: &S) -> Result<Option<usize>, S::Doubt> {
        let latest = limit.hull().hi().min(f64::MAX);
        while self.queue.least() <= latest {
            self.collect_front();
            if self.refresh()? {
                continue;
            }
            self.nominate();
            if self.candidates.len() > 1 && self.compute_front()? {
                continue;
            }
            let first = self.choose()?;
            if let Some(is_due) = self.is_due(first, limit)? {
                return Ok(is_due.then_some(first));
            }
        }
        Ok(None)
    }

    /// Collects the discs whose forecasts may come true no later than that
    /// with the least lower bound.
    fn collect_front(&mut self) {
        let first = self.forecasts[self.queue.least_slot()].as_ref();
        let end = first.map_or(f64::NEG_INFINITY, |first| first.bounds.hi());
        self.queue.collect_up_to(end, &mut self.front);
    }

    /// Makes one forecast of the front anew, if one no longer holds. One that
    /// is still contested when it may come true ends the run.
    fn refresh(&mut self) -> Result<bool, S::Doubt> {
        if let Some(disc) = self.find(|timeline, disc, next| timeline.is_void(disc, next)) {
            self.forecast(disc)?;
            return Ok(true);
        }
        let Some(disc) = self.find(|_, _, next| next.contested.is_some()) else {
            return Ok(false);
        };
        self.forecast(disc)?;
        let still = self.forecasts[disc].as_ref();
        match still.and_then(|next| next.contested.clone()) {
            Some(doubt) => Err(doubt),
            None => Ok(true),
        }
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
        next.is_stale(&self.flights) || next.is_graze() && self.has_grazed(disc, next.feature)
    }

    /// Makes the front candidates, each pair once and in the order of names.
    fn nominate(&mut self) {
        self.candidates.clear();
        for &disc in &self.front {
            if let Some(next) = &self.forecasts[disc] {
                let names = self.flights.world.names(disc, next.feature);
                self.candidates.push(Candidate { disc, names });
            }
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
    fn compute(&mut self, disc: usize) -> Result<bool, S::Doubt> {
        let Some(next) = &mut self.forecasts[disc] else {
            return Ok(false);
        };
        if next.meeting.is_some() {
            return Ok(false);
        }
        next.compute(&self.flights, disc)?;
        self.queue.set(disc, next.bounds.lo());
        Ok(true)
    }

    /// The candidate that comes first; of those at one time, by name.
    fn choose(&self) -> Result<usize, S::Doubt> {
        let mut first = &self.candidates[0];
        for candidate in &self.candidates[1..] {
            match self.time(candidate.disc).compare(self.time(first.disc)) {
                Ok(Less) => first = candidate,
                Ok(Equal | Greater) => {}
                Err(_) => return self.choose_among_commuting(),
            }
        }
        Ok(first.disc)
    }

    /// A candidate that none precedes, where not every order is decided.
    fn choose_among_commuting(&self) -> Result<usize, S::Doubt> {
        let mut doubt = None;
        for candidate in &self.candidates {
            match self.is_preceded(candidate) {
                Ok(false) => return Ok(candidate.disc),
                Ok(true) => {}
                Err(open) => doubt = doubt.or(Some(open)),
            }
        }
        // One is preceded by none, unless a decision is open.
        doubt.map_or(Ok(self.candidates[0].disc), Err)
    }

    fn is_preceded(&self, one: &Candidate) -> Result<bool, S::Doubt> {
        for other in &self.candidates {
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

    /// The time of a candidate among several.
    fn time(&self, disc: usize) -> &S {
        let next = self.forecasts[disc].as_ref();
        let meeting = next.and_then(|next| next.meeting.as_ref());
        &meeting.expect("candidates are computed").time
    }

    /// Whether a forecast comes true no later than a limit; none if it had to
    /// be computed for that.
    fn is_due(&mut self, disc: usize, limit: &S) -> Result<Option<bool>, S::Doubt> {
        let next = self.forecasts[disc].as_ref();
        let next = next.expect("a candidate has a forecast");
        if next.bounds.hi() <= limit.hull().lo() {
            return Ok(Some(true));
        }
        let Some(meeting) = &next.meeting else {
            return self.compute(disc).map(|_| None);
        };
        let order = meeting.time.compare(limit);
        let asking = || format!("whether d{disc} meets anything before the end");
        let order = order.map_err(|doubt| doubt.asking(asking))?;
        Ok(Some(order != Greater))
    }
}
