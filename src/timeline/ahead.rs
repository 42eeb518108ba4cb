//! What the next event will look at, fetched into the cache while this one is under way.
//!
//! With many discs events are anywhere, and wait for memory longer than they compute. But
//! of two events in turn the second one is known early on, mostly: first its disc, and when
//! what is kept of that has come, whom it meets and the cells about it, and at last its
//! neighbours.

use super::Timeline;
use super::arbiter::Timed;
use super::forecast::Forecast;
use crate::body::Feature;
use prefetch_index::prefetch_index;

/// With fewer discs than that all is in the cache.
const MANY: usize = 1 << 14;

impl<S: Timed> Timeline<S> {
    /// The disc of the next event, where it pays to look ahead.
    #[inline]
    fn upcoming(&self) -> Option<usize> {
        if S::IS_DEAR || self.forecasts.len() < MANY {
            return None;
        }
        self.queue.next()
    }

    /// Fetches what is kept of the disc of the next event.
    #[inline]
    pub(super) fn fetch_disc(&self) {
        if let Some(disc) = self.upcoming() {
            self.fetch(disc);
        }
    }

    /// Fetches what is kept of the disc that this meets, and the cells about it.
    #[inline]
    pub(super) fn fetch_partner(&self) {
        let Some(disc) = self.upcoming() else {
            return;
        };
        let next = self.forecasts[disc].as_ref();
        if let Some(Feature::Disc(other)) = next.and_then(Forecast::feature) {
            self.fetch(other as usize);
        }
        self.forecaster.fetch_cells(disc);
    }

    /// Fetches its neighbours.
    #[inline]
    pub(super) fn fetch_neighbours(&mut self) {
        if let Some(disc) = self.upcoming() {
            self.forecaster.fetch_neighbours(&self.flights, disc);
        }
    }

    #[inline]
    fn fetch(&self, disc: usize) {
        prefetch_index(&self.forecasts, disc);
        self.flights.fetch(disc);
        self.forecaster.fetch(disc);
    }
}
