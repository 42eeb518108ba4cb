//! Times in closed form, as they are written.

use carom::first_impact::Quadratic;
use carom::log::{Bounds, MIN_DIGITS};
use schemars::JsonSchema;
use serde::Serialize;

/// A time in closed form, and its bounds.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Time {
    exact: Form,
    #[serde(flatten)]
    bounds: Bounds,
}

/// The time p + q √d, of fractions; q and d are 0 if it is rational.
#[derive(Debug, Serialize, JsonSchema)]
struct Form {
    p: String,
    q: String,
    d: String,
}

impl From<&Quadratic> for Time {
    fn from(time: &Quadratic) -> Self {
        Self {
            bounds: Bounds::of_quadratic(time, MIN_DIGITS),
            exact: Form {
                p: time.p.to_string(),
                q: time.q.to_string(),
                d: time.d.to_string(),
            },
        }
    }
}
