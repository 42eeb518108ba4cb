//! Small discs so fast that a frame takes them many times their size.

use num_rational::BigRational;
use num_traits::Signed;

use super::parts::{Written, at, disc, ratio, whole};
use super::place::placed;
use crate::scene::generate::random::Random;
use crate::scene::{DiscBuilder, Scene, SceneBuilder, SceneError};

/// Of a second.
const FRAME: i64 = 64;

pub(super) fn draw(random: &mut Random) -> Result<SceneBuilder, SceneError> {
    let bullet = Bullet {
        speed: random.whole(128, 1024),
        radius: ratio(1, 1 << random.whole(4, 7)),
    };
    let scene = match random.whole(0, 3) {
        0 => bullet.plates(random),
        1 => bullet.slot(random),
        2 => bullet.targets(random),
        _ => bullet.duel(random),
    };
    // As many frames as it takes for so many lengths.
    let frames = random.whole(16, 64) * FRAME / bullet.speed + 1;
    let scene = scene.frame(Written(ratio(1, FRAME)), frames.unsigned_abs());
    placed(scene, random)
}

struct Bullet {
    speed: i64,
    radius: BigRational,
}

impl Bullet {
    /// From the left, towards x = 0 at some height.
    fn fired(&self, height: BigRational) -> DiscBuilder {
        let [x, y] = [whole(-6), height];
        disc([x, y], at(self.speed, 0), self.radius.clone())
    }

    /// Thin plates, one behind the other, and one behind the bullet.
    fn plates(&self, random: &mut Random) -> SceneBuilder {
        let thin = ratio(1, 1 << random.whole(6, 30));
        let tilt = ratio(random.whole(-4, 4), 2);
        let scene = Scene::builder("")
            .notes("A bullet between two plates, one of which is a thin pair.")
            .disc(self.fired(whole(0)))
            .wall([-8, -9], [-8, 9]);
        [whole(0), thin].into_iter().fold(scene, |scene, x| {
            let [low, high] = [-&tilt, tilt.clone()].map(|lean| Written(&x + lean));
            scene.wall((low, -9), (high, 9))
        })
    }

    /// A gap: as wide as the bullet, or almost, and met in the middle; or clearly less or
    /// more, and met anywhere. Off the middle of an exact one it would be stuck.
    fn slot(&self, random: &mut Random) -> SceneBuilder {
        let clear = random.one_of(&[ratio(1, 4), ratio(-1, 4)]);
        let (half, aim) = match random.coin() {
            true => (&self.radius + random.tiny(20, 40).abs(), whole(0)),
            false => (
                &self.radius * (whole(1) + clear),
                &self.radius * ratio(random.whole(-3, 3), 8),
            ),
        };
        Scene::builder("")
            .notes("A bullet at a gap of about its width, with plates before and behind.")
            .disc(self.fired(aim))
            .wall((0, -9), (0, Written(-&half)))
            .wall((0, 9), (0, Written(half)))
            .wall([4, -9], [4, 9])
            .wall([-8, -9], [-8, 9])
    }

    /// Three small discs at rest.
    fn targets(&self, random: &mut Random) -> SceneBuilder {
        let targets: Vec<_> = [0, 1, 3]
            .map(|x| {
                let off = &self.radius * ratio(random.whole(-19, 19), 16);
                disc([whole(x), off], at(0, 0), self.radius.clone())
            })
            .into();
        Scene::builder("")
            .notes("A bullet at a row of discs of its size.")
            .disc(self.fired(whole(0)))
            .discs(targets)
            .wall([5, -9], [5, 9])
            .wall([-8, -9], [-8, 9])
    }

    /// Two bullets at each other.
    fn duel(&self, random: &mut Random) -> SceneBuilder {
        let aim = &self.radius * ratio(random.whole(-33, 33), 16);
        let other = [whole(6), aim];
        let speed = random.whole(128, 1024);
        Scene::builder("")
            .notes("Two bullets at each other.")
            .disc(self.fired(whole(0)))
            .disc(disc(other, at(-speed, 0), self.radius.clone()))
            .wall([-8, -9], [-8, 9])
            .wall([8, -9], [8, 9])
    }
}
