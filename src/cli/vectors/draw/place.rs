//! Where a situation is, how fast it goes, and in which numbers.

use carom::scalar::{Number, NumberError};
use carom::scene::generate::Random;
use carom::scene::{Disc, DiscBuilder, IntoNumber, Scene, SceneError};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::{Body, Other, Pair, at, ratio, whole};
use crate::cli::vectors::plane::Vector;

/// Legs and hypotenuse.
const TRIPLES: [[i64; 3]; 7] = [
    [1, 0, 1],
    [0, -1, 1],
    [3, 4, 5],
    [-4, 3, 5],
    [5, -12, 13],
    [-15, -8, 17],
    [20, 21, 29],
];

/// In which numbers a pair is written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Writing {
    /// In binary64 where that is exact, else as fractions.
    Exact,
    /// Rounded to binary64.
    Rounded,
}

/// A number, unless it is none.
#[derive(Clone)]
struct Written(Result<Number, NumberError>);

impl IntoNumber for Written {
    fn into_number(self) -> Result<Number, NumberError> {
        self.0
    }
}

/// What is done to a pair: a turn that grows it, all in one, then a scale; a shift; more
/// speed; a velocity that both have.
pub(super) struct Place {
    turn: Vector,
    growth: BigRational,
    speed: BigRational,
    shift: Vector,
    drift: Vector,
    writing: Writing,
}

impl Place {
    pub(super) fn drawn(random: &mut Random) -> Self {
        match random.whole(0, 9) {
            0..=3 => Self::nearby(random),
            4 => Self::far(random),
            5 => Self::fast(random),
            6 => Self::scaled(random),
            7 => Self::fractions(random),
            _ => Self::rounded(random),
        }
    }

    /// Here, along the axes or at a Pythagorean angle, where short numbers stay so.
    fn nearby(random: &mut Random) -> Self {
        let [a, b, c] = random.one_of(&TRIPLES);
        let mut vector = |bound: i64| [0, 1].map(|_| whole(random.whole(-bound, bound)));
        Self {
            turn: [a, b].map(whole),
            growth: whole(c),
            speed: whole(1),
            shift: vector(9),
            drift: vector(3),
            writing: Writing::Exact,
        }
    }

    /// 10^3 to 10^9 away.
    fn far(random: &mut Random) -> Self {
        let mut far = || {
            let size = 10_i64.pow(random.whole(3, 9) as u32);
            whole(random.one_of(&[-1, 1]) * size + random.whole(-99, 99))
        };
        let shift = [far(), far()];
        let writing = random.one_of(&[Writing::Exact, Writing::Rounded]);
        Self {
            shift,
            writing,
            ..Self::nearby(random)
        }
    }

    /// So fast that a frame of 1/60 is long.
    fn fast(random: &mut Random) -> Self {
        Self {
            speed: whole(1 << random.whole(10, 16)),
            drift: at(0, 0),
            ..Self::nearby(random)
        }
    }

    /// Much smaller or larger, slower or faster.
    fn scaled(random: &mut Random) -> Self {
        let near = Self::nearby(random);
        let mut power = || {
            let power = BigRational::from_integer(BigInt::one() << random.whole(0, 40));
            if random.coin() { power.recip() } else { power }
        };
        let size = power();
        Self {
            turn: near.turn.map(|part| part * &size),
            growth: near.growth * size,
            speed: power(),
            shift: at(0, 0),
            drift: at(0, 0),
            ..near
        }
    }

    /// In numbers that are no binary64.
    fn fractions(random: &mut Random) -> Self {
        let near = Self::nearby(random);
        let part = ratio(1, random.one_of(&[3, 7, 10]));
        Self {
            turn: near.turn.map(|leg| leg * &part),
            growth: near.growth * part,
            ..near
        }
    }

    /// At any angle: the point of the unit circle whose half angle has a random tangent.
    fn rounded(random: &mut Random) -> Self {
        let unit = 1 << 50;
        let tangent = ratio(random.whole(-unit, unit), unit);
        let square = &tangent * &tangent;
        let below = whole(1) + &square;
        Self {
            turn: [(whole(1) - square) / &below, whole(2) * tangent / below],
            growth: whole(1),
            writing: Writing::Rounded,
            ..Self::nearby(random)
        }
    }

    pub(super) fn put(&self, pair: Pair, id: &str) -> Result<Scene, SceneError> {
        let scene = Scene::builder(id);
        match pair.other {
            Other::Disc(other) => {
                let discs = [pair.disc, other].map(|body| self.disc(body, &self.drift));
                scene.discs(discs)
            }
            Other::Wall(ends) => {
                let [from, to] = ends.map(|end| self.point(&end));
                scene.disc(self.disc(pair.disc, &at(0, 0))).wall(from, to)
            }
        }
        .build()
    }

    fn disc(&self, body: Body, drift: &Vector) -> DiscBuilder {
        let velocity = body.velocity.map(|part| part * &self.speed);
        let velocity = self.written(self.turned(&velocity), drift);
        let radius = self.number(body.radius * &self.growth);
        Disc::at(self.point(&body.position), radius).velocity(velocity)
    }

    fn point(&self, point: &Vector) -> [Written; 2] {
        self.written(self.turned(point), &self.shift)
    }

    fn turned(&self, [x, y]: &Vector) -> Vector {
        let [cos, sin] = &self.turn;
        [cos * x - sin * y, sin * x + cos * y]
    }

    fn written(&self, [x, y]: Vector, more: &Vector) -> [Written; 2] {
        [self.number(x + &more[0]), self.number(y + &more[1])]
    }

    fn number(&self, value: BigRational) -> Written {
        let exact = Number::try_from(value);
        Written(exact.and_then(|exact| match self.writing {
            Writing::Exact => Ok(exact.in_binary64()),
            Writing::Rounded => Number::try_from(exact.to_f64()),
        }))
    }
}
