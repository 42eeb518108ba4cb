//! The numbers that a simulation runs on.
//!
//! Detection, response and every algorithm are written once, over [`Scalar`].
//! What differs between arithmetics is whether a result rounds, and whether a
//! *decision* (the sign of a number, the order of two) can always be made:
//!
//! | type | a result | a decision |
//! |---|---|---|
//! | [`f64`] | rounds to nearest | always made, on the rounded numbers |
//! | [`Interval`] | rounds outwards | made, or left open |
//! | [`Exact`] | is rational, or enclosed to so many bits | proven, or left open |

mod ball;
mod binary64;
mod decay;
mod dyadic;
mod exact;
mod filtered;
mod form;
mod gradient;
mod interval;
mod isqrt;
mod number;
mod parse;
mod radius;
mod rounding;
mod step;
mod transcendental;
mod undecided;
mod value;

use std::cmp::Ordering;
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use num_rational::BigRational;

pub use decay::Decay;
pub(crate) use decay::lag;
pub(crate) use dyadic::Dyadic;
pub use exact::Exact;
pub use filtered::Filtered;
pub use interval::Interval;
pub(crate) use isqrt::{exact_sqrt, isqrt};
pub use number::{Number, NumberError};
pub(crate) use radius::Radius;
pub(crate) use rounding::Rounding;
#[cfg(feature = "json")]
pub(crate) use rounding::nearest_binary64;
pub use step::Step;
pub use undecided::{Doubt, Undecided};

/// A number that collisions are computed with.
///
/// Arithmetic is total; only decisions can fail. The operators take their
/// left operand by value and the right one by value or by reference.
pub trait Scalar:
    Clone
    + Debug
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + for<'a> Add<&'a Self, Output = Self>
    + Sub<Output = Self>
    + for<'a> Sub<&'a Self, Output = Self>
    + Mul<Output = Self>
    + for<'a> Mul<&'a Self, Output = Self>
    + Div<Output = Self>
    + for<'a> Div<&'a Self, Output = Self>
    + Neg<Output = Self>
{
    /// Why a decision was not made: [`std::convert::Infallible`] where
    /// each one can be.
    type Doubt: Doubt;

    /// What it takes to turn a number as written into this type: the bits of
    /// an enclosure, or nothing.
    type Precision: Copy + Debug + Send + Sync;

    /// Whether results round, so that what holds by construction (a normal
    /// as long as the sum of the radii) holds only nearly.
    const ROUNDS: bool;

    /// Whether operations are so dear that [`Interval`] should first rule
    /// out what it can.
    const IS_DEAR: bool;

    /// The number as it was written, rounded at most once.
    fn from_number(number: &Number, precision: Self::Precision) -> Self;

    /// A small whole number, exactly.
    fn from_integer(integer: i32) -> Self;

    /// The sign, as the order of this number against zero.
    fn sign(&self) -> Result<Ordering, Self::Doubt>;

    /// Whether the number is known to be zero, without any effort to find out.
    fn is_surely_zero(&self) -> bool {
        matches!(self.sign(), Ok(Ordering::Equal))
    }

    /// The order of two numbers.
    fn compare(&self, other: &Self) -> Result<Ordering, Self::Doubt>;

    /// The square, which an enclosure knows not to be negative.
    fn square(&self) -> Self;

    /// The square root of a number that has been decided not to be negative.
    fn sqrt(&self) -> Self;

    /// `a b - c d`, with a small relative error even where it cancels.
    fn difference_of_products(a: &Self, b: &Self, c: &Self, d: &Self) -> Self;

    /// `x² + y² - r²`: the power of a point at (x, y) with respect to a
    /// circle of radius r about the origin.
    fn power(x: &Self, y: &Self, r: &Self) -> Self {
        x.square() + y.square() - r.square()
    }

    /// The outcome of a step as a whole, where this type knows a better way
    /// than one operation after another, and `input` is such that it works.
    fn step<P: Step>(input: impl FnOnce() -> P::Input<Self>) -> Option<P::Output<Self>> {
        let _ = input;
        None
    }

    /// Prepares numbers for further steps, which are to involve no others.
    /// What they enclose stays the same.
    fn rebase<'a>(numbers: impl Iterator<Item = &'a mut Self>) {
        let _ = numbers;
    }

    /// The number alone, for the record: without what only steps need.
    #[must_use]
    fn bare(&self) -> Self {
        self.clone()
    }

    /// Lifts a computed time to `floor` where rounding alone put it before;
    /// a proven order needs no such help.
    fn not_before(self, floor: &Self) -> Self;

    /// The nearest binary64 (for an enclosure, to its middle).
    fn to_f64(&self) -> f64;

    /// Binary64 bounds of the true value; for `f64`, the number itself twice.
    fn hull(&self) -> Interval;

    /// Proven bounds of the true value, equal where it is held as a
    /// rational; none for an arithmetic that proves nothing.
    fn enclosure(&self) -> Option<(BigRational, BigRational)>;
}
