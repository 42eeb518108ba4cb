//! Binary64 intervals: quick enclosures that decide most questions.
//!
//! Each end is computed to nearest and then moved outwards by one number,
//! which bounds the rounding error without switching rounding modes.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use num_rational::BigRational;

use super::{Number, Scalar, Undecided};

/// The real numbers between two binary64 ends, these included.
///
/// An infinite end means that there is no bound on that side: the lower end
/// is never +∞, nor the upper one -∞. Infinity itself is not contained.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    lo: f64,
    hi: f64,
}

impl Interval {
    /// All real numbers.
    pub const UNBOUNDED: Self = Self {
        lo: f64::NEG_INFINITY,
        hi: f64::INFINITY,
    };

    pub(super) const ZERO: Self = Self { lo: 0.0, hi: 0.0 };

    /// The numbers from `lo` to `hi`, which must not be below `lo`. An end
    /// that is not a number is no bound; one beyond all binary64 numbers
    /// bounds by the largest of them.
    #[inline]
    pub fn new(lo: f64, hi: f64) -> Self {
        let lo = if lo.is_nan() {
            f64::NEG_INFINITY
        } else {
            lo.min(f64::MAX)
        };
        let hi = if hi.is_nan() {
            f64::INFINITY
        } else {
            hi.max(f64::MIN)
        };
        Self { lo, hi }
    }

    /// A single number, which must be finite.
    #[inline]
    pub(crate) fn point(number: f64) -> Self {
        Self::new(number, number)
    }

    /// Encloses what rounding to nearest may have cut off at both ends. An
    /// overflow of the lower end to +∞ becomes the largest number, which is
    /// a lower bound of what overflows.
    #[inline]
    fn outward(lo: f64, hi: f64) -> Self {
        Self {
            lo: lo.next_down(),
            hi: hi.next_up(),
        }
    }

    /// The hull of what two bounds of each operand give.
    ///
    /// A NaN comes from 0 × ∞ or ∞ / ∞, where ∞ stands for arbitrarily large
    /// numbers; `f64::min` and `f64::max` pass over it. The limits that it
    /// stands for lie within the hull of the other results, and there is one:
    /// neither operand of a product is the point zero, no divisor is
    /// unbounded on both sides.
    #[inline]
    fn hull_of(corners: [f64; 4]) -> Self {
        let [a, b, c, d] = corners;
        Self::outward(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }

    /// The lower end, or -∞.
    #[inline]
    pub fn lo(&self) -> f64 {
        self.lo
    }

    /// The upper end, or +∞.
    #[inline]
    pub fn hi(&self) -> f64 {
        self.hi
    }

    /// About the middle.
    #[inline]
    pub(crate) fn middle(&self) -> f64 {
        self.lo / 2.0 + self.hi / 2.0
    }

    /// At least the distance of the ends from the rounded middle.
    #[inline]
    pub(crate) fn radius(&self) -> f64 {
        if self.lo == self.hi {
            return 0.0;
        }
        let middle = self.middle();
        (self.hi - middle).max(middle - self.lo) * (1.0 + 1e-9)
    }

    /// The largest magnitude.
    pub(crate) fn magnitude(&self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.lo == 0.0 && self.hi == 0.0
    }

    #[inline]
    fn contains_zero(&self) -> bool {
        self.lo <= 0.0 && self.hi >= 0.0
    }
}

impl Scalar for Interval {
    type Doubt = Undecided;
    type Precision = ();

    const ROUNDS: bool = false;
    const IS_DEAR: bool = false;

    /// A point if the number is binary64, otherwise its two neighbours.
    fn from_number(number: &Number, (): ()) -> Self {
        number.hull()
    }

    #[inline]
    fn from_integer(integer: i32) -> Self {
        Self::point(integer.into())
    }

    #[inline]
    fn sign(&self) -> Result<Ordering, Undecided> {
        self.compare(&Self::ZERO)
    }

    /// Equal are only two points.
    #[inline]
    fn compare(&self, other: &Self) -> Result<Ordering, Undecided> {
        if self.lo > other.hi {
            Ok(Ordering::Greater)
        } else if self.hi < other.lo {
            Ok(Ordering::Less)
        } else if self.lo == other.hi && self.hi == other.lo {
            Ok(Ordering::Equal)
        } else {
            Err(Undecided::sign(f64::MANTISSA_DIGITS))
        }
    }

    #[inline]
    fn square(&self) -> Self {
        if self.is_zero() {
            return Self::ZERO;
        }
        let (near, far) = (
            self.lo.abs().min(self.hi.abs()),
            self.lo.abs().max(self.hi.abs()),
        );
        let near = if self.contains_zero() { 0.0 } else { near };
        let square = Self::outward(near * near, far * far);
        Self::new(square.lo.max(0.0), square.hi)
    }

    /// What lies below zero is cut off.
    #[inline]
    fn sqrt(&self) -> Self {
        if self.hi <= 0.0 {
            return Self::ZERO;
        }
        let root = Self::outward(self.lo.max(0.0).sqrt(), self.hi.sqrt());
        Self::new(root.lo.max(0.0), root.hi)
    }

    #[inline]
    fn difference_of_products(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        *a * b - *c * d
    }

    #[inline]
    fn not_before(self, _: &Self) -> Self {
        self
    }

    /// The middle, an infinity where only one side is bounded, zero where
    /// none is.
    fn to_f64(&self) -> f64 {
        if self.lo == self.hi {
            return self.lo;
        }
        let middle = self.lo / 2.0 + self.hi / 2.0;
        if middle.is_nan() { 0.0 } else { middle }
    }

    #[inline]
    fn hull(&self) -> Interval {
        *self
    }

    /// The two ends; none where one is missing.
    fn enclosure(&self) -> Option<(BigRational, BigRational)> {
        Some((
            BigRational::from_float(self.lo)?,
            BigRational::from_float(self.hi)?,
        ))
    }
}

impl Add<&Self> for Interval {
    type Output = Self;

    /// Zero adds nothing, not even a rounding error.
    #[inline]
    fn add(self, other: &Self) -> Self {
        if other.is_zero() {
            return self;
        }
        if self.is_zero() {
            return *other;
        }
        Self::outward(self.lo + other.lo, self.hi + other.hi)
    }
}

impl Sub<&Self> for Interval {
    type Output = Self;

    #[inline]
    fn sub(self, other: &Self) -> Self {
        self + -*other
    }
}

impl Mul<&Self> for Interval {
    type Output = Self;

    #[inline]
    fn mul(self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        Self::hull_of([
            self.lo * other.lo,
            self.lo * other.hi,
            self.hi * other.lo,
            self.hi * other.hi,
        ])
    }
}

impl Div<&Self> for Interval {
    type Output = Self;

    /// Unbounded if the divisor contains zero.
    #[inline]
    fn div(self, other: &Self) -> Self {
        if other.contains_zero() {
            return Self::UNBOUNDED;
        }
        if self.is_zero() {
            return Self::ZERO;
        }
        Self::hull_of([
            self.lo / other.lo,
            self.lo / other.hi,
            self.hi / other.lo,
            self.hi / other.hi,
        ])
    }
}

impl Neg for Interval {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self {
            lo: -self.hi,
            hi: -self.lo,
        }
    }
}

/// The operators with their right operand by value.
macro_rules! forward_by_value {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Interval {
            type Output = Self;

            #[inline]
            fn $method(self, other: Self) -> Self {
                $operator::$method(self, &other)
            }
        }
    )*};
}

forward_by_value!(Add add, Sub sub, Mul mul, Div div);

#[cfg(test)]
mod tests {
    use std::cmp::Ordering::{Equal, Greater, Less};

    use num_traits::{Signed, Zero};
    use proptest::prelude::*;

    use super::*;

    const INF: f64 = f64::INFINITY;

    /// Ends that matter: signs, zeros, overflow, underflow, no bound.
    fn end() -> impl Strategy<Value = f64> {
        let special = prop::sample::select(vec![
            0.0,
            -0.0,
            1.0,
            -1.0,
            f64::MAX,
            f64::MIN,
            5e-324,
            -5e-324,
            INF,
            -INF,
            1e200,
            -1e-200,
        ]);
        prop_oneof![special, -10.0..10.0, any::<f64>()]
    }

    fn interval() -> impl Strategy<Value = Interval> {
        let wide = (end(), end()).prop_map(|(a, b)| Interval::new(a.min(b), a.max(b)));
        prop_oneof![wide, end().prop_map(Interval::point)]
    }

    /// Rationals in an interval: the ends, or large numbers instead of none,
    /// zero, and something between.
    fn samples(interval: Interval) -> Vec<BigRational> {
        let beyond = BigRational::from_integer(num_bigint::BigInt::from(3).pow(1500));
        let lo = BigRational::from_float(interval.lo).unwrap_or_else(|| -beyond.clone());
        let hi = BigRational::from_float(interval.hi).unwrap_or(beyond);
        let third = &lo + (&hi - &lo) / BigRational::from_integer(3.into());
        let zero = interval.contains_zero().then(BigRational::zero);
        [lo, hi, third].into_iter().chain(zero).collect()
    }

    fn contains(interval: Interval, number: &BigRational) -> bool {
        let above = BigRational::from_float(interval.lo).is_none_or(|lo| lo <= *number);
        let below = BigRational::from_float(interval.hi).is_none_or(|hi| *number <= hi);
        above && below && interval.lo < INF && interval.hi > -INF
    }

    #[test]
    fn ends_are_made_valid() {
        assert_eq!(Interval::new(f64::NAN, f64::NAN), Interval::UNBOUNDED);
        assert_eq!(Interval::point(INF), Interval::new(f64::MAX, INF));
        assert_eq!(Interval::point(-INF), Interval::new(-INF, f64::MIN));
    }

    #[test]
    fn decisions() {
        let (one, wide) = (Interval::point(1.0), Interval::new(0.0, 2.0));
        let undecided = Err(Undecided::sign(53));
        assert_eq!(one.sign(), Ok(Greater));
        assert_eq!((-one).sign(), Ok(Less));
        assert_eq!(Interval::point(-0.0).sign(), Ok(Equal));
        assert_eq!(wide.sign(), undecided);
        assert_eq!(wide.compare(&wide), undecided);
        assert_eq!(wide.compare(&Interval::point(2.0)), undecided);
        assert_eq!(wide.compare(&Interval::point(2.5)), Ok(Less));
        assert_eq!(wide.compare(&Interval::point(-1.0)), Ok(Greater));
        assert_eq!(one.compare(&one), Ok(Equal));
    }

    #[test]
    fn zero_is_exact() {
        let (zero, wide) = (Interval::ZERO, Interval::UNBOUNDED);
        assert_eq!(zero * wide, zero);
        assert_eq!(wide * zero, zero);
        assert_eq!(wide / zero, wide);
        assert_eq!(zero / Interval::new(1.0, INF), zero);
        let third = Interval::new(0.25, 0.5);
        assert_eq!(third + zero, third);
        assert_eq!(zero - third, -third);
        assert_eq!(zero.sqrt(), zero);
    }

    #[test]
    fn middles() {
        assert_eq!(Interval::new(1.0, 2.0).to_f64(), 1.5);
        assert_eq!(Interval::new(f64::MAX, f64::MAX).to_f64(), f64::MAX);
        assert_eq!(Interval::point(5e-324).to_f64(), 5e-324);
        assert_eq!(Interval::UNBOUNDED.to_f64(), 0.0);
        assert_eq!(Interval::new(1.0, INF).to_f64(), INF);
    }

    #[test]
    fn enclosures_have_both_ends_or_none() {
        let half = BigRational::new(1.into(), 2.into());
        let one = BigRational::from_integer(1.into());
        assert_eq!(Interval::new(0.5, 1.0).enclosure(), Some((half, one)));
        assert_eq!(Interval::new(0.5, INF).enclosure(), None);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn operations_enclose(a in interval(), b in interval()) {
            for x in samples(a) {
                prop_assert!(contains(-a, &-&x));
                prop_assert!(contains(a.square(), &(&x * &x)));
                for y in samples(b) {
                    prop_assert!(contains(a + b, &(&x + &y)));
                    prop_assert!(contains(a - b, &(&x - &y)));
                    prop_assert!(contains(a * b, &(&x * &y)));
                    if !y.is_zero() {
                        prop_assert!(contains(a / b, &(&x / &y)));
                    }
                }
            }
        }

        #[test]
        fn roots_enclose(a in interval()) {
            let root = a.sqrt();
            prop_assert!(root.lo >= 0.0);
            for x in samples(a).iter().filter(|x| !x.is_negative()) {
                let square = |end: f64| BigRational::from_float(end).map(|end| &end * &end);
                prop_assert!(square(root.lo).is_some_and(|square| square <= *x));
                prop_assert!(square(root.hi).is_none_or(|square| square >= *x));
            }
        }

        #[test]
        fn decisions_are_true(a in interval(), b in interval()) {
            if let Ok(order) = a.compare(&b) {
                for (x, y) in samples(a).iter().zip(samples(b)) {
                    prop_assert_eq!(x.cmp(&y), order);
                }
            }
        }
    }
}
