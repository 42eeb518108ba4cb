//! A scene's bodies in one arithmetic, and how two of them meet.

use std::cmp::Ordering::{self, Greater};
use std::collections::HashMap;

use num_rational::BigRational;

use crate::body::{BodyId, Disc, End, Feature, Mass, Pair, Wall};
use crate::contacts::Contacts;
use crate::detect::{
    Encounter, Overlap, Segment, meet_circle, meet_segment, overlap_circle, overlap_segment,
};
use crate::respond::Restitution;
use crate::scalar::{Doubt, Interval, Number, Scalar};
use crate::scene::{self, Scene};
use crate::vec2::Vec2;

/// A point where walls end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// The lowest of the walls that end here.
    pub wall: u32,
    /// The end of that wall.
    pub end: End,
}

/// A body that a disc may meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// Another disc.
    Disc(usize),
    /// A wall, with its end points.
    Wall(usize),
}

impl Obstacle {
    /// The question whether a disc and this do something.
    pub(crate) fn ask(self, disc: usize, verb: &str) -> String {
        match self {
            Self::Disc(other) => format!("whether d{disc} and d{other} {verb}"),
            Self::Wall(wall) => format!("whether d{disc} and w{wall} {verb}"),
        }
    }
}

/// The bodies of a scene, as numbers of one type.
#[derive(Clone, Debug)]
pub struct World<S> {
    /// The discs, at the start of the scene or wherever a run has taken them.
    pub discs: Vec<Disc<S>>,
    /// The walls.
    pub walls: Vec<Wall<S>>,
    /// The points where walls end: end points that coincide are one.
    pub corners: Vec<Corner>,
    /// What impacts lose.
    pub restitution: Restitution<S>,
    /// What touches by construction, where the discs are now.
    pub contacts: Contacts,
}

impl<S: Scalar> World<S> {
    /// The bodies of a scene, each number rounded at most once.
    pub fn new(scene: &Scene, precision: S::Precision) -> Self {
        let number = |written: &Number| S::from_number(written, precision);
        let mut corners = Corners::default();
        let walls = (0..).zip(scene.walls());
        Self {
            discs: scene
                .discs()
                .iter()
                .map(|disc| make_disc(disc, number))
                .collect(),
            walls: walls
                .map(|(index, wall)| make_wall(wall, corners.of(index, wall), number))
                .collect(),
            corners: corners.list,
            restitution: make_restitution(&scene.effects().restitution, number),
            contacts: Contacts::none(scene.discs().len()),
        }
    }

    /// Binary64 bounds of everything. What touches by construction is left
    /// out: bounds leave that open.
    pub fn hull(&self) -> World<Interval> {
        World {
            discs: self.discs.iter().map(|disc| disc.map(S::hull)).collect(),
            walls: self.walls.iter().map(hull_of_wall).collect(),
            corners: self.corners.clone(),
            restitution: self.restitution.map(S::hull),
            contacts: Contacts::none(self.discs.len()),
        }
    }
}

impl<S: Scalar> World<S> {
    /// Whether a disc cannot meet an obstacle in free motion: it is the disc
    /// itself, or the two have parted and not collided since, or none of them
    /// can be deflected.
    #[inline]
    pub fn is_barred(&self, disc: usize, obstacle: Obstacle) -> bool {
        match obstacle {
            Obstacle::Disc(other) => disc == other || self.discs_are_barred(disc, other),
            Obstacle::Wall(wall) => self.wall_is_barred(disc, wall),
        }
    }

    fn discs_are_barred(&self, i: usize, j: usize) -> bool {
        let (first, second) = (&self.discs[i], &self.discs[j]);
        let parted = |disc: &Disc<S>, other: usize| {
            !disc.is_movable() || disc.last == Some(Feature::Disc(other as u32))
        };
        parted(first, j) && parted(second, i)
    }

    fn wall_is_barred(&self, disc: usize, wall: usize) -> bool {
        let disc = &self.discs[disc];
        !disc.is_movable()
            || match disc.last {
                Some(Feature::Wall(last)) => last as usize == wall,
                Some(Feature::Corner(last)) => self.walls[wall].corners.contains(&last),
                _ => false,
            }
    }

    /// Every disc with each disc after it and each wall.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = (usize, Obstacle)> + use<S> {
        let (discs, walls) = (self.discs.len(), self.walls.len());
        (0..discs).flat_map(move |disc| {
            let others = (disc + 1..discs).map(Obstacle::Disc);
            let walls = (0..walls).map(Obstacle::Wall);
            others.chain(walls).map(move |obstacle| (disc, obstacle))
        })
    }

    /// What a disc may meet in free motion.
    pub(crate) fn obstacles(&self, disc: usize) -> impl Iterator<Item = Obstacle> + use<'_, S> {
        let discs = (0..self.discs.len()).map(Obstacle::Disc);
        let walls = (0..self.walls.len()).map(Obstacle::Wall);
        discs
            .chain(walls)
            .filter(move |&obstacle| !self.is_barred(disc, obstacle))
    }

    /// Whether a disc moves towards a feature that it touches where all are.
    ///
    /// # Errors
    ///
    /// An enclosure does not decide it.
    pub fn approaches_here(&self, disc: usize, feature: Feature) -> Result<bool, S::Doubt> {
        let other = match feature {
            Feature::Disc(other) => self.discs[other as usize].position.clone(),
            Feature::Wall(_) | Feature::Corner(_) => Vec2::zero(),
        };
        self.approaches(disc, feature, &other)
    }

    /// Forgets what a disc touches that moves in a direction; only a wall
    /// along which it moves it goes on to touch.
    pub(crate) fn leave_contacts(&mut self, disc: usize, direction: &Vec2<S>) {
        let walls = &self.walls;
        self.contacts.leave(disc, |feature| {
            let Feature::Wall(wall) = feature else {
                return false;
            };
            let along = &walls[wall as usize].segment.along;
            along.cross(direction).sign().is_ok_and(Ordering::is_eq)
        });
    }

    /// Moves a disc freely for a time.
    pub(crate) fn advance_disc(&mut self, disc: usize, time: &S) {
        if time.sign().is_ok_and(Ordering::is_eq) {
            return;
        }
        self.discs[disc].advance(time);
        if !self.contacts.of(disc).is_empty() {
            let velocity = self.discs[disc].velocity.clone();
            self.leave_contacts(disc, &velocity);
        }
    }

    /// Moves all discs freely for a time.
    pub(crate) fn advance(&mut self, time: &S) {
        for disc in 0..self.discs.len() {
            self.advance_disc(disc, time);
        }
    }

    /// How many pairs overlap.
    ///
    /// # Errors
    ///
    /// An enclosure does not decide it.
    pub fn count_overlaps(&self) -> Result<u64, S::Doubt> {
        let bounds = S::FILTERED.then(|| self.hull());
        let surely_apart = |disc, obstacle| {
            let bounds = bounds.as_ref();
            bounds.is_some_and(|world| matches!(world.overlap(disc, obstacle), Ok(None)))
        };
        let mut count = 0;
        for (disc, obstacle) in self.pairs() {
            if !self.is_barred(disc, obstacle) && !surely_apart(disc, obstacle) {
                let overlap = self.overlap(disc, obstacle);
                let overlap =
                    overlap.map_err(|doubt| doubt.asking(|| obstacle.ask(disc, "overlap")))?;
                count += u64::from(overlap.is_some());
            }
        }
        Ok(count)
    }

    /// The overlap of a disc and an obstacle, if there is one, and what of the
    /// obstacle is nearest.
    ///
    /// # Errors
    ///
    /// An enclosure does not decide it.
    pub fn overlap(
        &self,
        disc: usize,
        obstacle: Obstacle,
    ) -> Result<Option<(Feature, Overlap<S>)>, S::Doubt> {
        if self.contact(disc, obstacle).is_some() {
            return Ok(None);
        }
        let body = &self.discs[disc];
        match obstacle {
            Obstacle::Disc(other) => {
                let second = &self.discs[other];
                let offset = second.position.minus(&body.position);
                let reach = body.radius.clone() + &second.radius;
                let overlap = overlap_circle(&offset, &reach)?;
                Ok(overlap.map(|overlap| (Feature::Disc(other as u32), overlap)))
            }
            Obstacle::Wall(wall) => {
                let segment = &self.walls[wall].segment;
                let overlap = overlap_segment(&body.position, &body.radius, segment)?;
                Ok(overlap.map(|overlap| (self.feature(wall, overlap.end), overlap)))
            }
        }
    }

    /// What of an obstacle a disc touches by construction.
    #[inline]
    pub fn contact(&self, disc: usize, obstacle: Obstacle) -> Option<Feature> {
        let mut touched = self.contacts.of(disc).iter().copied();
        touched.find(|feature| match (*feature, obstacle) {
            (Feature::Disc(other), Obstacle::Disc(index)) => other as usize == index,
            (Feature::Wall(other), Obstacle::Wall(index)) => other as usize == index,
            (Feature::Corner(corner), Obstacle::Wall(index)) => {
                self.walls[index].corners.contains(&corner)
            }
            _ => false,
        })
    }

    /// Whether a disc moves towards a feature that it touches, another disc
    /// being where `other` says.
    ///
    /// # Errors
    ///
    /// An enclosure does not decide it.
    pub fn approaches(
        &self,
        disc: usize,
        feature: Feature,
        other: &Vec2<S>,
    ) -> Result<bool, S::Doubt> {
        let Disc {
            position, velocity, ..
        } = &self.discs[disc];
        let closing = match feature {
            Feature::Wall(wall) => {
                let segment = &self.walls[wall as usize].segment;
                return segment.is_approached(position, velocity);
            }
            Feature::Corner(corner) => {
                let offset = self.corner_position(corner).minus(position);
                velocity.dot(&offset)
            }
            Feature::Disc(index) => {
                let closing = velocity.minus(&self.discs[index as usize].velocity);
                closing.dot(&other.minus(position))
            }
        };
        Ok(closing.sign()? == Greater)
    }

    /// When the discs i and j meet, from relative position and velocity.
    ///
    /// # Errors
    ///
    /// An enclosure does not decide it.
    #[inline]
    pub fn meet_discs(
        &self,
        (i, j): (usize, usize),
        offset: &Vec2<S>,
        velocity: &Vec2<S>,
    ) -> Result<Option<Encounter<S>>, S::Doubt> {
        let reach = self.discs[i].radius.clone() + &self.discs[j].radius;
        meet_circle(offset, velocity, &reach)
    }

    /// When a disc meets a wall, from where the disc is.
    ///
    /// # Errors
    ///
    /// An enclosure does not decide it.
    pub fn meet_wall(&self, disc: usize, wall: usize) -> Result<Option<Encounter<S>>, S::Doubt> {
        let Disc {
            position,
            velocity,
            radius,
            last,
            ..
        } = &self.discs[disc];
        let wall = &self.walls[wall];
        let barred = |end| self.is_end_of(*last, wall.corner(end));
        meet_segment(position, velocity, radius, &wall.segment, barred)
    }

    /// Whether a corner belongs to what a disc has parted from.
    fn is_end_of(&self, last: Option<Feature>, corner: u32) -> bool {
        matches!(last, Some(Feature::Wall(wall))
            if self.walls[wall as usize].corners.contains(&corner))
    }

    /// What of a wall an encounter touches.
    pub fn feature(&self, wall: usize, end: Option<End>) -> Feature {
        match end {
            Some(end) => Feature::Corner(self.walls[wall].corner(end)),
            None => Feature::Wall(wall as u32),
        }
    }

    /// The names under which the impact of a disc on a feature is logged:
    /// that on a corner with the lowest wall that ends there.
    pub fn names(&self, disc: usize, feature: Feature) -> (Pair, Option<End>) {
        let (body, end) = match feature {
            Feature::Disc(other) => (BodyId::Disc(other), None),
            Feature::Wall(wall) => (BodyId::Wall(wall), None),
            Feature::Corner(corner) => {
                let Corner { wall, end } = self.corners[corner as usize];
                (BodyId::Wall(wall), Some(end))
            }
        };
        (Pair::new(BodyId::Disc(disc as u32), body), end)
    }

    /// The point that a corner is.
    pub fn corner_position(&self, corner: u32) -> &Vec2<S> {
        let Corner { wall, end } = self.corners[corner as usize];
        self.walls[wall as usize].segment.end(end)
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

fn make_wall<S: Scalar>(
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

fn hull_of_wall<S: Scalar>(wall: &Wall<S>) -> Wall<Interval> {
    let segment = &wall.segment;
    Wall {
        segment: Segment {
            from: segment.from.map(S::hull),
            to: segment.to.map(S::hull),
            along: segment.along.map(S::hull),
            length: segment.length.hull(),
            length_squared: segment.length_squared.hull(),
        },
        corners: wall.corners,
    }
}

fn make_restitution<S: Scalar>(
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
