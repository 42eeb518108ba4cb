//! The first descent of any function that can be enclosed, together with its
//! derivatives.
//!
//! The time up to a place beyond all zeros is cut into parts, looked at from the
//! first one on. In a part over which the function has one sign there is nothing.
//! One over which its derivative has one sign has a zero where the signs at both
//! ends differ, and it is simple. All others are cut in halves. What stays open
//! to the last bit may be a double zero, or none.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::chain::{doubt, sign_over};
use super::enclosure::{Enclosure, Place};
use super::function::Function;
use super::span::Span;
use crate::scalar::Undecided;

/// What becomes of parts that stay open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Open {
    /// The search ends in doubt.
    Doubt,
    /// The sign that is computed at the end counts, as in binary64.
    Guess,
}

/// The bits of a place to which parts are not cut.
const SPARE_BITS: u32 = 3;

/// So many parts are as good as open.
const MOST_PARTS: usize = 1 << 14;

/// The first zero, before `end`, to which a function descends: a simple one. So
/// many derivatives, the function being the first, are known to be zero at 0, and
/// the next one to be positive.
pub(super) fn first_descent<E: Enclosure, F: Function<E>>(
    f: F,
    zeros: usize,
    end: E::Place,
    open: Open,
) -> Result<Option<Span<E::Place>>, Undecided> {
    let bits = f.bits().saturating_sub(SPARE_BITS);
    let search = Search::new(f, zeros, open);
    let mut parts = vec![Part::from_zero(end)];
    let mut before = match zeros {
        0 => search.sign_at(&E::Place::zero())?,
        _ => Greater,
    };
    for _ in 0..MOST_PARTS {
        let Some(part) = parts.pop() else {
            return Ok(None);
        };
        let after = match search.sign_after(&part)? {
            Some(sign) => sign,
            None if part.is_done(bits) => search.sign_at(&part.high)?,
            None => {
                parts.extend(part.halves());
                continue;
            }
        };
        if before == Greater && after == Less {
            return Ok(Some(Span::falling(part.low, part.high)));
        }
        if after.is_ne() {
            before = after;
        }
    }
    match open {
        Open::Doubt => Err(doubt(search.derivatives[0].bits())),
        Open::Guess => Ok(None),
    }
}

/// What a search goes by.
struct Search<F> {
    /// The function, its derivatives that are known to be zero at 0, and two more.
    derivatives: Vec<F>,
    open: Open,
}

impl<F> Search<F> {
    fn new<E: Enclosure>(f: F, zeros: usize, open: Open) -> Self
    where
        F: Function<E>,
    {
        let mut derivatives = vec![f];
        for order in 0..=zeros {
            derivatives.push(derivatives[order].derivative());
        }
        Self { derivatives, open }
    }

    /// The sign at the end of a part, if it is certain that there is at most one
    /// zero in it.
    fn sign_after<E: Enclosure>(&self, part: &Part<E::Place>) -> Result<Option<Ordering>, Undecided>
    where
        F: Function<E>,
    {
        let zeros = self.derivatives.len() - 2;
        let order = if part.is_first() { zeros } else { 0 };
        let span = Span::open(part.low.clone(), part.high.clone());
        let [head, next] = [order, order + 1].map(|order| &self.derivatives[order]);
        if let Some(sign) = sign_over(head, next, &span) {
            return Ok(Some(sign));
        }
        let slope = self.derivatives[1].at(&E::between(&part.low, &part.high));
        let is_monotone = slope.sign().is_ok_and(Ordering::is_ne);
        is_monotone.then(|| self.sign_at(&part.high)).transpose()
    }

    /// The sign at a place: that of what is computed, if need be.
    fn sign_at<E: Enclosure>(&self, place: &E::Place) -> Result<Ordering, Undecided>
    where
        F: Function<E>,
    {
        let value = self.derivatives[0].at(&E::at(place));
        match self.open {
            Open::Doubt => value.sign(),
            Open::Guess => Ok(value.to_f64().partial_cmp(&0.0).unwrap_or(Equal)),
        }
    }
}

/// A part of the time, and how often it has been cut.
struct Part<P> {
    low: P,
    high: P,
    cuts: u32,
}

impl<P: Place> Part<P> {
    fn from_zero(end: P) -> Self {
        Self {
            low: P::zero(),
            high: end,
            cuts: 0,
        }
    }

    fn is_first(&self) -> bool {
        self.low.order(&P::zero()).is_eq()
    }

    /// Whether there is nothing more to gain. A first part is never narrow.
    fn is_done(&self, bits: u32) -> bool {
        let cuts = 4 * bits.max(f64::MANTISSA_DIGITS);
        self.cuts > cuts || P::is_narrow([&self.low, &self.high], bits)
    }

    /// The halves, the first one last.
    fn halves(self) -> [Self; 2] {
        let middle = P::middle(&self.low, &self.high);
        let cuts = self.cuts + 1;
        let [low, high] = [[self.low, middle.clone()], [middle, self.high]]
            .map(|[low, high]| Self { low, high, cuts });
        [high, low]
    }
}
