//! The paper's multiple collision algorithm (P4.1 to P4.7).
//!
//! Passes of the single collision algorithm continue from each other: an
//! object that has collided goes on from there with what is left of its frame,
//! `1 - timepassed`, and only pairs with a `modified` object are tested again.
//! After the last pass, whoever did not collide in it moves on.
//!
//! Each object is tested on its own clock, even against one whose clock shows
//! another time: "the physical resultant vectors match up while the times do
//! not". This is what makes collisions that should not exist.

use std::time::{Duration, Instant};

use super::Frame;
use super::candidates::Candidates;
use super::clock::Clocks;
use super::pass::Passing;
use crate::impact::Impact;
use crate::kernel::Kernel;
use crate::world::World;

/// When the multiple collision algorithm stops looking for more collisions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passes {
    /// After so many passes.
    Count(u32),
    /// After the pass in which this time is used up, so that accuracy is
    /// forsaken for speed.
    Budget(Duration),
}

impl Passes {
    /// Whether another pass follows those done since `start`.
    fn allow_another(self, done: u32, start: Instant) -> bool {
        match self {
            Self::Count(count) => done < count,
            Self::Budget(budget) => start.elapsed() < budget,
        }
    }
}

/// Simulates a frame in several passes on local clocks.
///
/// # Errors
///
/// An enclosure does not decide whether or when a pair collides.
pub fn multiple<S: Kernel>(
    world: &mut World<S>,
    frame: &Frame<S>,
    passes: Passes,
    candidates: &mut Candidates,
) -> Result<Vec<Impact<S>>, S::Doubt> {
    run_passes(world, frame, passes, Clocks::Local, candidates)
}

/// Passes until no more are allowed, or until one finds nothing: then another
/// would find nothing either (D10).
pub(super) fn run_passes<S: Kernel>(
    world: &mut World<S>,
    frame: &Frame<S>,
    passes: Passes,
    clocks: Clocks,
    candidates: &mut Candidates,
) -> Result<Vec<Impact<S>>, S::Doubt> {
    let start = Instant::now();
    let mut passing = Passing::new(world, frame, clocks, candidates);
    passing.resolve_overlaps()?;
    let mut impacts = passing.pass()?;
    let (mut done, mut found) = (1, impacts.len());
    while found > 0 && passes.allow_another(done, start) {
        let more = passing.pass()?;
        (done, found) = (done + 1, more.len());
        impacts.extend(more);
    }
    passing.move_on();
    Ok(impacts)
}
