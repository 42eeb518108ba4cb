//! Velocities after an impact: those of exact arithmetic, rounded once.
//!
//! The normal n is that of the positions as they are stored, so the new
//! velocities are fractions: with w the relative velocity, e the coefficient of
//! restitution and M the total mass the first of two discs takes up
//! -(1 + e) (w·n) m₂ / (M n·n) times n. Each coordinate rounds to the nearest
//! binary64. If then, for the stored numbers, the bodies still approach, each
//! coordinate rounds away from the other body instead: so it is certain that
//! they do not. Bodies that do not approach before, on that normal, are left
//! as they are.
//!
//! Two words of floating point mostly tell what rounds to what ([`quick`]), and
//! whole numbers the rest ([`exact`]).

mod exact;
mod quick;

use super::course::{Line, coordinates};
use super::plane::Point;
use crate::body::Disc;
use crate::detect::Segment;
use crate::respond::Restitution;
use crate::scalar::Filtered;
use crate::vec2::Vec2;

/// Resolves the impact of two discs whose centres are at these places.
pub(super) fn collide_discs(
    discs: [&mut Disc<Filtered>; 2],
    centres: [&Vec2<Filtered>; 2],
    restitution: &Restitution<Filtered>,
) {
    let found = quick::discs(discs.each_ref().map(|disc| &**disc), centres, restitution);
    match found {
        Some(velocities) => {
            for (disc, velocity) in discs.into_iter().zip(velocities) {
                disc.velocity = velocity;
            }
        }
        None => exact::collide_discs(discs, centres, restitution),
    }
}

/// Resolves the impact of a disc, at some place, on a point.
pub(super) fn collide_point(
    disc: &mut Disc<Filtered>,
    [centre, point]: [&Vec2<Filtered>; 2],
    restitution: &Restitution<Filtered>,
) {
    let ends = [centre, point].map(coordinates);
    match quick::fixed(disc, ends, restitution) {
        Some(velocity) => disc.velocity = velocity,
        None => {
            let normal = Point::of(point).minus(&Point::of(centre));
            exact::collide_fixed(disc, normal, restitution);
        }
    }
}

/// Resolves the impact of a disc on the interior of a wall.
pub(super) fn collide_wall(
    disc: &mut Disc<Filtered>,
    wall: &Segment<Filtered>,
    restitution: &Restitution<Filtered>,
) {
    let line = Line::of(wall);
    match quick::wall(disc, &line, restitution) {
        Some(velocity) => disc.velocity = velocity,
        None => {
            let across = line.along().perpendicular();
            let towards = Point::of(&disc.velocity).dot(&across).sign();
            let normal = if towards.is_lt() {
                across.reversed()
            } else {
                across
            };
            exact::collide_fixed(disc, normal, restitution);
        }
    }
}
