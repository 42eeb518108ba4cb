//! Whether three bodies that collapse are left alone until then.
//!
//! Until the limit each body stays within a box, in binary64 bounds. The outer
//! bodies are only pushed outwards, so their velocities lie between what they
//! are now and what they tend to: that of the common centre of mass, or of the
//! one that has infinite mass. The gaps together never grow, so the middle
//! disc stays within the present gap of the body that it has just hit. All
//! other discs must have nothing to meet before the limit, and fly freely.
//! Boxes that do not overlap do not collide.
//!
//! The boxes shrink with the time that is left. Where they are too large the
//! answer is no, and the next impacts are closer to the limit.

use super::trio::{Side, Trio};
use crate::body::{BodyId, Mass};
use crate::kernel::Kernel;
use crate::scalar::Interval;
use crate::timeline::flight::Start;
use crate::timeline::{Timed, Timeline};
use crate::vec2::Vec2;
use crate::world::{Obstacle, World};

impl<S: Timed> Timeline<S> {
    /// Whether nothing but each other touches the three before the limit.
    pub(super) fn is_alone(&self, trio: &Trio<S>) -> bool {
        let end = trio.limit.hull().hi();
        if !end.is_finite()
            || !self.others_are_free(|disc| trio.contains(Obstacle::Disc(disc)), end)
        {
            return false;
        }
        let now = self.now.hull();
        let span = Interval::new(now.lo(), end.max(now.hi()));
        let world = self.boxes(trio, span);
        let is_partner = |other| trio.contains(other);
        trio.moved().all(|disc| is_apart(&world, disc, is_partner)) && stays_at_walls(&world, trio)
    }

    /// Whether no disc but some meets anything before a time.
    pub(super) fn others_are_free(&self, is_one: impl Fn(usize) -> bool, end: f64) -> bool {
        let mut forecasts = self.forecasts.iter().enumerate();
        forecasts.all(|(disc, next)| {
            let is_later = next.as_ref().is_none_or(|next| next.bounds.lo() > end);
            is_later || is_one(disc)
        })
    }

    /// Where free discs are throughout a span of time.
    pub(super) fn sweep(&self, span: Interval) -> World<Interval> {
        let mut world = self.flights.world.hull();
        for (disc, Start { since, .. }) in world.discs.iter_mut().zip(&self.flights.starts) {
            disc.position = disc.position.moved(&disc.velocity, &(span - since.hull()));
        }
        world
    }

    /// Where all discs are throughout the span of time up to the limit.
    fn boxes(&self, trio: &Trio<S>, span: Interval) -> World<Interval> {
        let mut world = self.sweep(span);
        let rest = Interval::new(0.0, (span - Interval::new(span.lo(), span.lo())).hi());
        let place = |disc: usize| self.flights.position_at(disc, &self.now).map(S::hull);
        let [a, b] = [0, 1].map(|side| trio.velocities(side).scaled(&rest));
        for (side, motion) in trio.sides.iter().zip([&a, &b]) {
            if let BodyId::Disc(disc) = side.body {
                world.discs[disc as usize].position = place(disc as usize).plus(motion);
            }
        }
        let gap = Interval::new(-trio.gap.hull().hi().max(0.0), 0.0);
        let unit = trio.unit.map(S::hull);
        world.discs[trio.middle].position = place(trio.middle).plus(&a).moved(&unit, &gap);
        world
    }
}

impl<S: Kernel> Trio<S> {
    /// Its discs that collisions deflect.
    fn moved(&self) -> impl Iterator<Item = usize> {
        let sides = self.sides.iter().filter_map(|side| match side {
            Side {
                body: BodyId::Disc(disc),
                mass: Mass::Finite(_),
                ..
            } => Some(*disc as usize),
            _ => None,
        });
        sides.chain([self.middle])
    }

    fn contains(&self, obstacle: Obstacle) -> bool {
        let body = match obstacle {
            Obstacle::Disc(disc) if disc == self.middle => return true,
            Obstacle::Disc(disc) => BodyId::Disc(disc as u32),
            Obstacle::Wall(wall) => BodyId::Wall(wall as u32),
        };
        self.sides.iter().any(|side| side.body == body)
    }

    /// Bounds of a side's velocity until the limit.
    fn velocities(&self, side: usize) -> Vec2<Interval> {
        let own = self.sides[side].velocity.map(S::hull);
        match self.sides[side].mass {
            Mass::Infinite => own,
            Mass::Finite(_) => {
                let last = self.last_velocity.map(S::hull);
                Vec2::new(join(own.x, last.x), join(own.y, last.y))
            }
        }
    }
}

/// Whether a disc's box overlaps no other body's but its partners'.
pub(super) fn is_apart(
    world: &World<Interval>,
    disc: usize,
    is_partner: impl Fn(Obstacle) -> bool,
) -> bool {
    let discs = (0..world.discs.len()).map(Obstacle::Disc);
    let walls = (0..world.walls.len()).map(Obstacle::Wall);
    let mut others = discs.chain(walls).filter(|&other| !is_partner(other));
    others.all(|other| matches!(world.overlap(disc, other), Ok(None)))
}

/// Whether the middle disc stays between the ends of the walls that it hits.
fn stays_at_walls<S: Kernel>(world: &World<Interval>, trio: &Trio<S>) -> bool {
    trio.sides.iter().all(|side| match side.body {
        BodyId::Disc(_) => true,
        BodyId::Wall(wall) => stays_beside(world, trio.middle, wall as usize),
    })
}

/// Whether all of a disc's box is between the ends of a wall.
pub(super) fn stays_beside(world: &World<Interval>, disc: usize, wall: usize) -> bool {
    let segment = &world.walls[wall].segment;
    segment.is_surely_beside(&world.discs[disc].position)
}

/// The least interval that contains two.
fn join(one: Interval, other: Interval) -> Interval {
    Interval::new(one.lo().min(other.lo()), one.hi().max(other.hi()))
}
