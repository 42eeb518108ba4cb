//! The arithmetics that a scene can be run in, and how many bits they may use.

use num_rational::BigRational;

use crate::scalar::{Exact, Number, Scalar};
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

impl Budget {
    /// The bits to try after an attempt with `bits` came this far, as a part
    /// of the whole run. Bits are lost at a steady rate, so that predicts how
    /// many the whole run needs.
    pub fn next_bits(&self, bits: u32, progress: f64) -> Option<u32> {
        let predicted = 1.1 * f64::from(bits) / progress.max(1e-3);
        let next = (predicted as u32).clamp(bits.saturating_mul(2), bits.saturating_mul(8));
        (bits < self.most_bits).then(|| next.next_multiple_of(64).min(self.most_bits))
    }
}

/// The bits that a number keeps beyond the digits asked for: what is computed
/// from it, and how it rounds, is then as good as certain too.
const SPARE_BITS: u32 = 64;

/// An arithmetic that a user can choose.
pub trait Arithmetic: Timed {
    /// Its name on the command line and in the log.
    const NAME: &'static str;

    /// What the first attempt computes with.
    fn first_precision(budget: &Budget) -> Self::Precision;

    /// What to compute with after an attempt that came so far, if there is
    /// more to try.
    fn next_precision(
        budget: &Budget,
        precision: Self::Precision,
        progress: f64,
    ) -> Option<Self::Precision>;

    /// The bits of enclosures, of an arithmetic that has them.
    fn bits(precision: Self::Precision) -> Option<u32>;

    /// Whether only numbers within [`Number::BINARY64_RANGE`] are safe.
    const LIMITED: bool;

    /// A rational of the size that a [`Number`] can have, rounded at most
    /// once.
    fn from_rational(value: BigRational, precision: Self::Precision) -> Self {
        let number = Number::try_from(value).expect("times are of the size of numbers");
        Self::from_number(&number, precision)
    }

    /// Whether so many decimal digits of the number are certain. An
    /// arithmetic that proves nothing has no more to offer.
    fn has_digits(&self, digits: u32) -> bool;

    /// The number in as little memory as so many certain decimal digits take.
    #[must_use]
    fn shortened(self, digits: u32) -> Self;

    /// The number as an exact one: for a binary64 the very number that it is.
    fn exactly(&self, bits: u32) -> Exact;
}

impl Arithmetic for f64 {
    const NAME: &'static str = "f64";
    const LIMITED: bool = true;

    fn has_digits(&self, _: u32) -> bool {
        true
    }

    fn shortened(self, _: u32) -> Self {
        self
    }

    fn first_precision(_: &Budget) {}

    fn next_precision(_: &Budget, (): (), _: f64) -> Option<()> {
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

impl Arithmetic for Exact {
    const NAME: &'static str = "exact";
    const LIMITED: bool = false;

    fn has_digits(&self, digits: u32) -> bool {
        let wanted = f64::from(digits) * std::f64::consts::LOG2_10;
        self.accuracy().is_none_or(|bits| bits as f64 > wanted)
    }

    fn shortened(self, digits: u32) -> Self {
        let bits = f64::from(digits) * std::f64::consts::LOG2_10;
        self.shortened(bits as u32 + SPARE_BITS)
    }

    fn first_precision(budget: &Budget) -> u32 {
        budget.first_bits
    }

    fn next_precision(budget: &Budget, bits: u32, progress: f64) -> Option<u32> {
        budget.next_bits(bits, progress)
    }

    fn bits(bits: u32) -> Option<u32> {
        Some(bits)
    }

    fn exactly(&self, _: u32) -> Exact {
        self.clone()
    }
}
