//! What binary64 bounds prove of a meeting.
//!
//! These are the generic formulas, on enclosures of the stored numbers. What is
//! at once they never settle here, for it hangs on signs of what is nearly zero.

use super::body::{Body, Course};
use crate::detect::{Encounter, Segment, meet_circle};
use crate::effects::falling::arc::Arc;
use crate::effects::falling::{circle, segment};
use crate::filtered::Line;
use crate::scalar::{Interval, Undecided};
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
                &seen_from(disc, &wall.from),
                &point(disc.radius),
                &wall,
                *touched,
            )
        }
        Course::Leaving(disc, line) => {
            let wall = wall(line);
            segment::leave(&seen_from(disc, &wall.from), &wall)
        }
    }
}

fn discs([early, late]: &[Body; 2], parted: bool) -> Met {
    let waited = point(late.since) - point(early.since);
    let (start, end) = (way(early), way(late));
    let offset = end.offset.minus(&start.at(&waited));
    let speed = start.velocity.moved(&vector(early.pull), &waited);
    let velocity = end.velocity.minus(&speed);
    if early.pull == late.pull {
        // In relation to each other they move straight.
        return match parted {
            true => Ok(None),
            false => meet_circle(&offset, &velocity, &reach(early, late)),
        };
    }
    let pull = vector(late.pull).minus(&vector(early.pull));
    let arc = Arc::new(offset, velocity, &pull);
    match parted {
        true => circle::meet_again(&arc),
        false => circle::meet(&arc, &reach(early, late)),
    }
}

fn reach(one: &Body, other: &Body) -> Interval {
    point(one.radius) + point(other.radius)
}

fn way(disc: &Body) -> Arc<Interval> {
    let [position, velocity, pull] = [disc.position, disc.velocity, disc.pull].map(vector);
    Arc::new(position, velocity, &pull)
}

fn seen_from(disc: &Body, place: &Vec2<Interval>) -> Arc<Interval> {
    way(disc).seen_from(place)
}

fn wall(line: &Line) -> Segment<Interval> {
    let [from, to] = [line.from, line.to].map(vector);
    let along = to.minus(&from);
    Segment::new(from, to, along)
}

fn vector([x, y]: [f64; 2]) -> Vec2<Interval> {
    Vec2::new(point(x), point(y))
}

fn point(number: f64) -> Interval {
    Interval::new(number, number)
}
