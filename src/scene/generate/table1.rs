//! The paper's experiment: Table 1.

use num_rational::BigRational;

use super::exact;
use super::random::Random;
use crate::scalar::Number;
use crate::scene::input::shown;
use crate::scene::{Disc, DiscBuilder, Scene, SceneError};

const COLUMNS: i32 = 15;
const ROWS: i32 = 10;
const RADIUS: i32 = 15;
const SPEED: f64 = 300.0;

/// The experiment behind the paper's Table 1: 150 discs in 10 rows of 15,
/// evenly spread in an elastic box of 800 by 600, with velocities uniform in
/// the circle of speed 300; 600 frames of 1/60.
///
/// The radius is 15 times `scale`: the paper's second column has 33 % of the
/// first one's. The paper gives no other number; those of the box, the radius
/// and the speed are ours.
pub fn table1(seed: u64, scale: &Number) -> Result<Scene, SceneError> {
    let scale = scale.to_rational();
    let radius = exact("scale", &scale * whole(RADIUS))?;
    let mut random = Random::new(seed);
    let discs = (0..ROWS)
        .flat_map(|row| (0..COLUMNS).map(move |column| (column, row)))
        .map(|(column, row)| disc(column, row, &radius, &mut random));
    let id = name(&scale);
    Scene::builder(id)
        .notes(notes(seed, &radius))
        .discs(discs)
        .walls_around([0, 0], [800, 600])
        .frame("1/60", 600)
        .build()
}

fn disc(column: i32, row: i32, radius: &Number, random: &mut Random) -> DiscBuilder {
    let position = [50 * (column + 1), 60 * row + 30];
    Disc::at(position, radius).velocity(random.in_circle(SPEED))
}

fn name(scale: &BigRational) -> &'static str {
    if *scale == whole(1) {
        "table1-full"
    } else if *scale == BigRational::new(33.into(), 100.into()) {
        "table1-third"
    } else {
        "table1"
    }
}

fn notes(seed: u64, radius: &Number) -> String {
    format!(
        "The experiment of the paper's Table 1: 150 discs of radius {} in 10 rows of 15, \
         evenly spread in an elastic box, 600 frames. Seed {seed}.",
        shown(radius)
    )
}

fn whole(number: i32) -> BigRational {
    BigRational::from_integer(number.into())
}
