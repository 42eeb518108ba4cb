//! The arithmetics that a scene can be run in, and how many bits they may use.

use num_rational::BigRational;

use crate::effects::{self, Fall, Sink};
use crate::scalar::{Decay, Exact, Filtered, Number, Scalar};
use crate::timeline::Timed;

/// How precise the enclosures of exact arithmetic may get.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// The bits of the first attempt.
    pub first_bits: u32,
    /// The bits beyond which the run is given up as undecided.
    pub most_bits: u32,
}

impl Default for Budget {
    fn default() -> Self {
        Self {
            first_bits: 128,
            most_bits: 16_384,
        }
    }
}

/// How an attempt came to its end before that of the run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shortfall {
    /// The part of the whole run that was done.
    pub progress: f64,
    /// The bits that were still certain.
    pub left: u32,
}

impl Budget {
    /// Bits beyond those that the run is expected to lose: the digits of the
    /// times, and close decisions.
    const RESERVE: f64 = 128.0;

    /// The bits to try after an attempt with `bits`.
    ///
    /// Bits are lost at a steady rate, so what an attempt lost predicts what
    /// the whole run loses. Below [`Exact::STEP_BITS`] the rate is another than
    /// above: a longer run is first tried with just these. An attempt that
    /// failed with many bits left was not short of them: it says nothing but
    /// that many more are needed.
    pub fn next_bits(&self, bits: u32, short: Shortfall) -> Option<u32> {
        let next = if short.left > bits / 4 {
            bits.saturating_mul(4)
        } else {
            self.predicted(bits, short)
        };
        let next = next.checked_next_multiple_of(64).unwrap_or(u32::MAX);
        (bits < self.most_bits).then(|| next.min(self.most_bits))
    }

    fn predicted(&self, bits: u32, short: Shortfall) -> u32 {
        let lost = f64::from(bits - short.left);
        let predicted = (1.1 * lost / short.progress.max(1e-3) + Self::RESERVE) as u32;
        let step = Exact::STEP_BITS;
        if bits < step && predicted > step {
            return step;
        }
        predicted.clamp(bits.saturating_add(bits / 4), bits.saturating_mul(32))
    }
}

/// The bits that a number keeps beyond the digits asked for: what is computed
/// from it, and how it rounds, is then as good as certain too.
const SPARE_BITS: u32 = 64;

/// An arithmetic that a user can choose.
pub trait Arithmetic: Timed + Decay {
    /// Its name on the command line and in the log.
    const NAME: &'static str;

    /// What the first attempt computes with.
    fn first_precision(budget: &Budget) -> Self::Precision;

    /// What to compute with after an attempt that failed, if there is more to
    /// try.
    fn next_precision(
        budget: &Budget,
        precision: Self::Precision,
        short: Shortfall,
    ) -> Option<Self::Precision>;

    /// The bits of enclosures, of an arithmetic that has them.
    fn bits(precision: Self::Precision) -> Option<u32>;

    /// The numbers of a scene that are safe have magnitudes between 2^-range and
    /// 2^range; none where all are.
    const RANGE: Option<i32>;

    /// What starts a course under gravity.
    const FALL: Fall<Self>;

    /// What starts a course through air, if it is to be had.
    const SINK: Option<Sink<Self>>;

    /// A rational of the size that a [`Number`] can have, rounded at most
    /// once.
    fn from_rational(value: BigRational, precision: Self::Precision) -> Self {
        let number = Number::try_from(value).expect("times are of the size of numbers");
        Self::from_number(&number, precision)
    }

    /// How many leading bits of the number are certain; none where it is
    /// known exactly, or where the arithmetic proves nothing.
    fn certain_bits(&self) -> Option<u32>;

    /// Whether so many decimal digits of the number are certain. An
    /// arithmetic that proves nothing has no more to offer.
    fn has_digits(&self, digits: u32) -> bool {
        let wanted = f64::from(digits) * std::f64::consts::LOG2_10;
        self.certain_bits()
            .is_none_or(|bits| f64::from(bits) > wanted)
    }

    /// The number in as little memory as so many certain decimal digits take.
    #[must_use]
    fn shortened(self, digits: u32) -> Self;

    /// The number as an exact one: for a binary64 the very number that it is.
    fn exactly(&self, bits: u32) -> Exact;
}

impl Arithmetic for f64 {
    const NAME: &'static str = "f64";
    const FALL: Fall<Self> = effects::fall;
    const SINK: Option<Sink<Self>> = Some(effects::sink);
    /// No product of four numbers overflows or vanishes.
    const RANGE: Option<i32> = Some(Number::BINARY64_RANGE);

    fn certain_bits(&self) -> Option<u32> {
        None
    }

    fn shortened(self, _: u32) -> Self {
        self
    }

    fn first_precision(_: &Budget) {}

    fn next_precision(_: &Budget, (): (), _: Shortfall) -> Option<()> {
        None
    }

    fn bits((): ()) -> Option<u32> {
        None
    }

    fn exactly(&self, bits: u32) -> Exact {
        let number = Number::try_from(*self);
        Exact::from_number(&number.unwrap_or(Number::from(0)), bits)
    }
}

impl Arithmetic for Filtered {
    const NAME: &'static str = "filtered";
    const FALL: Fall<Self> = effects::fall;
    /// Nobody knows how to decide everything about exponential functions.
    const SINK: Option<Sink<Self>> = None;
    /// The numbers can be stored, with all their bits.
    const RANGE: Option<i32> = Some(1000);

    fn certain_bits(&self) -> Option<u32> {
        None
    }

    fn shortened(self, _: u32) -> Self {
        self
    }

    fn first_precision(_: &Budget) {}

    fn next_precision(_: &Budget, (): (), _: Shortfall) -> Option<()> {
        None
    }

    fn bits((): ()) -> Option<u32> {
        None
    }

    fn exactly(&self, bits: u32) -> Exact {
        self.get().exactly(bits)
    }
}

impl Arithmetic for Exact {
    const NAME: &'static str = "exact";
    const FALL: Fall<Self> = effects::fall;
    const SINK: Option<Sink<Self>> = Some(effects::sink);
    const RANGE: Option<i32> = None;

    fn certain_bits(&self) -> Option<u32> {
        self.accuracy().map(|bits| u32::try_from(bits).unwrap_or(0))
    }

    fn shortened(self, digits: u32) -> Self {
        let bits = f64::from(digits) * std::f64::consts::LOG2_10;
        self.shortened(bits as u32 + SPARE_BITS)
    }

    fn first_precision(budget: &Budget) -> u32 {
        budget.first_bits
    }

    fn next_precision(budget: &Budget, bits: u32, short: Shortfall) -> Option<u32> {
        budget.next_bits(bits, short)
    }

    fn bits(bits: u32) -> Option<u32> {
        Some(bits)
    }

    fn exactly(&self, _: u32) -> Exact {
        self.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn next(bits: u32, left: u32, progress: f64) -> Option<u32> {
        let budget = Budget {
            first_bits: 128,
            most_bits: 20_000,
        };
        budget.next_bits(bits, Shortfall { progress, left })
    }

    /// 1.1 × 120 / 0.25 + 128 = 656.
    #[test]
    fn what_was_lost_predicts_what_will_be() {
        assert_eq!(next(128, 8, 0.25), Some(704));
        assert_eq!(next(2048, 48, 0.5), Some(4544));
    }

    #[test]
    fn a_long_run_is_tried_with_the_fewest_bits_of_steps_first() {
        assert_eq!(next(128, 8, 0.001), Some(Exact::STEP_BITS));
        // 1.1 × 2048 / 0.2 + 128 = 11 392.
        assert_eq!(next(2048, 0, 0.2), Some(11_392));
    }

    #[test]
    fn what_fails_with_bits_left_gets_four_times_as_many() {
        assert_eq!(next(128, 100, 0.001), Some(512));
        assert_eq!(next(4096, 2048, 0.001), Some(16_384));
    }

    #[test]
    fn the_budget_is_the_limit() {
        assert_eq!(next(4096, 0, 0.001), Some(20_000));
        assert_eq!(next(20_000, 0, 0.9), None);
    }
}
