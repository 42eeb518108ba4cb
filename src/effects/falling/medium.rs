//! What bodies fall through.

use std::fmt::Debug;

use super::Falling;
use super::arc::Arc;
use super::gap::Met;
use super::trajectory::Trajectory;
use crate::body::Disc;
use crate::detect::meet_circle;
use crate::roots::Roots;
use crate::scalar::{Interval, Scalar};
use crate::vec2::Vec2;

/// A type that names a medium.
pub trait Marker: Copy + Debug + PartialEq + Send + Sync + 'static {}

/// How much a medium resists.
pub trait Drag<S: Scalar>: Clone + Debug + Default + Send + Sync + 'static {
    /// Bounds of a disc's acceleration from now on, if this pulls it.
    fn acceleration(&self, pull: &Vec2<S>, disc: &Disc<S>) -> Vec2<Interval>;
}

/// How bodies fall through a medium.
///
/// What *pulls* them is given as it suits the medium: a vector along their
/// acceleration, at rest.
pub trait Medium<S: Scalar>: Marker {
    /// What of the medium a body has to know.
    type Drag: Drag<Falling<S, Self>>;

    /// A way through it.
    type Way: Trajectory<Falling<S, Self>>;

    /// The way from a place and a velocity on.
    fn way(
        offset: Vec2<Falling<S, Self>>,
        velocity: Vec2<Falling<S, Self>>,
        pull: &Vec2<Falling<S, Self>>,
        drag: &Self::Drag,
    ) -> Self::Way;

    /// When two bodies meet that both fall, as seen from one of them.
    fn meet_falling(
        offset: &Vec2<Falling<S, Self>>,
        velocity: &Vec2<Falling<S, Self>>,
        reach: &Falling<S, Self>,
        drag: &Self::Drag,
    ) -> Met<Falling<S, Self>>;
}

/// Nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Vacuum {}

impl Marker for Vacuum {}

impl<S: Scalar> Drag<S> for () {
    fn acceleration(&self, pull: &Vec2<S>, _: &Disc<S>) -> Vec2<Interval> {
        pull.map(Scalar::hull)
    }
}

/// What pulls is the acceleration.
impl<S: Roots> Medium<S> for Vacuum {
    type Drag = ();
    type Way = Arc<Falling<S>>;

    fn way(
        offset: Vec2<Falling<S>>,
        velocity: Vec2<Falling<S>>,
        pull: &Vec2<Falling<S>>,
        (): &(),
    ) -> Arc<Falling<S>> {
        Arc::new(offset, velocity, pull)
    }

    /// Straight.
    fn meet_falling(
        offset: &Vec2<Falling<S>>,
        velocity: &Vec2<Falling<S>>,
        reach: &Falling<S>,
        (): &(),
    ) -> Met<Falling<S>> {
        meet_circle(offset, velocity, reach)
    }
}
