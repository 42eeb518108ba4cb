//! Impacts, and what the log says of one.

use std::cmp::Ordering;

use crate::body::{Disc, End, Feature, Pair};
use crate::respond::{Normal, collide_discs, collide_wall};
use crate::scalar::Scalar;
use crate::vec2::Vec2;
use crate::world::World;

/// An impact, as it is logged (P3.4).
#[derive(Clone, Debug)]
pub struct Impact<S> {
    /// When it happens: for a frame algorithm on the clock of the pair's
    /// first body.
    pub time: S,
    /// The time on the other body's clock, where that differs.
    pub other_time: Option<S>,
    /// The two bodies.
    pub pair: Pair,
    /// The wall's end point that is hit, if it is one.
    pub end: Option<End>,
    /// The number of the group of impacts proven to be simultaneous.
    pub tie: Option<u32>,
    /// The frame and the pass in which a frame algorithm found it.
    pub step: Option<Step>,
    /// The circumstances.
    pub contact: Contact<S>,
}

/// Where in its run a frame algorithm found an impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Step {
    /// The frame, from zero on.
    pub frame: u64,
    /// The pass (or the sub-step) within the frame, from one on.
    pub pass: u32,
}

/// How two bodies touch, and what becomes of them.
#[derive(Clone, Debug)]
pub struct Contact<S> {
    /// Along the line on which they touch: of two discs from the first centre
    /// to the second one.
    pub normal: Vec2<S>,
    /// The first body's centre.
    pub centre: Vec2<S>,
    /// The first body's velocity after the impact.
    pub velocity: Vec2<S>,
    /// The other body's velocity after the impact, unless it is a wall.
    pub other_velocity: Option<Vec2<S>>,
}

impl<S: Scalar> World<S> {
    /// The line on which a disc touches a feature, another disc being where
    /// `other` says.
    pub(crate) fn normal(&self, disc: usize, feature: Feature, other: &Vec2<S>) -> Vec2<S> {
        let centre = &self.discs[disc].position;
        match feature {
            Feature::Disc(_) => other.minus(centre),
            Feature::Corner(corner) => self.corner_position(corner).minus(centre),
            Feature::Wall(wall) => self.walls[wall as usize].segment.along.perpendicular(),
        }
    }

    /// Applies the response to the impact of a disc on a feature, along a
    /// normal, and remembers that they part.
    pub(crate) fn collide(
        &mut self,
        disc: usize,
        feature: Feature,
        direction: Vec2<S>,
        overlap: bool,
    ) -> Result<Contact<S>, S::Doubt> {
        let normal = self.measured(disc, feature, direction, overlap);
        let other_velocity = match feature {
            Feature::Disc(other) => {
                let other = other as usize;
                let [first, second] = two(&mut self.discs, disc, other);
                collide_discs(first, second, &normal, &self.restitution)?;
                Some(second.velocity.clone())
            }
            Feature::Wall(_) | Feature::Corner(_) => {
                collide_wall(&mut self.discs[disc], &normal, &self.restitution)?;
                None
            }
        };
        self.remember(disc, feature);
        let body = &self.discs[disc];
        Ok(Contact {
            normal: normal.direction,
            centre: body.position.clone(),
            velocity: body.velocity.clone(),
            other_velocity,
        })
    }
}

impl<S: Scalar> World<S> {
    /// The normal with its square, by construction where that is known.
    fn measured(
        &self,
        disc: usize,
        feature: Feature,
        direction: Vec2<S>,
        overlap: bool,
    ) -> Normal<S> {
        let radius = &self.discs[disc].radius;
        match feature {
            Feature::Wall(wall) => {
                let squared = self.walls[wall as usize].segment.length_squared.clone();
                Normal { direction, squared }
            }
            _ if overlap => Normal::at_overlap(direction),
            Feature::Corner(_) => Normal::at_contact(direction, radius),
            Feature::Disc(other) => {
                let reach = radius.clone() + &self.discs[other as usize].radius;
                Normal::at_contact(direction, &reach)
            }
        }
    }

    /// Remembers that a disc and a feature part from each other.
    pub(crate) fn remember(&mut self, disc: usize, feature: Feature) {
        self.discs[disc].last = Some(feature);
        if let Feature::Disc(other) = feature {
            self.discs[other as usize].last = Some(Feature::Disc(disc as u32));
        }
    }
}

/// Two different discs.
pub(crate) fn two<S>(discs: &mut [Disc<S>], first: usize, second: usize) -> [&mut Disc<S>; 2] {
    discs
        .get_disjoint_mut([first, second])
        .expect("a disc does not collide with itself")
}

/// Gives each group of consecutive impacts that are proven to be simultaneous
/// a number. Computed times that round prove nothing.
pub fn number_ties<S: Scalar>(impacts: &mut [Impact<S>]) {
    if S::ROUNDS {
        return;
    }
    let mut next = 0;
    for later in 1..impacts.len() {
        let [before, after] = [later - 1, later].map(|index| &impacts[index].time);
        if before.compare(after).is_ok_and(Ordering::is_eq) {
            let tie = *impacts[later - 1].tie.get_or_insert_with(|| {
                next += 1;
                next - 1
            });
            impacts[later].tie = Some(tie);
        }
    }
}
