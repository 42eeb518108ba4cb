//! Square roots of rationals, and what of them is rational.

use std::cmp::Ordering;

use num_bigint::{BigInt, BigUint, Sign};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::scalar::exact_sqrt;

/// Squares of factors up to here are found.
const LARGEST_FACTOR: u32 = 256;

/// The order against zero; that of the ratios themselves is slow.
pub(super) fn sign_of(value: &BigRational) -> Ordering {
    value.numer().cmp(&BigInt::ZERO)
}

/// The root of the square of a rational.
pub(super) fn rational_root(square: &BigRational) -> Option<BigRational> {
    let root = |part: &BigInt| exact_sqrt(&part.to_biguint()?).map(BigInt::from);
    // Roots of coprime squares are coprime.
    Some(BigRational::new_raw(
        root(square.numer())?,
        root(square.denom())?,
    ))
}

/// Splits n into s² f with s > 0, such that f has no square factor that is
/// easily found. It is 1 if n is a square.
pub(super) fn split_square(n: &BigInt) -> (BigInt, BigInt) {
    let (mut root, mut free, mut rest) = (BigUint::one(), BigUint::one(), n.magnitude().clone());
    let twos = rest.trailing_zeros().unwrap_or(0);
    rest >>= twos;
    root <<= twos / 2;
    free <<= twos % 2;
    for factor in (3..LARGEST_FACTOR).step_by(2) {
        let power = remove(&mut rest, factor);
        root *= BigUint::from(factor).pow(power / 2);
        free *= BigUint::from(factor).pow(power % 2);
    }
    match exact_sqrt(&rest) {
        Some(exact) => root *= exact,
        None => free *= rest,
    }
    let sign = if n.sign() == Sign::Minus {
        Sign::Minus
    } else {
        Sign::Plus
    };
    (root.into(), BigInt::from_biguint(sign, free))
}

/// Divides by a factor as often as that is possible, and tells how often.
fn remove(n: &mut BigUint, factor: u32) -> u32 {
    let mut power = 0;
    while !n.is_zero() && n.is_multiple_of(&factor.into()) {
        *n /= factor;
        power += 1;
    }
    power
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn squares_are_split_off() {
        let table = [
            (1, 1, 1),
            (12, 2, 3),
            (-72, 6, -2),
            (49 * 30, 7, 30),
            (10_403 * 10_403, 10_403, 1),
        ];
        for (n, root, free) in table {
            assert_eq!(split_square(&n.into()), (root.into(), free.into()), "{n}");
        }
    }

    proptest! {
        #[test]
        fn the_parts_make_the_number(n in any::<i64>().prop_filter("zero has no parts", |n| *n != 0), s in 1..100_000_i64) {
            let n = BigInt::from(n);
            let (root, free) = split_square(&n);
            prop_assert_eq!(&root * &root * &free, n.clone());
            prop_assert_eq!(split_square(&free).0, BigInt::one());
            let square = &n * &n * s * s;
            prop_assert_eq!(split_square(&square).1, BigInt::one());
        }

        #[test]
        fn roots_of_rational_squares(n in 0..1_000_000_i64, d in 1..1_000_000_i64) {
            let ratio = BigRational::new(n.into(), d.into());
            prop_assert_eq!(rational_root(&(&ratio * &ratio)), Some(ratio.clone()));
            prop_assert_eq!(rational_root(&(-&ratio * &ratio - BigRational::one())), None);
        }
    }
}
