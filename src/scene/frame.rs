//! The frames that a scene is simulated in.

use num_rational::BigRational;

use super::input::bare;
use crate::scalar::Number;

/// Frames of equal duration. The frame algorithms step by them, the timeline
/// is sampled at them.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "json",
    derive(serde::Serialize, serde::Deserialize),
    serde(default, deny_unknown_fields)
)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct Frame {
    /// How long a frame lasts, a positive number; 1 if absent.
    pub duration: Number,
    /// How many frames there are, at least 1; 1 if absent.
    #[cfg_attr(feature = "cli", schemars(range(min = 1)))]
    pub count: u64,
}

impl Frame {
    /// The time that all frames last together.
    pub fn total(&self) -> BigRational {
        self.duration.to_rational() * BigRational::from_integer(self.count.into())
    }
}

impl Default for Frame {
    /// One frame of duration 1.
    fn default() -> Self {
        Self {
            duration: bare(1),
            count: 1,
        }
    }
}
