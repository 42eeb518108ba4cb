//! The timeline of a plane that is one rectangle over and over: discs that leave it on
//! one side come in on the other.
//!
//! It is the timeline with discs alone, each of which meets copies of the others. Places
//! are not taken back into the rectangle, so a motion is straight from impact to impact,
//! and which copy is met is a pair of whole numbers. In exact arithmetic where copies
//! are is exact; in binary64 that is rounded once for each look at a copy.
//!
//! Ties are decided by numbers alone: times that are equal and not rational are left
//! undecided. There is no search for accumulations.

mod copies;
mod forecast;

use std::cmp::Ordering::Greater;

use super::flight::Flights;
use super::front::is_negligible;
use super::neighbours::{Image, Motion, Torus};
use super::queue::Queue;
use super::{Accumulation, NEGLIGIBLE};
use crate::body::Disc;
use crate::effects::Course;
use crate::impact::Impact;
use crate::kernel::{Kernel, Time};
use crate::scalar::{Doubt, Scalar};
use crate::vec2::Vec2;
use crate::world::World;
use copies::{Couple, collide, impact, meet, overlap};
use forecast::{Forecast, Meeting};

/// The run of a periodic scene.
#[derive(Clone, Debug)]
pub struct Periodic<S: Kernel> {
    flights: Flights<S>,
    period: Vec2<S>,
    torus: Torus,
    /// What each disc has collided with last.
    parted: Vec<Option<Image>>,
    /// What each disc has grazed since it last changed, and the partner's turn then.
    grazed: Vec<Vec<(Image, u64)>>,
    forecasts: Vec<Forecast<S>>,
    /// The forecasts' lower bounds.
    queue: Queue,
    /// Those that may be the first.
    front: Vec<usize>,
    found: Vec<u32>,
    near: Vec<Image>,
    /// No meeting after this is of interest.
    horizon: f64,
    /// Times that are closer are as good as one for impacts without a common disc.
    negligible: f64,
    now: S,
    turn: u64,
    grazes: u64,
}

/// How many pairs overlap in a periodic world.
///
/// # Errors
///
/// An enclosure does not decide it.
pub(crate) fn count_overlaps<S: Kernel>(
    world: &World<S>,
    period: &Vec2<S>,
) -> Result<u64, S::Doubt> {
    let flights = Flights::new(world.clone());
    let torus = torus(&flights, period)?;
    let (mut found, mut near, mut count) = (Vec::new(), Vec::new(), 0);
    for disc in 0..world.discs.len() {
        torus.list(disc, &mut found, &mut near);
        for image in near.iter().filter(|image| image.disc as usize > disc) {
            let other = &world.discs[image.disc as usize];
            let can_collide = world.discs[disc].is_movable() || other.is_movable();
            let couple = Couple::new(disc, *image);
            count += u64::from(can_collide && overlap(&flights, period, couple)?);
        }
    }
    Ok(count)
}

/// The cells at the start, with all discs.
fn torus<S: Kernel>(flights: &Flights<S>, period: &Vec2<S>) -> Result<Torus, S::Doubt> {
    let discs = &flights.world.discs;
    let radii = discs.iter().map(|disc| disc.radius.hull().hi());
    let sides = [&period.x, &period.y].map(|side| side.hull().middle());
    let mut torus = Torus::new(sides, radii.fold(0.0, f64::max), discs.len());
    for disc in 0..discs.len() {
        settle(&mut torus, flights, disc, 0.0)?;
    }
    Ok(torus)
}

/// Puts a disc into the cell where it is at a time.
fn settle<S: Kernel>(
    torus: &mut Torus,
    flights: &Flights<S>,
    disc: usize,
    time: f64,
) -> Result<(), S::Doubt> {
    let is_certain = torus.settle(disc, &Motion::of(flights, disc), time);
    let question = || format!("where d{disc} is at {time}");
    match S::Doubt::open(question) {
        Some(doubt) if !is_certain => Err(doubt),
        _ => Ok(()),
    }
}

impl<S: Kernel> Periodic<S> {
    /// The run of a world with a period from time zero to `until`.
    ///
    /// # Errors
    ///
    /// It cannot be decided what the discs meet first.
    pub fn new(world: World<S>, period: Vec2<S>, until: &S) -> Result<Self, S::Doubt> {
        let count = world.discs.len();
        let flights = Flights::new(world);
        let mut periodic = Self {
            torus: torus(&flights, &period)?,
            flights,
            period,
            parted: vec![None; count],
            grazed: vec![Vec::new(); count],
            forecasts: vec![Forecast::Nothing; count],
            queue: Queue::new(count),
            front: Vec::new(),
            found: Vec::new(),
            near: Vec::new(),
            horizon: until.hull().hi(),
            negligible: until.hull().hi() * NEGLIGIBLE,
            now: S::from_integer(0),
            turn: 0,
            grazes: 0,
        };
        (0..count).try_for_each(|disc| periodic.forecast(disc))?;
        Ok(periodic)
    }

    /// Finds what a disc comes to first.
    fn forecast(&mut self, disc: usize) -> Result<(), S::Doubt> {
        let leave = self.torus.leave(disc);
        self.torus.list(disc, &mut self.found, &mut self.near);
        let mut first: Option<Meeting<S>> = None;
        for &image in &self.near {
            let Some(meeting) = self.meeting(disc, image)? else {
                continue;
            };
            let is_first = first
                .as_ref()
                .map_or(Ok(true), |first| meeting.precedes(first));
            if meeting.time.bounds().lo() <= leave.min(self.horizon) && is_first? {
                first = Some(meeting);
            }
        }
        let next = match first {
            Some(first) if first.time.bounds().hi() <= leave || leave > self.horizon => {
                Forecast::Meeting(first)
            }
            Some(first) => Forecast::Leaving(leave.min(first.time.bounds().lo())),
            None if leave > self.horizon => Forecast::Nothing,
            None => Forecast::Leaving(leave),
        };
        self.queue.set(disc, next.bounds()[0]);
        self.forecasts[disc] = next;
        Ok(())
    }

    /// The meeting of a disc with a copy of another, unless they part or none of them
    /// can be deflected.
    fn meeting(&self, disc: usize, image: Image) -> Result<Option<Meeting<S>>, S::Doubt> {
        let other = image.disc as usize;
        let partner_turn = self.flights.starts[other].turn;
        if self.have_parted(disc, image) && self.have_parted(other, image.seen_back(disc))
            || self.grazed[disc].contains(&(image, partner_turn))
        {
            return Ok(None);
        }
        let couple = Couple::new(disc, image);
        let met = meet(&self.flights, &self.period, couple);
        let met =
            met.map_err(|doubt| doubt.asking(|| format!("whether {} meet", couple.pair())))?;
        let [one, two] = couple.discs().map(|disc| self.flights.starts[disc].turn);
        let late = couple.discs()[usize::from(one < two)];
        Ok(met.map(|met| Meeting {
            couple,
            image,
            partner_turn,
            graze: met.graze,
            overlap: met.overlap,
            moment: met.overlap.then(|| self.flights.moment_of(late)),
            time: met.time,
        }))
    }

    /// Whether a disc has collided with a copy of another one last, or nothing deflects
    /// it.
    fn have_parted(&self, disc: usize, image: Image) -> bool {
        !self.flights.world.discs[disc].is_movable() || self.parted[disc] == Some(image)
    }

    /// The next impact, if it is not after `limit`.
    ///
    /// # Errors
    ///
    /// It cannot be decided which impact is the next.
    fn next(&mut self, limit: &S) -> Result<Option<Impact<S>>, S::Doubt> {
        let latest = limit.hull().hi().min(f64::MAX);
        while self.queue.least() <= latest {
            self.collect_front();
            if self.refresh()? {
                continue;
            }
            let Some(next) = self.first()? else {
                continue;
            };
            let question = || format!("whether {} meet before the end", next.couple.pair());
            let order = next.time.order_to(limit);
            if order.map_err(|doubt| doubt.asking(question))? == Greater {
                return Ok(None);
            }
            if next.graze {
                self.pass(&next)?;
            } else {
                return self.resolve(&next).map(Some);
            }
        }
        Ok(None)
    }

    /// Collects the discs whose forecasts may come true no later than that with the
    /// least lower bound.
    fn collect_front(&mut self) {
        let end = |disc: usize| self.forecasts[disc].bounds()[1];
        self.queue.collect_front(end, &mut self.front);
    }

    /// Makes one forecast of the front anew, if one no longer holds or goes not far
    /// enough.
    fn refresh(&mut self) -> Result<bool, S::Doubt> {
        for &disc in &self.front {
            match &self.forecasts[disc] {
                Forecast::Leaving(_) => {
                    settle(&mut self.torus, &self.flights, disc, self.queue.least())?;
                }
                Forecast::Meeting(next)
                    if self.flights.starts[next.image.disc as usize].turn != next.partner_turn => {}
                _ => continue,
            }
            self.forecast(disc)?;
            return Ok(true);
        }
        Ok(false)
    }

    /// The meeting of the front that comes first; of those at one time, by name.
    fn first(&self) -> Result<Option<Meeting<S>>, S::Doubt> {
        let mut first: Option<&Meeting<S>> = None;
        for &disc in &self.front {
            let Forecast::Meeting(next) = &self.forecasts[disc] else {
                continue;
            };
            let is_first = match first {
                None => true,
                Some(first) if next.couple == first.couple => false,
                Some(first) if self.commute(next, first) => next.couple < first.couple,
                Some(first) => next.precedes(first)?,
            };
            if is_first {
                first = Some(next);
            }
        }
        Ok(first.cloned())
    }

    /// Whether two meetings may come in any order: they have no disc in common and no
    /// difference in time that matters.
    fn commute(&self, one: &Meeting<S>, other: &Meeting<S>) -> bool {
        let apart = || (one.time.value() - &other.time.value()).hull();
        one.order(other).is_err()
            && !one.couple.shares_disc(other.couple)
            && is_negligible(&apart(), self.negligible)
    }

    /// Notes a tangent pass, after which both go on.
    fn pass(&mut self, next: &Meeting<S>) -> Result<(), S::Doubt> {
        self.grazes += 1;
        let discs = next.couple.discs();
        for (disc, image) in discs.into_iter().zip(next.couple.images()) {
            let turn = self.flights.starts[image.disc as usize].turn;
            self.grazed[disc].push((image, turn));
        }
        discs.into_iter().try_for_each(|disc| self.forecast(disc))
    }

    fn resolve(&mut self, next: &Meeting<S>) -> Result<Impact<S>, S::Doubt> {
        self.turn += 1;
        let couple = next.couple;
        let named = next.moment.filter(|_| !S::ROUNDS);
        let moment = named.unwrap_or(self.turn);
        let time = next.time.clone().settled(&self.now);
        let discs = couple.discs();
        let is_movable = |disc: &usize| self.flights.world.discs[*disc].is_movable();
        let changed = discs.map(|disc| Some(disc).filter(is_movable));
        let changed = changed.into_iter().flatten();
        for disc in changed.clone() {
            self.flights.bring(disc, &time, moment, self.turn);
        }
        self.now = time.value();
        let (flights, period) = (&mut self.flights, &self.period);
        let contact = collide(flights, period, couple, &self.now, next.overlap)?;
        for (disc, image) in discs.into_iter().zip(couple.images()) {
            self.parted[disc] = Some(image);
        }
        for disc in changed.clone() {
            self.grazed[disc].clear();
            settle(&mut self.torus, &self.flights, disc, self.now.hull().lo())?;
        }
        for disc in changed {
            self.forecast(disc)?;
        }
        Ok(impact(couple, &time, moment, contact))
    }
}

impl<S: Kernel + Scalar> Course<S> for Periodic<S> {
    fn next_impact(&mut self, limit: &S) -> Result<Option<Impact<S>>, S::Doubt> {
        self.next(limit)
    }

    fn disc_count(&self) -> usize {
        self.forecasts.len()
    }

    fn now(&self) -> S {
        self.now.clone()
    }

    fn discs_at(&self, time: &S) -> Vec<Disc<S>> {
        let discs = 0..self.forecasts.len();
        discs.map(|disc| self.flights.disc_at(disc, time)).collect()
    }

    fn grazes(&self) -> u64 {
        self.grazes
    }

    fn rests(&self) -> u64 {
        0
    }

    fn closest_call(&self) -> Option<f64> {
        None
    }

    fn accumulation(&self) -> Option<Accumulation<S>> {
        None
    }

    fn duplicate(&self) -> Box<dyn Course<S>> {
        Box::new(self.clone())
    }
}
