//! Distances along a straight way, exactly. What is asked of them is how far an answer is
//! from another one.

use carom::scalar::Number;
use carom::scene::{Disc, Wall};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

pub(super) type Vector = [BigRational; 2];

pub(super) fn vector(point: &[Number; 2]) -> Vector {
    point.each_ref().map(Number::to_rational)
}

pub(super) fn minus([x, y]: &Vector, [other_x, other_y]: &Vector) -> Vector {
    [x - other_x, y - other_y]
}

pub(super) fn dot([x, y]: &Vector, [other_x, other_y]: &Vector) -> BigRational {
    x * other_x + y * other_y
}

pub(super) fn cross([x, y]: &Vector, [other_x, other_y]: &Vector) -> BigRational {
    x * other_y - y * other_x
}

/// A disc's way, seen from what it may meet: a point, or a segment from the origin.
pub(super) struct Way {
    pub(super) position: Vector,
    pub(super) velocity: Vector,
    pub(super) reach: BigRational,
    /// Where the segment leads.
    pub(super) along: Option<Vector>,
}

impl Way {
    pub(super) fn of_discs(one: &Disc, other: &Disc) -> Self {
        Self {
            position: minus(&vector(&one.position), &vector(&other.position)),
            velocity: minus(&vector(&one.velocity), &vector(&other.velocity)),
            reach: one.radius.to_rational() + other.radius.to_rational(),
            along: None,
        }
    }

    pub(super) fn to_wall(disc: &Disc, wall: &Wall) -> Self {
        let from = vector(&wall.from);
        Self {
            position: minus(&vector(&disc.position), &from),
            velocity: vector(&disc.velocity),
            reach: disc.radius.to_rational(),
            along: Some(minus(&vector(&wall.to), &from)),
        }
    }

    /// The square of the distance at the start.
    pub(super) fn start(&self) -> BigRational {
        let Some(along) = &self.along else {
            return dot(&self.position, &self.position);
        };
        let foot = dot(&self.position, along) / dot(along, along);
        let foot = foot.clamp(BigRational::zero(), BigRational::one());
        let apart = minus(&self.position, &along.each_ref().map(|part| part * &foot));
        dot(&apart, &apart)
    }

    /// The square of the least distance, from the start on.
    pub(super) fn least(&self) -> BigRational {
        let Some(along) = &self.along else {
            return self.least_from(&self.position);
        };
        if self.crosses(along) {
            return BigRational::zero();
        }
        let to = self.least_from(&minus(&self.position, along));
        self.start().min(self.least_from(&self.position)).min(to)
    }

    /// The same, from a point that is seen in that place.
    fn least_from(&self, place: &Vector) -> BigRational {
        let towards = dot(place, &self.velocity);
        let distance = dot(place, place);
        match towards.is_negative() {
            true => distance - &towards * &towards / dot(&self.velocity, &self.velocity),
            false => distance,
        }
    }

    /// Whether the centre goes through the segment.
    fn crosses(&self, along: &Vector) -> bool {
        let turn = cross(&self.velocity, along);
        if turn.is_zero() {
            return false;
        }
        let back = self.position.each_ref().map(|part| -part);
        let time = cross(&back, along) / &turn;
        let place = cross(&back, &self.velocity) / turn;
        !time.is_negative() && !place.is_negative() && place <= BigRational::one()
    }

    /// By what part of the reach a distance, given by its square, differs from it.
    pub(super) fn margin(&self, square: &BigRational) -> f64 {
        // |√s - 1| = |s - 1| / (√s + 1).
        let part = square / (&self.reach * &self.reach);
        let difference = (&part - BigRational::one()).abs();
        nearest(difference) / (nearest(part).sqrt() + 1.0)
    }
}

/// The nearest binary64 of a number that is of no absurd size.
pub(super) fn nearest(value: BigRational) -> f64 {
    Number::try_from(value).map_or(f64::MAX, |number| number.to_f64())
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom::scene::Scene;

    /// A disc of radius 1 goes along y = 2, 3 and -1 past the wall from (0, 0) to (4, 0).
    #[test]
    fn margins_are_parts_of_the_reach() {
        let margin = |y: i32, speed: i32| {
            let disc = Disc::at([-3, y], 1).velocity([speed, 0]);
            let scene = Scene::builder("pass").disc(disc).wall([0, 0], [4, 0]);
            let scene = scene.build().expect("a scene");
            let way = Way::to_wall(&scene.discs()[0], &scene.walls()[0]);
            way.margin(&way.least())
        };
        assert_eq!(margin(2, 1), 1.0);
        assert_eq!(margin(3, 1), 2.0);
        assert_eq!(margin(-1, 1), 0.0);
        // It goes away: √(3² + 4²) is four more than 1.
        assert_eq!(margin(4, -1), 4.0);
        // Through it all.
        assert_eq!(margin(0, 2), 1.0);
    }

    #[test]
    fn a_way_through_a_wall_comes_as_near_as_can_be() {
        let scene = Scene::builder("through")
            .disc(Disc::at([1, 5], 1).velocity([0, -1]))
            .wall([0, 0], [4, 1])
            .build()
            .expect("a scene");
        let way = Way::to_wall(&scene.discs()[0], &scene.walls()[0]);
        assert!(way.least().is_zero());
    }
}
