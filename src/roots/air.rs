//! Zeros of what falls through air, in each arithmetic: in binary64 bounds where
//! these suffice.

use std::convert::Infallible;

use super::Descent;
use super::chain::{doubt, sharpen};
use super::fading::{Fade, Fades, Fading};
use super::search::{Open, first_descent};
use super::span::Span;
use crate::scalar::{Dyadic, Exact, Interval, Scalar, Undecided};

/// By bounds of the numbers as they are. What these leave open counts as what is
/// computed.
impl Fades for f64 {
    fn lag(&self) -> Self {
        Interval::point(*self).lag().middle()
    }

    fn descent(f: &Fading<Self>, zeros: usize) -> Result<Option<Descent<Self>>, Infallible> {
        let f = f.map(|&number| Interval::point(number));
        let Ok(Some(span)) = first_descent(f.clone(), zeros, f.end, Open::Guess) else {
            return Ok(None);
        };
        Ok(Some(enclosed(span, &f).map(|time| time.middle())))
    }
}

/// Proven, or left open.
impl Fades for Exact {
    fn lag(&self) -> Self {
        self.lag()
    }

    fn descent(f: &Fading<Self>, zeros: usize) -> Result<Option<Descent<Self>>, Undecided> {
        let bits = f
            .terms
            .iter()
            .map(Self::precision)
            .max()
            .unwrap_or_default();
        if !f.end.is_finite() {
            return Err(doubt(bits));
        }
        let descent = crossing(f, zeros)?.map(|span| enclosed(span, f));
        Ok(descent.map(|descent| descent.map(|time| time.with_bits(bits))))
    }
}

/// The first descent, in binary64 where that suffices.
fn crossing(f: &Fading<Exact>, zeros: usize) -> Result<Option<Span<Dyadic>>, Undecided> {
    match first_descent(f.map(Exact::hull), zeros, f.end, Open::Doubt) {
        Ok(crossing) => Ok(crossing.map(|span| span.map(|place| Dyadic::from_f64(*place)))),
        Err(_) => first_descent(f.clone(), zeros, Dyadic::from_f64(f.end), Open::Doubt),
    }
}

/// A descent to a simple zero.
fn enclosed<E: Fade>(mut span: Span<E::Place>, f: &Fading<E>) -> Descent<E> {
    sharpen(&mut span, f);
    Descent {
        time: E::between(&span.low, &span.high),
        graze: false,
    }
}
