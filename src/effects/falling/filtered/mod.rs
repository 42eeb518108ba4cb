//! Bodies that fall, in binary64 that is never wrong about its own numbers.
//!
//! As without gravity (see [`filtered`](crate::filtered)) every decision is that
//! of exact arithmetic for the stored numbers. Enclosures in binary64 make most
//! (`screen`), whole numbers all others (`exact`): the times are zeros of
//! polynomials with dyadic coefficients, of which everything is decidable.
//!
//! # What is rounded, and when
//!
//! Once an impact, each stored number, to the nearest binary64 of its exact
//! value:
//!
//! 1. the time of the impact;
//! 2. where the bodies are, and how fast they move, at the exact time;
//! 3. their velocities after it, from the numbers of 2., as without gravity.
//!
//! When a disc comes to rest on a wall, or slides along it, its velocity and what
//! is left of gravity are projected on the direction of the wall: each coordinate
//! rounds once. Unless the wall is parallel to an axis, the disc thus leaves its
//! true way by no more than √2 (ulp(v) t + ulp(a) t²/2) / 2 in a time t.
//!
//! # Overlap by rounding
//!
//! It is bounded as without gravity, with speeds at the time of the impact. What
//! has collided, and comes back before either meets something else, collides as
//! soon as it is as close again: each such impact rounds once more.

mod body;
mod exact;
mod hold;
mod instant;
mod parabola;
mod screen;

use std::convert::Infallible;

use super::Falling;
use super::arc::Arc;
use super::gap::bouncing;
use super::segment::Touched;
use super::weight::Weight;
use crate::body::Disc;
use crate::detect::{Encounter, End, Overlap, Segment};
use crate::kernel::{Approach, Flight, Kernel, Met, Time};
use crate::respond::{Normal, Restitution};
use crate::scalar::{Filtered, Interval};
use crate::vec2::Vec2;
use body::{Body, Course, Parted, line, stored};
use exact::{Delay, Meeting};

pub use instant::Instant;

type Decision<T> = Result<T, Infallible>;

impl Kernel for Falling<Filtered> {
    type Time = Instant;
    type Pull = Weight<Self>;

    const IS_STRAIGHT: bool = false;

    fn position_after(flight: Flight<'_, Self>, time: &Self) -> Vec2<Self> {
        stored(Instant::at(*time).place_of(&from_zero(flight)))
    }

    fn velocity_after(flight: Flight<'_, Self>, time: &Self) -> Vec2<Self> {
        stored(Instant::at(*time).speed_of(&from_zero(flight)))
    }

    fn position_at(flight: Flight<'_, Self>, time: &Instant) -> Vec2<Self> {
        stored(time.place_of(&Body::of(flight)))
    }

    fn velocity_at(flight: Flight<'_, Self>, time: &Instant) -> Vec2<Self> {
        stored(time.speed_of(&Body::of(flight)))
    }

    #[inline]
    fn meet_discs(approach: &Approach<'_, Self>) -> Decision<Option<Met<Instant>>> {
        Ok(meet(discs(approach, Parted::No)))
    }

    fn meet_disc_again(
        approach: &Approach<'_, Self>,
        skims: bool,
    ) -> Decision<Option<Met<Instant>>> {
        let parted = if skims { Parted::Skimming } else { Parted::Yes };
        Ok(meet(discs(approach, parted)))
    }

    fn meet_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        barred: impl Fn(End) -> bool,
    ) -> Decision<Option<Met<Instant>>> {
        let barred = [End::From, End::To].map(barred);
        let touched = Touched::Nothing { barred };
        let course = Course::Wall(Body::of(flight), line(wall), touched);
        Ok(meet(course))
    }

    fn meet_wall_again(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        touched: Option<End>,
        skims: bool,
    ) -> Decision<Option<Met<Instant>>> {
        let touched = Touched::of(touched, skims);
        let course = Course::Wall(Body::of(flight), line(wall), touched);
        Ok(meet(course))
    }

    fn leave_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
    ) -> Decision<Option<Met<Instant>>> {
        let met = meet(Course::Leaving(Body::of(flight), line(wall)));
        Ok(met.map(|met| Met { rest: true, ..met }))
    }

    fn bouncing(flight: Flight<'_, Self>, wall: &Segment<Self>, kept: &Self) -> Option<[Self; 2]> {
        let Disc {
            position, velocity, ..
        } = flight.disc;
        let arc = Arc::new(position.minus(&wall.from), *velocity, &flight.pull.acting);
        bouncing(&arc.quadratic(|power| power.cross(&wall.along)), kept)
    }

    fn overlap_discs(first: &Disc<Self>, second: &Disc<Self>) -> Decision<Option<Overlap<Self>>> {
        let overlap = Filtered::overlap_discs(&landed(first), &landed(second))?;
        Ok(overlap.map(|overlap| overlap.map(lifted)))
    }

    fn overlap_wall(disc: &Disc<Self>, wall: &Segment<Self>) -> Decision<Option<Overlap<Self>>> {
        let overlap = Filtered::overlap_wall(&landed(disc), &wall.map(number))?;
        Ok(overlap.map(|overlap| overlap.map(lifted)))
    }

    fn approaches_point(
        disc: &Disc<Self>,
        point: &Vec2<Self>,
        velocity: &Vec2<Self>,
    ) -> Decision<bool> {
        Filtered::approaches_point(&landed(disc), &point.map(number), &velocity.map(number))
    }

    fn approaches_wall(disc: &Disc<Self>, wall: &Segment<Self>) -> Decision<bool> {
        Filtered::approaches_wall(&landed(disc), &wall.map(number))
    }

    fn collide_discs(
        [first, second]: [&mut Disc<Self>; 2],
        centres: [&Vec2<Self>; 2],
        normal: &Normal<Self>,
        restitution: &Restitution<Self>,
    ) -> Decision<()> {
        let [mut one, mut other] = [landed(first), landed(second)];
        let [start, end] = centres.map(|centre| centre.map(number));
        let (normal, restitution) = (normal.map(number), restitution.map(number));
        Filtered::collide_discs(
            [&mut one, &mut other],
            [&start, &end],
            &normal,
            &restitution,
        )?;
        first.velocity = one.velocity.map(lifted);
        second.velocity = other.velocity.map(lifted);
        Ok(())
    }

    fn collide_point(
        disc: &mut Disc<Self>,
        places: [&Vec2<Self>; 2],
        normal: &Normal<Self>,
        restitution: &Restitution<Self>,
    ) -> Decision<()> {
        let mut body = landed(disc);
        let [centre, point] = places.map(|place| place.map(number));
        let (normal, restitution) = (normal.map(number), restitution.map(number));
        Filtered::collide_point(&mut body, [&centre, &point], &normal, &restitution)?;
        disc.velocity = body.velocity.map(lifted);
        Ok(())
    }

    fn collide_wall(
        disc: &mut Disc<Self>,
        wall: &Segment<Self>,
        normal: &Normal<Self>,
        restitution: &Restitution<Self>,
    ) -> Decision<()> {
        let mut body = landed(disc);
        let (normal, restitution) = (normal.map(number), restitution.map(number));
        Filtered::collide_wall(&mut body, &wall.map(number), &normal, &restitution)?;
        disc.velocity = body.velocity.map(lifted);
        Ok(())
    }
}

fn number(falling: &Falling<Filtered>) -> Filtered {
    falling.0
}

fn lifted(number: &Filtered) -> Falling<Filtered> {
    Falling::new(*number)
}

fn landed(disc: &Disc<Falling<Filtered>>) -> Disc<Filtered> {
    disc.map(number)
}

/// A disc in flight since time zero.
fn from_zero(flight: Flight<'_, Falling<Filtered>>) -> Body {
    Body {
        since: 0.0,
        ..Body::of(flight)
    }
}

fn discs(approach: &Approach<'_, Falling<Filtered>>, parted: Parted) -> Course {
    let pair = [approach.early, approach.late].map(Body::of);
    Course::Discs { pair, parted }
}

/// Where a course leads to, and when.
fn meet(course: Course) -> Option<Met<Instant>> {
    match screen::meeting(&course) {
        Ok(None) => None,
        Ok(Some(met)) if !met.overlap => Some(enclosed(course, &met)),
        _ => exact::meeting(&course).map(|meeting| found(course, meeting)),
    }
}

fn enclosed(course: Course, met: &Encounter<Interval>) -> Met<Instant> {
    let time = Instant::after(course, met.end, met.delay);
    Met {
        time,
        graze: met.graze,
        overlap: false,
        inside: false,
        rest: met.rest,
        end: met.end,
    }
}

/// What an exact decision amounts to.
fn found(course: Course, Meeting { delay, end }: Meeting) -> Met<Instant> {
    let time = match delay.time() {
        Some(time) => Instant::exactly_after(course, end, time),
        None => Instant::at(Falling::new(Filtered::new(course.start()))),
    };
    Met {
        time,
        graze: matches!(delay, Delay::Graze(_)),
        overlap: delay.time().is_none(),
        inside: matches!(delay, Delay::Inside),
        rest: matches!(delay, Delay::Rest),
        end,
    }
}
