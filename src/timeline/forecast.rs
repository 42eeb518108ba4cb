//! What a disc meets next.
//!
//! Each disc carries one forecast: the first of all its meetings, as things
//! stand. It is made anew when the disc itself has changed, and when its turn
//! comes but the partner has changed meanwhile. A pair is thus forecast by
//! whichever of the two changed last, and no meeting is lost.
//!
//! Where operations are dear, bounds come first: a [`Sweep`] drops the discs
//! that are too far away, [`Interval`]s enclose the times of the other
//! meetings. Mostly they prove which one is the first: then its exact time is
//! not computed before it comes true, or is to be compared with another.

use std::cmp::Ordering::{Equal, Greater, Less};

use super::flight::{Flights, Meeting};
use super::sweep::Sweep;
use crate::body::Feature;
use crate::scalar::{Doubt, Interval, Scalar};
use crate::world::{Obstacle, World};

/// The first meeting of a disc.
#[derive(Clone, Debug)]
pub(super) struct Forecast<S: Scalar> {
    /// What is met.
    pub(super) obstacle: Obstacle,
    /// What of it is touched.
    pub(super) feature: Feature,
    /// Binary64 bounds of the time.
    pub(super) bounds: Interval,
    /// The meeting itself, unless bounds have sufficed so far: then it is an
    /// impact with a delay.
    pub(super) meeting: Option<Meeting<S>>,
    /// The partner's turn that the forecast supposes.
    partner_turn: u64,
    /// Why another meeting of the same disc could not be proven to be later.
    pub(super) contested: Option<S::Doubt>,
}

impl<S: Scalar> Forecast<S> {
    fn bounded(obstacle: Obstacle, bounds: &Meeting<Interval>, flights: &Flights<S>) -> Self {
        Self {
            obstacle,
            feature: bounds.feature,
            bounds: bounds.time,
            meeting: None,
            partner_turn: flights.turn_of(bounds.feature),
            contested: None,
        }
    }

    #[inline]
    fn computed(obstacle: Obstacle, meeting: Meeting<S>, flights: &Flights<S>) -> Self {
        Self {
            obstacle,
            feature: meeting.feature,
            bounds: meeting.time.hull(),
            partner_turn: flights.turn_of(meeting.feature),
            meeting: Some(meeting),
            contested: None,
        }
    }

    /// Whether the partner has changed since.
    #[inline]
    pub(super) fn is_stale(&self, flights: &Flights<S>) -> bool {
        flights.turn_of(self.feature) != self.partner_turn
    }

    /// Whether the two only pass in tangency.
    #[inline]
    pub(super) fn is_graze(&self) -> bool {
        self.meeting.as_ref().is_some_and(|meeting| meeting.graze)
    }

    /// Computes the meeting of a disc, if bounds have sufficed so far.
    pub(super) fn compute(&mut self, flights: &Flights<S>, disc: usize) -> Result<(), S::Doubt> {
        if self.meeting.is_none() {
            let meeting = meet(flights, disc, self.obstacle)?;
            let meeting = meeting.expect("bounds prove that the two meet");
            self.bounds = meeting.time.hull();
            self.meeting = Some(meeting);
        }
        Ok(())
    }
}

/// When and where a disc meets an obstacle, or which of the two is in doubt.
#[inline]
fn meet<S: Scalar>(
    flights: &Flights<S>,
    disc: usize,
    obstacle: Obstacle,
) -> Result<Option<Meeting<S>>, S::Doubt> {
    let met = flights.meet(disc, obstacle);
    met.map_err(|doubt| doubt.asking(|| obstacle.ask(disc, "meet")))
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
    bounds: Option<Bounds>,
    survivors: Vec<Survivor>,
    /// No meeting after this is of interest.
    horizon: f64,
}

/// The bodies in bounds, and what discs are too far apart.
#[derive(Clone, Debug)]
struct Bounds {
    flights: Flights<Interval>,
    sweep: Sweep,
}

/// What bounds have not ruled out as the first meeting of a disc.
#[derive(Clone, Debug)]
struct Survivor {
    obstacle: Obstacle,
    /// The bounds of the meeting, unless they leave it open whether there is
    /// one.
    meeting: Option<Meeting<Interval>>,
}

impl Survivor {
    fn may_be_before(&self, time: f64) -> bool {
        self.meeting
            .as_ref()
            .is_none_or(|meeting| meeting.time.lo() <= time)
    }

    /// The bounds, if they prove an impact with a delay.
    fn impact(&self) -> Option<&Meeting<Interval>> {
        self.meeting
            .as_ref()
            .filter(|meeting| !meeting.graze && !meeting.overlap)
    }
}

impl Forecaster {
    pub(super) fn new<S: Scalar>(flights: &Flights<S>, horizon: &S) -> Self {
        let horizon = horizon.hull().hi();
        Self {
            bounds: S::FILTERED.then(|| Bounds::new(flights.hull(), horizon)),
            survivors: Vec::new(),
            horizon,
        }
    }

    /// Takes note of a disc that has changed.
    pub(super) fn update<S: Scalar>(&mut self, flights: &Flights<S>, disc: usize) {
        if let Some(bounds) = &mut self.bounds {
            bounds.update(flights, disc);
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
        let Some(bounds) = &self.bounds else {
            for obstacle in partners.of(&flights.world, disc) {
                first.offer(disc, obstacle, self.horizon, &skips)?;
            }
            return Ok(first.finish(disc));
        };
        let candidates = partners.of(&flights.world, disc);
        bounds.filter(disc, candidates, &mut self.survivors, &skips);
        if let [Survivor { obstacle, .. }] = &self.survivors[..]
            && let Some(meeting) = self.survivors[0].impact()
        {
            return Ok(Some(Forecast::bounded(*obstacle, meeting, flights)));
        }
        for survivor in &self.survivors {
            first.offer(disc, survivor.obstacle, self.horizon, &skips)?;
        }
        Ok(first.finish(disc))
    }
}

impl Bounds {
    fn new(flights: Flights<Interval>, horizon: f64) -> Self {
        let sweep = Sweep::new(&flights, horizon);
        Self { flights, sweep }
    }

    fn update<S: Scalar>(&mut self, flights: &Flights<S>, disc: usize) {
        self.flights.world.discs[disc] = flights.world.discs[disc].map(S::hull);
        self.flights.since[disc] = flights.since[disc].hull();
        self.flights.turn[disc] = flights.turn[disc];
        self.sweep.update(&self.flights, disc);
    }

    /// Collects the obstacles among `candidates` that a disc may meet first,
    /// and not after the horizon.
    fn filter(
        &self,
        disc: usize,
        candidates: impl Iterator<Item = Obstacle>,
        survivors: &mut Vec<Survivor>,
        skips: impl Fn(Feature, bool) -> bool,
    ) {
        survivors.clear();
        let earliest = self.flights.since[disc].lo();
        // A time by which it meets something, if nothing happens before.
        let mut latest = self.sweep.horizon();
        for obstacle in candidates {
            if let Obstacle::Disc(other) = obstacle
                && self.sweep.are_apart(disc, other, earliest, latest)
            {
                continue;
            }
            let meeting = match self.flights.meet(disc, obstacle) {
                Ok(None) => continue,
                Ok(Some(meeting)) if skips(meeting.feature, meeting.overlap) => continue,
                Ok(Some(meeting)) if meeting.time.lo() > latest => continue,
                Ok(Some(meeting)) => Some(meeting),
                Err(_) => None,
            };
            if let Some(meeting) = &meeting {
                latest = latest.min(meeting.time.hi());
            }
            survivors.push(Survivor { obstacle, meeting });
        }
        survivors.retain(|survivor| survivor.may_be_before(latest));
    }
}

/// The first of a disc's meetings among those offered so far.
struct First<'a, S: Scalar> {
    flights: &'a Flights<S>,
    best: Option<(Obstacle, Meeting<S>)>,
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
        let met = meet(self.flights, disc, obstacle)?;
        let Some(meeting) = met.filter(|meeting| !skips(meeting.feature, meeting.overlap)) else {
            return Ok(());
        };
        if meeting.time.hull().lo() <= horizon {
            self.enter(disc, obstacle, meeting);
        }
        Ok(())
    }

    fn enter(&mut self, disc: usize, obstacle: Obstacle, meeting: Meeting<S>) {
        let Some((_, best)) = &self.best else {
            self.best = Some((obstacle, meeting));
            return;
        };
        if best.feature == meeting.feature {
            return;
        }
        match meeting.time.compare(&best.time) {
            Ok(Less) => self.best = Some((obstacle, meeting)),
            Ok(Equal) if self.precedes(disc, &meeting, best) => {
                self.best = Some((obstacle, meeting));
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
        let (obstacle, best) = self.best?;
        let open = |rival: &Meeting<S>| !matches!(rival.time.compare(&best.time), Ok(Greater));
        let rival = self.rivals.into_iter().find(|(rival, _)| open(rival));
        let contested = rival.map(|(rival, doubt)| {
            let [one, two] =
                [&best, &rival].map(|meeting| self.flights.world.names(disc, meeting.feature).0);
            doubt.asking(|| format!("whether {one} or {two} meet first"))
        });
        let forecast = Forecast::computed(obstacle, best, self.flights);
        Some(Forecast {
            contested,
            ..forecast
        })
    }
}
