//! Proven zeros: of enclosed coefficients, and of rational ones.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::One;

use super::algebraic::Algebraic;
use super::chain::{first_crossing, sharpen};
use super::enclosure::Enclosure;
use super::span::Span;
use super::{Descent, Polynomial, Roots};
use crate::scalar::{Dyadic, Exact, Interval, Scalar, Undecided};

impl Roots for Interval {
    fn descent(f: &Polynomial<Self>) -> Result<Option<Descent<Self>>, Undecided> {
        Ok(first_crossing(f)?.map(|span| enclosed(span, f)))
    }
}

impl Roots for Exact {
    fn descent(f: &Polynomial<Self>) -> Result<Option<Descent<Self>>, Undecided> {
        let bits = f.0.iter().map(Self::precision).max().unwrap_or_default();
        let descent = match whole(f) {
            Some(whole) => Algebraic::first_descent(&whole).map(|descent| Descent {
                time: descent.time.into_exact(bits),
                graze: descent.graze,
            }),
            None => crossing(f)?.map(|span| enclosed(span, f)),
        };
        Ok(descent.map(|Descent { time, graze }| Descent {
            time: time.with_bits(bits),
            graze,
        }))
    }
}

/// The first descent to a simple zero, in binary64 where that suffices.
fn crossing(f: &Polynomial<Exact>) -> Result<Option<Span<Dyadic>>, Undecided> {
    match first_crossing(&f.map(Exact::hull)) {
        Ok(crossing) => Ok(crossing.map(|span| span.map(|place| Dyadic::from_f64(*place)))),
        Err(_) => first_crossing(f),
    }
}

/// A descent to a simple zero. (Even ones, which there may be to skip, have been
/// left open.)
fn enclosed<E: Enclosure>(mut span: Span<E::Place>, f: &Polynomial<E>) -> Descent<E> {
    sharpen(&mut span, f);
    Descent::crossing(E::between(&span.low, &span.high))
}

/// The same polynomial times a whole number such that its coefficients become
/// whole, if they are known.
fn whole(f: &Polynomial<Exact>) -> Option<Polynomial<Dyadic>> {
    let known = |a: &Exact| Some(a.enclosure().filter(|_| a.is_rational())?.0);
    let ratios: Vec<BigRational> = f.0.iter().map(known).collect::<Option<_>>()?;
    let divisor = ratios
        .iter()
        .fold(BigInt::one(), |divisor, ratio| divisor.lcm(ratio.denom()));
    Some(Polynomial(std::array::from_fn(|power| {
        let ratio = &ratios[power];
        Dyadic::new(ratio.numer() * (&divisor / ratio.denom()), 0).normalised()
    })))
}
