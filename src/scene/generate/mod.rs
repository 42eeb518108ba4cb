//! Scenes that are made rather than written.
//!
//! What is random is drawn from a seed: the same seed gives the same scene on
//! every platform and with every version. Random numbers are binary64, all
//! others exact.

mod break_shot;
mod corner;
mod cradle;
mod families;
mod galperin;
mod gas;
mod mirror;
mod random;
mod ring;
mod table1;
mod transform;

use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use super::SceneError;
use super::input::{bare, shown};
use crate::scalar::Number;

pub use break_shot::{MAX_ROWS, Rack, break_shot};
pub use corner::corner;
pub use cradle::cradle;
pub use families::{Family, scene_of};
pub use galperin::{MAX_POWER, galperin};
pub use gas::{gas, periodic_gas};
pub use mirror::mirror;
pub use random::Random;
pub use ring::ring;
pub use table1::table1;
pub use transform::transformed;

/// A computed parameter, exactly, unless it is of absurd size.
fn exact(place: &str, value: BigRational) -> Result<Number, SceneError> {
    match value.to_integer().to_i32() {
        Some(integer) if value.is_integer() => Ok(bare(integer)),
        _ => Number::try_from(value).map_err(|error| SceneError::format(place, error)),
    }
}

/// A rational point of the unit circle.
fn unit(place: &str, point: &[Number; 2]) -> Result<[BigRational; 2], SceneError> {
    let [x, y] = point.each_ref().map(Number::to_rational);
    if !(&x * &x + &y * &y).is_one() {
        let expected = "a rational point of the unit circle, such as 3/5,4/5";
        let found = point.each_ref().map(shown).join(",");
        return Err(SceneError::physical(place, expected, found));
    }
    Ok([x, y])
}
