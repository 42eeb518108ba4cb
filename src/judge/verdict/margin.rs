//! How close the decision was in which a log differs.
//!
//! From the exact state after the last impact before, all goes on as if nothing
//! collided. What the log has instead of the true impact may then happen later, or not at
//! all: by how much later, or by how much the two bodies pass each other. Likewise by how
//! much the bodies of an impact that it misses would enter each other.

use std::cmp::Ordering;

use super::carry::{Carry, ROUNDING};
use crate::body::{BodyId, Disc, Pair};
use crate::detect::{End, Segment, meet_circle, meet_segment};
use crate::judge::Difference;
use crate::judge::tally::ulp;
use crate::playback::Playback;
use crate::scalar::{Exact, Number, Scalar, Undecided};
use crate::scene::Scene;
use crate::vec2::Vec2;
use crate::world::World;

/// How close a decision was.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct Margin {
    /// What was decided.
    pub of: Decision,
    /// By how much: of an order the time between two impacts, of a meeting the length by
    /// which two bodies pass, or would enter each other, of an end the time between.
    pub value: f64,
    /// The same in ulps of the time, or of the distance at which the two touch.
    pub ulps: f64,
    /// What binary64 resolves there.
    pub resolution: f64,
}

/// What a margin is that of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "json",
    derive(serde::Serialize),
    serde(rename_all = "kebab-case")
)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub enum Decision {
    /// Which of two impacts comes first.
    Order,
    /// Whether two bodies meet.
    Meeting,
    /// Whether an impact is before the end of the run.
    End,
}

impl Margin {
    /// Whether bodies pass in tangency, as far as exact arithmetic tells.
    pub fn is_tangent(&self) -> bool {
        self.of == Decision::Meeting && self.value == 0.0
    }

    /// Whether that is closer than binary64 resolves.
    pub fn is_close(&self) -> bool {
        self.closeness() <= 1.0
    }

    /// The margin in terms of what binary64 resolves.
    fn closeness(&self) -> f64 {
        self.value / self.resolution
    }
}

/// The state in which a log takes another course than the truth.
pub(super) struct Question<'a> {
    difference: &'a Difference,
    end: f64,
    /// The bodies, and the time at which they are there; none where motion is not
    /// straight.
    state: Option<(World<Exact>, Exact)>,
}

/// What two bodies come to, if nothing else happens.
enum Fate {
    /// They meet at this time.
    Meet(f64),
    /// They do not: by how much, and how fast they pass.
    Pass { length: f64, reach: f64, speed: f64 },
}

impl<'a> Question<'a> {
    pub(super) fn new(scene: &Scene, end: &Number, bits: u32, difference: &'a Difference) -> Self {
        let effects = scene.effects();
        let is_straight =
            effects.gravity.is_none() && effects.drag.is_none() && scene.periodic().is_none();
        Self {
            difference,
            end: end.to_f64(),
            state: is_straight
                .then(|| state(scene, end, bits, difference))
                .flatten(),
        }
    }

    /// The closest of the decisions that the log may have taken otherwise.
    pub(super) fn margin(&self, carry: &Carry) -> Option<Margin> {
        let Difference {
            truth, candidate, ..
        } = *self.difference;
        let instead = candidate.and_then(|(pair, _)| self.instead(pair, truth, carry));
        let missed = truth.and_then(|(pair, _)| self.depth(pair, carry));
        let late = match candidate {
            Some(_) => None,
            None => truth.map(|(_, time)| self.apart(Decision::End, time, self.end, carry)),
        };
        let margins = [instead, missed, late].into_iter().flatten();
        margins.min_by(|one, other| one.closeness().total_cmp(&other.closeness()))
    }

    /// How close it was that a pair collides instead of another.
    fn instead(&self, pair: Pair, truth: Option<(Pair, f64)>, carry: &Carry) -> Option<Margin> {
        match (self.fate(pair)?, truth) {
            (Fate::Meet(time), Some((_, first))) => {
                Some(self.apart(Decision::Order, first, time, carry))
            }
            (Fate::Meet(time), None) if time >= self.end => {
                Some(self.apart(Decision::End, self.end, time, carry))
            }
            // What it says is no first impact.
            (Fate::Meet(_), None) => None,
            (pass, _) => self.room(&pass, carry),
        }
    }

    /// How close one time is to another.
    fn apart(&self, of: Decision, first: f64, other: f64, carry: &Carry) -> Margin {
        let value = (other - first).abs();
        Margin {
            of,
            value,
            ulps: value / ulp(first),
            resolution: carry.resolution(first),
        }
    }

    /// How far a pair that collides would enter each other.
    fn depth(&self, pair: Pair, carry: &Carry) -> Option<Margin> {
        let (world, _) = self.state.as_ref()?;
        self.room(&Couple::of(world, pair)?.nearest()?, carry)
    }

    /// What a pair comes to, if nothing else happens; none where they touch already.
    fn fate(&self, pair: Pair) -> Option<Fate> {
        let (world, now) = self.state.as_ref()?;
        let couple = Couple::of(world, pair)?;
        match couple.meet() {
            Ok(Some(delay)) => Some(Fate::Meet((now.clone() + delay).to_f64())),
            Ok(None) => couple.nearest(),
            Err(_) => couple.nearest().map(Fate::touching),
        }
    }

    fn room(&self, pass: &Fate, carry: &Carry) -> Option<Margin> {
        let Fate::Pass {
            length,
            reach,
            speed,
        } = *pass
        else {
            return None;
        };
        let time = self.difference.time;
        Some(Margin {
            of: Decision::Meeting,
            value: length,
            ulps: length / ulp(reach),
            resolution: (carry.resolution(time) * speed).max(ROUNDING * ulp(reach)),
        })
    }
}

impl Fate {
    fn length(&self) -> f64 {
        match self {
            Self::Pass { length, .. } => *length,
            Self::Meet(_) => f64::INFINITY,
        }
    }

    /// The same passage, of which it is open whether the two touch.
    fn touching(self) -> Self {
        match self {
            Self::Pass { reach, speed, .. } => Self::Pass {
                length: 0.0,
                reach,
                speed,
            },
            meet @ Self::Meet(_) => meet,
        }
    }
}

/// A disc, and what it may meet.
enum Couple<'a> {
    Discs([&'a Disc<Exact>; 2]),
    Wall(&'a Disc<Exact>, &'a Segment<Exact>),
}

impl<'a> Couple<'a> {
    fn of(world: &'a World<Exact>, pair: Pair) -> Option<Self> {
        let disc = |body| match body {
            BodyId::Disc(index) => world.discs.get(index as usize),
            BodyId::Wall(_) => None,
        };
        let first = disc(pair.a)?;
        match pair.b {
            BodyId::Disc(_) => Some(Self::Discs([first, disc(pair.b)?])),
            BodyId::Wall(wall) => {
                let wall = world.walls.get(wall as usize)?;
                Some(Self::Wall(first, &wall.segment))
            }
        }
    }

    /// How long it takes them to meet, if they do.
    fn meet(&self) -> Result<Option<Exact>, Undecided> {
        let met = match self {
            Self::Discs([one, other]) => {
                let reach = one.radius.clone() + &other.radius;
                let (offset, velocity) = relative(one, other);
                meet_circle(&offset, &velocity, &reach)?
            }
            Self::Wall(disc, wall) => {
                let Disc {
                    position,
                    velocity,
                    radius,
                    ..
                } = disc;
                meet_segment(position, velocity, radius, wall, |_| false)?
            }
        };
        Ok(met.filter(|met| !met.graze).map(|met| met.delay))
    }

    /// How they pass, where they come nearest: a wall at an end, unless the path crosses
    /// it.
    fn nearest(&self) -> Option<Fate> {
        match self {
            Self::Discs([one, other]) => {
                let reach = one.radius.clone() + &other.radius;
                let (offset, velocity) = relative(one, other);
                passage(&offset, &velocity, &reach)
            }
            Self::Wall(disc, wall) if crosses(disc, wall) => Some(Fate::Pass {
                length: disc.radius.to_f64(),
                reach: disc.radius.to_f64(),
                speed: disc.velocity.norm_squared().to_f64().sqrt(),
            }),
            Self::Wall(disc, wall) => {
                let ends = [End::From, End::To].map(|end| {
                    let offset = disc.position.minus(wall.end(end));
                    passage(&offset, &disc.velocity, &disc.radius)
                });
                let ends = ends.into_iter().flatten();
                ends.min_by(|one, other| one.length().total_cmp(&other.length()))
            }
        }
    }
}

/// Where a disc is and how it moves, seen from another.
fn relative(one: &Disc<Exact>, other: &Disc<Exact>) -> (Vec2<Exact>, Vec2<Exact>) {
    let offset = other.position.minus(&one.position);
    (offset, other.velocity.minus(&one.velocity))
}

/// Whether a disc's centre gets to a wall: to binary64, for then it is far from the ends.
fn crosses(disc: &Disc<Exact>, wall: &Segment<Exact>) -> bool {
    let offset = disc.position.minus(&wall.from);
    let side = offset.cross(&wall.along).to_f64();
    let drift = disc.velocity.cross(&wall.along).to_f64();
    let [start, speed] = [&offset, &disc.velocity].map(|vector| vector.dot(&wall.along).to_f64());
    let time = -side / drift;
    let foot = (start + speed * time) / wall.length_squared.to_f64();
    time > 0.0 && (0.0..=1.0).contains(&foot)
}

/// How a point passes a circle about the origin, if it comes nearer or rests: its least
/// distance d from the origin, with d² = x² - (x·v)² / v², is off the radius R by
/// (d² - R²) / 2R, as long as that is little.
fn passage(offset: &Vec2<Exact>, velocity: &Vec2<Exact>, reach: &Exact) -> Option<Fate> {
    let (approach, squared) = (offset.dot(velocity), velocity.norm_squared());
    let distance = offset.norm_squared();
    let nearest = match (squared.sign(), approach.sign()) {
        (Ok(Ordering::Equal), _) => distance,
        (_, Ok(Ordering::Equal | Ordering::Greater)) => return None,
        _ => distance - &(approach.square() / &squared),
    };
    let double = reach.clone() + reach;
    let length = (nearest - &reach.square()) / &double;
    let is_open = length.sign().is_ok_and(Ordering::is_eq) || length.sign().is_err();
    Some(Fate::Pass {
        length: if is_open { 0.0 } else { length.to_f64().abs() },
        reach: reach.to_f64(),
        speed: squared.to_f64().sqrt(),
    })
}

/// The exact state after the last true impact before a difference, and its time.
fn state(
    scene: &Scene,
    end: &Number,
    bits: u32,
    difference: &Difference,
) -> Option<(World<Exact>, Exact)> {
    let mut playback = Playback::<Exact>::until(scene, end, bits).ok()?;
    for impact in playback.impacts().take(difference.followed) {
        impact.ok()?;
    }
    let mut world = World::new(scene, bits);
    world.discs = playback.discs();
    Some((world, playback.time().clone()))
}
