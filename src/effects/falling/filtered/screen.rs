//! What binary64 bounds prove of a meeting.
//!
//! These are the generic formulas, on enclosures of the stored numbers. What is
//! at once they never settle here, for it hangs on signs of what is nearly zero.

use super::body::{Body, Course, Parted};
use crate::detect::{Encounter, Segment, meet_circle};
use crate::effects::falling::arc::Arc;
use crate::effects::falling::{circle, segment};
use crate::filtered::Line;
use crate::scalar::{Interval, Scalar, Undecided};
use crate::vec2::Vec2;

type Met = Result<Option<Encounter<Interval>>, Undecided>;

/// Where a course leads to, and within which time from its start.
pub(super) fn meeting(course: &Course) -> Met {
    match course {
        Course::Known => Ok(None),
        Course::Discs { pair, parted } => discs(pair, *parted),
        Course::Wall(disc, line, touched) => {
            let wall = wall(line);
            segment::meet(
                &seen_from(disc, line.from),
                &point(disc.radius),
                &wall,
                *touched,
            )
        }
        Course::Leaving(disc, line) => {
            let wall = wall(line);
            segment::leave(&seen_from(disc, line.from), &wall)
        }
    }
}

fn discs([early, late]: &[Body; 2], parted: Parted) -> Met {
    let waited = distance(late.since, early.since);
    let (start, end) = (way(early), way(late));
    let offset = end.offset.minus(&start.at(&waited));
    let speed = start.velocity.moved(&vector(early.pull), &waited);
    let velocity = end.velocity.minus(&speed);
    if early.pull == late.pull {
        // In relation to each other they move straight.
        return match parted {
            Parted::Yes | Parted::Skimming => Ok(None),
            Parted::No => meet_straight(&offset, &velocity, &reach(early, late)),
        };
    }
    let pull = vector(late.pull).minus(&vector(early.pull));
    let arc = Arc::new(offset, velocity, &pull);
    match parted {
        Parted::No => circle::meet(&arc, &reach(early, late)),
        Parted::Yes => circle::meet_again(&arc),
        Parted::Skimming => circle::leave(&arc),
    }
}

/// That they pass each other may be plain even if it is not whether they approach.
fn meet_straight(offset: &Vec2<Interval>, velocity: &Vec2<Interval>, reach: &Interval) -> Met {
    meet_circle(offset, velocity, reach).or_else(|doubt| {
        let (moment, strength) = (
            offset.cross(velocity),
            velocity.norm_squared() * reach.square(),
        );
        let passes = moment.square().lo() > strength.hi();
        if passes { Ok(None) } else { Err(doubt) }
    })
}

fn reach(one: &Body, other: &Body) -> Interval {
    point(one.radius) + point(other.radius)
}

fn way(disc: &Body) -> Arc<Interval> {
    let [position, velocity, pull] = [disc.position, disc.velocity, disc.pull].map(vector);
    Arc::new(position, velocity, &pull)
}

fn seen_from(disc: &Body, place: [f64; 2]) -> Arc<Interval> {
    let [velocity, pull] = [disc.velocity, disc.pull].map(vector);
    Arc::new(difference(disc.position, place), velocity, &pull)
}

/// The difference of two vectors, a point where it is a number of binary64.
fn difference([x, y]: [f64; 2], [from_x, from_y]: [f64; 2]) -> Vec2<Interval> {
    Vec2::new(distance(x, from_x), distance(y, from_y))
}

/// By Knuth's two-sum, which tells whether a difference rounds.
fn distance(to: f64, from: f64) -> Interval {
    let rounded = to - from;
    let part = rounded - to;
    let error = (to - (rounded - part)) - (from + part);
    if error == 0.0 {
        point(rounded)
    } else {
        point(to) - point(from)
    }
}

fn wall(line: &Line) -> Segment<Interval> {
    let [from, to] = [line.from, line.to].map(vector);
    Segment::new(from, to, difference(line.to, line.from))
}

fn vector([x, y]: [f64; 2]) -> Vec2<Interval> {
    Vec2::new(point(x), point(y))
}

fn point(number: f64) -> Interval {
    Interval::new(number, number)
}
