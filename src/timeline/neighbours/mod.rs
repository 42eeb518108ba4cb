//! What a disc may meet soon: the broad phase (P6.2).
//!
//! Everything, or what is near. What is near is found in a [`Grid`], and holds
//! until the disc leaves its cell; a forecast looks no further, and is made anew
//! then. Both lead to the same impacts.

mod grid;
mod walls;

use super::flight::Flights;
use crate::kernel::Kernel;
use crate::scalar::Interval;
use crate::world::{Obstacle, World};
use grid::Grid;

/// How the bodies are found that a disc may meet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BroadPhase {
    /// All of them are looked at.
    AllPairs,
    /// Those in the cells of a grid about it; where there are only a few,
    /// all of them.
    #[default]
    Grid,
}

/// As many discs are looked at as quickly as a grid.
const FEW: usize = 12;

/// The bodies that each disc may meet.
#[derive(Clone, Debug)]
pub(super) enum Neighbours {
    Everything,
    Near(Box<Grid>),
}

/// How a disc moves: where it is at a time, and how fast, in bounds.
pub(super) struct Motion {
    pub(super) position: [Interval; 2],
    pub(super) velocity: [Interval; 2],
    pub(super) since: Interval,
}

impl Motion {
    #[inline]
    fn of<S: Kernel>(flights: &Flights<S>, disc: usize) -> Self {
        let body = &flights.world.discs[disc];
        let hull = |vector: &crate::vec2::Vec2<S>| [vector.x.hull(), vector.y.hull()];
        Self {
            position: hull(&body.position),
            velocity: hull(&body.velocity),
            since: flights.since[disc].hull(),
        }
    }
}

impl Neighbours {
    /// The bodies near to each other at the start of some flights.
    pub(super) fn new<S: Kernel>(flights: &Flights<S>, phase: BroadPhase) -> Self {
        let world = &flights.world;
        if phase == BroadPhase::AllPairs || world.discs.len() <= FEW || !S::IS_STRAIGHT {
            return Self::Everything;
        }
        let mut grid = Grid::new(&world.hull());
        for disc in 0..world.discs.len() {
            if world.discs[disc].is_movable() || world.rests_for_ever(disc) {
                grid.settle(disc, &Motion::of(flights, disc), 0.0);
            } else {
                grid.stray(disc);
            }
        }
        Self::Near(Box::new(grid))
    }

    /// Takes note of a disc that has changed.
    #[inline]
    pub(super) fn update<S: Kernel>(&mut self, flights: &Flights<S>, disc: usize) {
        if let Self::Near(grid) = self {
            let motion = Motion::of(flights, disc);
            grid.settle(disc, &motion, motion.since.lo());
        }
    }

    /// Takes note of a disc that leaves its cell at a time before which nothing
    /// happens.
    pub(super) fn renew<S: Kernel>(&mut self, flights: &Flights<S>, disc: usize, time: f64) {
        if let Self::Near(grid) = self {
            grid.renew(disc, &Motion::of(flights, disc), time);
        }
    }

    /// Until when a disc meets none but its neighbours.
    #[inline]
    pub(super) fn last_until(&self, disc: usize) -> f64 {
        match self {
            Self::Everything => f64::INFINITY,
            Self::Near(grid) => grid.leave(disc),
        }
    }

    /// Collects what a disc may meet, walls first: often they bound how far
    /// ahead it is worth to look.
    #[inline]
    pub(super) fn collect<S: Kernel>(
        &self,
        world: &World<S>,
        disc: usize,
        found: &mut Vec<Obstacle>,
    ) {
        found.clear();
        match self {
            Self::Near(grid) if !grid.is_stray(disc) => {
                grid.visit(disc, |obstacle| {
                    if !world.is_barred(disc, obstacle) {
                        found.push(obstacle);
                    }
                });
            }
            _ => found.extend(world.obstacles(disc)),
        }
    }
}
