//! The parts against each other and against enclosures.

mod bound;
mod form;
mod square;
mod tower;

use proptest::prelude::*;

use super::build::Normal;
use super::{Expression, Limits};
use crate::scalar::{Number, Scalar};

fn whole(n: i64) -> Expression {
    Expression::from_number(&Number::from(n), Limits::default())
}

fn root(n: i64) -> Expression {
    whole(n).sqrt()
}

fn normal(expression: &Expression) -> Normal<'_> {
    Normal::of(expression, Limits::default().bits).unwrap()
}

/// A number with one to three roots, one within the other: of those that
/// share their root, some are equal in disguise.
fn expression() -> impl Strategy<Value = Expression> {
    let radicand = prop_oneof![Just(2), Just(3), Just(5), Just(6), Just(8), Just(10)];
    let simple = (-4..5_i64, -3..4_i64, 1..4_i64, radicand)
        .prop_map(|(a, b, c, d)| (whole(a) + whole(b) * root(d)) / whole(c));
    simple.prop_recursive(2, 3, 2, |inner| {
        prop_oneof![
            (inner.clone(), inner.clone()).prop_map(|(a, b)| a * b),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| a - b),
            (inner.clone(), 0..30_i64).prop_map(|(a, n)| (a.square() + whole(n)).sqrt()),
        ]
    })
}
