//! A cheap proof that a number is no square: its image in a prime field is
//! none.
//!
//! Let every radicand of a tower go to a residue other than zero modulo an odd
//! prime p. The choice of a root of each residue maps the numbers without p in
//! their denominators to F_p, and keeps sums and products. Let R be the
//! quotients of such numbers whose divisors do not go to zero. R holds the
//! roots of its squares: it grows from the fractions without p in their
//! denominators, a discrete valuation ring, by roots of T² - d where 2 d is
//! invertible, hence is unramified over it and a discrete valuation ring
//! itself; and a root of x is integral, as it satisfies T² - x = 0. So the
//! image of a square is a square, and what goes to a nonresidue has no root in
//! the tower. What goes to a residue may have one or not.

use std::sync::LazyLock;

use num_bigint::{BigInt, Sign};
use num_traits::ToPrimitive;

use super::element::Element;

/// How many maps are kept of each field.
const MAPS: usize = 32;

/// The largest primes below 2^31 that are 3 modulo 4, so that roots are
/// powers.
static PRIMES: LazyLock<Vec<u32>> = LazyLock::new(|| {
    let candidates = (0..).map(|n| (1 << 31) - 1 - 4 * n);
    candidates.filter(|&n| is_prime(n)).take(MAPS).collect()
});

fn is_prime(n: u32) -> bool {
    !n.is_multiple_of(2)
        && (3..)
            .step_by(2)
            .take_while(|d| d * d <= n)
            .all(|d| !n.is_multiple_of(d))
}

/// A map from a tower into a prime field.
#[derive(Clone, Debug)]
pub(super) struct Embedding {
    prime: u32,
    /// Where the radicals go.
    roots: Vec<u64>,
}

impl Embedding {
    /// Maps of the rationals.
    pub(super) fn of_rationals() -> Vec<Self> {
        let map = |&prime: &u32| Self {
            prime,
            roots: Vec::new(),
        };
        PRIMES.iter().map(map).collect()
    }

    /// The maps that go on to a field with one more radical, each in two ways
    /// where there is room.
    pub(super) fn extend(maps: &[Self], radicand: &[BigInt]) -> Vec<Self> {
        let roots: Vec<_> = maps
            .iter()
            .filter_map(|map| Some((map, map.root_of(map.image(radicand))?)))
            .collect();
        let positive = roots.iter().map(|(map, root)| map.with(*root));
        let negative = roots.iter().map(|(map, root)| map.with(map.p() - root));
        positive.chain(negative).take(MAPS).collect()
    }

    /// Whether the number is certainly no square of the field.
    pub(super) fn refutes_square(&self, x: &Element) -> bool {
        // n / m is a square exactly if n m is.
        let denominator = self.residue(&x.denominator);
        let image = self.image(&x.numerator) * denominator % self.p();
        image != 0 && self.power(image, (self.p() - 1) / 2) != 1
    }

    fn p(&self) -> u64 {
        self.prime.into()
    }

    fn with(&self, root: u64) -> Self {
        let mut roots = self.roots.clone();
        roots.push(root);
        Self { roots, ..*self }
    }

    fn residue(&self, number: &BigInt) -> u64 {
        let magnitude = (number.magnitude() % self.prime).to_u64().unwrap_or(0);
        match number.sign() {
            Sign::Minus if magnitude != 0 => self.p() - magnitude,
            _ => magnitude,
        }
    }

    fn image(&self, coefficients: &[BigInt]) -> u64 {
        if let [number] = coefficients {
            return self.residue(number);
        }
        let (low, high) = coefficients.split_at(coefficients.len() / 2);
        let root = self.roots[low.len().trailing_zeros() as usize];
        (self.image(low) + self.image(high) * root) % self.p()
    }

    /// A root of a residue other than zero: a^((p + 1) / 4).
    fn root_of(&self, residue: u64) -> Option<u64> {
        let root = self.power(residue, self.p().div_ceil(4));
        (residue != 0 && root * root % self.p() == residue).then_some(root)
    }

    fn power(&self, base: u64, exponent: u64) -> u64 {
        let (mut result, mut square, mut rest) = (1, base, exponent);
        while rest > 0 {
            if rest % 2 == 1 {
                result = result * square % self.p();
            }
            square = square * square % self.p();
            rest /= 2;
        }
        result
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::limits::Limits;
    use crate::algebra::tower::Tower;

    /// By Fermat's test to four bases, with the library's powers.
    #[test]
    fn primes_are_primes() {
        assert_eq!(PRIMES.len(), MAPS);
        for &p in PRIMES.iter() {
            assert_eq!(p % 4, 3);
            for base in [2, 3, 5, 7].map(BigInt::from) {
                let power = base.modpow(&BigInt::from(p - 1), &BigInt::from(p));
                assert_eq!(power, BigInt::from(1));
            }
        }
        assert_eq!(PRIMES[0], i32::MAX as u32, "a Mersenne prime");
        assert!(!is_prime(46_337 * 46_337) && !is_prime(3 * 715_827_881));
    }

    /// Sums and products keep their places, also over a nested radical.
    #[test]
    fn maps_keep_sums_and_products() {
        let mut tower = Tower::new(Limits::default());
        let number = |numbers: &[i32]| {
            let numerator = numbers.iter().copied().map(BigInt::from).collect();
            Element::new(numerator, BigInt::from(1))
        };
        tower.root(&number(&[2])).unwrap();
        tower.root(&number(&[1, 1])).unwrap();
        let (a, b) = (number(&[3, -1, 4, 1]), number(&[-5, 9, 2, 6]));
        let (sum, product) = (a.add(&b), tower.mul(&a, &b).unwrap());
        assert!(!tower.embeddings[2].is_empty());
        for map in &tower.embeddings[2] {
            let [x, y] = [&a, &b].map(|n| map.image(&n.numerator));
            assert_eq!(map.image(&sum.numerator), (x + y) % map.p());
            assert_eq!(map.image(&product.numerator), x * y % map.p());
        }
    }
}
