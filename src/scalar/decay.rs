//! What drag makes of time: 1 - e^-x, which nears 1 as x grows, and how far that
//! *lags* behind x.

use std::ops::RangeInclusive;

use super::{Dyadic, Exact, Filtered, Interval, Scalar};

/// Numbers with the exponential function, as far as linear drag needs it.
pub trait Decay: Scalar {
    /// 1 - e^-x, for x ≥ 0. It is below 1, also where it rounds.
    #[must_use]
    fn decay(&self) -> Self;

    /// -ln (1 - x), for x between 0 and 1.
    #[must_use]
    fn undecay(&self) -> Self;
}

/// The largest number below 1.
const BELOW_ONE: f64 = 1.0 - f64::EPSILON / 2.0;

/// With the functions of the platform.
impl Decay for f64 {
    fn decay(&self) -> Self {
        (-(-self).exp_m1()).min(BELOW_ONE)
    }

    fn undecay(&self) -> Self {
        -(-self.min(BELOW_ONE)).ln_1p()
    }
}

/// x - (1 - e^-x), for x ≥ 0, to a few units in the last place: by its series where
/// that is about x²/2, and else as it stands.
pub(crate) fn lag(x: f64) -> f64 {
    if x > 1.0 {
        return x - x.decay();
    }
    let sum = LAG_TERMS
        .rev()
        .fold(1.0, |sum, n| 1.0 - x / f64::from(n) * sum);
    x * x / 2.0 * sum
}

/// x^n / n! up to 1 is less than 2^-54 of the first term from n = 19 on.
const LAG_TERMS: RangeInclusive<i32> = 3..=19;

/// Proven bounds.
impl Decay for Exact {
    fn decay(&self) -> Self {
        self.decay()
    }

    fn undecay(&self) -> Self {
        self.undecay()
    }
}

/// Bounds of so many bits, rounded: the same on every platform.
impl Decay for Filtered {
    fn decay(&self) -> Self {
        Self::new(rounded(self.get(), Exact::decay).min(BELOW_ONE))
    }

    fn undecay(&self) -> Self {
        Self::new(rounded(self.get().min(BELOW_ONE), Exact::undecay))
    }
}

const BITS: u32 = 128;

fn rounded(x: f64, function: fn(&Exact) -> Exact) -> f64 {
    function(&Exact::from_dyadic(Dyadic::from_f64(x), BITS)).to_f64()
}

impl Interval {
    /// Bounds of 1 - e^-x, for x ≥ 0, and of x - (1 - e^-x), which is about x²/2
    /// where that is small. Both increase.
    pub(crate) fn decay_and_lag(self) -> [Self; 2] {
        let low = decay_and_lag(self.lo().max(0.0));
        let high = match self.lo() < self.hi() {
            true => decay_and_lag(self.hi().max(0.0)),
            false => low,
        };
        let [decay, lag] = [0, 1].map(|part| Self::new(low[part].lo(), high[part].hi()));
        [Self::new(decay.lo(), decay.hi().min(1.0)), lag]
    }
}

/// From here on 1 - e^-x is 1 but for less than a unit in the last place.
const LATE: f64 = 64.0;

/// Up to here the series is summed.
const SMALL: f64 = 1.0 / 16.0;

/// 1 - e^-x and x - (1 - e^-x). With D and L those of x, those of 2 x are
/// D (2 - D) and 2 L + D², where nothing cancels. (Bounds of 1 - (1 - D)² are
/// narrower for D above 1/2: they get narrow as D nears 1.)
fn decay_and_lag(x: f64) -> [Interval; 2] {
    if x >= LATE {
        let decay = Interval::new(BELOW_ONE, 1.0);
        return [decay, Interval::point(x) - decay];
    }
    let doublings = if x > SMALL {
        (x / SMALL).log2().ceil() as i32
    } else {
        0
    };
    let start = Interval::point(x / f64::from(doublings).exp2());
    let mut lag = small_lag(start);
    let mut decay = start - lag;
    let [one, two] = [1.0, 2.0].map(Interval::point);
    for _ in 0..doublings {
        lag = two * lag + decay.square();
        decay = if decay.lo() < 0.5 {
            decay * (two - decay)
        } else {
            one - (one - decay).square()
        };
    }
    [decay, lag]
}

/// x²/2! - x³/3! + …, where the terms fall.
fn small_lag(x: Interval) -> Interval {
    const FACTORIALS: [f64; 9] = [
        2.0, 6.0, 24.0, 120.0, 720.0, 5040.0, 40320.0, 362880.0, 3628800.0,
    ];
    let one = Interval::point(1.0);
    // What follows is between nothing and the next term.
    let rest = Interval::new(0.0, (one / Interval::point(39_916_800.0)).hi());
    let coefficients = FACTORIALS
        .iter()
        .rev()
        .map(|&factorial| one / Interval::point(factorial));
    x.square() * coefficients.fold(rest, |sum, next| next - x * sum)
}

#[cfg(test)]
mod tests {
    use num_traits::ToPrimitive;
    use proptest::prelude::*;

    use super::*;

    proptest! {
        /// Against the bounds by whole numbers, of 128 bits.
        #[test]
        fn bounds_hold_and_are_narrow(mantissa in 1.0..2.0_f64, exponent in -60..10_i32) {
            let x = mantissa * f64::from(exponent).exp2();
            let exact = Exact::from_dyadic(Dyadic::from_f64(x), 256);
            let narrow = Interval::point(x);
            for (bounds, truth) in narrow.decay_and_lag().into_iter().zip(exact.decay_and_lag()) {
                let (lo, hi) = truth.enclosure().unwrap();
                let truth = [lo, hi].map(|end| end.to_f64().unwrap());
                prop_assert!(bounds.lo() <= truth[0].next_up() && truth[1].next_down() <= bounds.hi());
                prop_assert!(bounds.hi() - bounds.lo() <= 1e-14 * bounds.hi());
            }
        }
    }

    proptest! {
        /// Bounds hold, and so the number lies between those of 53 bits, or nearly.
        #[test]
        fn the_lag_of_numbers_is_close(mantissa in 1.0..2.0_f64, exponent in -60..10_i32) {
            let x = mantissa * f64::from(exponent).exp2();
            let [_, bounds] = Interval::point(x).decay_and_lag();
            prop_assert!((lag(x) - bounds.middle()).abs() < 1e-15 * bounds.lo());
        }
    }

    #[test]
    fn at_nothing_there_is_nothing() {
        let zero = Interval::point(0.0);
        for bounds in zero.decay_and_lag() {
            assert_eq!([bounds.lo(), bounds.hi()], [0.0, 0.0]);
        }
    }
}
