//! The paper's single collision algorithm (P3.1).
//!
//! Every pair is tested for a collision within the frame, and each object
//! keeps the one that comes first for it. An object that collides stays at the
//! place of its collision for the rest of the frame, with its new velocity, and
//! so falls behind (P3.7); all others move on to the end of theirs.

use super::Frame;
use super::candidates::Candidates;
use super::clock::Clocks;
use super::pass::Passing;
use crate::impact::Impact;
use crate::kernel::Kernel;
use crate::world::World;

/// Simulates a frame with at most one collision an object.
///
/// # Errors
///
/// An enclosure does not decide whether or when a pair collides.
pub fn single<S: Kernel>(
    world: &mut World<S>,
    frame: &Frame<S>,
    candidates: &mut Candidates,
) -> Result<Vec<Impact<S>>, S::Doubt> {
    let mut passing = Passing::new(world, frame, Clocks::Local, candidates);
    passing.resolve_overlaps()?;
    let impacts = passing.pass()?;
    passing.move_on();
    Ok(impacts)
}
