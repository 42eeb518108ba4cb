//! Bodies that overlap without a direction: concentric discs, and discs whose
//! centre is on a wall. They do not collide until they have parted.

use std::cmp::Ordering;

use crate::body::Feature;
use crate::kernel::Kernel;
use crate::world::{Obstacle, World};

/// The pairs that have not parted from such a start.
#[derive(Clone, Debug, Default)]
pub(super) struct Nested {
    pairs: Vec<(usize, Obstacle)>,
}

impl Nested {
    /// The pairs that start so, each with the lower disc first.
    pub(super) fn find<S: Kernel>(world: &World<S>) -> Self {
        let mut pairs = world.close_pairs();
        pairs.retain(|&(disc, obstacle)| match obstacle {
            Obstacle::Disc(other) => is_concentric(world, disc, other),
            Obstacle::Wall(wall) => is_on_wall(world, disc, wall),
        });
        Self { pairs }
    }

    /// Whether a disc has not parted from an obstacle.
    #[inline]
    pub(super) fn holds(&self, disc: usize, obstacle: Obstacle) -> bool {
        let pair = match obstacle {
            Obstacle::Disc(other) => (disc.min(other), Obstacle::Disc(disc.max(other))),
            Obstacle::Wall(_) => (disc, obstacle),
        };
        !self.pairs.is_empty() && self.pairs.contains(&pair)
    }

    /// Forgets a pair that has collided, and thus parted before. The corner
    /// that a disc collides with may be that of another wall, while it still
    /// `overlaps` the one that it is nested in.
    pub(super) fn part<S: Kernel>(
        &mut self,
        world: &World<S>,
        disc: usize,
        feature: Feature,
        overlaps: impl Fn(usize) -> bool,
    ) {
        self.pairs.retain(|&pair| {
            let is_nested = match (pair.1, feature) {
                (Obstacle::Wall(wall), Feature::Corner(_)) => overlaps(wall),
                _ => false,
            };
            is_nested || !is_of(world, pair, disc, feature)
        });
    }
}

fn is_of<S: Kernel>(
    world: &World<S>,
    (first, obstacle): (usize, Obstacle),
    disc: usize,
    feature: Feature,
) -> bool {
    match (obstacle, feature) {
        (Obstacle::Disc(second), Feature::Disc(other)) => {
            let other = other as usize;
            (first, second) == (disc.min(other), disc.max(other))
        }
        (Obstacle::Wall(own), Feature::Wall(wall)) => first == disc && own == wall as usize,
        (Obstacle::Wall(own), Feature::Corner(corner)) => {
            first == disc && world.walls[own].corners.contains(&corner)
        }
        _ => false,
    }
}

fn is_concentric<S: Kernel>(world: &World<S>, one: usize, other: usize) -> bool {
    let [one, other] = [one, other].map(|disc| &world.discs[disc].position);
    let equal = |a: &S, b: &S| a.compare(b).is_ok_and(Ordering::is_eq);
    equal(&one.x, &other.x) && equal(&one.y, &other.y)
}

fn is_on_wall<S: Kernel>(world: &World<S>, disc: usize, wall: usize) -> bool {
    let segment = &world.walls[wall].segment;
    let offset = world.discs[disc].position.minus(&segment.from);
    offset
        .cross(&segment.along)
        .sign()
        .is_ok_and(Ordering::is_eq)
        && matches!(world.overlap(disc, Obstacle::Wall(wall)), Ok(Some((_, overlap))) if overlap.separation.is_none())
}
