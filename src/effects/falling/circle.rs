//! A disc that falls, and a point or a body that does not, or not as fast.
//!
//! They meet where the square of their distance, less that of the radii together,
//! first descends to zero. Where they touch already, or overlap and part, it
//! counts as zero at the start: they meet when they are as close again. If they
//! touch, neither approach nor part, and the second derivative is negative, they
//! would enter each other: the one *rests* on the other.

use std::cmp::Ordering::{Greater, Less};

use super::gap::{Gap, Met};
use super::trajectory::Trajectory;
use crate::detect::Encounter;
use crate::scalar::Scalar;

/// When a point meets a circle about the origin of radius `reach`.
pub(super) fn meet<S: Scalar>(way: &impl Trajectory<S>, reach: &S) -> Met<S> {
    let gap = S::power(&way.offset().x, &way.offset().y, reach);
    let sign = gap.sign()?;
    if sign == Greater {
        return way.distance(gap).descent(0);
    }
    match (way.offset().dot(way.velocity()).sign()?, sign) {
        (Less, Less) => Ok(Some(Encounter::inside())),
        (Less, _) => Ok(Some(Encounter::now())),
        _ => meet_again(way),
    }
}

/// When a point that is on a circle, and does not approach its centre, meets it
/// again.
pub(super) fn meet_again<S: Scalar>(way: &impl Trajectory<S>) -> Met<S> {
    way.distance(S::from_integer(0)).meet_from_contact(1)
}

/// The same, where its way is known to be a tangent of the circle.
pub(super) fn leave<S: Scalar>(way: &impl Trajectory<S>) -> Met<S> {
    way.distance(S::from_integer(0)).meet_from_contact(2)
}
