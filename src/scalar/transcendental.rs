//! The exponential function and the logarithm, in proven bounds.
//!
//! Both are summed up in fixed point, with n digits in base two after the point.
//! Every operation rounds down, or is off by less than two units of the last
//! place; the bounds count these. All functions are monotone, so that the bounds
//! of an argument give those of the result.

use std::cmp::Ordering::{Greater, Less};

use num_bigint::BigInt;
use num_traits::{One, Zero};

use super::{Dyadic, Exact};

/// Bits beyond those that are asked for.
const GUARD: u32 = 64;

/// The argument of the exponential series is below 2^-this.
const SMALL: i64 = 16;

/// Fixed-point numbers with so many bits after the point.
#[derive(Clone, Copy, Debug)]
struct Fixed(u32);

impl Fixed {
    fn one(self) -> BigInt {
        BigInt::one() << self.0
    }

    /// A number that is not negative over 2^`halvings`, rounded down.
    fn of(self, number: &Dyadic, halvings: u32) -> BigInt {
        let shift = number.exponent() + i64::from(self.0) - i64::from(halvings);
        if shift < 0 {
            number.mantissa() >> -shift
        } else {
            number.mantissa() << shift
        }
    }

    fn product(self, one: &BigInt, other: &BigInt) -> BigInt {
        (one * other) >> self.0
    }

    fn bounds(self, number: &BigInt, error: u64) -> [Dyadic; 2] {
        [number - error, number + error].map(|end| Dyadic::new(end, -i64::from(self.0)))
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

    /// The logarithm of two, as that of 1/2 is -2 artanh 1/3.
    fn ln_two(self) -> (BigInt, u64) {
        let (half, error) = self.inverse_tanh(&(self.one() / 3));
        (half * 2, 2 * error + 4)
    }
}

/// Bounds of e^-x for x ≥ 0, no further apart than 2^-bits.
fn exp_minus(x: &Dyadic, bits: u32) -> [Dyadic; 2] {
    if x.top() > 40 {
        return [Dyadic::zero(), Dyadic::new(BigInt::one(), -i64::from(bits))];
    }
    let halvings = (x.top() + SMALL).max(0) as u32;
    let fixed = Fixed(bits + GUARD + 2 * halvings);
    let argument = fixed.of(x, halvings);
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

/// Bounds of the natural logarithm of a positive number, no further apart than
/// about 2^-bits.
fn ln(x: &Dyadic, bits: u32) -> [Dyadic; 2] {
    let exponent = x.top();
    let fixed = Fixed(bits + GUARD + 2 * exponent.unsigned_abs().max(1).ilog2());
    // x / 2^exponent is a / b, between 1/2 and 1.
    let (a, b) = (x.mantissa(), BigInt::one() << x.mantissa().bits());
    let z = ((a - &b) << fixed.0) / (a + b);
    let (mut sum, mut error) = fixed.inverse_tanh(&z);
    (sum, error) = (sum * 2, 2 * error + 4);
    if exponent != 0 {
        let (ln_two, ln_two_error) = fixed.ln_two();
        sum += ln_two * exponent;
        error += ln_two_error * exponent.unsigned_abs();
    }
    fixed.bounds(&sum, error)
}

/// What a number is after taking it from one.
fn complement(number: Dyadic) -> Dyadic {
    Dyadic::from(1).sub(&number)
}

fn greater(one: Dyadic, other: Dyadic) -> Dyadic {
    if one.compare(&other) == Less {
        other
    } else {
        one
    }
}

impl Exact {
    /// 1 - e^-x, for x ≥ 0.
    pub(crate) fn decay(&self) -> Self {
        let [decay] = self.increasing(1, |x, bits| [decay(exp_minus(x, bits))]);
        decay
    }

    /// 1 - e^-x, and x - (1 - e^-x), for x ≥ 0.
    pub(crate) fn decay_and_lag(&self) -> [Self; 2] {
        self.increasing(2, |x, bits| {
            let power = exp_minus(x, bits);
            let behind = x.clone().sub(&Dyadic::from(1));
            let lag = power.clone().map(|power| power.add(&behind));
            [decay(power), lag.map(|end| greater(end, Dyadic::zero()))]
        })
    }

    /// -ln (1 - x), for x between 0 and 1: anything if x may be 1.
    pub(crate) fn undecay(&self) -> Self {
        let is_below_one = |end: &Dyadic| end.compare(&Dyadic::from(1)) == Less;
        if !self.ends().is_some_and(|[_, high]| is_below_one(&high)) {
            return Self::unknown(self.precision());
        }
        let [undecay] = self.increasing(1, |x, bits| {
            let [low, high] = ln(&complement(x.clone()), bits);
            [[-high, -low]]
        });
        undecay
    }

    /// The values, for a number that is not negative, of increasing functions that go
    /// as such a power of it or a lower one where that is small, given their bounds at
    /// a point to within about 2^-bits.
    fn increasing<const N: usize>(
        &self,
        power: i64,
        bounds: impl Fn(&Dyadic, u32) -> [[Dyadic; 2]; N],
    ) -> [Self; N] {
        let bits = self.precision();
        let Some([low, high]) = self.ends().filter(|[_, high]| high.sign() == Greater) else {
            return [(); N].map(|()| self.clone());
        };
        let small = power * (-high.top()).max(0);
        let all = bits + u32::try_from(small).unwrap_or(u32::MAX / 4);
        let most = bounds(&high, all);
        let least = match low.compare(&high) {
            Less => bounds(&greater(low, Dyadic::zero()), all),
            _ => most.clone(),
        };
        let mut ends = least.into_iter().zip(most);
        [(); N].map(|()| match ends.next() {
            Some(([low, _], [_, high])) => Self::spanning([low, high], bits),
            None => Self::unknown(bits),
        })
    }
}

/// Bounds of 1 - e^-x, given those of e^-x.
fn decay([low, high]: [Dyadic; 2]) -> [Dyadic; 2] {
    let least = greater(complement(high), Dyadic::zero());
    [least, complement(greater(low, Dyadic::zero()))]
}

#[cfg(test)]
mod tests {
    use num_rational::BigRational;
    use num_traits::ToPrimitive;
    use proptest::prelude::*;

    use super::*;
    use crate::scalar::{Number, Scalar};

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

        /// The lag, too, which goes as the square: to as many digits of itself.
        #[test]
        fn the_lag_is_that_of_the_series(n in 1..2000_i64, shift in 0..80) {
            let x = BigRational::new(n.into(), BigInt::from(256) << shift);
            let [decay, lag] = Exact::from_rational(x.clone(), 128).decay_and_lag();
            let (lo, hi) = lag.enclosure().unwrap();
            let [high, low] = series(&x).map(|power| BigRational::one() - power);
            prop_assert!(lo <= &x - low && &x - high <= hi);
            prop_assert!(((hi - &lo) / lo).to_f64().unwrap() < 1e-36);
            let (lo, hi) = decay.enclosure().unwrap();
            let [high, low] = series(&x).map(|power| BigRational::one() - power);
            prop_assert!(lo <= high && low <= hi);
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
