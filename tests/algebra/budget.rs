//! What is past the budget is left open.

use std::cmp::Ordering::Equal;

use carom::algebra::{Expression, Limits};
use carom::scalar::{Number, Scalar};

fn root(n: i64, limits: Limits) -> Expression {
    Expression::from_number(&Number::from(n), limits).sqrt()
}

/// (√2 + √3 + √5 + …)² less all that it gives: zero.
fn square_written_out(count: usize, limits: Limits) -> Expression {
    let primes = &[2, 3, 5, 7, 11, 13, 17, 19, 23, 29][..count];
    let sum = primes
        .iter()
        .map(|&p| root(p, limits))
        .reduce(|a, b| a + b)
        .unwrap();
    let mut rest = sum.square();
    for (place, p) in primes.iter().enumerate() {
        rest = rest - Expression::from_number(&Number::from(*p), limits);
        for q in &primes[..place] {
            rest = rest - Expression::from_integer(2) * root(p * q, limits);
        }
    }
    rest
}

#[test]
fn what_is_within_the_limits_is_proven() {
    for count in 2..=8 {
        let zero = square_written_out(count, Limits::default());
        assert_eq!(zero.sign(), Ok(Equal), "{count}");
    }
}

#[test]
fn what_is_past_the_limits_is_open() {
    let ten = square_written_out(10, Limits::default())
        .sign()
        .unwrap_err();
    assert!(
        ten.bits >= 2048 && ten.bound.is_some_and(|bound| bound > 1 << 17),
        "{ten:?}"
    );
    let tight = Limits {
        radicals: 2,
        bound_bits: 100,
        ..Limits::default()
    };
    let open = square_written_out(4, tight).sign().unwrap_err();
    assert!(open.bound.is_some_and(|bound| bound > 100));
    assert!(open.to_string().contains("a proof takes"), "{open}");
}

/// Either way alone is enough where it can be gone.
#[test]
fn tower_and_bound_stand_alone() {
    let tower_only = Limits {
        bound_bits: 0,
        ..Limits::default()
    };
    let bound_only = Limits {
        radicals: 0,
        ..Limits::default()
    };
    for limits in [tower_only, bound_only] {
        assert_eq!(
            square_written_out(3, limits).sign(),
            Ok(Equal),
            "{limits:?}"
        );
    }
}

/// Numbers that come without limits take the usual ones.
#[test]
fn small_integers_have_the_usual_limits() {
    let root = |n| Expression::from_integer(n).sqrt();
    let zero = root(2) * root(3) - root(6);
    assert_eq!(zero.sign(), Ok(Equal));
}
