//! Parabolas: the ways of what falls in a vacuum.

use std::cmp::Ordering;

use super::gap::{Gap, Met, Quadratic};
use super::trajectory::{Trajectory, length};
use crate::detect::Encounter;
use crate::roots::{Polynomial, Roots};
use crate::scalar::{Interval, Scalar};
use crate::vec2::Vec2;

/// A parabola: d + v t + h t², where h is half the acceleration.
#[derive(Clone, Debug)]
pub struct Arc<S> {
    pub(super) offset: Vec2<S>,
    pub(super) velocity: Vec2<S>,
    half_pull: Vec2<S>,
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

    /// A linear function of where the centre is, given for vectors.
    pub(super) fn quadratic(&self, of: impl Fn(&Vec2<S>) -> S) -> Quadratic<S> {
        let [c, b, a] = [&self.offset, &self.velocity, &self.half_pull].map(of);
        Quadratic { a, b, c }
    }

    /// Where the centre is at a time.
    pub(super) fn at(&self, time: &S) -> Vec2<S> {
        let velocity = self.velocity.moved(&self.half_pull, time);
        self.offset.moved(&velocity, time)
    }
}

impl<S: Roots> Trajectory<S> for Arc<S> {
    type Line = Quadratic<S>;
    type Circle = Quartic<S>;

    fn offset(&self) -> &Vec2<S> {
        &self.offset
    }

    fn velocity(&self) -> &Vec2<S> {
        &self.velocity
    }

    fn seen_from(&self, point: &Vec2<S>) -> Self {
        Self {
            offset: self.offset.minus(point),
            ..self.clone()
        }
    }

    fn at(&self, time: &S) -> Vec2<S> {
        self.at(time)
    }

    fn velocity_at(&self, time: &S) -> Vec2<S> {
        let twice = S::from_integer(2) * time;
        self.velocity.moved(&self.half_pull, &twice)
    }

    fn after(&self, time: &S) -> Self {
        Self {
            offset: self.at(time),
            velocity: self.velocity_at(time),
            ..self.clone()
        }
    }

    fn component(&self, of: impl Fn(&Vec2<S>) -> S) -> Quadratic<S> {
        self.quadratic(of)
    }

    /// ```text
    /// (h·h) t⁴ + 2 (v·h) t³ + (v·v + 2 d·h) t² + 2 (d·v) t + (d·d - R²)
    /// ```
    fn distance(&self, gap: S) -> Quartic<S> {
        let Self {
            offset,
            velocity,
            half_pull,
        } = self;
        let two = || S::from_integer(2);
        Quartic([
            gap,
            two() * offset.dot(velocity),
            velocity.norm_squared() + two() * offset.dot(half_pull),
            two() * velocity.dot(half_pull),
            half_pull.norm_squared(),
        ])
    }

    /// |v| t + |h| t².
    fn range(&self, time: Interval) -> Interval {
        length(&self.velocity) * time + length(&self.half_pull) * time.square()
    }
}

/// A polynomial of the fourth degree, the constant term first.
pub struct Quartic<S>([S; 5]);

impl<S: Roots> Gap<S> for Quartic<S> {
    fn sign(&self, derivative: usize) -> Result<Ordering, S::Doubt> {
        self.0[derivative].sign()
    }

    /// What is known to be zero at the start is divided out.
    fn descent(&self, zeros: usize) -> Met<S> {
        let zero = |_: &S| S::from_integer(0);
        let mut coefficients = self.0.each_ref().map(zero);
        coefficients[..self.0.len() - zeros].clone_from_slice(&self.0[zeros..]);
        let met = S::descent(&Polynomial(coefficients))?;
        Ok(met.map(|met| Encounter {
            graze: met.graze,
            ..Encounter::impact(met.time)
        }))
    }
}
