//! The way of a disc's centre, seen from a point.

use super::gap::{Gap, LineGap};
use crate::scalar::{Interval, Scalar};
use crate::vec2::Vec2;

/// A way on which a centre moves from a place and a velocity on.
pub trait Trajectory<S: Scalar>: Sized {
    /// Its distance from a line.
    type Line: LineGap<S>;
    /// Its distance from a point.
    type Circle: Gap<S>;

    /// Where it starts.
    fn offset(&self) -> &Vec2<S>;

    /// How fast.
    fn velocity(&self) -> &Vec2<S>;

    /// The same way, seen from elsewhere.
    #[must_use]
    fn seen_from(&self, point: &Vec2<S>) -> Self;

    /// Where the centre is at a time.
    fn at(&self, time: &S) -> Vec2<S>;

    /// How fast it is then.
    fn velocity_at(&self, time: &S) -> Vec2<S>;

    /// The rest of the way, from a time on.
    #[must_use]
    fn after(&self, time: &S) -> Self;

    /// A linear function of where the centre is, given for vectors.
    fn component(&self, of: impl Fn(&Vec2<S>) -> S) -> Self::Line;

    /// The square of the distance from the origin, less as much as makes it come
    /// to `gap` at the start.
    fn distance(&self, gap: S) -> Self::Circle;

    /// A bound of how far the centre gets from where it starts.
    fn range(&self, time: Interval) -> Interval;
}

/// Bounds of a vector's length.
pub(super) fn length<S: Scalar>(vector: &Vec2<S>) -> Interval {
    let [x, y] = [vector.x.hull(), vector.y.hull()];
    (x.square() + y.square()).sqrt()
}
