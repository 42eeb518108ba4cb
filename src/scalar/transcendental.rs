//! The exponential function and the logarithm, in proven bounds.
//!
//! Both are summed up in fixed point, with n digits in base two after the point.
//! Every operation rounds down, or is off by less than two units of the last
//! place; the bounds count these. All functions are monotone, so that the bounds
//! of an argument give those of the result.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::{Exact, Scalar};

/// Bits beyond those that are asked for.
const GUARD: u32 = 64;

/// The argument of the exponential series is below 2^-this.
const SMALL: u32 = 16;

/// Fixed-point numbers with so many bits after the point.
#[derive(Clone, Copy, Debug)]
struct Fixed(u32);

impl Fixed {
    fn one(self) -> BigInt {
        BigInt::one() << self.0
    }

    /// Rounded down.
    fn of(self, number: &BigRational) -> BigInt {
        (number.numer() << self.0) / number.denom()
    }

    fn product(self, one: &BigInt, other: &BigInt) -> BigInt {
        (one * other) >> self.0
    }

    fn bounds(self, number: &BigInt, error: u64) -> [BigRational; 2] {
        [number - error, number + error].map(|end| BigRational::new(end, self.one()))
    }

    /// The sum of z^(2i+1) / (2i+1), for |z| ≤ 1/3: off by less than four units
    /// a term.
    fn inverse_tanh(self, z: &BigInt) -> (BigInt, u64) {
        let squared = self.product(z, z);
        let (mut power, mut sum, mut terms) = (z.clone(), z.clone(), 1_u64);
        while !power.is_zero() && power != BigInt::from(-1) {
            power = self.product(&power, &squared);
            sum += &power / (2 * terms + 1);
            terms += 1;
        }
        (sum, 4 * terms)
    }
}

/// Bounds of e^-x for x ≥ 0, no further apart than 2^-bits.
fn exp_minus(x: &BigRational, bits: u32) -> [BigRational; 2] {
    let whole = x.ceil().to_integer().bits() as u32;
    if whole > 40 {
        return [BigRational::zero(), small(bits)];
    }
    let halvings = whole + SMALL;
    let fixed = Fixed(bits + GUARD + 2 * halvings);
    let argument = fixed.of(x) >> halvings;
    let (mut term, mut sum, mut terms) = (fixed.one(), fixed.one(), 0_u64);
    while !term.is_zero() && term != BigInt::from(-1) {
        terms += 1;
        term = -fixed.product(&term, &argument) / terms;
        sum += &term;
    }
    // The argument, the terms, and what follows the last one.
    let mut error = 3 * terms + 4;
    for _ in 0..halvings {
        sum = fixed.product(&sum, &sum);
        error = 2 * error + 2;
    }
    fixed.bounds(&sum, error)
}

fn small(bits: u32) -> BigRational {
    BigRational::new(BigInt::one(), BigInt::one() << bits)
}

/// Bounds of the natural logarithm of a positive number, no further apart than
/// about 2^-bits.
fn ln(x: &BigRational, bits: u32) -> [BigRational; 2] {
    let exponent = x.numer().bits() as i64 - x.denom().bits() as i64;
    let fixed = Fixed(bits + GUARD + 2 * exponent.unsigned_abs().max(1).ilog2());
    let scale = |shift: i64| BigRational::from_integer(BigInt::one() << shift);
    let middle = if exponent < 0 {
        x * scale(-exponent)
    } else {
        x / scale(exponent)
    };
    // It is between 1/2 and 2.
    let one = BigRational::one();
    let z = fixed.of(&((&middle - &one) / (middle + one)));
    let third = fixed.of(&BigRational::new(BigInt::one(), 3.into()));
    let (part, error) = fixed.inverse_tanh(&z);
    let (ln_two, other_error) = fixed.inverse_tanh(&third);
    let sum: BigInt = (part + ln_two * exponent) * 2;
    let error = 2 * (error + 2 + (other_error + 2) * exponent.unsigned_abs());
    fixed.bounds(&sum, error)
}

impl Exact {
    /// 1 - e^-x, for x ≥ 0.
    pub(crate) fn decay(&self) -> Self {
        let one = BigRational::one;
        self.increasing(1, |x, bits| {
            let [low, high] = exp_minus(&x.clone().max(BigRational::zero()), bits);
            [
                one() - high.min(one()),
                one() - low.max(BigRational::zero()),
            ]
        })
    }

    /// x - (1 - e^-x), for x ≥ 0.
    pub(crate) fn lag(&self) -> Self {
        self.increasing(2, |x, bits| {
            let x = x.clone().max(BigRational::zero());
            let behind = &x - BigRational::one();
            exp_minus(&x, bits).map(|power| (power + &behind).max(BigRational::zero()))
        })
    }

    /// -ln (1 - x), for x between 0 and 1: anything if x may be 1.
    pub(crate) fn undecay(&self) -> Self {
        let one = BigRational::one();
        if self.enclosure().is_some_and(|(_, hi)| hi >= one) {
            return Self::unknown(self.precision());
        }
        self.increasing(1, |x, bits| {
            let [low, high] = ln(&(&one - x), bits);
            [-high, -low]
        })
    }

    /// The value of an increasing function that goes as such a power of the number
    /// where that is small, given its bounds at a point to within about 2^-bits.
    fn increasing(
        &self,
        power: u32,
        bounds: impl Fn(&BigRational, u32) -> [BigRational; 2],
    ) -> Self {
        let bits = self.precision();
        let Some((lo, hi)) = self.enclosure() else {
            return self.clone();
        };
        if hi.is_zero() {
            return self.clone();
        }
        let small = hi.denom().bits().saturating_sub(hi.numer().bits());
        let all = bits + power * u32::try_from(small).unwrap_or(u32::MAX / 4);
        let [least, most] = bounds(&hi, all);
        let least = if lo == hi {
            least
        } else {
            bounds(&lo, all)[0].clone()
        };
        Self::enclosing([least, most], bits)
    }
}

#[cfg(test)]
mod tests {
    use num_traits::ToPrimitive;
    use proptest::prelude::*;

    use super::*;
    use crate::scalar::Number;

    fn exact(text: &str) -> Exact {
        Exact::from_number(&text.parse::<Number>().unwrap(), 128)
    }

    /// e^-x by its series in fractions, of which the terms alternate: between any
    /// two of its sums, once they fall.
    fn series(x: &BigRational) -> [BigRational; 2] {
        let (mut term, mut sum) = (BigRational::one(), BigRational::one());
        let mut before = sum.clone();
        for n in 1..120 {
            term = -term * x / BigRational::from_integer(n.into());
            before = std::mem::replace(&mut sum, &before + &term);
        }
        [before.clone().min(sum.clone()), before.max(sum)]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn the_decay_is_that_of_the_series(n in 1..2000_i64) {
            let x = BigRational::new(n.into(), 250.into());
            let (lo, hi) = Exact::from_rational(x.clone(), 128).decay().enclosure().unwrap();
            let [high, low] = series(&x).map(|power| BigRational::one() - power);
            prop_assert!(lo <= high && low <= hi);
            prop_assert!((hi - lo).to_f64().unwrap() < 1e-36);
        }

        /// The one undoes the other, however small the number.
        #[test]
        fn the_logarithm_undoes_the_decay(n in 1..64_i64, exponent in -400..3_i32) {
            let x = BigRational::from_integer(n.into())
                * BigRational::from_integer(2.into()).pow(exponent - 5);
            let back = Exact::from_rational(x.clone(), 128).decay().undecay();
            let (lo, hi) = back.enclosure().unwrap();
            prop_assert!(lo <= x && x <= hi);
            prop_assert!(((hi - lo) / x).to_f64().unwrap() < 1e-30);
        }
    }

    #[test]
    fn what_may_be_without_end_is_unknown() {
        assert!(exact("1").undecay().enclosure().is_none());
        assert!(exact("0").decay().is_surely_zero());
        // Whether 1 - e^-1000 is below 1 takes 1443 bits.
        let one = exact("1");
        assert!(exact("1000").decay().compare(&one).is_err());
        let decay = exact("1000").with_bits(1500).decay();
        assert_eq!(decay.compare(&one), Ok(std::cmp::Ordering::Less));
    }
}
