//! What pulls a disc, and what holds it.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::Falling;
use crate::body::{Disc, Wall};
use crate::detect::Segment;
use crate::kernel::Pull;
use crate::roots::Roots;
use crate::scalar::{Interval, Scalar};
use crate::vec2::Vec2;

/// What pulls a disc, and what holds it.
#[derive(Clone, Debug)]
pub struct Weight<S> {
    /// Its acceleration.
    pub(super) acting: Vec2<S>,
    /// The acceleration if nothing holds it.
    gravity: Vec2<S>,
    state: State,
    skims: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    /// A body of infinite mass does not fall.
    Fixed,
    Free,
    /// Held by a wall, or in the groove of two.
    Held(usize, Option<usize>),
}

impl<S: Scalar> Weight<S> {
    pub(super) fn on(disc: &Disc<S>, gravity: Option<&Vec2<S>>) -> Self {
        let state = if disc.is_movable() {
            State::Free
        } else {
            State::Fixed
        };
        let gravity = gravity.filter(|_| state == State::Free);
        let gravity = gravity.cloned().unwrap_or_default();
        Self {
            acting: gravity.clone(),
            gravity,
            state,
            skims: false,
        }
    }

    /// Whether nothing but gravity acts.
    pub(super) fn is_free(&self) -> bool {
        self.state == State::Free
    }
}

/// Which way a vector points, seen from a wall: away from it on the side of a
/// disc, or towards it.
fn away<S: Scalar>(
    vector: &Vec2<S>,
    disc: &Disc<S>,
    wall: &Segment<S>,
) -> Result<Ordering, S::Doubt> {
    let side = disc.position.minus(&wall.from).cross(&wall.along).sign()?;
    let across = vector.cross(&wall.along).sign()?;
    Ok(if side == Less {
        across.reverse()
    } else {
        across
    })
}

/// The part of a vector along a wall: all of it, if it is exactly so, and exactly
/// so along an axis.
fn along<S: Scalar>(vector: &Vec2<S>, wall: &Segment<S>) -> Vec2<S> {
    let zero = || S::from_integer(0);
    if wall.along.x.is_surely_zero() {
        return Vec2::new(zero(), vector.y.clone());
    }
    if wall.along.y.is_surely_zero() {
        return Vec2::new(vector.x.clone(), zero());
    }
    let across = vector.cross(&wall.along) / &wall.length_squared;
    vector.moved(&wall.along.perpendicular(), &across)
}

impl<S: Roots> Weight<Falling<S>> {
    /// Notes that a disc that a wall holds was held by another one up to now. If
    /// they are at a right angle it is stopped; at rest, and pulled towards both,
    /// it stays where it is.
    fn rest_between(
        &mut self,
        disc: &mut Disc<Falling<S>>,
        [wall, other]: [usize; 2],
        walls: &[Wall<Falling<S>>],
    ) -> Result<(), S::Doubt> {
        let [new, old] = [wall, other].map(|wall| &walls[wall].segment);
        if new.along.dot(&old.along).is_surely_zero() {
            disc.velocity = Vec2::zero();
        }
        let rests = disc.velocity.x.is_surely_zero() && disc.velocity.y.is_surely_zero();
        if rests && away(&self.acting, disc, old)? == Less {
            self.acting = Vec2::zero();
            self.state = State::Held(wall, Some(other));
        }
        Ok(())
    }
}

impl<S: Roots> Pull<Falling<S>> for Weight<Falling<S>> {
    fn acceleration(&self) -> Option<Vec2<Interval>> {
        Some(self.acting.map(Scalar::hull))
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
        disc: &mut Disc<Falling<S>>,
        wall: usize,
        walls: &[Wall<Falling<S>>],
    ) -> Result<(), S::Doubt> {
        let segment = &walls[wall].segment;
        if away(&self.gravity, disc, segment)? == Greater {
            self.let_go();
            return Ok(());
        }
        self.skims = false;
        disc.velocity = along(&disc.velocity, segment);
        self.acting = along(&self.gravity, segment);
        let before = std::mem::replace(&mut self.state, State::Held(wall, None));
        match before {
            State::Held(other, None) => self.rest_between(disc, [wall, other], walls),
            _ => Ok(()),
        }
    }

    fn let_go(&mut self) {
        self.skims = false;
        if self.state != State::Fixed {
            self.acting = self.gravity.clone();
            self.state = State::Free;
        }
    }

    fn slide_off(
        &mut self,
        disc: &Disc<Falling<S>>,
        corner: &Vec2<Falling<S>>,
    ) -> Result<bool, S::Doubt> {
        self.let_go();
        self.skim();
        let offset = disc.position.minus(corner);
        let bend = disc.velocity.norm_squared() + offset.dot(&self.gravity);
        let drift = disc.velocity.dot(&self.gravity);
        Ok(match (bend.sign()?, drift.sign()?) {
            (Less, _) | (Equal, Less) => false,
            (Greater, _) | (Equal, Equal | Greater) => true,
        })
    }
}
