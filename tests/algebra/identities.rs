//! Sums that are zero, and known by hand to be.

use std::cmp::Ordering::{Equal, Greater, Less};

use carom::algebra::Expression;
use carom::scalar::Scalar;

use super::{number, root, whole};

/// √(a + b√c)
fn nested(a: i64, b: i64, c: i64) -> Expression {
    (whole(a) + whole(b) * root(c)).sqrt()
}

/// Roots that can be written with fewer roots one within the other, as
/// squaring shows.
#[test]
fn denestings() {
    let zeros = [
        root(2) + root(3) - nested(5, 2, 6),
        nested(3, 2, 2) - whole(1) - root(2),
        nested(7, 4, 3) - whole(2) - root(3),
        nested(4, -2, 3) - root(3) + whole(1),
        nested(16, -2, 55) - root(11) + root(5),
        nested(9, 4, 5) - nested(9, -4, 5) - whole(4),
        nested(2, 1, 3) - (root(6) + root(2)) / whole(2),
        nested(10, 2, 24) - root(6) - whole(2),
        // √(16 - 2√29 + 2√(55 - 10√29)) = √5 + √(11 - 2√29)
        (nested(55, -10, 29) * whole(2) + whole(16) - whole(2) * root(29)).sqrt()
            - root(5)
            - nested(11, -2, 29),
        // (√2 + √3 + √5)² = 10 + 2√6 + 2√10 + 2√15
        (whole(10) + whole(2) * (root(6) + root(10) + root(15))).sqrt()
            - root(2)
            - root(3)
            - root(5),
    ];
    for (place, zero) in zeros.iter().enumerate() {
        assert_eq!(zero.sign(), Ok(Equal), "identity {place}");
        assert_eq!(
            (zero.clone() + number("1e-60")).sign(),
            Ok(Greater),
            "{place}"
        );
        assert_eq!(
            (zero.clone() - number("1e-600")).sign(),
            Ok(Less),
            "{place}"
        );
    }
}

/// 2 cos(π/16) and 2 sin(π/16): nested to depth three.
#[test]
fn half_angles() {
    let half = |x: Expression, sign: i64| (whole(2) + whole(sign) * x).sqrt();
    let (eighth, quarter) = (half(root(2), 1), root(2));
    let (cos, sin) = (half(eighth.clone(), 1), half(eighth.clone(), -1));
    let (two, four) = (whole(2), whole(4));
    let zeros = [
        cos.square() + sin.square() - &four,
        cos.clone() * &sin - half(quarter.clone(), -1),
        cos.square() - &two - &eighth,
        (cos.square() - &two).square() - &two - &quarter,
        // cos 3x = 4 cos³x - 3 cos x; 2 cos(3π/16) = √(2 + √(2 - √2))
        cos.square() * &cos - whole(3) * &cos - half(half(quarter, -1), 1),
        (cos.clone() + &sin).square() - four - two * half(root(2), -1),
    ];
    for (place, zero) in zeros.iter().enumerate() {
        assert_eq!(zero.sign(), Ok(Equal), "identity {place}");
    }
    assert_eq!(cos.compare(&sin), Ok(Greater));
}

/// The regular pentagon, and the one of seventeen corners, of which Gauss gave
/// the cosine: both cosines are roots of Chebyshev's T_n(x) = 1, where T_n has
/// its maximum.
#[test]
fn regular_polygons() {
    let pentagon = (root(5) - whole(1)) / whole(4);
    assert_eq!(chebyshev(5, &pentagon).compare(&whole(1)), Ok(Equal));
    let (r17, a) = (root(17), nested(34, -2, 17));
    let b = (whole(17) + whole(3) * &r17 - &a - whole(2) * nested(34, 2, 17)).sqrt();
    let gauss = (r17 - whole(1) + a + whole(2) * b) / whole(16);
    assert_eq!(chebyshev(17, &gauss).compare(&whole(1)), Ok(Equal));
    let near = gauss + number("1e-90");
    assert_eq!(chebyshev(17, &near).compare(&whole(1)), Ok(Less));
}

/// T_n(x), by T_(n+1) = 2 x T_n - T_(n-1).
fn chebyshev(n: usize, x: &Expression) -> Expression {
    let start = (whole(1), x.clone());
    let step = |(before, last): (Expression, Expression), _| {
        let next = whole(2) * x * &last - before;
        (last, next)
    };
    (1..n).fold(start, step).1
}

/// The same number from its conjugates: sums and products of the roots of
/// x² - 2 a x + (a² - b) = 0 are rational.
#[test]
fn conjugates() {
    for (a, b) in [(1, 2), (5, 24), (-7, 3)] {
        let (plus, minus) = (whole(a) + root(b), whole(a) - root(b));
        let product = plus.clone() * &minus;
        assert_eq!(product.compare(&whole(a * a - b)), Ok(Equal));
        let fourth = plus.square().square() + minus.square().square();
        let expected = 2 * a.pow(4) + 12 * a * a * b + 2 * b * b;
        assert_eq!(fourth.compare(&whole(expected)), Ok(Equal));
        let reciprocals = whole(1) / plus + whole(1) / minus;
        let expected = whole(2 * a) / whole(a * a - b);
        assert_eq!(reciprocals.compare(&expected), Ok(Equal));
    }
}

/// What is proven stays with the number.
#[test]
fn proofs_are_remembered() {
    let zero = root(2) + root(3) - nested(5, 2, 6);
    assert!(zero.rational().is_none() && zero.enclosure() != whole(0).enclosure());
    assert_eq!(zero.sign(), Ok(Equal));
    assert_eq!(zero.enclosure(), whole(0).enclosure());
    let product = nested(2, 1, 3) * nested(2, -1, 3);
    assert!(product.rational().is_none());
    assert_eq!((product.clone() - whole(1)).sign(), Ok(Equal));
    assert_eq!(
        product.rational().map(ToString::to_string).as_deref(),
        Some("1")
    );
    assert!((product.sqrt() * whole(3)).rational().is_some());
}

#[test]
fn what_is_no_number_has_no_sign() {
    let zero = root(2) + root(3) - nested(5, 2, 6);
    let one = whole(1);
    let never = [
        one.clone() / whole(0),
        one.clone() / &zero,
        whole(-1).sqrt(),
        (root(2) - root(3)).sqrt(),
        (zero.clone() - number("1e-300")).sqrt(),
        one / zero + root(7),
    ];
    for (place, number) in never.iter().enumerate() {
        assert!(number.sign().is_err(), "{place}");
    }
}
