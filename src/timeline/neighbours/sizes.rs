//! Which discs of a world are of about one size.

use std::collections::HashSet;

use super::grid::SIZE;
use crate::body::Disc;
use crate::kernel::Kernel;

/// Discs that are smaller by this may get smaller cells.
const RATIO: f64 = 4.0;

/// So many discs in a cell, on the average of those that are not empty, are worth
/// smaller cells.
const CROWD: usize = 2;

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
    if size > least && size.is_finite() && !are_crowded(spots, size) {
        size
    } else {
        least
    }
}

fn are_crowded(spots: &[Spot], size: f64) -> bool {
    let cells: HashSet<[u64; 2]> = spots.iter().map(|spot| spot.cell(size)).collect();
    spots.len() > CROWD * cells.len()
}
