//! Functions of time of what falls through air.
//!
//! Under gravity g and linear drag k a disc has moved by v s + u r after a time t,
//! where v is its velocity at first, u = g/k that which it tends to, and
//!
//! ```text
//! s = (1 - e^(-k t)) / k,   s' = 1 - k s
//! r = t - s,                r' = k s
//! ```
//!
//! (r is about k t²/2 at first: where drag is weak, nothing cancels.) So the gap
//! between it and a line is a linear function of s and r, that between it and a
//! point a quadratic one; and so are their derivatives.

use super::Descent;
use super::enclosure::Enclosure;
use super::function::Function;
use crate::scalar::{Decay, Exact, Interval, Scalar};

/// A quadratic function of s and r: terms of 1, s, r, s², s r and r².
#[derive(Clone, Debug)]
pub struct Fading<S> {
    /// The coefficients.
    pub terms: [S; 6],
    /// The rate k of the drag.
    pub rate: S,
    /// A time beyond all zeros.
    pub end: f64,
}

/// A number type that finds zeros of such functions.
pub trait Fades: Decay {
    /// 1 - e^-x, and x - (1 - e^-x), for x ≥ 0.
    #[must_use]
    fn decay_and_lag(&self) -> [Self; 2];

    /// The first t > 0 at which f is zero and has been positive just before.
    ///
    /// So many derivatives, f itself being the first, are known to be zero at 0,
    /// and the next one to be positive. Where f is negative at first it has to
    /// rise before.
    ///
    /// # Errors
    ///
    /// The coefficients leave open whether there is such a time, or which.
    fn descent(f: &Fading<Self>, zeros: usize) -> Result<Option<Descent<Self>>, Self::Doubt>;
}

impl<S> Fading<S> {
    /// The function with its numbers in another form.
    pub(crate) fn map<T>(&self, change: impl Fn(&S) -> T) -> Fading<T> {
        Fading {
            terms: self.terms.each_ref().map(&change),
            rate: change(&self.rate),
            end: self.end,
        }
    }
}

impl<S: Scalar> Fading<S> {
    /// The value, given s and r.
    pub(super) fn of(&self, [fast, slow]: &[S; 2]) -> S {
        let [one, s, r, ss, sr, rr] = &self.terms;
        let of_fast = ss.clone() * fast + s;
        let of_slow = sr.clone() * fast + r + rr.clone() * slow;
        one.clone() + of_fast * fast + of_slow * slow
    }

    /// The derivative.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let [_, s, r, ss, sr, rr] = &self.terms;
        let rate = &self.rate;
        let twice = |number: &S| S::from_integer(2) * number;
        let terms = [
            s.clone(),
            rate.clone() * &(r.clone() - s) + twice(ss),
            sr.clone(),
            rate.clone() * &(sr.clone() - twice(ss)),
            rate.clone() * &(twice(rr) - sr),
            S::from_integer(0),
        ];
        Self {
            terms,
            ..self.clone()
        }
    }

    /// The same, where so many derivatives are known to be zero at the start, the
    /// function itself being the first. (The first two are terms of it.)
    #[must_use]
    pub fn with_zeros(mut self, zeros: usize) -> Self {
        for term in self.terms.iter_mut().take(zeros.min(2)) {
            *term = S::from_integer(0);
        }
        self
    }
}

/// Enclosures with the exponential function.
pub(super) trait Fade: Enclosure {
    /// 1 - e^-x, and x - (1 - e^-x).
    fn decay_and_lag(&self) -> [Self; 2];
}

impl Fade for Interval {
    fn decay_and_lag(&self) -> [Self; 2] {
        (*self).decay_and_lag()
    }
}

impl Fade for Exact {
    fn decay_and_lag(&self) -> [Self; 2] {
        self.decay_and_lag()
    }
}

impl<E: Fade> Function<E> for Fading<E> {
    fn at(&self, t: &E) -> E {
        let x = t.clone() * &self.rate;
        self.of(&x.decay_and_lag().map(|part| part / &self.rate))
    }

    fn derivative(&self) -> Self {
        self.derivative()
    }

    fn rough(&self, bits: u32) -> Self {
        self.map(|a| a.rough(bits))
    }

    fn bits(&self) -> u32 {
        let numbers = self.terms.iter().chain([&self.rate]);
        numbers.map(E::bits).max().unwrap_or_default()
    }
}
