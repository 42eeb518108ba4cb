//! A first look at a number with more bits, as it stands: what is only nearly
//! zero mostly shows its sign, before any normal form is made.

use std::cmp::Ordering;
use std::collections::HashMap;

use super::expression::Expression;
use crate::scalar::{Exact, Scalar};

/// The bits of such looks; each takes a few times those of the one before.
const BITS: [u32; 2] = [512, 2048];

/// The sign, if it shows.
pub(super) fn sign(number: &Expression) -> Option<Ordering> {
    let wanted = BITS.into_iter().filter(|&bits| bits > number.limits().bits);
    wanted
        .map(|bits| evaluate(number, bits).sign().ok())
        .find(Option::is_some)?
}

/// Encloses a number with so many bits in every operation.
fn evaluate(root: &Expression, bits: u32) -> Exact {
    let mut values: HashMap<usize, Exact> = HashMap::new();
    let mut pending = vec![root];
    while let Some(&node) = pending.last() {
        let before = pending.len();
        if !values.contains_key(&node.address()) {
            let operands = node.operation().operands().into_iter().flatten();
            let missing = operands.filter(|operand| !values.contains_key(&operand.address()));
            pending.extend(missing);
            if pending.len() == before {
                let value = |operand: &Expression| values[&operand.address()].clone();
                values.insert(node.address(), node.operation().value(value, bits));
            }
        }
        if pending.len() == before {
            pending.pop();
        }
    }
    values
        .remove(&root.address())
        .unwrap_or_else(|| root.to_exact())
}
