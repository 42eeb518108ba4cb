//! How a wall holds a disc, decided exactly and rounded once.

use std::cmp::Ordering::{self, Equal, Less};
use std::convert::Infallible;

use super::body::{coordinates, line, stored};
use crate::body::Disc;
use crate::detect::Segment;
use crate::effects::Falling;
use crate::effects::falling::weight::Holding;
use crate::filtered::Point;
use crate::scalar::{Dyadic, Filtered, Rounding};
use crate::vec2::Vec2;

type Vector = Vec2<Falling<Filtered>>;

fn exactly(vector: &Vector) -> Point {
    Point::new(coordinates(vector))
}

impl Holding for Falling<Filtered> {
    type Drag = ();

    fn away(
        vector: &Vector,
        disc: &Disc<Self>,
        wall: &Segment<Self>,
    ) -> Result<Ordering, Infallible> {
        let line = line(wall);
        let (along, from) = (line.along(), Point::new(line.from));
        let side = exactly(&disc.position).minus(&from).cross(&along).sign();
        let across = exactly(vector).cross(&along).sign();
        Ok(if side == Less {
            across.reverse()
        } else {
            across
        })
    }

    fn along(vector: &Vector, wall: &Segment<Self>) -> Vector {
        let along = line(wall).along();
        let vector = exactly(vector);
        let (part, squared) = (vector.dot(&along), along.squared());
        let share = |coordinate: &Dyadic| {
            let scaled = part.mul(coordinate);
            scaled.divided_by(&squared, Rounding::Nearest)
        };
        stored([share(&along.x), share(&along.y)])
    }

    fn are_square(one: &Segment<Self>, other: &Segment<Self>) -> bool {
        line(one).along().dot(&line(other).along()).is_zero()
    }

    fn bend(
        disc: &Disc<Self>,
        corner: &Vector,
        gravity: &Vector,
        (): &(),
    ) -> Result<Ordering, Infallible> {
        let [position, velocity, corner, gravity] =
            [&disc.position, &disc.velocity, corner, gravity].map(exactly);
        let offset = position.minus(&corner);
        let bend = velocity.squared().add(&offset.dot(&gravity)).sign();
        Ok(match bend {
            Equal => velocity.dot(&gravity).sign(),
            other => other,
        })
    }
}
