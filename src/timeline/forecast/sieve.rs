//! What bounds, or a glance, rule out of what a disc may meet.

use crate::body::Feature;
use crate::kernel::{Glance, Kernel};
use crate::scalar::Interval;
use crate::timeline::flight::Flights;
use crate::timeline::sweep::Sweep;
use crate::world::Obstacle;

/// What bounds have not ruled out as the first meeting of a disc.
#[derive(Clone, Debug)]
pub(super) struct Survivor {
    pub(super) obstacle: Obstacle,
    /// They do not meet outside of this time, if they do.
    pub(super) time: Interval,
    /// What is met, if it is proven that there is an impact with a delay.
    pub(super) impact: Option<Feature>,
}

/// The bodies in bounds, and what discs are too far apart.
#[derive(Clone, Debug)]
pub(super) struct Bounds {
    pub(super) flights: Flights<Interval>,
    pub(super) sweep: Sweep,
}

impl Bounds {
    pub(super) fn new(flights: Flights<Interval>, horizon: f64) -> Self {
        let sweep = Sweep::new(&flights, horizon);
        Self { flights, sweep }
    }

    pub(super) fn update<S: Kernel>(&mut self, flights: &Flights<S>, disc: usize) {
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
        let begun = self.flights.starts[disc].since.lo();
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

/// Finds what of its neighbours a disc may meet first.
pub(super) struct Sieve<'a, S: Kernel, W, K> {
    pub(super) flights: &'a Flights<S>,
    pub(super) disc: usize,
    pub(super) bounds: Option<&'a Bounds>,
    pub(super) survivors: &'a mut Vec<Survivor>,
    /// A time by which it meets something, if nothing happens before, or after
    /// which nothing is of interest.
    pub(super) latest: f64,
    pub(super) wanted: W,
    pub(super) skips: K,
}

impl<S, W, K> Sieve<'_, S, W, K>
where
    S: Kernel,
    W: Fn(Obstacle) -> bool,
    K: Fn(Obstacle, Feature, bool) -> bool,
{
    /// Adds an obstacle, unless it is ruled out.
    pub(super) fn add(&mut self, obstacle: Obstacle) {
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

    /// The time after which nothing is of interest, by far more than a time rounds, but
    /// not never.
    #[inline]
    pub(super) fn limit(&self) -> f64 {
        let limit = self.latest + 8.0 * f64::EPSILON * self.latest.abs();
        limit.min(f64::MAX)
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
    pub(super) fn finish(self) {
        if self.survivors.len() > 1 {
            let latest = self.latest;
            self.survivors
                .retain(|survivor| survivor.time.lo() <= latest);
        }
    }
}
