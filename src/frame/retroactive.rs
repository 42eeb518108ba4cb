//! The paper's detection after a collision (P2.1): step, test, resolve.
//!
//! All objects move on by a finite step; then pairs that overlap are moved
//! apart and, if they approach, collide where they are. Objects that are
//! nowhere found to overlap pass through each other: the algorithm tunnels.
//! Smaller steps only make that rarer (P2.3).

use super::Frame;
use super::bounded::Bounded;
use super::candidates::Candidates;
use crate::impact::{Impact, Step};
use crate::kernel::Kernel;
use crate::world::World;

/// Simulates a frame in so many steps of equal length.
///
/// # Errors
///
/// An enclosure does not decide whether a pair overlaps or approaches.
pub fn retroactive<S: Kernel>(
    world: &mut World<S>,
    frame: &Frame<S>,
    substeps: u32,
    candidates: &mut Candidates,
) -> Result<Vec<Impact<S>>, S::Doubt> {
    let substeps = substeps.max(1);
    let step = frame.duration.clone() / S::from_integer(substeps as i32);
    let mut impacts = Vec::new();
    for pass in 1..=substeps {
        world.advance(&step);
        let clock = step.clone() * S::from_integer(pass as i32);
        let time = frame.start.clone() + clock;
        let number = Step {
            frame: frame.number,
            pass,
        };
        let bodies = Bounded::new(world, candidates, &S::from_integer(0));
        collide_overlapping(bodies, &time, number, &mut impacts)?;
    }
    Ok(impacts)
}

/// Moves apart whatever overlaps, and lets it collide if it approaches (D15).
fn collide_overlapping<S: Kernel>(
    mut bodies: Bounded<'_, S>,
    time: &S,
    step: Step,
    impacts: &mut Vec<Impact<S>>,
) -> Result<(), S::Doubt> {
    bodies.separate_all(|world, disc, feature| {
        if !world.approaches_here(disc, feature)? {
            world.remember(disc, feature);
            return Ok(());
        }
        let contact = world.collide_here(disc, feature)?;
        let names = world.names(disc, feature);
        impacts.push(Impact {
            step: Some(step),
            ..Impact::new(time.clone(), names, contact)
        });
        Ok(())
    })
}
