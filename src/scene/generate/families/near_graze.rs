//! Discs that nearly, or truly, only touch what they pass.
//!
//! A disc goes along y = `reach` past a body at the origin: another disc, the end of a
//! wall, or two discs on both sides of its path. By how much they reach each other is in
//! the radius: `reach` and a tiny number, or nothing more.

use num_rational::BigRational;

use super::parts::{at, disc, point, ratio, told, whole};
use super::place::placed;
use crate::scene::generate::random::Random;
use crate::scene::{Scene, SceneBuilder, SceneError};

pub(super) fn draw(random: &mut Random) -> Result<SceneBuilder, SceneError> {
    let pass = Pass {
        reach: random.whole(2, 6),
        more: random.tiny(20, 70),
        start: random.whole(2, 9),
        speed: random.one_of(&[ratio(1, 2), whole(1), whole(3), whole(7)]),
    };
    let scene = match random.whole(0, 4) {
        0 | 1 => pass.disc(random),
        2 | 3 => pass.end(random),
        _ => pass.between(),
    };
    let scene = pass.timed(scene, random);
    placed(scene, random)
}

struct Pass {
    reach: i64,
    /// How much further than that they reach.
    more: BigRational,
    start: i64,
    speed: BigRational,
}

impl Pass {
    /// The disc that passes, if what it passes has some radius.
    fn scene(&self, what: &str, other: &BigRational) -> SceneBuilder {
        let radius = whole(self.reach) + &self.more - other;
        let start = at(-self.reach - self.start, self.reach);
        let notes = format!("It reaches {what} by {}.", told(&self.more));
        Scene::builder("")
            .notes(notes)
            .disc(disc(start, [self.speed.clone(), whole(0)], radius))
    }

    fn disc(&self, random: &mut Random) -> SceneBuilder {
        let radius = random.one_of(&[ratio(1, 2), whole(1), whole(self.reach - 1)]);
        let other = disc(at(0, 0), at(0, 0), radius.clone());
        let mass = random.one_of(&[1, 1, 3]);
        self.scene("a disc", &radius).disc(other.mass(mass))
    }

    /// The wall goes away from the path, or straight along it.
    fn end(&self, random: &mut Random) -> SceneBuilder {
        let tip = at(0, 0);
        let foot = at(random.whole(-4, 4), -random.whole(1, 6));
        let ends = if random.coin() {
            [tip, foot]
        } else {
            [foot, tip]
        };
        let [from, to] = ends.map(point);
        self.scene("the end of a wall", &whole(0)).wall(from, to)
    }

    fn between(&self) -> SceneBuilder {
        let radius = whole(1);
        let others = [0, 2 * self.reach].map(|y| disc(at(0, y), at(0, 0), radius.clone()));
        self.scene("two discs at once", &radius).discs(others)
    }

    /// As long as it takes to come back, if there is a wall behind; else a while.
    fn timed(&self, scene: SceneBuilder, random: &mut Random) -> SceneBuilder {
        let way = 2 * (self.start + 3 * self.reach + 6);
        let frame = whole(way) / &self.speed / whole(8);
        let scene = scene.frame(super::parts::Written(frame), 8);
        let behind = 2 * self.reach + 4;
        match random.coin() {
            true => scene.wall([behind, -30], [behind, 30]),
            false => scene,
        }
    }
}
