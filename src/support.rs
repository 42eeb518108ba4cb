//! What of a scene cannot be simulated, told before anything runs (D19).

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use crate::arithmetic::Arithmetic;
use crate::effects;
use crate::scalar::Number;
use crate::scene::{Disc, Mass, Restitution, Scene};
use crate::simulation::Algorithm;

/// So many doublings of a side may a disc get away from a periodic cell on its own: each
/// side it crosses costs time.
const FARTHEST: u32 = 19;

/// Something that a scene asks for and that is not to be had.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Unsupported {
    /// An effect that an algorithm does not have in an arithmetic, or not
    /// together with another one.
    #[error("{place}: not available {circumstance}")]
    Combination {
        /// Where the scene asks for it.
        place: &'static str,
        /// With what it is not.
        circumstance: String,
    },
    /// A disc that may get too far from the cell of a periodic scene.
    #[error("{place}: expected to keep within 2^{FARTHEST} sides of the periodic cell")]
    Far {
        /// The disc.
        place: String,
    },
    /// A number that is too large or too small for an arithmetic.
    #[error(
        "{place}: expected a magnitude between 2^-{range} and 2^{range} for {arithmetic}, found {found}"
    )]
    Range {
        /// Where the number stands.
        place: String,
        /// The arithmetic.
        arithmetic: &'static str,
        /// The numbers that it takes.
        range: i32,
        /// The number.
        found: String,
    },
}

/// Whether an algorithm can simulate a scene in an arithmetic.
///
/// # Errors
///
/// The first thing that it cannot.
pub fn check_support<S: Arithmetic>(
    scene: &Scene,
    algorithm: Algorithm,
) -> Result<(), Unsupported> {
    check_periodic::<S>(scene, algorithm)?;
    check_effects::<S>(scene, algorithm)?;
    numbers(scene).try_for_each(|(place, number)| check_number::<S>(place, number))
}

/// Only the timeline repeats the plane, and only where motion is straight.
fn check_periodic<S: Arithmetic>(scene: &Scene, algorithm: Algorithm) -> Result<(), Unsupported> {
    let Some(cell) = scene.periodic() else {
        return Ok(());
    };
    let refused = |place, circumstance| Unsupported::Combination {
        place,
        circumstance,
    };
    if algorithm != Algorithm::Timeline {
        return Err(refused("periodic", format!("in the algorithm {algorithm}")));
    }
    let effects = scene.effects();
    let bent = [
        (effects.gravity.is_some(), "effects.gravity"),
        (effects.drag.is_some(), "effects.drag"),
    ];
    if let Some((_, place)) = bent.into_iter().find(|(asked, _)| *asked) {
        return Err(refused(place, String::from("in a periodic scene")));
    }
    check_distances(scene, &scene.frame().total())?;
    let sides = cell.sides();
    sides
        .iter()
        .try_for_each(|side| check_number::<S>("periodic", side))
}

/// How far the discs of a periodic scene may get until a time.
pub(crate) fn check_distances(scene: &Scene, until: &BigRational) -> Result<(), Unsupported> {
    let Some(cell) = scene.periodic() else {
        return Ok(());
    };
    let most = BigRational::from_integer(BigInt::one() << FARTHEST);
    let limits = cell.sides().map(|side| side.to_rational() * &most);
    let is_far = |disc: &Disc, axis: usize| {
        let [place, speed] = [&disc.position[axis], &disc.velocity[axis]];
        place.to_rational().abs() + speed.to_rational().abs() * until > limits[axis]
    };
    let mut discs = scene.discs().iter();
    match discs.position(|disc| is_far(disc, 0) || is_far(disc, 1)) {
        Some(index) => Err(Unsupported::Far {
            place: format!("discs[{index}]"),
        }),
        None => Ok(()),
    }
}

/// The frame algorithms take all effects. So does the timeline, but for drag in
/// an arithmetic that has it in warped time alone.
fn check_effects<S: Arithmetic>(scene: &Scene, algorithm: Algorithm) -> Result<(), Unsupported> {
    let effects = scene.effects();
    let is_air = effects::is_air(effects, has_moving_wall(scene));
    if algorithm != Algorithm::Timeline || !is_air || S::SINK.is_some() {
        return Ok(());
    }
    let other = if effects.gravity.is_some() {
        "gravity"
    } else if has_moving_wall(scene) {
        "a moving disc of infinite mass"
    } else {
        "elastic_below"
    };
    Err(Unsupported::Combination {
        place: "effects.drag",
        circumstance: format!("by the timeline in {}, together with {other}", S::NAME),
    })
}

fn has_moving_wall(scene: &Scene) -> bool {
    let moves = |disc: &Disc| !disc.velocity.iter().all(Number::is_zero);
    let mut discs = scene.discs().iter();
    discs.any(|disc| disc.mass == Mass::Infinite && moves(disc))
}

/// Whether an arithmetic can compute with a number. Where its range is
/// limited, no product of four must overflow or vanish.
pub(crate) fn check_number<S: Arithmetic>(
    place: impl Into<String>,
    number: &Number,
) -> Result<(), Unsupported> {
    match S::RANGE {
        Some(range) if !number.is_within(range) => Err(Unsupported::Range {
            place: place.into(),
            arithmetic: S::NAME,
            range,
            found: number.to_string(),
        }),
        _ => Ok(()),
    }
}

/// All numbers of a scene, with their places.
fn numbers(scene: &Scene) -> impl Iterator<Item = (String, &Number)> {
    let discs = scene.discs().iter().enumerate().flat_map(|(index, disc)| {
        let mass = match &disc.mass {
            Mass::Finite(mass) => Some(mass),
            Mass::Infinite => None,
        };
        let named = disc.position.iter().map(|number| ("position", number));
        let named = named.chain(disc.velocity.iter().map(|number| ("velocity", number)));
        let named = named.chain([("radius", &disc.radius)]);
        let named = named.chain(mass.map(|number| ("mass", number)));
        named.map(move |(key, number)| (format!("discs[{index}].{key}"), number))
    });
    let walls = scene.walls().iter().enumerate().flat_map(|(index, wall)| {
        let from = wall.from.iter().map(|number| ("from", number));
        let named = from.chain(wall.to.iter().map(|number| ("to", number)));
        named.map(move |(key, number)| (format!("walls[{index}].{key}"), number))
    });
    let duration = (String::from("frame.duration"), &scene.frame().duration);
    discs
        .chain(walls)
        .chain([duration])
        .chain(slow_limit(scene))
        .chain(forces(scene))
}

/// Gravity and drag.
fn forces(scene: &Scene) -> impl Iterator<Item = (String, &Number)> {
    let effects = scene.effects();
    let gravity = effects.gravity.iter().flatten();
    let gravity = gravity.map(|number| (String::from("effects.gravity"), number));
    let drag = effects.drag.iter();
    gravity.chain(drag.map(|number| (String::from("effects.drag.linear"), number)))
}

/// The speed below which impacts are elastic.
fn slow_limit(scene: &Scene) -> Option<(String, &Number)> {
    match &scene.effects().restitution {
        Restitution::Newton { elastic_below, .. } => elastic_below
            .as_ref()
            .map(|speed| (String::from("effects.restitution.elastic_below"), speed)),
        _ => None,
    }
}
