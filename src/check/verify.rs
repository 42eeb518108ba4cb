//! Whether an impact that a run says there is, is one.
//!
//! The two must touch at the time that is given, and not part: unless in a graze.
//! A line that passes a point at a distance R + η is within ε of R for a path of
//! √(2 R ε) on either side of its nearest point. Bodies that move on such a line
//! collide somewhere on that path if they are moved by ε, in a graze, whose
//! impulse is too small to matter. So of bodies that part, the line must nowhere
//! be nearer than R - ε.

use super::course::{Course, exceeds, outwards};
use super::finding::Kind;
use super::real::{Point, Real};
use super::record::Claim;
use super::window::Window;
use crate::body::End;
use crate::world::Obstacle;

/// What is wrong, and by how many margins.
pub(super) type Fault = (Kind, f64);

impl Window<'_> {
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
        let beyond = match claim.pair.1 {
            Obstacle::Disc(_) => self.parting(pair, &course.ends[1]),
            Obstacle::Wall(wall) => self.beside(claim, wall, &course.ends[1]),
        };
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

    /// By how many margins the bodies of a pair part, with a disc's centre at an
    /// offset from a point that it touches.
    fn parting(&self, pair: (usize, Obstacle), offset: &Point) -> Option<f64> {
        let (velocity, margin) = (self.relative_velocity(pair), self.margin(pair));
        let beyond = excess(&offset.dot(&velocity), &velocity, margin)?;
        let inner = (&self.reach(pair) - &Real::from(margin)).square();
        let moment = offset.cross(&velocity).square();
        let is_graze = moment >= &inner * &velocity.norm_squared();
        (!is_graze).then_some(beyond)
    }

    /// By how many margins a disc with its centre at a place parts from a wall
    /// that it touches, or touches another part of it.
    fn beside(&self, claim: &Claim, wall: usize, place: &Point) -> Option<f64> {
        let [from, to] = self.bodies.walls[wall].map(Point::from);
        let margin = self.margin(claim.pair);
        let corner = match claim.end {
            Some(End::From) => from,
            Some(End::To) => to,
            None => {
                let (offset, along) = (place.minus(&from), to.minus(&from));
                let beyond = self.leaving(claim.pair, &offset, &along);
                return beyond.or_else(|| outside(&offset, &along, margin));
            }
        };
        let beyond = self.parting(claim.pair, &place.minus(&corner));
        beyond.or_else(|| self.inside(&corner, place, margin))
    }

    /// By how many margins a disc moves away from a wall's line.
    fn leaving(&self, pair: (usize, Obstacle), offset: &Point, along: &Point) -> Option<f64> {
        let velocity = self.relative_velocity(pair);
        excess(
            &outwards(offset, along, &velocity),
            &velocity,
            self.margin(pair),
        )
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
    let length = vector.norm_squared().to_f64().sqrt();
    let beyond = product.to_f64() / length / margin;
    exceeds(product, vector, &Real::from(margin)).then_some(beyond)
}
