//! Graphs deeper than any stack.

use std::cmp::Ordering::{Equal, Greater};

use carom::algebra::Expression;
use carom::scalar::Scalar;

use super::{root, whole};

const LENGTH: usize = 1_000_000;

/// x → (x + 1) / √2, which tends to 1 + √2.
fn chain(length: usize) -> Expression {
    let (one, half) = (whole(1), root(2));
    (0..length).fold(root(3), |x, _| (x + &one) / &half)
}

/// Built, asked, and dropped: from the middle too.
#[test]
fn a_long_chain() {
    let middle = chain(LENGTH / 4);
    let end = (0..LENGTH / 4).fold(middle.clone(), |x, _| (x + &root(5)).sqrt());
    assert_eq!(end.sign(), Ok(Greater));
    drop(end);
    assert_eq!(middle.compare(&whole(2)), Ok(Greater), "near 1 + √2");
}

/// What is done and undone, in an order that hides it.
fn undone(length: usize) -> Expression {
    let two = root(2);
    let there = (0..length).fold(root(3), |x, _| x * &two + &two);
    let back = (0..length).fold(there, |x, _| (x - &two) / &two);
    back - root(3)
}

/// The enclosure does not tell, so the whole chain is taken to its form. What
/// is too long for a proof is not guessed.
#[test]
fn a_long_chain_is_undone() {
    assert_eq!(undone(1000).sign(), Ok(Equal));
    let long = undone(LENGTH / 20).sign();
    assert!(long == Ok(Equal) || long.is_err());
}
