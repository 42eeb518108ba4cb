//! What truly happens in free flight up to a time, from a stored state.
//!
//! Nothing is predicted: it is decided, exactly, whether bodies have got into
//! each other by then (see [`margin`](super::margin) for what that means). All of
//! it are signs of polynomials in the stored numbers, so there is always an
//! answer.

use super::bodies::{Bodies, Motion, discs, length};
use super::course::{Course, Target};
use super::margin::margin;
use super::real::{Point, Real};
use crate::world::Obstacle;

/// The flight of all bodies from where they are stored up to a time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window<'a> {
    pub(super) bodies: &'a Bodies,
    pub(super) motions: &'a [Motion],
    pub(super) time: f64,
    /// The time on the clock that the margins go by.
    pub(super) clock: f64,
    /// How many margins are allowed.
    pub(super) slack: f64,
}

impl<'a> Window<'a> {
    pub(super) fn new(bodies: &'a Bodies, motions: &'a [Motion], time: f64) -> Self {
        Self {
            bodies,
            motions,
            time,
            clock: time,
            slack: 1.0,
        }
    }

    /// How far apart the bodies of a pair are when they touch.
    pub(super) fn reach(&self, (disc, obstacle): (usize, Obstacle)) -> Real {
        let reach = Real::from(self.bodies.radii[disc]);
        match obstacle {
            Obstacle::Disc(other) => &reach + &Real::from(self.bodies.radii[other]),
            Obstacle::Wall(_) => reach,
        }
    }

    /// By how much the bodies of a pair may have to be moved.
    pub(super) fn margin(&self, (disc, obstacle): (usize, Obstacle)) -> f64 {
        let size = |disc: usize| length(self.motions[disc].position) + self.bodies.radii[disc];
        let rest = match obstacle {
            Obstacle::Disc(other) => size(other),
            Obstacle::Wall(wall) => self.bodies.walls[wall].map(length).iter().sum(),
        };
        let paces = discs((disc, obstacle)).map(|disc| self.motions[disc].pace);
        self.slack * margin(size(disc) + rest, paces.sum::<f64>() * self.clock)
    }

    /// Where a disc is at a time.
    fn position(&self, disc: usize, time: f64) -> Point {
        let Motion {
            position,
            velocity,
            since,
            ..
        } = self.motions[disc];
        let flown = &Real::from(time) - &Real::from(since);
        Point::from(position).moved(&Point::from(velocity), &flown)
    }

    /// The way of a pair, since both are in flight.
    pub(super) fn course(&self, (disc, obstacle): (usize, Obstacle)) -> Course {
        let since = |disc: usize| self.motions[disc].since;
        match obstacle {
            Obstacle::Disc(other) => {
                let start = since(disc).max(since(other));
                let offset = |time| self.position(other, time).minus(&self.position(disc, time));
                Course {
                    ends: [start, self.time].map(offset),
                    target: Target::Point(Point::origin()),
                }
            }
            Obstacle::Wall(wall) => Course {
                ends: [since(disc), self.time].map(|time| self.position(disc, time)),
                target: Target::Segment(self.bodies.walls[wall].map(Point::from)),
            },
        }
    }

    /// By how many margins the bodies of a pair get into each other, or deeper
    /// than they were at first; none if they stay within the margin.
    pub(super) fn depth(&self, pair: (usize, Obstacle)) -> Option<f64> {
        if self.is_far(pair) {
            return None;
        }
        let (course, margin) = (self.course(pair), self.margin(pair));
        let reach = self.reach(pair);
        let start = course.distances()[0];
        let floor = if start < reach.to_f64() {
            Real::from(start)
        } else {
            reach
        };
        let bound = &floor - &Real::from(margin);
        let is_deep = course.gets_nearer_than(&bound);
        is_deep.then(|| (floor.to_f64() - course.least()) / margin)
    }

    /// By how many margins the bodies of a pair overlap at the end, beyond what
    /// they did when they were this far apart.
    pub(super) fn overlap(&self, pair: (usize, Obstacle), apart: f64) -> f64 {
        if self.is_far(pair) {
            return 0.0;
        }
        let floor = self.reach(pair).to_f64().min(apart);
        (floor - self.course(pair).distances()[1]) / self.margin(pair)
    }

    /// Whether a line keeps the way of a pair and its target apart, by much more
    /// than binary64 rounds: nothing else is decided in it.
    fn is_far(&self, pair: (usize, Obstacle)) -> bool {
        let [ends, target] = self.sketch(pair);
        let reach = self.reach(pair).to_f64() + SPARE * self.margin(pair);
        let normal = |[from, to]: [[f64; 2]; 2]| [from[1] - to[1], to[0] - from[0]];
        let axes = [[1.0, 0.0], [0.0, 1.0], normal(ends), normal(target)];
        axes.into_iter().any(|axis| {
            let [own, other] = [ends, target].map(|segment| shadow(segment, axis));
            (own[0] - other[1]).max(other[0] - own[1]) > reach * length(axis)
        })
    }

    /// The way of a pair, and its target, in binary64.
    fn sketch(&self, (disc, obstacle): (usize, Obstacle)) -> [[[f64; 2]; 2]; 2] {
        let since = |disc: usize| self.motions[disc].since;
        let place = |disc: usize, time| self.motions[disc].place(time);
        match obstacle {
            Obstacle::Wall(wall) => {
                let way = [since(disc), self.time].map(|time| place(disc, time));
                [way, self.bodies.walls[wall]]
            }
            Obstacle::Disc(other) => {
                let start = since(disc).max(since(other));
                let offset = |time| {
                    let [own, other] = [disc, other].map(|disc| place(disc, time));
                    [other[0] - own[0], other[1] - own[1]]
                };
                [[start, self.time].map(offset), [[0.0; 2]; 2]]
            }
        }
    }

    /// Whether the bodies of a pair are apart at first.
    pub(super) fn starts_apart(&self, pair: (usize, Obstacle)) -> bool {
        !self.course(pair).starts_within(&self.reach(pair))
    }

    /// Whether a pair may come to touch: it does but for the margin, and does not
    /// part from the first, unless as in a graze.
    pub(super) fn may_meet(&self, pair: (usize, Obstacle)) -> bool {
        let (course, margin) = (self.course(pair), self.margin(pair));
        let (reach, margin) = (self.reach(pair), Real::from(margin));
        course.gets_nearer_than(&(&reach + &margin))
            && (!course.departs(&margin) || course.passes(&(&reach - &margin)))
    }
}

/// So many margins are beyond all doubt.
const SPARE: f64 = 1e6;

/// The interval in which a segment lies along an axis, times the axis's length.
fn shadow(segment: [[f64; 2]; 2], axis: [f64; 2]) -> [f64; 2] {
    let [one, other] = segment.map(|end| end[0] * axis[0] + end[1] * axis[1]);
    [one.min(other), one.max(other)]
}
