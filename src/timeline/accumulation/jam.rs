//! A disc that is stuck from the start.
//!
//! It touches or overlaps bodies that do not move, and whichever way it goes it
//! approaches one of them: so each impact is followed by another at once. Between two
//! bodies that is so if they are opposite each other, and with three or more if the
//! directions away from them go all the way around. Elsewhere a disc gets out after
//! finitely many impacts. It cannot get into such a place, which has no room, so all
//! that is watched is time zero; and since even many impacts at once may end, only after
//! [`PATIENCE`] of them, and whenever there have been twice as many.

use std::cmp::Ordering::{Equal, Greater, Less};

use super::Accumulation;
use crate::body::{BodyId, Feature, Pair};
use crate::impact::Impact;
use crate::respond::Restitution;
use crate::scalar::Scalar;
use crate::timeline::{Timed, Timeline};
use crate::vec2::Vec2;
use crate::world::World;

/// So many impacts at time zero are nothing special.
const PATIENCE: usize = 64;

/// The impacts at time zero.
#[derive(Clone, Debug, Default)]
pub(in crate::timeline) struct Jams {
    count: usize,
    /// The latest half of them: discs, and the bodies at rest that they hit.
    latest: Vec<(usize, Feature)>,
}

impl<S: Timed> Timeline<S> {
    /// The end of the run, if its latest impact is of a disc that is stuck.
    pub(super) fn jam(&mut self, impact: &Impact<S>) -> Option<Accumulation<S>> {
        if impact.time.hull().hi() > 0.0 {
            return None;
        }
        let world = &self.flights.world;
        let hit = at_rest(world, impact);
        self.jams.latest.extend(hit);
        self.jams.count += 1;
        if self.jams.count < PATIENCE || !self.jams.count.is_power_of_two() {
            return None;
        }
        let latest = std::mem::take(&mut self.jams.latest);
        let (disc, _) = hit?;
        let mut partners: Vec<_> = latest.into_iter().filter(|(one, _)| *one == disc).collect();
        partners.sort();
        partners.dedup();
        let away = partners
            .iter()
            .map(|(_, feature)| away(world, disc, *feature));
        let away: Vec<_> = away.collect::<Result<_, _>>().ok()?;
        matches!(is_stuck(&away), Ok(true)).then(|| Accumulation {
            limit: [self.now.clone(), self.now.clone()],
            proven: !S::ROUNDS && matches!(world.restitution, Restitution::Elastic),
            word: word(world, &partners),
        })
    }
}

/// The disc of an impact with a body that does not move, and what it hit of that.
fn at_rest<S: Timed>(world: &World<S>, impact: &Impact<S>) -> Option<(usize, Feature)> {
    let Pair { a, b } = impact.pair;
    match (a, b) {
        (BodyId::Disc(disc), BodyId::Wall(wall)) => {
            Some((disc as usize, world.feature(wall as usize, impact.end)))
        }
        (BodyId::Disc(one), BodyId::Disc(other)) => {
            let rests = |disc: u32| world.rests_for_ever(disc as usize);
            match [rests(one), rests(other)] {
                [false, true] => Some((one as usize, Feature::Disc(other))),
                [true, false] => Some((other as usize, Feature::Disc(one))),
                _ => None,
            }
        }
        (BodyId::Wall(_), _) => None,
    }
}

/// The direction in which a disc parts from what it hits.
fn away<S: Timed>(world: &World<S>, disc: usize, feature: Feature) -> Result<Vec2<S>, S::Doubt> {
    let place = &world.discs[disc].position;
    match feature {
        Feature::Disc(other) => Ok(place.minus(&world.discs[other as usize].position)),
        Feature::Corner(corner) => Ok(place.minus(world.corner_position(corner))),
        Feature::Wall(wall) => {
            let segment = &world.walls[wall as usize].segment;
            let normal = segment.along.perpendicular();
            match normal.dot(&place.minus(&segment.from)).sign()? {
                Less => Ok(normal.scaled(&S::from_integer(-1))),
                Equal | Greater => Ok(normal),
            }
        }
    }
}

/// Whether no direction is away from all.
fn is_stuck<S: Scalar>(away: &[Vec2<S>]) -> Result<bool, S::Doubt> {
    if let [one, other] = away {
        let is_opposite = one.cross(other).sign()? == Equal && one.dot(other).sign()? == Less;
        return Ok(is_opposite);
    }
    for one in away {
        for other in away {
            if one.cross(other).sign()? != Greater {
                continue;
            }
            for third in away {
                let [next, back] = [other.cross(third), third.cross(one)];
                if next.sign()? == Greater && back.sign()? == Greater {
                    return Ok(true);
                }
            }
        }
    }
    Ok(false)
}

/// The pairs that go on colliding.
fn word<S: Timed>(world: &World<S>, partners: &[(usize, Feature)]) -> Vec<Pair> {
    let names = partners.iter();
    names
        .map(|(disc, feature)| world.names(*disc, *feature).0)
        .collect()
}
