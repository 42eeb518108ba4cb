//! How a disc meets a wall: a point in motion meets all that is no further than a radius
//! from a segment.
//!
//! From the start of a wall of direction w and length L the point's offset is x. It is at
//! a side of the stadium where |x × w| = r L: at the time (|x × w| - r L) / |v × w|, if
//! v × w has the other sign than x × w. The foot is on the wall if x·w is between 0
//! and L² then. Otherwise, and if it starts within the strip between the sides, an end's
//! circle is all that it can meet first. It cannot meet both at once: a point as far from
//! both ends as the radius is nearer to the wall between them.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use num_rational::BigRational;
use num_traits::Signed;

use super::circle::Passage;
use super::plane::{Motion, Vector, cross, dot, minus};
use super::{Class, FirstImpact, Quadratic};
use crate::body::End;

/// A disc in motion, and a wall.
pub(super) struct Stadium {
    /// The disc, seen from the wall's start.
    motion: Motion,
    along: Vector,
    squared: BigRational,
    /// x × w.
    side: BigRational,
    /// v × w.
    drift: BigRational,
}

/// What of a wall is nearest.
enum Nearest {
    Interior,
    End(End),
}

impl Stadium {
    pub(super) fn new(mut motion: Motion, from: Vector, to: &Vector) -> Self {
        motion.position = minus(&motion.position, &from);
        let along = minus(to, &from);
        Self {
            squared: dot(&along, &along),
            side: cross(&motion.position, &along),
            drift: cross(&motion.velocity, &along),
            motion,
            along,
        }
    }

    pub(super) fn first_impact(&self) -> FirstImpact {
        match self.nearest() {
            Nearest::End(end) => match self.passage(end).first_impact(Some(end)) {
                // It is outside.
                FirstImpact {
                    class: Class::Miss | Class::Hit | Class::Graze,
                    ..
                } => self.ahead(),
                at_once => at_once,
            },
            Nearest::Interior => match self.gap() {
                Less => FirstImpact::overlap(self.approaches(), None),
                Equal => FirstImpact::touching(self.approaches(), None),
                Greater => self.ahead(),
            },
        }
    }

    /// What of the wall is nearest at the start; where the foot is an end, that.
    fn nearest(&self) -> Nearest {
        let foot = dot(&self.motion.position, &self.along);
        if !foot.is_positive() {
            Nearest::End(End::From)
        } else if foot >= self.squared {
            Nearest::End(End::To)
        } else {
            Nearest::Interior
        }
    }

    /// How the distance from the wall's line compares with the radius.
    fn gap(&self) -> Ordering {
        let radius = &self.motion.radius;
        (&self.side * &self.side).cmp(&(radius * radius * &self.squared))
    }

    /// Whether it moves towards the line; one that is on it is on no side.
    fn approaches(&self) -> bool {
        (&self.side * &self.drift).is_negative()
    }

    /// The first meeting of a disc that is outside.
    fn ahead(&self) -> FirstImpact {
        let side = (self.gap() == Greater && self.approaches()).then(|| self.at_side());
        side.flatten().unwrap_or_else(|| self.at_ends())
    }

    /// The meeting with a side, if the foot is on the wall then.
    fn at_side(&self) -> Option<FirstImpact> {
        let drift = self.drift.abs();
        let (p, q) = (self.side.abs() / &drift, -&self.motion.radius / &drift);
        let time = Quadratic::new(p, q, self.squared.clone());
        let start = dot(&self.motion.position, &self.along);
        let foot = time
            .scaled(&dot(&self.motion.velocity, &self.along))
            .plus(&start);
        let end = match (foot.sign(), foot.plus(&-&self.squared).sign()) {
            (Less, _) | (_, Greater) => return None,
            (Equal, _) => Some(End::From),
            (_, Equal) => Some(End::To),
            _ => None,
        };
        Some(FirstImpact {
            class: Class::Hit,
            time: Some(time),
            end,
        })
    }

    /// The meeting with the end that is met first.
    fn at_ends(&self) -> FirstImpact {
        let [from, to] = [End::From, End::To].map(|end| self.passage(end).first_impact(Some(end)));
        match (&from.time, &to.time) {
            (Some(one), Some(other)) if other.is_less_than(one) => to,
            (Some(_), _) => from,
            (None, _) => to,
        }
    }

    fn passage(&self, end: End) -> Passage {
        let mut motion = Motion {
            position: self.motion.position.clone(),
            velocity: self.motion.velocity.clone(),
            radius: self.motion.radius.clone(),
        };
        if end == End::To {
            motion.position = minus(&motion.position, &self.along);
        }
        Passage::new(&motion, &self.motion.radius)
    }
}
