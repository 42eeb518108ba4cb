//! When two bodies meet, moving freely from where they are now.
//!
//! The paper's three cases are one here (P2.4, P3.2): of two bodies that both
//! move, one is taken as the frame of reference, so that only *relative*
//! position and velocity count; and bodies that overlap already meet now, if they
//! approach, or not at all.
//!
//! They meet if they touch and approach, not if one of the two (D16). No
//! tolerance is involved. What is exact and what rounds is up to the
//! [`Scalar`].

mod circle;
mod clear;
mod gap;
mod overlap;
mod segment;

use crate::scalar::Scalar;

pub use circle::meet_circle;
pub(crate) use clear::{Passage, least_room};
pub use gap::{gap_circle, gap_segment};
pub use overlap::{Overlap, Separation, overlap_circle, overlap_segment};
pub(crate) use segment::Nearest;
pub use segment::{End, Segment, meet_segment};

/// The first time that two bodies touch while they move freely.
#[derive(Clone, Debug)]
pub struct Encounter<S> {
    /// The time until they touch, never negative.
    pub delay: S,
    /// Whether they only pass in tangency, so that nothing changes.
    pub graze: bool,
    /// Whether they overlap now, or touch, so that the delay is none.
    pub overlap: bool,
    /// Whether they overlap now, and do not only touch.
    pub inside: bool,
    /// Whether they touch and neither approach nor part, but are pressed together.
    pub rest: bool,
    /// The wall's end point that is touched, unless its interior is.
    pub end: Option<End>,
}

impl<S: Scalar> Encounter<S> {
    /// The bodies touch and approach already.
    pub(crate) fn now() -> Self {
        Self {
            overlap: true,
            ..Self::impact(S::from_integer(0))
        }
    }

    /// The bodies touch, and are pressed together.
    pub(crate) fn rest() -> Self {
        Self {
            rest: true,
            ..Self::now()
        }
    }

    /// The bodies overlap and approach already.
    pub(crate) fn inside() -> Self {
        Self {
            inside: true,
            ..Self::now()
        }
    }

    pub(crate) fn impact(delay: S) -> Self {
        Self {
            delay,
            graze: false,
            overlap: false,
            inside: false,
            rest: false,
            end: None,
        }
    }

    pub(crate) fn graze(delay: S) -> Self {
        Self {
            graze: true,
            ..Self::impact(delay)
        }
    }

    pub(crate) fn at(self, end: End) -> Self {
        Self {
            end: Some(end),
            ..self
        }
    }
}
