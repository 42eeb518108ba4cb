//! Zeros of what falls through air, in each arithmetic: in binary64 bounds where
//! these suffice.

use std::convert::Infallible;

use super::Descent;
use super::chain::{doubt, sharpen};
use super::fading::{Fade, Fades, Fading};
use super::search::{Open, first_descent};
use super::span::Span;
use crate::scalar::{Decay, Dyadic, Exact, Interval, Scalar, Undecided, lag};

/// Of a line by numbers alone; else by bounds of the numbers as they are. What these
/// leave open counts as what is computed.
impl Fades for f64 {
    fn decay_and_lag(&self) -> [Self; 2] {
        [self.decay(), lag(*self)]
    }

    fn descent(f: &Fading<Self>, zeros: usize) -> Result<Option<Descent<Self>>, Infallible> {
        if f.is_linear() {
            let met = f.fall(zeros)?.map(|stretch| f.landing(stretch));
            return Ok(met.map(Descent::crossing));
        }
        let f = f.map(|&number| Interval::point(number));
        let Ok(Some(span)) = first_descent(f.clone(), zeros, f.end, Open::Guess) else {
            return Ok(None);
        };
        Ok(Some(enclosed(span, &f).map(|time| time.middle())))
    }
}

/// Proven, or left open.
impl Fades for Exact {
    fn decay_and_lag(&self) -> [Self; 2] {
        self.decay_and_lag()
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
    if f.is_linear() {
        let Some(stretch) = f.fall(zeros)? else {
            return Ok(None);
        };
        return f.enclosed_landing(stretch).map(Some);
    }
    match first_descent(f.map(Exact::hull), zeros, f.end, Open::Doubt) {
        Ok(crossing) => Ok(crossing.map(|span| span.map(|place| Dyadic::from_f64(*place)))),
        Err(_) => first_descent(f.clone(), zeros, Dyadic::from_f64(f.end), Open::Doubt),
    }
}

/// A descent to a simple zero.
fn enclosed<E: Fade>(mut span: Span<E::Place>, f: &Fading<E>) -> Descent<E> {
    sharpen(&mut span, f);
    Descent::crossing(E::between(&span.low, &span.high))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fading<S: Scalar>(terms: [i32; 6], end: f64) -> Fading<S> {
        Fading {
            terms: terms.map(S::from_integer),
            rate: S::from_integer(1),
            end,
        }
    }

    fn time(terms: [i32; 6], zeros: usize) -> Option<f64> {
        let Ok(met) = f64::descent(&fading(terms, 8.0), zeros);
        met.map(|met| met.time)
    }

    /// 1 - r is zero where t + e^-t = 2. Thrown up, s - r = 2 s - t falls back to
    /// zero. From below, -3 + 9 s - 3 r = 3 (4 s - t - 1) first has to rise: it is
    /// zero where t + 4 e^-t = 3, at 0.45 and 2.74, and falls at the second.
    #[test]
    fn falls() {
        let falls = |t: f64, zero: f64| zero.abs() < 1e-14 * t;
        let fall = time([1, 0, -1, 0, 0, 0], 0).unwrap();
        assert!(falls(fall, fall + (-fall).exp() - 2.0));
        let throw = time([0, 1, -1, 0, 0, 0], 1).unwrap();
        assert!(throw > 1.0 && falls(throw, throw - 2.0 + 2.0 * (-throw).exp()));
        let back = time([-3, 9, -3, 0, 0, 0], 0).unwrap();
        assert!(back > 2.0 && falls(back, back + 4.0 * (-back).exp() - 3.0));
    }

    /// (2 s - 1)² touches zero at ln 2, which enclosures leave open. Binary64 may take
    /// it for a crossing, but only where the square is a rounding of its terms, some
    /// 2^-51: within 2^-25 of there, since 2 s - 1 grows by 2 e^-t, which is 1. (2 s - 1)² + 1
    /// stays above.
    #[test]
    fn what_does_not_cross() {
        let touching = [1, -4, 0, 4, 0, 0];
        assert!(Exact::descent(&fading(touching, 8.0), 0).is_err());
        let off = |time: f64| (time - std::f64::consts::LN_2).abs();
        assert!(time(touching, 0).is_none_or(|time| off(time) < 2_f64.powi(-25)));
        assert_eq!(time([2, -4, 0, 4, 0, 0], 0), None);
        let apart = fading::<Exact>([2, -4, 0, 4, 0, 0], 8.0);
        assert!(matches!(Exact::descent(&apart, 0), Ok(None)));
    }
}
