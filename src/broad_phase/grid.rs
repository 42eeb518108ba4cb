//! A grid of square cells, about as large as the areas are.
//!
//! The cells of a plane without bounds share a finite number of places: a power of
//! two of them in a row, and as many rows. A point's cell is a coordinate times a
//! constant, rounded down. Both round, but never out of order: a point of two areas
//! is in a cell that is between the first and the last one of each.

use super::area::Area;

/// Cells further out have no names.
const FARTHEST: f64 = (1_u64 << 31) as f64;

/// An area over more than this part of all places is better compared with all.
const SPREAD: usize = 4;

/// How large the cells are, and how they share places.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    inverse: f64,
    columns: i64,
    rows: i64,
}

/// The cells of an area, from the first to the last in both directions.
#[derive(Clone, Copy)]
pub(super) struct Cells {
    first: [i64; 2],
    last: [i64; 2],
}

impl Grid {
    /// A grid for some areas: with cells of their mean size, and some two places
    /// for each of them in the shape of all together; none if they are
    /// points, or too large.
    pub(super) fn of(areas: &[Area]) -> Option<Self> {
        let bounded = || areas.iter().filter(|area| area.is_bounded());
        let count = bounded().count();
        let size = bounded()
            .map(|area| area.size() / count as f64)
            .sum::<f64>();
        let most = (2 * count).next_power_of_two().max(16) as f64;
        let cells = [0, 1].map(|axis| {
            let ends = bounded().map(|area| (area.lo[axis], area.hi[axis]));
            let (lo, hi) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), end| {
                (lo.min(end.0), hi.max(end.1))
            });
            ((hi - lo) / size).clamp(1.0, most)
        });
        // As many as most, if there are so many cells.
        let excess = (cells[0] * cells[1] / most).max(1.0).sqrt();
        let [columns, rows] = cells.map(|cells| (cells / excess) as i64);
        let inverse = 1.0 / size;
        inverse.is_normal().then_some(Self {
            inverse,
            columns: (columns.max(1) as u64).next_power_of_two() as i64,
            rows: (rows.max(1) as u64).next_power_of_two() as i64,
        })
    }

    /// How many places there are.
    pub(super) fn places(&self) -> usize {
        (self.columns * self.rows) as usize
    }

    /// The cells that an area touches, unless they are too many.
    #[inline]
    pub(super) fn cells(&self, area: &Area) -> Option<Cells> {
        let [left, bottom] = area.lo.map(|end| self.cell(end));
        let [right, top] = area.hi.map(|end| self.cell(end));
        let cells = Cells {
            first: [left?, bottom?],
            last: [right?, top?],
        };
        (cells.count() <= self.places().div_ceil(SPREAD)).then_some(cells)
    }

    #[inline]
    fn cell(&self, coordinate: f64) -> Option<i64> {
        cell(coordinate * self.inverse)
    }

    /// Visits the places of some cells.
    #[inline]
    pub(super) fn visit(&self, cells: Cells, mut visit: impl FnMut(usize)) {
        for row in cells.first[1]..=cells.last[1] {
            let start = (row & (self.rows - 1)) * self.columns;
            for column in cells.first[0]..=cells.last[0] {
                visit((start + (column & (self.columns - 1))) as usize);
            }
        }
    }
}

/// The cell of a coordinate that is told in cells, unless it is too far out.
#[inline]
pub(crate) fn cell(coordinate: f64) -> Option<i64> {
    // Rounded down: quicker than the function of the C library.
    let floor = || coordinate as i64 - i64::from(coordinate < coordinate as i64 as f64);
    (coordinate.abs() < FARTHEST).then(floor)
}

impl Cells {
    fn count(&self) -> usize {
        let [columns, rows] = [0, 1].map(|axis| self.last[axis].abs_diff(self.first[axis]) + 1);
        columns.saturating_mul(rows) as usize
    }
}
