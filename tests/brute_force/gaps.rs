//! When the gap between a moving disc and something closes.
//!
//! A disc that moves straight and a convex body have a distance that is a
//! convex function of time. So its minimum is found by ternary search, and if
//! that is below zero, bisection between now and then finds the one time at
//! which the gap closes: nothing can be missed, and no root is solved for.

/// A point or a vector.
pub(crate) type Point = [f64; 2];

/// Enough to narrow any time down to the last bit.
const STEPS: usize = 200;

/// Something convex that does not move, seen from a disc.
#[derive(Clone, Copy)]
pub(crate) enum Target {
    Point(Point),
    Segment(Point, Point),
}

pub(crate) fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

pub(crate) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(crate) fn moved(position: Point, velocity: Point, time: f64) -> Point {
    [
        position[0] + velocity[0] * time,
        position[1] + velocity[1] * time,
    ]
}

impl Target {
    /// How far along a segment, from 0 to 1, the point nearest to another is.
    pub(crate) fn part(self, point: Point) -> f64 {
        match self {
            Self::Point(_) => 0.0,
            Self::Segment(from, to) => {
                let along = minus(to, from);
                (dot(minus(point, from), along) / dot(along, along)).clamp(0.0, 1.0)
            }
        }
    }

    pub(crate) fn nearest(self, point: Point) -> Point {
        match self {
            Self::Point(target) => target,
            Self::Segment(from, to) => moved(from, minus(to, from), self.part(point)),
        }
    }

    fn distance(self, point: Point) -> f64 {
        let [x, y] = minus(point, self.nearest(point));
        x.hypot(y)
    }
}

/// When a point that moves within `until` comes as close to a target as
/// `reach`. One that does not approach now never will.
pub(crate) fn closes(
    target: Target,
    position: Point,
    velocity: Point,
    reach: f64,
    until: f64,
) -> Option<f64> {
    let away = minus(position, target.nearest(position));
    if dot(away, velocity) >= 0.0 {
        return None;
    }
    let gap = |time| target.distance(moved(position, velocity, time)) - reach;
    if gap(0.0) <= 0.0 {
        return Some(0.0);
    }
    let lowest = minimum(gap, until);
    (gap(lowest) < 0.0).then(|| root(gap, lowest))
}

/// Where a convex function is least between 0 and `end`.
fn minimum(f: impl Fn(f64) -> f64, end: f64) -> f64 {
    let (mut low, mut high) = (0.0, end);
    for _ in 0..STEPS {
        let third = (high - low) / 3.0;
        if f(low + third) < f(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    high
}

/// Where a function that is positive at 0 and negative at `end` vanishes.
fn root(f: impl Fn(f64) -> f64, end: f64) -> f64 {
    let (mut low, mut high) = (0.0, end);
    for _ in 0..STEPS {
        let middle = (low + high) / 2.0;
        if f(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}
