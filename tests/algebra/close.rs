//! Numbers so near to each other that many digits agree, but not all.

use std::cmp::Ordering::{Greater, Less};

use carom::algebra::{Expression, Limits};
use carom::scalar::Scalar;
use num_bigint::BigInt;
use num_rational::BigRational;

use super::{root, whole};

fn power_of_ten(exponent: u32) -> BigInt {
    BigInt::from(10).pow(exponent)
}

fn integer(n: &BigInt) -> Expression {
    Expression::from_rational(BigRational::from_integer(n.clone()), Limits::default())
}

/// √(n² + 1) = n + 1/(2n) - 1/(8n³) + … is below its first terms, and above
/// with the next one, for any n.
#[test]
fn roots_beside_squares() {
    for digits in [3, 30, 100, 400] {
        let n = power_of_ten(digits);
        let root = integer(&(&n * &n + 1)).sqrt();
        let n = integer(&n);
        let two = n.clone() + whole(1) / (whole(2) * &n);
        assert_eq!((root.clone() - &two).sign(), Ok(Less), "{digits}");
        let three = two - whole(1) / (whole(8) * n.square() * &n);
        assert_eq!(root.compare(&three), Ok(Greater), "{digits}");
    }
}

/// The m-th difference of the square root has the sign of its m-th
/// derivative, (-1)^(m-1), and is about x^(1/2 - m).
#[test]
fn differences_of_roots() {
    for (m, digits) in [(2, 60), (3, 60), (5, 40), (7, 40), (12, 30), (12, 120)] {
        let n = power_of_ten(digits);
        let mut sum = whole(0);
        let mut binomial = 1_i64;
        for i in 0..=m {
            let sign = if (m - i) % 2 == 0 { 1 } else { -1 };
            sum = sum + whole(sign * binomial) * integer(&(&n + i)).sqrt();
            binomial = binomial * (m - i) / (i + 1);
        }
        let expected = if m % 2 == 1 { Greater } else { Less };
        assert_eq!(sum.sign(), Ok(expected), "{m}");
    }
}

/// √n + √(n + 3) < √(n + 1) + √(n + 2), for the root is concave.
#[test]
fn sums_of_two_roots() {
    for n in [10_i64, 1000, 1_000_000, 1_000_000_000_000] {
        let outer = root(n) + root(n + 3);
        let inner = root(n + 1) + root(n + 2);
        assert_eq!(outer.compare(&inner), Ok(Less));
    }
}

/// (√2 - 1)^n is tiny and not zero; it equals |a - b√2| with the convergents.
#[test]
fn powers_of_a_small_unit() {
    let unit = root(2) - whole(1);
    let (mut power, mut a, mut b) = (whole(1), whole(1), whole(0));
    for n in 1..=600 {
        power = power * &unit;
        (a, b) = (whole(2) * &b - &a, a - &b);
        if n % 150 == 0 {
            let number = a.clone() + b.clone() * root(2);
            assert_eq!(number.sign(), Ok(Greater), "{n}");
            assert!(
                number.compare(&power).is_ok_and(|order| order.is_eq()),
                "{n}"
            );
        }
    }
}
