//! A grid of square cells, each disc in the one where its centre is.
//!
//! Until it *leaves*, the centre of a disc surely keeps within its cell, give or
//! take a margin m. Two discs of radii up to R that touch are no further than
//! 2 R from each other, so for cells of size h ≥ 2 R + 2 m their cells are
//! neighbours, or one. All that is computed here is so in binary64, with an
//! error that is checked to be less than a quarter of the margin.
//!
//! The cells of a plane without bounds share a finite number of *buckets*. A disc that is larger than R, or of
//! which the numbers are too uncertain, or that keeps leaving cells without
//! meeting anything, is a *stray*: a neighbour of all others, as all are of it.

use super::Motion;
use super::cells::{Cells, ROOM};
use super::walls::Walls;
use crate::scalar::Interval;
use crate::world::World;

/// The part of a cell that is margin.
const MARGIN: f64 = 1.0 / 16.0;

/// The size of a cell, in radii of the largest disc that is no stray.
const SIZE: f64 = 2.0 * (1.0 + 1e-9) / (1.0 - 2.0 * MARGIN);

/// Cells further out have no names.
const FARTHEST: f64 = (1_u64 << 31) as f64;

/// Where strays are.
const NONE: u32 = u32::MAX;

/// Where a disc is that has not been placed yet.
const NOWHERE: u32 = u32::MAX - 1;

/// Where the discs are.
#[derive(Clone, Debug)]
pub(in crate::timeline) struct Grid {
    shape: Shape,
    buckets: Cells,
    places: Vec<Place>,
    strays: Vec<u32>,
    walls: Walls,
    /// The radius above which a disc is a stray.
    largest: f64,
    radii: Vec<f64>,
    /// How often a disc may leave cells in vain.
    patience: u32,
}

/// The size of the cells, and how they share buckets: a power of two of them in
/// a row, and as many rows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    pub(super) size: f64,
    inverse: f64,
    columns: u32,
    rows: u32,
}

/// A disc's place.
#[derive(Clone, Copy, Debug)]
struct Place {
    /// The bucket, unless it is a stray.
    bucket: u32,
    /// How often it has left a cell since it changed.
    moves: u32,
    leave: f64,
}

impl Shape {
    /// As many buckets as discs, or a few times that, in the shape of an area.
    fn of(size: f64, [width, height]: [f64; 2], discs: usize) -> Self {
        let most = (2 * discs).next_power_of_two().max(16) as f64;
        let cells = |length: f64| (length / size).clamp(4.0, most / 4.0);
        let [mut columns, mut rows] =
            [width, height].map(|length| (cells(length) as u32).next_power_of_two());
        while f64::from(columns) * f64::from(rows) > most && columns.max(rows) > 4 {
            if columns > rows {
                columns /= 2;
            } else {
                rows /= 2;
            }
        }
        Self {
            size,
            inverse: 1.0 / size,
            columns,
            rows,
        }
    }

    pub(super) fn buckets(&self) -> usize {
        self.columns as usize * self.rows as usize
    }

    /// The cell of a coordinate.
    #[inline]
    pub(super) fn cell(&self, coordinate: f64) -> Option<i64> {
        let place = coordinate * self.inverse;
        // Rounded down: quicker than the function of the C library.
        let cell = place as i64 - i64::from(place < place as i64 as f64);
        (place.abs() < FARTHEST).then_some(cell)
    }

    #[inline]
    pub(super) fn bucket(&self, [column, row]: [i64; 2]) -> u32 {
        let column = column as u32 & (self.columns - 1);
        let row = row as u32 & (self.rows - 1);
        row * self.columns + column
    }

    /// The buckets of a cell and of the eight cells about it.
    #[inline]
    fn around(&self, bucket: u32) -> [u32; 9] {
        let Self { columns, rows, .. } = *self;
        let (column, row) = (bucket & (columns - 1), bucket >> columns.trailing_zeros());
        let [left, middle, right] = beside(column, columns);
        let [below, here, above] = beside(row, rows).map(|row| row * columns);
        [
            below + left,
            below + middle,
            below + right,
            here + left,
            here + middle,
            here + right,
            above + left,
            above + middle,
            above + right,
        ]
    }
}

/// A place among so many, a power of two, and those next to it, all about.
#[inline]
fn beside(place: u32, count: u32) -> [u32; 3] {
    [
        place.wrapping_sub(1) & (count - 1),
        place,
        (place + 1) & (count - 1),
    ]
}

impl Grid {
    /// An empty grid for the discs of a world, with all its walls.
    pub(super) fn new(world: &World<Interval>) -> Self {
        let radii: Vec<f64> = world.discs.iter().map(|disc| disc.radius.hi()).collect();
        let largest = largest_of_most(&radii);
        let size = SIZE * largest;
        let shape = Shape::of(size, extent(world), radii.len());
        let nowhere = Place {
            bucket: NOWHERE,
            moves: 0,
            leave: f64::INFINITY,
        };
        Self {
            buckets: Cells::new(shape.buckets()),
            places: vec![nowhere; radii.len()],
            strays: Vec::new(),
            walls: Walls::new(world, &shape, largest + MARGIN * size),
            largest,
            patience: (radii.len() as u32 / 8).max(64),
            radii,
            shape,
        }
    }

    #[inline]
    pub(super) fn is_stray(&self, disc: usize) -> bool {
        self.places[disc].bucket == NONE
    }

    #[inline]
    pub(super) fn leave(&self, disc: usize) -> f64 {
        self.places[disc].leave
    }

    /// Puts a disc into its cell at a time, after its motion has changed.
    #[inline]
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
        self.places[disc].moves = moves;
        if moves > self.patience {
            self.stray(disc);
        } else {
            self.place(disc, motion, time);
        }
    }

    #[inline]
    fn place(&mut self, disc: usize, motion: &Motion, time: f64) {
        let (bucket, leave) = self
            .find(disc, motion, time)
            .unwrap_or((NONE, f64::INFINITY));
        self.move_to(disc, bucket, leave);
    }

    /// The bucket of a disc at a time, and when it leaves the cell.
    #[inline]
    fn find(&self, disc: usize, motion: &Motion, time: f64) -> Option<(u32, f64)> {
        if self.radii[disc] > self.largest {
            return None;
        }
        let x = self.follow(motion, 0, time)?;
        let y = self.follow(motion, 1, time)?;
        let leave = x.leave.min(y.leave).min(motion.until);
        let limit = MARGIN * self.shape.size / 4.0;
        let is_certain = x.error_at(leave) < limit && y.error_at(leave) < limit;
        is_certain.then(|| (self.shape.bucket([x.cell, y.cell]), leave))
    }

    /// For how long a motion is as good as straight, if no coordinate of the
    /// acceleration is larger than this.
    pub(super) fn straight_for(&self, pull: f64) -> f64 {
        (MARGIN * self.shape.size / 8.0 / pull).sqrt()
    }

    /// One coordinate of a motion from a time on.
    #[inline]
    fn follow(&self, motion: &Motion, axis: usize, time: f64) -> Option<Course> {
        let [position, velocity] = [motion.position[axis], motion.velocity[axis]];
        let (speed, since) = (velocity.value, motion.since.value);
        let start = position.value + speed * (time - since);
        let cell = self.shape.cell(start)?;
        let size = self.shape.size;
        let (low, high) = (cell as f64 * size, (cell + 1) as f64 * size);
        let margin = MARGIN * size / 2.0;
        let way = if speed > 0.0 {
            high + margin - start
        } else {
            start - (low - margin)
        };
        Some(Course {
            cell,
            leave: if speed == 0.0 {
                f64::INFINITY
            } else {
                time + way / speed.abs()
            },
            known: position.error + speed.abs() * motion.since.error,
            size: position.value.abs() + position.error,
            speed: speed.abs(),
            uncertain: velocity.error,
            since,
        })
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
        match before {
            NOWHERE => {}
            NONE => self.strays.retain(|&stray| stray as usize != disc),
            _ => self.buckets.remove(before, disc as u32),
        }
        match bucket {
            NONE => self.strays.push(disc as u32),
            _ => self.buckets.insert(bucket, disc as u32),
        }
    }

    /// The walls near a disc that is no stray.
    #[inline]
    pub(super) fn walls(&self, disc: usize) -> impl Iterator<Item = u32> {
        self.walls.near(self.places[disc].bucket)
    }

    /// Lists the discs near a disc that is no stray, it itself among them.
    #[inline]
    pub(super) fn list_discs(&self, disc: usize, list: &mut Vec<u32>) {
        let around = self.shape.around(self.places[disc].bucket);
        list.resize(around.len() * ROOM, NONE);
        let mut count = 0;
        for bucket in around {
            count = self.buckets.list(bucket, list, count);
        }
        list.truncate(count);
        if self.buckets.have_others() {
            let others = |bucket| self.buckets.others(bucket).iter().copied();
            list.extend(around.into_iter().flat_map(others));
        }
        list.extend(&self.strays);
    }
}

/// One coordinate of a disc's motion.
struct Course {
    cell: i64,
    leave: f64,
    /// How far off it may be at the start.
    known: f64,
    size: f64,
    speed: f64,
    /// How far off the speed may be.
    uncertain: f64,
    since: f64,
}

impl Course {
    /// How far off it may be at a time, with all that rounds until then.
    #[inline]
    fn error_at(&self, time: f64) -> f64 {
        if time == f64::INFINITY {
            // It rests, if it is certain to.
            let rests = self.speed == 0.0 && self.uncertain == 0.0;
            return if rests { self.known } else { f64::INFINITY };
        }
        let flown = (time - self.since).abs();
        let way = (self.speed + self.uncertain) * flown;
        let rounds = 8.0 * f64::EPSILON * (self.size + way + self.speed * time.abs());
        self.known + self.uncertain * flown + rounds
    }
}

/// The radius that only a few discs exceed, if that is much less than the
/// largest.
fn largest_of_most(radii: &[f64]) -> f64 {
    let mut sorted = radii.to_vec();
    sorted.sort_by(|one, other| other.total_cmp(one));
    let few = (radii.len() as f64).sqrt() as usize / 2;
    if sorted[few] < sorted[0] / 2.0 {
        sorted[few]
    } else {
        sorted[0]
    }
}

/// The width and the height of the area in which the discs are.
fn extent(world: &World<Interval>) -> [f64; 2] {
    let length = |coordinate: fn(&crate::vec2::Vec2<Interval>) -> &Interval| {
        let ends = world.discs.iter().map(|disc| coordinate(&disc.position));
        let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), end| {
            (low.min(end.lo()), high.max(end.hi()))
        });
        high - low
    };
    [length(|point| &point.x), length(|point| &point.y)]
}
