//! How an arithmetic takes the decisions that collisions consist of.
//!
//! Most compute: the formulas of [`detect`](crate::detect) and
//! [`respond`], one operation after the other. That is what the
//! methods of [`Kernel`] do unless an arithmetic has its own. One that stores
//! rounded numbers and yet decides exactly has: it takes each decision as a
//! whole, from the numbers that it stores.
//!
//! The time of a meeting need not be such a number: it is a [`Time`]. (The
//! pattern is that of the kernels of CGAL, the Computational Geometry Algorithms
//! Library.)

mod flight;
mod met;
mod pull;
mod time;

use std::cmp::Ordering::{Equal, Greater, Less};

use crate::algebra::Expression;
use crate::body::Disc;
use crate::detect::{
    End, Overlap, Segment, meet_circle, meet_segment, overlap_circle, overlap_segment,
};
use crate::respond::{self, Normal, Restitution};
use crate::scalar::{Exact, Interval, Scalar};
use crate::vec2::Vec2;

pub use flight::{Approach, Flight};
pub use met::{Glance, Met};
pub use pull::Pull;
pub use time::Time;

/// A number type, and how bodies whose numbers it holds collide.
///
/// The errors of all methods are open decisions.
pub trait Kernel: Scalar {
    /// A time at which bodies meet.
    type Time: Time<Self>;

    /// What acts on a disc in flight; nothing where motion is straight.
    type Pull: Pull<Self>;

    /// Whether it is remembered that bodies touch which were brought to their
    /// contact, since the numbers do not show it.
    const REMEMBERS_CONTACTS: bool = true;

    /// Whether free motion is straight: bodies that have parted then do not meet
    /// again before one of them collides.
    const IS_STRAIGHT: bool = true;

    /// Whether numbers are binary64 and discs move uniformly between impacts: as
    /// the stored numbers say, or as operations on them come to.
    const GLIDES: bool = false;

    /// Where a disc is after it has been in flight for so long.
    #[inline]
    fn position_after(flight: Flight<'_, Self>, time: &Self) -> Vec2<Self> {
        flight.disc.position.moved(&flight.disc.velocity, time)
    }

    /// How fast a disc moves after it has been in flight for so long.
    #[inline]
    fn velocity_after(flight: Flight<'_, Self>, time: &Self) -> Vec2<Self> {
        let _ = time;
        flight.disc.velocity.clone()
    }

    /// When two discs meet again that touch where the later one is, and part, or
    /// of which one only `skims` the other.
    #[inline]
    fn meet_disc_again(
        approach: &Approach<'_, Self>,
        skims: bool,
    ) -> Result<Option<Met<Self::Time>>, Self::Doubt> {
        let _ = (approach, skims);
        Ok(None)
    }

    /// When a disc gets to the end of a wall that holds it.
    #[inline]
    fn leave_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
    ) -> Result<Option<Met<Self::Time>>, Self::Doubt> {
        let _ = (flight, wall);
        Ok(None)
    }

    /// Where a disc is that has got to the interior of a wall, which its numbers may
    /// not show.
    #[inline]
    fn place_at_wall(disc: &Disc<Self>, wall: &Segment<Self>) -> Vec2<Self> {
        let _ = wall;
        disc.position.clone()
    }

    /// Bounds of how long a disc that has just hit a wall bounces on it, if nothing else
    /// happens, and each impact leaves so much of its speed.
    #[inline]
    fn bouncing(flight: Flight<'_, Self>, wall: &Segment<Self>, kept: &Self) -> Option<[Self; 2]> {
        let _ = (flight, wall, kept);
        None
    }

    /// When a disc meets a wall again that it touches, in its interior or at an
    /// end point, and parts from, or only `skims`.
    #[inline]
    fn meet_wall_again(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        touched: Option<End>,
        skims: bool,
    ) -> Result<Option<Met<Self::Time>>, Self::Doubt> {
        let _ = (flight, wall, touched, skims);
        Ok(None)
    }

    /// When two discs meet, at least one of which can be deflected.
    #[inline]
    fn meet_discs(approach: &Approach<'_, Self>) -> Result<Option<Met<Self::Time>>, Self::Doubt> {
        let met = meet_circle(&approach.offset(), &approach.velocity(), &approach.reach())?;
        Ok(met.map(|encounter| Met::after(approach.late.since, encounter)))
    }

    /// When a disc meets a wall. The end points for which `barred` holds are
    /// known not to be met.
    #[inline]
    fn meet_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        barred: impl Fn(End) -> bool,
    ) -> Result<Option<Met<Self::Time>>, Self::Doubt> {
        let Disc {
            position,
            velocity,
            radius,
            ..
        } = flight.disc;
        let met = meet_segment(position, velocity, radius, wall, barred)?;
        Ok(met.map(|encounter| Met::after(flight.since, encounter)))
    }

    /// The time of a meeting that is ahead within these bounds, where they tell
    /// it.
    #[inline]
    fn time_within(bounds: Interval) -> Option<Self::Time> {
        let _ = bounds;
        None
    }

    /// What can quickly be told of the meeting of two discs.
    #[inline]
    fn glance_at_discs(approach: &Approach<'_, Self>) -> Glance {
        let _ = approach;
        Glance::Open
    }

    /// What can quickly be told of the meeting of a disc and a wall.
    #[inline]
    fn glance_at_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        barred: impl Fn(End) -> bool,
    ) -> Glance {
        let _ = (flight, wall, barred);
        Glance::Open
    }

    /// Where a disc is at a time, if nothing changes its motion.
    #[inline]
    fn position_at(flight: Flight<'_, Self>, time: &Self::Time) -> Vec2<Self> {
        Self::position_after(flight, &(time.value() - flight.since))
    }

    /// How fast a disc moves at a time, if nothing changes its motion.
    #[inline]
    fn velocity_at(flight: Flight<'_, Self>, time: &Self::Time) -> Vec2<Self> {
        if Self::IS_STRAIGHT {
            return flight.disc.velocity.clone();
        }
        Self::velocity_after(flight, &(time.value() - flight.since))
    }

    /// The overlap of two discs, if there is one.
    fn overlap_discs(
        first: &Disc<Self>,
        second: &Disc<Self>,
    ) -> Result<Option<Overlap<Self>>, Self::Doubt> {
        let offset = second.position.minus(&first.position);
        let reach = first.radius.clone() + &second.radius;
        overlap_circle(&offset, &reach)
    }

    /// The overlap of a disc and a wall, if there is one.
    fn overlap_wall(
        disc: &Disc<Self>,
        wall: &Segment<Self>,
    ) -> Result<Option<Overlap<Self>>, Self::Doubt> {
        overlap_segment(&disc.position, &disc.radius, wall)
    }

    /// Whether a disc moves towards a point that moves.
    fn approaches_point(
        disc: &Disc<Self>,
        point: &Vec2<Self>,
        velocity: &Vec2<Self>,
    ) -> Result<bool, Self::Doubt> {
        let closing = disc.velocity.minus(velocity);
        let offset = point.minus(&disc.position);
        Ok(closing.dot(&offset).sign()? == Greater)
    }

    /// Whether a disc moves towards a wall's line.
    fn approaches_wall(disc: &Disc<Self>, wall: &Segment<Self>) -> Result<bool, Self::Doubt> {
        let side = disc.position.minus(&wall.from).cross(&wall.along);
        let drift = disc.velocity.cross(&wall.along);
        Ok(match side.sign()? {
            Equal => false,
            Less => drift.sign()? == Greater,
            Greater => drift.sign()? == Less,
        })
    }

    /// Resolves the impact of two discs whose centres are at these places, on a
    /// normal that goes from the first to the second one.
    fn collide_discs(
        [first, second]: [&mut Disc<Self>; 2],
        centres: [&Vec2<Self>; 2],
        normal: &Normal<Self>,
        restitution: &Restitution<Self>,
    ) -> Result<(), Self::Doubt> {
        let _ = centres;
        respond::collide_discs(first, second, normal, restitution)
    }

    /// Resolves the impact of a disc, whose centre is at the first of two
    /// places, on a point at the second one.
    fn collide_point(
        disc: &mut Disc<Self>,
        places: [&Vec2<Self>; 2],
        normal: &Normal<Self>,
        restitution: &Restitution<Self>,
    ) -> Result<(), Self::Doubt> {
        let _ = places;
        respond::collide_wall(disc, normal, restitution)
    }

    /// Resolves the impact of a disc on the interior of a wall.
    fn collide_wall(
        disc: &mut Disc<Self>,
        wall: &Segment<Self>,
        normal: &Normal<Self>,
        restitution: &Restitution<Self>,
    ) -> Result<(), Self::Doubt> {
        let _ = wall;
        respond::collide_wall(disc, normal, restitution)
    }
}

impl Kernel for f64 {
    type Time = Self;
    type Pull = ();

    const GLIDES: bool = true;

    #[inline]
    fn time_within(bounds: Interval) -> Option<Self> {
        Some(bounds.lo())
    }

    #[inline]
    fn glance_at_discs(approach: &Approach<'_, Self>) -> Glance {
        let Ok(met) = Self::meet_discs(approach);
        Glance::at(met)
    }

    #[inline]
    fn glance_at_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        barred: impl Fn(End) -> bool,
    ) -> Glance {
        let Ok(met) = Self::meet_wall(flight, wall, barred);
        Glance::at(met)
    }
}

impl Kernel for Interval {
    type Time = Self;
    type Pull = ();
}

impl Kernel for Exact {
    type Time = Self;
    type Pull = ();
}

impl Kernel for Expression {
    type Time = Self;
    type Pull = ();
}
