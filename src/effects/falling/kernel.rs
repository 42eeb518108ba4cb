//! How bodies meet of which some fall.

use std::cmp::Ordering::{Greater, Less};

use super::Falling;
use super::circle;
use super::gap;
use super::medium::Medium;
use super::segment::{self, Touched};
use super::trajectory::Trajectory;
use super::weight::Weight;
use crate::body::Disc;
use crate::detect::{End, Segment};
use crate::kernel::{Approach, Flight, Kernel, Met};
use crate::scalar::Scalar;
use crate::vec2::Vec2;

impl<S: Scalar, M: Medium<S>> Kernel for Falling<S, M> {
    type Time = Self;
    type Pull = Weight<Self, M::Drag>;

    const IS_STRAIGHT: bool = false;

    fn position_after(flight: Flight<'_, Self>, time: &Self) -> Vec2<Self> {
        way(flight).at(time)
    }

    fn velocity_after(flight: Flight<'_, Self>, time: &Self) -> Vec2<Self> {
        way(flight).velocity_at(time)
    }

    fn meet_discs(approach: &Approach<'_, Self>) -> Result<Option<Met<Self>>, S::Doubt> {
        let reach = approach.reach();
        let met = match relative(approach) {
            None => {
                let (offset, velocity) = (approach.offset(), approach.velocity());
                M::meet_falling(&offset, &velocity, &reach, &approach.late.pull.drag)?
            }
            Some(way) => circle::meet(&way, &reach)?,
        };
        Ok(met.map(|met| Met::after(approach.late.since, met)))
    }

    fn meet_disc_again(
        approach: &Approach<'_, Self>,
        skims: bool,
    ) -> Result<Option<Met<Self>>, S::Doubt> {
        let Some(way) = relative(approach) else {
            return Ok(None);
        };
        let met = match skims {
            true => circle::leave(&way)?,
            false => circle::meet_again(&way)?,
        };
        Ok(met.map(|met| Met::after(approach.late.since, met)))
    }

    fn meet_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        barred: impl Fn(End) -> bool,
    ) -> Result<Option<Met<Self>>, S::Doubt> {
        let barred = [End::From, End::To].map(barred);
        meet_wall(flight, wall, Touched::Nothing { barred })
    }

    fn meet_wall_again(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        touched: Option<End>,
        skims: bool,
    ) -> Result<Option<Met<Self>>, S::Doubt> {
        let touched = Touched::of(touched, skims);
        meet_wall(flight, wall, touched)
    }

    fn leave_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
    ) -> Result<Option<Met<Self>>, S::Doubt> {
        let met = segment::leave(&way(flight).seen_from(&wall.from), wall)?;
        Ok(met.map(|met| Met::after(flight.since, met)))
    }

    /// Exactly its radius from a wall that is along an axis: so it is known whether it
    /// touches the line of another one too. Rounded numbers stay as they are.
    fn place_at_wall(disc: &Disc<Self>, wall: &Segment<Self>) -> Vec2<Self> {
        let Vec2 { x, y } = disc.position.clone();
        let beside = |place: &Self, line: &Self| match (place.clone() - line).sign() {
            Ok(Greater) => line.clone() + &disc.radius,
            Ok(Less) => line.clone() - &disc.radius,
            _ => place.clone(),
        };
        match [&wall.along.x, &wall.along.y].map(Self::is_surely_zero) {
            _ if S::ROUNDS => Vec2::new(x, y),
            [true, _] => Vec2::new(beside(&x, &wall.from.x), y),
            [_, true] => Vec2::new(x.clone(), beside(&y, &wall.from.y)),
            _ => Vec2::new(x, y),
        }
    }

    fn bouncing(flight: Flight<'_, Self>, wall: &Segment<Self>, kept: &Self) -> Option<[Self; 2]> {
        let gap = way(flight).seen_from(&wall.from);
        gap::bouncing(&gap.component(|power| power.cross(&wall.along)), kept)
    }
}

/// The way of a disc.
fn way<S: Scalar, M: Medium<S>>(flight: Flight<'_, Falling<S, M>>) -> M::Way {
    let Disc {
        position, velocity, ..
    } = flight.disc;
    let Weight { acting, drag, .. } = flight.pull;
    M::way(position.clone(), velocity.clone(), acting, drag)
}

fn meet_wall<S: Scalar, M: Medium<S>>(
    flight: Flight<'_, Falling<S, M>>,
    wall: &Segment<Falling<S, M>>,
    touched: Touched,
) -> Result<Option<Met<Falling<S, M>>>, S::Doubt> {
    let way = way(flight).seen_from(&wall.from);
    let met = segment::meet(&way, &flight.disc.radius, wall, touched)?;
    Ok(met.map(|met| Met::after(flight.since, met)))
}

/// The way of the later disc, seen from the earlier one; none if both fall
/// freely.
fn relative<S: Scalar, M: Medium<S>>(approach: &Approach<'_, Falling<S, M>>) -> Option<M::Way> {
    let [early, late] = [approach.early, approach.late].map(|flight| flight.pull);
    if early.is_free() && late.is_free() {
        return None;
    }
    let pull = late.acting.minus(&early.acting);
    let (offset, velocity) = (approach.offset(), approach.velocity());
    Some(M::way(offset, velocity, &pull, &late.drag))
}
