//! Integer square roots in about the time of a few multiplications.
//!
//! The recursion of Zimmermann: Karatsuba Square Root, INRIA research report
//! 3805, 1999: the root of the upper half gives half of the digits, one
//! division by it gives the other half.

use num_bigint::BigUint;
use num_integer::Integer;
use num_traits::{ToPrimitive, Zero};

/// Up to here the library's own roots take no longer.
const LIBRARY_BITS: u64 = 512;

/// The largest whole number whose square is not above `n`.
pub(crate) fn isqrt(n: &BigUint) -> BigUint {
    if n.bits() <= LIBRARY_BITS {
        small_sqrt(n)
    } else {
        sqrt_rem(n).0
    }
}

/// The square root of a square.
pub(crate) fn exact_sqrt(n: &BigUint) -> Option<BigUint> {
    if !may_be_square(n) {
        return None;
    }
    let (root, remainder) = sqrt_rem(n);
    remainder.is_zero().then_some(root)
}

/// Squares without their trailing zeros are 1 modulo 8: this rules out most
/// others at once.
fn may_be_square(n: &BigUint) -> bool {
    let zeros = n.trailing_zeros().unwrap_or(0);
    let odd_part = || (n >> zeros).iter_u64_digits().next().unwrap_or(1);
    zeros.is_multiple_of(2) && (n.is_zero() || odd_part() % 8 == 1)
}

/// The root s, rounded down, and n - s².
fn sqrt_rem(n: &BigUint) -> (BigUint, BigUint) {
    if n.bits() <= LIBRARY_BITS {
        let root = small_sqrt(n);
        let square = &root * &root;
        return (root, n - square);
    }
    // With b = 2^quarter, n = upper b² + middle b + lower. The division below
    // is precise enough as long as upper ≥ b²/4.
    let quarter = (n.bits() + 1) / 4;
    let upper = n >> (2 * quarter);
    let rest = n - (&upper << (2 * quarter));
    let middle = &rest >> quarter;
    let lower = rest - (&middle << quarter);

    let (high_root, high_rest) = sqrt_rem(&upper);
    let (low_root, division_rest) = ((high_rest << quarter) + middle).div_rem(&(&high_root << 1));
    let root = (high_root << quarter) + &low_root;
    corrected(
        root,
        (division_rest << quarter) + lower,
        &low_root * &low_root,
    )
}

fn small_sqrt(n: &BigUint) -> BigUint {
    n.to_u128().map_or_else(|| n.sqrt(), |n| n.isqrt().into())
}

/// The root and the remainder `partial - square`; where that is negative,
/// the root was one too large.
fn corrected(root: BigUint, partial: BigUint, square: BigUint) -> (BigUint, BigUint) {
    if partial >= square {
        return (root, partial - square);
    }
    // n - (s - 1)² = n - s² + 2s - 1.
    let lifted = partial + (&root << 1) - 1_u32;
    (root - 1_u32, lifted - square)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn check(n: &BigUint) {
        let (root, remainder) = sqrt_rem(n);
        assert_eq!(isqrt(n), root);
        assert_eq!(&root * &root + &remainder, *n);
        // n < (root + 1)².
        assert!(remainder <= &root << 1);
        let is_square = remainder.is_zero();
        assert_eq!(exact_sqrt(n), is_square.then_some(root));
    }

    /// Shifted above the recursion's smallest case too.
    #[test]
    fn small_numbers() {
        for n in 0..70_000_u32 {
            check(&n.into());
        }
        for n in 0..5_000_u32 {
            for shift in (500..520).chain([126, 127]) {
                check(&(BigUint::from(n) << shift));
            }
        }
    }

    #[test]
    fn beside_powers_of_two_and_their_squares() {
        for shift in 1..1200_u32 {
            let power = BigUint::from(1_u32) << shift;
            let below = &power - 1_u32;
            for n in [&power + 1_u32, power.clone(), below.clone()] {
                check(&n);
                check(&(&n * &n - 1_u32));
                check(&(&n * &n));
                check(&(&n * &n + 1_u32));
            }
        }
    }

    proptest! {
        #[test]
        fn large_numbers(digits in prop::collection::vec(any::<u32>(), 1..200)) {
            let n = BigUint::new(digits);
            check(&n);
            check(&(&n * &n));
            check(&(&n * &n + (&n << 1)));
        }

        /// Long runs of equal bits, where the correction is needed.
        #[test]
        fn runs(lengths in prop::collection::vec(1..300_usize, 1..8)) {
            let step = |n: BigUint, length: &usize| ((n + 1_u32) << *length) - 1_u32;
            let n = lengths.iter().fold(BigUint::ZERO, |n, length| step(n << *length, length));
            check(&n);
        }
    }
}
