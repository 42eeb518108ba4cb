//! Floating point in one and in two words.
//!
//! A [`Twofold`] is the unevaluated sum of two binary64 numbers, the second at
//! most half an ulp of the first. Its operations are those of Joldes, Muller and
//! Popescu (Tight and rigorous error bounds for basic building blocks of
//! double-word arithmetic, 2017), with relative errors of at most 15 u² where
//! u = 2^-53 and nothing overflows or vanishes; the square root is that of
//! Lefèvre, Louvet, Muller, Picot and Rideau (Accurate calculation of Euclidean
//! norms using double-word arithmetic, 2023), with at most 25/8 u².

use std::ops::{Add, Div, Mul, Neg, Sub};

/// The unit roundoff of binary64.
const U: f64 = f64::EPSILON / 2.0;

/// The largest magnitude, and the inverse of the least one, for which products of
/// four numbers are safe.
pub(super) const LIMIT: f64 = f64::from_bits((1023 + 200) << 52);

/// More than what underflow can then cost.
pub(super) const UNDERFLOW: f64 = f64::from_bits((1023 - 800) << 52);

/// Whether a magnitude is within these limits.
#[inline]
pub(super) fn is_moderate(size: f64) -> bool {
    size < LIMIT && size * LIMIT > 1.0
}

/// A number that floating-point decisions are computed with.
pub(super) trait Float:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The largest relative error of an operation.
    const UNIT: f64;

    /// A binary64 number.
    fn new(number: f64) -> Self;

    /// The square root of a positive number.
    fn sqrt(self) -> Self;

    /// The nearest binary64 number.
    fn head(self) -> f64;

    /// The difference of two binary64 numbers.
    #[inline]
    fn difference(one: f64, other: f64) -> Self {
        Self::new(one) - Self::new(other)
    }
}

impl Float for f64 {
    const UNIT: f64 = U;

    #[inline]
    fn new(number: f64) -> Self {
        number
    }

    #[inline]
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }

    #[inline]
    fn head(self) -> f64 {
        self
    }
}

/// The sum of two binary64 numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Twofold {
    head: f64,
    tail: f64,
}

impl Twofold {
    /// The nearest binary64 number to all numbers that are no further than
    /// `error` from this one, if that is the same for all.
    #[inline]
    pub(super) fn nearest(self, error: f64) -> Option<f64> {
        let error = error + 4.0 * U * self.tail.abs();
        let [low, high] = [self.tail - error, self.tail + error];
        let nearest = self.head + low;
        let is_sure = nearest == self.head + high && nearest.is_finite();
        (is_sure && nearest != 0.0).then_some(nearest)
    }
}

impl Float for Twofold {
    const UNIT: f64 = 16.0 * U * U;

    #[inline]
    fn new(number: f64) -> Self {
        Self {
            head: number,
            tail: 0.0,
        }
    }

    #[inline]
    fn sqrt(self) -> Self {
        let root = self.head.sqrt();
        let rest = (-root).mul_add(root, self.head) + self.tail;
        quick_sum(root, rest / (2.0 * root))
    }

    #[inline]
    fn head(self) -> f64 {
        self.head
    }

    /// Exact.
    #[inline]
    fn difference(one: f64, other: f64) -> Self {
        sum(one, -other)
    }
}

/// The sum of two numbers, exactly (Knuth).
#[inline]
fn sum(a: f64, b: f64) -> Twofold {
    let head = a + b;
    let of_b = head - a;
    let tail = (a - (head - of_b)) + (b - of_b);
    Twofold { head, tail }
}

/// The same where the first number is not smaller (Dekker).
#[inline]
fn quick_sum(a: f64, b: f64) -> Twofold {
    let head = a + b;
    let tail = b - (head - a);
    Twofold { head, tail }
}

/// The product of two numbers, exactly.
#[inline]
fn product(a: f64, b: f64) -> Twofold {
    let head = a * b;
    let tail = a.mul_add(b, -head);
    Twofold { head, tail }
}

impl Add for Twofold {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        let heads = sum(self.head, other.head);
        let tails = sum(self.tail, other.tail);
        let partial = quick_sum(heads.head, heads.tail + tails.head);
        quick_sum(partial.head, tails.tail + partial.tail)
    }
}

impl Neg for Twofold {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self {
            head: -self.head,
            tail: -self.tail,
        }
    }
}

impl Sub for Twofold {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Twofold {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let heads = product(self.head, other.head);
        let cross = self.head * other.tail + self.tail * other.head;
        quick_sum(heads.head, heads.tail + cross)
    }
}

impl Div for Twofold {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let head = self.head / other.head;
        let covered = other * Self::new(head);
        let rest = (self.head - covered.head) + (self.tail - covered.tail);
        quick_sum(head, rest / other.head)
    }
}

#[cfg(test)]
mod tests {
    use num_rational::BigRational;
    use num_traits::Signed;
    use proptest::prelude::*;

    use super::*;

    fn exactly(number: Twofold) -> BigRational {
        [number.head, number.tail]
            .map(|part| BigRational::from_float(part).unwrap())
            .into_iter()
            .sum()
    }

    fn twofold() -> impl Strategy<Value = Twofold> {
        (-1e6..1e6_f64, -1.0..1.0_f64)
            .prop_map(|(head, part)| quick_sum(head, part * U * head))
            .prop_filter("not zero", |number| number.head != 0.0)
    }

    fn is_close(computed: Twofold, exact: &BigRational) -> bool {
        let unit = BigRational::from_float(Twofold::UNIT).unwrap();
        (exactly(computed) - exact).abs() <= unit * exact.abs()
    }

    proptest! {
        /// Against rationals.
        #[test]
        fn operations_err_by_at_most_a_unit(a in twofold(), b in twofold()) {
            let (x, y) = (exactly(a), exactly(b));
            prop_assert!(is_close(a + b, &(&x + &y)));
            prop_assert!(is_close(a - b, &(&x - &y)));
            prop_assert!(is_close(a * b, &(&x * &y)));
            prop_assert!(is_close(a / b, &(&x / &y)));
        }

        /// The square of a root is off by twice as much.
        #[test]
        fn roots_err_by_at_most_a_unit(a in twofold()) {
            let number = if a.head < 0.0 { -a } else { a };
            let root = exactly(number.sqrt());
            let two_units = BigRational::from_float(2.1 * Twofold::UNIT).unwrap();
            let exact = exactly(number);
            prop_assert!((&root * &root - &exact).abs() <= two_units * exact);
        }

        #[test]
        fn differences_are_exact(a in -1e300..1e300_f64, b in -1.0..1.0_f64) {
            let exact = [a, -b].map(|number| BigRational::from_float(number).unwrap());
            prop_assert_eq!(exactly(Twofold::difference(a, b)), exact.into_iter().sum());
        }
    }

    /// 1 + 2^-54 rounds to 1; what may be 1 + 2^-53, half way to the next, is
    /// left open.
    #[test]
    fn what_rounds_alike_is_rounded() {
        let number = Twofold {
            head: 1.0,
            tail: U / 2.0,
        };
        assert_eq!(number.nearest(U / 4.0), Some(1.0));
        assert_eq!(number.nearest(U / 2.0), None);
    }
}
