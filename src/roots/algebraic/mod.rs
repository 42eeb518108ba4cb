//! Real algebraic numbers of degree 4 or less, of which everything is decidable.
//!
//! A number is a simple zero of a polynomial with dyadic coefficients, the only
//! one in a span, plus an offset. Enclosures decide most questions; what they
//! leave open may be an equality, which a common divisor of two polynomials
//! proves or rules out (Cohen, A Course in Computational Algebraic Number Theory,
//! 4.2; Yap, Fundamental Problems of Algorithmic Algebra, 6). Where it is ruled
//! out, narrower enclosures are certain to decide.

mod order;
mod round;
#[cfg(test)]
mod tests;

use std::cmp::Ordering::{self, Equal, Greater, Less};

use num_bigint::BigInt;
use num_rational::BigRational;

use super::chain::{FIRST_BITS, first_crossing, sharpen, spans};
use super::enclosure::{Enclosure, Place};
use super::span::{Kind, Span};
use super::whole::Whole;
use super::{Descent, Polynomial, Zero, first_descent};
use crate::scalar::{Dyadic, Exact, Interval, Rounding, Scalar};

/// A zero of a polynomial, plus an offset.
#[derive(Clone, Debug)]
pub(crate) struct Algebraic {
    f: Polynomial<Dyadic>,
    /// Where f has one zero, which is simple and above 0.
    span: Span<Dyadic>,
    offset: Dyadic,
    /// How many the zero has been enclosed with.
    bits: u32,
}

impl Algebraic {
    /// The first descent of a polynomial, as in [`Roots`](super::Roots).
    pub(crate) fn first_descent(f: &Polynomial<Dyadic>) -> Option<Descent<Self>> {
        if let Ok(crossing) = first_crossing(&f.map(hull)) {
            return crossing.map(|span| Descent {
                time: Self::new(f.clone(), span.map(|place| Dyadic::from_f64(*place))),
                graze: false,
            });
        }
        let simple = Whole::of(f).square_free().to_dyadic();
        let Descent { time, graze } = first_descent(signed(f, isolated(&simple)))?;
        let time = Self::new(simple, time);
        Some(Descent { time, graze })
    }

    /// All descents, in order.
    pub(crate) fn descents(f: &Polynomial<Dyadic>) -> Vec<Descent<Self>> {
        if f.0.iter().all(Dyadic::is_zero) {
            return Vec::new();
        }
        let simple = Whole::of(f).square_free().to_dyadic();
        let zeros = signed(f, isolated(&simple)).into_iter();
        let descents = zeros.filter(|zero| zero.before == Greater);
        descents
            .map(|zero| Descent {
                time: Self::new(simple.clone(), zero.place),
                graze: zero.after == Greater,
            })
            .collect()
    }

    /// The descent within bounds in which a polynomial plainly falls from above
    /// zero to below.
    pub(crate) fn within(f: &Polynomial<Dyadic>, bounds: Interval) -> Option<Self> {
        if !bounds.hi().is_finite() || f.map(hull).derivative().at(&bounds).sign() != Ok(Less) {
            return None;
        }
        let [low, high] = [bounds.lo(), bounds.hi()].map(Dyadic::from_f64);
        let [before, after] = [&low, &high].map(|end| f.exactly_at(end).sign());
        let span = Span {
            low,
            high,
            before,
            after,
            kind: Kind::Simple,
        };
        ((before, after) == (Greater, Less)).then(|| Self::new(f.clone(), span))
    }

    /// The same number, enclosed to more bits than binary64 has.
    pub(crate) fn sharpened(mut self) -> Self {
        self.sharpen(FIRST_BITS);
        self
    }

    fn new(f: Polynomial<Dyadic>, span: Span<Dyadic>) -> Self {
        Self {
            f,
            span,
            offset: Dyadic::zero(),
            bits: 0,
        }
    }

    fn ends(&self) -> [Dyadic; 2] {
        [&self.span.low, &self.span.high].map(|end| end.clone().add(&self.offset))
    }

    /// Encloses the zero to about so many bits.
    fn sharpen(&mut self, bits: u32) {
        if self.bits < bits {
            self.bits = bits;
            sharpen(&mut self.span, &enclosed(&self.f, bits));
        }
    }

    /// The number itself if it is rational, or else an enclosure.
    pub(super) fn into_exact(mut self, bits: u32) -> Exact {
        if let Some(ratio) = self.rational() {
            return Exact::from_rational(ratio + self.offset.to_rational(), bits);
        }
        self.sharpen(bits);
        let [low, high] = self.ends();
        Exact::between(&low, &high)
    }

    /// The zero, if it is rational: a whole number divided by the leading
    /// coefficient of the polynomial as one with whole coefficients (Gauss).
    fn rational(&mut self) -> Option<BigRational> {
        let whole = Whole::of(&self.f);
        let leading = BigInt::from(whole.leading().magnitude().clone());
        if leading.bits() > Exact::RATIONAL_BITS {
            return None;
        }
        let ratio = BigRational::new(self.nearest_multiple(&leading), leading);
        let is_zero = self.may_be(&ratio) && whole.is_zero_at(&ratio);
        is_zero.then_some(ratio)
    }

    /// The only whole number that the zero times a positive one may be.
    fn nearest_multiple(&mut self, factor: &BigInt) -> BigInt {
        let (factor, one) = (Dyadic::new(factor.clone(), 0), Dyadic::from(1));
        let mut bits = FIRST_BITS;
        loop {
            self.sharpen(bits);
            let [low, high] = [&self.span.low, &self.span.high].map(|end| end.mul(&factor));
            if high.clone().sub(&low).compare(&one).is_lt() {
                return floor(high);
            }
            bits *= 2;
        }
    }

    /// Whether a number is within the span.
    fn may_be(&self, ratio: &BigRational) -> bool {
        self.span.low.to_rational() <= *ratio && *ratio <= self.span.high.to_rational()
    }
}

/// The largest whole number that is not above a number.
fn floor(mut number: Dyadic) -> BigInt {
    number.floor_at(0);
    number.mantissa() << number.exponent().max(0)
}

/// The nearest binary64 bounds of a number.
fn hull(number: &Dyadic) -> Interval {
    Interval::new(number.to_f64(Rounding::Down), number.to_f64(Rounding::Up))
}

/// A polynomial whose zeros are enclosed with so many bits.
fn enclosed(f: &Polynomial<Dyadic>, bits: u32) -> Polynomial<Exact> {
    f.map(|a| Exact::from_dyadic(a.clone(), bits))
}

/// All zeros above 0 of a polynomial that has simple ones alone.
fn isolated(f: &Polynomial<Dyadic>) -> Vec<Span<Dyadic>> {
    let mut bits = FIRST_BITS;
    loop {
        let spans = spans(&enclosed(f, bits)).unwrap_or_else(|_| vec![unknown()]);
        if spans.iter().all(|span| span.kind == Kind::Simple) {
            return spans;
        }
        bits *= 2;
    }
}

/// All numbers.
fn unknown() -> Span<Dyadic> {
    Span::open(Dyadic::zero(), Dyadic::zero())
}

/// The zeros of f, with its signs around them.
fn signed(f: &Polynomial<Dyadic>, spans: Vec<Span<Dyadic>>) -> Vec<Zero<Span<Dyadic>>> {
    let first = f.0.iter().map(Dyadic::sign).find(|sign| *sign != Equal);
    let last = f.0.iter().map(Dyadic::sign).rfind(|sign| *sign != Equal);
    let gaps = spans
        .windows(2)
        .map(|pair| Place::middle(&pair[0].high, &pair[1].low));
    let inner: Vec<Ordering> = gaps
        .map(|place: Dyadic| f.exactly_at(&place).sign())
        .collect();
    let before = first.into_iter().chain(inner.clone());
    let after = inner.iter().copied().chain(last);
    let signs = before.zip(after);
    let zero = |(place, (before, after))| Zero {
        place,
        before,
        after,
    };
    spans.into_iter().zip(signs).map(zero).collect()
}

impl Polynomial<Dyadic> {
    /// The value at some t.
    pub(crate) fn exactly_at(&self, t: &Dyadic) -> Dyadic {
        let step = |value: Dyadic, a: &Dyadic| value.mul(t).add(a);
        self.0.iter().rev().fold(Dyadic::zero(), step)
    }
}
