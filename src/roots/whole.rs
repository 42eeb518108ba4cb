//! Polynomials with whole coefficients: common divisors.
//!
//! Most pairs have none but constants, which their images modulo a prime tell: if
//! the prime does not divide a leading coefficient, the degree of the common
//! divisor of the images is at least that of the polynomials'. Otherwise the
//! sequence of pseudo-remainders without their contents tells (Knuth, The Art of
//! Computer Programming 2, 4.6.1, algorithm E).

use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::Polynomial;
use crate::scalar::Dyadic;

/// By ascending powers, without a common divisor of all coefficients, and with a
/// leading one that is not zero; none for zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Whole(Vec<BigInt>);

/// A prime (of Mersenne), such that products are small.
const PRIME: u64 = (1 << 61) - 1;

impl Whole {
    /// A multiple of a polynomial.
    pub(super) fn of(f: &Polynomial<Dyadic>) -> Self {
        let counted = f.0.iter().filter(|a| !a.is_zero());
        let lowest = counted.map(Dyadic::exponent).min().unwrap_or_default();
        let whole = |a: &Dyadic| match a.is_zero() {
            true => BigInt::ZERO,
            false => a.mantissa() << (a.exponent() - lowest),
        };
        Self::primitive(f.0.iter().map(whole).collect())
    }

    /// Without zeros at the end and without the content.
    fn primitive(mut coefficients: Vec<BigInt>) -> Self {
        while coefficients.last().is_some_and(BigInt::is_zero) {
            coefficients.pop();
        }
        let content = coefficients
            .iter()
            .fold(BigInt::ZERO, |content, a| content.gcd(a));
        if content.bits() > 1 {
            coefficients.iter_mut().for_each(|a| *a /= &content);
        }
        Self(coefficients)
    }

    fn is_constant(&self) -> bool {
        self.0.len() <= 1
    }

    /// The coefficient of the highest power.
    pub(super) fn leading(&self) -> BigInt {
        self.0.last().cloned().unwrap_or_default()
    }

    /// By Horner's rule for p/q, times a power of q.
    pub(super) fn is_zero_at(&self, ratio: &BigRational) -> bool {
        let start = (BigInt::ZERO, BigInt::one());
        let step = |(value, power): (BigInt, BigInt), a: &BigInt| {
            (value * ratio.numer() + a * &power, power * ratio.denom())
        };
        self.0.iter().rev().fold(start, step).0.is_zero()
    }

    pub(super) fn to_dyadic(&self) -> Polynomial<Dyadic> {
        let coefficient = |power: usize| self.0.get(power).cloned().unwrap_or_default();
        Polynomial(std::array::from_fn(|power| {
            Dyadic::new(coefficient(power), 0).normalised()
        }))
    }

    fn derivative(&self) -> Self {
        let terms = self.0.iter().enumerate().skip(1);
        Self::primitive(terms.map(|(power, a)| a * BigInt::from(power)).collect())
    }

    /// The greatest common divisor, none being zero.
    pub(super) fn common(&self, other: &Self) -> Self {
        if are_coprime(self, other) {
            return Self(vec![BigInt::from(1)]);
        }
        let (mut a, mut b) = (self.clone(), other.clone());
        while !b.0.is_empty() {
            (a, b) = (b.clone(), Self::primitive(divided(a.0, &b.0).1));
        }
        a
    }

    /// The polynomial with the same zeros, each of them simple.
    pub(super) fn square_free(&self) -> Self {
        let common = self.common(&self.derivative());
        if common.is_constant() {
            return self.clone();
        }
        Self::primitive(divided(self.0.clone(), &common.0).0)
    }
}

/// Quotient and remainder of a multiple of the dividend. That both are of the
/// same multiple does not matter: the remainder, and the quotient of what divides,
/// are told but for a factor.
fn divided(mut dividend: Vec<BigInt>, divisor: &[BigInt]) -> (Vec<BigInt>, Vec<BigInt>) {
    let Some(leading) = divisor.last() else {
        return (Vec::new(), dividend);
    };
    let mut quotient = Vec::new();
    while dividend.len() >= divisor.len() {
        let Some(top) = dividend.pop() else { break };
        quotient
            .iter_mut()
            .chain(&mut dividend)
            .for_each(|a| *a *= leading);
        let place = dividend.len() + 1 - divisor.len();
        for (a, b) in dividend[place..].iter_mut().zip(divisor) {
            *a -= &top * b;
        }
        quotient.push(top);
    }
    quotient.reverse();
    (quotient, dividend)
}

/// Whether two polynomials certainly have no common zero.
fn are_coprime(one: &Whole, other: &Whole) -> bool {
    let [mut a, mut b] = [one, other].map(|f| f.0.iter().map(residue).collect::<Vec<_>>());
    if [&a, &b]
        .iter()
        .any(|f| f.last().is_none_or(|leading| *leading == 0))
    {
        return false;
    }
    while b.len() > 1 {
        (a, b) = (b.clone(), remainder(a, &b));
    }
    !b.is_empty()
}

/// The remainder modulo the prime, but for a factor.
fn remainder(mut dividend: Vec<u64>, divisor: &[u64]) -> Vec<u64> {
    let leading = divisor[divisor.len() - 1];
    while dividend.len() >= divisor.len() {
        let top = dividend[dividend.len() - 1];
        let place = dividend.len() - divisor.len();
        dividend.iter_mut().for_each(|a| *a = times(*a, leading));
        for (a, b) in dividend[place..].iter_mut().zip(divisor) {
            *a = (*a + PRIME - times(top, *b)) % PRIME;
        }
        while dividend.last() == Some(&0) {
            dividend.pop();
        }
    }
    dividend
}

fn times(a: u64, b: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(PRIME)) as u64
}

fn residue(number: &BigInt) -> u64 {
    let magnitude = (number.magnitude() % PRIME).to_u64().unwrap_or(0);
    match number.sign() {
        Sign::Minus if magnitude != 0 => PRIME - magnitude,
        _ => magnitude,
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn whole(coefficients: &[i64]) -> Whole {
        Whole::primitive(coefficients.iter().copied().map(BigInt::from).collect())
    }

    fn product(a: &Whole, b: &Whole) -> Whole {
        let mut sum = vec![BigInt::ZERO; a.0.len() + b.0.len()];
        for (i, x) in a.0.iter().enumerate() {
            for (j, y) in b.0.iter().enumerate() {
                sum[i + j] += x * y;
            }
        }
        Whole::primitive(sum)
    }

    /// But for the sign.
    fn are_equal(a: &Whole, b: &Whole) -> bool {
        *a == *b || *a == Whole(b.0.iter().map(|x| -x).collect())
    }

    fn shifted(prime: bool) -> Whole {
        let leading = if prime { PRIME as i64 } else { 1 };
        whole(&[3, -1, leading])
    }

    #[test]
    fn common_divisors() {
        // 2 t + 3, t² + 1 and t - 5, and one whose leading coefficient is the prime.
        let [a, b, c] = [whole(&[3, 2]), whole(&[1, 0, 1]), whole(&[-5, 1])];
        assert!(are_equal(&product(&a, &b).common(&product(&a, &c)), &a));
        assert!(product(&a, &a).common(&product(&b, &c)).is_constant());
        assert!(are_equal(
            &product(&a, &product(&b, &a)).square_free(),
            &product(&a, &b)
        ));
        assert!(are_equal(&product(&b, &b).square_free(), &b));
        for prime in [false, true] {
            let d = shifted(prime);
            assert!(are_equal(&product(&d, &a).common(&product(&d, &c)), &d));
            assert!(product(&d, &a).common(&c).is_constant());
        }
        assert!(are_equal(&a.common(&whole(&[])), &a));
    }

    proptest! {
        /// The common divisor of products with one factor the same is a multiple
        /// of it, and divides both.
        #[test]
        fn common_factors_divide(
            [a, b, c] in prop::array::uniform3(prop::array::uniform3(-9..9_i64)),
        ) {
            let [a, b, c] = [a, b, c].map(|f| whole(&f));
            prop_assume!([&a, &b, &c].iter().all(|f| !f.0.is_empty()));
            let (f, g) = (product(&a, &b), product(&a, &c));
            let common = f.common(&g);
            let divides = |divisor: &Whole, f: &Whole| {
                Whole::primitive(divided(f.0.clone(), &divisor.0).1).0.is_empty()
            };
            prop_assert!(divides(&common, &f) && divides(&common, &g) && divides(&a, &common));
            prop_assert!(divides(&f.square_free(), &f));
        }
    }
}
