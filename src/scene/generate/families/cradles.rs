//! Lines of discs that touch, or nearly do.

use num_rational::BigRational;
use num_traits::Signed;

use super::parts::{Written, at, disc, ratio, whole};
use super::place::placed;
use crate::scalar::Number;
use crate::scene::generate::random::Random;
use crate::scene::generate::{cradle, exact};
use crate::scene::{DiscBuilder, Scene, SceneBuilder, SceneError};

pub(super) fn draw(random: &mut Random) -> Result<SceneBuilder, SceneError> {
    let gap = random.tiny(4, 50).abs();
    let scene = match random.whole(0, 2) {
        0 => newton(random, &gap)?,
        kind => line(random, &gap, kind == 1),
    };
    placed(scene, random)
}

/// Equal discs, of which one or two come in.
fn newton(random: &mut Random, gap: &BigRational) -> Result<SceneBuilder, SceneError> {
    let count = random.whole(3, 7) as u32;
    let moving = random.whole(1, 2) as u32;
    let gap: Number = exact("gap", gap.clone())?;
    Ok(SceneBuilder::from(cradle(count, moving, &gap)?))
}

/// Discs of all sizes, struck from the left, or from both sides.
fn line(random: &mut Random, gap: &BigRational, both: bool) -> SceneBuilder {
    let count = random.whole(2, 5);
    let equal = random.coin();
    let mut place = whole(0);
    let mut before = whole(0);
    let mut discs: Vec<DiscBuilder> = Vec::new();
    let mut next = |distance: &BigRational, speed: i64, random: &mut Random| {
        let radius = ratio(random.whole(2, 8), 4);
        place += &before + distance + &radius;
        before = radius.clone();
        let mass = if equal { 1 } else { random.whole(1, 4) };
        let one = disc([place.clone(), whole(0)], at(speed, 0), radius);
        discs.push(one.mass(mass));
    };
    let far = whole(random.whole(2, 5));
    next(&whole(0), 1, random);
    for index in 0..count {
        let distance = if index == 0 { &far } else { gap };
        next(distance, 0, random);
    }
    if both {
        next(&far, -random.whole(1, 2), random);
    }
    Scene::builder("")
        .notes("A line of discs that touch, or nearly do, and what strikes it.")
        .discs(discs)
        .frame(Written(ratio(1, 2)), 24)
}
