//! The end of a run as a scene, to go on from.

use num_rational::BigRational;

use super::decimal::{Direction, rounded};
use super::quantity::nearest;
use crate::arithmetic::Arithmetic;
use crate::body;
use crate::run::Outcome;
use crate::scalar::{Number, NumberError};
use crate::scene::{Disc, DiscBuilder, IntoNumber, Mass, Scene, SceneError};
use crate::vec2::Vec2;

/// The scene in which a run has ended, with as many frames as there were.
///
/// Positions and velocities are rounded: to binary64, or those of exact
/// arithmetic to so many decimal digits. Discs that touch may thus overlap, or
/// touch no more.
///
/// # Errors
///
/// A disc has gone where no [`Number`] is.
pub fn end_scene<S: Arithmetic>(
    scene: &Scene,
    outcome: &Outcome<S>,
    digits: Option<u32>,
) -> Result<Scene, SceneError> {
    let discs = scene.discs().iter().zip(&outcome.end);
    let discs = discs.map(|(written, end)| disc(written, end, digits));
    let time = nearest(&outcome.time);
    scene
        .to_builder()
        .notes(format!("{} as it is at {time}.", scene.id()))
        .without_discs()
        .discs(discs)
        .build()
}

fn disc<S: Arithmetic>(written: &Disc, end: &body::Disc<S>, digits: Option<u32>) -> DiscBuilder {
    let point =
        |vector: &Vec2<S>| [&vector.x, &vector.y].map(|number| Rounded::new(number, digits));
    let disc = Disc::at(point(&end.position), &written.radius).velocity(point(&end.velocity));
    match &written.mass {
        Mass::Finite(mass) => disc.mass(mass),
        Mass::Infinite => disc.infinite_mass(),
    }
}

/// A rounded number, unless it has become too large to be one.
struct Rounded(Result<Number, NumberError>);

impl Rounded {
    fn new<S: Arithmetic>(value: &S, digits: Option<u32>) -> Self {
        let decimal =
            digits.and_then(|digits| Some(rounded(&middle(value)?, digits, Direction::Nearest)));
        Self(match decimal {
            Some(decimal) => decimal.parse(),
            None => Number::try_from(nearest(value)),
        })
    }
}

impl IntoNumber for Rounded {
    fn into_number(self) -> Result<Number, NumberError> {
        self.0
    }
}

/// The middle of a number's proven bounds, if it has any.
fn middle<S: Arithmetic>(value: &S) -> Option<BigRational> {
    let (lo, hi) = value.enclosure()?;
    Some((lo + hi) / BigRational::from_integer(2.into()))
}
