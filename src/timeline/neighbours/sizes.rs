//! Which discs of a world are of about one size, and how large cells for these are.

use std::collections::HashMap;

use super::grid::SIZE;
use crate::body::Disc;
use crate::kernel::Kernel;

/// Discs that are smaller by this may get smaller cells.
const RATIO: f64 = 4.0;

/// So many discs in the cell of a disc, on the average of all discs, are worth smaller
/// cells.
const CROWD: usize = 3;

/// A cell is at most so many times as large as discs that fill the plane need: if they get
/// together later on, they must not be too many in one.
const MOST: f64 = 16.0;

/// So many bodies, on the average, are in a cell of those that have room: with fewer, discs
/// leave it more often, and with more there are too many to look at.
const SHARE: f64 = 1.2;

/// Where a disc is, and how large.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub(super) place: [f64; 2],
    radius: f64,
}

impl Spot {
    pub(super) fn of<S: Kernel>(disc: &Disc<S>) -> Self {
        Self {
            place: [disc.position.x.to_f64(), disc.position.y.to_f64()],
            radius: disc.radius.hull().hi(),
        }
    }

    /// The cell of some size that it is in.
    fn cell(&self, size: f64) -> [u64; 2] {
        self.place.map(|place| (place / size).floor().to_bits())
    }
}

/// The largest radius on each level of a grid, from large to small. There is one
/// level, unless much smaller discs would crowd its cells.
pub(super) fn largest_of_levels(spots: &mut [Spot]) -> Vec<f64> {
    spots.sort_unstable_by(|one, other| other.radius.total_cmp(&one.radius));
    let (mut levels, mut rest) = (Vec::new(), &*spots);
    while let [Spot { radius, .. }, ..] = rest {
        levels.push(*radius);
        let similar = rest.partition_point(|spot| spot.radius > radius / RATIO);
        if similar == rest.len() || !are_crowded(rest, SIZE * radius) {
            break;
        }
        rest = &rest[similar..];
    }
    levels
}

/// The size of cells for the discs of a level, the largest of which has that radius, in
/// an area with so many walls: where there is room, a cell has about one body, so that
/// discs seldom leave it.
pub(super) fn size_of_cells(
    spots: &[Spot],
    largest: f64,
    [width, height]: [f64; 2],
    walls: usize,
) -> f64 {
    let least = SIZE * largest;
    let bodies = spots.len() + walls;
    let size = (width * height * SHARE / bodies as f64).sqrt();
    let mut size = size.min(MOST * least);
    while size > least && are_crowded(spots, size) {
        size /= 2.0;
    }
    size.max(least)
}

fn are_crowded(spots: &[Spot], size: f64) -> bool {
    let mut cells = HashMap::<[u64; 2], usize>::new();
    for spot in spots {
        *cells.entry(spot.cell(size)).or_default() += 1;
    }
    let in_cells: usize = cells.values().map(|count| count * count).sum();
    in_cells > CROWD * spots.len()
}
