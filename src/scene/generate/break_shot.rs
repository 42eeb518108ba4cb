//! The break of a billiard game.

use num_rational::BigRational;

use super::exact;
use crate::scalar::Number;
use crate::scene::input::shown;
use crate::scene::{Disc, DiscBuilder, Scene, SceneError};

/// The most rows of a rack.
pub const MAX_ROWS: u32 = 1000;

/// How the discs of a rack stand.
#[derive(Clone, Debug, PartialEq)]
pub enum Rack {
    /// Neighbours in a row are so far apart, and neighbours of different rows
    /// a little farther.
    Gap(Number),
    /// Neighbours of different rows touch, at the angle of the triangle
    /// 3-4-5; those in a row are 2/5 apart.
    Touching,
}

/// A cue disc that comes in with speed 1 and strikes the tip of a triangle of
/// `rows` rows, at the time 6. All discs have radius 1, and the whole is its
/// own image in the x axis.
///
/// Row i, at x = i h, has its discs at y = (2k - i) w, for k from 0 to i, so
/// that neighbours are 2w apart in a row, and √(h² + w²) in different ones. A
/// rack of equilateral triangles with its h = √3 w would not be rational:
/// - with a gap g, w = 1 + g/2 and h = 7/4 w, which is a bit more: with g = 0,
///   discs touch in their rows and are √65/4 - 2 ≈ 0.0156 apart across them;
/// - touching, w = 6/5 and h = 8/5, so that √(h² + w²) = 2.
///
/// The discs are named row by row after the cue, `d0`.
pub fn break_shot(rows: u32, rack: &Rack) -> Result<Scene, SceneError> {
    check(rows, rack)?;
    let steps = steps(rack);
    let triangle = (0..rows)
        .flat_map(|row| (0..=row).map(move |place| (row, place)))
        .map(|(row, place)| disc(row, place, &steps))
        .collect::<Result<Vec<_>, _>>()?;
    Scene::builder(format!("break-{}", triangle.len()))
        .notes(notes(rows, rack))
        .disc(Disc::at([-8, 0], 1).velocity([1, 0]))
        .discs(triangle)
        .frame(1, 12 + 4 * u64::from(rows))
        .build()
}

/// From row to row, and half of that from neighbour to neighbour in a row.
fn steps(rack: &Rack) -> [BigRational; 2] {
    match rack {
        Rack::Gap(gap) => {
            let half = ratio(1, 1) + gap.to_rational() / ratio(2, 1);
            [ratio(7, 4) * &half, half]
        }
        Rack::Touching => [ratio(8, 5), ratio(6, 5)],
    }
}

fn disc(row: u32, place: u32, [step, half]: &[BigRational; 2]) -> Result<DiscBuilder, SceneError> {
    let [row, place] = [row, place].map(i64::from);
    let x = exact("gap", step * ratio(row, 1))?;
    let y = exact("gap", half * ratio(2 * place - row, 1))?;
    Ok(Disc::at([x, y], 1))
}

fn check(rows: u32, rack: &Rack) -> Result<(), SceneError> {
    if !(1..=MAX_ROWS).contains(&rows) {
        let expected = format!("from 1 to {MAX_ROWS}");
        return Err(SceneError::physical("rows", expected, rows));
    }
    match rack {
        Rack::Gap(gap) if gap.sign().is_lt() => Err(SceneError::physical(
            "gap",
            "a number not below 0",
            shown(gap),
        )),
        _ => Ok(()),
    }
}

fn notes(rows: u32, rack: &Rack) -> String {
    let neighbours = match rack {
        Rack::Gap(gap) => format!("Neighbours in a row are {} apart.", gap.to_rational()),
        Rack::Touching => String::from("Neighbours of different rows touch."),
    };
    format!("A cue disc into a triangle of {rows} rows, its own mirror image. {neighbours}")
}

fn ratio(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}
