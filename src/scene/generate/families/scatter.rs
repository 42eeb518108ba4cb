//! Discs of all sizes and masses, here and there.

use super::parts::{Written, ratio};
use crate::scalar::Number;
use crate::scene::generate::random::Random;
use crate::scene::{Disc, DiscBuilder, Restitution, Scene, SceneBuilder};

/// The cells that discs start in, and their side.
const COLUMNS: i64 = 4;
const ROWS: i64 = 3;
const SIDE: f64 = 4.0;

/// Two to six discs in a box, or on their way to its middle without one.
pub(super) fn random(random: &mut Random) -> SceneBuilder {
    let grain = random.one_of(&[None, Some(2), Some(20)]);
    let scatter = Scatter {
        shift: [0.0; 2],
        grain,
        is_open: random.coin(),
    };
    let scene = scatter.scene(random);
    match random.whole(0, 3) {
        0 => scene.restitution(loss(random)),
        _ => scene,
    }
}

/// The same without a loss, far from the origin. Coordinates are multiples of 2^-20, and
/// so they are there what they would be here.
pub(super) fn offset(random: &mut Random) -> SceneBuilder {
    let mut far = || {
        let size = 10_i64.pow(random.whole(3, 9) as u32);
        (random.one_of(&[-1, 1]) * size + random.whole(-99, 99)) as f64
    };
    let scatter = Scatter {
        shift: [far(), far()],
        grain: Some(20),
        is_open: random.coin(),
    };
    scatter.scene(random)
}

fn loss(random: &mut Random) -> Restitution {
    let tenths = Number::from(random.whole(5, 9)).to_rational() / ratio(10, 1);
    let tenths = Number::try_from(tenths).expect("a few tenths are of no absurd size");
    Restitution::newton(tenths)
}

/// How discs are scattered.
pub(super) struct Scatter {
    pub(super) shift: [f64; 2],
    /// Numbers are multiples of 2^-grain, or any binary64.
    pub(super) grain: Option<i32>,
    /// Without walls, and towards the middle.
    pub(super) is_open: bool,
}

impl Scatter {
    fn scene(&self, random: &mut Random) -> SceneBuilder {
        let masses = |random: &mut Random| random.one_of(&[0.25, 0.5, 1.0, 1.0, 2.0, 4.0]);
        let count = random.whole(2, 6);
        let discs: Vec<_> = (self.discs(count, random).into_iter())
            .map(|disc| disc.mass(masses(random)))
            .collect();
        self.around(Scene::builder("").discs(discs))
    }

    /// With its walls and frames.
    pub(super) fn around(&self, scene: SceneBuilder) -> SceneBuilder {
        let scene = scene.frame(Written(ratio(1, 4)), 16);
        let [x, y] = self.shift;
        match self.is_open {
            true => scene,
            false => {
                scene.walls_around([x, y], [x + COLUMNS as f64 * SIDE, y + ROWS as f64 * SIDE])
            }
        }
    }

    /// Discs of mass 1, each in a cell of its own.
    pub(super) fn discs(&self, count: i64, random: &mut Random) -> Vec<DiscBuilder> {
        let cells = COLUMNS * ROWS;
        let first = random.whole(0, cells - 1);
        // No two steps of 5 lead to the same of 12 cells.
        let cells = (0..count).map(|index| (first + 5 * index) % cells);
        cells.map(|cell| self.disc(cell, random)).collect()
    }

    fn disc(&self, cell: i64, random: &mut Random) -> DiscBuilder {
        let radius = self.grained(0.625 + random.within(0.375));
        let place = [cell % COLUMNS, cell / COLUMNS];
        let place = place.map(|cell| {
            let room = 0.875 * (SIDE / 2.0 - radius);
            self.grained((cell as f64 + 0.5) * SIDE + random.within(room))
        });
        let middle = [COLUMNS, ROWS].map(|cells| cells as f64 * SIDE / 2.0);
        let velocity = [0, 1].map(|axis| {
            let towards = (middle[axis] - place[axis]) / 2.0;
            self.grained(match self.is_open {
                true => towards + random.within(1.0),
                false => random.within(4.0),
            })
        });
        let place = [place[0] + self.shift[0], place[1] + self.shift[1]];
        Disc::at(place, radius).velocity(velocity)
    }

    fn grained(&self, number: f64) -> f64 {
        match self.grain {
            Some(bits) => {
                let unit = f64::from(1 << bits);
                (number * unit).round() / unit
            }
            None => number,
        }
    }
}
