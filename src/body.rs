//! The bodies of a scene, their names, and what a disc touched last.

use std::fmt;

use crate::detect::Segment;
use crate::scalar::Scalar;
use crate::vec2::Vec2;

pub use crate::detect::End;

/// A disc or a wall, by its place in the scene. Discs come before walls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BodyId {
    /// The i-th disc, written `d<i>`.
    Disc(u32),
    /// The i-th wall, written `w<i>`.
    Wall(u32),
}

impl fmt::Display for BodyId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Disc(index) => write!(f, "d{index}"),
            Self::Wall(index) => write!(f, "w{index}"),
        }
    }
}

/// Two bodies that meet: a disc, and a disc of higher index or a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Pair {
    /// The disc, of two discs the one with the lower index.
    pub a: BodyId,
    /// The other disc, or the wall.
    pub b: BodyId,
}

impl Pair {
    /// The pair in its order, whichever body is named first.
    pub fn new(one: BodyId, other: BodyId) -> Self {
        Self {
            a: one.min(other),
            b: one.max(other),
        }
    }

    /// Whether the pairs have a disc in common; walls do not count, for an
    /// impact does not change them.
    pub fn shares_disc(&self, other: &Self) -> bool {
        let discs = |pair: &Self| [pair.a, pair.b];
        discs(self)
            .into_iter()
            .any(|body| matches!(body, BodyId::Disc(_)) && discs(other).contains(&body))
    }
}

impl fmt::Display for Pair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} and {}", self.a, self.b)
    }
}

/// What a disc can touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Feature {
    /// A disc.
    Disc(u32),
    /// The interior of a wall.
    Wall(u32),
    /// A point where walls end, by its place among [`World::corners`](crate::world::World).
    Corner(u32),
}

/// A mass: finite, or so large that collisions never deflect the body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mass<S> {
    /// A finite mass.
    Finite(S),
    /// Collisions never deflect the body; it may move (P5.3, D12).
    Infinite,
}

/// A disc in motion (P1.1): in binary64, one line of the cache.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub struct Disc<S> {
    /// Where the centre is.
    pub position: Vec2<S>,
    /// How fast it moves.
    pub velocity: Vec2<S>,
    /// The radius.
    pub radius: S,
    /// The mass.
    pub mass: Mass<S>,
    /// What it collided with last: it has parted from that by construction.
    pub last: Option<Feature>,
}

impl<S> Disc<S> {
    /// Whether collisions deflect the disc.
    pub fn is_movable(&self) -> bool {
        matches!(self.mass, Mass::Finite(_))
    }

    /// The same disc in another arithmetic.
    pub fn map<T>(&self, make: impl Fn(&S) -> T) -> Disc<T> {
        Disc {
            position: self.position.map(&make),
            velocity: self.velocity.map(&make),
            radius: make(&self.radius),
            mass: match &self.mass {
                Mass::Finite(mass) => Mass::Finite(make(mass)),
                Mass::Infinite => Mass::Infinite,
            },
            last: self.last,
        }
    }
}

impl<S: Scalar> Disc<S> {
    /// Moves freely for a time (P1.3).
    pub fn advance(&mut self, time: &S) {
        self.position = self.position.moved(&self.velocity, time);
    }
}

/// A wall.
#[derive(Clone, Debug)]
pub struct Wall<S> {
    /// Where it is.
    pub segment: Segment<S>,
    /// The corners that its end points are.
    pub corners: [u32; 2],
}

impl<S> Wall<S> {
    /// The corner at an end.
    pub fn corner(&self, end: End) -> u32 {
        self.corners[end as usize]
    }
}
