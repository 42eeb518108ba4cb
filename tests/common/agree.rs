//! When an exact number is the expected one.

use carom::run::Outcome;
use carom::scalar::{Exact, Scalar};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::{name, numbers, ratio, tolerance};

/// The value of a number that must be held as a rational.
#[track_caller]
pub(crate) fn rational(number: &Exact) -> BigRational {
    let (lo, hi) = number.enclosure().expect("exact arithmetic encloses");
    assert_eq!(lo, hi, "not a rational");
    lo
}

/// Asserts that a number is `p + q √n`, by a narrow enclosure of the root
/// alone, squared.
#[track_caller]
pub(crate) fn assert_surd(number: &Exact, [p, q]: [&str; 2], n: &str) {
    let (p, q, n) = (ratio(p), ratio(q), ratio(n));
    let (lo, hi) = number.enclosure().expect("exact arithmetic encloses");
    let ends = [lo, hi].map(|end| (end - &p) / &q);
    let [low, high] = [ends.iter().min().unwrap(), ends.iter().max().unwrap()];
    assert!(
        !low.is_negative() && low * low <= n && n <= high * high,
        "{number:?} is not {p} + {q} root {n}"
    );
    assert!(high - low < narrow(), "{number:?} is vague");
}

/// Asserts that a number is this rational, as far as a narrow enclosure tells.
#[track_caller]
pub(crate) fn assert_encloses(number: &Exact, expected: &str) {
    let (lo, hi) = number.enclosure().expect("exact arithmetic encloses");
    let expected = ratio(expected);
    assert!(
        lo <= expected && expected <= hi && hi - lo < narrow(),
        "{number:?} is not {expected}"
    );
}

/// Whether two numbers can be the same: their narrow enclosures overlap.
pub(crate) fn agree(one: &Exact, other: &Exact) -> bool {
    contains_zero(&(one.clone() - other))
}

/// Whether a number is zero as far as a narrow enclosure tells.
pub(crate) fn contains_zero(number: &Exact) -> bool {
    let (lo, hi) = number.enclosure().expect("exact arithmetic encloses");
    lo <= BigRational::zero() && hi >= BigRational::zero() && hi - lo < narrow()
}

/// The distance of two numbers that both are known to many digits.
pub(crate) fn distance(one: &Exact, other: &Exact) -> f64 {
    let (lo, hi) = (one.clone() - other).enclosure().unwrap();
    lo.abs().max(hi.abs()).to_f64().unwrap()
}

fn narrow() -> BigRational {
    BigRational::from_float(tolerance::ENCLOSURE).expect("a finite tolerance")
}

/// Asserts that a log has these impacts at these rational times, and no
/// others.
#[track_caller]
pub(crate) fn assert_log(outcome: &Outcome<Exact>, expected: &[(&str, &str)]) {
    let found = outcome.impacts.iter();
    let found: Vec<_> = found
        .map(|impact| (rational(&impact.time), name(impact)))
        .collect();
    let expected: Vec<_> = expected
        .iter()
        .map(|(time, name)| (ratio(time), (*name).to_owned()))
        .collect();
    assert_eq!(found, expected);
}

/// Asserts that the discs end like this: position, then velocity.
#[track_caller]
pub(crate) fn assert_end(outcome: &Outcome<Exact>, expected: &[[&str; 4]]) {
    let found = outcome.end.iter();
    let found: Vec<_> = found
        .map(|disc| numbers(disc).map(|n| rational(&n)))
        .collect();
    let expected: Vec<_> = expected.iter().map(|disc| disc.map(ratio)).collect();
    assert_eq!(found, expected);
}
