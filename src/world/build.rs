//! A scene's bodies made into numbers of one type.

use std::collections::HashMap;

use num_rational::BigRational;

use super::{Corner, World};
use crate::body::{Disc, End, Mass, Wall};
use crate::contacts::Contacts;
use crate::detect::Segment;
use crate::kernel::Kernel;
use crate::respond::Restitution;
use crate::scalar::{Interval, Number};
use crate::scene::{self, Scene};
use crate::vec2::Vec2;

impl<S: Kernel> World<S> {
    /// The bodies of a scene, each number rounded at most once.
    pub fn new(scene: &Scene, precision: S::Precision) -> Self {
        let number = |written: &Number| S::from_number(written, precision);
        let mut corners = Corners::default();
        let walls = (0..).zip(scene.walls());
        let discs = scene.discs().iter();
        Self {
            pulls: vec![S::Pull::default(); discs.len()],
            discs: discs.map(|disc| make_disc(disc, number)).collect(),
            walls: walls
                .map(|(index, wall)| make_wall(wall, corners.of(index, wall), number))
                .collect(),
            corners: corners.list,
            period: scene.periodic().map(|cell| period(cell, precision)),
            restitution: make_restitution(&scene.effects().restitution, number),
            contacts: Contacts::none(scene.discs().len()),
        }
    }

    /// The same bodies in another arithmetic, each number made from its
    /// counterpart. What touches by construction, and what pulls, is left out.
    pub(crate) fn rebuilt<T: Kernel>(&self, make: impl Fn(&S) -> T) -> World<T> {
        let wall = |wall: &Wall<S>| {
            let Segment {
                from, to, along, ..
            } = &wall.segment;
            Wall {
                segment: Segment::new(from.map(&make), to.map(&make), along.map(&make)),
                corners: wall.corners,
            }
        };
        World {
            pulls: vec![T::Pull::default(); self.discs.len()],
            discs: self.discs.iter().map(|disc| disc.map(&make)).collect(),
            walls: self.walls.iter().map(wall).collect(),
            corners: self.corners.clone(),
            period: self.period.as_ref().map(|period| period.map(&make)),
            restitution: self.restitution.map(&make),
            contacts: Contacts::none(self.discs.len()),
        }
    }

    /// Binary64 bounds of everything. What touches by construction is left
    /// out: bounds leave that open; so is what pulls.
    pub fn hull(&self) -> World<Interval> {
        World {
            pulls: vec![(); self.discs.len()],
            discs: self.discs.iter().map(|disc| disc.map(S::hull)).collect(),
            walls: self.walls.iter().map(hull_of_wall).collect(),
            corners: self.corners.clone(),
            period: self.period.as_ref().map(|period| period.map(S::hull)),
            restitution: self.restitution.map(S::hull),
            contacts: Contacts::none(self.discs.len()),
        }
    }
}

/// The corners met so far, told apart by their exact coordinates.
#[derive(Default)]
struct Corners {
    list: Vec<Corner>,
    known: HashMap<[BigRational; 2], u32>,
}

impl Corners {
    /// The corners at a wall's two ends.
    fn of(&mut self, index: u32, wall: &scene::Wall) -> [u32; 2] {
        [
            self.at(index, End::From, &wall.from),
            self.at(index, End::To, &wall.to),
        ]
    }

    fn at(&mut self, wall: u32, end: End, point: &[Number; 2]) -> u32 {
        let next = self.list.len() as u32;
        let corner = *self
            .known
            .entry([point[0].to_rational(), point[1].to_rational()])
            .or_insert(next);
        if corner == next {
            self.list.push(Corner { wall, end });
        }
        corner
    }
}

fn vector<S>(written: &[Number; 2], number: impl Fn(&Number) -> S) -> Vec2<S> {
    Vec2::new(number(&written[0]), number(&written[1]))
}

/// The sides of a cell, each rounded at most once.
fn period<S: Kernel>(cell: &scene::Cell, precision: S::Precision) -> Vec2<S> {
    let [x, y] = cell.sides();
    let side = |side| S::from_number(&side, precision);
    Vec2::new(side(x), side(y))
}

fn make_disc<S>(disc: &scene::Disc, number: impl Fn(&Number) -> S) -> Disc<S> {
    Disc {
        position: vector(&disc.position, &number),
        velocity: vector(&disc.velocity, &number),
        radius: number(&disc.radius),
        mass: match &disc.mass {
            scene::Mass::Finite(mass) => Mass::Finite(number(mass)),
            scene::Mass::Infinite => Mass::Infinite,
        },
        last: None,
    }
}

fn make_wall<S: Kernel>(
    wall: &scene::Wall,
    corners: [u32; 2],
    number: impl Fn(&Number) -> S,
) -> Wall<S> {
    let (from, to) = (vector(&wall.from, &number), vector(&wall.to, &number));
    let along = to.minus(&from);
    Wall {
        segment: Segment::new(from, to, along),
        corners,
    }
}

fn hull_of_wall<S: Kernel>(wall: &Wall<S>) -> Wall<Interval> {
    Wall {
        segment: wall.segment.map(S::hull),
        corners: wall.corners,
    }
}

fn make_restitution<S: Kernel>(
    written: &scene::Restitution,
    number: impl Fn(&Number) -> S,
) -> Restitution<S> {
    match written {
        scene::Restitution::Elastic => Restitution::Elastic,
        scene::Restitution::Newton {
            coefficient,
            walls,
            elastic_below,
        } => Restitution::Newton {
            discs: number(coefficient),
            walls: number(walls.as_ref().unwrap_or(coefficient)),
            elastic_below: elastic_below.as_ref().map(number),
        },
        scene::Restitution::Paper { loss } => Restitution::Paper {
            kept: S::from_integer(1) - number(loss),
        },
    }
}
