//! A point on a parabola that meets a circle about the origin: a disc that falls,
//! and a body that does not.
//!
//! The gap |d + v t + h t²|² - R² is the quartic
//!
//! ```text
//! (h·h) t⁴ + 2 (v·h) t³ + (v·v + 2 d·h) t² + 2 (d·v) t + (d·d - R²)
//! ```
//!
//! They meet at its first descent to zero. Where they touch already, or overlap
//! and part, its last coefficient counts as zero, and a root is divided out:
//! they meet when they are as close again. If they touch, neither approach nor
//! part, and the second derivative is negative, they would enter each other: the
//! point *rests* on the circle.

use std::cmp::Ordering::{Equal, Greater, Less};

use super::arc::Arc;
use crate::detect::Encounter;
use crate::roots::{Polynomial, Roots};
use crate::scalar::Scalar;

type Met<S> = Result<Option<Encounter<S>>, <S as Scalar>::Doubt>;

/// When a point meets a circle of radius `reach`.
pub(super) fn meet<S: Roots>(arc: &Arc<S>, reach: &S) -> Met<S> {
    let gap = S::power(&arc.offset.x, &arc.offset.y, reach);
    let gap_sign = gap.sign()?;
    if gap_sign == Greater {
        let [linear, square, cube, fourth] = powers(arc);
        return descent([gap, linear, square, cube, fourth]);
    }
    match (arc.offset.dot(&arc.velocity).sign()?, gap_sign) {
        (Less, Less) => Ok(Some(Encounter::inside())),
        (Less, _) => Ok(Some(Encounter::now())),
        _ => meet_again(arc),
    }
}

/// When a point that is on a circle, and does not approach its centre, meets it
/// again.
pub(super) fn meet_again<S: Roots>(arc: &Arc<S>) -> Met<S> {
    let zero = || S::from_integer(0);
    let [linear, square, cube, fourth] = powers(arc);
    match linear.sign()? {
        Less => Ok(Some(Encounter::now())),
        Greater => descent([linear, square, cube, fourth, zero()]),
        Equal => leave(arc),
    }
}

/// The same, where its way is known to be a tangent of the circle.
pub(super) fn leave<S: Roots>(arc: &Arc<S>) -> Met<S> {
    let zero = || S::from_integer(0);
    let [_, square, cube, fourth] = powers(arc);
    match (square.sign()?, cube.sign()?) {
        (Less, _) | (Equal, Less) => Ok(Some(Encounter::rest())),
        (Greater, _) => descent([square, cube, fourth, zero(), zero()]),
        (Equal, Greater) => descent([cube, fourth, zero(), zero(), zero()]),
        (Equal, Equal) => Ok(None),
    }
}

/// The coefficients of the gap, but for the constant one.
fn powers<S: Scalar>(arc: &Arc<S>) -> [S; 4] {
    let Arc {
        offset,
        velocity,
        half_pull,
    } = arc;
    let two = || S::from_integer(2);
    [
        two() * offset.dot(velocity),
        velocity.norm_squared() + two() * offset.dot(half_pull),
        two() * velocity.dot(half_pull),
        half_pull.norm_squared(),
    ]
}

fn descent<S: Roots>(coefficients: [S; 5]) -> Met<S> {
    let met = S::descent(&Polynomial(coefficients))?;
    Ok(met.map(|met| Encounter {
        graze: met.graze,
        ..Encounter::impact(met.time)
    }))
}
