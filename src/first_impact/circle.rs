//! How a point in motion meets a circle about the origin.
//!
//! With its position x and velocity v, and the radius R, |x + v t|² = R² has with
//! a = v·v, b = x·v and c = x·x - R² the first root (-b - √(b² - a c)) / a.

use std::cmp::Ordering::{Equal, Greater, Less};

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::plane::{Motion, dot};
use super::{Class, FirstImpact, Quadratic};
use crate::body::End;

/// The coefficients of a point's way.
pub(super) struct Passage {
    a: BigRational,
    b: BigRational,
    c: BigRational,
    /// Whether it starts at the middle, which is in no direction.
    is_concentric: bool,
}

impl Passage {
    pub(super) fn new(motion: &Motion, reach: &BigRational) -> Self {
        let Motion {
            position, velocity, ..
        } = motion;
        let distance = dot(position, position);
        Self {
            a: dot(velocity, velocity),
            b: dot(position, velocity),
            is_concentric: distance.is_zero(),
            c: distance - reach * reach,
        }
    }

    /// Their first meeting; the circle may be that about a wall's end.
    pub(super) fn first_impact(&self, end: Option<End>) -> FirstImpact {
        let approaches = self.b.is_negative();
        match self.c.cmp(&BigRational::zero()) {
            Less => FirstImpact::overlap(approaches && !self.is_concentric, end),
            Equal => FirstImpact::touching(approaches, end),
            Greater if approaches => self.ahead(end),
            Greater => FirstImpact::miss(),
        }
    }

    /// The meeting of a point that is outside, and comes nearer.
    fn ahead(&self, end: Option<End>) -> FirstImpact {
        let d = &self.b * &self.b - &self.a * &self.c;
        let class = match d.cmp(&BigRational::zero()) {
            Less => return FirstImpact::miss(),
            Equal => Class::Graze,
            Greater => Class::Hit,
        };
        FirstImpact {
            class,
            time: Some(Quadratic::new(-&self.b / &self.a, -self.a.recip(), d)),
            end,
        }
    }
}
