//! What a disc may meet soon: the broad phase (P6.2).
//!
//! Everything, or what is near. What is near is found in a [`Grid`], and holds
//! until the disc leaves its cell; a forecast looks no further, and is made anew
//! then. Both lead to the same impacts.

mod cells;
mod course;
mod grid;
mod level;
mod shape;
mod sizes;
mod torus;
mod walls;

use super::flight::Flights;
use crate::kernel::{Kernel, Pull};
use crate::scalar::Interval;
use crate::vec2::Vec2;
use crate::world::World;
use grid::{Grid, Near};

pub(super) use torus::{Image, Torus};

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

/// How a disc moves: where it is at a time, and how fast, up to another time.
pub(super) struct Motion {
    pub(super) position: [Known; 2],
    pub(super) velocity: [Known; 2],
    pub(super) since: Known,
    pub(super) until: f64,
}

/// A number, and how far off that may be.
#[derive(Clone, Copy)]
pub(super) struct Known {
    pub(super) value: f64,
    pub(super) error: f64,
}

impl Known {
    #[inline]
    fn of<S: Kernel>(number: &S) -> Self {
        if S::ROUNDS {
            let (value, error) = (number.to_f64(), 0.0);
            return Self { value, error };
        }
        Self::within(number.hull())
    }

    fn within(bounds: Interval) -> Self {
        Self {
            value: bounds.middle(),
            error: bounds.radius(),
        }
    }
}

impl Motion {
    #[inline]
    pub(super) fn of<S: Kernel>(flights: &Flights<S>, disc: usize) -> Self {
        let body = &flights.world.discs[disc];
        let known = |vector: &crate::vec2::Vec2<S>| [&vector.x, &vector.y].map(Known::of);
        Self {
            position: known(&body.position),
            velocity: known(&body.velocity),
            since: Known::of(&flights.starts[disc].since),
            until: f64::INFINITY,
        }
    }

    /// How a disc moves from some time on.
    #[inline]
    fn at<S: Kernel>(grid: &Grid, flights: &Flights<S>, disc: usize, time: f64) -> Self {
        let pull = S::Pull::of(&flights.world.pulls, disc);
        match pull.acceleration(&flights.world.discs[disc]) {
            None => Self::of(flights, disc),
            Some(pull) => {
                let motion = Self::falling(flights, disc, time, &pull);
                motion.straight_in(grid, disc, &pull)
            }
        }
    }

    fn falling<S: Kernel>(
        flights: &Flights<S>,
        disc: usize,
        time: f64,
        pull: &Vec2<Interval>,
    ) -> Self {
        let body = &flights.world.discs[disc];
        let since = Interval::point(time);
        let flown = since - flights.starts[disc].since.hull();
        let [position, velocity] =
            [&body.position, &body.velocity].map(|vector| vector.map(S::hull));
        let half = pull.scaled(&Interval::point(0.5));
        let position = position.moved(&velocity.moved(&half, &flown), &flown);
        let velocity = velocity.moved(pull, &flown);
        let known = |Vec2 { x, y }: Vec2<Interval>| [x, y].map(Known::within);
        Self {
            position: known(position),
            velocity: known(velocity),
            since: Known::within(since),
            until: f64::INFINITY,
        }
    }

    /// The same as a straight motion, for as long as it is as good as one in the
    /// cells of a grid.
    fn straight_in(mut self, grid: &Grid, disc: usize, pull: &Vec2<Interval>) -> Self {
        let most = pull.x.magnitude().max(pull.y.magnitude());
        if most > 0.0 {
            let lasts = grid.straight_for(disc, most);
            self.until = self.since.value + lasts;
            for speed in &mut self.velocity {
                speed.error += most * lasts;
            }
        }
        self
    }
}

impl Neighbours {
    /// The bodies near to each other at the start of some flights.
    pub(super) fn new<S: Kernel>(flights: &Flights<S>, phase: BroadPhase) -> Self {
        let world = &flights.world;
        if phase == BroadPhase::AllPairs || world.discs.len() <= FEW {
            return Self::Everything;
        }
        let mut grid = Grid::new(world);
        for disc in 0..world.discs.len() {
            if world.discs[disc].is_movable() || world.rests_for_ever(disc) {
                let motion = Motion::at(&grid, flights, disc, 0.0);
                grid.settle(disc, &motion, 0.0);
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
            let time = flights.starts[disc].since.hull().lo();
            let motion = Motion::at(grid, flights, disc, time);
            grid.settle(disc, &motion, time);
        }
    }

    /// Takes note of a disc that leaves its cell at a time before which nothing
    /// happens.
    pub(super) fn renew<S: Kernel>(&mut self, flights: &Flights<S>, disc: usize, time: f64) {
        if let Self::Near(grid) = self {
            let motion = Motion::at(grid, flights, disc, time);
            grid.renew(disc, &motion, time);
        }
    }

    /// Fetches where a disc is into the cache.
    #[inline]
    pub(super) fn fetch(&self, disc: usize) {
        if let Self::Near(grid) = self {
            grid.fetch(disc);
        }
    }

    /// Fetches the cells about a disc.
    #[inline]
    pub(super) fn fetch_cells(&self, disc: usize) {
        if let Self::Near(grid) = self {
            grid.fetch_cells(disc);
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

    /// What a disc may meet, and some more.
    #[inline]
    pub(super) fn of(&self, disc: usize) -> Surroundings<'_> {
        Surroundings(match self {
            Self::Everything => None,
            Self::Near(grid) => grid.near(disc),
        })
    }
}

/// What is near a disc, or everything.
pub(super) struct Surroundings<'a>(Option<Near<'a>>);

impl Surroundings<'_> {
    /// Visits the walls.
    #[inline]
    pub(super) fn visit_walls<S: Kernel>(&self, world: &World<S>, visit: impl FnMut(u32)) {
        match &self.0 {
            Some(near) => near.walls().for_each(visit),
            None => (0..world.walls.len() as u32).for_each(visit),
        }
    }

    /// Whether nothing has been left out.
    #[inline]
    pub(super) fn is_everything(&self) -> bool {
        self.0.is_none()
    }

    /// Lists the discs.
    #[inline]
    pub(super) fn list_discs<S: Kernel>(&self, world: &World<S>, list: &mut Vec<u32>) {
        list.clear();
        match &self.0 {
            Some(near) => near.list_discs(list),
            None => list.extend(0..world.discs.len() as u32),
        }
    }
}
