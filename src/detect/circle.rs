//! A point that moves towards a circle: two discs, or a disc and an end point.
//!
//! With the relative position d and the relative velocity v, the gap
//! |d + v t|² - R² is the quadratic (v·v) t² + 2 (d·v) t + c with c = d·d - R².
//! They touch first at its smaller root, written as c / (√D - d·v), where
//! nothing cancels: both terms of the denominator are positive. The
//! discriminant is formed as D = (v·v) R² - (d × v)², in which the distance,
//! often much larger than the radii, does not appear squared.
//!
//! The smaller root is not after the mean of both, -d·v / (v·v), when they are
//! nearest. In a graze from close by, where c and D are roundings, the quotient could
//! be far beyond that: a rounded root is not let past it.
//!
//! Degenerate cases: d·v ≥ 0 is not an approach, whatever the gap (so
//! concentric bodies and bodies at relative rest never meet); D = 0 is a
//! tangent pass; c ≤ 0 with an approach is an impact now.

use std::cmp::Ordering::{Equal, Greater, Less};

use super::Encounter;
use crate::scalar::Scalar;
use crate::vec2::Vec2;

/// When a point at `offset` from the centre of a circle of radius `reach`,
/// moving at `velocity` relative to it, meets the circle from outside, or
/// moves inwards inside it.
///
/// # Error in binary64
///
/// Let u = 2^-53, δ = D / (v·v R²) and g = (d·d - R²) / (d·d + R²): δ is 0 in
/// tangency and 1 head-on, g is 0 in contact and nearly 1 far away. For the
/// offset, the velocity and the radius as given, within
/// [`Number::BINARY64_RANGE`](crate::scalar::Number::BINARY64_RANGE):
///
/// - **The verdict** outside the circle is right where |δ| > 8u, that is if the
///   path does not pass the centre at R to within 4u R. For (v·v) R is computed
///   to 3u and d × v to 2u, so D to 3u (v·v) R² + 4u (d × v)² and then 2u of
///   itself; and (d·v)² ≥ δ (d·d) (v·v), δ being no more than 1, so that where
///   D > 0 the sign of d·v is certain too. A large distance plays no part.
/// - **Inside**, the sign of d·v is all that counts: it is certain unless its
///   products cancel to 2u of their sizes.
/// - **The gap** is computed to u of itself and 8u² (d·d + R²), so that its sign
///   is right where |g| > 9u².
/// - **The time** has an error of at most 10u/δ + 9u²/g of itself, where
///   δ ≥ 64u. In the denominator, at least 2√D, the root is wrong by
///   (7u/δ + 3u) √D and d·v by 2u |d||v|, which is at most 2u/√δ of it;
///   subtraction and division add 2u.
///
/// A difference of coordinates is exact if they are within a factor of two of
/// each other, or have few digits, and otherwise wrong by u of itself; so is a
/// sum of radii.
///
/// # Errors
///
/// An enclosure of an intermediate value contains zero.
///
/// # Examples
///
/// A point 4 away from a circle of radius 2, moving at 4 towards its centre:
///
/// ```
/// use carom::detect::meet_circle;
/// use carom::vec2::Vec2;
///
/// let met = meet_circle(&Vec2::new(4.0, 0.0), &Vec2::new(-4.0, 0.0), &2.0)?;
/// assert_eq!(met.unwrap().delay, 0.5);
/// # Ok::<(), std::convert::Infallible>(())
/// ```
#[inline]
pub fn meet_circle<S: Scalar>(
    offset: &Vec2<S>,
    velocity: &Vec2<S>,
    reach: &S,
) -> Result<Option<Encounter<S>>, S::Doubt> {
    let approach = offset.dot(velocity);
    if approach.sign()? != Less {
        return Ok(None);
    }
    let speed_squared = velocity.norm_squared();
    let discriminant = discriminant(offset, velocity, reach, &speed_squared);
    Ok(match discriminant.sign()? {
        Less => None,
        Equal => Some(Encounter::graze(-approach / speed_squared)),
        Greater => Some(enter(
            offset,
            reach,
            (approach, &speed_squared),
            &discriminant,
        )?),
    })
}

/// D. Where nothing rounds, but an enclosed velocity is along an axis, it is
/// (v·v) (R² - d²), with that coordinate of the offset that does not change: so it is
/// known to be zero for a tangent pass at a known distance.
#[inline]
fn discriminant<S: Scalar>(
    offset: &Vec2<S>,
    velocity: &Vec2<S>,
    reach: &S,
    speed_squared: &S,
) -> S {
    let is_along = |across: &S| !S::ROUNDS && across.is_surely_zero();
    let beside = |distance: &S| S::difference_of_products(reach, reach, distance, distance);
    if is_along(&velocity.x) {
        return beside(&offset.x) * speed_squared;
    }
    if is_along(&velocity.y) {
        return beside(&offset.y) * speed_squared;
    }
    let moment = offset.cross(velocity);
    let strength = speed_squared.clone() * reach;
    S::difference_of_products(&strength, reach, &moment, &moment)
}

/// The smaller root of the quadratic, or now where it has passed already.
#[inline]
fn enter<S: Scalar>(
    offset: &Vec2<S>,
    reach: &S,
    (approach, speed_squared): (S, &S),
    discriminant: &S,
) -> Result<Encounter<S>, S::Doubt> {
    let gap = S::power(&offset.x, &offset.y, reach);
    match gap.sign()? {
        Less => return Ok(Encounter::inside()),
        Equal => return Ok(Encounter::now()),
        Greater => {}
    }
    let delay = gap / (discriminant.sqrt() - &approach);
    if S::ROUNDS {
        let nearest = -approach / speed_squared;
        if nearest.compare(&delay)? == Less {
            return Ok(Encounter::impact(nearest));
        }
    }
    Ok(Encounter::impact(delay))
}
