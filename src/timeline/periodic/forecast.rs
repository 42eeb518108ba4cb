//! What a disc of a periodic plane comes to, and which of two meetings is the first.

use std::cmp::Ordering::{self, Equal, Less};

use super::copies::Couple;
use crate::kernel::{Kernel, Time};
use crate::scalar::Doubt;
use crate::timeline::neighbours::Image;

/// What a disc comes to first.
#[derive(Clone, Debug)]
pub(super) enum Forecast<S: Kernel> {
    Nothing,
    /// Another cell, at this time.
    Leaving(f64),
    Meeting(Meeting<S>),
}

/// A meeting of a disc with a copy of another one.
#[derive(Clone, Debug)]
pub(super) struct Meeting<S: Kernel> {
    pub(super) couple: Couple,
    pub(super) image: Image,
    /// The turn at which the partner had changed last.
    pub(super) partner_turn: u64,
    pub(super) time: S::Time,
    pub(super) graze: bool,
    pub(super) overlap: bool,
    /// The name of the time, if the meeting follows without any delay.
    pub(super) moment: Option<u64>,
}

impl<S: Kernel> Forecast<S> {
    pub(super) fn bounds(&self) -> [f64; 2] {
        match self {
            Self::Nothing => [f64::INFINITY; 2],
            Self::Leaving(time) => [*time; 2],
            Self::Meeting(meeting) => {
                let bounds = meeting.time.bounds();
                [bounds.lo(), bounds.hi()]
            }
        }
    }
}

impl<S: Kernel> Meeting<S> {
    pub(super) fn order(&self, other: &Self) -> Result<Ordering, S::Doubt> {
        if !S::ROUNDS && self.moment.is_some() && self.moment == other.moment {
            return Ok(Equal);
        }
        self.time.order(&other.time)
    }

    /// Whether it is to be resolved before another one, which is none of the same two.
    pub(super) fn precedes(&self, other: &Self) -> Result<bool, S::Doubt> {
        let (one, two) = (self.couple, other.couple);
        let order = self.order(other).map_err(|doubt| {
            doubt.asking(|| format!("whether {} or {} meet first", one.pair(), two.pair()))
        })?;
        Ok(order == Less || order == Equal && one < two)
    }
}
