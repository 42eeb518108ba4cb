//! What a disc meets next.
//!
//! Each disc carries one forecast: the first of all its meetings, as things
//! stand. It is made anew when the disc itself has changed, and when its turn
//! comes but the partner has changed meanwhile. A pair is thus forecast by
//! whichever of the two changed last, and no meeting is lost.
//!
//! Where operations are dear, [`Interval`] bounds of every meeting come
//! first, and only those that may be the earliest are computed.

use std::cmp::Ordering::{Equal, Greater, Less};

use super::flight::{Flights, Meeting};
use crate::body::Feature;
use crate::scalar::{Doubt, Interval, Scalar};
use crate::world::{Obstacle, World};

/// The first meeting of a disc.
#[derive(Clone, Debug)]
pub(super) struct Forecast<S: Scalar> {
    pub(super) meeting: Meeting<S>,
    /// Binary64 bounds of the time.
    pub(super) bounds: Interval,
    /// The partner's turn that the forecast supposes.
    partner_turn: u64,
    /// Why another meeting of the same disc could not be proven to be later.
    pub(super) contested: Option<S::Doubt>,
}

impl<S: Scalar> Forecast<S> {
    fn new(meeting: Meeting<S>, flights: &Flights<S>) -> Self {
        Self {
            bounds: meeting.time.hull(),
            partner_turn: flights.turn_of(meeting.feature),
            meeting,
            contested: None,
        }
    }

    /// Whether the partner has changed since.
    pub(super) fn is_stale(&self, flights: &Flights<S>) -> bool {
        flights.turn_of(self.meeting.feature) != self.partner_turn
    }
}

/// Whom a disc's forecast considers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Partners {
    /// Everything.
    All,
    /// At the start, when all discs are forecast in turn, only what is left of
    /// the pairs: later discs, and what makes no forecasts of its own.
    Later,
}

impl Partners {
    #[inline]
    fn of<S: Scalar>(self, world: &World<S>, disc: usize) -> impl Iterator<Item = Obstacle> {
        world
            .obstacles(disc)
            .filter(move |&obstacle| match obstacle {
                Obstacle::Disc(other) if self == Self::Later => {
                    other > disc || !world.discs[other].is_movable()
                }
                _ => true,
            })
    }
}

/// Finds forecasts, and keeps what that takes from one to the next.
#[derive(Clone, Debug)]
pub(super) struct Forecaster {
    /// The bodies' binary64 bounds, where the arithmetic wants the filter.
    bounds: Option<Flights<Interval>>,
    /// What the filter left over, with a lower bound of the time.
    survivors: Vec<(Obstacle, f64)>,
    /// No meeting after this is of interest.
    horizon: f64,
}

impl Forecaster {
    pub(super) fn new<S: Scalar>(flights: &Flights<S>, horizon: &S) -> Self {
        Self {
            bounds: S::FILTERED.then(|| flights.hull()),
            survivors: Vec::new(),
            horizon: horizon.hull().hi(),
        }
    }

    /// Takes note of a disc that has changed.
    pub(super) fn update<S: Scalar>(&mut self, flights: &Flights<S>, disc: usize) {
        if let Some(bounds) = &mut self.bounds {
            bounds.world.discs[disc] = flights.world.discs[disc].map(S::hull);
            bounds.since[disc] = flights.since[disc].hull();
            bounds.turn[disc] = flights.turn[disc];
        }
    }

    /// The first meeting of a disc, but for those it `skips`, told by what is
    /// met and whether that overlaps already.
    pub(super) fn forecast<S: Scalar>(
        &mut self,
        flights: &Flights<S>,
        disc: usize,
        partners: Partners,
        skips: impl Fn(Feature, bool) -> bool,
    ) -> Result<Option<Forecast<S>>, S::Doubt> {
        let mut first = First::new(flights);
        if self.bounds.is_none() {
            for obstacle in partners.of(&flights.world, disc) {
                first.offer(disc, obstacle, self.horizon, &skips)?;
            }
            return Ok(first.finish(disc));
        }
        let latest = self.filter(flights, disc, partners, &skips);
        for &(obstacle, earliest) in &self.survivors {
            if earliest <= latest {
                first.offer(disc, obstacle, self.horizon, &skips)?;
            }
        }
        Ok(first.finish(disc))
    }

    /// Collects the obstacles that a disc may meet, and returns a time by
    /// which it meets one, if nothing happens before.
    fn filter<S: Scalar>(
        &mut self,
        flights: &Flights<S>,
        disc: usize,
        partners: Partners,
        skips: impl Fn(Feature, bool) -> bool,
    ) -> f64 {
        self.survivors.clear();
        let mut latest = self.horizon;
        let Some(bounds) = &self.bounds else {
            return latest;
        };
        for obstacle in partners.of(&flights.world, disc) {
            match bounds.meet(disc, obstacle) {
                Ok(None) => {}
                Ok(Some(meeting)) if skips(meeting.feature, meeting.overlap) => {}
                Ok(Some(meeting)) => {
                    latest = latest.min(meeting.time.hi());
                    self.survivors.push((obstacle, meeting.time.lo()));
                }
                Err(_) => self.survivors.push((obstacle, f64::NEG_INFINITY)),
            }
        }
        latest
    }
}

/// The first of a disc's meetings among those offered so far.
struct First<'a, S: Scalar> {
    flights: &'a Flights<S>,
    best: Option<Forecast<S>>,
    /// Meetings of which it is open whether they are before the best one.
    rivals: Vec<(Meeting<S>, S::Doubt)>,
}

impl<'a, S: Scalar> First<'a, S> {
    fn new(flights: &'a Flights<S>) -> Self {
        Self {
            flights,
            best: None,
            rivals: Vec::new(),
        }
    }

    #[inline]
    fn offer(
        &mut self,
        disc: usize,
        obstacle: Obstacle,
        horizon: f64,
        skips: impl Fn(Feature, bool) -> bool,
    ) -> Result<(), S::Doubt> {
        let met = self.flights.meet(disc, obstacle);
        let met = met.map_err(|doubt| doubt.asking(|| obstacle.ask(disc, "meet")))?;
        let Some(meeting) = met.filter(|meeting| !skips(meeting.feature, meeting.overlap)) else {
            return Ok(());
        };
        if meeting.time.hull().lo() <= horizon {
            self.enter(disc, meeting);
        }
        Ok(())
    }

    fn enter(&mut self, disc: usize, meeting: Meeting<S>) {
        let Some(best) = &self.best else {
            self.best = Some(Forecast::new(meeting, self.flights));
            return;
        };
        if best.meeting.feature == meeting.feature {
            return;
        }
        match meeting.time.compare(&best.meeting.time) {
            Ok(Less) => self.best = Some(Forecast::new(meeting, self.flights)),
            Ok(Equal) if self.precedes(disc, &meeting, &best.meeting) => {
                self.best = Some(Forecast::new(meeting, self.flights));
            }
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
    fn finish(self, disc: usize) -> Option<Forecast<S>> {
        let mut best = self.best?;
        let open =
            |rival: &Meeting<S>| !matches!(rival.time.compare(&best.meeting.time), Ok(Greater));
        let rival = self.rivals.into_iter().find(|(rival, _)| open(rival));
        best.contested = rival.map(|(rival, doubt)| {
            let [one, two] = [&best.meeting, &rival]
                .map(|meeting| self.flights.world.names(disc, meeting.feature).0);
            doubt.asking(|| format!("whether {one} or {two} meet first"))
        });
        Some(best)
    }
}
