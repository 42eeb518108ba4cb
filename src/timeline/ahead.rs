//! What the next events will look at, fetched into the cache before they come.
//!
//! With many discs events are anywhere, and wait for memory longer than they compute. But
//! mostly it is known which ones are next. So while others are under way, their data are
//! fetched in three steps, each of which tells where the next ones are: what is kept of
//! the disc; of whom it meets, and the cells about it; how its neighbours move.

use prefetch_index::prefetch_index;

use super::Timeline;
use super::arbiter::Timed;
use super::forecast::Forecast;
use crate::body::Feature;

/// With fewer discs memory is not waited for longer than it takes to look ahead: with 10⁴
/// of them that made an impact an eighth slower.
const MANY: usize = 1 << 14;

/// So many discs are looked ahead for. Six to sixteen were no quicker.
const DISCS: usize = 4;

/// The discs of the next events, by how much of them has been fetched.
#[derive(Clone, Debug, Default)]
pub(super) struct Ahead {
    is_worth_it: bool,
    fetched: Vec<usize>,
    surrounded: Vec<usize>,
}

impl Ahead {
    /// For so many discs.
    pub(super) fn new<S: Timed>(discs: usize) -> Self {
        Self {
            is_worth_it: !S::IS_DEAR && discs >= MANY,
            ..Self::default()
        }
    }
}

impl<S: Timed> Timeline<S> {
    /// Looks ahead.
    #[inline]
    pub(super) fn look_ahead(&mut self) {
        if self.ahead.is_worth_it {
            self.fetch_step();
        }
    }

    fn fetch_step(&mut self) {
        let mut ahead = std::mem::take(&mut self.ahead);
        for disc in ahead.surrounded.drain(..) {
            self.forecaster.fetch_neighbours(&self.flights, disc);
        }
        std::mem::swap(&mut ahead.surrounded, &mut ahead.fetched);
        for &disc in &ahead.surrounded {
            self.fetch_surroundings(disc);
        }
        self.queue.look_ahead(DISCS, &mut ahead.fetched);
        for &disc in &ahead.fetched {
            self.fetch(disc);
        }
        self.ahead = ahead;
    }

    /// Fetches what is kept of a disc.
    #[inline]
    fn fetch(&self, disc: usize) {
        // It may be in two lines of the cache.
        prefetch_index(&self.forecasts, disc);
        prefetch_index(&self.forecasts, disc + 1);
        self.queue.fetch(disc);
        self.flights.fetch(disc);
        self.forecaster.fetch(disc);
    }

    /// Fetches what is kept of whom a disc meets, and the cells about it.
    #[inline]
    fn fetch_surroundings(&self, disc: usize) {
        let next = self.forecasts[disc].as_ref();
        if let Some(Feature::Disc(other)) = next.and_then(Forecast::feature) {
            self.fetch(other as usize);
        }
        for feature in self.flights.world.contacts.of(disc) {
            if let Feature::Disc(other) = feature {
                self.flights.world.contacts.fetch(*other as usize);
            }
        }
        self.forecaster.fetch_cells(disc);
    }
}
