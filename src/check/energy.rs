//! What an impact does to the energy of its two bodies.
//!
//! Of two discs it is that in the scene's frame of reference. A body of infinite
//! mass or a wall does work when it moves, but not in its own frame: there the
//! speed of the other one counts.

use super::bodies::Motion;
use super::margin::ENERGY;
use super::real::{Point, Real};
use super::record::Record;
use crate::world::Obstacle;

/// By how many margins an impact gains energy, or an elastic one changes it.
pub(super) fn drift(record: &Record, index: usize, elastic: bool) -> Option<f64> {
    let (disc, obstacle) = record.claims[index].pair;
    let states = [&record.states[index], &record.states[index + 1]];
    let masses = &record.bodies.masses;
    let [before, after] = states.map(|state| match obstacle {
        Obstacle::Wall(_) => relative(&state[disc], None),
        Obstacle::Disc(other) => match (masses[disc], masses[other]) {
            (Some(_), None) => relative(&state[disc], Some(&state[other])),
            (None, _) => relative(&state[other], Some(&state[disc])),
            (Some(mass), Some(other_mass)) => {
                together([(mass, &state[disc]), (other_mass, &state[other])])
            }
        },
    });
    let gain = (&after.value - &before.value).to_f64();
    let allowed = ENERGY * before.scale.max(after.scale);
    let beyond = if elastic { gain.abs() } else { gain } / allowed;
    (beyond > 1.0).then_some(beyond)
}

/// Twice an energy, and the size of what it is computed from.
struct Energy {
    value: Real,
    scale: f64,
}

/// Of a disc of mass 1, relative to what it has met.
fn relative(disc: &Motion, other: Option<&Motion>) -> Energy {
    let base = other.map_or([0.0; 2], |other| other.velocity);
    let velocity = Point::from(disc.velocity).minus(&Point::from(base));
    let speeds = disc.speed() + other.map_or(0.0, Motion::speed);
    Energy {
        value: velocity.norm_squared(),
        scale: speeds * speeds,
    }
}

fn together(discs: [(f64, &Motion); 2]) -> Energy {
    let [one, other] = discs.map(|(mass, disc)| {
        let square = Point::from(disc.velocity).norm_squared();
        &Real::from(mass) * &square
    });
    let value = &one + &other;
    let scale = value.to_f64();
    Energy { value, scale }
}
