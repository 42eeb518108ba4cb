//! Elements of a tower: polynomials in its radicals, over one denominator.
//!
//! The numerator's coefficients stand in a list of 2^j numbers. The i-th
//! belongs to the product of those radicals whose bits are set in i, so that
//! the two halves are a and b in a + b√d, where √d is the last radical.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// Coefficients, as many as a power of two.
pub(super) type Coefficients = Vec<BigInt>;

/// A number of a tower, in lowest terms: without empty upper halves, without a
/// common divisor, with a positive denominator.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Element {
    pub(super) numerator: Coefficients,
    pub(super) denominator: BigInt,
}

impl Element {
    /// Brings a quotient by a number that is not zero to lowest terms.
    pub(super) fn new(mut numerator: Coefficients, mut denominator: BigInt) -> Self {
        while numerator.len() > 1 && is_zero(&numerator[numerator.len() / 2..]) {
            numerator.truncate(numerator.len() / 2);
        }
        let mut divisor = content(&numerator, denominator.clone());
        if denominator.is_negative() {
            divisor = -divisor;
        }
        if !divisor.is_one() {
            numerator.iter_mut().for_each(|n| *n /= &divisor);
            denominator /= divisor;
        }
        Self {
            numerator,
            denominator,
        }
    }

    pub(super) fn rational(value: &BigRational) -> Self {
        Self {
            numerator: vec![value.numer().clone()],
            denominator: value.denom().clone(),
        }
    }

    pub(super) fn whole(value: BigInt) -> Self {
        Self {
            numerator: vec![value],
            denominator: BigInt::one(),
        }
    }

    /// How many radicals of the tower it takes to make the number.
    pub(super) fn level(&self) -> usize {
        self.numerator.len().trailing_zeros() as usize
    }

    /// Exactly when all coefficients are: the products of radicals are a
    /// basis.
    pub(super) fn is_zero(&self) -> bool {
        is_zero(&self.numerator)
    }

    pub(super) fn to_rational(&self) -> Option<BigRational> {
        match &self.numerator[..] {
            // In lowest terms already.
            [numerator] => Some(BigRational::new_raw(
                numerator.clone(),
                self.denominator.clone(),
            )),
            _ => None,
        }
    }

    /// The bits of all coefficients.
    pub(super) fn bits(&self) -> u64 {
        let numerator: u64 = self.numerator.iter().map(BigInt::bits).sum();
        numerator + self.denominator.bits()
    }

    /// a and b of a + b√d, where √d is the radical after the first `level`.
    pub(super) fn split(&self, level: usize) -> (Self, Self) {
        let half = 1 << level;
        if self.numerator.len() <= half {
            return (self.clone(), Self::whole(BigInt::zero()));
        }
        let part = |numerator: &[BigInt]| Self::new(numerator.to_vec(), self.denominator.clone());
        let (a, b) = self.numerator.split_at(half);
        (part(a), part(b))
    }

    /// This number times the radical after the first `level`, of which it is
    /// made.
    pub(super) fn times_radical(&self, level: usize) -> Self {
        let mut numerator = vec![BigInt::zero(); 2 << level];
        numerator[1 << level..][..self.numerator.len()].clone_from_slice(&self.numerator);
        Self::new(numerator, self.denominator.clone())
    }

    pub(super) fn negated(&self) -> Self {
        Self {
            numerator: self.numerator.iter().map(|n| -n).collect(),
            denominator: self.denominator.clone(),
        }
    }

    pub(super) fn add(&self, other: &Self) -> Self {
        let common = self.denominator.lcm(&other.denominator);
        let mut total = scaled(&self.numerator, &(&common / &self.denominator));
        add_to(
            &mut total,
            &scaled(&other.numerator, &(&common / &other.denominator)),
        );
        Self::new(total, common)
    }

    pub(super) fn sub(&self, other: &Self) -> Self {
        self.add(&other.negated())
    }

    /// This number times a rational that is not zero.
    pub(super) fn scaled(&self, factor: &BigRational) -> Self {
        Self::new(
            scaled(&self.numerator, factor.numer()),
            &self.denominator * factor.denom(),
        )
    }
}

pub(super) fn is_zero(coefficients: &[BigInt]) -> bool {
    coefficients.iter().all(Zero::is_zero)
}

/// The greatest common divisor of coefficients and another number. Most
/// coefficients only confirm the divisor found so far, which a division shows
/// faster than the algorithm for any two numbers.
pub(super) fn content(coefficients: &[BigInt], other: BigInt) -> BigInt {
    let mut divisor = other.abs();
    for coefficient in coefficients {
        if divisor.is_one() {
            break;
        }
        divisor = if divisor.is_zero() {
            coefficient.abs()
        } else {
            divisor.gcd(&(coefficient % &divisor))
        };
    }
    divisor
}

fn scaled(coefficients: &[BigInt], factor: &BigInt) -> Coefficients {
    coefficients.iter().map(|n| n * factor).collect()
}

/// Adds to a list that grows where the other one is longer.
pub(super) fn add_to(sum: &mut Coefficients, other: &[BigInt]) {
    lengthen(sum, other.len());
    sum.iter_mut().zip(other).for_each(|(n, term)| *n += term);
}

/// Subtracts from a list that grows where the other one is longer.
pub(super) fn subtract_from(difference: &mut Coefficients, other: &[BigInt]) {
    lengthen(difference, other.len());
    difference
        .iter_mut()
        .zip(other)
        .for_each(|(n, term)| *n -= term);
}

pub(super) fn sum(a: &[BigInt], b: &[BigInt]) -> Coefficients {
    let mut sum = a.to_vec();
    add_to(&mut sum, b);
    sum
}

fn lengthen(coefficients: &mut Coefficients, length: usize) {
    if coefficients.len() < length {
        coefficients.resize(length, BigInt::zero());
    }
}
