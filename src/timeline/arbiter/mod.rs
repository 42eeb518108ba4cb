//! Decisions that enclosures leave open, made by proof.
//!
//! Enclosures tell what differs. That two impacts are simultaneous, that bodies
//! touch, or pass in tangency, they cannot prove at any precision. Where it
//! seems so, an [`Arbiter`] is asked. The one of [`Exact`] numbers tries, in
//! this order,
//!
//! 1. the **symmetries** of the scene: what one of them maps onto each other
//!    happens at the same time, at any depth;
//! 2. **algebra**: the causal cone of the question is computed again in
//!    [`Expression`](crate::algebra::Expression)s, by the same code, and they decide.
//!
//! What neither settles stays in doubt. Binary64 decides everything itself, filtered or not.

mod algebra;
mod history;
mod images;
mod replay;

use std::cmp::Ordering;
use std::fmt::Debug;

use super::flight::Flights;
use super::meeting::Meeting;
use crate::body::Feature;
use crate::effects::{Falling, Medium};
use crate::kernel::Kernel;
use crate::scalar::{Exact, Filtered, Scalar};
use crate::symmetry::Symmetry;
use crate::world::{Obstacle, World};
pub(super) use algebra::Algebra;

/// Numbers that a timeline can be computed with.
pub trait Timed: Kernel {
    /// Who decides what the numbers themselves do not.
    type Arbiter: Arbiter<Self>;
}

impl Timed for f64 {
    type Arbiter = Nobody;
}

impl Timed for Filtered {
    type Arbiter = Nobody;
}

impl Timed for Exact {
    type Arbiter = Algebra;
}

impl Timed for Falling<Filtered> {
    type Arbiter = Nobody;
}

impl<S: Scalar, M: Medium<S>> Timed for Falling<S, M> {
    type Arbiter = Nobody;
}

/// A meeting that has been forecast.
#[derive(Clone, Copy, Debug)]
pub struct Foreseen {
    /// The disc, of two discs the one with the lower index.
    pub(super) disc: usize,
    /// What it meets.
    pub(super) feature: Feature,
    /// The name of the time, if they touch already.
    pub(super) moment: Option<u64>,
}

impl Foreseen {
    pub(super) fn new(disc: usize, feature: Feature, moment: Option<u64>) -> Self {
        let (disc, feature) = match feature {
            Feature::Disc(other) if (other as usize) < disc => {
                (other as usize, Feature::Disc(disc as u32))
            }
            _ => (disc, feature),
        };
        Self {
            disc,
            feature,
            moment,
        }
    }

    /// What a disc meets.
    pub(super) fn meeting<S: Kernel>(disc: usize, meeting: &Meeting<S>) -> Self {
        Self::new(disc, meeting.feature, meeting.moment)
    }
}

/// Who is asked when a decision is in doubt: it decides, or hands back the
/// doubt.
pub trait Arbiter<S: Kernel>: Clone + Debug + Send + Sync {
    /// The arbiter of a world at its start, and of the symmetries that it has.
    fn new(world: &World<S>, symmetries: &[Symmetry]) -> Self;

    /// Takes note of an impact that is about to change these discs.
    fn note(&mut self, met: &Foreseen, changed: [Option<usize>; 2], moment: u64);

    /// Takes note of impacts that are about to be resolved at once, at the time
    /// of one of them, and of the discs that this changes.
    fn note_cluster(
        &mut self,
        trigger: &Foreseen,
        contacts: &[(usize, Feature)],
        changed: &[usize],
        moment: u64,
    );

    /// Whether a disc and an obstacle are apart, touch or overlap at the time
    /// of a meeting, and the feature that is nearest.
    fn gap(
        &mut self,
        flights: &Flights<S>,
        met: &Foreseen,
        disc: usize,
        obstacle: Obstacle,
        doubt: S::Doubt,
    ) -> Result<(Ordering, Feature), S::Doubt>;

    /// Which of two meetings comes first.
    fn order(
        &mut self,
        flights: &Flights<S>,
        one: &Foreseen,
        other: &Foreseen,
        doubt: S::Doubt,
    ) -> Result<Ordering, S::Doubt>;

    /// Which comes first, a meeting or a time that is known exactly.
    fn order_to(
        &mut self,
        flights: &Flights<S>,
        one: &Foreseen,
        time: &S,
        doubt: S::Doubt,
    ) -> Result<Ordering, S::Doubt>;

    /// When and where a disc meets an obstacle.
    fn meet(
        &mut self,
        flights: &Flights<S>,
        disc: usize,
        obstacle: Obstacle,
        doubt: S::Doubt,
    ) -> Result<Option<Meeting<S>>, S::Doubt>;

    /// Whether a disc moves towards a feature that it touches.
    fn approaches(
        &mut self,
        flights: &Flights<S>,
        disc: usize,
        feature: Feature,
        doubt: S::Doubt,
    ) -> Result<bool, S::Doubt>;
}

/// The arbiter where there is nothing to decide.
#[derive(Clone, Debug)]
pub struct Nobody;

impl<S: Kernel> Arbiter<S> for Nobody {
    fn new(_: &World<S>, _: &[Symmetry]) -> Self {
        Self
    }

    fn note(&mut self, _: &Foreseen, _: [Option<usize>; 2], _: u64) {}

    fn note_cluster(&mut self, _: &Foreseen, _: &[(usize, Feature)], _: &[usize], _: u64) {}

    fn gap(
        &mut self,
        _: &Flights<S>,
        _: &Foreseen,
        _: usize,
        _: Obstacle,
        doubt: S::Doubt,
    ) -> Result<(Ordering, Feature), S::Doubt> {
        Err(doubt)
    }

    fn order(
        &mut self,
        _: &Flights<S>,
        _: &Foreseen,
        _: &Foreseen,
        doubt: S::Doubt,
    ) -> Result<Ordering, S::Doubt> {
        Err(doubt)
    }

    fn order_to(
        &mut self,
        _: &Flights<S>,
        _: &Foreseen,
        _: &S,
        doubt: S::Doubt,
    ) -> Result<Ordering, S::Doubt> {
        Err(doubt)
    }

    fn meet(
        &mut self,
        _: &Flights<S>,
        _: usize,
        _: Obstacle,
        doubt: S::Doubt,
    ) -> Result<Option<Meeting<S>>, S::Doubt> {
        Err(doubt)
    }

    fn approaches(
        &mut self,
        _: &Flights<S>,
        _: usize,
        _: Feature,
        doubt: S::Doubt,
    ) -> Result<bool, S::Doubt> {
        Err(doubt)
    }
}
