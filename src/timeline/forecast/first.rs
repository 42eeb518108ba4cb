//! The first of several meetings, by their times and, where numbers leave that
//! open, by proof.

use std::cmp::Ordering::{Equal, Greater, Less};

use super::Forecast;
use crate::body::Feature;
use crate::kernel::{Kernel, Time};
use crate::scalar::Doubt;
use crate::timeline::arbiter::{Arbiter, Timed};
use crate::timeline::flight::Flights;
use crate::timeline::meeting::Meeting;
use crate::world::Obstacle;

/// When and where a disc meets an obstacle, where numbers leave that open by
/// proof.
#[inline]
pub(super) fn meet<S: Timed>(
    flights: &Flights<S>,
    disc: usize,
    obstacle: Obstacle,
    arbiter: &mut S::Arbiter,
) -> Result<Option<Meeting<S>>, S::Doubt> {
    flights.meet(disc, obstacle).or_else(|doubt| {
        let doubt = doubt.asking(|| obstacle.ask(disc, "meet"));
        match flights.contact(disc, obstacle) {
            Some(feature) => {
                let approaches = arbiter.approaches(flights, disc, feature, doubt)?;
                Ok(approaches.then(|| flights.touching(disc, feature)))
            }
            None => arbiter.meet(flights, disc, obstacle, doubt),
        }
    })
}

/// The first of a disc's meetings among those offered so far.
pub(super) struct First<'a, S: Kernel> {
    flights: &'a Flights<S>,
    /// No meeting after this is of interest.
    horizon: f64,
    best: Option<Meeting<S>>,
    /// The least relative difference of two times that had to be compared.
    pub(super) closest: f64,
    /// Meetings of which it is open whether they are before the best one.
    rivals: Vec<(Meeting<S>, S::Doubt)>,
}

impl<'a, S: Timed> First<'a, S> {
    pub(super) fn new(flights: &'a Flights<S>, horizon: f64) -> Self {
        Self {
            flights,
            horizon,
            best: None,
            closest: f64::INFINITY,
            rivals: Vec::new(),
        }
    }

    #[inline]
    pub(super) fn offer(
        &mut self,
        disc: usize,
        obstacle: Obstacle,
        arbiter: &mut S::Arbiter,
        skips: impl Fn(Obstacle, Feature, bool) -> bool,
    ) -> Result<(), S::Doubt> {
        let met = meet(self.flights, disc, obstacle, arbiter)?;
        let Some(meeting) = met.filter(|meeting| !skips(obstacle, meeting.feature, meeting.inside))
        else {
            return Ok(());
        };
        if meeting.time.bounds().lo() <= self.horizon {
            self.enter(disc, meeting, arbiter);
        }
        Ok(())
    }

    fn enter(&mut self, disc: usize, meeting: Meeting<S>, arbiter: &mut S::Arbiter) {
        let Some(best) = &self.best else {
            self.best = Some(meeting);
            return;
        };
        if best.feature == meeting.feature {
            return;
        }
        let order = self.flights.order((disc, &meeting), (disc, best), arbiter);
        if !S::ROUNDS && matches!(order, Ok(Less | Greater)) {
            self.closest = self.closest.min(meeting.apart(best));
        }
        match order {
            Ok(Less) => self.best = Some(meeting),
            Ok(Equal) if self.precedes(disc, &meeting, best) => self.best = Some(meeting),
            Ok(Equal | Greater) => {}
            Err(doubt) => self.rivals.push((meeting, doubt)),
        }
    }

    /// Whether of two simultaneous meetings the first is the one to resolve.
    fn precedes(&self, disc: usize, one: &Meeting<S>, other: &Meeting<S>) -> bool {
        let names = |meeting: &Meeting<S>| self.flights.world.names(disc, meeting.feature);
        names(one) < names(other)
    }

    /// The first meeting, with the reason if a rival may still be before it.
    pub(super) fn finish(self, disc: usize) -> Option<Forecast<S>> {
        let best = self.best?;
        let open = |rival: &Meeting<S>| !matches!(rival.time.order(&best.time), Ok(Greater));
        let rival = self.rivals.into_iter().find(|(rival, _)| open(rival));
        let contested = rival.map(|(rival, doubt)| {
            let [one, two] =
                [&best, &rival].map(|meeting| self.flights.world.names(disc, meeting.feature).0);
            doubt.asking(|| format!("whether {one} or {two} meet first"))
        });
        let forecast = Forecast::computed(best, self.flights);
        Some(Forecast {
            contested,
            ..forecast
        })
    }
}
