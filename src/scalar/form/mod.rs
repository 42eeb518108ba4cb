//! Enclosures that know how their errors hang together.
//!
//! A number x with midpoint m may carry a *linear form*: x - m lies within
//! c₁ ε₁ + … + cₙ εₙ ± rest, where the symbols ε, of which nothing is known
//! but that they lie in [-1, 1], are shared by all numbers of a *basis*. The
//! radius of the number bounds the whole form, so that whoever does not know
//! of forms computes with the ball as ever.
//!
//! - [`step`] takes numbers and their forms through a whole computation;
//! - [`rebase`] gives all numbers new symbols before the rests, which know of
//!   nothing, matter.
//!
//! The coefficients are binary64 numbers with a common power of two. What
//! rounds in computing with them is bounded beforehand and goes to the rest.

mod mean_value;
mod rebase;

use std::sync::Arc;

use super::ball::Ball;
use super::dyadic::Dyadic;
use super::radius::Radius;
use super::rounding::power_of_two;

pub(super) use mean_value::step;
pub(super) use rebase::{Enclosed, rebase};

/// Bits of a midpoint that are kept below its radius: as many as the
/// coefficients have, and some.
const GUARD: i64 = 64;

/// What underflows in computing with coefficients of about 1 is far less
/// than 2 to this.
const UNDERFLOW: i64 = -900;

/// A set of symbols; the same only as itself.
#[derive(Clone, Debug)]
struct Basis(Arc<()>);

impl Basis {
    fn new() -> Self {
        Self(Arc::new(()))
    }

    fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// How far a number is from its midpoint, in terms of the symbols of a basis.
#[derive(Clone, Debug)]
pub(super) struct Form {
    /// None where there are no symbols, and the rest is all.
    basis: Option<Basis>,
    /// Symbols, in ascending order, with their coefficients: at most about 1
    /// each, in units of 2^`exponent`.
    terms: Vec<(u32, f64)>,
    exponent: i64,
    /// A bound of the sum of all coefficients.
    linear: Radius,
    /// A bound of what the symbols leave out.
    rest: Radius,
}

impl Form {
    /// Something of which only a bound is known.
    pub(super) fn unknown(rest: Radius) -> Self {
        Self {
            basis: None,
            terms: Vec::new(),
            exponent: 0,
            linear: Radius::ZERO,
            rest,
        }
    }

    /// What one symbol explains.
    fn of_symbol(basis: &Basis, symbol: u32, bound: Radius) -> Self {
        Self {
            basis: Some(basis.clone()),
            terms: vec![(symbol, bound.fraction())],
            exponent: bound.top(),
            linear: bound,
            rest: Radius::ZERO,
        }
    }

    /// The form with these terms in units of 2^`exponent`; none if they
    /// overflow.
    fn new(basis: &Basis, mut terms: Vec<(u32, f64)>, exponent: i64, rest: Radius) -> Option<Self> {
        terms.retain(|(_, coefficient)| *coefficient != 0.0);
        let sum: f64 = terms.iter().map(|(_, coefficient)| coefficient.abs()).sum();
        if !sum.is_finite() {
            return None;
        }
        if terms.is_empty() {
            return Some(Self::unknown(rest));
        }
        let shift = binary_exponent(sum).clamp(-1000, 1000);
        let factor = power_of_two(-shift);
        for (_, coefficient) in &mut terms {
            *coefficient *= factor;
        }
        let exponent = exponent + shift;
        let rounding = Radius::magnitude(1.0 + terms.len() as f64 * f64::EPSILON);
        let sum = Radius::magnitude(sum * factor).mul(rounding);
        Some(Self {
            basis: Some(basis.clone()),
            terms,
            exponent,
            linear: sum.mul(Radius::power_of_two(exponent)),
            rest: rest.add(Radius::power_of_two(exponent + UNDERFLOW)),
        })
    }

    /// A bound of the whole.
    fn total(&self) -> Radius {
        self.linear.add(self.rest)
    }

    /// The same about another midpoint without bits that are of no use.
    pub(super) fn around(mut self, mut mid: Dyadic) -> (Ball, Self) {
        let floor = self.total().top() - GUARD;
        if mid.floor_at(floor) {
            self.rest = self.rest.add(Radius::power_of_two(floor));
        }
        (Ball::around(mid, self.total()), self)
    }
}

/// The exponent of the largest power of two that is not above a positive
/// number; the smallest one of normal numbers for subnormal ones.
fn binary_exponent(number: f64) -> i64 {
    (number.to_bits() >> 52 & 0x7ff) as i64 - 1023
}
