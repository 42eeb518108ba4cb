//! Enclosures of a normal form to any number of bits, in one sweep over its
//! terms.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;

use super::graph::Graph;
use super::term::{Multiple, Term};
use crate::scalar::{Exact, Scalar};

/// Encloses a number with so many bits in every operation, given the terms
/// that it is made of.
pub(super) fn number(graph: &Graph, needed: &[usize], number: &Multiple, bits: u32) -> Exact {
    let one = whole(&BigInt::from(1), bits);
    let mut values = vec![one.clone(); graph.terms().len()];
    for &place in needed {
        values[place] = term(&graph.terms()[place], |operand| &values[operand], bits);
    }
    let factor = Exact::from_rational(number.factor.clone(), bits);
    factor * number.term.map_or(&one, |term| &values[term])
}

/// Encloses a term, given the enclosures of those that it is made of.
pub(super) fn term<'a>(term: &Term, value: impl Fn(usize) -> &'a Exact, bits: u32) -> Exact {
    match term {
        Term::Sum { constant, parts } => parts
            .iter()
            .map(|(part, coefficient)| whole(coefficient, bits) * value(*part))
            .fold(whole(constant, bits), |sum, part| sum + part),
        Term::Product(factors) => factors
            .iter()
            .map(|(factor, exponent)| power(value(*factor), *exponent, bits))
            .fold(whole(&BigInt::from(1), bits), |product, factor| {
                product * factor
            }),
        Term::Root { factor, of } => {
            let factor = whole(factor, bits);
            root(of.map_or(factor.clone(), |of| factor * value(of)))
        }
    }
}

/// Nothing is known about the root of a negative number.
fn root(radicand: Exact) -> Exact {
    match radicand.sign() {
        Ok(Ordering::Less) => Exact::from_integer(1) / Exact::from_integer(0),
        _ => radicand.sqrt(),
    }
}

/// A whole number.
pub(super) fn whole(number: &BigInt, bits: u32) -> Exact {
    Exact::from_rational(BigRational::from_integer(number.clone()), bits)
}

/// Squares of enclosures know not to be negative, so powers are made of them.
fn power(base: &Exact, exponent: i64, bits: u32) -> Exact {
    let mut result = whole(&BigInt::from(1), bits);
    let mut square = base.clone();
    let mut rest = exponent.unsigned_abs();
    while rest > 0 {
        if rest % 2 == 1 {
            result = result * &square;
        }
        rest /= 2;
        if rest > 0 {
            square = square.square();
        }
    }
    if exponent < 0 {
        whole(&BigInt::from(1), bits) / result
    } else {
        result
    }
}

/// Some n such that the magnitude is less than 2^-n, where one is known.
pub(super) fn bits_of_zero(value: &Exact) -> Option<i64> {
    let (lo, hi) = value.enclosure()?;
    let top = |end: &BigRational| {
        if end.is_zero() {
            i64::MIN / 2
        } else {
            end.numer().bits() as i64 - end.denom().bits() as i64 + 1
        }
    };
    Some(-top(&lo).max(top(&hi)))
}
