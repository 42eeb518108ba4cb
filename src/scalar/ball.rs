//! Midpoint-radius enclosures: a number known up to an error.
//!
//! Every operation encloses all results that its operands' enclosures admit
//! (Johansson: Arb: efficient arbitrary-precision midpoint-radius interval
//! arithmetic, 2017). Midpoints are rounded to the bits asked for, and to what
//! the radius justifies; the radius takes up what that leaves out.

use std::cmp::Ordering;
use std::ops::Neg;

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;

use super::dyadic::Dyadic;
use super::interval::Interval;
use super::isqrt::isqrt;
use super::radius::{MAX_EXPONENT, Radius};
use super::rounding::{Leading, Rounding};

/// The numbers at most `rad` away from `mid`.
///
/// Where the radius is [`Radius::UNKNOWN`], that is any number.
#[derive(Clone, Debug)]
pub(crate) struct Ball {
    mid: Dyadic,
    rad: Radius,
}

/// A ball that is only looked at; any [`Dyadic`] is one as it stands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BallRef<'a> {
    mid: &'a Dyadic,
    rad: Radius,
}

/// Bits that a midpoint keeps below its radius, so that rounding it adds next
/// to nothing to the radius.
const GUARD: i64 = 32;

/// Bits too many that are not worth the effort of removing them.
const SLACK: i64 = 32;

impl Ball {
    /// Encloses `mid` ± `rad` with a midpoint of about so many bits.
    #[inline]
    fn rounded(mid: Dyadic, rad: Radius, bits: u32) -> Self {
        let top = mid.top();
        if rad.is_unknown() || top > MAX_EXPONENT {
            return Self::unknown();
        }
        // A radius is never less than this, so no midpoint need be finer.
        let floor = floor_of(rad).max(-MAX_EXPONENT);
        Self { mid, rad }.floored(floor.max(top - i64::from(bits)))
    }

    /// Moves what the midpoint has below 2^`floor` into the radius.
    #[inline]
    fn floored(mut self, floor: i64) -> Self {
        let worthwhile = floor - self.mid.exponent() >= SLACK;
        if worthwhile && self.mid.floor_at(floor) {
            self.rad = self.rad.add(Radius::power_of_two(floor));
        }
        self
    }

    /// The ball with a midpoint of about so many bits.
    pub(crate) fn shortened(self, bits: u32) -> Self {
        Self::rounded(self.mid, self.rad, bits)
    }

    /// The ball of a midpoint and a radius as they are.
    pub(crate) fn around(mid: Dyadic, rad: Radius) -> Self {
        Self { mid, rad }
    }

    /// The midpoint.
    pub(crate) fn into_middle(self) -> Dyadic {
        self.mid
    }

    /// A ball about an exact number.
    pub(crate) fn from_dyadic(number: Dyadic, bits: u32) -> Self {
        Self::rounded(number, Radius::ZERO, bits)
    }

    /// A ball about a fraction.
    pub(crate) fn from_ratio(ratio: &BigRational, bits: u32) -> Self {
        let numerator = Dyadic::new(ratio.numer().clone(), 0);
        let denominator = Dyadic::new(ratio.denom().clone(), 0);
        BallRef::exact(&numerator).div(BallRef::exact(&denominator), bits)
    }

    /// Any number.
    pub(crate) fn unknown() -> Self {
        Self {
            mid: Dyadic::zero(),
            rad: Radius::UNKNOWN,
        }
    }

    /// The numbers from zero up to a bound.
    fn up_to(bound: Radius) -> Self {
        let rad = bound.half();
        let mid = rad.to_dyadic();
        if rad.is_unknown() {
            Self::unknown()
        } else {
            Self { mid, rad }
        }
    }

    #[inline]
    pub(crate) fn view(&self) -> BallRef<'_> {
        BallRef {
            mid: &self.mid,
            rad: self.rad,
        }
    }

    /// The sum. Bits of either midpoint far below the radius of the sum are
    /// not added up.
    #[inline]
    pub(crate) fn add(self, other: BallRef<'_>, bits: u32) -> Self {
        let rad = self.rad.add(other.rad);
        if rad.is_unknown() {
            return Self::unknown();
        }
        let lowest = self.mid.exponent().min(other.mid.exponent());
        let floor = floor_of(rad);
        if floor - lowest < SLACK {
            return Self::rounded(self.mid.add(other.mid), rad, bits);
        }
        // Each midpoint is lowered by less than 2^floor.
        let rad = rad.add(Radius::power_of_two(floor + 1));
        Self::rounded(self.mid.add_floored(other.mid, floor), rad, bits)
    }
}

impl Neg for Ball {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            mid: -self.mid,
            rad: self.rad,
        }
    }
}

/// The exponent below which a radius makes bits of a midpoint pointless.
#[inline]
fn floor_of(rad: Radius) -> i64 {
    rad.top() - GUARD
}

impl<'a> BallRef<'a> {
    #[inline]
    pub(crate) fn exact(mid: &'a Dyadic) -> Self {
        let rad = Radius::ZERO;
        Self { mid, rad }
    }

    #[inline]
    fn is_unknown(self) -> bool {
        self.rad.is_unknown()
    }

    /// Whether the ball is a single number.
    pub(crate) fn is_exact(self) -> bool {
        self.rad.is_zero()
    }

    /// The binary64 nearest to the midpoint.
    pub(crate) fn to_f64(self) -> f64 {
        self.mid.to_f64(Rounding::Nearest)
    }

    /// The bound of the error.
    pub(crate) fn radius(self) -> Radius {
        self.rad
    }

    pub(crate) fn to_ball(self) -> Ball {
        Ball {
            mid: self.mid.clone(),
            rad: self.rad,
        }
    }

    pub(crate) fn add(self, other: BallRef<'_>, bits: u32) -> Ball {
        self.to_ball().add(other, bits)
    }

    pub(crate) fn sub(self, other: BallRef<'_>, bits: u32) -> Ball {
        -(-self.to_ball()).add(other, bits)
    }

    /// (a ± r) (b ± s) lies within |a| s + (|b| + s) r of a b.
    #[inline]
    pub(crate) fn mul(self, other: BallRef<'_>, bits: u32) -> Ball {
        let (a, b) = (Radius::above(self.mid), Radius::above(other.mid));
        let rad = a.mul(other.rad).add(b.add(other.rad).mul(self.rad));
        Ball::rounded(self.mid.mul(other.mid), rad, bits)
    }

    /// (a ± r)² lies within (2 |a| + r) r of a², and above zero.
    #[inline]
    pub(crate) fn square(self, bits: u32) -> Ball {
        let a = Radius::above(self.mid);
        if self.sign().is_none() {
            let upper = a.add(self.rad);
            return Ball::up_to(upper.mul(upper));
        }
        let rad = a.add(a).add(self.rad).mul(self.rad);
        Ball::rounded(self.mid.mul(self.mid), rad, bits)
    }

    /// (a ± r) / (b ± s) lies within (r + |a / b| s) / (|b| - s) of a / b;
    /// nothing is known if the divisor contains zero.
    pub(crate) fn div(self, other: BallRef<'_>, bits: u32) -> Ball {
        let divisor = Radius::below_down(other.mid).sub_down(other.rad);
        if divisor.is_zero() {
            return Ball::unknown();
        }
        let bits = self.useful_bits(bits).min(other.useful_bits(bits));
        let quotient = truncated_quotient(self.mid, other.mid, bits);
        let unit = Radius::power_of_two(quotient.exponent());
        let magnitude = Radius::above(&quotient).add(unit);
        let rad = magnitude.mul(other.rad).add(self.rad).div(divisor);
        Ball::rounded(quotient, rad.add(unit), bits)
    }

    /// √(a ± r) lies within r / (√a + √(a - r)) of √a; a ball that contains
    /// zero is cut off there.
    pub(crate) fn sqrt(self, bits: u32) -> Ball {
        let middle = Radius::below_down(self.mid);
        let lowest = middle.sub_down(self.rad);
        if lowest.is_zero() || self.mid.sign() != Ordering::Greater {
            return self.sqrt_from_zero();
        }
        let bits = self.useful_bits(bits);
        let root = truncated_sqrt(self.mid, bits);
        let unit = Radius::power_of_two(root.exponent());
        let rad = self
            .rad
            .div(middle.sqrt_down().add_down(lowest.sqrt_down()));
        Ball::rounded(root, rad.add(unit), bits)
    }

    /// From zero up to the root of the upper end.
    fn sqrt_from_zero(self) -> Ball {
        let middle = match self.mid.sign() {
            Ordering::Greater => Radius::above(self.mid),
            _ => Radius::ZERO,
        };
        Ball::up_to(middle.add(self.rad).sqrt())
    }

    /// How many of the bits asked for a result can be worth: not many more
    /// than are certain here.
    #[inline]
    fn useful_bits(self, bits: u32) -> u32 {
        let certain = self.mid.top() - floor_of(self.rad);
        certain.min(i64::from(bits)).max(1) as u32
    }

    /// The sign, where it is certain.
    #[inline]
    pub(crate) fn sign(self) -> Option<Ordering> {
        let certain = self.is_exact() || Radius::below_down(self.mid) > self.rad;
        certain.then(|| self.mid.sign())
    }

    /// How many bits are certain: the greatest n found with an error of at
    /// most 2^-n, relative to the number; none for an exact number.
    pub(crate) fn accuracy(self) -> Option<i64> {
        if self.is_exact() {
            return None;
        }
        let lowest = Radius::below_down(self.mid).sub_down(self.rad);
        // The number is at least 2^(top - 1), the error less than 2^top.
        Some((lowest.top() - 1 - self.rad.top()).max(0))
    }

    /// Binary64 bounds.
    pub(crate) fn hull(self) -> Interval {
        if self.is_unknown() {
            return Interval::UNBOUNDED;
        }
        if self.is_exact() {
            return Interval::new(
                self.mid.to_f64(Rounding::Down),
                self.mid.to_f64(Rounding::Up),
            );
        }
        let (lo, hi, exponent) = self.leading_bounds();
        Interval::new(
            signed_to_f64(lo, exponent, Rounding::Down),
            signed_to_f64(hi, exponent, Rounding::Up),
        )
    }

    /// Bounds in units of a power of two, from the leading bits alone.
    fn leading_bounds(self) -> (i128, i128, i64) {
        let leading = self.mid.leading();
        // The unit in which the larger one has 64 bits.
        let exponent = match self.mid.is_zero() {
            true => self.rad.top() - 64,
            false => leading.exponent.max(self.rad.top() - 64),
        };
        let shift = (exponent - leading.exponent).clamp(0, 64) as u32;
        let magnitude = i128::from(leading.bits) >> shift;
        let more = leading.more || magnitude << shift != i128::from(leading.bits);
        let rad = i128::from(self.rad.in_units(exponent));
        let (near, far) = (magnitude - rad, magnitude + i128::from(more) + rad);
        match self.mid.sign() {
            Ordering::Less => (-far, -near, exponent),
            _ => (near, far, exponent),
        }
    }

    /// The ends, unless nothing is known.
    pub(crate) fn ends(self) -> Option<(BigRational, BigRational)> {
        if self.is_unknown() {
            return None;
        }
        let rad = self.rad.to_dyadic();
        let lower = self.mid.clone().add(&-rad.clone());
        let upper = self.mid.clone().add(&rad);
        Some((lower.to_rational(), upper.to_rational()))
    }
}

/// The binary64 neighbour of `mantissa` × 2^`exponent`.
fn signed_to_f64(mantissa: i128, exponent: i64, rounding: Rounding) -> f64 {
    Leading::of_u128(mantissa.unsigned_abs(), exponent).to_f64(mantissa < 0, rounding)
}

/// A quotient of at least so many bits, rounded towards zero.
fn truncated_quotient(a: &Dyadic, b: &Dyadic, bits: u32) -> Dyadic {
    let wanted = i64::from(bits) + b.mantissa().bits() as i64;
    let shift = (wanted - a.mantissa().bits() as i64).max(0);
    let quotient = (a.mantissa() << shift) / b.mantissa();
    Dyadic::new(quotient, a.exponent() - shift - b.exponent())
}

/// The square root of a positive number to at least so many bits, rounded
/// down.
fn truncated_sqrt(number: &Dyadic, bits: u32) -> Dyadic {
    let shift = 2 * i64::from(bits) - number.mantissa().bits() as i64;
    // The exponent that is halved has to be even.
    let shift = shift - ((number.exponent() - shift) & 1);
    let magnitude = number.mantissa().magnitude();
    // Bits that are cut off do not affect the root rounded down.
    let root = if shift >= 0 {
        isqrt(&(magnitude << shift))
    } else {
        isqrt(&(magnitude >> -shift))
    };
    let mantissa = BigInt::from_biguint(Sign::Plus, root);
    Dyadic::new(mantissa, (number.exponent() - shift) / 2)
}

#[cfg(test)]
mod tests;
