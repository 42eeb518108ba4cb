//! Square cells, and how they share buckets.

use crate::broad_phase::cell;

/// One coordinate of cells of some size.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    pub(super) size: f64,
    inverse: f64,
}

impl Scale {
    pub(super) fn new(size: f64) -> Self {
        Self {
            size,
            inverse: 1.0 / size,
        }
    }

    /// The cell of a coordinate.
    #[inline]
    pub(super) fn cell(&self, coordinate: f64) -> Option<i64> {
        cell(coordinate * self.inverse)
    }
}

/// The size of the cells, and how they share buckets: a power of two of them in
/// a row, and as many rows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    pub(super) scale: Scale,
    columns: u32,
    rows: u32,
}

impl Shape {
    /// As many buckets as discs, or a few times that, in the shape of an area.
    pub(super) fn of(size: f64, [width, height]: [f64; 2], discs: usize) -> Self {
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
            scale: Scale::new(size),
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
        self.scale.cell(coordinate)
    }

    #[inline]
    pub(super) fn bucket(&self, [column, row]: [i64; 2]) -> u32 {
        let column = column as u32 & (self.columns - 1);
        let row = row as u32 & (self.rows - 1);
        row * self.columns + column
    }

    /// The buckets of a cell and of the eight cells about it.
    #[inline]
    pub(super) fn around(&self, bucket: u32) -> [u32; 9] {
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

    /// Whether so many columns and rows further on are other buckets.
    pub(super) fn are_apart(&self, [columns, rows]: [i64; 2]) -> bool {
        columns < self.columns.into() && rows < self.rows.into()
    }

    /// The buckets of the cells in a row, from one column to another: from the first
    /// to the last, twice for those that are not in one piece.
    pub(super) fn buckets_in_row(
        &self,
        row: i64,
        [from, to]: [i64; 2],
    ) -> impl Iterator<Item = (u32, u32)> + use<> {
        let [first, last] = [from, to].map(|column| self.bucket([column, row]));
        let [start, end] = [0, -1].map(|column| self.bucket([column, row]));
        let pieces = match first <= last {
            true => [Some((first, last)), None],
            false => [Some((first, end)), Some((start, last))],
        };
        pieces.into_iter().flatten()
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
