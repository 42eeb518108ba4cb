//! Two discs and a wall: the ratio of their masses alone says how often they meet.
//!
//! With the ratio M and α = arctan √(1/M) there are ⌈π/α⌉ - 1 impacts
//! ([`galperin`](crate::scene::generate::galperin())), wherever the discs start. With the
//! distances q₁ and q₂ of light and heavy disc from the wall, less the diameters between,
//! and the speed v, the last one is at (q₂ + q₁ tan α / tan δ) / v, where δ is what α
//! leaves of π. For each ratio here tan α / tan δ is below 16.

use super::parts::{Written, at, disc, ratio, whole};
use super::place::placed;
use crate::scene::generate::random::Random;
use crate::scene::{Scene, SceneBuilder, SceneError};

/// The ratios, as fractions.
const RATIOS: [[i64; 2]; 14] = [
    [1, 1],
    [3, 1],
    [1, 3],
    [2, 1],
    [7, 2],
    [9, 1],
    [10, 1],
    [16, 1],
    [49, 1],
    [50, 1],
    [99, 1],
    [100, 1],
    [100, 1],
    [10_000, 1],
];

pub(super) fn draw(random: &mut Random) -> Result<SceneBuilder, SceneError> {
    let [heavy, light] = random.one_of(&RATIOS);
    let [near, between] = [0, 1].map(|_| ratio(random.whole(1, 16), 8));
    let [small, large] = [0, 1].map(|_| ratio(random.whole(1, 8), 4));
    let speed = random.whole(1, 4);
    let first = &near + &small;
    let second = &first + &small + &between + &large;
    // Longer than it takes.
    let duration = (whole(17) * &near + &between) / whole(speed);
    let scene = Scene::builder("")
        .notes(format!("The ratio of the masses is {heavy}/{light}."))
        .disc(disc([first, whole(0)], at(0, 0), small).mass(light))
        .disc(disc([second, whole(0)], at(-speed, 0), large).mass(heavy))
        .wall([0, -3], [0, 3])
        .frame(Written(duration), 1);
    placed(scene, random)
}
