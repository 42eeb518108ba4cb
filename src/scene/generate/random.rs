//! Random numbers of a kind that no library's next version changes: the
//! generator is pinned, and so is how its bits become numbers.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};

/// Random numbers that are the same on every platform and with every version.
#[derive(Clone, Debug)]
pub struct Random(ChaCha8Rng);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    /// A stream of its own for each key.
    pub fn keyed(key: [u8; 32]) -> Self {
        Self(ChaCha8Rng::from_seed(key))
    }

    /// One of the whole numbers from `low` to `high`, both included, nearly evenly.
    pub fn whole(&mut self, low: i64, high: i64) -> i64 {
        let count = high.abs_diff(low) + 1;
        let scaled = u128::from(self.0.next_u64()) * u128::from(count);
        low + (scaled >> u64::BITS) as i64
    }

    /// One of some, of which there must be one.
    pub fn one_of<T: Clone>(&mut self, choice: &[T]) -> T {
        choice[self.whole(0, choice.len() as i64 - 1) as usize].clone()
    }

    /// True as often as false.
    pub fn coin(&mut self) -> bool {
        self.whole(0, 1) == 1
    }

    /// A tiny number: one of ±2^-`least` to ±2^-`most`, or, once in three, zero.
    pub fn tiny(&mut self, least: i64, most: i64) -> BigRational {
        let sign = self.whole(-1, 1);
        let exponent = self.whole(least, most);
        BigRational::new(sign.into(), BigInt::one() << exponent)
    }

    /// Uniform from 0 to 1, without 1: a multiple of 2^-53.
    fn unit(&mut self) -> f64 {
        let bits = self.0.next_u64() >> (u64::BITS - f64::MANTISSA_DIGITS);
        bits as f64 * (f64::EPSILON / 2.0)
    }

    /// Uniform from `-bound` to `bound`.
    pub(super) fn within(&mut self, bound: f64) -> f64 {
        (2.0 * self.unit() - 1.0) * bound
    }

    /// A point, uniform in a circle around the origin.
    pub(super) fn in_circle(&mut self, radius: f64) -> [f64; 2] {
        loop {
            let [x, y] = [self.within(radius), self.within(radius)];
            if x * x + y * y <= radius * radius {
                return [x, y];
            }
        }
    }

    /// Nearly normal, of mean 0 and variance 1: the sum of twelve uniform
    /// numbers (Irwin and Hall), which needs no transcendental function.
    pub(super) fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.unit()).sum::<f64>() - 6.0
    }
}
