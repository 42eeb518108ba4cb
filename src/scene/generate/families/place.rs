//! A scene drawn along the axes, somewhere in the plane.
//!
//! It is turned and grows at once: by the vector (a, b) of a Pythagorean triple, times
//! are as they were, and lengths c = √(a² + b²) as long. So what is a whole number or a
//! short binary fraction stays one, which a turn by (a/c, b/c) would not keep.

use num_rational::BigRational;

use super::parts::{Written, whole};
use crate::scalar::Number;
use crate::scene::generate::random::Random;
use crate::scene::{Disc, IntoNumber, Scene, SceneBuilder, SceneError, Wall};

type Vector = [BigRational; 2];

/// Legs and hypotenuse.
const TRIPLES: [[i64; 3]; 6] = [
    [1, 0, 1],
    [0, 1, 1],
    [3, 4, 5],
    [4, -3, 5],
    [5, -12, 13],
    [-15, 8, 17],
];

/// What is done to a scene.
struct Place {
    turn: Vector,
    growth: BigRational,
    shift: Vector,
    /// A velocity that all have besides their own, where no wall is at rest.
    drift: Vector,
}

/// The scene, turned and shifted by chance, and in motion if there are no walls.
pub(super) fn placed(scene: SceneBuilder, random: &mut Random) -> Result<SceneBuilder, SceneError> {
    let mut scene = scene.build()?;
    let [a, b, c] = random.one_of(&TRIPLES);
    let is_free = scene.walls.is_empty() && random.coin();
    let mut vector = |bound: i64| [0, 1].map(|_| whole(random.whole(-bound, bound)));
    let place = Place {
        turn: [a, b].map(whole),
        growth: whole(c),
        shift: vector(9),
        drift: vector(if is_free { 3 } else { 0 }),
    };
    place.put(&mut scene)?;
    Ok(SceneBuilder::from(scene))
}

impl Place {
    fn put(&self, scene: &mut Scene) -> Result<(), SceneError> {
        for disc in &mut scene.discs {
            *disc = self.disc(disc)?;
        }
        for Wall { from, to } in &mut scene.walls {
            *from = self.vector(from, &self.shift)?;
            *to = self.vector(to, &self.shift)?;
        }
        Ok(())
    }

    fn disc(&self, disc: &Disc) -> Result<Disc, SceneError> {
        Ok(Disc {
            position: self.vector(&disc.position, &self.shift)?,
            velocity: self.vector(&disc.velocity, &self.drift)?,
            radius: written(disc.radius.to_rational() * &self.growth)?,
            mass: disc.mass.clone(),
        })
    }

    fn vector(&self, vector: &[Number; 2], more: &Vector) -> Result<[Number; 2], SceneError> {
        let [x, y] = vector.each_ref().map(Number::to_rational);
        let [a, b] = &self.turn;
        let turned = [a * &x - b * &y, b * &x + a * &y];
        let [x, y] = turned;
        Ok([written(x + &more[0])?, written(y + &more[1])?])
    }
}

fn written(value: BigRational) -> Result<Number, SceneError> {
    let number = Written(value).into_number();
    number.map_err(|error| SceneError::format("place", error))
}
