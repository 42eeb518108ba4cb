//! The timeline under whatever acts in a scene.

use super::Dragged;
use crate::arithmetic::Arithmetic;
use crate::body::Disc;
use crate::impact::Impact;
use crate::kernel::Kernel;
use crate::scalar::{Number, Scalar};
use crate::scene::{Effects, Restitution};
use crate::timeline::{Accumulation, Periodic, Setup, Timed, Timeline};
use crate::vec2::Vec2;
use crate::world::World;

/// The course of events in a world, one impact after the other.
pub trait Course<S: Scalar>: std::fmt::Debug + Send + Sync {
    /// The next impact, if it is not after `limit`. There is none if
    /// infinitely many precede that (see [`accumulation`](Self::accumulation)).
    ///
    /// # Errors
    ///
    /// It cannot be decided which impact is the next.
    fn next_impact(&mut self, limit: &S) -> Result<Option<Impact<S>>, S::Doubt>;

    /// How many discs there are.
    fn disc_count(&self) -> usize;

    /// The time of the latest impact.
    fn now(&self) -> S;

    /// The discs as they are at a time: not before the latest impact, nor
    /// after the next one.
    fn discs_at(&self, time: &S) -> Vec<Disc<S>>;

    /// How many tangent passes there were so far.
    fn grazes(&self) -> u64;

    /// How many contacts became resting so far.
    fn rests(&self) -> u64;

    /// The least difference, relative to either, of two different times of which
    /// it had to be found out which is the first, or less. Exact arithmetic
    /// only.
    fn closest_call(&self) -> Option<f64>;

    /// The accumulation before which the course ends, if it does.
    fn accumulation(&self) -> Option<Accumulation<S>>;

    /// The same course once more.
    fn duplicate(&self) -> Box<dyn Course<S>>;
}

impl<S: Scalar> Clone for Box<dyn Course<S>> {
    fn clone(&self) -> Self {
        self.duplicate()
    }
}

/// What starts a course under gravity.
pub type Fall<S> =
    fn(World<S>, &Vec2<S>, &S, &Setup<'_>) -> Result<Box<dyn Course<S>>, <S as Scalar>::Doubt>;

/// What starts a course under gravity and drag of some rate.
pub type Sink<S> =
    fn(World<S>, &Vec2<S>, &S, &S, &Setup<'_>) -> Result<Box<dyn Course<S>>, <S as Scalar>::Doubt>;

/// Whether drag takes more than time that is warped: something acts that does not
/// fade as all motion does.
pub(crate) fn is_air(effects: &Effects, has_moving_wall: bool) -> bool {
    let tells_slow = matches!(
        effects.restitution,
        Restitution::Newton {
            elastic_below: Some(_),
            ..
        }
    );
    effects.drag.is_some() && (effects.gravity.is_some() || has_moving_wall || tells_slow)
}

/// The course of a world from time zero to `until` under the effects of a scene
/// that is supported. Each effect has its line here.
///
/// # Errors
///
/// It cannot be decided what the discs meet first.
pub fn course<S: Arithmetic>(
    world: World<S>,
    effects: &Effects,
    until: &S,
    setup: &Setup<'_>,
    precision: S::Precision,
) -> Result<Box<dyn Course<S>>, S::Doubt> {
    if let Some(period) = world.period.clone() {
        return Ok(Box::new(Periodic::new(world, period, until)?));
    }
    let number = |written: &Number| S::from_number(written, precision);
    let gravity = effects.gravity.as_ref();
    let gravity = gravity.map(|[x, y]| Vec2::new(number(x), number(y)));
    if let (Some(rate), Some(sink)) = (&effects.drag, S::SINK)
        && is_air(effects, has_moving_wall(&world))
    {
        let gravity = gravity.unwrap_or_default();
        return sink(world, &gravity, &number(rate), until, setup);
    }
    if let Some(gravity) = gravity {
        return S::FALL(world, &gravity, until, setup);
    }
    if let Some(rate) = &effects.drag {
        return Ok(Box::new(Dragged::new(world, number(rate), until, setup)?));
    }
    Ok(Box::new(Timeline::with_setup(world, until, setup)?))
}

fn has_moving_wall<S: Kernel>(world: &World<S>) -> bool {
    let rests = |disc: &Disc<S>| {
        let Vec2 { x, y } = &disc.velocity;
        x.is_surely_zero() && y.is_surely_zero()
    };
    let mut discs = world.discs.iter();
    discs.any(|disc| !disc.is_movable() && !rests(disc))
}

impl<S: Timed> Course<S> for Timeline<S> {
    fn next_impact(&mut self, limit: &S) -> Result<Option<Impact<S>>, S::Doubt> {
        Self::next_impact(self, limit)
    }

    fn disc_count(&self) -> usize {
        Self::disc_count(self)
    }

    fn now(&self) -> S {
        Self::now(self).clone()
    }

    fn discs_at(&self, time: &S) -> Vec<Disc<S>> {
        Self::discs_at(self, time)
    }

    fn grazes(&self) -> u64 {
        Self::grazes(self)
    }

    fn rests(&self) -> u64 {
        Self::rests(self)
    }

    fn closest_call(&self) -> Option<f64> {
        Self::closest_call(self)
    }

    fn accumulation(&self) -> Option<Accumulation<S>> {
        Self::accumulation(self).cloned()
    }

    fn duplicate(&self) -> Box<dyn Course<S>> {
        Box::new(self.clone())
    }
}
