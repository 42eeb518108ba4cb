//! How close to zero a number can be that is not zero.
//!
//! Every number E here is a quotient U / L of algebraic integers that are
//! made without divisions. With u and l at least the magnitudes of U and L and
//! of all their conjugates, and k different square roots in E, E is either
//! zero or at least 1 / (l u^(D-1)) with D = 2^k: the norm of U is a nonzero
//! whole number, hence at least 1, and a product of at most D conjugates.
//!
//! | E | u | l |
//! |---|---|---|
//! | a / b | \|a\| | \|b\| |
//! | E1 ± E2 | u1 l2 + l1 u2 | l1 l2 |
//! | E1 E2 | u1 u2 | l1 l2 |
//! | E1 / E2 | u1 l2 | l1 u2 |
//! | √E1, u1 ≥ l1 | √(u1 l1) | l1 |
//! | √E1, u1 < l1 | u1 | √(u1 l1) |
//!
//! Burnikel, Funke, Mehlhorn, Schirra, Schmitt: A separation bound for real
//! algebraic expressions, ESA 2001 and Algorithmica 2009. Larger u and l than
//! these only weaken the bound, so it is computed with numbers of 32 bits that
//! round upwards.

use num_bigint::BigInt;
use num_traits::One;

use super::graph::Graph;
use super::term::{Multiple, Term};
use crate::scalar::{Dyadic, Radius};

/// Bounds of the numerator and the denominator, and of their conjugates.
#[derive(Clone, Copy, Debug)]
struct Sizes {
    u: Radius,
    l: Radius,
}

impl Sizes {
    fn fraction(numerator: &BigInt, denominator: &BigInt) -> Self {
        let size = |part: &BigInt| Radius::above(&Dyadic::new(part.clone(), 0));
        Self {
            u: size(numerator),
            l: size(denominator),
        }
    }

    fn whole(number: &BigInt) -> Self {
        Self::fraction(number, &BigInt::one())
    }

    fn add(self, other: Self) -> Self {
        Self {
            u: self.u.mul(other.l).add(self.l.mul(other.u)),
            l: self.l.mul(other.l),
        }
    }

    fn mul(self, other: Self) -> Self {
        Self {
            u: self.u.mul(other.u),
            l: self.l.mul(other.l),
        }
    }

    fn inverse(self) -> Self {
        Self {
            u: self.l,
            l: self.u,
        }
    }

    fn power(self, exponent: i64) -> Self {
        let base = if exponent < 0 { self.inverse() } else { self };
        let mut result = Self::whole(&BigInt::one());
        let mut square = base;
        let mut rest = exponent.unsigned_abs();
        while rest > 0 {
            if rest % 2 == 1 {
                result = result.mul(square);
            }
            square = square.mul(square);
            rest /= 2;
        }
        result
    }

    fn root(self) -> Self {
        let middle = self.u.mul(self.l).sqrt();
        if self.u >= self.l {
            Self { u: middle, ..self }
        } else {
            Self { l: middle, ..self }
        }
    }

    /// Some n such that 1 / (l u^(D-1)) is at least 2^-n.
    fn bits(self, radicals: u32) -> Option<u64> {
        let others = 1_u64.checked_shl(radicals)? - 1;
        let numerator = sixteenths(self.u)?.checked_mul(others)?;
        Some(numerator.checked_add(sixteenths(self.l)?)?.div_ceil(16))
    }
}

/// The binary logarithm in sixteenths, rounded up, and not below zero; of
/// what is too large to take powers of, more roughly.
fn sixteenths(bound: Radius) -> Option<u64> {
    if bound.is_unknown() {
        return None;
    }
    let power = (0..4).fold(bound, |square, _| square.mul(square));
    let log = if power.is_unknown() {
        16 * bound.top()
    } else {
        power.top()
    };
    u64::try_from(log.max(0)).ok()
}

/// Some n such that a number made of these terms is zero or at least 2^-n in
/// magnitude; none if that is beyond all budgets.
pub(super) fn separation_bits(graph: &Graph, needed: &[usize], number: &Multiple) -> Option<u64> {
    let mut sizes = vec![Sizes::whole(&BigInt::one()); graph.terms().len()];
    for &place in needed {
        sizes[place] = term_sizes(&graph.terms()[place], &sizes);
    }
    let is_root = |&&place: &&usize| matches!(graph.terms()[place], Term::Root { .. });
    let radicals = needed.iter().filter(is_root).count();
    let factor = Sizes::fraction(number.factor.numer(), number.factor.denom());
    let whole = number.term.map_or(factor, |term| factor.mul(sizes[term]));
    whole.bits(u32::try_from(radicals).ok()?)
}

fn term_sizes(term: &Term, sizes: &[Sizes]) -> Sizes {
    match term {
        Term::Sum { constant, parts } => parts
            .iter()
            .map(|(part, coefficient)| Sizes::whole(coefficient).mul(sizes[*part]))
            .fold(Sizes::whole(constant), Sizes::add),
        Term::Product(factors) => factors
            .iter()
            .map(|(factor, exponent)| sizes[*factor].power(*exponent))
            .fold(Sizes::whole(&BigInt::one()), Sizes::mul),
        Term::Root { factor, of } => {
            let factor = Sizes::whole(factor);
            of.map_or(factor, |of| factor.mul(sizes[of])).root()
        }
    }
}
