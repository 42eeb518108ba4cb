//! A ring that closes.

use num_rational::BigRational;

use super::exact;
use crate::scene::{Disc, DiscBuilder, Scene, SceneError};

/// `count` discs of radius 1 on a circle of the radius `count`, that all move
/// to its centre with speed 1: a multiple of 4, with the symmetries of the
/// square.
///
/// No regular polygon but the square has rational corners, so the discs are
/// only nearly evenly spread. With the tangent t of half its angle, a point of
/// the unit circle is ((1 - t²)/(1 + t²), 2t/(1 + t²)): rational, as t is.
/// Those below 45 degrees have t up to √2 - 1; here t runs in even steps up to
/// 12/29, which is a little less. All others are images of these; the four
/// points on the axes belong to the ring if `count` is not a multiple of 8.
pub fn ring(count: u32) -> Result<Scene, SceneError> {
    if count == 0 || !count.is_multiple_of(4) {
        return Err(SceneError::physical(
            "count",
            "a multiple of 4, above 0",
            count,
        ));
    }
    let discs = directions(count)
        .map(|direction| disc(count, direction))
        .collect::<Result<Vec<_>, _>>()?;
    Scene::builder(format!("ring-{count}"))
        .notes(format!(
            "{count} discs on a ring that all move to its centre. It has the symmetries of \
             the square."
        ))
        .discs(discs)
        .frame(1, 2 * u64::from(count))
        .build()
}

/// The points of the unit circle: a quarter of them turned three times.
fn directions(count: u32) -> impl Iterator<Item = [BigRational; 2]> {
    let axis = (!count.is_multiple_of(8)).then(|| [ratio(1, 1), ratio(0, 1)]);
    let octant = (0..count / 8).map(move |index| {
        // Half a step from the axis if no point is on it.
        let halves = if count.is_multiple_of(8) {
            2 * index + 1
        } else {
            2 * index + 2
        };
        at_half_angle(ratio(12, 29) * ratio(4 * i64::from(halves), i64::from(count)))
    });
    let quarter = axis.into_iter().chain(octant.flat_map(|[x, y]| {
        let mirrored = [y.clone(), x.clone()];
        [[x, y], mirrored]
    }));
    quarter.flat_map(|[x, y]| {
        [
            [x.clone(), y.clone()],
            [-&y, x.clone()],
            [-&x, -&y],
            [y, -x],
        ]
    })
}

/// The point whose half angle has this tangent.
fn at_half_angle(tangent: BigRational) -> [BigRational; 2] {
    let square = &tangent * &tangent;
    let below = ratio(1, 1) + &square;
    [
        (ratio(1, 1) - square) / &below,
        ratio(2, 1) * tangent / below,
    ]
}

fn disc(count: u32, direction: [BigRational; 2]) -> Result<DiscBuilder, SceneError> {
    let along = |part: &BigRational| exact("count", part * ratio(count.into(), 1));
    let [x, y] = direction.each_ref().map(along);
    let [back_x, back_y] = direction.map(|part| exact("count", -part));
    Ok(Disc::at([x?, y?], 1).velocity([back_x?, back_y?]))
}

fn ratio(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}
