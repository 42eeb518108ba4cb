//! The multiple collision algorithm with the clocks of a pair brought
//! together before it is tested.
//!
//! This is not in the paper: it is the cure that the paper's own diagnosis
//! suggests (P6.1), so that a comparison shows what it alone buys. Of the two
//! objects, the one whose clock is behind is first moved on along its present
//! path. A collision then has one time, and comes first by that.

use super::Frame;
use super::candidates::Candidates;
use super::clock::Clocks;
use super::multiple::{Passes, run_passes};
use crate::impact::Impact;
use crate::kernel::Kernel;
use crate::world::World;

/// Simulates a frame in several passes on synchronised clocks.
///
/// # Errors
///
/// An enclosure does not decide whether or when a pair collides.
pub fn synchronised<S: Kernel>(
    world: &mut World<S>,
    frame: &Frame<S>,
    passes: Passes,
    candidates: &mut Candidates,
) -> Result<Vec<Impact<S>>, S::Doubt> {
    run_passes(world, frame, passes, Clocks::Synchronised, candidates)
}
