//! Numbers p + q √d.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// A number p + q √d with rationals p, q and d, where d is not negative; for a rational
/// number q and d are 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quadratic {
    /// The rational part.
    pub p: BigRational,
    /// The factor of the root.
    pub q: BigRational,
    /// What the root is taken of: no square of a rational, unless it is 0.
    pub d: BigRational,
}

/// Bounds are at first so many bits beyond the point.
const FIRST_BITS: u64 = 64;

impl Quadratic {
    /// p + q √d; where d is the square of a rational, as a rational.
    pub(super) fn new(p: BigRational, q: BigRational, d: BigRational) -> Self {
        if q.is_zero() {
            return Self::rational(p);
        }
        match root(&d) {
            Some(root) => Self::rational(p + q * root),
            None => Self { p, q, d },
        }
    }

    pub(super) fn zero() -> Self {
        Self::rational(BigRational::zero())
    }

    fn rational(p: BigRational) -> Self {
        Self {
            p,
            q: BigRational::zero(),
            d: BigRational::zero(),
        }
    }

    /// Whether it is a rational number.
    pub fn is_rational(&self) -> bool {
        self.q.is_zero()
    }

    pub(super) fn scaled(&self, factor: &BigRational) -> Self {
        Self::new(&self.p * factor, &self.q * factor, self.d.clone())
    }

    pub(super) fn plus(&self, summand: &BigRational) -> Self {
        Self {
            p: &self.p + summand,
            ..self.clone()
        }
    }

    /// The sign: that of the larger of p² and q² d, where the two parts differ in sign.
    pub fn sign(&self) -> Ordering {
        let zero = BigRational::zero();
        let (rational, root) = (self.p.cmp(&zero), self.q.cmp(&zero));
        match (rational, root) {
            (rational, Equal) => rational,
            (Equal, root) => root,
            (rational, root) if rational == root => rational,
            (rational, _) => match (&self.p * &self.p).cmp(&(&self.q * &self.q * &self.d)) {
                Greater => rational,
                // √d would be rational.
                Equal => Equal,
                Less => rational.reverse(),
            },
        }
    }

    /// Whether it is less than another number, to which it must not be equal unless both
    /// are rational.
    pub(super) fn is_less_than(&self, other: &Self) -> bool {
        if self.is_rational() && other.is_rational() {
            return self.p < other.p;
        }
        let mut bits = FIRST_BITS;
        loop {
            let [(lo, hi), (other_lo, other_hi)] = [self, other].map(|one| one.bounds(bits));
            if hi < other_lo {
                return true;
            }
            if other_hi < lo {
                return false;
            }
            bits *= 2;
        }
    }

    /// Bounds that differ by no more than 2^-bits of the number itself, and are equal if
    /// it is rational.
    pub fn enclosure(&self, bits: u64) -> (BigRational, BigRational) {
        let mut precision = bits.max(FIRST_BITS);
        loop {
            let (lo, hi) = self.bounds(precision);
            let width = (&hi - &lo) * (BigInt::one() << bits);
            if width <= lo.abs().min(hi.abs()) {
                return (lo, hi);
            }
            precision *= 2;
        }
    }

    /// Bounds that differ by no more than 2^-bits.
    fn bounds(&self, bits: u64) -> (BigRational, BigRational) {
        if self.is_rational() {
            return (self.p.clone(), self.p.clone());
        }
        // |q| √d is between s and s + 1 in units of 2^-bits.
        let squared = &self.q * &self.q * &self.d * (BigInt::one() << (2 * bits));
        let floor = squared.to_integer().sqrt();
        let unit = BigInt::one() << bits;
        let part = |integer: BigInt| BigRational::new(integer, unit.clone());
        let (lo, hi) = (part(floor.clone()), part(floor + 1));
        match self.q.is_negative() {
            true => (&self.p - hi, &self.p - lo),
            false => (&self.p + lo, &self.p + hi),
        }
    }
}

/// The root of a rational number that is not negative, if that is rational.
fn root(square: &BigRational) -> Option<BigRational> {
    let [numerator, denominator] = [square.numer(), square.denom()].map(|part| part.sqrt());
    let is_exact = &numerator * &numerator == *square.numer()
        && &denominator * &denominator == *square.denom();
    is_exact.then(|| BigRational::new(numerator, denominator))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(text: &str) -> BigRational {
        text.parse().unwrap()
    }

    fn quadratic([p, q, d]: [&str; 3]) -> Quadratic {
        Quadratic::new(ratio(p), ratio(q), ratio(d))
    }

    #[test]
    fn squares_have_rational_roots() {
        let two = quadratic(["1/2", "3", "1/4"]);
        assert!(two.is_rational() && two.p == ratio("2"));
        assert!(!quadratic(["0", "1", "2"]).is_rational());
    }

    /// 99/70 exceeds √2, for 99² = 9801 and 2 · 70² = 9800; 41/29 is less.
    #[test]
    fn signs_are_exact() {
        assert_eq!(quadratic(["99/70", "-1", "2"]).sign(), Greater);
        assert_eq!(quadratic(["-99/70", "1", "2"]).sign(), Less);
        assert_eq!(quadratic(["41/29", "-1", "2"]).sign(), Less);
        assert_eq!(quadratic(["1", "1", "2"]).sign(), Greater);
        assert_eq!(quadratic(["0", "-1", "2"]).sign(), Less);
    }

    /// 99/70 - √2 = 1 / (70² (99/70 + √2)), some 7.2e-5.
    #[test]
    fn small_differences_have_close_bounds() {
        let (lo, hi) = quadratic(["99/70", "-1", "2"]).enclosure(80);
        assert!(lo.is_positive() && lo < hi);
        assert!((&hi - &lo) * (BigInt::one() << 80) <= lo);
        let product = |end: &BigRational| end * ratio("4900") * (ratio("99/70") * ratio("2") - end);
        let one = BigRational::one();
        assert!(product(&lo) <= one && one <= product(&hi));
    }

    #[test]
    fn different_roots_are_ordered() {
        let [three, two] = [["0", "1", "3"], ["1/4", "1", "2"]].map(quadratic);
        assert!(two.is_less_than(&three) && !three.is_less_than(&two));
    }
}
