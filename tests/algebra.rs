//! Numbers that prove every sign: against identities known by hand, against
//! integer arithmetic of many digits, and on impacts that are simultaneous.

#[path = "algebra/budget.rs"]
mod budget;
#[path = "algebra/close.rs"]
mod close;
#[path = "algebra/deep.rs"]
mod deep;
#[path = "algebra/identities.rs"]
mod identities;
#[path = "algebra/impacts.rs"]
mod impacts;
#[path = "algebra/random.rs"]
mod random;

use carom::algebra::{Expression, Limits};
use carom::scalar::{Number, Scalar};

/// A number as text: `3`, `-1/3`.
fn number(text: &str) -> Expression {
    Expression::from_number(&text.parse().unwrap(), Limits::default())
}

fn whole(n: i64) -> Expression {
    Expression::from_number(&Number::from(n), Limits::default())
}

fn root(n: i64) -> Expression {
    whole(n).sqrt()
}
