//! What it takes to enclose zeros: numbers with two ends.

use std::cmp::Ordering::{self, Greater};
use std::fmt::Debug;

use num_bigint::BigInt;
use num_traits::One;

use crate::scalar::{Dyadic, Exact, Interval, Radius, Scalar, Undecided};

/// A place on the line of numbers, known exactly.
pub(super) trait Place: Clone + Debug {
    fn zero() -> Self;

    /// 2^`exponent`, or as near to that as there is one.
    fn power_of_two(exponent: i64) -> Self;

    fn order(&self, other: &Self) -> Ordering;

    /// Between two places that are not negative: about half way, or where the
    /// upper one is more than a few times the lower one, which is not zero, about
    /// half way by their exponents.
    fn middle(low: &Self, high: &Self) -> Self;

    /// Beyond this place as seen from another one, as far again; or a tiny bit
    /// where they are the same.
    fn beyond(&self, from: &Self, upwards: bool) -> Self;

    /// Whether one width is at most half of another.
    fn is_halved(ends: [&Self; 2], before: [&Self; 2]) -> bool;

    /// Whether the width is less than 2^-`bits` of the lower end.
    fn is_narrow(ends: [&Self; 2], bits: u32) -> bool;
}

/// Enclosures that zeros are enclosed with.
pub(super) trait Enclosure: Scalar<Doubt = Undecided> {
    type Place: Place;

    /// A single number.
    fn at(place: &Self::Place) -> Self;

    /// All numbers from one to another.
    fn between(low: &Self::Place, high: &Self::Place) -> Self;

    /// Bounds, unless nothing is known.
    fn ends(&self) -> Option<[Self::Place; 2]>;

    /// The exponent of a power of two that the magnitude is not above, unless
    /// nothing is known.
    fn ceiling(&self) -> Option<i64>;

    /// The exponent of one that it is not below, unless it may be zero.
    fn floor(&self) -> Option<i64>;

    /// How many bits the enclosures that come from this number have.
    fn bits(&self) -> u32;

    /// The same to fewer bits.
    fn rough(&self, bits: u32) -> Self;
}

impl Place for f64 {
    fn zero() -> Self {
        0.0
    }

    fn power_of_two(exponent: i64) -> Self {
        (exponent.clamp(-1022, 1023) as Self).exp2()
    }

    fn order(&self, other: &Self) -> Ordering {
        self.total_cmp(other)
    }

    fn middle(low: &Self, high: &Self) -> Self {
        if *low > 0.0 && high / low > 4.0 {
            Self::from_bits(low.to_bits().midpoint(high.to_bits()))
        } else {
            low / 2.0 + high / 2.0
        }
    }

    fn beyond(&self, from: &Self, upwards: bool) -> Self {
        let width = (self - from).abs();
        if upwards {
            (self + width).max(self.next_up())
        } else {
            (self - width).min(self.next_down())
        }
    }

    fn is_halved([low, high]: [&Self; 2], [from, to]: [&Self; 2]) -> bool {
        high - low <= (to - from) / 2.0
    }

    fn is_narrow([low, high]: [&Self; 2], bits: u32) -> bool {
        high - low < low * Self::power_of_two(-i64::from(bits))
    }
}

impl Enclosure for Interval {
    type Place = f64;

    fn at(place: &f64) -> Self {
        Self::point(*place)
    }

    fn between(low: &f64, high: &f64) -> Self {
        Self::new(*low, *high)
    }

    fn ends(&self) -> Option<[f64; 2]> {
        let ends = [self.lo(), self.hi()];
        ends.iter().all(|end| end.is_finite()).then_some(ends)
    }

    fn ceiling(&self) -> Option<i64> {
        let magnitude = self.magnitude();
        magnitude.is_finite().then(|| exponent(magnitude) + 1)
    }

    fn floor(&self) -> Option<i64> {
        let nearest = self.lo().max(-self.hi());
        (nearest >= f64::MIN_POSITIVE).then(|| exponent(nearest))
    }

    fn bits(&self) -> u32 {
        f64::MANTISSA_DIGITS
    }

    fn rough(&self, _: u32) -> Self {
        *self
    }
}

/// That of the largest power of two that is not above a positive number; for
/// subnormal ones that of the least normal number, less one.
fn exponent(number: f64) -> i64 {
    (number.to_bits() >> 52) as i64 - 1023
}

/// Bits of the middle between two places below their distance.
const GUARD: i64 = 8;

/// Bits of a place down to where it is left alone for something beyond it.
const TINY: i64 = 64;

impl Place for Dyadic {
    fn zero() -> Self {
        Self::zero()
    }

    fn power_of_two(exponent: i64) -> Self {
        Self::new(BigInt::one(), exponent)
    }

    fn order(&self, other: &Self) -> Ordering {
        self.compare(other)
    }

    fn middle(low: &Self, high: &Self) -> Self {
        if !low.is_zero() && high.top() - low.top() > 2 {
            return Place::power_of_two((low.top() + high.top()) / 2 - 1);
        }
        let width = high.clone().sub(low);
        let mut middle = low.clone().add(high).halved();
        middle.floor_at(width.top() - GUARD);
        middle
    }

    fn beyond(&self, from: &Self, upwards: bool) -> Self {
        let width = match self.clone().sub(from) {
            none if none.is_zero() => Place::power_of_two(self.top() - TINY),
            width if width.sign() == Greater => width,
            width => -width,
        };
        let beyond = if upwards {
            self.clone().add(&width)
        } else {
            self.clone().sub(&width)
        };
        beyond.normalised()
    }

    fn is_halved([low, high]: [&Self; 2], [from, to]: [&Self; 2]) -> bool {
        let width = high.clone().sub(low);
        width.compare(&to.clone().sub(from).halved()) != Greater
    }

    fn is_narrow([low, high]: [&Self; 2], bits: u32) -> bool {
        let width = high.clone().sub(low);
        width.is_zero() || low.top() - width.top() > i64::from(bits)
    }
}

impl Enclosure for Exact {
    type Place = Dyadic;

    fn at(place: &Dyadic) -> Self {
        Self::around(place.clone(), Radius::ZERO, 0)
    }

    fn between(low: &Dyadic, high: &Dyadic) -> Self {
        let middle = low.clone().add(high).halved();
        let error = Radius::above(&high.clone().sub(low).halved());
        Self::around(middle, error, 0)
    }

    fn ends(&self) -> Option<[Dyadic; 2]> {
        self.ends()
    }

    fn ceiling(&self) -> Option<i64> {
        let [low, high] = self.ends()?;
        Some(low.top().max(high.top()))
    }

    fn floor(&self) -> Option<i64> {
        let [low, high] = self.ends()?;
        let certain = low.sign() == high.sign() && !low.is_zero();
        certain.then(|| low.top().min(high.top()) - 1)
    }

    fn bits(&self) -> u32 {
        self.precision()
    }

    fn rough(&self, bits: u32) -> Self {
        self.clone().shortened(bits)
    }
}
