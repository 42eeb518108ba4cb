//! What truly happens in free flight up to a time, from a stored state.
//!
//! Nothing is predicted: it is *verified*, exactly, that bodies said to collide
//! touch and approach then, and that no others have got into each other before
//! (see [`margin`](super::margin) for how exactly that has to hold). All of it
//! are signs of polynomials in the stored numbers, so there is always an answer.

use std::cmp::Ordering::{Greater, Less};

use super::bodies::{Bodies, Motion, discs, length};
use super::course::{Course, Target};
use super::finding::Kind;
use super::margin::margin;
use super::real::{Point, Real};
use super::record::Claim;
use crate::body::End;
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

/// What is wrong, and by how many margins.
pub(super) type Fault = (Kind, f64);

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
    fn reach(&self, (disc, obstacle): (usize, Obstacle)) -> Real {
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

    /// Whether the boxes about the ways of a pair are apart, by much more than
    /// they are rounded.
    fn is_far(&self, (disc, obstacle): (usize, Obstacle)) -> bool {
        let own = self.extent(disc);
        let other = match obstacle {
            Obstacle::Disc(other) => self.extent(other),
            Obstacle::Wall(wall) => {
                let [from, to] = self.bodies.walls[wall];
                [0, 1].map(|axis| [from[axis].min(to[axis]), from[axis].max(to[axis])])
            }
        };
        (0..2).any(|axis| own[axis][1] < other[axis][0] || other[axis][1] < own[axis][0])
    }

    /// The box about a disc's way, with some to spare.
    fn extent(&self, disc: usize) -> [[f64; 2]; 2] {
        let motion = &self.motions[disc];
        let flown = self.time - motion.since;
        [0, 1].map(|axis| {
            let (from, way) = (motion.position[axis], motion.velocity[axis] * flown);
            let spare = 1e-9 * (from.abs() + way.abs());
            let radius = self.bodies.radii[disc] * (1.0 + 1e-9) + spare;
            [from.min(from + way) - radius, from.max(from + way) + radius]
        })
    }

    /// Whether the bodies of a pair are apart at the end.
    pub(super) fn ends_apart(&self, pair: (usize, Obstacle)) -> bool {
        !self.course(pair).ends_within(&self.reach(pair))
    }

    /// Whether a pair comes to touch, and approaches at first.
    pub(super) fn may_meet(&self, pair: (usize, Obstacle)) -> bool {
        let course = self.course(pair);
        let bound = &self.reach(pair) + &Real::from(self.margin(pair));
        let [start, _] = course.distances();
        course.gets_nearer_than(&bound) && course.least() <= start
    }

    /// Whether two bodies that are said to collide do so, at the end.
    ///
    /// # Errors
    ///
    /// They do not touch, they part, or it is another part of a wall.
    pub(super) fn verify(&self, claim: &Claim) -> Result<(), Fault> {
        let pair = claim.pair;
        let (course, margin) = (self.course(pair), self.margin(pair));
        let bound = &self.reach(pair) + &Real::from(margin);
        if !course.ends_within(&bound) {
            let off = course.distances()[1] - self.reach(pair).to_f64();
            return Err((self.untouched(&course, &bound), off / margin));
        }
        let beyond = self.parting(claim, &course, margin);
        beyond.map_or(Ok(()), |beyond| Err((Kind::Spurious, beyond)))
    }

    /// What it is that bodies collide which do not touch.
    fn untouched(&self, course: &Course, bound: &Real) -> Kind {
        let [from, to] = &course.ends;
        let way = to.minus(from);
        let far = to.moved(&way, &Real::from(f64::from(1 << 20)));
        let later = Course {
            ends: [from.clone(), far],
            target: course.target.clone(),
        };
        if later.gets_nearer_than(bound) {
            Kind::Mistimed
        } else {
            Kind::Spurious
        }
    }

    /// By how many margins a claimed impact is none, or is one of another part
    /// of a wall, though the two touch.
    fn parting(&self, claim: &Claim, course: &Course, margin: f64) -> Option<f64> {
        let (disc, obstacle) = claim.pair;
        let place = &course.ends[1];
        let Obstacle::Wall(wall) = obstacle else {
            let velocity = self.relative_velocity(claim.pair);
            return excess(&place.dot(&velocity), &velocity, margin);
        };
        let velocity = Point::from(self.motions[disc].velocity);
        let [from, to] = self.bodies.walls[wall].map(Point::from);
        let Some(end) = claim.end else {
            let (offset, along) = (place.minus(&from), to.minus(&from));
            let (side, drift) = (offset.cross(&along), velocity.cross(&along));
            let outwards = if side.sign() == Less {
                &Real::zero() - &drift
            } else {
                drift
            };
            let beyond = excess(&outwards, &velocity, margin);
            return beyond.or_else(|| outside(&offset, &along, margin));
        };
        let corner = if end == End::From { from } else { to };
        let offset = place.minus(&corner);
        excess(&offset.dot(&velocity), &velocity, margin)
            .or_else(|| self.inside(&corner, place, margin))
    }

    fn relative_velocity(&self, pair: (usize, Obstacle)) -> Point {
        let velocity = |disc: usize| Point::from(self.motions[disc].velocity);
        match pair.1 {
            Obstacle::Disc(other) => velocity(other).minus(&velocity(pair.0)),
            Obstacle::Wall(_) => velocity(pair.0),
        }
    }

    /// By how many margins a place is beside the interior of every wall that
    /// ends at a corner, rather than beyond the end of one.
    fn inside(&self, corner: &Point, place: &Point, margin: f64) -> Option<f64> {
        let walls = self.bodies.walls.iter().map(|wall| wall.map(Point::from));
        let ends = walls.flat_map(|[from, to]| [[from.clone(), to.clone()], [to, from]]);
        let beside = ends.filter(|[end, _]| end == corner).map(|[end, other]| {
            let (offset, along) = (place.minus(&end), other.minus(&end));
            excess(&offset.dot(&along), &along, margin)
        });
        beside.min_by(|one, other| one.unwrap_or(0.0).total_cmp(&other.unwrap_or(0.0)))?
    }
}

/// By how many margins the foot of a place is beyond one of the ends.
fn outside(offset: &Point, along: &Point, margin: f64) -> Option<f64> {
    let foot = offset.dot(along);
    let before = &Real::zero() - &foot;
    let after = &foot - &along.norm_squared();
    excess(&before, along, margin).or_else(|| excess(&after, along, margin))
}

/// By how many margins a product with a vector exceeds nothing: of a velocity,
/// how fast two bodies part; of a wall's length, how far a place is along it.
fn excess(product: &Real, vector: &Point, margin: f64) -> Option<f64> {
    let length_squared = vector.norm_squared();
    let allowed = &Real::from(margin).square() * &length_squared;
    let exceeds = product.sign() == Greater && product.square() > allowed;
    exceeds.then(|| product.to_f64() / length_squared.to_f64().sqrt() / margin)
}
