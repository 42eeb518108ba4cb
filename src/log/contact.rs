//! Where two bodies touch, and what becomes of them.

use std::cmp::Ordering;

use super::quantity::Quantity;
use crate::arithmetic::Arithmetic;
use crate::body::BodyId;
use crate::impact::{self, Impact};
use crate::vec2::Vec2;
use crate::world::World;

/// The circumstances of an impact.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct Contact {
    /// Where the bodies touch; of discs that overlap, the point of the first
    /// one's rim that is nearest to the second one.
    pub point: [Quantity; 2],
    /// The unit vector from the first body to the second one.
    pub normal: [Quantity; 2],
    /// The first body's velocity after the impact.
    pub velocity_a: [Quantity; 2],
    /// The second body's velocity after the impact, unless it is a wall.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "[Quantity; 2]"))]
    pub velocity_b: Option<[Quantity; 2]>,
}

impl Contact {
    /// The circumstances of an impact in a world, with so many digits.
    pub(super) fn new<S: Arithmetic>(
        world: &World<S>,
        impact: &Impact<S>,
        contact: &impact::Contact<S>,
        digits: u32,
    ) -> Self {
        let vector = |vector: &Vec2<S>| -> [Quantity; 2] {
            [&vector.x, &vector.y].map(|number| Quantity::new(number, digits))
        };
        let (point, direction) = touching(world, impact, contact);
        Self {
            point: vector(&point),
            normal: vector(&unit(&direction)),
            velocity_a: vector(&contact.velocity),
            velocity_b: contact.other_velocity.as_ref().map(vector),
        }
    }
}

/// The point of contact, and the direction from the first body to the second.
fn touching<S: Arithmetic>(
    world: &World<S>,
    impact: &Impact<S>,
    contact: &impact::Contact<S>,
) -> (Vec2<S>, Vec2<S>) {
    let (centre, normal) = (&contact.centre, &contact.normal);
    let wall = match impact.pair.b {
        BodyId::Disc(_) => return (rim(world, impact.pair.a, contact), normal.clone()),
        BodyId::Wall(wall) => &world.walls[wall as usize].segment,
    };
    match impact.end {
        Some(end) => (wall.end(end).clone(), normal.clone()),
        None => foot(centre, normal, &wall.from),
    }
}

/// The point of the first disc's rim that is nearest to the second one.
fn rim<S: Arithmetic>(world: &World<S>, first: BodyId, contact: &impact::Contact<S>) -> Vec2<S> {
    match first {
        BodyId::Disc(disc) => {
            let radius = &world.discs[disc as usize].radius;
            contact.centre.moved(&unit(&contact.normal), radius)
        }
        // The first body of a pair is a disc.
        BodyId::Wall(_) => contact.centre.clone(),
    }
}

/// The foot of the perpendicular from a centre to the line through a point
/// with that normal, and the normal in the direction of the line.
fn foot<S: Arithmetic>(centre: &Vec2<S>, normal: &Vec2<S>, point: &Vec2<S>) -> (Vec2<S>, Vec2<S>) {
    let distance = point.minus(centre).dot(normal) / normal.norm_squared();
    let is_behind = distance.sign().is_ok_and(Ordering::is_lt);
    let direction = if is_behind {
        -normal.clone()
    } else {
        normal.clone()
    };
    (centre.moved(normal, &distance), direction)
}

fn unit<S: Arithmetic>(direction: &Vec2<S>) -> Vec2<S> {
    let length = direction.norm_squared().sqrt();
    direction.map(|coordinate| coordinate.clone() / &length)
}
