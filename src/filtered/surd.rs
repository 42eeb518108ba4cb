//! Numbers `(p + q √d) / a`, computed with exactly.
//!
//! The time at which two bodies meet is such a number, for bodies whose
//! positions, velocities and radii are dyadic; and so is where a body is then.
//! Their order takes nothing but products and sums of whole numbers: square
//! roots go away by squaring, at most twice.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use num_bigint::BigInt;

use crate::scalar::{Dyadic, Rounding, isqrt};

/// `(rational + factor √radicand) / divisor`.
#[derive(Clone, Debug)]
pub(super) struct Surd {
    pub(super) rational: Dyadic,
    pub(super) factor: Dyadic,
    /// Not negative.
    pub(super) radicand: Dyadic,
    /// Positive.
    pub(super) divisor: Dyadic,
}

/// The significant bits of a root in an estimate.
const ROOT_BITS: i64 = 160;

impl Surd {
    /// The number times `slope`, plus `offset`.
    pub(super) fn mapped(&self, slope: &Dyadic, offset: &Dyadic) -> Self {
        let offset = offset.mul(&self.divisor);
        Self {
            rational: self.rational.mul(slope).add(&offset),
            factor: self.factor.mul(slope),
            radicand: self.radicand.clone(),
            divisor: self.divisor.clone(),
        }
    }

    /// The number, later by a time.
    pub(super) fn plus(&self, offset: &Dyadic) -> Self {
        self.mapped(&Dyadic::from(1), offset)
    }

    /// The order of two numbers.
    pub(super) fn order(&self, other: &Self) -> Ordering {
        let difference = self
            .rational
            .mul(&other.divisor)
            .sub(&other.rational.mul(&self.divisor));
        let own = self.factor.mul(&other.divisor);
        let others = -other.factor.mul(&self.divisor);
        sign_of_two_roots(
            &difference,
            (&own, &self.radicand),
            (&others, &other.radicand),
        )
    }

    /// The order against a dyadic number.
    pub(super) fn order_to(&self, number: &Dyadic) -> Ordering {
        let difference = self.rational.clone().sub(&number.mul(&self.divisor));
        sign_of_root(&difference, &self.factor, &self.radicand)
    }

    /// The nearest binary64, of two equally near ones the even one.
    pub(super) fn to_f64(&self) -> f64 {
        let (numerator, divisor) = self.estimate();
        let guess = numerator.divided_by(&divisor, Rounding::Nearest);
        if self.factor.is_zero() || self.radicand.is_zero() {
            return guess;
        }
        self.settle(guess)
    }

    /// Numerator and denominator of a fraction that is near the number, with a
    /// relative error of less than 2^-100: where rational part and root cancel,
    /// p + q √d is (p² - q² d) / (p - q √d).
    fn estimate(&self) -> (Dyadic, Dyadic) {
        let (p, a) = (&self.rational, &self.divisor);
        let root = self.factor.mul(&root(&self.radicand));
        if p.is_zero() || root.is_zero() || p.sign() == root.sign() {
            return (p.clone().add(&root), a.clone());
        }
        let conjugate = a.mul(&p.clone().sub(&root));
        let squared = self.factor.mul(&self.factor).mul(&self.radicand);
        let norm = p.mul(p).sub(&squared);
        if conjugate.sign() == Less {
            (-norm, -conjugate)
        } else {
            (norm, conjugate)
        }
    }

    /// The nearest binary64, from one near it.
    fn settle(&self, mut guess: f64) -> f64 {
        while guess.is_finite() {
            let is_even = guess.to_bits() & 1 == 0;
            let upper = self.order_to(&middle(guess, guess.next_up()));
            let lower = self.order_to(&middle(guess, guess.next_down()));
            if upper == Greater || upper == Equal && !is_even {
                guess = guess.next_up();
            } else if lower == Less || lower == Equal && !is_even {
                guess = guess.next_down();
            } else {
                break;
            }
        }
        guess
    }
}

/// Half way between two binary64 numbers, of which the second may be infinite.
fn middle(one: f64, other: f64) -> Dyadic {
    let other = if other.is_infinite() {
        Dyadic::new(BigInt::from(other.signum() as i32), 1024)
    } else {
        Dyadic::from_f64(other)
    };
    Dyadic::from_f64(one).add(&other).halved()
}

/// The square root, rounded down to so many bits.
fn root(radicand: &Dyadic) -> Dyadic {
    let mantissa = radicand.mantissa();
    let lack = (2 * ROOT_BITS - mantissa.bits() as i64).max(0);
    let exponent = radicand.exponent() - lack;
    let (lack, exponent) = (
        lack + exponent.rem_euclid(2),
        exponent - exponent.rem_euclid(2),
    );
    let root = isqrt(&(mantissa.magnitude() << lack));
    Dyadic::new(root.into(), exponent / 2)
}

/// The sign of `x + y √d`.
pub(super) fn sign_of_root(x: &Dyadic, y: &Dyadic, d: &Dyadic) -> Ordering {
    let rational = x.sign();
    let root = if d.is_zero() { Equal } else { y.sign() };
    stronger(rational, root, || x.mul(x).compare(&y.mul(y).mul(d)))
}

/// The sign of `x + y √d + z √e`.
fn sign_of_two_roots(
    x: &Dyadic,
    (y, d): (&Dyadic, &Dyadic),
    (z, e): (&Dyadic, &Dyadic),
) -> Ordering {
    let first = sign_of_root(x, y, d);
    let second = if e.is_zero() { Equal } else { z.sign() };
    stronger(first, second, || {
        let squares = x.mul(x).add(&y.mul(y).mul(d)).sub(&z.mul(z).mul(e));
        let twice = x.mul(y).mul(&Dyadic::from(2));
        sign_of_root(&squares, &twice, d)
    })
}

/// The sign of a sum of two terms with these signs, given how their magnitudes
/// compare.
fn stronger(first: Ordering, second: Ordering, compare: impl FnOnce() -> Ordering) -> Ordering {
    if second == Equal || first == second {
        return first;
    }
    if first == Equal {
        return second;
    }
    match compare() {
        Greater => first,
        Equal => Equal,
        Less => second,
    }
}
