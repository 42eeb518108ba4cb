//! Exact numbers against rationals.

use std::cmp::Ordering::{Equal, Greater, Less};

use num_bigint::BigInt;
use num_traits::One;
use proptest::prelude::*;

use super::*;

fn exact(text: &str) -> Exact {
    Exact::from_number(&text.parse().unwrap(), 100)
}

fn rational(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

/// The rational that a number is held as.
fn held(number: &Exact) -> Option<BigRational> {
    let (lo, hi) = number.enclosure()?;
    (lo == hi && number.is_rational()).then_some(lo)
}

fn fraction() -> impl Strategy<Value = BigRational> {
    let denominator = prop_oneof![1..1000_i64, (0..40_u32).prop_map(|shift| 1 << shift)];
    (-10_000..10_000_i64, denominator).prop_map(|(n, d)| rational(n, d))
}

fn from_ratio(ratio: &BigRational) -> Exact {
    Exact::from_number(&Number::try_from(ratio.clone()).unwrap(), 100)
}

#[test]
fn numbers_are_taken_over_exactly() {
    for text in ["0", "3", "-1/3", "0.1", "0x1p-1000", "1e300"] {
        let number: Number = text.parse().unwrap();
        assert_eq!(held(&exact(text)), Some(number.to_rational()));
    }
    let binary = Exact::from_number(&Number::try_from(0.1).unwrap(), 0);
    assert_eq!(held(&binary), BigRational::from_float(0.1));
    assert_eq!(binary.hull(), Interval::new(0.1, 0.1));
    assert_eq!(binary.accuracy(), None);
}

#[test]
fn roots_of_squares_are_rational() {
    let table = [
        ("0", "0"),
        ("9", "3"),
        ("1/4", "1/2"),
        ("4/9", "2/3"),
        ("0.0001", "0.01"),
    ];
    for (square, root) in table {
        assert_eq!(held(&exact(square).sqrt()), held(&exact(root)));
    }
    for number in ["2", "1/2", "8", "4/3", "3/4", "17", "1/10"] {
        assert!(!exact(number).sqrt().is_rational(), "{number}");
    }
}

/// √2 to 40 digits, from tables.
#[test]
fn roots_of_others_are_enclosed() {
    let root = exact("2").sqrt();
    assert_eq!(
        root.compare(&exact("1.4142135623730950488016887242")),
        Ok(Greater)
    );
    assert_eq!(
        root.compare(&exact("1.4142135623730950488016887243")),
        Ok(Less)
    );
    assert_eq!(root.to_f64(), std::f64::consts::SQRT_2);
    assert!(root.accuracy().is_some_and(|bits| bits >= 98));
    assert!(root.square().compare(&exact("2")).is_err());
    let doubt = (root.square() - exact("2")).sign().unwrap_err();
    assert_eq!(doubt, Undecided::sign(100));
}

#[test]
fn zero_is_exact() {
    let (zero, root) = (Exact::from_integer(0), exact("2").sqrt());
    let unknown = exact("1") / &zero;
    for number in [&root, &unknown, &exact("1/3")] {
        assert_eq!((zero.clone() * number).sign(), Ok(Equal));
        assert_eq!((number.clone() * &zero).sign(), Ok(Equal));
        let sum = number.clone() + &zero;
        assert_eq!(sum.enclosure(), number.enclosure());
        let difference = zero.clone() - number;
        assert_eq!(difference.enclosure(), (-number.clone()).enclosure());
    }
    assert_eq!((zero / root).sign(), Ok(Equal));
}

#[test]
fn division_by_what_may_be_zero_tells_nothing() {
    let maybe_zero = exact("2").sqrt().square() - exact("2");
    for divisor in [Exact::from_integer(0), maybe_zero] {
        for dividend in [exact("0"), exact("1"), exact("1/3"), exact("3").sqrt()] {
            let quotient = dividend / &divisor;
            assert!(quotient.sign().is_err());
            assert_eq!(quotient.enclosure(), None);
            assert_eq!(quotient.hull(), Interval::UNBOUNDED);
            assert!(!quotient.is_rational());
        }
    }
}

#[test]
fn long_rationals_become_enclosures() {
    for text in ["1/3", "5", "3/1024", "7/5"] {
        let mut power = exact(text);
        let mut truth = held(&power).unwrap();
        while power.is_rational() {
            power = power.clone() * &power;
            truth = &truth * &truth;
            let length = truth.numer().bits() + truth.denom().bits();
            assert_eq!(
                power.is_rational(),
                length <= Exact::RATIONAL_BITS,
                "{text}"
            );
            let (lo, hi) = power.enclosure().unwrap();
            assert!(lo <= truth && truth <= hi);
        }
        assert!(power.accuracy().is_some_and(|bits| bits >= 95));
    }
}

#[test]
fn the_higher_precision_is_carried_on() {
    let three = Exact::from_integer(3);
    let low = Exact::from_number(&Number::from(2), 64);
    let high = Exact::from_number(&Number::from(2), 1000);
    let accuracy = |number: Exact| number.sqrt().accuracy().unwrap();
    assert!((62..=66).contains(&accuracy(three.clone() * &low - &three)));
    assert!((998..=1002).contains(&accuracy(low + high + &three)));
    assert!(accuracy(three) >= 100);
}

#[test]
fn close_numbers_are_told_apart() {
    let tiny = BigRational::new(BigInt::one(), BigInt::one() << 2000_u32);
    let third = rational(1, 3);
    let (a, b) = (from_ratio(&third), from_ratio(&(&third + tiny)));
    assert_eq!(a.compare(&b), Ok(Less));
    assert_eq!(b.compare(&a), Ok(Greater));
    assert_eq!(a.compare(&a), Ok(Equal));
}

proptest! {
    #[test]
    fn rationals_stay_exact(x in fraction(), y in fraction()) {
        let (a, b) = (from_ratio(&x), from_ratio(&y));
        prop_assert_eq!(held(&(a.clone() + &b)), Some(&x + &y));
        prop_assert_eq!(held(&(a.clone() - &b)), Some(&x - &y));
        prop_assert_eq!(held(&(a.clone() * &b)), Some(&x * &y));
        prop_assert_eq!(held(&a.square()), Some(&x * &x));
        prop_assert_eq!(held(&a.square().sqrt()), Some(if x < rational(0, 1) { -&x } else { x.clone() }));
        prop_assert_eq!(a.compare(&b), Ok(x.cmp(&y)));
        prop_assert_eq!(a.sign(), Ok(x.cmp(&rational(0, 1))));
        let power = Exact::difference_of_products(&a, &b, &b, &b);
        prop_assert_eq!(held(&power), Some(&x * &y - &y * &y));
        if y != rational(0, 1) {
            prop_assert_eq!(held(&(a / b)), Some(x / y));
        }
    }

    /// (√x ± y) for all kinds of y against bounds of √x.
    #[test]
    fn mixed_operations_enclose(x in 2..1000_u32, y in fraction()) {
        let root = exact(&x.to_string()).sqrt();
        let b = from_ratio(&y);
        let (lo, hi) = root.enclosure().unwrap();
        let within = |result: Exact, ends: [BigRational; 2]| {
            let (from, to) = result.enclosure().unwrap();
            ends.iter().all(|end| from <= *end && *end <= to)
        };
        prop_assert!(within(root.clone() + &b, [&lo + &y, &hi + &y]));
        prop_assert!(within(b.clone() + &root, [&lo + &y, &hi + &y]));
        prop_assert!(within(root.clone() - &b, [&lo - &y, &hi - &y]));
        prop_assert!(within(b.clone() - &root, [&y - &lo, &y - &hi]));
        prop_assert!(within(root.clone() * &b, [&lo * &y, &hi * &y]));
        prop_assert!(within(b.clone() * &root, [&lo * &y, &hi * &y]));
        prop_assert!(within(b.clone() / &root, [&y / &lo, &y / &hi]));
        if y != rational(0, 1) {
            prop_assert!(within(root / b, [&lo / &y, &hi / &y]));
        }
    }

    #[test]
    fn comparisons_with_enclosures_are_true(x in 2..1000_i64, y in fraction()) {
        let root = exact(&x.to_string()).sqrt();
        let order = from_ratio(&y).compare(&root);
        let square_order = (&y * &y).cmp(&rational(x, 1));
        let expected = if y < rational(0, 1) { Less } else { square_order };
        prop_assert_eq!(order, Ok(expected));
    }
}
