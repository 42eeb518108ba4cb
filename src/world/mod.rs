//! A scene's bodies in one arithmetic, and how two of them meet.

mod build;
mod close;
mod touch;

use std::cmp::Ordering::{self, Equal};

use crate::body::{BodyId, Disc, End, Feature, Mass, Pair, Wall};
use crate::contacts::Contacts;
use crate::detect::Segment;
use crate::kernel::{Flight, Glance, Kernel, Met, Pull, Time};
use crate::respond::Restitution;
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
    /// A body of some number, where the walls are counted on after so many discs.
    #[inline]
    pub(crate) fn numbered(body: usize, discs: usize) -> Self {
        match body.checked_sub(discs) {
            None => Self::Disc(body),
            Some(wall) => Self::Wall(wall),
        }
    }

    /// The disc, or the interior of the wall.
    pub(crate) fn whole(self) -> Feature {
        match self {
            Self::Disc(other) => Feature::Disc(other as u32),
            Self::Wall(wall) => Feature::Wall(wall as u32),
        }
    }

    /// The question whether a disc and this do something.
    pub(crate) fn ask(self, disc: usize, verb: &str) -> String {
        match self {
            Self::Disc(other) => format!("whether d{disc} and d{other} {verb}"),
            Self::Wall(wall) => format!("whether d{disc} and w{wall} {verb}"),
        }
    }
}

/// The bodies of a scene, as numbers of one type (P1.1).
#[derive(Clone, Debug)]
pub struct World<S: Kernel> {
    /// The discs, at the start of the scene or wherever a run has taken them.
    pub discs: Vec<Disc<S>>,
    /// What pulls each of them.
    pub pulls: Vec<S::Pull>,
    /// The walls.
    pub walls: Vec<Wall<S>>,
    /// The points where walls end: end points that coincide are one.
    pub corners: Vec<Corner>,
    /// The sides of the cell that repeats, if the plane is periodic.
    pub period: Option<Vec2<S>>,
    /// What impacts lose.
    pub restitution: Restitution<S>,
    /// What touches by construction, where the discs are now.
    pub contacts: Contacts,
}

impl<S: Kernel> World<S> {
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
        if !S::IS_STRAIGHT {
            return [i, j].iter().all(|&disc| !self.discs[disc].is_movable());
        }
        self.discs_have_parted(i, j)
    }

    fn wall_is_barred(&self, disc: usize, wall: usize) -> bool {
        let is_movable = self.discs[disc].is_movable();
        !is_movable || S::IS_STRAIGHT && self.wall_parted_from(disc, wall).is_some()
    }

    /// What of an obstacle a disc has parted from, when its motion changed last,
    /// and may come back to.
    #[inline]
    pub(crate) fn parted_from(&self, disc: usize, obstacle: Obstacle) -> Option<Feature> {
        if S::IS_STRAIGHT {
            return None;
        }
        match obstacle {
            Obstacle::Disc(other) => {
                let feature = Feature::Disc(other as u32);
                self.discs_have_parted(disc, other).then_some(feature)
            }
            Obstacle::Wall(wall) => self.wall_parted_from(disc, wall),
        }
    }

    fn discs_have_parted(&self, i: usize, j: usize) -> bool {
        let (first, second) = (&self.discs[i], &self.discs[j]);
        let parted = |disc: &Disc<S>, other: usize| {
            !disc.is_movable() || disc.last == Some(Feature::Disc(other as u32))
        };
        parted(first, j) && parted(second, i)
    }

    fn wall_parted_from(&self, disc: usize, wall: usize) -> Option<Feature> {
        self.discs[disc].last.filter(|last| match *last {
            Feature::Wall(last) => last as usize == wall,
            Feature::Corner(last) => self.walls[wall].corners.contains(&last),
            Feature::Disc(_) => false,
        })
    }

    /// Whether a disc that parts from a feature parts from all of an obstacle:
    /// a wall is convex, so it has no other part to meet.
    pub(crate) fn is_part_of(&self, feature: Feature, obstacle: Obstacle) -> bool {
        match (feature, obstacle) {
            (Feature::Disc(other), Obstacle::Disc(index)) => other as usize == index,
            (Feature::Wall(other), Obstacle::Wall(index)) => other as usize == index,
            (Feature::Corner(corner), Obstacle::Wall(index)) => {
                self.walls[index].corners.contains(&corner)
            }
            _ => false,
        }
    }

    /// Whether a disc is at rest, and no collision changes that.
    pub(crate) fn rests_for_ever(&self, disc: usize) -> bool {
        let disc = &self.discs[disc];
        let is_still = || {
            disc.velocity
                .norm_squared()
                .sign()
                .is_ok_and(Ordering::is_eq)
        };
        !disc.is_movable() && is_still()
    }

    /// Every disc with each disc after it and each wall (P1.2).
    pub(crate) fn pairs(&self) -> impl Iterator<Item = (usize, Obstacle)> + use<S> {
        let (discs, walls) = (self.discs.len(), self.walls.len());
        (0..discs).flat_map(move |disc| {
            let others = (disc + 1..discs).map(Obstacle::Disc);
            let walls = (0..walls).map(Obstacle::Wall);
            others.chain(walls).map(move |obstacle| (disc, obstacle))
        })
    }

    /// All numbers that the bodies are given by.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = &S> {
        let discs = self.discs.iter().flat_map(|disc| {
            let mass = match &disc.mass {
                Mass::Finite(mass) => Some(mass),
                Mass::Infinite => None,
            };
            let vectors = [&disc.position, &disc.velocity].into_iter();
            let coordinates = vectors.flat_map(|vector| [&vector.x, &vector.y]);
            coordinates.chain([&disc.radius]).chain(mass)
        });
        let walls = self.walls.iter().flat_map(|wall| {
            let Segment {
                from, to, along, ..
            } = &wall.segment;
            [from, to, along]
                .into_iter()
                .flat_map(|vector| [&vector.x, &vector.y])
        });
        discs.chain(walls).chain(self.restitution.numbers())
    }

    /// Moves a disc freely from one time to another.
    pub(crate) fn advance_disc(&mut self, disc: usize, since: &S, time: &S::Time) {
        if matches!(time.order_to(since), Ok(Equal)) {
            return;
        }
        let flight = self.flight(disc, since);
        let position = S::position_at(flight, time);
        if !S::IS_STRAIGHT {
            self.discs[disc].velocity = S::velocity_at(flight, time);
        }
        self.discs[disc].position = position;
        if !self.contacts.of(disc).is_empty() {
            let velocity = self.discs[disc].velocity.clone();
            self.leave_contacts(disc, &velocity);
        }
    }

    /// Where a disc that is in flight since some time is at another.
    #[inline]
    pub(crate) fn position_at(&self, disc: usize, since: &S, time: &S::Time) -> Vec2<S> {
        S::position_at(self.flight(disc, since), time)
    }

    /// A disc that is in flight since some time.
    #[inline]
    pub(crate) fn flight<'a>(&'a self, disc: usize, since: &'a S) -> Flight<'a, S> {
        Flight {
            disc: &self.discs[disc],
            since,
            pull: S::Pull::of(&self.pulls, disc),
        }
    }

    /// Moves all discs freely for a time.
    pub(crate) fn advance(&mut self, time: &S) {
        let (start, time) = (S::from_integer(0), S::Time::at(time.clone()));
        for disc in 0..self.discs.len() {
            self.advance_disc(disc, &start, &time);
        }
    }

    /// When a disc in flight since a time meets a wall.
    ///
    /// # Errors
    ///
    /// An enclosure does not decide it.
    pub fn meet_wall(
        &self,
        disc: usize,
        since: &S,
        wall: usize,
    ) -> Result<Option<Met<S::Time>>, S::Doubt> {
        let last = self.discs[disc].last;
        let wall = &self.walls[wall];
        let barred = |end| match S::IS_STRAIGHT {
            true => self.is_end_of(last, wall.corner(end)),
            false => self.slides_to(disc, wall.corner(end)),
        };
        S::meet_wall(self.flight(disc, since), &wall.segment, barred)
    }

    /// What can quickly be told of that.
    #[inline]
    pub(crate) fn glance_at_wall(&self, disc: usize, since: &S, wall: usize) -> Glance {
        let last = self.discs[disc].last;
        let wall = &self.walls[wall];
        let barred = |end| self.is_end_of(last, wall.corner(end));
        S::glance_at_wall(self.flight(disc, since), &wall.segment, barred)
    }

    /// Whether a corner belongs to what a disc has parted from.
    fn is_end_of(&self, last: Option<Feature>, corner: u32) -> bool {
        matches!(last, Some(Feature::Wall(wall))
            if self.walls[wall as usize].corners.contains(&corner))
    }

    /// Whether a corner belongs to a wall that holds a disc: it meets it where it
    /// leaves that wall.
    fn slides_to(&self, disc: usize, corner: u32) -> bool {
        let mut holders = S::Pull::of(&self.pulls, disc)
            .holders()
            .into_iter()
            .flatten();
        holders.any(|wall| self.walls[wall].corners.contains(&corner))
    }

    /// Whether a wall is in one line with one that holds a disc, which then does
    /// not meet it, but may slide on to it.
    pub(crate) fn slides_along(&self, disc: usize, wall: usize) -> bool {
        let mut holders = S::Pull::of(&self.pulls, disc)
            .holders()
            .into_iter()
            .flatten();
        let segment = &self.walls[wall].segment;
        holders.any(|holder| self.walls[holder].segment.is_in_line_with(segment))
    }

    /// What of a wall an encounter touches.
    pub fn feature(&self, wall: usize, end: Option<End>) -> Feature {
        match end {
            Some(end) => Feature::Corner(self.walls[wall].corner(end)),
            None => Feature::Wall(wall as u32),
        }
    }

    /// What of an obstacle an encounter touches.
    pub(crate) fn feature_of(&self, obstacle: Obstacle, end: Option<End>) -> Feature {
        match obstacle {
            Obstacle::Disc(other) => Feature::Disc(other as u32),
            Obstacle::Wall(wall) => self.feature(wall, end),
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
