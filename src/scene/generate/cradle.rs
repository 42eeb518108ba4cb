//! Newton's cradle, laid flat.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::exact;
use crate::scalar::Number;
use crate::scene::input::shown;
use crate::scene::{Disc, DiscBuilder, Scene, SceneError};

/// The distance that the moving discs have to go before the first impact.
const APPROACH: i32 = 8;

/// Newton's cradle: `count` equal discs of radius 1 in a row, of which the
/// first `moving` come in together with speed 1 and as many leave at the
/// other end. Neighbours are `gap` apart; with a gap of 0 they touch.
///
/// Equal discs on a line exchange their velocities, so that motion passes
/// through the row at speed 1 but for the diameters, which it skips: the last
/// impact is at 8 + (`count` - 2) `gap`, the end at twice 8 + `count` `gap`.
pub fn cradle(count: u32, moving: u32, gap: &Number) -> Result<Scene, SceneError> {
    check(count, moving, gap)?;
    let gap = gap.to_rational();
    let discs = (0..count)
        .map(|index| disc(index, moving, &gap))
        .collect::<Result<Vec<_>, _>>()?;
    let duration = whole(2) * (whole(APPROACH) + &gap * whole(count));
    Scene::builder(format!("cradle-{moving}in{count}"))
        .notes(format!(
            "Newton's cradle: {moving} of {count} discs come in, as many leave. \
             Neighbours are {gap} apart."
        ))
        .discs(discs)
        .frame(exact("gap", duration)?, 1)
        .build()
}

/// The first disc that is struck is at the origin.
fn disc(index: u32, moving: u32, gap: &BigRational) -> Result<DiscBuilder, SceneError> {
    let place = whole(i64::from(index) - i64::from(moving)) * (whole(2) + gap);
    if index >= moving {
        return Ok(Disc::at((exact("gap", place)?, 0), 1));
    }
    // The gap before the struck disc is that of the approach instead.
    let place = place + gap - whole(APPROACH);
    Ok(Disc::at((exact("gap", place)?, 0), 1).velocity([1, 0]))
}

fn check(count: u32, moving: u32, gap: &Number) -> Result<(), SceneError> {
    if moving == 0 || moving >= count {
        let expected = format!("from 1 to less than count, which is {count}");
        return Err(SceneError::physical("moving", expected, moving));
    }
    if gap.sign().is_lt() {
        return Err(SceneError::physical(
            "gap",
            "a number not below 0",
            shown(gap),
        ));
    }
    Ok(())
}

fn whole(number: impl Into<BigInt>) -> BigRational {
    BigRational::from_integer(number.into())
}
