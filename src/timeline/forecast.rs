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

use super::arbiter::{Arbiter, Foreseen, Timed};
use super::flight::{Flights, Meeting};
use super::neighbours::{BroadPhase, Neighbours};
use super::sweep::Sweep;
use super::tracks::{Track, Tracks};
use crate::body::Feature;
use crate::kernel::{Glance, Kernel, Time};
use crate::scalar::{Doubt, Interval};
use crate::world::Obstacle;

/// The first meeting of a disc.
#[derive(Clone, Debug)]
pub(super) struct Forecast<S: Kernel> {
    /// Binary64 bounds of the time.
    pub(super) bounds: Interval,
    pub(super) outlook: Outlook<S>,
    /// Why another meeting of the same disc could not be proven to be later.
    pub(super) contested: Option<S::Doubt>,
}

/// How much of a disc's first meeting is known.
#[derive(Clone, Debug)]
pub(super) enum Outlook<S: Kernel> {
    /// Only that there is none before the lower bound of the time: it is left
    /// for later to tell the candidates apart.
    Open,
    /// It is the impact on this, after a delay, of which the bounds of the
    /// time have sufficed so far.
    Bounded(Obstacle, Foresight),
    /// Only that there is none before it leaves its neighbours.
    Leaving,
    /// All. Boxed, for most forecasts are made anew before they come true.
    Computed(Box<Meeting<S>>, Foresight),
}

/// What is met, and the partner's turn that this supposes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foresight {
    pub(super) feature: Feature,
    partner_turn: u64,
}

impl Foresight {
    fn new<S: Kernel>(feature: Feature, flights: &Flights<S>) -> Self {
        Self {
            feature,
            partner_turn: flights.turn_of(feature),
        }
    }
}

impl<S: Kernel> Forecast<S> {
    fn open(earliest: f64, horizon: f64) -> Self {
        Self {
            bounds: Interval::new(earliest, horizon),
            outlook: Outlook::Open,
            contested: None,
        }
    }

    fn leaving(time: f64) -> Self {
        Self {
            bounds: Interval::new(time, time),
            outlook: Outlook::Leaving,
            contested: None,
        }
    }

    /// Whether it is left for later to tell the candidates apart.
    pub(super) fn is_open(&self) -> bool {
        matches!(self.outlook, Outlook::Open)
    }

    /// Whether it looks no further than to where the disc gets new neighbours.
    pub(super) fn is_leaving(&self) -> bool {
        matches!(self.outlook, Outlook::Leaving)
    }

    fn bounded(
        obstacle: Obstacle,
        bounds: Interval,
        feature: Feature,
        flights: &Flights<S>,
    ) -> Self {
        Self {
            bounds,
            outlook: Outlook::Bounded(obstacle, Foresight::new(feature, flights)),
            contested: None,
        }
    }

    fn computed(meeting: Meeting<S>, flights: &Flights<S>) -> Self {
        let foresight = Foresight::new(meeting.feature, flights);
        Self {
            bounds: meeting.time.bounds(),
            outlook: Outlook::Computed(Box::new(meeting), foresight),
            contested: None,
        }
    }

    /// What is met, unless that is open.
    #[inline]
    pub(super) fn feature(&self) -> Option<Feature> {
        self.foresight().map(|foresight| foresight.feature)
    }

    #[inline]
    fn foresight(&self) -> Option<Foresight> {
        match &self.outlook {
            Outlook::Open | Outlook::Leaving => None,
            Outlook::Bounded(_, foresight) | Outlook::Computed(_, foresight) => Some(*foresight),
        }
    }

    /// The meeting, if it is computed.
    #[inline]
    pub(super) fn meeting(&self) -> Option<&Meeting<S>> {
        match &self.outlook {
            Outlook::Computed(meeting, _) => Some(meeting),
            Outlook::Open | Outlook::Leaving | Outlook::Bounded(..) => None,
        }
    }

    /// What a disc meets, which must not be open.
    pub(super) fn foreseen(&self, disc: usize) -> Foreseen {
        let feature = self.feature().expect("it is not open what is met");
        let moment = self.meeting().and_then(|meeting| meeting.moment);
        Foreseen::new(disc, feature, moment)
    }

    /// Whether the partner has changed since.
    #[inline]
    pub(super) fn is_stale(&self, flights: &Flights<S>) -> bool {
        let changed =
            |foresight: Foresight| flights.turn_of(foresight.feature) != foresight.partner_turn;
        self.foresight().is_some_and(changed)
    }

    /// Whether the two overlap already, and do not only touch.
    pub(super) fn is_inside(&self) -> bool {
        self.meeting().is_some_and(|meeting| meeting.inside)
    }

    /// Whether the two come to rest on each other then, or part that were.
    #[inline]
    pub(super) fn is_rest(&self) -> bool {
        self.meeting().is_some_and(|meeting| meeting.rest)
    }

    /// Whether the two only pass in tangency.
    #[inline]
    pub(super) fn is_graze(&self) -> bool {
        self.meeting().is_some_and(|meeting| meeting.graze)
    }
}

impl<S: Timed> Forecast<S> {
    /// Computes the meeting of a disc, if bounds have sufficed so far.
    pub(super) fn compute(
        &mut self,
        flights: &Flights<S>,
        disc: usize,
        arbiter: &mut S::Arbiter,
    ) -> Result<(), S::Doubt> {
        if let Outlook::Bounded(obstacle, foresight) = self.outlook {
            let feature = foresight.feature;
            let meeting = impact(flights, disc, (obstacle, feature), self.bounds, arbiter)?;
            self.bounds = meeting.time.bounds();
            self.outlook = Outlook::Computed(Box::new(meeting), foresight);
        }
        Ok(())
    }

    /// The meeting of a disc, which comes true; what is met must not be open.
    pub(super) fn come_true(
        self,
        flights: &Flights<S>,
        disc: usize,
        arbiter: &mut S::Arbiter,
    ) -> Result<Meeting<S>, S::Doubt> {
        match self.outlook {
            Outlook::Bounded(obstacle, Foresight { feature, .. }) => {
                impact(flights, disc, (obstacle, feature), self.bounds, arbiter)
            }
            Outlook::Computed(meeting, _) => Ok(*meeting),
            Outlook::Open | Outlook::Leaving => unreachable!("it is open what is met"),
        }
    }
}

/// The impact of a disc that bounds prove.
fn impact<S: Timed>(
    flights: &Flights<S>,
    disc: usize,
    (obstacle, feature): (Obstacle, Feature),
    bounds: Interval,
    arbiter: &mut S::Arbiter,
) -> Result<Meeting<S>, S::Doubt> {
    if let Some(meeting) = flights.ahead(bounds, feature) {
        return Ok(meeting);
    }
    let met = meet(flights, disc, obstacle, arbiter)?;
    Ok(met.expect("bounds prove that the two meet"))
}

/// When and where a disc meets an obstacle, where numbers leave that open by
/// proof.
#[inline]
fn meet<S: Timed>(
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

/// Finds forecasts, and keeps what that takes from one to the next.
#[derive(Clone, Debug)]
pub(super) struct Forecaster {
    /// The bodies' binary64 bounds, where the arithmetic wants the filter.
    bounds: Option<Bounds>,
    /// How the bodies move, where that is simple.
    tracks: Tracks,
    neighbours: Neighbours,
    /// The discs that a disc may meet.
    near: Vec<u32>,
    /// What of the bodies that a disc may meet bounds have not ruled out.
    survivors: Vec<Survivor>,
    /// No meeting after this is of interest.
    horizon: f64,
    /// The least relative difference of two times that had to be compared.
    closest: f64,
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
    /// They do not meet outside of this time, if they do.
    time: Interval,
    /// What is met, if it is proven that there is an impact with a delay.
    impact: Option<Feature>,
}

/// How far to go with a forecast.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Effort {
    /// Only as far as bounds lead.
    Bounds,
    /// Until it is known what is met.
    Numbers,
}

impl Forecaster {
    pub(super) fn new<S: Kernel>(flights: &Flights<S>, horizon: &S, phase: BroadPhase) -> Self {
        let horizon = horizon.hull().hi();
        Self {
            bounds: S::IS_DEAR.then(|| Bounds::new(flights.hull(), horizon)),
            tracks: Tracks::new(flights),
            neighbours: Neighbours::new(flights, phase),
            near: Vec::new(),
            survivors: Vec::new(),
            horizon,
            closest: f64::INFINITY,
        }
    }

    /// The least relative difference of two times that had to be compared, or
    /// infinity.
    pub(super) fn closest(&self) -> f64 {
        self.closest
    }

    /// Takes note of a disc that has changed.
    pub(super) fn update<S: Kernel>(&mut self, flights: &Flights<S>, disc: usize) {
        if let Some(bounds) = &mut self.bounds {
            bounds.update(flights, disc);
        }
        self.tracks.update(flights, disc);
        self.neighbours.update(flights, disc);
    }

    /// Takes note of a disc that gets new neighbours at a time before which
    /// nothing happens.
    pub(super) fn renew<S: Kernel>(&mut self, flights: &Flights<S>, disc: usize, time: f64) {
        self.neighbours.renew(flights, disc, time);
    }

    /// Whether bounds prove that a disc and an obstacle are apart at a time.
    pub(super) fn are_apart<S: Kernel>(&self, disc: usize, obstacle: Obstacle, time: &S) -> bool {
        self.bounds.as_ref().is_some_and(|bounds| {
            let gap = bounds.flights.gap(disc, obstacle, &time.hull());
            matches!(gap, Ok((Greater, _)))
        })
    }

    /// The first meeting of a disc with one of its neighbours, if that is sure
    /// to be before it gets others. Some of them are not `wanted`; others it
    /// `skips`, told by what is met and whether that overlaps already.
    pub(super) fn forecast<S: Timed>(
        &mut self,
        flights: &Flights<S>,
        disc: usize,
        effort: Effort,
        arbiter: &mut S::Arbiter,
        (wanted, skips): (
            impl Fn(Obstacle) -> bool,
            impl Fn(Obstacle, Feature, bool) -> bool,
        ),
    ) -> Result<Option<Forecast<S>>, S::Doubt> {
        let leave = self.neighbours.last_until(disc);
        self.sift(flights, disc, leave, wanted, &skips);
        let first = self.first(flights, disc, effort, arbiter, skips)?;
        Ok(match first {
            Some(first) if first.bounds.hi() <= leave => Some(first),
            _ if leave > self.horizon => first,
            Some(first) => Some(Forecast::leaving(leave.min(first.bounds.lo()))),
            None => Some(Forecast::leaving(leave)),
        })
    }

    /// Collects what a disc may meet first, and not after the horizon: walls
    /// before discs, for often they bound how far ahead it is worth to look.
    fn sift<S: Timed>(
        &mut self,
        flights: &Flights<S>,
        disc: usize,
        leave: f64,
        wanted: impl Fn(Obstacle) -> bool,
        skips: impl Fn(Obstacle, Feature, bool) -> bool,
    ) {
        let latest = match self.bounds {
            Some(_) => self.horizon,
            None => self.horizon.min(leave),
        };
        self.survivors.clear();
        let mut sieve = Sieve {
            flights,
            disc,
            bounds: self.bounds.as_ref(),
            survivors: &mut self.survivors,
            latest,
            wanted,
            skips,
        };
        let (world, neighbours) = (&flights.world, &self.neighbours);
        neighbours.visit_walls(world, disc, |wall| sieve.add(Obstacle::Wall(wall as usize)));
        neighbours.list_discs(world, disc, &mut self.near);
        let track = self.tracks.of(disc);
        for &other in &self.near {
            let other = other as usize;
            let is_clear = |track: &Track| self.tracks.are_clear(track, other, sieve.latest);
            if other != disc && !track.is_some_and(is_clear) {
                sieve.add(Obstacle::Disc(other));
            }
        }
        sieve.finish();
    }

    /// The first meeting among the survivors.
    fn first<S: Timed>(
        &mut self,
        flights: &Flights<S>,
        disc: usize,
        effort: Effort,
        arbiter: &mut S::Arbiter,
        skips: impl Fn(Obstacle, Feature, bool) -> bool,
    ) -> Result<Option<Forecast<S>>, S::Doubt> {
        match &self.survivors[..] {
            [] => return Ok(None),
            &[
                Survivor {
                    obstacle,
                    time,
                    impact: Some(feature),
                },
            ] => return Ok(Some(Forecast::bounded(obstacle, time, feature, flights))),
            several if S::IS_DEAR && effort == Effort::Bounds => {
                let times = several.iter().map(|survivor| survivor.time.lo());
                let earliest = times.fold(f64::INFINITY, f64::min);
                return Ok(Some(Forecast::open(earliest, self.horizon)));
            }
            _ => {}
        }
        let mut first = First::new(flights, self.horizon);
        for survivor in &self.survivors {
            first.offer(disc, survivor.obstacle, arbiter, &skips)?;
        }
        self.closest = self.closest.min(first.closest);
        Ok(first.finish(disc))
    }
}

/// Finds what of its neighbours a disc may meet first.
struct Sieve<'a, S: Kernel, W, K> {
    flights: &'a Flights<S>,
    disc: usize,
    bounds: Option<&'a Bounds>,
    survivors: &'a mut Vec<Survivor>,
    /// A time by which it meets something, if nothing happens before, or after
    /// which nothing is of interest.
    latest: f64,
    wanted: W,
    skips: K,
}

impl<S, W, K> Sieve<'_, S, W, K>
where
    S: Kernel,
    W: Fn(Obstacle) -> bool,
    K: Fn(Obstacle, Feature, bool) -> bool,
{
    /// Adds an obstacle, unless it is ruled out.
    #[inline(never)]
    fn add(&mut self, obstacle: Obstacle) {
        if self.flights.world.is_barred(self.disc, obstacle) || !(self.wanted)(obstacle) {
            return;
        }
        let survivor = match self.bounds {
            Some(bounds) => bounds.look(self.disc, obstacle, self.latest, &self.skips),
            None => self.glance(obstacle),
        };
        if let Some(survivor) = survivor
            && survivor.time.lo() <= self.latest
        {
            self.latest = self.latest.min(survivor.time.hi());
            self.survivors.push(survivor);
        }
    }

    /// What a glance does not rule out.
    #[inline]
    fn glance(&self, obstacle: Obstacle) -> Option<Survivor> {
        let (time, impact) = match self.flights.glance(self.disc, obstacle) {
            Glance::Clear => return None,
            Glance::Open => (Interval::UNBOUNDED, None),
            Glance::Ahead(time, end) => {
                let feature = self.flights.world.feature_of(obstacle, end);
                if (self.skips)(obstacle, feature, false) {
                    return None;
                }
                (time, Some(feature))
            }
        };
        Some(Survivor {
            obstacle,
            time,
            impact,
        })
    }

    /// Drops what others have ruled out since.
    fn finish(self) {
        if self.survivors.len() > 1 {
            let latest = self.latest;
            self.survivors
                .retain(|survivor| survivor.time.lo() <= latest);
        }
    }
}

impl Bounds {
    fn new(flights: Flights<Interval>, horizon: f64) -> Self {
        let sweep = Sweep::new(&flights, horizon);
        Self { flights, sweep }
    }

    fn update<S: Kernel>(&mut self, flights: &Flights<S>, disc: usize) {
        self.flights.follow(disc, flights);
        self.sweep.update(&self.flights, disc);
    }

    /// What bounds do not rule out as the first meeting of a disc, up to a time.
    fn look(
        &self,
        disc: usize,
        obstacle: Obstacle,
        latest: f64,
        skips: impl Fn(Obstacle, Feature, bool) -> bool,
    ) -> Option<Survivor> {
        let begun = self.flights.since[disc].lo();
        if let Obstacle::Disc(other) = obstacle
            && self.sweep.are_apart(disc, other, begun, latest)
        {
            return None;
        }
        let (time, impact) = match self.flights.meet(disc, obstacle) {
            Ok(None) => return None,
            Ok(Some(meeting)) if skips(obstacle, meeting.feature, meeting.inside) => return None,
            Ok(Some(meeting)) => {
                let is_impact = !meeting.graze && !meeting.overlap;
                (meeting.time, is_impact.then_some(meeting.feature))
            }
            Err(_) => {
                let earliest = self.flights.apart_until(disc, obstacle);
                (Interval::new(earliest, f64::INFINITY), None)
            }
        };
        Some(Survivor {
            obstacle,
            time,
            impact,
        })
    }
}

/// The first of a disc's meetings among those offered so far.
struct First<'a, S: Kernel> {
    flights: &'a Flights<S>,
    /// No meeting after this is of interest.
    horizon: f64,
    best: Option<Meeting<S>>,
    /// The least relative difference of two times that had to be compared.
    closest: f64,
    /// Meetings of which it is open whether they are before the best one.
    rivals: Vec<(Meeting<S>, S::Doubt)>,
}

impl<'a, S: Timed> First<'a, S> {
    fn new(flights: &'a Flights<S>, horizon: f64) -> Self {
        Self {
            flights,
            horizon,
            best: None,
            closest: f64::INFINITY,
            rivals: Vec::new(),
        }
    }

    #[inline]
    fn offer(
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
    fn finish(self, disc: usize) -> Option<Forecast<S>> {
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
