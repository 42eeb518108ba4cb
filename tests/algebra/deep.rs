//! Graphs deeper than any stack.

use std::cmp::Ordering::{Equal, Greater};

use carom::algebra::Expression;
use carom::scalar::Scalar;

use crate::{root, whole};

const LENGTH: usize = 1_000_000;

/// x → (x + 1) / √2 has no rational value, and stays between 1 and 1 + √2...
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
    assert_eq!(middle.compare(&whole(2)), Ok(Greater), "it tends to 1 + √2");
}

/// The enclosure does not tell, so the whole chain is taken to its form.
#[test]
fn a_long_chain_is_undone() {
    let mut x = root(3);
    let two = root(2);
    for _ in 0..LENGTH / 4 {
        x = x * &two + &two;
    }
    for _ in 0..LENGTH / 4 {
        x = (x - &two) / &two;
    }
    let difference = x.clone() - root(3);
    let decided = difference.sign();
    assert!(decided == Ok(Equal) || decided.is_err());
}
