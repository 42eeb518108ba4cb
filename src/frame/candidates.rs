//! The pairs that a frame algorithm tests: all of them (P1.2), or those that may
//! meet within the frame, for they [get](super::reach) to the same place.
//!
//! Which pairs these are does not depend on how they are found, nor does the order
//! in which they are tested. In exact arithmetic, where a test can leave its
//! question open, they alone are tested in every broad phase. Otherwise
//! [`BroadPhase::AllPairs`] leaves no pair out: it costs what the paper's algorithms
//! cost, and finds no more.

use super::reach;
use crate::broad_phase::{Area, BroadPhase, Index};
use crate::kernel::Kernel;
use crate::scalar::Interval;
use crate::world::{Obstacle, World};

/// So few bodies are all looked at as quickly.
const FEW: usize = 16;

/// Which pairs a frame algorithm tests. It goes from frame to frame for its memory
/// alone.
#[derive(Clone, Debug, Default)]
pub struct Candidates {
    phase: BroadPhase,
    /// Whether any pairs are left out.
    is_selective: bool,
    /// Where the discs and then the walls get to, if so.
    index: Index,
    discs: usize,
    bodies: usize,
    time: f64,
    /// What is near to a disc.
    near: Vec<usize>,
    /// Those that are to be tested, each a disc and a body after it.
    pairs: Vec<[u32; 2]>,
}

impl Candidates {
    /// Candidates that a broad phase finds.
    pub fn new(phase: BroadPhase) -> Self {
        Self {
            phase,
            ..Self::default()
        }
    }

    /// Enters the bodies of a world, of which there may be bounds, with all that
    /// they get to within a time.
    pub(super) fn enter<S: Kernel>(
        &mut self,
        world: &World<S>,
        bounds: Option<&World<Interval>>,
        time: f64,
    ) {
        self.discs = world.discs.len();
        self.bodies = self.discs + world.walls.len();
        self.time = time;
        let phase = match self.bodies {
            0..=FEW => BroadPhase::AllPairs,
            _ => self.phase,
        };
        self.is_selective = S::IS_STRAIGHT && (S::IS_DEAR || phase != BroadPhase::AllPairs);
        match bounds {
            _ if !self.is_selective => {}
            Some(bounds) => self.index.rebuild(phase, areas(bounds, time)),
            None => self.index.rebuild(phase, areas(world, time)),
        }
    }

    /// Takes note of a disc that has changed.
    pub(super) fn update<S: Kernel>(
        &mut self,
        world: &World<S>,
        bounds: Option<&World<Interval>>,
        disc: usize,
    ) {
        if self.is_selective {
            let area = match bounds {
                Some(bounds) => reach::of_disc(&bounds.discs[disc], self.time),
                None => reach::of_disc(&world.discs[disc], self.time),
            };
            self.index.replace(disc, area);
        }
    }

    /// Tests a disc with the candidates after a body, in their order, until
    /// something is found.
    pub(super) fn find_after<T, E>(
        &mut self,
        disc: usize,
        body: usize,
        test: impl FnMut(Obstacle) -> Result<Option<T>, E>,
    ) -> Result<Option<(usize, T)>, E> {
        if self.is_selective {
            self.list_after(disc, body);
            self.find(self.near.iter().copied(), test)
        } else {
            self.find(body + 1..self.bodies, test)
        }
    }

    fn find<T, E>(
        &self,
        bodies: impl Iterator<Item = usize>,
        mut test: impl FnMut(Obstacle) -> Result<Option<T>, E>,
    ) -> Result<Option<(usize, T)>, E> {
        for body in bodies {
            if let Some(found) = test(self.obstacle(body))? {
                return Ok(Some((body, found)));
            }
        }
        Ok(None)
    }

    /// Lists what is near to a disc, after a body.
    fn list_after(&mut self, disc: usize, body: usize) {
        let Self { index, near, .. } = self;
        near.clear();
        index.look_about(disc, |other| {
            if other > body {
                near.push(other);
            }
        });
        near.sort_unstable();
    }

    /// Finds the pairs with a disc that is to be tested. What touches by
    /// construction is among them, also where numbers that round have drifted.
    pub(super) fn list<S: Kernel>(&mut self, world: &World<S>, is_tested: impl Fn(usize) -> bool) {
        let Self {
            index,
            pairs,
            discs,
            ..
        } = self;
        pairs.clear();
        if !self.is_selective {
            return;
        }
        for disc in (0..*discs).filter(|&disc| is_tested(disc)) {
            let mut add = |body: usize| {
                let is_added = body < disc && is_tested(body);
                if !is_added {
                    pairs.push([disc.min(body), disc.max(body)].map(|body| body as u32));
                }
            };
            index.look_about(disc, &mut add);
            for obstacle in world.touched(disc) {
                add(match obstacle {
                    Obstacle::Disc(other) => other,
                    Obstacle::Wall(wall) => *discs + wall,
                });
            }
        }
        pairs.sort_unstable();
        pairs.dedup();
    }

    /// The pairs of a world that have been found, or all, in their order.
    pub(super) fn pairs<S: Kernel>(
        &self,
        world: &World<S>,
    ) -> impl Iterator<Item = (usize, Obstacle)> {
        let all = (!self.is_selective).then(|| world.pairs());
        let found = self.pairs.iter().map(|pair| {
            let [disc, body] = pair.map(|body| body as usize);
            (disc, self.obstacle(body))
        });
        found.chain(all.into_iter().flatten())
    }

    #[inline]
    fn obstacle(&self, body: usize) -> Obstacle {
        Obstacle::numbered(body, self.discs)
    }
}

/// Where the discs and then the walls of a world get to within a time.
fn areas<S: Kernel>(world: &World<S>, time: f64) -> impl Iterator<Item = Area> {
    let discs = world.discs.iter();
    let walls = world.walls.iter();
    discs
        .map(move |disc| reach::of_disc(disc, time))
        .chain(walls.map(|wall| reach::of_wall(&wall.segment)))
}
