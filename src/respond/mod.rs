//! What an impact does to velocities: an impulse along the line of centres
//! (P5.1).
//!
//! The normal n stays unnormalised, so no square root is taken: with the
//! relative velocity w of the first body against the second, the approach
//! w·n and the restitution e, the velocities change by
//! ∓ (1 + e) (w·n / n·n) m'/(m + m') n, where m' is the other body's mass.
//! Against a body of infinite mass the share m'/(m + m') is 1. This is the
//! paper's formula, with the unit normal that its derivation needs (D11; van
//! den Heuvel and Jackson: Pool Hall Lessons, 2002).
//!
//! At a contact n·n is R² by construction. Exact arithmetic uses that; where
//! results round, the computed n·n conserves energy better.
//!
//! Contacts of one instant that share discs can also be resolved together:
//! see [`reflect_cluster`].

mod project;
mod reflect;

use std::cmp::Ordering::Less;

use crate::body::{Disc, Mass};
use crate::scalar::Scalar;
use crate::vec2::Vec2;

pub use reflect::{ClusterContact, MAX_ROUNDS, Reflection, reflect_cluster};

/// How much of the motion an impact keeps.
#[derive(Clone, Debug)]
pub enum Restitution<S> {
    /// Nothing is lost.
    Elastic,
    /// Newton's: the normal relative speed after is a part of that before.
    Newton {
        /// The coefficient between discs.
        discs: S,
        /// The coefficient between a disc and a wall.
        walls: S,
        /// The normal relative speed below which nothing is lost.
        elastic_below: Option<S>,
    },
    /// The paper's: after an elastic impact both whole velocities are
    /// multiplied by `1 - C_R` (P5.2, D13). Momentum is not conserved.
    Paper {
        /// The factor `1 - C_R`.
        kept: S,
    },
}

impl<S> Restitution<S> {
    /// The same rule in another arithmetic.
    pub fn map<T>(&self, make: impl Fn(&S) -> T) -> Restitution<T> {
        match self {
            Self::Elastic => Restitution::Elastic,
            Self::Newton {
                discs,
                walls,
                elastic_below,
            } => Restitution::Newton {
                discs: make(discs),
                walls: make(walls),
                elastic_below: elastic_below.as_ref().map(make),
            },
            Self::Paper { kept } => Restitution::Paper { kept: make(kept) },
        }
    }

    /// The numbers of the rule.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = &S> {
        let numbers = match self {
            Self::Elastic => [None; 3],
            Self::Newton {
                discs,
                walls,
                elastic_below,
            } => [Some(discs), Some(walls), elastic_below.as_ref()],
            Self::Paper { kept } => [Some(kept), None, None],
        };
        numbers.into_iter().flatten()
    }
}

impl<S: Scalar> Restitution<S> {
    /// 1 + e for an impact that approaches with w·n along a normal of which
    /// the square is given.
    fn strength(&self, against: Against, approach: &S, normal_squared: &S) -> Result<S, S::Doubt> {
        let Self::Newton {
            discs,
            walls,
            elastic_below,
        } = self
        else {
            return Ok(S::from_integer(2));
        };
        if let Some(speed) = elastic_below {
            let limit = speed.square() * normal_squared;
            if approach.square().compare(&limit)? == Less {
                return Ok(S::from_integer(2));
            }
        }
        let coefficient = match against {
            Against::Disc => discs,
            Against::Wall => walls,
        };
        Ok(S::from_integer(1) + coefficient)
    }

    fn damp(&self, disc: &mut Disc<S>) {
        if let Self::Paper { kept } = self
            && disc.is_movable()
        {
            disc.velocity = disc.velocity.scaled(kept);
        }
    }
}

#[derive(Clone, Copy)]
enum Against {
    Disc,
    Wall,
}

/// The line along which two bodies touch.
#[derive(Clone, Debug)]
pub struct Normal<S> {
    /// From the first body's centre towards the other body, of any length.
    pub direction: Vec2<S>,
    /// Its square: exact where it is known by construction.
    pub squared: S,
}

impl<S> Normal<S> {
    /// The same normal in another arithmetic.
    pub(crate) fn map<T>(&self, make: impl Fn(&S) -> T) -> Normal<T> {
        Normal {
            direction: self.direction.map(&make),
            squared: make(&self.squared),
        }
    }
}

impl<S: Scalar> Normal<S> {
    /// The normal of bodies that touch at a distance of `reach`.
    pub fn at_contact(direction: Vec2<S>, reach: &S) -> Self {
        if S::ROUNDS {
            return Self::at_overlap(direction);
        }
        let squared = reach.square();
        Self { direction, squared }
    }

    /// The normal in the other direction.
    #[must_use]
    pub fn reversed(self) -> Self {
        Self {
            direction: -self.direction,
            ..self
        }
    }

    /// The normal of bodies that overlap, or of a line.
    pub fn at_overlap(direction: Vec2<S>) -> Self {
        let squared = direction.norm_squared();
        Self { direction, squared }
    }
}

/// Resolves the impact of two discs, of which at most one has infinite mass.
///
/// # Errors
///
/// It cannot be decided whether the impact is slow enough to be elastic.
pub fn collide_discs<S: Scalar>(
    first: &mut Disc<S>,
    second: &mut Disc<S>,
    normal: &Normal<S>,
    restitution: &Restitution<S>,
) -> Result<(), S::Doubt> {
    let approach = first
        .velocity
        .minus(&second.velocity)
        .dot(&normal.direction);
    let strength = restitution.strength(Against::Disc, &approach, &normal.squared)?;
    let push = strength * approach / &normal.squared;
    let (first_share, second_share) = shares(&first.mass, &second.mass);
    deflect(first, &normal.direction, &(-push.clone()), first_share);
    deflect(second, &normal.direction, &push, second_share);
    restitution.damp(first);
    restitution.damp(second);
    Ok(())
}

/// Resolves the impact of a disc on a wall (P5.3).
///
/// # Errors
///
/// It cannot be decided whether the impact is slow enough to be elastic.
pub fn collide_wall<S: Scalar>(
    disc: &mut Disc<S>,
    normal: &Normal<S>,
    restitution: &Restitution<S>,
) -> Result<(), S::Doubt> {
    let approach = disc.velocity.dot(&normal.direction);
    let strength = restitution.strength(Against::Wall, &approach, &normal.squared)?;
    let push = strength * approach / &normal.squared;
    deflect(disc, &normal.direction, &(-push), Share::Whole);
    restitution.damp(disc);
    Ok(())
}

/// The part of the relative change of velocity that a body takes.
pub(crate) enum Share<S> {
    Nothing,
    Part(S),
    Whole,
}

/// The parts that two bodies take: in inverse proportion to their masses.
pub(crate) fn shares<S: Scalar>(first: &Mass<S>, second: &Mass<S>) -> (Share<S>, Share<S>) {
    match (first, second) {
        (Mass::Finite(m1), Mass::Finite(m2)) => {
            let total = m1.clone() + m2;
            let part = |mass: &S| Share::Part(mass.clone() / &total);
            (part(m2), part(m1))
        }
        (Mass::Finite(_), Mass::Infinite) => (Share::Whole, Share::Nothing),
        (Mass::Infinite, _) => (Share::Nothing, Share::Whole),
    }
}

fn deflect<S: Scalar>(disc: &mut Disc<S>, normal: &Vec2<S>, push: &S, share: Share<S>) {
    let push = match share {
        Share::Nothing => return,
        Share::Part(part) => part * push,
        Share::Whole => push.clone(),
    };
    disc.velocity = disc.velocity.moved(normal, &push);
}
