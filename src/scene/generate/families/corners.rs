//! A disc where walls end, meet, or leave just enough room.

use num_traits::Signed;

use super::parts::{Written, at, disc, ratio, whole};
use super::place::placed;
use crate::scalar::Number;
use crate::scene::generate::random::Random;
use crate::scene::generate::{corner, exact};
use crate::scene::{Scene, SceneBuilder, SceneError};

/// Rational points of the upper half of the unit circle.
const WEDGES: [[i64; 3]; 8] = [
    [0, 1, 1],
    [3, 4, 5],
    [-3, 4, 5],
    [4, 3, 5],
    [-4, 3, 5],
    [5, 12, 13],
    [-20, 21, 29],
    [15, 8, 17],
];

pub(super) fn draw(random: &mut Random) -> Result<SceneBuilder, SceneError> {
    let scene = match random.whole(0, 4) {
        0 => straight(random)?,
        1 => wedge(random),
        2 => apex(random),
        3 => end(random),
        _ => mouth(random),
    };
    placed(scene, random)
}

/// Into a wedge, so that it touches both walls at once.
fn straight(random: &mut Random) -> Result<SceneBuilder, SceneError> {
    let [cos, sin, one] = random.one_of(&WEDGES);
    let [cos, sin]: [Result<Number, _>; 2] = [cos, sin].map(|leg| exact("wedge", ratio(leg, one)));
    Ok(SceneBuilder::from(corner(&[cos?, sin?])?))
}

/// Into a wedge, towards its tip or by it: both walls in turn, more than once if it is
/// narrow.
///
/// The start is on the bisector, which goes along (1 + cos, sin), far enough out for the
/// disc to be between the walls.
fn wedge(random: &mut Random) -> SceneBuilder {
    let [cos, sin, one] = random.one_of(&WEDGES);
    let far = ratio(random.whole(5, 9) * 16 / one, 16);
    let start = [one + cos, sin].map(|part| whole(part) * &far);
    let velocity =
        [0, 1].map(|axis: usize| ratio(random.whole(-2, 2), 4) - &start[axis] / whole(4));
    let length = 24 / one + 4;
    Scene::builder("")
        .notes("A disc into a wedge.")
        .disc(disc(start, velocity, ratio(random.whole(2, 6), 4)))
        .wall([0, 0], [60, 0])
        .wall([0, 0], [length * cos, length * sin])
        .frame(1, 16)
}

/// At the tip of two walls, from outside: ends that coincide.
fn apex(random: &mut Random) -> SceneBuilder {
    let height = ratio(random.whole(-4, 4), 4);
    let velocity = at(random.whole(1, 3), 0);
    let [up, down] = [0, 1].map(|_| random.whole(1, 9));
    Scene::builder("")
        .notes("A disc against the tip of two walls, whose ends coincide.")
        .disc(disc([whole(-5), height], velocity, whole(1)))
        .wall([0, 0], [9, up])
        .wall([9, -down], [0, 0])
        .frame(1, 8)
}

/// At the end of a wall: head-on, or with the foot exactly on it.
fn end(random: &mut Random) -> SceneBuilder {
    let speed = random.whole(1, 3);
    let (start, velocity) = match random.coin() {
        true => (at(-6, 0), at(speed, 0)),
        false => ([whole(0), whole(5)], at(0, -speed)),
    };
    let off = random.tiny(20, 60);
    let start = [start[0].clone() + &off, start[1].clone() + off];
    Scene::builder("")
        .notes("A disc against the end of a wall: its foot is at the end, or almost.")
        .disc(disc(start, velocity, whole(1)))
        .wall([0, 0], [7, 0])
        .wall([-9, -9], [-9, 9])
        .frame(1, 8)
}

/// Into a mouth that is closed behind: as wide as the disc, or almost, and met in the
/// middle; or clearly less or more, and met anywhere. Off the middle of an exact one it
/// would be stuck.
fn mouth(random: &mut Random) -> SceneBuilder {
    let clear = random.one_of(&[ratio(1, 4), ratio(-1, 4)]);
    let (half, aim) = match random.coin() {
        true => (whole(1) + random.tiny(20, 40).abs(), whole(0)),
        false => (whole(1) + clear, ratio(random.whole(-3, 3), 8)),
    };
    let sides = [half.clone(), -half];
    let start = [whole(-5), aim];
    let scene = Scene::builder("")
        .notes("A disc into a mouth of about its width.")
        .disc(disc(start, at(random.whole(1, 3), 0), whole(1)))
        .wall([6, -2], [6, 2])
        .frame(1, 8);
    sides.into_iter().fold(scene, |scene, y| {
        let y = Written(y);
        scene.wall((0, y.clone()), (6, y))
    })
}
