//! Scenes that are made rather than written.
//!
//! What is random is drawn from a seed: the same seed gives the same scene on
//! every platform and with every version. Random numbers are binary64, all
//! others exact.

mod cradle;
mod galperin;
mod gas;
mod random;
mod table1;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::SceneError;
use super::input::bare;
use crate::scalar::Number;

pub use cradle::cradle;
pub use galperin::{MAX_POWER, galperin};
pub use gas::gas;
pub use table1::table1;

/// A computed parameter, exactly, unless it is of absurd size.
fn exact(place: &str, value: BigRational) -> Result<Number, SceneError> {
    match value.to_integer().to_i32() {
        Some(integer) if value.is_integer() => Ok(bare(integer)),
        _ => Number::try_from(value).map_err(|error| SceneError::format(place, error)),
    }
}
