//! How near a disc's centre comes to what it might touch, while it moves on a
//! straight line: the distance of two segments, of a segment and a point.
//!
//! Distances are compared squared and free of denominators: exactly.

use std::cmp::Ordering::{self, Greater, Less};

use super::real::{Point, Real};

/// What a disc might touch, as seen from where the centre's line is drawn.
#[derive(Clone, Debug)]
pub(super) enum Target {
    /// Another disc's centre, which is made the origin.
    Point(Point),
    /// A wall.
    Segment([Point; 2]),
}

/// The line on which a centre moves, relative to its target.
#[derive(Clone, Debug)]
pub(super) struct Course {
    pub(super) ends: [Point; 2],
    pub(super) target: Target,
}

impl Course {
    /// Whether the centre gets nearer to the target than `bound`.
    pub(super) fn gets_nearer_than(&self, bound: &Real) -> bool {
        if bound.sign() != Greater {
            return false;
        }
        let [from, to] = &self.ends;
        match &self.target {
            Target::Point(point) => compare(point, &self.ends, bound) == Less,
            Target::Segment(wall) => {
                let ends = [from, to].into_iter();
                cross(&self.ends, wall)
                    || ends.clone().any(|end| compare(end, wall, bound) == Less)
                    || wall
                        .iter()
                        .any(|end| compare(end, &self.ends, bound) == Less)
            }
        }
    }

    /// Whether the centre starts no farther from the target than `bound`.
    pub(super) fn starts_within(&self, bound: &Real) -> bool {
        compare(&self.ends[0], &self.segment(), bound) != Greater
    }

    /// Whether the centre ends no farther from the target than `bound`.
    pub(super) fn ends_within(&self, bound: &Real) -> bool {
        compare(&self.ends[1], &self.segment(), bound) != Greater
    }

    /// Whether the centre moves away from the target at the start, more than it
    /// might if it were elsewhere by a margin.
    pub(super) fn departs(&self, margin: &Real) -> bool {
        let [from, to] = &self.ends;
        let way = to.minus(from);
        let outwards = match foot(from, &self.segment()) {
            Foot::Beyond(offset) => offset.dot(&way),
            Foot::Between(offset, along) => outwards(&offset, &along, &way),
        };
        exceeds(&outwards, &way, margin)
    }

    /// Whether the line of the way passes a point at no less than `bound`.
    pub(super) fn passes(&self, bound: &Real) -> bool {
        let Target::Point(point) = &self.target else {
            return false;
        };
        let [from, to] = &self.ends;
        let way = to.minus(from);
        let moment = from.minus(point).cross(&way).square();
        moment >= &bound.square() * &way.norm_squared()
    }

    /// About how far from the target the centre starts and ends.
    pub(super) fn distances(&self) -> [f64; 2] {
        let segment = self.segment();
        self.ends.each_ref().map(|end| distance(end, &segment))
    }

    /// About how near to the target the centre gets.
    pub(super) fn least(&self) -> f64 {
        match &self.target {
            Target::Point(point) => distance(point, &self.ends),
            Target::Segment(wall) if cross(&self.ends, wall) => 0.0,
            Target::Segment(wall) => {
                let own = self.ends.iter().map(|end| distance(end, wall));
                let other = wall.iter().map(|end| distance(end, &self.ends));
                own.chain(other).fold(f64::INFINITY, f64::min)
            }
        }
    }

    fn segment(&self) -> [Point; 2] {
        match &self.target {
            Target::Point(point) => [point.clone(), point.clone()],
            Target::Segment(wall) => wall.clone(),
        }
    }
}

/// How fast a point moves away from a line, times the length of `along`.
pub(super) fn outwards(offset: &Point, along: &Point, velocity: &Point) -> Real {
    let drift = velocity.cross(along);
    match offset.cross(along).sign() {
        Less => &Real::zero() - &drift,
        _ => drift,
    }
}

/// Whether a product with a vector is greater than a margin times its length.
pub(super) fn exceeds(product: &Real, vector: &Point, margin: &Real) -> bool {
    let allowed = &margin.square() * &vector.norm_squared();
    product.sign() == Greater && product.square() > allowed
}

/// Of a segment, where the perpendicular from a point meets its line.
enum Foot {
    /// Not between the ends: this one is nearest, with the vector from it.
    Beyond(Point),
    /// Between them: the vectors from the first end to the point, and along.
    Between(Point, Point),
}

fn foot(point: &Point, [from, to]: &[Point; 2]) -> Foot {
    let (offset, along) = (point.minus(from), to.minus(from));
    let part = offset.dot(&along);
    if part.sign() != Greater {
        return Foot::Beyond(offset);
    }
    if part >= along.norm_squared() {
        return Foot::Beyond(point.minus(to));
    }
    Foot::Between(offset, along)
}

/// The order of a point's distance from a segment and a positive bound.
fn compare(point: &Point, segment: &[Point; 2], bound: &Real) -> Ordering {
    let bound = bound.square();
    match foot(point, segment) {
        Foot::Beyond(offset) => offset.norm_squared().cmp(&bound),
        Foot::Between(offset, along) => {
            let reach = &bound * &along.norm_squared();
            offset.cross(&along).square().cmp(&reach)
        }
    }
}

/// A point's distance from a segment, as a binary64 some ulps off.
fn distance(point: &Point, segment: &[Point; 2]) -> f64 {
    match foot(point, segment) {
        Foot::Beyond(offset) => offset.norm_squared().to_f64().sqrt(),
        Foot::Between(offset, along) => {
            offset.cross(&along).to_f64().abs() / along.norm_squared().to_f64().sqrt()
        }
    }
}

/// Whether two segments cross, each strictly from one side to the other.
fn cross(one: &[Point; 2], other: &[Point; 2]) -> bool {
    parts(one, other) && parts(other, one)
}

/// Whether the line of one segment has the ends of the other on both sides.
fn parts([from, to]: &[Point; 2], [one, other]: &[Point; 2]) -> bool {
    let along = to.minus(from);
    let side = |end: &Point| end.minus(from).cross(&along).sign();
    let (one, other) = (side(one), side(other));
    one.is_ne() && one == other.reverse()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn course(ends: [[f64; 2]; 2], target: Target) -> Course {
        let ends = ends.map(Point::from);
        Course { ends, target }
    }

    fn wall(ends: [[f64; 2]; 2]) -> Target {
        Target::Segment(ends.map(Point::from))
    }

    /// Triangles 3-4-5: the distances are whole.
    #[test]
    fn the_nearest_distance() {
        let origin = || Target::Point(Point::origin());
        let table = [
            (course([[-4.0, 3.0], [9.0, 3.0]], origin()), 3.0),
            (course([[4.0, 3.0], [9.0, 3.0]], origin()), 5.0),
            (course([[4.0, 3.0], [4.0, 3.0]], origin()), 5.0),
            (
                course([[0.0, 5.0], [7.0, 2.0]], wall([[1.0, 0.0], [9.0, 0.0]])),
                2.0,
            ),
            (
                course([[-3.0, 4.0], [-9.0, 4.0]], wall([[0.0, 0.0], [9.0, 0.0]])),
                5.0,
            ),
            (
                course([[-5.0, 9.0], [5.0, 9.0]], wall([[0.0, 2.0], [0.0, 0.0]])),
                7.0,
            ),
            (
                course([[3.0, 9.0], [3.0, -9.0]], wall([[0.0, 0.0], [9.0, 0.0]])),
                0.0,
            ),
        ];
        for (course, least) in table {
            assert_eq!(course.least(), least);
            let bound = Real::from(least);
            assert!(!course.gets_nearer_than(&bound));
            let above = Real::from(least.next_up());
            assert!(course.gets_nearer_than(&above));
        }
    }

    #[test]
    fn the_end_is_compared_inclusively() {
        let course = course([[0.0, 9.0], [3.0, 4.0]], Target::Point(Point::origin()));
        assert!(course.ends_within(&Real::from(5.0)));
        assert!(!course.ends_within(&Real::from(5.0_f64.next_down())));
        assert_eq!(course.distances(), [9.0, 5.0]);
    }
}
