//! Binary64 that is never wrong about its own numbers.
//!
//! The state is binary64: positions, velocities, and for each disc the time at
//! which it is there. Every decision (whether two bodies meet, what of a wall,
//! whether they approach, which of two impacts comes first) is that of exact
//! arithmetic *for the stored numbers*. Floating point with an error bound
//! decides most (`screen`); where it cannot tell, whole numbers do (`exact`),
//! without any limit: nothing stays open.
//!
//! # What is rounded, and when
//!
//! Once an impact, each stored number, to the nearest binary64 of its exact
//! value:
//!
//! 1. the time of the impact;
//! 2. where the bodies are at the exact time;
//! 3. their velocities after it, on the normal of the positions of 2. If the
//!    bodies still approached, the coordinates round away from the other body
//!    instead.
//!
//! So a run is defined without reference to this code, and has the same bits on
//! every platform. (What would be beyond the largest binary64 is stored as that.
//! A moving body of infinite mass is not stored anew: for an impact with it,
//! its place at the rounded time is rounded. The rule `reflect` solves for
//! velocities in binary64, as `f64` does.)
//!
//! # Overlap by rounding
//!
//! Positions that round move each by at most half an ulp a coordinate; a time
//! that rounds is as if a body had moved for half an ulp of the time. Two bodies
//! that touch thus overlap by no more than
//! √2 (ulp(x₁) + ulp(x₂)) / 2 + (|v₁| + |v₂|) ulp(t) / 2, with the largest
//! coordinates x, speeds v and the time t. By 3. they do not approach after an
//! impact, and two bodies that do not approach do not get closer in free
//! motion: the overlap does not grow, and as such it is no impact. An impact of
//! one of them with a third body rounds again, which may add as much. Bodies that
//! overlap and *do* approach, because one of them was struck meanwhile, collide
//! at once.

mod course;
mod exact;
mod float;
mod impulse;
mod moment;
mod plane;
mod screen;
mod surd;

use std::cmp::Ordering::{Greater, Less};
use std::convert::Infallible;

use crate::body::Disc;
use crate::detect::{End, Overlap, Segment};
use crate::kernel::{Approach, Flight, Glance, Kernel, Met, Time};
use crate::respond::{Normal, Restitution};
use crate::scalar::{Dyadic, Filtered, Interval};
use crate::vec2::Vec2;
use course::{Course, Ray};
use exact::{Meeting, Part};
use screen::Verdict;

pub(crate) use course::Line;
pub use moment::Moment;
pub(crate) use plane::Point;

type Decision<T> = Result<T, Infallible>;

impl Kernel for Filtered {
    type Time = Moment;
    type Pull = ();

    /// What the stored numbers say is all that counts.
    const REMEMBERS_CONTACTS: bool = false;

    const GLIDES: bool = true;

    #[inline]
    fn meet_discs(approach: &Approach<'_, Self>) -> Decision<Option<Met<Moment>>> {
        let pair = [approach.early, approach.late].map(Ray::of);
        Ok(match screen::discs(&pair) {
            Verdict::Apart => None,
            Verdict::After(delay) => Some(met(Moment::after(delay, Course::Discs(pair)))),
            Verdict::Open => found(
                exact::discs(&pair),
                Course::Discs(pair),
                approach.late.since,
            ),
        })
    }

    fn meet_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        barred: impl Fn(End) -> bool,
    ) -> Decision<Option<Met<Moment>>> {
        let (disc, line) = (Ray::of(flight), Line::of(wall));
        let (verdict, end) = screen::wall(&disc, &line, &barred);
        Ok(match verdict {
            Verdict::Apart => None,
            Verdict::After(delay) => {
                let met = met(Moment::after(delay, line.course(disc, end)));
                Some(Met { end, ..met })
            }
            Verdict::Open => {
                let (meeting, part) = exact::wall(&disc, &line, barred);
                let course = line.course(disc, part.circle());
                let end = part.end();
                found(meeting, course, flight.since).map(|met| Met { end, ..met })
            }
        })
    }

    #[inline]
    fn glance_at_discs(approach: &Approach<'_, Self>) -> Glance {
        let pair = [approach.early, approach.late].map(Ray::of);
        glance(screen::discs(&pair), None, approach.late.since)
    }

    #[inline]
    fn glance_at_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        barred: impl Fn(End) -> bool,
    ) -> Glance {
        let (verdict, end) = screen::wall(&Ray::of(flight), &Line::of(wall), barred);
        glance(verdict, end, flight.since)
    }

    fn position_at(flight: Flight<'_, Self>, time: &Moment) -> Vec2<Self> {
        time.place_of(&Ray::of(flight))
    }

    fn overlap_discs(first: &Disc<Self>, second: &Disc<Self>) -> Decision<Option<Overlap<Self>>> {
        if screen::are_apart([first, second].map(|disc| Ray::standing(disc, 0.0))) {
            return Ok(None);
        }
        let offset = Point::of(&second.position).minus(&Point::of(&first.position));
        let [own, other] = [first, second].map(|disc| Dyadic::from_f64(disc.radius.get()));
        if offset.compare_length(&own.add(&other)) != Less {
            return Ok(None);
        }
        let offset = second.position.minus(&first.position);
        Overlap::with_circle(&offset, &(first.radius + second.radius)).map(Some)
    }

    fn overlap_wall(disc: &Disc<Self>, wall: &Segment<Self>) -> Decision<Option<Overlap<Self>>> {
        let part = exact::overlap(&Ray::standing(disc, 0.0), &Line::of(wall));
        part.map(|part| match part {
            Part::Interior(end) => Overlap::with_line(&disc.position, &disc.radius, wall, end),
            Part::End(end) => {
                let offset = wall.end(end).minus(&disc.position);
                let overlap = Overlap::with_circle(&offset, &disc.radius)?;
                let end = Some(end);
                Ok(Overlap { end, ..overlap })
            }
        })
        .transpose()
    }

    fn approaches_point(
        disc: &Disc<Self>,
        point: &Vec2<Self>,
        velocity: &Vec2<Self>,
    ) -> Decision<bool> {
        let closing = Point::of(&disc.velocity).minus(&Point::of(velocity));
        let offset = Point::of(point).minus(&Point::of(&disc.position));
        Ok(closing.dot(&offset).sign() == Greater)
    }

    fn approaches_wall(disc: &Disc<Self>, wall: &Segment<Self>) -> Decision<bool> {
        Ok(exact::approaches(
            &Ray::standing(disc, 0.0),
            &Line::of(wall),
        ))
    }

    fn collide_discs(
        discs: [&mut Disc<Self>; 2],
        centres: [&Vec2<Self>; 2],
        _: &Normal<Self>,
        restitution: &Restitution<Self>,
    ) -> Decision<()> {
        impulse::collide_discs(discs, centres, restitution);
        Ok(())
    }

    fn collide_point(
        disc: &mut Disc<Self>,
        places: [&Vec2<Self>; 2],
        _: &Normal<Self>,
        restitution: &Restitution<Self>,
    ) -> Decision<()> {
        impulse::collide_point(disc, places, restitution);
        Ok(())
    }

    fn collide_wall(
        disc: &mut Disc<Self>,
        wall: &Segment<Self>,
        _: &Normal<Self>,
        restitution: &Restitution<Self>,
    ) -> Decision<()> {
        impulse::collide_wall(disc, wall, restitution);
        Ok(())
    }
}

#[inline]
fn met(time: Moment) -> Met<Moment> {
    Met {
        time,
        graze: false,
        overlap: false,
        inside: false,
        rest: false,
        end: None,
    }
}

/// What a decision in floating point amounts to, seen from a time.
#[inline]
fn glance(verdict: Verdict<f64>, end: Option<End>, start: &Filtered) -> Glance {
    match verdict {
        Verdict::Apart => Glance::Clear,
        Verdict::After(delay) => {
            let [lo, hi] = delay.after(start.get()).bounds();
            Glance::Ahead(Interval::new(lo, hi), end)
        }
        Verdict::Open => Glance::Open,
    }
}

/// What an exact decision amounts to.
fn found(meeting: Meeting, course: Course, start: &Filtered) -> Option<Met<Moment>> {
    match meeting {
        Meeting::Never => None,
        Meeting::Now { inside } => Some(Met {
            overlap: true,
            inside,
            ..met(Moment::at(*start))
        }),
        Meeting::At(time) => Some(met(Moment::of(&time, course))),
        Meeting::Graze(time) => Some(Met {
            graze: true,
            ..met(Moment::of(&time, course))
        }),
    }
}
