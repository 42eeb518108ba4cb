//! The way of a disc's centre, in dyadic numbers.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::body::Body;
use crate::filtered::{Line, Point};
use crate::roots::Polynomial;
use crate::scalar::Dyadic;

/// d + v t + h t², where h is half the acceleration, by powers of the time.
#[derive(Clone, Debug)]
pub(super) struct Parabola([Point; 3]);

impl Parabola {
    /// The way of a disc from where it is known.
    pub(super) fn of(disc: &Body) -> Self {
        let half = Dyadic::from(1).halved();
        let [position, velocity, pull] = [disc.position, disc.velocity, disc.pull].map(Point::new);
        Self([position, velocity, pull.scaled(&half)])
    }

    /// The way of the later disc from where it is known, seen from the earlier
    /// one.
    pub(super) fn between([early, late]: &[Body; 2]) -> Self {
        let waited = Dyadic::from_f64(late.since).sub(&Dyadic::from_f64(early.since));
        let (Self(early), Self(late)) = (Self::of(early).after(&waited), Self::of(late));
        Self([0, 1, 2].map(|power| late[power].minus(&early[power])))
    }

    /// The same way from a later time on.
    fn after(&self, time: &Dyadic) -> Self {
        let [d, v, h] = &self.0;
        let gain = h.scaled(time);
        let position = d.plus(&v.plus(&gain).scaled(time));
        Self([position, v.plus(&gain).plus(&gain), h.clone()])
    }

    /// The same way, seen from a point.
    pub(super) fn seen_from(&self, point: [f64; 2]) -> Self {
        let [offset, velocity, half] = self.0.clone();
        Self([offset.minus(&Point::new(point)), velocity, half])
    }

    /// How far aside of a wall's line the centre is, times the wall's length, if
    /// it is seen from the wall's first end point.
    pub(super) fn side(&self, wall: &Line) -> Quadratic {
        let along = wall.along();
        Quadratic(self.0.each_ref().map(|power| power.cross(&along)))
    }

    /// Where along the wall it is, the same way.
    pub(super) fn foot(&self, wall: &Line) -> Quadratic {
        let along = wall.along();
        Quadratic(self.0.each_ref().map(|power| power.dot(&along)))
    }

    /// The square of the distance, less that of the radius.
    pub(super) fn gap(&self, radius: &Dyadic) -> Polynomial<Dyadic> {
        let [d, v, h] = &self.0;
        Polynomial([
            d.squared().sub(&radius.mul(radius)),
            twice(d.dot(v)),
            v.squared().add(&twice(d.dot(h))),
            twice(v.dot(h)),
            h.squared(),
        ])
    }
}

/// A quadratic, by ascending powers.
#[derive(Clone, Debug)]
pub(super) struct Quadratic(pub(super) [Dyadic; 3]);

impl Quadratic {
    /// A side, counted from the wall towards one of its sides.
    pub(super) fn on(&self, side: Ordering) -> Self {
        match side {
            Less => self.clone().reversed(),
            Equal | Greater => self.clone(),
        }
    }

    fn reversed(self) -> Self {
        Self(self.0.map(|number| -number))
    }

    /// What is left to a number.
    pub(super) fn below(self, number: &Dyadic) -> Self {
        let Self([c, b, a]) = self.reversed();
        Self([c.add(number), b, a])
    }

    pub(super) fn polynomial(&self) -> Polynomial<Dyadic> {
        let [c, b, a] = self.0.clone();
        Polynomial([c, b, a, Dyadic::zero(), Dyadic::zero()])
    }

    /// Without the constant, divided by the time.
    pub(super) fn divided(&self) -> Polynomial<Dyadic> {
        let [_, b, a] = self.0.clone();
        Polynomial([b, a, Dyadic::zero(), Dyadic::zero(), Dyadic::zero()])
    }

    /// The square, less a number.
    pub(super) fn squared_above(&self, number: &Dyadic) -> Polynomial<Dyadic> {
        let [c, b, a] = &self.0;
        Polynomial([
            c.mul(c).sub(number),
            twice(c.mul(b)),
            b.mul(b).add(&twice(c.mul(a))),
            twice(b.mul(a)),
            a.mul(a),
        ])
    }
}

fn twice(number: Dyadic) -> Dyadic {
    number.clone().add(&number)
}
