//! What pulls a disc, and what holds it.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::Falling;
use super::gap::Gap;
use super::medium::{Drag, Medium};
use super::trajectory::Trajectory;
use crate::body::{Disc, Wall};
use crate::detect::Segment;
use crate::kernel::{Kernel, Pull};
use crate::scalar::{Interval, Scalar};
use crate::vec2::Vec2;

/// What pulls a disc, and what holds it, in a medium of some [`Drag`].
#[derive(Clone, Debug)]
pub struct Weight<S, D = ()> {
    /// What pulls it.
    pub(super) acting: Vec2<S>,
    /// What does if nothing holds it.
    free: Vec2<S>,
    pub(super) drag: D,
    state: State,
    skims: bool,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum State {
    /// A body of infinite mass does not fall.
    #[default]
    Fixed,
    Free,
    /// Held by a wall, or in the groove of two.
    Held(usize, Option<usize>),
}

impl<S: Scalar, D: Drag<S>> Default for Weight<S, D> {
    fn default() -> Self {
        Self::fixed(Vec2::zero(), D::default())
    }
}

impl<S: Scalar, D: Drag<S>> Weight<S, D> {
    /// That of a body that falls.
    pub(super) fn free(pull: Vec2<S>, drag: D) -> Self {
        Self {
            state: State::Free,
            ..Self::fixed(pull, drag)
        }
    }

    /// That of a body which nothing slows down or pulls: as that of one which falls
    /// the same way.
    pub(super) fn fixed(pull: Vec2<S>, drag: D) -> Self {
        Self {
            acting: pull.clone(),
            free: pull,
            drag,
            state: State::Fixed,
            skims: false,
        }
    }

    /// Whether nothing holds it, of what falls.
    pub(super) fn is_free(&self) -> bool {
        self.state == State::Free
    }
}

/// What has to be decided of a disc that walls hold.
pub trait Holding: Kernel<Pull = Weight<Self, Self::Drag>> {
    /// What of a medium a body has to know.
    type Drag: Drag<Self>;

    /// Which way a vector points, seen from a wall: away from it on the side of a
    /// disc, or towards it.
    ///
    /// # Errors
    ///
    /// It is open.
    fn away(
        vector: &Vec2<Self>,
        disc: &Disc<Self>,
        wall: &Segment<Self>,
    ) -> Result<Ordering, Self::Doubt>;

    /// The part of a vector along a wall: all of it, if it is exactly so, and exactly
    /// so along an axis.
    fn along(vector: &Vec2<Self>, wall: &Segment<Self>) -> Vec2<Self>;

    /// Whether two walls are surely at a right angle.
    fn are_square(one: &Segment<Self>, other: &Segment<Self>) -> bool;

    /// Which way the gap grows of a disc that touches a corner, and moves at a
    /// right angle to the normal: by its second derivative or, where that is
    /// zero, the third one.
    ///
    /// # Errors
    ///
    /// It is open.
    fn bend(
        disc: &Disc<Self>,
        corner: &Vec2<Self>,
        pull: &Vec2<Self>,
        drag: &Self::Drag,
    ) -> Result<Ordering, Self::Doubt>;
}

impl<S: Scalar, M: Medium<S>> Holding for Falling<S, M> {
    type Drag = M::Drag;

    fn away(
        vector: &Vec2<Self>,
        disc: &Disc<Self>,
        wall: &Segment<Self>,
    ) -> Result<Ordering, S::Doubt> {
        let side = disc.position.minus(&wall.from).cross(&wall.along).sign()?;
        let across = vector.cross(&wall.along).sign()?;
        Ok(if side == Less {
            across.reverse()
        } else {
            across
        })
    }

    fn along(vector: &Vec2<Self>, wall: &Segment<Self>) -> Vec2<Self> {
        let zero = || Self::from_integer(0);
        if wall.along.x.is_surely_zero() {
            return Vec2::new(zero(), vector.y.clone());
        }
        if wall.along.y.is_surely_zero() {
            return Vec2::new(vector.x.clone(), zero());
        }
        let across = vector.cross(&wall.along) / &wall.length_squared;
        vector.moved(&wall.along.perpendicular(), &across)
    }

    fn are_square(one: &Segment<Self>, other: &Segment<Self>) -> bool {
        one.along.dot(&other.along).is_surely_zero()
    }

    fn bend(
        disc: &Disc<Self>,
        corner: &Vec2<Self>,
        pull: &Vec2<Self>,
        drag: &M::Drag,
    ) -> Result<Ordering, S::Doubt> {
        let offset = disc.position.minus(corner);
        let way = M::way(offset, disc.velocity.clone(), pull, drag);
        let gap = way.distance(Self::from_integer(0));
        Ok(match gap.sign(2)? {
            Equal => gap.sign(3)?,
            bend => bend,
        })
    }
}

impl<S: Holding> Weight<S, S::Drag> {
    /// Notes that a disc that a wall holds was held by another one up to now. If
    /// they are at a right angle it is stopped; at rest, and pulled towards both,
    /// it stays where it is.
    fn rest_between(
        &mut self,
        disc: &mut Disc<S>,
        [wall, other]: [usize; 2],
        walls: &[Wall<S>],
    ) -> Result<(), S::Doubt> {
        let [new, old] = [wall, other].map(|wall| &walls[wall].segment);
        if S::are_square(new, old) {
            disc.velocity = Vec2::zero();
        }
        let rests = disc.velocity.x.is_surely_zero() && disc.velocity.y.is_surely_zero();
        if rests && S::away(&self.acting, disc, old)? == Less {
            self.acting = Vec2::zero();
            self.state = State::Held(wall, Some(other));
        }
        Ok(())
    }
}

impl<S: Holding> Pull<S> for Weight<S, S::Drag> {
    fn acceleration(&self, disc: &Disc<S>) -> Option<Vec2<Interval>> {
        let moves = self.state != State::Fixed;
        Some(match moves {
            true => self.drag.acceleration(&self.acting, disc),
            false => Vec2::zero(),
        })
    }

    fn holders(&self) -> [Option<usize>; 2] {
        match self.state {
            State::Held(wall, other) => [Some(wall), other],
            State::Fixed | State::Free => [None; 2],
        }
    }

    fn skims(&self) -> bool {
        self.skims
    }

    fn skim(&mut self) {
        self.skims = true;
    }

    fn rest_on(
        &mut self,
        disc: &mut Disc<S>,
        wall: usize,
        walls: &[Wall<S>],
    ) -> Result<(), S::Doubt> {
        let segment = &walls[wall].segment;
        if S::away(&self.free, disc, segment)? == Greater {
            self.let_go();
            return Ok(());
        }
        self.skims = false;
        disc.velocity = S::along(&disc.velocity, segment);
        self.acting = S::along(&self.free, segment);
        let before = std::mem::replace(&mut self.state, State::Held(wall, None));
        match before {
            State::Held(other, None) => self.rest_between(disc, [wall, other], walls),
            _ => Ok(()),
        }
    }

    fn let_go(&mut self) {
        self.skims = false;
        if self.state != State::Fixed {
            self.acting = self.free.clone();
            self.state = State::Free;
        }
    }

    fn slide_off(&mut self, disc: &Disc<S>, corner: &Vec2<S>) -> Result<bool, S::Doubt> {
        self.let_go();
        self.skim();
        Ok(S::bend(disc, corner, &self.free, &self.drag)? != Less)
    }
}
