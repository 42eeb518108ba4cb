//! The way of a disc's centre, seen from a point.

use crate::scalar::Scalar;
use crate::vec2::Vec2;

/// A parabola: d + v t + h t², where h is half the acceleration.
#[derive(Clone, Debug)]
pub(super) struct Arc<S> {
    pub(super) offset: Vec2<S>,
    pub(super) velocity: Vec2<S>,
    pub(super) half_pull: Vec2<S>,
}

impl<S: Scalar> Arc<S> {
    /// The way under an acceleration.
    pub(super) fn new(offset: Vec2<S>, velocity: Vec2<S>, pull: &Vec2<S>) -> Self {
        let half = S::from_integer(1) / S::from_integer(2);
        Self {
            offset,
            velocity,
            half_pull: pull.scaled(&half),
        }
    }

    /// The same way, seen from elsewhere.
    pub(super) fn seen_from(&self, point: &Vec2<S>) -> Self {
        Self {
            offset: self.offset.minus(point),
            ..self.clone()
        }
    }

    /// What it is made of, by powers of the time.
    pub(super) fn powers(&self) -> [&Vec2<S>; 3] {
        [&self.offset, &self.velocity, &self.half_pull]
    }

    /// Where the centre is at a time.
    pub(super) fn at(&self, time: &S) -> Vec2<S> {
        let velocity = self.velocity.moved(&self.half_pull, time);
        self.offset.moved(&velocity, time)
    }
}
