//! Drawing pairs of bodies: a situation, and where in the plane and in which numbers it
//! is.
//!
//! Situations are drawn along the axes with short numbers, at a body that is at rest at
//! the origin, so that what they are about can be exact. Then they are moved.

mod disc;
mod end;
mod place;
mod wall;

use carom::scene::generate::Random;
use carom::scene::{Scene, SceneError};
use num_rational::BigRational;

use super::plane::Vector;
use place::Place;

/// A disc, and what it may meet.
struct Pair {
    disc: Body,
    other: Other,
}

#[derive(Clone)]
struct Body {
    position: Vector,
    velocity: Vector,
    radius: BigRational,
}

enum Other {
    Disc(Body),
    Wall([Vector; 2]),
}

/// What a file of questions is about: what it is that a disc may meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::cli::vectors) enum Kind {
    /// A disc and another one.
    Disc,
    /// A disc and a wall.
    Wall,
    /// A disc and the end of a wall.
    End,
}

/// A situation: its name, how many of it are drawn, and how.
struct Situation {
    name: &'static str,
    count: u64,
    draw: fn(&mut Random) -> Pair,
}

impl Kind {
    pub(in crate::cli::vectors) const ALL: [Self; 3] = [Self::Disc, Self::Wall, Self::End];

    pub(in crate::cli::vectors) fn name(self) -> &'static str {
        match self {
            Self::Disc => "disc-disc",
            Self::Wall => "disc-wall",
            Self::End => "disc-end",
        }
    }

    fn situations(self) -> &'static [Situation] {
        match self {
            Self::Disc => &disc::SITUATIONS,
            Self::Wall => &wall::SITUATIONS,
            Self::End => &end::SITUATIONS,
        }
    }

    /// All questions of this kind, each as a scene of its own.
    pub(in crate::cli::vectors) fn scenes(self) -> impl Iterator<Item = Result<Scene, SceneError>> {
        let situations = self.situations().iter();
        situations.flat_map(move |situation| {
            (0..situation.count).map(move |index| self.scene(situation, index))
        })
    }

    fn scene(self, situation: &Situation, index: u64) -> Result<Scene, SceneError> {
        let name = format!("{}-{}", self.name(), situation.name);
        let mut random = Random::keyed(key(&name, index));
        let pair = (situation.draw)(&mut random);
        Place::drawn(&mut random).put(pair, &format!("{name}-{index}"))
    }
}

/// A number, and as much of a name as there is room for.
fn key(name: &str, index: u64) -> [u8; 32] {
    let mut key = [0; 32];
    let bytes = index.to_le_bytes().into_iter().chain(name.bytes());
    key.iter_mut().zip(bytes).for_each(|(to, from)| *to = from);
    key
}

fn ratio(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

fn whole(number: i64) -> BigRational {
    ratio(number, 1)
}

fn at(x: i64, y: i64) -> Vector {
    [whole(x), whole(y)]
}

/// As much as rounding may do to a number of this size, or nothing.
fn rounding(random: &mut Random) -> BigRational {
    random.tiny(44, 52)
}

/// Between two whole numbers, in steps of a 16th or, for half of all, of 2^-40.
fn between(random: &mut Random, low: i64, high: i64) -> BigRational {
    let steps = random.one_of(&[1_i64 << 4, 1 << 40]);
    ratio(random.whole(low * steps, high * steps), steps)
}

/// From an eighth to three and an eighth.
fn radius(random: &mut Random) -> BigRational {
    between(random, 0, 3) + ratio(1, 8)
}

/// A number near another one that is short enough for a binary64.
fn trimmed(number: BigRational) -> BigRational {
    let unit = whole(1 << 20);
    (number * &unit).trunc() / unit
}

impl Pair {
    /// A disc and a wall from the origin to a point, from either of its ends.
    fn with_wall(random: &mut Random, to: Vector, disc: Body) -> Self {
        let mut ends = [at(0, 0), to];
        if !random.coin() {
            ends.reverse();
        }
        Self {
            disc,
            other: Other::Wall(ends),
        }
    }
}

impl Body {
    fn moving(position: Vector, velocity: Vector, radius: BigRational) -> Self {
        Self {
            position,
            velocity,
            radius,
        }
    }

    fn resting(radius: BigRational) -> Self {
        Self::moving(at(0, 0), at(0, 0), radius)
    }
}
