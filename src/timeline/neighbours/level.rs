//! The cells for discs of about one size.

use super::cells::Cells;
use super::grid::MARGIN;
use super::shape::Shape;
use super::walls::Walls;
use crate::kernel::Kernel;
use crate::world::World;

/// More than what rounds.
const SLACK: f64 = 1.0 + 1e-9;

/// The discs of about one size, by their cells, and the walls near each of these.
#[derive(Clone, Debug)]
pub(super) struct Level {
    pub(super) shape: Shape,
    pub(super) discs: Cells,
    pub(super) walls: Walls,
    /// The radius that no disc exceeds.
    pub(super) largest: f64,
}

/// A box.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Stay {
    low: [f64; 2],
    high: [f64; 2],
}

impl Stay {
    /// All that is no further from a box, of which each coordinate is between two
    /// numbers, than a margin.
    pub(super) fn about([x, y]: [[f64; 2]; 2], margin: f64) -> Self {
        Self {
            low: [x[0] - margin, y[0] - margin],
            high: [x[1] + margin, y[1] + margin],
        }
    }
}

impl Level {
    /// The empty cells of a size for so many discs of a world, of which none is larger
    /// than that.
    pub(super) fn new<S: Kernel>(
        world: &World<S>,
        [largest, size]: [f64; 2],
        extent: [f64; 2],
        discs: usize,
    ) -> Self {
        let shape = Shape::of(size, extent, discs);
        Self {
            discs: Cells::new(shape.buckets()),
            walls: Walls::new(world, &shape, largest + MARGIN * size),
            largest,
            shape,
        }
    }

    /// Fetches a bucket and those about it into the cache.
    #[inline]
    pub(super) fn fetch_around(&self, bucket: u32) {
        let around = self.shape.around(bucket);
        around.iter().for_each(|&bucket| self.discs.fetch(bucket));
        self.walls.fetch(bucket);
    }

    /// Lists the discs in a bucket and in those about it.
    #[inline]
    pub(super) fn list_around(&self, bucket: u32, list: &mut Vec<u32>) {
        self.discs.list(self.shape.around(bucket), list);
    }

    /// Adds to a list the discs of this level that another may touch, which is no
    /// larger than that and the centre of which keeps within a box.
    ///
    /// Their centres keep within R + R' of the box, and within their cells up to the
    /// margin m'; so of each row of cells it takes a part. With d between the box
    /// and the row, less m', it ends √((R + R')² - d²) + m' from the box.
    pub(super) fn search(&self, stay: &Stay, largest: f64, list: &mut Vec<u32>) {
        if self.search_rows(stay, largest, list).is_none() {
            self.discs.list_all(list);
        }
    }

    /// The same, unless that were too many cells.
    fn search_rows(&self, stay: &Stay, largest: f64, list: &mut Vec<u32>) -> Option<()> {
        let (shape, size) = (&self.shape, self.shape.scale.size);
        let margin = MARGIN * size;
        let reach = (largest + self.largest) * SLACK;
        let far = reach + margin;
        let [[left, right], [bottom, top]] =
            [0, 1].map(|axis| [stay.low[axis] - far, stay.high[axis] + far]);
        let [left, right, bottom, top] = [
            shape.cell(left)?,
            shape.cell(right)?,
            shape.cell(bottom)?,
            shape.cell(top)?,
        ];
        if !shape.are_apart([right - left, top - bottom]) {
            return None;
        }
        for row in bottom..=top {
            let (low, high) = (row as f64 * size - margin, (row + 1) as f64 * size + margin);
            let apart = (low - stay.high[1]).max(stay.low[1] - high).max(0.0);
            let wide = (reach * reach - apart * apart).max(0.0).sqrt() * SLACK + margin;
            let [from, to] = [stay.low[0] - wide, stay.high[0] + wide];
            for (first, last) in shape.buckets_in_row(row, [shape.cell(from)?, shape.cell(to)?]) {
                self.discs.list_between(first, last, list);
            }
        }
        Some(())
    }
}
