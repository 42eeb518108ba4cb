//! What a disc meets next.
//!
//! Each disc carries one forecast: the first of all its meetings, as things
//! stand. It is made anew when the disc itself has changed, and when its turn
//! comes but the partner has changed meanwhile. A pair is thus forecast by
//! whichever of the two changed last, and no meeting is lost.
//!
//! Where operations are dear, bounds come first: a
//! [`Sweep`](super::sweep::Sweep) drops the discs
//! that are too far away, [`Interval`](crate::scalar::Interval)s enclose the times of the other
//! meetings. Mostly they prove which one is the first: then its exact time is
//! not computed before it comes true, or is to be compared with another.

mod first;
mod outlook;
mod scan;
mod sieve;

use std::cmp::Ordering::Greater;

use super::arbiter::Timed;
use super::flight::Flights;
use super::neighbours::{BroadPhase, Neighbours};
use crate::body::Feature;
use crate::kernel::Kernel;
use crate::world::Obstacle;
use first::First;
use scan::{Scan, View};
use sieve::{Bounds, Sieve, Survivor};

pub(super) use outlook::Forecast;

/// Finds forecasts, and keeps what that takes from one to the next.
#[derive(Clone, Debug)]
pub(super) struct Forecaster {
    /// The bodies' binary64 bounds, where the arithmetic wants the filter.
    bounds: Option<Bounds>,
    /// Looks at what a disc may meet, where discs glide.
    scan: Scan,
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
            scan: Scan::new(flights),
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
        self.scan.update(flights, disc);
        self.neighbours.update(flights, disc);
    }

    /// Takes note of a disc that gets new neighbours at a time before which
    /// nothing happens.
    pub(super) fn renew<S: Kernel>(&mut self, flights: &Flights<S>, disc: usize, time: f64) {
        self.neighbours.renew(flights, disc, time);
    }

    /// Fetches where a disc is among its neighbours into the cache.
    #[inline]
    pub(super) fn fetch(&self, disc: usize) {
        self.neighbours.fetch(disc);
    }

    /// Fetches the cells about a disc.
    #[inline]
    pub(super) fn fetch_cells(&self, disc: usize) {
        self.neighbours.fetch_cells(disc);
    }

    /// Fetches how the discs move that a disc may meet.
    #[inline]
    pub(super) fn fetch_neighbours<S: Kernel>(&mut self, flights: &Flights<S>, disc: usize) {
        let near = self.neighbours.of(disc);
        if near.is_everything() {
            return;
        }
        near.list_discs(&flights.world, &mut self.near);
        for &other in &self.near {
            flights.fetch_motion(other as usize);
        }
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
        let (world, near) = (&flights.world, self.neighbours.of(disc));
        near.visit_walls(world, |wall| sieve.add(Obstacle::Wall(wall as usize)));
        near.list_discs(world, &mut self.near);
        if S::GLIDES {
            let View { first, second, all } = self.scan.look(flights, disc, &mut self.near);
            if first.earliest <= sieve.limit() {
                sieve.add(Obstacle::Disc(first.other as usize));
            }
            if second.earliest <= sieve.limit() {
                for sighted in all.iter().filter(|sighted| sighted.other != first.other) {
                    if sighted.earliest <= sieve.limit() {
                        sieve.add(Obstacle::Disc(sighted.other as usize));
                    }
                }
            }
        } else {
            for &other in self.near.iter().filter(|other| **other as usize != disc) {
                sieve.add(Obstacle::Disc(other as usize));
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
