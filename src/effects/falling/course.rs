//! The timeline of bodies that fall, told in numbers of the arithmetic itself.

use super::air::{Air, Rate};
use super::medium::Marker;
use super::{Falling, Weight};
use crate::arithmetic::Arithmetic;
use crate::body::Disc;
use crate::effects::Course;
use crate::impact::Impact;
use crate::kernel::Kernel;
use crate::roots::Fades;
use crate::scalar::Scalar;
use crate::timeline::{Accumulation, Setup, Timed, Timeline};
use crate::vec2::Vec2;
use crate::world::World;

/// A timeline under gravity.
#[derive(Clone, Debug)]
struct Fallen<S, M>(Timeline<Falling<S, M>>)
where
    S: Scalar,
    M: Marker,
    Falling<S, M>: Timed;

/// The course of a world under gravity.
///
/// # Errors
///
/// It cannot be decided what the discs meet first.
pub(crate) fn fall<S>(
    world: World<S>,
    gravity: &Vec2<S>,
    until: &S,
    setup: &Setup<'_>,
) -> Result<Box<dyn Course<S>>, S::Doubt>
where
    S: Arithmetic,
    Falling<S>: Timed<Doubt = S::Doubt, Pull = Weight<Falling<S>>>,
{
    let gravity = gravity.map(lifted);
    let weight = |disc: &Disc<_>| match disc.is_movable() {
        true => Weight::free(gravity.clone(), ()),
        false => Weight::default(),
    };
    start(world, weight, until, setup)
}

/// The course of a world under gravity and drag of some rate.
///
/// # Errors
///
/// It cannot be decided what the discs meet first.
pub(crate) fn sink<S>(
    world: World<S>,
    gravity: &Vec2<S>,
    rate: &S,
    until: &S,
    setup: &Setup<'_>,
) -> Result<Box<dyn Course<S>>, S::Doubt>
where
    S: Arithmetic + Fades,
{
    let tends = gravity.map(|number| lifted(&(number.clone() / rate)));
    let rate = Rate(lifted::<S, Air>(rate));
    let weight = |disc: &Disc<_>| match disc.is_movable() {
        true => Weight::free(tends.clone(), rate.clone()),
        false => Weight::fixed(disc.velocity.clone(), rate.clone()),
    };
    start(world, weight, until, setup)
}

/// The course of a world whose discs are pulled in some way.
fn start<S, M>(
    world: World<S>,
    weight: impl Fn(&Disc<Falling<S, M>>) -> <Falling<S, M> as Kernel>::Pull,
    until: &S,
    setup: &Setup<'_>,
) -> Result<Box<dyn Course<S>>, S::Doubt>
where
    S: Arithmetic,
    M: Marker,
    Falling<S, M>: Timed<Doubt = S::Doubt>,
{
    let contacts = world.contacts.clone();
    let mut world = world.rebuilt(lifted);
    world.contacts = contacts;
    world.pulls = world.discs.iter().map(weight).collect();
    for disc in &mut world.discs {
        // What it has parted from it need not touch any more.
        disc.last = None;
    }
    let timeline = Timeline::with_setup(world, &Falling::new(until.clone()), setup)?;
    Ok(Box::new(Fallen(timeline)))
}

fn lifted<S: Clone, M>(number: &S) -> Falling<S, M> {
    Falling::new(number.clone())
}

fn landed<S: Clone, M>(number: &Falling<S, M>) -> S {
    number.0.clone()
}

impl<S, M> Course<S> for Fallen<S, M>
where
    S: Scalar,
    M: Marker,
    Falling<S, M>: Timed<Doubt = S::Doubt>,
{
    fn next_impact(&mut self, limit: &S) -> Result<Option<Impact<S>>, S::Doubt> {
        let impact = self.0.next_impact(&Falling::new(limit.clone()))?;
        Ok(impact.map(|impact| impact.map(landed)))
    }

    fn disc_count(&self) -> usize {
        self.0.disc_count()
    }

    fn now(&self) -> S {
        landed(self.0.now())
    }

    fn discs_at(&self, time: &S) -> Vec<Disc<S>> {
        let discs = self.0.discs_at(&Falling::new(time.clone()));
        discs.iter().map(|disc| disc.map(landed)).collect()
    }

    fn grazes(&self) -> u64 {
        self.0.grazes()
    }

    fn rests(&self) -> u64 {
        self.0.rests()
    }

    fn closest_call(&self) -> Option<f64> {
        self.0.closest_call()
    }

    fn accumulation(&self) -> Option<Accumulation<S>> {
        self.0.accumulation().map(|found| found.map(landed))
    }

    fn duplicate(&self) -> Box<dyn Course<S>> {
        Box::new(self.clone())
    }
}
