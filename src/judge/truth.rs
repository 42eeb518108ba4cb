//! The exact timeline, as what others are held against.

use super::tally::Logged;
use crate::body::Disc;
use crate::conserved::energy;
use crate::effects::course;
use crate::impact::{Impact, number_ties};
use crate::scalar::{Exact, Scalar, Undecided};
use crate::scene::Effects;
use crate::timeline::Setup;
use crate::vec2::Vec2;
use crate::world::World;

/// What truly happens in a frame.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The impacts.
    pub impacts: Vec<Logged>,
    /// Where each disc is at the end, to binary64.
    pub end: Vec<Vec2<f64>>,
    /// The kinetic energy at the end, to binary64.
    pub energy: f64,
}

impl Truth {
    /// What happened in a frame, and how it ended.
    pub(super) fn new(impacts: &[Impact<Exact>], end: &[Disc<Exact>]) -> Self {
        let places = end.iter().map(|disc| disc.position.map(Exact::to_f64));
        Self {
            impacts: impacts.iter().map(Logged::from).collect(),
            end: places.collect(),
            energy: energy(end).to_f64(),
        }
    }
}

/// What truly happens in a world, in the frame that starts at `start`; none if
/// that is infinitely many impacts.
///
/// # Errors
///
/// The precision of the numbers leaves a decision open.
pub fn true_frame(
    world: World<Exact>,
    effects: &Effects,
    bits: u32,
    start: &Exact,
    duration: &Exact,
) -> Result<Option<Truth>, Undecided> {
    let mut timeline = course(world, effects, duration, &Setup::default(), bits)?;
    let mut impacts = Vec::new();
    while let Some(impact) = timeline.next_impact(duration)? {
        let time = start.clone() + &impact.time;
        impacts.push(Impact { time, ..impact });
    }
    if timeline.accumulation().is_some() {
        return Ok(None);
    }
    number_ties(&mut impacts);
    let end = timeline.discs_at(duration);
    Ok(Some(Truth::new(&impacts, &end)))
}
