//! Whole numbers of 512 bits with a sign, in two's complement: sums, products
//! and shifts are taken modulo 2^512, and so are right wherever the result fits.

use std::array::from_fn;
use std::ops::{Add, Mul, Neg, Shl, Sub};

/// Words of 64 bits.
const WORDS: usize = 8;

/// A whole number, its lowest word first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Wide([u64; WORDS]);

impl Wide {
    pub(crate) fn is_negative(self) -> bool {
        self.0[WORDS - 1] >> 63 == 1
    }

    pub(crate) fn is_positive(self) -> bool {
        !self.is_negative() && self.0 != [0; WORDS]
    }

    pub(crate) fn square(self) -> Self {
        self * self
    }

    /// Within some 2^-52 of itself.
    pub(crate) fn to_f64(self) -> f64 {
        if self.is_negative() {
            return -(-self).to_f64();
        }
        let word = 64_f64.exp2();
        let words = self.0.iter().rev();
        words.fold(0.0, |sum, &digit| sum * word + digit as f64)
    }
}

impl From<i128> for Wide {
    fn from(number: i128) -> Self {
        Self(from_fn(|word| (number >> (64 * word).min(127)) as u64))
    }
}

impl Neg for Wide {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(|word| !word)) + Self::from(1)
    }
}

impl Add for Wide {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let mut carry = 0;
        Self(from_fn(|word| {
            let sum = u128::from(self.0[word]) + u128::from(other.0[word]) + carry;
            carry = sum >> 64;
            sum as u64
        }))
    }
}

impl Sub for Wide {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let mut product = [0; WORDS];
        for (low, &digit) in self.0.iter().enumerate() {
            let mut carry = 0;
            for (place, &factor) in product[low..].iter_mut().zip(&other.0) {
                let sum = u128::from(digit) * u128::from(factor) + u128::from(*place) + carry;
                *place = sum as u64;
                carry = sum >> 64;
            }
        }
        Self(product)
    }
}

impl Shl<u32> for Wide {
    type Output = Self;

    fn shl(self, bits: u32) -> Self {
        let (words, bits) = ((bits / 64) as usize, bits % 64);
        let word = |index: usize| index.checked_sub(words).map_or(0, |index| self.0[index]);
        Self(from_fn(|index| {
            let below = index.checked_sub(1).map_or(0, word);
            word(index) << bits | (below >> 1) >> (63 - bits)
        }))
    }
}

#[cfg(test)]
mod tests {
    use num_bigint::{BigInt, BigUint, Sign};
    use num_traits::{One, ToPrimitive};
    use rand::{Rng, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;

    fn big(wide: Wide) -> BigInt {
        let size = |wide: Wide| {
            let words = wide.0.iter().rev().map(|&word| BigUint::from(word));
            words.fold(BigUint::ZERO, |sum, word| (sum << 64) + word)
        };
        if wide.is_negative() {
            BigInt::from_biguint(Sign::Minus, size(-wide))
        } else {
            size(wide).into()
        }
    }

    /// A number of up to 127 bits, with a sign.
    fn some(random: &mut ChaCha8Rng) -> i128 {
        random.random::<i128>() >> random.random_range(0..128)
    }

    #[test]
    fn agrees_with_big_numbers() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        for _ in 0..20_000 {
            let [a, b, c, d] = [0; 4].map(|_| some(&mut random));
            let bits = random.random_range(0..=256);
            let [p, q] = [(a, b), (c, d)].map(|(a, b)| Wide::from(a) * Wide::from(b));
            let [r, s] = [(a, b), (c, d)].map(|(a, b)| BigInt::from(a) * b);
            assert_eq!([big(p), big(q)], [r.clone(), s.clone()]);
            assert_eq!(big(p - q), &r - &s);
            assert_eq!(big(p * Wide::from(c) + q), &r * c + &s);
            assert_eq!(big(p << bits), &r * (BigInt::one() << bits));
            let size = r.to_f64().expect("less than 2^254");
            assert!((p.to_f64() - size).abs() <= size.abs() * f64::EPSILON * 2.0);
            assert_eq!(p.is_positive(), r > BigInt::ZERO);
        }
    }
}
