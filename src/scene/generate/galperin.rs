//! Counting the digits of π with two discs and a wall.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::exact;
use crate::scene::{Disc, Scene, SceneError};

/// The largest power for which [`galperin`] has a proven end.
pub const MAX_POWER: u32 = 15;

/// A light disc at rest between a wall and a heavy one, 100^`power` times its
/// mass, that comes in: floor(π 10^`power`) impacts in all (G. Galperin:
/// Playing pool with π, 2003).
///
/// How long it takes: with q₁ = 1 and q₂ = 2 the initial distances of light
/// and heavy disc from the wall, less the diameters between, the point
/// (q₂ √M, q₁ √m) moves like a billiard ball in a wedge of the angle
/// α = arctan √(m/M). Unfolded, its path is a straight line that crosses the
/// rays at α, 2α, … below π. It crosses the last one, δ ahead of π, at the
/// time 2 + tan α / tan δ. For equal masses δ = α, and it is 3. Otherwise
/// δ/α = frac(π/α), which is above 1/10 since none of π's first 16 decimals is
/// 0; with tan α ≤ 4α/π and tan δ ≥ δ the time is below 2 + 40/π < 15.
pub fn galperin(power: u32) -> Result<Scene, SceneError> {
    if power > MAX_POWER {
        let expected = format!("at most {MAX_POWER}");
        return Err(SceneError::physical("power", expected, power));
    }
    let mass = BigRational::from_integer(BigInt::from(100).pow(power));
    let mass = exact("power", mass)?;
    Scene::builder(format!("galperin-{power}"))
        .notes(format!(
            "The mass ratio is 100^{power}: floor(pi * 10^{power}) impacts in all."
        ))
        .disc(Disc::at([2, 0], 1))
        .disc(Disc::at([5, 0], 1).velocity([-1, 0]).mass(mass))
        .wall([0, -1], [0, 1])
        .frame(15, 1)
        .build()
}
