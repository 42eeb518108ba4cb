//! Which pairs overlap, and how deep: decided exactly, by however little it is.

use crate::body::Disc;
use crate::detect::Separation;
use crate::scalar::{Exact, Scalar, Undecided};
use crate::timeline::count_overlaps;
use crate::world::{Obstacle, World};

/// The pairs that overlap.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Overlaps {
    pub(super) count: u64,
    /// How deep the deepest is, to binary64; not measured in a plane that repeats.
    pub(super) depth: f64,
}

/// Finds the pairs of a world that overlap.
///
/// # Errors
///
/// An enclosure does not decide it.
pub(super) fn overlaps(world: &World<Exact>) -> Result<Overlaps, Undecided> {
    if let Some(period) = &world.period {
        let count = count_overlaps(world, period)?;
        return Ok(Overlaps { count, depth: 0.0 });
    }
    let mut found = Overlaps::default();
    for (disc, obstacle) in world.close_pairs() {
        if world.is_barred(disc, obstacle) {
            continue;
        }
        if let Some((_, overlap)) = world.overlap(disc, obstacle)? {
            found.count += 1;
            let depth = overlap.separation.as_ref().map(depth);
            let depth = depth.unwrap_or_else(|| reach(&world.discs, disc, obstacle));
            found.depth = found.depth.max(depth);
        }
    }
    Ok(found)
}

fn depth(separation: &Separation<Exact>) -> f64 {
    let length = separation.direction.norm_squared().sqrt();
    (length * &separation.lack).to_f64()
}

/// How deep a disc is in what its centre is on.
fn reach(discs: &[Disc<Exact>], disc: usize, obstacle: Obstacle) -> f64 {
    let own = discs[disc].radius.to_f64();
    match obstacle {
        Obstacle::Disc(other) => own + discs[other].radius.to_f64(),
        Obstacle::Wall(_) => own,
    }
}
