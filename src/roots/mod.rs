//! When a gap comes down to zero: a polynomial of degree 4 or less, mostly.
//!
//! Under uniform gravity the gap between a disc and the line of a wall is a
//! quadratic in time; that between a disc and a point, or a body of infinite
//! mass, which does not fall, is a quartic: `|d + v t + g t²/2|² - R²`. They meet
//! at its first [`Descent`].
//!
//! All arithmetics go the same way, by the chain of derivatives: between two
//! neighbouring zeros of its derivative a polynomial is monotone, so that the
//! signs at both ends tell whether it has a zero there, which is then enclosed.
//! What differs is how much is proven:
//!
//! | type | zeros are | even zeros, zeros too close |
//! |---|---|---|
//! | [`f64`] | approximated, to about the last bit | as the computed signs have it |
//! | [`Interval`](crate::scalar::Interval) | enclosed | left open |
//! | [`Exact`](crate::scalar::Exact), all coefficients rational | rational, or enclosed | decided, always |
//! | [`Exact`](crate::scalar::Exact) otherwise | enclosed | left open |
//!
//! Through air it is a function of exponentials, [`Fading`]. Between a disc and a line
//! that is monotone but for one turn; else the zeros are enclosed by cutting the time
//! into parts.
//!
//! The module `algebraic` keeps such a zero as a number of which everything is
//! decidable.

mod air;
pub(crate) mod algebraic;
mod binary64;
mod chain;
mod enclosure;
mod fading;
mod function;
mod line;
mod proven;
mod search;
mod span;
#[cfg(test)]
mod tests;
mod whole;

use std::cmp::Ordering::{self, Greater};

use crate::scalar::Scalar;
pub use fading::{Fades, Fading};

/// `a₀ + a₁ t + … + a₄ t⁴`, by ascending powers.
#[derive(Clone, Debug)]
pub struct Polynomial<S>(pub [S; 5]);

/// A polynomial, positive before, comes to zero.
#[derive(Clone, Debug)]
pub struct Descent<S> {
    /// When.
    pub time: S,
    /// Whether it only touches zero and is positive again: a zero of even
    /// multiplicity.
    pub graze: bool,
}

impl<S> Descent<S> {
    /// To a simple zero.
    fn crossing(time: S) -> Self {
        Self { time, graze: false }
    }

    /// The same, told in other numbers.
    pub(crate) fn map<T>(self, change: impl FnOnce(S) -> T) -> Descent<T> {
        Descent {
            time: change(self.time),
            graze: self.graze,
        }
    }
}

/// A number type that finds zeros of polynomials with such coefficients.
pub trait Roots: Scalar {
    /// The first t > 0 at which f is zero and has been positive just before.
    ///
    /// Where f is negative at first it has to rise before. A zero at 0 does not
    /// count, and what it leaves to know is the next coefficient's sign: whoever
    /// knows of it by structure gives 0 as the first coefficient.
    ///
    /// # Errors
    ///
    /// The coefficients leave open whether there is such a time, or which.
    fn descent(f: &Polynomial<Self>) -> Result<Option<Descent<Self>>, Self::Doubt>;
}

/// A zero, with the signs on both sides of it.
#[derive(Clone, Copy, Debug)]
struct Zero<T> {
    place: T,
    before: Ordering,
    after: Ordering,
}

/// The first of all zeros, in order, to which a polynomial descends.
fn first_descent<T>(zeros: impl IntoIterator<Item = Zero<T>>) -> Option<Descent<T>> {
    let first = zeros.into_iter().find(|zero| zero.before == Greater)?;
    Some(Descent {
        time: first.place,
        graze: first.after == Greater,
    })
}

impl<T> Polynomial<T> {
    /// The polynomial with its coefficients in another form.
    pub(crate) fn map<U>(&self, change: impl FnMut(&T) -> U) -> Polynomial<U> {
        Polynomial(self.0.each_ref().map(change))
    }
}

impl<S: Scalar> Polynomial<S> {
    /// The value at some t.
    pub fn at(&self, t: &S) -> S {
        let [a, b, c, d, e] = &self.0;
        if e.is_surely_zero() && d.is_surely_zero() {
            return (c.clone() * t + b) * t + a;
        }
        (((e.clone() * t + d) * t + c) * t + b) * t + a
    }

    /// The derivative.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let times = |power: usize| self.0[power].clone() * S::from_integer(power as i32);
        Self([times(1), times(2), times(3), times(4), S::from_integer(0)])
    }

    /// The least and the greatest power whose coefficients are not known to be
    /// zero.
    fn powers(&self) -> Option<(usize, usize)> {
        let counts = |coefficient: &S| !coefficient.is_surely_zero();
        let lowest = self.0.iter().position(counts)?;
        Some((lowest, self.0.iter().rposition(counts)?))
    }

    /// The polynomial divided by t as often as it is surely divisible.
    fn without_zero(&self) -> Self {
        let lowest = self.powers().map_or(0, |(lowest, _)| lowest);
        let mut coefficients = self.0.clone();
        coefficients.rotate_left(lowest);
        Self(coefficients)
    }
}
