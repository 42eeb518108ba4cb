//! Velocities after an impact in two words of floating point, where all that
//! they may truly be rounds to the same.
//!
//! With u the largest relative error of an operation, w·n errs by at most
//! 4 u |w| |n| (sums of magnitudes), so the change of a coordinate by that part of
//! itself and 24 u for all other operations.

use crate::body::{Disc, Mass};
use crate::filtered::course::{Line, coordinates};
use crate::filtered::float::{Float, Twofold, UNDERFLOW, is_moderate};
use crate::respond::Restitution;
use crate::scalar::Filtered;
use crate::vec2::Vec2;

type Pair = [Twofold; 2];

/// What an impact does to velocities.
struct Push {
    /// (1 + e) (w·n) / (n·n).
    strength: Twofold,
    /// The largest relative error of what is computed from it.
    error: f64,
    normal: Pair,
}

/// The velocities after the impact of two discs.
pub(super) fn discs(
    [first, second]: [&Disc<Filtered>; 2],
    centres: [&Vec2<Filtered>; 2],
    restitution: &Restitution<Filtered>,
) -> Option<[Vec2<Filtered>; 2]> {
    let elasticity = match restitution {
        Restitution::Elastic => Filtered::new(1.0),
        Restitution::Newton {
            discs,
            elastic_below: None,
            ..
        } => *discs,
        Restitution::Newton { .. } | Restitution::Paper { .. } => return None,
    };
    let [from, to] = centres.map(coordinates);
    let [own, other] = [first, second].map(|disc| coordinates(&disc.velocity));
    let push = Push::new(differences(own, other), differences(to, from), elasticity)?;
    let [share, other_share] = shares(&first.mass, &second.mass);
    let after = [push.after(own, -share)?, push.after(other, other_share)?];
    push.has_parted(differences(after[0], after[1]))
        .then(|| after.map(vector))
}

/// The velocity of a disc after its impact on a fixed point, from its centre and
/// that.
pub(super) fn fixed(
    disc: &Disc<Filtered>,
    [from, to]: [[f64; 2]; 2],
    restitution: &Restitution<Filtered>,
) -> Option<Vec2<Filtered>> {
    rebound(disc, differences(to, from), restitution)
}

/// The velocity of a disc after its impact on a wall.
pub(super) fn wall(
    disc: &Disc<Filtered>,
    line: &Line,
    restitution: &Restitution<Filtered>,
) -> Option<Vec2<Filtered>> {
    let [x, y] = differences(line.to, line.from);
    let velocity = coordinates(&disc.velocity);
    let across = velocity[1] * x.head() - velocity[0] * y.head();
    let normal = if across < 0.0 { [y, -x] } else { [-y, x] };
    rebound(disc, normal, restitution)
}

fn rebound(
    disc: &Disc<Filtered>,
    normal: Pair,
    restitution: &Restitution<Filtered>,
) -> Option<Vec2<Filtered>> {
    let elasticity = match restitution {
        Restitution::Elastic => Filtered::new(1.0),
        Restitution::Newton {
            walls,
            elastic_below: None,
            ..
        } => *walls,
        Restitution::Newton { .. } | Restitution::Paper { .. } => return None,
    };
    let velocity = coordinates(&disc.velocity);
    let push = Push::new(velocity.map(Twofold::new), normal, elasticity)?;
    let after = push.after(velocity, Twofold::new(-1.0))?;
    push.has_parted(after.map(Twofold::new))
        .then(|| vector(after))
}

impl Push {
    /// None if it is not certain that the bodies approach, or how much.
    fn new(velocity: Pair, normal: Pair, elasticity: Filtered) -> Option<Self> {
        let (approach, error) = along(velocity, normal);
        let is_sharp = approach.head() > 1e6 * error + UNDERFLOW;
        let is_safe = is_moderate(size(velocity)) && is_moderate(size(normal));
        let squared = normal[0] * normal[0] + normal[1] * normal[1];
        let gain = Twofold::new(1.0) + Twofold::new(elasticity.get());
        (is_sharp && is_safe).then(|| Self {
            strength: gain * approach / squared,
            error: 1.01 * error / approach.head() + 24.0 * Twofold::UNIT,
            normal,
        })
    }

    /// A velocity with a share of the push, if it is certain how that rounds.
    fn after(&self, velocity: [f64; 2], share: Twofold) -> Option<[f64; 2]> {
        let push = self.strength * share;
        let coordinate = |place: usize| {
            let (speed, normal) = (velocity[place], self.normal[place]);
            if share.head() == 0.0 || normal.head() == 0.0 {
                return Some(speed);
            }
            let change = push * normal;
            let size = change.head().abs();
            let error = self.error * size + Twofold::UNIT * (speed.abs() + size) + UNDERFLOW;
            (Twofold::new(speed) + change).nearest(error)
        };
        Some([coordinate(0)?, coordinate(1)?])
    }

    /// Whether bodies with this relative velocity certainly do not approach.
    fn has_parted(&self, velocity: Pair) -> bool {
        let (approach, error) = along(velocity, self.normal);
        -approach.head() > error
    }
}

/// The product of a velocity and a normal, and how far off that may be.
fn along(velocity: Pair, normal: Pair) -> (Twofold, f64) {
    let product = velocity[0] * normal[0] + velocity[1] * normal[1];
    let error = 4.0 * Twofold::UNIT * size(velocity) * size(normal);
    (product, error)
}

fn size([x, y]: Pair) -> f64 {
    x.head().abs() + y.head().abs()
}

/// The parts that two bodies take: in inverse proportion to their masses, of
/// which at most one is infinite.
fn shares(first: &Mass<Filtered>, second: &Mass<Filtered>) -> Pair {
    match (first, second) {
        (Mass::Finite(first), Mass::Finite(second)) => {
            let [first, second] = [first, second].map(|mass| Twofold::new(mass.get()));
            let total = first + second;
            [second / total, first / total]
        }
        (Mass::Finite(_), Mass::Infinite) => [1.0, 0.0].map(Twofold::new),
        (Mass::Infinite, _) => [0.0, 1.0].map(Twofold::new),
    }
}

fn differences(one: [f64; 2], other: [f64; 2]) -> Pair {
    [0, 1].map(|place| Twofold::difference(one[place], other[place]))
}

fn vector([x, y]: [f64; 2]) -> Vec2<Filtered> {
    Vec2::new(Filtered::new(x), Filtered::new(y))
}
