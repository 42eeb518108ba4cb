//! The cells of a periodic plane, which are those of one rectangle over and over.
//!
//! Places are not taken back into the rectangle: a disc goes on from cell to cell
//! without an end. A side L has n cells of size L / n, so the copy of a disc that is k
//! rectangles further on is k n cells further on. Until it leaves its cell the centre of
//! a disc keeps within that, give or take a margin m, as in a [`Grid`](super::grid::Grid);
//! so two discs of radii up to R touch only if their cells are no further from each
//! other than g, for g cells are at least as long as 2 R + 2 m.

use super::Motion;
use super::cells::Cells;
use super::course::Course;
use super::grid::{MARGIN, SIZE};
use super::shape::Scale;

/// More than what rounds.
const SLACK: f64 = 1.0 + 1e-9;

/// No more cells than so many for each disc.
const CELLS: f64 = 2.0;

/// No more cells on a side than so many: a disc may get many sides away, and cells are
/// counted up to 2^31.
const MOST: f64 = 2048.0;

/// A copy of a disc, so many rectangles further on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(in crate::timeline) struct Image {
    pub(in crate::timeline) disc: u32,
    pub(in crate::timeline) cell: [i64; 2],
}

impl Image {
    /// The copy of another disc that this disc is as seen from that copy of it.
    pub(in crate::timeline) fn seen_back(self, disc: usize) -> Self {
        Self {
            disc: disc as u32,
            cell: self.cell.map(|cell| -cell),
        }
    }
}

/// Where the discs are.
#[derive(Clone, Debug)]
pub(in crate::timeline) struct Torus {
    axes: [Axis; 2],
    discs: Cells,
    places: Vec<Place>,
}

/// One coordinate of the cells.
#[derive(Clone, Copy, Debug)]
struct Axis {
    scale: Scale,
    /// So many are a side.
    count: i64,
    /// How many cells further on something may touch.
    reach: i64,
}

/// A disc's place.
#[derive(Clone, Copy, Debug)]
struct Place {
    cell: [i64; 2],
    leave: f64,
}

impl Axis {
    fn new(side: f64, size: f64, largest: f64) -> Self {
        let count = (side / size).floor();
        // Also where these are beyond all bounds, which leaves no number.
        let count = if count >= 1.0 { count.min(MOST) } else { 1.0 };
        let size = side / count;
        let reach = 2.0 * largest / size + 2.0 * MARGIN;
        Self {
            scale: Scale::new(size),
            count: count as i64,
            reach: (reach * SLACK).ceil() as i64,
        }
    }

    /// The cells of the rectangle that those near a cell are copies of, each once.
    fn around(self, cell: i64) -> impl Iterator<Item = u32> {
        let count = (2 * self.reach + 1).min(self.count);
        (0..count).map(move |place| (cell - self.reach + place).rem_euclid(self.count) as u32)
    }

    /// How many rectangles further on copies of something in another cell are that are
    /// near a cell.
    fn copies(self, cell: i64, other: i64) -> std::ops::RangeInclusive<i64> {
        let away = cell - other;
        let first = (away - self.reach).div_euclid(self.count);
        let first = first + i64::from((away - self.reach).rem_euclid(self.count) > 0);
        first..=(away + self.reach).div_euclid(self.count)
    }
}

impl Torus {
    /// The empty cells for so many discs, none larger than that, in a rectangle.
    pub(in crate::timeline) fn new(sides: [f64; 2], largest: f64, discs: usize) -> Self {
        let area = sides[0] * sides[1] / (CELLS * discs.max(1) as f64);
        let size = (SIZE * largest).max(area.sqrt());
        let axes = sides.map(|side| Axis::new(side, size, largest));
        let place = Place {
            cell: [0, 0],
            leave: f64::INFINITY,
        };
        let mut torus = Self {
            discs: Cells::new((axes[0].count * axes[1].count) as usize),
            axes,
            places: vec![place; discs],
        };
        for disc in 0..discs {
            torus.discs.insert(0, disc as u32);
        }
        torus
    }

    /// Puts a disc into the cell where it is at a time. Whether it is certain that it
    /// keeps within that until it leaves.
    pub(in crate::timeline) fn settle(&mut self, disc: usize, motion: &Motion, time: f64) -> bool {
        let courses = [0, 1].map(|axis| Course::follow(motion, axis, time, &self.axes[axis].scale));
        let [Some(x), Some(y)] = courses else {
            self.places[disc].leave = f64::INFINITY;
            return false;
        };
        let place = Place {
            cell: [x.cell, y.cell],
            leave: x.leave.min(y.leave),
        };
        let limits = self.axes.map(|axis| MARGIN * axis.scale.size / 4.0);
        let before = std::mem::replace(&mut self.places[disc], place);
        let [before, after] = [before.cell, place.cell].map(|cell| self.bucket(cell));
        if before != after {
            self.discs.remove(before, disc as u32);
            self.discs.insert(after, disc as u32);
        }
        x.error_at(place.leave) < limits[0] && y.error_at(place.leave) < limits[1]
    }

    /// When a disc leaves its cell.
    pub(in crate::timeline) fn leave(&self, disc: usize) -> f64 {
        self.places[disc].leave
    }

    /// Lists the copies of other discs that a disc may touch until it leaves its cell,
    /// or they theirs.
    pub(in crate::timeline) fn list(
        &self,
        disc: usize,
        found: &mut Vec<u32>,
        list: &mut Vec<Image>,
    ) {
        let cell = self.places[disc].cell;
        found.clear();
        list.clear();
        for row in self.axes[1].around(cell[1]) {
            for column in self.axes[0].around(cell[0]) {
                let bucket = row * self.axes[0].count as u32 + column;
                self.discs.list_between(bucket, bucket, found);
            }
        }
        let others = found.iter().filter(|other| **other as usize != disc);
        list.extend(others.flat_map(|&other| self.copies(cell, other)));
    }

    /// The copies of a disc that are near a cell.
    fn copies(&self, cell: [i64; 2], disc: u32) -> impl Iterator<Item = Image> + use<> {
        let other = self.places[disc as usize].cell;
        let [columns, rows] = [0, 1].map(|axis| self.axes[axis].copies(cell[axis], other[axis]));
        let cells = rows.flat_map(move |row| columns.clone().map(move |column| [column, row]));
        cells.map(move |cell| Image { disc, cell })
    }

    fn bucket(&self, [column, row]: [i64; 2]) -> u32 {
        let [columns, rows] = self.axes.map(|axis| axis.count);
        (row.rem_euclid(rows) * columns + column.rem_euclid(columns)) as u32
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::Known;
    use super::*;

    fn motion(position: [f64; 2]) -> Motion {
        let known = |value| Known { value, error: 0.0 };
        Motion {
            position: position.map(known),
            velocity: [known(0.0); 2],
            since: known(0.0),
            until: f64::INFINITY,
        }
    }

    proptest! {
        /// Against all copies that may be meant: what is closer than the two radii is
        /// listed, and nothing twice.
        #[test]
        fn lists_all_that_is_close(
            places in prop::collection::vec(prop::array::uniform2(-40.0..40.0_f64), 2..12),
            sides in prop::array::uniform2(2.0..20.0_f64),
            largest in 0.1..1.0_f64,
        ) {
            let mut torus = Torus::new(sides, largest, places.len());
            for (disc, place) in places.iter().enumerate() {
                prop_assert!(torus.settle(disc, &motion(*place), 0.0));
            }
            for (disc, place) in places.iter().enumerate() {
                let (mut found, mut list) = (Vec::new(), Vec::new());
                torus.list(disc, &mut found, &mut list);
                let mut once = list.clone();
                once.sort_unstable();
                once.dedup();
                prop_assert_eq!(once.len(), list.len());
                let images = (-45..=45_i64).flat_map(|x| (-45..=45_i64).map(move |y| [x, y]));
                for (other, cell) in images.flat_map(|cell| (0..places.len()).map(move |o| (o, cell))) {
                    let apart = [0, 1].map(|axis| {
                        places[other][axis] + cell[axis] as f64 * sides[axis] - place[axis]
                    });
                    if other != disc && apart[0].hypot(apart[1]) < 2.0 * largest {
                        let image = Image { disc: other as u32, cell };
                        prop_assert!(list.contains(&image), "{disc} {image:?}");
                    }
                }
            }
        }
    }
}
