//! Proven zeros: of enclosed coefficients, and of rational ones.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::One;

use super::algebraic::Algebraic;
use super::chain::{first_crossing, sharpen};
use super::enclosure::Enclosure;
use super::{Descent, Polynomial, Roots};
use crate::scalar::{Dyadic, Exact, Interval, Scalar, Undecided};

impl Roots for Interval {
    fn descent(f: &Polynomial<Self>, _: usize) -> Result<Option<Descent<Self>>, Undecided> {
        enclosed(f)
    }
}

impl Roots for Exact {
    fn descent(f: &Polynomial<Self>, grazes: usize) -> Result<Option<Descent<Self>>, Undecided> {
        let bits = f.0.iter().map(Self::precision).max().unwrap_or_default();
        let descent = match whole(f) {
            Some(whole) => Algebraic::first_descent(&whole, grazes).map(|descent| Descent {
                time: descent.time.to_exact(bits),
                graze: descent.graze,
            }),
            None => enclosed(f)?,
        };
        Ok(descent.map(|Descent { time, graze }| Descent {
            time: time.with_bits(bits),
            graze,
        }))
    }
}

/// The first descent if it is to a simple zero; even ones, which there may be to
/// skip, are left open.
fn enclosed<E: Enclosure>(f: &Polynomial<E>) -> Result<Option<Descent<E>>, Undecided> {
    let crossing = first_crossing(f)?;
    Ok(crossing.map(|mut span| {
        sharpen(&mut span, f);
        Descent {
            time: E::between(&span.low, &span.high),
            graze: false,
        }
    }))
}

/// The same polynomial times a whole number such that its coefficients become
/// whole, if they are known.
fn whole(f: &Polynomial<Exact>) -> Option<Polynomial<Dyadic>> {
    let known = f.0.iter().all(Exact::is_rational);
    let ratios: Option<Vec<BigRational>> = known
        .then(|| f.0.iter().map(|a| Some(a.enclosure()?.0)).collect())
        .flatten();
    let ratios = ratios?;
    let divisor = ratios
        .iter()
        .fold(BigInt::one(), |divisor, ratio| divisor.lcm(ratio.denom()));
    Some(Polynomial(std::array::from_fn(|power| {
        let ratio = &ratios[power];
        Dyadic::new(ratio.numer() * (&divisor / ratio.denom()), 0).normalised()
    })))
}
