//! How bodies meet of which some fall.

use super::Falling;
use super::arc::Arc;
use super::circle;
use super::segment::{self, Touched};
use super::weight::Weight;
use crate::body::Disc;
use crate::detect::{End, Segment, meet_circle};
use crate::kernel::{Approach, Flight, Kernel, Met};
use crate::roots::{Descent, Polynomial, Roots};
use crate::scalar::Scalar;
use crate::vec2::Vec2;

impl<S: Roots> Roots for Falling<S> {
    fn descent(f: &Polynomial<Self>) -> Result<Option<Descent<Self>>, S::Doubt> {
        let f = Polynomial(f.0.clone().map(|number| number.0));
        let met = S::descent(&f)?;
        Ok(met.map(|Descent { time, graze }| Descent {
            time: Self(time),
            graze,
        }))
    }
}

impl<S: Roots> Kernel for Falling<S> {
    type Time = Self;
    type Pull = Weight<Self>;

    const IS_STRAIGHT: bool = false;

    fn position_after(flight: Flight<'_, Self>, time: &Self) -> Vec2<Self> {
        let Disc {
            position, velocity, ..
        } = flight.disc;
        Arc::new(position.clone(), velocity.clone(), &flight.pull.acting).at(time)
    }

    fn velocity_after(flight: Flight<'_, Self>, time: &Self) -> Vec2<Self> {
        flight.disc.velocity.moved(&flight.pull.acting, time)
    }

    fn meet_discs(approach: &Approach<'_, Self>) -> Result<Option<Met<Self>>, S::Doubt> {
        let reach = approach.reach();
        let met = match relative(approach) {
            None => meet_circle(&approach.offset(), &approach.velocity(), &reach)?,
            Some(arc) => circle::meet(&arc, &reach)?,
        };
        Ok(met.map(|met| Met::after(approach.late.since, met)))
    }

    fn meet_disc_again(
        approach: &Approach<'_, Self>,
        skims: bool,
    ) -> Result<Option<Met<Self>>, S::Doubt> {
        let Some(arc) = relative(approach) else {
            return Ok(None);
        };
        let met = match skims {
            true => circle::leave(&arc)?,
            false => circle::meet_again(&arc)?,
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
        let met = segment::leave(&way(flight, wall), wall)?;
        Ok(met.map(|met| Met::after(flight.since, met)))
    }

    fn bouncing(flight: Flight<'_, Self>, wall: &Segment<Self>, kept: &Self) -> Option<Self> {
        segment::bouncing(&way(flight, wall), wall, kept)
    }
}

/// The way of a disc, seen from a wall's first end point.
pub(super) fn way<S>(flight: Flight<'_, Falling<S>>, wall: &Segment<Falling<S>>) -> Arc<Falling<S>>
where
    S: Scalar,
    Falling<S>: Kernel<Pull = Weight<Falling<S>>>,
{
    let Disc {
        position, velocity, ..
    } = flight.disc;
    let offset = position.minus(&wall.from);
    Arc::new(offset, velocity.clone(), &flight.pull.acting)
}

fn meet_wall<S: Roots>(
    flight: Flight<'_, Falling<S>>,
    wall: &Segment<Falling<S>>,
    touched: Touched,
) -> Result<Option<Met<Falling<S>>>, S::Doubt> {
    let way = way(flight, wall);
    let met = segment::meet(&way, &flight.disc.radius, wall, touched)?;
    Ok(met.map(|met| Met::after(flight.since, met)))
}

/// The way of the later disc, seen from the earlier one; none if that is
/// straight, for both fall.
fn relative<S: Roots>(approach: &Approach<'_, Falling<S>>) -> Option<Arc<Falling<S>>> {
    let [early, late] = [approach.early, approach.late].map(|flight| flight.pull);
    if early.is_free() && late.is_free() {
        return None;
    }
    let pull = late.acting.minus(&early.acting);
    Some(Arc::new(approach.offset(), approach.velocity(), &pull))
}
