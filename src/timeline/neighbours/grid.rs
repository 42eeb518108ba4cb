//! Grids of square cells, each disc in a cell where its centre is.
//!
//! Discs of about one size are on one *level*, a grid of its own. Until it *leaves*,
//! the centre of a disc surely keeps within its cell, give or take a margin m. Two
//! discs of radii up to R that touch are no further than 2 R from each other, so
//! for cells of size h ≥ 2 R + 2 m their cells are neighbours, or one. All that is
//! computed here is so in binary64, with an error that is checked to be less than
//! a quarter of the margin.
//!
//! Discs of different levels find each other by the *stay* of the one that looks: a
//! box that its centre keeps within until it leaves. Those that it may touch are in
//! the cells no further than R + R' + m' from that, with the other level's numbers
//! (see [`Level::search`]). The two need not find each other at once: one that is
//! not found cannot be touched before one of the two leaves, and looks again. So that
//! a large disc need not look far, its stay is at first no longer than a smallest
//! cell; each time that it leaves in vain, the next one is twice as long.
//!
//! The cells of a plane without bounds share a finite number of *buckets*. A disc of
//! which the numbers are too uncertain, or that keeps leaving cells without
//! meeting anything, is a *stray*: a neighbour of all others, as all are of it.

use prefetch_index::prefetch_index;

use super::Motion;
use super::course::Course;
use super::level::{Level, Stay};
use super::sizes::{Spot, largest_of_levels, size_of_cells};
use crate::kernel::Kernel;
use crate::world::World;

/// The part of a cell that is margin.
pub(super) const MARGIN: f64 = 1.0 / 16.0;

/// The least size of a cell, in radii of the largest disc of its level.
pub(super) const SIZE: f64 = 2.0 * (1.0 + 1e-9) / (1.0 - 2.0 * MARGIN);

/// Where strays are.
const NONE: u32 = u32::MAX;

/// Where a disc is that has not been placed yet.
const NOWHERE: u32 = u32::MAX - 1;

/// Where the discs are.
#[derive(Clone, Debug)]
pub(in crate::timeline) struct Grid {
    /// From large cells to small ones.
    levels: Vec<Level>,
    places: Vec<Place>,
    /// Of use only where there are several levels.
    stays: Vec<Stay>,
    strays: Vec<u32>,
    /// The size of the smallest cells.
    least: f64,
    /// How often a disc may leave cells in vain.
    patience: u16,
}

/// A disc's place.
#[derive(Clone, Copy, Debug)]
struct Place {
    /// The bucket, unless it is a stray.
    bucket: u32,
    level: u16,
    /// How often it has left a cell since it changed.
    moves: u16,
    leave: f64,
}

/// What is near a disc.
pub(in crate::timeline) struct Near<'a> {
    grid: &'a Grid,
    disc: usize,
    level: &'a Level,
    bucket: u32,
}

impl Grid {
    /// An empty grid for the discs of a world, with all its walls.
    pub(super) fn new<S: Kernel>(world: &World<S>) -> Self {
        let mut spots: Vec<Spot> = world.discs.iter().map(Spot::of).collect();
        let extent = extent(&spots);
        let largest = largest_of_levels(&mut spots);
        let level_of = |radius: f64| largest.partition_point(|largest| *largest >= radius) - 1;
        let mut counts = vec![0; largest.len()];
        let mut grid = Self {
            levels: Vec::new(),
            places: Vec::new(),
            stays: Vec::new(),
            strays: Vec::new(),
            least: f64::INFINITY,
            patience: (spots.len() / 8).clamp(64, u16::MAX.into()) as u16,
        };
        for disc in &world.discs {
            let level = level_of(disc.radius.hull().hi());
            counts[level] += 1;
            grid.places.push(Place::nowhere(level));
        }
        if largest.len() > 1 {
            grid.stays = vec![Stay::default(); spots.len()];
        }
        let mut rest = &spots[..];
        for (largest, count) in largest.into_iter().zip(counts) {
            let (own, smaller) = rest.split_at(count);
            let size = size_of_cells(own, largest, extent, world.walls.len());
            grid.least = grid.least.min(size);
            grid.levels
                .push(Level::new(world, [largest, size], extent, count));
            rest = smaller;
        }
        grid
    }

    /// What is near a disc, unless it is a stray.
    #[inline]
    pub(super) fn near(&self, disc: usize) -> Option<Near<'_>> {
        let place = &self.places[disc];
        (place.bucket != NONE).then(|| Near {
            grid: self,
            disc,
            level: &self.levels[usize::from(place.level)],
            bucket: place.bucket,
        })
    }

    /// Fetches the place of a disc into the cache.
    #[inline]
    pub(super) fn fetch(&self, disc: usize) {
        prefetch_index(&self.places, disc);
    }

    /// Fetches the cells about a disc.
    #[inline]
    pub(super) fn fetch_cells(&self, disc: usize) {
        if let Some(near) = self.near(disc) {
            near.level.fetch_around(near.bucket);
        }
    }

    #[inline]
    pub(super) fn leave(&self, disc: usize) -> f64 {
        self.places[disc].leave
    }

    /// Puts a disc into its cell at a time, after its motion has changed.
    #[inline(always)]
    pub(super) fn settle(&mut self, disc: usize, motion: &Motion, time: f64) {
        self.places[disc].moves = 0;
        self.place(disc, motion, time);
    }

    /// Makes a disc a stray for good.
    pub(super) fn stray(&mut self, disc: usize) {
        self.move_to(disc, NONE, f64::INFINITY);
    }

    /// Puts a disc into the cell that it gets into at a time.
    pub(super) fn renew(&mut self, disc: usize, motion: &Motion, time: f64) {
        let moves = self.places[disc].moves + 1;
        if moves > self.patience {
            self.stray(disc);
        } else {
            self.places[disc].moves = moves;
            self.place(disc, motion, time);
        }
    }

    #[inline(always)]
    fn place(&mut self, disc: usize, motion: &Motion, time: f64) {
        let (bucket, leave) = self
            .find(disc, motion, time)
            .unwrap_or((NONE, f64::INFINITY));
        self.move_to(disc, bucket, leave);
    }

    /// The bucket of a disc at a time, and when it leaves the cell.
    #[inline(always)]
    fn find(&mut self, disc: usize, motion: &Motion, time: f64) -> Option<(u32, f64)> {
        let shape = &self.level(disc).shape;
        let x = Course::follow(motion, 0, time, &shape.scale)?;
        let y = Course::follow(motion, 1, time, &shape.scale)?;
        let mut leave = x.leave.min(y.leave).min(motion.until);
        let bucket = shape.bucket([x.cell, y.cell]);
        let limit = MARGIN * shape.scale.size / 4.0;
        if !self.stays.is_empty() {
            leave = leave.min(time + self.way(disc) / x.speed.abs().max(y.speed.abs()));
            let ends = [&x, &y].map(|course| course.between(time, leave));
            self.stays[disc] = Stay::about(ends, 2.0 * limit);
        }
        let is_certain = x.error_at(leave) < limit && y.error_at(leave) < limit;
        is_certain.then_some((bucket, leave))
    }

    /// How far a disc may move in a coordinate before it looks again.
    fn way(&self, disc: usize) -> f64 {
        self.least * f64::from(self.places[disc].moves.min(1000)).exp2()
    }

    /// For how long the motion of a disc is as good as straight, if no coordinate of
    /// the acceleration is larger than this.
    pub(super) fn straight_for(&self, disc: usize, pull: f64) -> f64 {
        (MARGIN * self.level(disc).shape.scale.size / 8.0 / pull).sqrt()
    }

    #[inline]
    fn level(&self, disc: usize) -> &Level {
        &self.levels[usize::from(self.places[disc].level)]
    }

    /// Moves a disc from its list to another.
    #[inline]
    fn move_to(&mut self, disc: usize, bucket: u32, leave: f64) {
        let place = &mut self.places[disc];
        place.leave = leave;
        let before = std::mem::replace(&mut place.bucket, bucket);
        if before == bucket {
            return;
        }
        let discs = &mut self.levels[usize::from(place.level)].discs;
        match before {
            NOWHERE => {}
            NONE => self.strays.retain(|&stray| stray as usize != disc),
            _ => discs.remove(before, disc as u32),
        }
        match bucket {
            NONE => self.strays.push(disc as u32),
            _ => discs.insert(bucket, disc as u32),
        }
    }
}

impl Near<'_> {
    /// The walls that the disc may meet.
    #[inline]
    pub(super) fn walls(&self) -> impl Iterator<Item = u32> {
        self.level.walls.near(self.bucket)
    }

    /// Lists the discs that it may meet, it itself among them.
    #[inline]
    pub(super) fn list_discs(&self, list: &mut Vec<u32>) {
        self.level.list_around(self.bucket, list);
        if !self.grid.stays.is_empty() {
            self.list_others(list);
        }
        list.extend(&self.grid.strays);
    }

    /// Adds the discs of other levels.
    fn list_others(&self, list: &mut Vec<u32>) {
        let stay = &self.grid.stays[self.disc];
        let is_other = |level: &&Level| !std::ptr::eq(*level, self.level);
        for level in self.grid.levels.iter().filter(is_other) {
            level.search(stay, self.level.largest, list);
        }
    }
}

impl Place {
    fn nowhere(level: usize) -> Self {
        Self {
            bucket: NOWHERE,
            level: level as u16,
            moves: 0,
            leave: f64::INFINITY,
        }
    }
}

/// The width and the height of the area in which the discs are.
fn extent(spots: &[Spot]) -> [f64; 2] {
    [0, 1].map(|axis| {
        let places = spots.iter().map(|spot| spot.place[axis]);
        let ends = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| {
            (low.min(place), high.max(place))
        });
        ends.1 - ends.0
    })
}
