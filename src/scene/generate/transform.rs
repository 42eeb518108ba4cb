//! The same scene somewhere else.

use num_rational::BigRational;

use super::{exact, unit};
use crate::scalar::Number;
use crate::scene::{Cell, Disc, Scene, SceneBuilder, SceneError, Wall};

/// A scene turned about the origin and then shifted, exactly: a vector (x, y)
/// becomes (c x - s y, s x + c y) for `rotate` = (c, s), a rational point of
/// the unit circle, such as (3/5, 4/5).
///
/// What happens in it is what happened in the first, elsewhere. Its numbers
/// are exact, where a number has changed.
pub fn transformed(
    scene: &Scene,
    rotate: &[Number; 2],
    shift: &[Number; 2],
) -> Result<Scene, SceneError> {
    let motion = Motion {
        rotate: unit("rotate", rotate)?,
        shift: shift.each_ref().map(Number::to_rational),
    };
    let mut moved = scene.clone();
    for disc in &mut moved.discs {
        *disc = motion.disc(disc)?;
    }
    for wall in &mut moved.walls {
        *wall = motion.wall(wall)?;
    }
    moved.periodic = scene.periodic().map(|cell| motion.cell(cell)).transpose()?;
    let gravity = scene.effects().gravity.as_ref();
    moved.effects.gravity = gravity.map(|gravity| motion.vector(gravity)).transpose()?;
    SceneBuilder::from(moved).build()
}

/// A turn about the origin, then a shift.
struct Motion {
    rotate: [BigRational; 2],
    shift: [BigRational; 2],
}

impl Motion {
    fn vector(&self, vector: &[Number; 2]) -> Result<[Number; 2], SceneError> {
        written("rotate", vector, self.turned(vector))
    }

    fn point(&self, point: &[Number; 2]) -> Result<[Number; 2], SceneError> {
        let [x, y] = self.turned(point);
        written("shift", point, [x + &self.shift[0], y + &self.shift[1]])
    }

    fn turned(&self, vector: &[Number; 2]) -> [BigRational; 2] {
        let [x, y] = vector.each_ref().map(Number::to_rational);
        let [cos, sin] = &self.rotate;
        [cos * &x - sin * &y, sin * x + cos * y]
    }

    fn disc(&self, disc: &Disc) -> Result<Disc, SceneError> {
        Ok(Disc {
            position: self.point(&disc.position)?,
            velocity: self.vector(&disc.velocity)?,
            ..disc.clone()
        })
    }

    fn wall(&self, wall: &Wall) -> Result<Wall, SceneError> {
        Ok(Wall {
            from: self.point(&wall.from)?,
            to: self.point(&wall.to)?,
        })
    }

    /// A cell stays a rectangle with level sides only if it is not turned.
    fn cell(&self, cell: &Cell) -> Result<Cell, SceneError> {
        let [cos, sin] = &self.rotate;
        if *cos != BigRational::from_integer(1.into()) {
            let found = format!("{cos},{sin}");
            return Err(SceneError::physical(
                "rotate",
                "1,0 for a periodic scene",
                found,
            ));
        }
        Ok(Cell {
            from: self.point(&cell.from)?,
            to: self.point(&cell.to)?,
        })
    }
}

/// The new coordinates, those that have not changed as they were written.
fn written(
    place: &str,
    before: &[Number; 2],
    [x, y]: [BigRational; 2],
) -> Result<[Number; 2], SceneError> {
    let coordinate = |before: &Number, after: BigRational| match before.to_rational() == after {
        true => Ok(before.clone()),
        false => exact(place, after),
    };
    Ok([coordinate(&before[0], x)?, coordinate(&before[1], y)?])
}
