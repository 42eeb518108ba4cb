//! Three bodies on a line: a disc m between a and b, with which it collides
//! in turn.
//!
//! Let ℓ_n be the speed at which m and its partner approach in the n-th
//! impact, e_a and e_b the coefficients of restitution, and s_a the part of
//! the relative change of velocity that m takes in an impact on a. An impact
//! on a turns ℓ into the opening speed e_a ℓ and adds κ_a ℓ to the approach of
//! m and b, where κ_a = (1 + e_a) s_a. Hence, after an impact on a,
//!
//! > ℓ_{n+2} = κ_b ℓ_{n+1} - e_a ℓ_n,
//!
//! and in turn with a and b exchanged. For every second impact this gives
//! ℓ_{n+4} = T ℓ_{n+2} - D ℓ_n with T = κ_a κ_b - e_a - e_b and D = e_a e_b,
//! the trace and the determinant of two impacts. A third body is always there
//! to be hit unless an ℓ fails to be positive, so only velocities count:
//!
//! - If T ≤ 0 or T² < 4 D, some ℓ is not positive: there are finitely many
//!   impacts. For three equal discs that is e > 7 - 4√3.
//! - Otherwise both roots μ1 ≥ μ2 of μ² - T μ + D are real, and not negative.
//!   m_{n+1} = ρ m_n with ρ = (e_a + μ2) / κ_b starts the solution that every
//!   second time is multiplied by μ2. All ℓ are positive if and only if
//!   ℓ_1 ≥ ρ ℓ_0.
//!
//! The intervals follow from the gap e ℓ_n τ_n that the next impact leaves:
//! τ_{n+1} = e ℓ_n τ_n / ℓ_{n+2}, so that τ_n ℓ_n ℓ_{n+1} is multiplied by e
//! each time. So is ℓ_n m_{n+1} - ℓ_{n+1} m_n, and the intervals are
//! multiples of m_{n+1} / ℓ_{n+1} - m_n / ℓ_n: their sum telescopes. It is
//! finite if ℓ_1 > ρ ℓ_0, for then m_n / ℓ_n tends to zero, and with the gap
//! g = τ_0 ℓ_1 between m and b at the impact on a
//!
//! > t* = t_0 + g / (ℓ_1 - ρ ℓ_0).
//!
//! With ℓ_1 = ρ ℓ_0 the intervals do not even shrink. In terms of the speed
//! o = e_a ℓ_0 at which m and a part, ρ ℓ_0 = o (1 + e_b / μ1) / κ_b, which
//! holds for e_a = 0 too: then all impacts are at t_0, and so is t*.
//!
//! Between bodies of infinite mass s = 1, hence T = 1 + D, μ1 = 1, ρ = e_a and
//! ℓ_1 - ρ ℓ_0 is the speed at which a and b approach: m is squeezed until
//! they leave no room, whatever e is, also one that differs from impact to
//! impact.
//!
//! Source of the condition: McNamara and Young, Inelastic collapse and
//! clumping in a one-dimensional granular medium, 1992; with unequal masses
//! as Zhou and Kadanoff, Inelastic collapse of three particles, 1996. All is
//! exact but the root of T² - 4 D.

use std::cmp::Ordering::{Equal, Greater, Less};

use super::Accumulation;
use crate::body::{BodyId, Disc, Mass, Pair};
use crate::kernel::Kernel;
use crate::respond::{Restitution, Share, shares};
use crate::timeline::flight::Flights;
use crate::vec2::Vec2;

/// What becomes of a disc between two bodies.
pub(super) enum Fate<S> {
    /// The three collide for ever, before a finite time.
    Collapses(Trio<S>),
    /// They do not.
    Parts,
    /// They are not on a line, or a decision is open.
    Unknown,
}

/// A disc between two bodies on a line, with which it collides for ever.
pub(super) struct Trio<S> {
    pub(super) middle: usize,
    /// The one that it has just hit, and the other.
    pub(super) sides: [Side<S>; 2],
    /// The unit vector from the middle one to the one just hit.
    pub(super) unit: Vec2<S>,
    /// What the middle one and the other are apart.
    pub(super) gap: S,
    /// The velocity to which those of finite mass tend, unless only the middle
    /// one has it.
    pub(super) last_velocity: Vec2<S>,
    pub(super) limit: S,
}

/// A body beside the middle one.
pub(super) struct Side<S> {
    pub(super) body: BodyId,
    /// Its velocity; a wall's is that of the middle one along it.
    pub(super) velocity: Vec2<S>,
    pub(super) mass: Mass<S>,
    /// The distance at which it touches the middle one.
    reach: S,
    restitution: S,
    /// The part of the relative change of velocity that the middle one takes.
    share: S,
}

/// What becomes of a disc that at `now` has hit the first of two bodies, and
/// before that the other.
pub(super) fn fate<S: Kernel>(
    flights: &Flights<S>,
    now: &S,
    middle: usize,
    sides: [BodyId; 2],
) -> Fate<S> {
    let setting = Setting {
        flights,
        now,
        middle: flights.disc_at(middle, now),
    };
    let Some(mut trio) = setting.line_up(middle, sides) else {
        return Fate::Unknown;
    };
    match time_left(&trio, &setting.middle.velocity) {
        Ok(Some(time)) => {
            trio.limit = now.clone() + time;
            Fate::Collapses(trio)
        }
        Ok(None) => Fate::Parts,
        Err(_) => Fate::Unknown,
    }
}

impl<S: Kernel> Trio<S> {
    pub(super) fn accumulation(&self, proven: bool) -> Accumulation<S> {
        let middle = BodyId::Disc(self.middle as u32);
        let [latest, other] = &self.sides;
        Accumulation {
            limit: [self.limit.clone(), self.limit.clone()],
            proven,
            word: vec![
                Pair::new(middle, other.body),
                Pair::new(middle, latest.body),
            ],
        }
    }
}

/// The time until the limit, if there is one.
fn time_left<S: Kernel>(trio: &Trio<S>, velocity: &Vec2<S>) -> Result<Option<S>, S::Doubt> {
    let [a, b] = &trio.sides;
    let speed = |side: &Side<S>| side.velocity.minus(velocity).dot(&trio.unit);
    let (opening, approach) = (speed(a), speed(b));
    let one = S::from_integer(1);
    let [kick_a, kick_b] = [a, b].map(|side| (one.clone() + &side.restitution) * &side.share);
    let trace = kick_a * &kick_b - &a.restitution - &b.restitution;
    let determinant = a.restitution.clone() * &b.restitution;
    let discriminant = trace.square() - S::from_integer(4) * determinant;
    if trace.sign()? != Greater || discriminant.sign()? == Less {
        return Ok(None);
    }
    let root = (trace + discriminant.sqrt()) / S::from_integer(2);
    let least = opening * (one + b.restitution.clone() / root) / kick_b;
    let margin = approach - least;
    let lasts = margin.sign()? == Greater;
    Ok(lasts.then(|| trio.gap.clone() / margin))
}

/// Where and when three bodies are looked at.
struct Setting<'a, S: Kernel> {
    flights: &'a Flights<S>,
    now: &'a S,
    middle: Disc<S>,
}

impl<S: Kernel> Setting<'_, S> {
    /// The three, if they are proven to be and to move on a line.
    fn line_up(&self, middle: usize, [a, b]: [BodyId; 2]) -> Option<Trio<S>> {
        let towards = self.offset(a);
        let unit = match a {
            BodyId::Disc(_) => towards.scaled(&(S::from_integer(1) / self.reach(a))),
            BodyId::Wall(wall) => self.across(wall, &towards)?,
        };
        let sides = [self.side(a, &unit)?, self.side(b, &unit)?];
        let offset = self.offset(b);
        let straight = match b {
            BodyId::Disc(_) => offset.clone(),
            BodyId::Wall(wall) => self.along(wall).perpendicular(),
        };
        let distance = -offset.dot(&unit);
        let is_line = is_zero(&straight.cross(&unit)) && matches!(distance.sign(), Ok(Greater));
        let gap = distance - &sides[1].reach;
        let trio = Trio {
            middle,
            unit,
            last_velocity: self.last_velocity(&sides),
            limit: gap.clone(),
            gap,
            sides,
        };
        is_line.then_some(trio)
    }

    /// That of the body of infinite mass, or of the centre of mass.
    fn last_velocity(&self, sides: &[Side<S>; 2]) -> Vec2<S> {
        let mut momentum = Vec2::zero();
        let mut total = S::from_integer(0);
        let middle = (&self.middle.mass, &self.middle.velocity);
        let sides = sides.iter().map(|side| (&side.mass, &side.velocity));
        for (mass, velocity) in sides.chain([middle]) {
            let Mass::Finite(mass) = mass else {
                return velocity.clone();
            };
            momentum = momentum.moved(velocity, mass);
            total = total + mass;
        }
        momentum.scaled(&(S::from_integer(1) / total))
    }

    /// A body beside the middle one, if the two move on the line.
    fn side(&self, body: BodyId, unit: &Vec2<S>) -> Option<Side<S>> {
        let velocity = self.velocity(body, unit);
        let relative = velocity.minus(&self.middle.velocity);
        let mass = self.mass(body);
        let side = Side {
            body,
            velocity,
            reach: self.reach(body),
            restitution: self.restitution(body, &mass)?,
            share: match shares(&self.middle.mass, &mass).0 {
                Share::Part(part) => part,
                Share::Whole => S::from_integer(1),
                Share::Nothing => return None,
            },
            mass,
        };
        let is_on_line = matches!(body, BodyId::Wall(_)) || is_zero(&relative.cross(unit));
        is_on_line.then_some(side)
    }

    /// The unit vector across a wall, towards it.
    fn across(&self, wall: u32, towards: &Vec2<S>) -> Option<Vec2<S>> {
        let length = &self.flights.world.walls[wall as usize].segment.length;
        let across = self.along(wall).perpendicular();
        let unit = across.scaled(&(S::from_integer(1) / length));
        match towards.dot(&unit).sign().ok()? {
            Less => Some(-unit),
            Equal => None,
            Greater => Some(unit),
        }
    }

    fn along(&self, wall: u32) -> &Vec2<S> {
        &self.flights.world.walls[wall as usize].segment.along
    }

    /// From the middle one to a disc, or to a point of a wall.
    fn offset(&self, body: BodyId) -> Vec2<S> {
        let walls = &self.flights.world.walls;
        let target = match body {
            BodyId::Disc(disc) => self.flights.position_at(disc as usize, self.now),
            BodyId::Wall(wall) => walls[wall as usize].segment.from.clone(),
        };
        target.minus(&self.middle.position)
    }

    fn reach(&self, body: BodyId) -> S {
        let radius = self.middle.radius.clone();
        match body {
            BodyId::Disc(disc) => radius + &self.flights.world.discs[disc as usize].radius,
            BodyId::Wall(_) => radius,
        }
    }

    fn velocity(&self, body: BodyId, unit: &Vec2<S>) -> Vec2<S> {
        match body {
            BodyId::Disc(disc) => self.flights.world.discs[disc as usize].velocity.clone(),
            BodyId::Wall(_) => {
                let velocity = &self.middle.velocity;
                velocity.moved(unit, &-velocity.dot(unit))
            }
        }
    }

    fn mass(&self, body: BodyId) -> Mass<S> {
        match body {
            BodyId::Disc(disc) => self.flights.world.discs[disc as usize].mass.clone(),
            BodyId::Wall(_) => Mass::Infinite,
        }
    }

    /// The coefficient of every impact to come, if it is known. Where it
    /// depends on the speed, that of an elastic one stands for it between
    /// bodies of infinite mass; others do not collapse.
    fn restitution(&self, body: BodyId, mass: &Mass<S>) -> Option<S> {
        match &self.flights.world.restitution {
            Restitution::Elastic => Some(S::from_integer(1)),
            Restitution::Newton {
                elastic_below: Some(_),
                ..
            } => matches!(mass, Mass::Infinite).then(|| S::from_integer(1)),
            Restitution::Newton { discs, walls, .. } => Some(match body {
                BodyId::Disc(_) => discs.clone(),
                BodyId::Wall(_) => walls.clone(),
            }),
            Restitution::Paper { .. } => None,
        }
    }
}

fn is_zero<S: Kernel>(number: &S) -> bool {
    matches!(number.sign(), Ok(Equal))
}
