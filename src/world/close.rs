//! Which bodies are so close that they may overlap: the boxes about them do.
//!
//! The boxes are in binary64, rounded outwards.

use super::{Obstacle, World};
use crate::broad_phase::{Area, BroadPhase, Index};
use crate::kernel::Kernel;
use crate::scalar::Interval;
use crate::vec2::Vec2;

impl<S: Kernel> World<S> {
    /// Every disc with the discs after it and the walls that it may overlap, and
    /// with some that it does not: in the order of all pairs.
    pub(crate) fn close_pairs(&self) -> Vec<(usize, Obstacle)> {
        let discs = (0..self.discs.len()).map(|disc| self.box_of_disc(disc));
        let walls = (0..self.walls.len()).map(|wall| self.box_of_wall(wall));
        let mut index = Index::default();
        index.rebuild(BroadPhase::Grid, discs.chain(walls));
        let (mut pairs, mut near) = (Vec::new(), Vec::new());
        let count = self.discs.len();
        for disc in 0..count {
            near.clear();
            index.look_about(disc, |body| near.push(body));
            near.retain(|&body| body > disc);
            near.sort_unstable();
            pairs.extend(
                near.iter()
                    .map(|&body| (disc, Obstacle::numbered(body, count))),
            );
        }
        pairs
    }

    fn box_of_disc(&self, disc: usize) -> Area {
        let body = &self.discs[disc];
        let radius = body.radius.hull();
        let Vec2 { x, y } = body.position.map(S::hull);
        let ends = |middle: Interval| [(middle - radius).lo(), (middle + radius).hi()];
        area([x, y].map(ends))
    }

    fn box_of_wall(&self, wall: usize) -> Area {
        let segment = &self.walls[wall].segment;
        let [from, to] = [&segment.from, &segment.to].map(|end| end.map(S::hull));
        let ends = |[from, to]: [Interval; 2]| [from.lo().min(to.lo()), from.hi().max(to.hi())];
        area([[from.x, to.x], [from.y, to.y]].map(ends))
    }
}

/// The points between two ends in both coordinates.
fn area([x, y]: [[f64; 2]; 2]) -> Area {
    Area::new([x[0], y[0]], [x[1], y[1]])
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
