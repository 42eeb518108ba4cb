//! What a normal form is made of.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;

/// Parts of a sum or product beyond which it is not opened.
const MOST_PARTS: usize = 64;

/// The exponent of a power beyond which a product is not opened.
const HIGHEST_POWER: i64 = 64;

/// Bits of a rational beyond which the normal form is given up.
pub(super) const LONGEST_RATIONAL: u64 = 1 << 13;

/// A rational times a term.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Multiple {
    pub(super) factor: BigRational,
    /// None for one.
    pub(super) term: Option<usize>,
}

/// A term to a power.
pub(super) type Power = (usize, i64);

/// What is not rational, as far as the form tells. Terms are named by their
/// places in the graph; a term comes after those that it is made of.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Term {
    Sum {
        constant: BigInt,
        parts: Vec<(usize, BigInt)>,
    },
    Product(Vec<Power>),
    Root {
        factor: BigInt,
        of: Option<usize>,
    },
}

/// Why a number has no form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NoForm {
    /// It is no number: a quotient by zero, or the root of a negative number.
    Undefined,
    /// A rational became too long.
    TooLong,
}

impl Multiple {
    pub(super) fn rational(factor: BigRational) -> Self {
        Self { factor, term: None }
    }

    pub(super) fn of(factor: BigRational, term: usize) -> Self {
        let term = (!factor.is_zero()).then_some(term);
        Self { factor, term }
    }

    pub(super) fn is_zero(&self) -> bool {
        self.factor.is_zero()
    }

    pub(super) fn negated(self) -> Self {
        Self {
            factor: -self.factor,
            ..self
        }
    }

    pub(super) fn checked(self) -> Result<Self, NoForm> {
        let length = self.factor.numer().bits() + self.factor.denom().bits();
        if length > LONGEST_RATIONAL {
            return Err(NoForm::TooLong);
        }
        Ok(self)
    }
}

impl Term {
    /// The terms that this one is made of.
    pub(super) fn operands(&self) -> Vec<usize> {
        match self {
            Self::Sum { parts, .. } => parts.iter().map(|part| part.0).collect(),
            Self::Product(factors) => factors.iter().map(|factor| factor.0).collect(),
            Self::Root { of, .. } => of.iter().copied().collect(),
        }
    }

    /// A sum that can be a part of another without being one itself.
    pub(super) fn as_short_sum(&self) -> Option<(&BigInt, &[(usize, BigInt)])> {
        match self {
            Self::Sum { constant, parts } if parts.len() <= MOST_PARTS => Some((constant, parts)),
            _ => None,
        }
    }

    pub(super) fn as_short_product(&self) -> Option<&[Power]> {
        match self {
            Self::Product(factors)
                if factors.len() <= MOST_PARTS
                    && factors.iter().all(|factor| factor.1.abs() <= HIGHEST_POWER) =>
            {
                Some(factors)
            }
            _ => None,
        }
    }
}
