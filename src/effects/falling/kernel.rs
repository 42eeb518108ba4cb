//! How bodies meet of which some fall.

use std::cmp::Ordering::{Greater, Less};

use super::Falling;
use super::arc::Arc;
use super::circle;
use super::segment::{self, Gap, Touched};
use super::weight::Weight;
use crate::body::Disc;
use crate::detect::{Encounter, End, Segment, meet_circle};
use crate::kernel::{Approach, Flight, Kernel, Met};
use crate::roots::{Descent, Polynomial, Roots};
use crate::scalar::Scalar;
use crate::vec2::Vec2;

impl<S: Roots> Roots for Falling<S> {
    fn descent(f: &Polynomial<Self>, grazes: usize) -> Result<Option<Descent<Self>>, S::Doubt> {
        let f = Polynomial(f.0.clone().map(|number| number.0));
        let met = S::descent(&f, grazes)?;
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

    fn pull(disc: &Disc<Self>, gravity: Option<&Vec2<Self>>) -> Weight<Self> {
        Weight::on(disc, gravity)
    }

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
        meet_wall(flight, wall, Touched::Nothing, barred)
    }

    fn meet_wall_again(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        touched: Option<End>,
        skims: bool,
    ) -> Result<Option<Met<Self>>, S::Doubt> {
        let touched = match touched {
            Some(end) => Touched::End { end, skims },
            None => Touched::Interior { skims },
        };
        meet_wall(flight, wall, touched, |_| false)
    }

    fn leave_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
    ) -> Result<Option<Met<Self>>, S::Doubt> {
        let [c, b, a] = way(flight, wall)
            .powers()
            .map(|power| power.dot(&wall.along));
        let left = wall.length_squared.clone() - &c;
        let ends = [
            (
                End::To,
                Gap {
                    a: -a.clone(),
                    b: -b.clone(),
                    c: left,
                },
            ),
            (End::From, Gap { a, b, c }),
        ];
        let mut first = None;
        for (end, gap) in ends {
            let met = gap.fall()?.map(|met| met.at(end));
            first = segment::earlier(first, met)?;
        }
        let left = |met| Encounter { rest: true, ..met };
        Ok(first.map(|met| Met::after(flight.since, left(met))))
    }

    fn bouncing(flight: Flight<'_, Self>, wall: &Segment<Self>, kept: &Self) -> Option<Self> {
        let [_, b, a] = way(flight, wall)
            .powers()
            .map(|power| power.cross(&wall.along));
        let falls = matches!(
            (a.sign(), b.sign()),
            (Ok(Less), Ok(Greater)) | (Ok(Greater), Ok(Less))
        );
        let flown = -b / a;
        falls.then(|| flown / (Self::from_integer(1) - kept))
    }
}

/// The way of a disc, seen from a wall's first end point.
fn way<S: Roots>(flight: Flight<'_, Falling<S>>, wall: &Segment<Falling<S>>) -> Arc<Falling<S>> {
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
    barred: impl Fn(End) -> bool,
) -> Result<Option<Met<Falling<S>>>, S::Doubt> {
    let way = way(flight, wall);
    let met = segment::meet(&way, &flight.disc.radius, wall, touched, barred)?;
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
