//! Gravity and drag in the frame algorithms (D19): the velocity changes at the
//! start of a frame, and is constant within it.

use crate::kernel::Kernel;
use crate::scalar::Number;
use crate::scene::Effects;
use crate::vec2::Vec2;
use crate::world::World;

/// What changes the velocity of each disc of finite mass.
#[derive(Clone, Debug)]
pub struct Forces<S> {
    gravity: Option<Vec2<S>>,
    drag: Option<S>,
}

impl<S: Kernel> Forces<S> {
    /// The forces of a scene, if it names any.
    pub fn of(effects: &Effects, precision: S::Precision) -> Option<Self> {
        let number = |written: &Number| S::from_number(written, precision);
        let gravity = effects.gravity.as_ref();
        let forces = Self {
            gravity: gravity.map(|[x, y]| Vec2::new(number(x), number(y))),
            drag: effects.drag.as_ref().map(number),
        };
        (forces.gravity.is_some() || forces.drag.is_some()).then_some(forces)
    }

    /// Changes all velocities by (g - k v) Δt. Bodies that have parted may then
    /// meet again.
    pub fn act(&self, world: &mut World<S>, duration: &S) {
        for disc in world.discs.iter_mut().filter(|disc| disc.is_movable()) {
            let gain = self.acceleration(&disc.velocity);
            disc.velocity = disc.velocity.moved(&gain, duration);
            disc.last = None;
        }
    }

    fn acceleration(&self, velocity: &Vec2<S>) -> Vec2<S> {
        let pull = self.gravity.clone().unwrap_or_default();
        match &self.drag {
            Some(rate) => pull.moved(velocity, &-rate.clone()),
            None => pull,
        }
    }
}
