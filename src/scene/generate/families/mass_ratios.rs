//! Masses of very different size, and infinite ones.

use super::parts::{Written, at, disc, ratio, whole};
use super::scatter::Scatter;
use crate::scene::generate::random::Random;
use crate::scene::{DiscBuilder, Scene, SceneBuilder};

pub(super) fn draw(random: &mut Random) -> SceneBuilder {
    match random.whole(0, 2) {
        0 => open(random),
        1 => boxed(random),
        _ => pinched(random),
    }
}

/// 10^3 to 10^12, in binary64, or infinite.
fn heavy(disc: DiscBuilder, random: &mut Random) -> DiscBuilder {
    match random.whole(0, 3) {
        0 => disc.infinite_mass(),
        _ => disc.mass(10_f64.powi(random.whole(3, 12) as i32)),
    }
}

/// Around the origin, in short numbers.
fn scatter(is_open: bool) -> Scatter {
    Scatter {
        shift: [0.0; 2],
        grain: Some(10),
        is_open,
    }
}

/// Heavy ones and light ones that go to the middle.
fn open(random: &mut Random) -> SceneBuilder {
    let scatter = scatter(true);
    let count = random.whole(3, 6);
    let mut discs = scatter.discs(count, random);
    for place in discs.iter_mut().take(2) {
        *place = heavy(place.clone(), random);
    }
    let notes = "Heavy discs and light ones on their way to the middle.";
    scatter.around(Scene::builder("").notes(notes).discs(discs))
}

/// Light ones in a box with heavy ones at rest.
fn boxed(random: &mut Random) -> SceneBuilder {
    let scatter = scatter(false);
    let count = random.whole(2, 5);
    let mut discs = scatter.discs(count, random);
    discs[0] = heavy(discs[0].clone().velocity([0, 0]), random);
    let notes = "Light discs in a box with a heavy one at rest.";
    scatter.around(Scene::builder("").notes(notes).discs(discs))
}

/// A light one between two heavy ones, whose gap is half as wide at the end.
fn pinched(random: &mut Random) -> SceneBuilder {
    let speed = random.whole(2, 8);
    let offset = ratio(random.whole(-4, 4), 1 << random.whole(4, 30));
    let light = disc([whole(0), offset], at(speed, 0), ratio(1, 4));
    let press = |x: i64, random: &mut Random| {
        let one = disc(at(3 * x, 0), at(-x, 0), whole(1));
        heavy(one, random)
    };
    let [left, right] = [-1, 1].map(|x| press(x, random));
    Scene::builder("")
        .notes("A light disc between two heavy ones, which come nearer.")
        .disc(light)
        .disc(left)
        .disc(right)
        .frame(Written(ratio(1, 8)), 8)
}
