//! The paper's algorithms: they handle what collides within one frame.
//!
//! One file holds one algorithm, in the paper's vocabulary. Those with
//! detection *a priori* share the pass over the pairs, of which the collisions
//! that come first for their objects are kept. Nothing here is
//! improved upon. What the algorithms miss, invent and misorder is what carom
//! is there to show.
//!
//! Only the pairs that are tested are of choice: all of them, as in the paper, or
//! the [`Candidates`] of another [`BroadPhase`], which find the same.
//!
//! Times within a frame run from zero to the frame's duration, where the
//! paper's `timepassed` runs from zero to one (D2).

mod bounded;
mod candidates;
mod clock;
mod multiple;
mod overlap;
mod pass;
mod reach;
mod retroactive;
mod single;
mod synchronised;

use crate::kernel::Kernel;
use crate::world::World;
use bounded::Bounded;

pub use crate::broad_phase::BroadPhase;
pub use candidates::Candidates;
pub use multiple::{Passes, multiple};
pub use retroactive::retroactive;
pub use single::single;
pub use synchronised::synchronised;

/// Which frame is simulated, and how long it lasts.
#[derive(Clone, Debug)]
pub struct Frame<S> {
    /// The number of the frame, from zero on.
    pub number: u64,
    /// When it starts.
    pub start: S,
    /// How long it lasts.
    pub duration: S,
}

/// Moves apart what overlaps, as a frame with passes does at its start (P3.5).
pub(crate) fn resolve_overlaps<S: Kernel>(world: &mut World<S>) -> Result<(), S::Doubt> {
    let mut all = Candidates::new(BroadPhase::AllPairs);
    Bounded::new(world, &mut all, &S::from_integer(0)).resolve_overlaps()
}
