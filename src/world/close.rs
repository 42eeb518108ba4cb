//! Which bodies are so close that they may overlap: the boxes about them do.
//!
//! The boxes are in binary64, rounded outwards. They are swept from left to right,
//! so that of many bodies most pairs are never looked at.

use super::{Obstacle, World};
use crate::body::{BodyId, Pair};
use crate::kernel::Kernel;
use crate::scalar::Interval;

/// The box about a body.
struct Bounds {
    x: Interval,
    y: Interval,
    body: BodyId,
}

impl Bounds {
    fn is_beside(&self, other: &Self) -> bool {
        self.y.lo() <= other.y.hi() && other.y.lo() <= self.y.hi()
    }
}

impl<S: Kernel> World<S> {
    /// Every disc with the discs after it and the walls that it may overlap, and
    /// with some that it does not.
    pub(crate) fn close_pairs(&self) -> Vec<(usize, Obstacle)> {
        let discs = (0..self.discs.len()).map(|disc| self.bounds_of_disc(disc));
        let walls = (0..self.walls.len()).map(|wall| self.bounds_of_wall(wall));
        let mut bounds: Vec<Bounds> = discs.chain(walls).collect();
        bounds.sort_unstable_by(|one, other| one.x.lo().total_cmp(&other.x.lo()));
        let mut pairs = Vec::new();
        for (place, one) in bounds.iter().enumerate() {
            let later = bounds[place + 1..].iter();
            let reached = later.take_while(|other| other.x.lo() <= one.x.hi());
            let close = reached.filter(|other| one.is_beside(other));
            pairs.extend(close.map(|other| Pair::new(one.body, other.body)));
        }
        pairs.sort_unstable();
        pairs.into_iter().filter_map(obstacle_of).collect()
    }

    fn bounds_of_disc(&self, disc: usize) -> Bounds {
        let body = &self.discs[disc];
        let radius = body.radius.hull();
        let about = |middle: &S| {
            let middle = middle.hull();
            Interval::new((middle - radius).lo(), (middle + radius).hi())
        };
        Bounds {
            x: about(&body.position.x),
            y: about(&body.position.y),
            body: BodyId::Disc(disc as u32),
        }
    }

    fn bounds_of_wall(&self, wall: usize) -> Bounds {
        let segment = &self.walls[wall].segment;
        let between = |from: &S, to: &S| {
            let (from, to) = (from.hull(), to.hull());
            Interval::new(from.lo().min(to.lo()), from.hi().max(to.hi()))
        };
        Bounds {
            x: between(&segment.from.x, &segment.to.x),
            y: between(&segment.from.y, &segment.to.y),
            body: BodyId::Wall(wall as u32),
        }
    }
}

/// A disc and what it may overlap, unless both are walls.
fn obstacle_of(pair: Pair) -> Option<(usize, Obstacle)> {
    match (pair.a, pair.b) {
        (BodyId::Disc(disc), BodyId::Disc(other)) => {
            Some((disc as usize, Obstacle::Disc(other as usize)))
        }
        (BodyId::Disc(disc), BodyId::Wall(wall)) => {
            Some((disc as usize, Obstacle::Wall(wall as usize)))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use proptest::prelude::*;

    use super::*;
    use crate::scene::{Disc, Scene};

    fn world() -> impl Strategy<Value = World<f64>> {
        let number = || -20..20_i32;
        let disc = (number(), number(), 1..9_i32);
        let walls = prop::collection::vec([number(), number(), number(), number()], 0..6);
        (prop::collection::vec(disc, 1..12), walls).prop_map(|(discs, walls)| {
            let discs = discs
                .into_iter()
                .map(|(x, y, radius)| Disc::at([x, y], radius));
            let mut scene = Scene::builder("test").frame(1, 1).discs(discs);
            for [x, y, to_x, to_y] in walls {
                scene = scene.wall([x, y], [to_x, to_y + 50]);
            }
            World::new(&scene.build().expect("a valid scene"), ())
        })
    }

    proptest! {
        /// Nothing that overlaps is left out, and the order is that of all pairs.
        #[test]
        fn what_overlaps_is_close(world in world()) {
            let key = |(disc, obstacle): &(usize, Obstacle)| (*disc, obstacle.whole());
            let close: Vec<_> = world.close_pairs().iter().map(key).collect();
            prop_assert!(close.is_sorted());
            let close: BTreeSet<_> = close.into_iter().collect();
            for pair in world.pairs() {
                let Ok(overlap) = world.overlap(pair.0, pair.1);
                prop_assert!(overlap.is_none() || close.contains(&key(&pair)));
            }
        }
    }
}
