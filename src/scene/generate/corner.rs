//! A disc that meets two walls at once.

use num_rational::BigRational;
use num_traits::{One, Signed};

use super::{exact, unit};
use crate::scalar::Number;
use crate::scene::{Disc, Scene, SceneError};

/// A disc of radius 1 that goes straight into a wedge and touches both of its
/// walls at the time 1.
///
/// The walls go from the origin, one along the x axis and one along `wedge` =
/// (c, s), a rational point of the upper half of the unit circle: (0, 1) is a
/// right angle. Their bisector goes along (1 + c, s), and so does the disc:
/// at a (1 + c, s) it is a s away from both walls, and a falls at the rate 1.
/// Out of a right angle it comes back the way it went in.
pub fn corner(wedge: &[Number; 2]) -> Result<Scene, SceneError> {
    let [cos, sin] = unit("wedge", wedge)?;
    if !sin.is_positive() {
        let found = format!("{cos},{sin}");
        return Err(SceneError::physical(
            "wedge",
            "a point above the x axis",
            found,
        ));
    }
    let one = BigRational::one();
    let bisector = [&one + &cos, sin.clone()];
    let start = &one + sin.recip();
    // Twice as far as the foot of the disc at the start, and some more.
    let length = BigRational::from_integer(2.into()) * (&start * &bisector[0] + &one);
    let [x, y] = bisector
        .each_ref()
        .map(|part| exact("wedge", part * &start));
    let [vx, vy] = bisector.map(|part| exact("wedge", -part));
    let [end_x, end_y] = [cos, sin].map(|part| exact("wedge", part * &length));
    Scene::builder("corner")
        .notes("A disc goes into a wedge and touches both walls at the time 1.")
        .disc(Disc::at([x?, y?], 1).velocity([vx?, vy?]))
        .wall([0, 0], (exact("wedge", length)?, 0))
        .wall([0, 0], [end_x?, end_y?])
        .frame(1, 3)
        .build()
}
