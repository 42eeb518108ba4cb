//! Gases of equal discs: in a box, or without any walls.

use std::f64::consts::FRAC_PI_4;

use super::random::Random;
use crate::scalar::Number;
use crate::scene::input::shown;
use crate::scene::{Disc, Scene, SceneBuilder, SceneError};

/// How much of a lattice's step must stay free at the start, so that rounded
/// positions cannot overlap.
const MIN_GAP: f64 = 1e-6;

/// A gas of `count` discs of radius 1/2 in a square box with walls.
///
/// The discs cover the part `packing` of the box. They start apart from each
/// other, near the points of a square lattice; each component of a velocity
/// has variance 1. Since the lattice has whole rows, not every packing
/// fraction up to π/4 can be had.
pub fn gas(seed: u64, count: u32, packing: f64) -> Result<Scene, SceneError> {
    let (side, scene) = fill(seed, count, packing)?;
    let notes = format!("A gas of {count} discs that cover {packing} of the box. Seed {seed}.");
    let scene = scene.id("gas").notes(notes);
    scene.walls_around([0.0, 0.0], [side, side]).build()
}

/// The same gas in a square that repeats, in place of a box.
pub fn periodic_gas(seed: u64, count: u32, packing: f64) -> Result<Scene, SceneError> {
    let (side, scene) = fill(seed, count, packing)?;
    let notes = format!("A gas of {count} discs that cover {packing} of the plane. Seed {seed}.");
    let scene = scene.id("periodic-gas").notes(notes);
    scene.periodic([0.0, 0.0], [side, side]).build()
}

/// The side of a square, and the discs in it.
fn fill(seed: u64, count: u32, packing: f64) -> Result<(f64, SceneBuilder), SceneError> {
    let rows = f64::from(count).sqrt().ceil();
    let side = (f64::from(count) * FRAC_PI_4 / packing).sqrt();
    check(count, packing, side / rows - 1.0)?;
    let mut random = Random::new(seed);
    let lattice = Lattice { rows, side };
    let discs = (0..count).map(|index| {
        let position = lattice.place(index, &mut random);
        Disc::at(position, "1/2").velocity([random.normal(), random.normal()])
    });
    let scene = Scene::builder("gas").discs(discs).frame("1/60", 600);
    Ok((side, scene))
}

/// The points that discs of diameter 1 start near.
struct Lattice {
    rows: f64,
    side: f64,
}

impl Lattice {
    /// The lattice's point, moved by at most a quarter of the free gap: two
    /// neighbours keep half of it.
    fn place(&self, index: u32, random: &mut Random) -> [f64; 2] {
        let step = self.side / self.rows;
        let index = f64::from(index);
        let [row, column] = [(index / self.rows).floor(), index % self.rows];
        let mut jittered = |cell: f64| (cell + 0.5) * step + random.within((step - 1.0) / 4.0);
        [jittered(column), jittered(row)]
    }
}

fn check(count: u32, packing: f64, gap: f64) -> Result<(), SceneError> {
    if count == 0 {
        return Err(SceneError::physical("count", "at least 1", count));
    }
    let packing =
        Number::try_from(packing).map_err(|error| SceneError::format("packing", error))?;
    if gap < MIN_GAP || gap.is_nan() || gap.is_infinite() {
        let expected = "a packing fraction, above 0, that the square lattice has room for";
        return Err(SceneError::physical("packing", expected, shown(&packing)));
    }
    Ok(())
}
