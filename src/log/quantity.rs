//! Numbers in logs and states: computed, or proven to lie within bounds.

use num_rational::BigRational;

use super::decimal::{self, Direction};
use crate::arithmetic::Arithmetic;
use crate::first_impact::Quadratic;
use crate::run::Accumulation;
use crate::scalar::{Scalar, nearest_binary64};

/// The digits that bounds have beyond those that are correct, so that
/// rounding outwards takes none of those away.
const GUARD_DIGITS: u32 = 2;

/// A number of a run.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Quantity {
    /// As computed.
    Computed(f64),
    /// Proven to lie within bounds.
    Proven(Bounds),
}

/// What exact arithmetic says of a number.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct Bounds {
    /// The nearest binary64.
    #[serde(rename = "f64")]
    pub nearest: f64,
    /// The lower bound, a decimal or a fraction.
    pub lo: String,
    /// The upper bound, equal to the lower one if the number is rational.
    pub hi: String,
}

impl Quantity {
    /// A number, with bounds of so many correct digits where it has any.
    pub fn new<S: Arithmetic>(value: &S, digits: u32) -> Self {
        match Bounds::new(value, digits) {
            Some(bounds) => Self::Proven(bounds),
            None => Self::Computed(finite(value.to_f64())),
        }
    }

    /// The time that infinitely many impacts approach.
    pub(super) fn of_limit(found: &Accumulation, digits: u32) -> Self {
        let [lo, hi] = &found.limit;
        let nearest = finite(found.limit_to_f64());
        match found.proven {
            true => Self::Proven(Bounds::between(nearest, lo, hi, digits)),
            false => Self::Computed(nearest),
        }
    }

    /// The number, as the nearest binary64.
    pub fn to_f64(&self) -> f64 {
        match self {
            Self::Computed(number) => *number,
            Self::Proven(bounds) => bounds.nearest,
        }
    }
}

impl Bounds {
    /// The proven bounds of a number, with so many correct digits; none if
    /// nothing is proven.
    pub fn new<S: Arithmetic>(value: &S, digits: u32) -> Option<Self> {
        let (lo, hi) = value.enclosure()?;
        let nearest = nearest_between(&lo, &hi, value);
        Some(Self::between(nearest, &lo, &hi, digits))
    }

    /// The bounds of a number in closed form, with so many correct digits.
    pub fn of_quadratic(value: &Quadratic, digits: u32) -> Self {
        let mut bits = u64::from(digits.saturating_add(GUARD_DIGITS)) * 4;
        loop {
            let (lo, hi) = value.enclosure(bits);
            let [low, high] = [&lo, &hi].map(nearest_binary64);
            // An irrational number is not the middle of two binary64 numbers.
            if low == high {
                return Self::between(finite(low), &lo, &hi, digits);
            }
            bits *= 2;
        }
    }

    fn between(nearest: f64, lo: &BigRational, hi: &BigRational, digits: u32) -> Self {
        if lo == hi {
            let text = decimal::exact(lo, digits);
            return Self {
                nearest,
                lo: text.clone(),
                hi: text,
            };
        }
        let digits = digits.saturating_add(GUARD_DIGITS);
        Self {
            nearest,
            lo: decimal::rounded(lo, digits, Direction::Down),
            hi: decimal::rounded(hi, digits, Direction::Up),
        }
    }
}

/// The binary64 nearest to the true value: that to which both bounds round.
/// Where they differ the true value is next to the middle of two binary64
/// numbers, and the one nearest to the middle of the bounds is taken.
pub(super) fn nearest<S: Arithmetic>(value: &S) -> f64 {
    match value.enclosure() {
        Some((lo, hi)) => nearest_between(&lo, &hi, value),
        None => finite(value.to_f64()),
    }
}

fn nearest_between<S: Scalar>(lo: &BigRational, hi: &BigRational, value: &S) -> f64 {
    let [lo, hi] = [lo, hi].map(nearest_binary64);
    finite(if lo == hi { lo } else { value.to_f64() })
}

/// JSON has no infinities: beyond the largest binary64 that one is nearest. It
/// has no NaN either, which is written as `null`.
fn finite(number: f64) -> f64 {
    // The sum turns a negative zero into zero.
    number.clamp(f64::MIN, f64::MAX) + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Exact, Scalar};

    fn exact(text: &str, bits: u32) -> Exact {
        Exact::from_number(&text.parse().unwrap(), bits)
    }

    #[test]
    fn binary64_proves_nothing() {
        assert_eq!(Quantity::new(&0.1, 20), Quantity::Computed(0.1));
        assert_eq!(Quantity::new(&f64::INFINITY, 20).to_f64(), f64::MAX);
        assert!(Quantity::new(&-0.0, 20).to_f64().is_sign_positive());
    }

    #[test]
    fn rationals_have_equal_bounds() {
        let bounds = Bounds::new(&exact("262/65", 64), 20).unwrap();
        assert_eq!([&*bounds.lo, &*bounds.hi], ["262/65", "262/65"]);
        assert_eq!(bounds.nearest, 262.0 / 65.0);
    }

    /// √2 = 1.41421356237309504880168872420969807…
    #[test]
    fn roots_are_enclosed() {
        let bounds = Bounds::new(&exact("2", 128).sqrt(), 20).unwrap();
        assert_eq!(bounds.lo, "1.414213562373095048801");
        assert_eq!(bounds.hi, "1.414213562373095048802");
        assert_eq!(bounds.nearest, std::f64::consts::SQRT_2);
    }

    /// 1 + 2^-53 is half way between 1 and the next binary64; a little more
    /// is nearer to that.
    #[test]
    fn the_nearest_is_that_of_the_truth() {
        let half_way = exact("0x1.00000000000008p0", 200);
        let more = half_way + exact("2", 200).sqrt() * exact("0x1p-80", 200);
        assert_eq!(nearest(&more), 1f64.next_up());
    }

    #[test]
    fn numbers_beyond_binary64_have_bounds_all_the_same() {
        let large = exact("1e400", 64);
        let bounds = Bounds::new(&large, 20).unwrap();
        assert_eq!(bounds.nearest, f64::MAX);
        assert_eq!(bounds.lo, format!("1{}", "0".repeat(400)));
    }
}
