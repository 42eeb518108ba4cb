//! Three discs in the plane: m between a and b, with which it collides in
//! turn while the normals turn.
//!
//! The gaps are g = |Δ| - R. In free flight 0 ≤ g'' ≤ K with K = W² / R, where W
//! bounds the relative speeds: by the energy relative to the centre of mass,
//! which never grows. An impact on b adds κ_b c ℓ to the approach of m and a,
//! where c is minus the product of the unit normals. These turn by at most W / R
//! a time, so that c ≥ c_0 - W (1 / R_a + 1 / R_b) S until a time S later. With the
//! intervals τ_n, as on a line (see [`trio`](super::trio)),
//!
//! > ℓ_{n+2} = κ_b c ℓ_{n+1} - e ℓ_n - δ with 0 ≤ δ ≤ K (τ_n + τ_{n+1}),
//!
//! and the gap that this closes is at most e ℓ_n τ_n + K τ_n² / 2. Now suppose
//! that q_n = ℓ_{n+1} / ℓ_n ≥ Q_a after an impact on a, or Q_b after one on b, and
//! that h_n = K τ_n / ℓ_{n+1} ≤ H. Let r_a = (e / Q_a + H / 2) / Q_b. If
//!
//! > κ_b c - e / Q_a - H (1 + r_a) ≥ Q_b and r_a ≤ Q_b,
//!
//! m and a approach at no less than Q_b ℓ_{n+1} for a time r_a τ_n, which is
//! enough to close the gap. Hence τ_{n+1} ≤ r_a τ_n, q_{n+1} ≥ Q_b and
//! h_{n+1} ≤ h_n r_a / Q_b ≤ H. If the same holds with a and b exchanged, the
//! two go on for ever, and r_a r_b < 1 bounds the sum of the intervals by
//! S = τ_0 (1 + r_a) / (1 - r_a r_b). Meanwhile the pair that does not approach
//! parts, since g'' ≥ 0.
//!
//! For Q serves a little less than the ratio to which q tends on a line. The
//! conditions then hold for small H if that ratio is above the cube root of e;
//! between that and the threshold on a line the curvature of the paths
//! prevails in the end, unless the discs are on a line exactly.
//!
//! All is computed in binary64 bounds, from differences that the arithmetic
//! itself computes.

use std::cmp::Ordering::Greater;

use super::Accumulation;
use crate::body::{BodyId, Disc, Mass, Pair};
use crate::kernel::Kernel;
use crate::respond::Restitution;
use crate::scalar::{Interval, Scalar};
use crate::timeline::{Timed, Timeline};
use crate::vec2::Vec2;
use crate::world::{Obstacle, World};

/// The part of the limit's time up to which its bounds must be close: 22
/// digits.
const TIGHT: f64 = 1e-22;

/// By how much Q is less than the ratio to which q tends.
const SLACK: f64 = 1.0 / 16.0;

/// Three discs that are proven to collide for ever, if left alone.
pub(super) struct Cascade {
    discs: [usize; 3],
    /// A bound of the time that is left.
    rest: f64,
    /// Bounds of how far each disc gets.
    travels: [f64; 3],
}

/// Three discs as they are after an impact of the first two: the middle one, a
/// and b.
struct Three<S> {
    discs: [Disc<S>; 3],
    masses: [S; 3],
    restitution: S,
}

/// What their motion until the limit depends on.
struct Motion {
    /// W.
    speed: Interval,
    /// Bounds of the speeds of each disc.
    speeds: [Interval; 3],
    /// R_a and R_b.
    reaches: [Interval; 2],
    /// κ_a and κ_b.
    kicks: [Interval; 2],
    restitution: Interval,
    /// ℓ_0, and how fast m and b approach.
    approaches: [Interval; 2],
    gap: Interval,
    /// c_0.
    cosine: Interval,
}

impl<S: Timed> Timeline<S> {
    /// The proof that a disc, which has just hit the first of two others, goes
    /// on to collide with them for ever.
    pub(super) fn cascade(&self, middle: usize, sides: [BodyId; 2]) -> Option<Cascade> {
        let [BodyId::Disc(a), BodyId::Disc(b)] = sides else {
            return None;
        };
        let discs = [middle, a as usize, b as usize];
        let motion = self.three(discs)?.motion();
        let rest = motion.time_left()?;
        let travel = |speed: Interval| (speed * Interval::new(rest, rest)).hi();
        Some(Cascade {
            discs,
            rest,
            travels: motion.speeds.map(travel),
        })
    }

    fn three(&self, discs: [usize; 3]) -> Option<Three<S>> {
        let Restitution::Newton {
            discs: restitution,
            elastic_below: None,
            ..
        } = &self.flights.world.restitution
        else {
            return None;
        };
        let discs = discs.map(|disc| self.flights.disc_at(disc, &self.now));
        let mass = |disc: &Disc<S>| match &disc.mass {
            Mass::Finite(mass) => Some(mass.clone()),
            Mass::Infinite => None,
        };
        let masses = [mass(&discs[0])?, mass(&discs[1])?, mass(&discs[2])?];
        Some(Three {
            discs,
            masses,
            restitution: restitution.clone(),
        })
    }

    /// Whether the bounds of the limit are close.
    pub(super) fn is_tight(&self, cascade: &Cascade) -> bool {
        cascade.rest <= TIGHT * self.now.to_f64()
    }

    /// The accumulation, if nothing else touches the three before.
    pub(super) fn settle(&self, cascade: &Cascade) -> Option<Accumulation<S>> {
        let now = self.now.hull();
        let end = (now + Interval::new(0.0, cascade.rest)).hi();
        let span = Interval::new(now.lo(), end);
        let [middle, a, b] = cascade.discs;
        let is_one = |disc: usize| cascade.discs.contains(&disc);
        if !self.others_are_free(is_one, end) {
            return None;
        }
        let mut world = self.sweep(span);
        for (disc, travel) in cascade.discs.into_iter().zip(cascade.travels) {
            let range = Interval::new(-travel, travel);
            let place = self.flights.position_at(disc, &self.now).map(S::hull);
            world.discs[disc].position = place.plus(&Vec2::new(range, range));
        }
        let is_partner = |other| matches!(other, Obstacle::Disc(disc) if is_one(disc));
        let apart = |disc: &usize| super::alone::is_apart(&world, *disc, is_partner);
        let is_alone = cascade.discs.iter().all(apart) && are_apart(&world, a, b);
        is_alone.then(|| Accumulation {
            limit: [
                self.now.clone(),
                self.now.clone() + from_f64::<S>(cascade.rest),
            ],
            proven: true,
            word: [b, a].map(|side| pair(middle, side)).to_vec(),
        })
    }
}

fn are_apart(world: &World<Interval>, a: usize, b: usize) -> bool {
    matches!(world.overlap(a, Obstacle::Disc(b)), Ok(None))
}

fn pair(one: usize, other: usize) -> Pair {
    Pair::new(BodyId::Disc(one as u32), BodyId::Disc(other as u32))
}

/// A power of two that is not below a positive number, exactly.
fn from_f64<S: Kernel>(number: f64) -> S {
    let two = S::from_integer(2);
    let mut power = S::from_integer(1);
    let mut size = 1.0;
    while size > number && size > f64::MIN_POSITIVE {
        power = power / &two;
        size /= 2.0;
    }
    while size < number {
        power = power * &two;
        size *= 2.0;
    }
    power
}

impl<S: Kernel> Three<S> {
    fn motion(&self) -> Motion {
        let [middle, a, b] = &self.discs;
        let masses = self.masses.each_ref().map(S::hull);
        let energy = self.doubled_energy().hull();
        let speeds = masses.map(|mass| (energy / mass).sqrt());
        let reaches = [a, b].map(|side| (middle.radius.clone() + &side.radius).hull());
        let away = [a, b].map(|side| side.position.minus(&middle.position));
        let distance = away[1].norm_squared().sqrt();
        let normals = [
            away[0].map(S::hull).scaled(&inverse(reaches[0])),
            away[1].map(S::hull).scaled(&inverse(distance.hull())),
        ];
        let parting = |side: &Disc<S>, normal: &Vec2<Interval>| {
            let relative = side.velocity.minus(&middle.velocity);
            relative.map(S::hull).dot(normal)
        };
        let restitution = self.restitution.hull();
        let gain = Interval::from_integer(1) + restitution;
        let kick = |side: usize| gain * masses[side] / (masses[0] + masses[side]);
        let gap = distance - (middle.radius.clone() + &b.radius);
        let drift = self.centre_speed();
        Motion {
            speed: speeds[0] + larger(speeds[1], speeds[2]),
            speeds: speeds.map(|speed| speed + drift),
            reaches,
            kicks: [kick(1), kick(2)],
            approaches: [
                parting(a, &normals[0]) / restitution,
                -parting(b, &normals[1]),
            ],
            restitution,
            gap: gap.hull(),
            cosine: -normals[0].dot(&normals[1]),
        }
    }

    fn centre_velocity(&self) -> Vec2<S> {
        let mut momentum = Vec2::zero();
        let mut total = S::from_integer(0);
        for (disc, mass) in self.discs.iter().zip(&self.masses) {
            momentum = momentum.moved(&disc.velocity, mass);
            total = total + mass;
        }
        momentum.scaled(&(S::from_integer(1) / total))
    }

    fn centre_speed(&self) -> Interval {
        self.centre_velocity().map(S::hull).norm_squared().sqrt()
    }

    /// Twice the energy relative to the centre of mass.
    fn doubled_energy(&self) -> S {
        let centre = self.centre_velocity();
        let parts = self.discs.iter().zip(&self.masses);
        let energies = parts.map(|(disc, mass)| {
            let relative = disc.velocity.minus(&centre);
            relative.norm_squared() * mass
        });
        energies.fold(S::from_integer(0), |sum, energy| sum + energy)
    }
}

impl Motion {
    /// A bound of the time that is left, if they are proven to collide for
    /// ever.
    fn time_left(&self) -> Option<f64> {
        let [before, approach] = self.approaches;
        let [one, two, zero] = [1, 2, 0].map(Interval::from_integer);
        let [a, b] = self.reaches;
        let curvature = self.speed.square() * larger(inverse(a), inverse(b));
        // Within this time the gap closes, if half of the approach is left.
        let first = two * self.gap / approach;
        let speed = approach - curvature * first;
        let is_closing = is_over(before, zero) && is_over(speed * two, approach);
        let ratios = self.ratios().filter(|_| is_closing)?;
        let bend = curvature * first / speed;
        let shrinks = [0, 1].map(|side| {
            let [own, next] = [ratios[side], ratios[1 - side]];
            (self.restitution / own + bend / two) / next
        });
        let rest = first * (one + shrinks[0]) / (one - shrinks[0] * shrinks[1]);
        let turn = self.speed * (inverse(a) + inverse(b)) * rest;
        let cosine = self.cosine - turn;
        let lasts = [0, 1].map(|side| {
            let [own, next] = [ratios[side], ratios[1 - side]];
            let least = self.kicks[1 - side] * cosine
                - self.restitution / own
                - bend * (one + shrinks[side]);
            is_over(least, next) && is_over(next, shrinks[side]) && is_over(one, shrinks[side])
        });
        let starts = is_over(speed / before, ratios[0]);
        (starts && lasts == [true; 2] && rest.hi().is_finite()).then(|| rest.hi())
    }

    /// Q_a and Q_b: any numbers do, so the middles of bounds serve.
    fn ratios(&self) -> Option<[Interval; 2]> {
        let e = middle(self.restitution);
        let kicks = self.kicks.map(|kick| middle(kick) * middle(self.cosine));
        let trace = kicks[0] * kicks[1] - 2.0 * e;
        let discriminant = trace * trace - 4.0 * e * e;
        let root = (trace + discriminant.sqrt()) / 2.0;
        let ratio = |kick: f64| (e + root) / kick * (1.0 - SLACK);
        let ratios = [ratio(kicks[1]), ratio(kicks[0])];
        let are_good = ratios.iter().all(|ratio| ratio.is_finite() && *ratio > 0.0);
        are_good.then(|| ratios.map(|ratio| Interval::new(ratio, ratio)))
    }
}

fn inverse(number: Interval) -> Interval {
    Interval::from_integer(1) / number
}

fn larger(one: Interval, other: Interval) -> Interval {
    Interval::new(one.lo().max(other.lo()), one.hi().max(other.hi()))
}

fn middle(number: Interval) -> f64 {
    f64::midpoint(number.lo(), number.hi())
}

/// Whether a number is proven to be greater than another.
fn is_over(one: Interval, other: Interval) -> bool {
    one.compare(&other) == Ok(Greater)
}
