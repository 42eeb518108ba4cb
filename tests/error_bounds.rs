//! What binary64 makes of the first impact, held to the bounds that
//! `meet_circle` and `meet_segment` state, against fractions.

#[path = "../examples/formulas/exact.rs"]
#[allow(dead_code, reason = "the example uses more of it")]
mod exact;

#[path = "error_bounds/circles.rs"]
mod circles;
#[path = "error_bounds/segments.rs"]
mod segments;

use num_rational::BigRational;

/// Half the distance of 1 to the next binary64: what a rounding may change,
/// relative to the result.
fn unit() -> BigRational {
    exact::fraction(f64::EPSILON / 2.0)
}

fn whole(number: i32) -> BigRational {
    BigRational::from_integer(number.into())
}
