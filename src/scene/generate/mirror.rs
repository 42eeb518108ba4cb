//! A gas and its mirror image.

use super::gas;
use crate::scalar::Number;
use crate::scene::{Disc, Scene, SceneError};

/// A [`gas`](super::gas()) of `count` discs and its image in the y axis, in one
/// box of twice the width: each disc meets its own image on the axis, and
/// whatever else happens, happens twice at the same time.
///
/// The image of `d<i>` is `d<count + i>`.
pub fn mirror(seed: u64, count: u32, packing: f64) -> Result<Scene, SceneError> {
    let gas = gas(seed, count, packing)?;
    let images = gas
        .discs()
        .iter()
        .map(image)
        .collect::<Result<Vec<_>, _>>()?;
    let [side, height] = &gas.walls()[2].from;
    Scene::builder("mirror")
        .notes(format!(
            "A gas of {count} discs that cover {packing} of the box, and its mirror image. \
             Seed {seed}."
        ))
        .discs(gas.discs().iter().cloned())
        .discs(images)
        .walls_around((opposite(side)?, 0), [side, height])
        .frame("1/60", 600)
        .build()
}

fn image(disc: &Disc) -> Result<Disc, SceneError> {
    let flipped = |[x, y]: &[Number; 2]| Ok::<_, SceneError>([opposite(x)?, y.clone()]);
    Ok(Disc {
        position: flipped(&disc.position)?,
        velocity: flipped(&disc.velocity)?,
        ..disc.clone()
    })
}

/// Minus a number of a gas, which is a binary64.
fn opposite(number: &Number) -> Result<Number, SceneError> {
    Number::try_from(-number.to_f64()).map_err(|error| SceneError::format("packing", error))
}
