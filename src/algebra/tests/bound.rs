//! The separation bound against the tower: neither knows of the other.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};
use proptest::prelude::*;

use super::{expression, normal, root, whole};
use crate::algebra::Expression;
use crate::algebra::ascent::Ascent;
use crate::algebra::bound::separation_bits;
use crate::algebra::evaluate;
use crate::algebra::limits::Limits;
use crate::scalar::Scalar;

/// Whether the tower holds the number to be zero.
fn is_zero_in_tower(number: &Expression) -> bool {
    let normal = normal(number);
    let needed = normal.graph.needed(&normal.goal);
    let (ascent, end) = Ascent::of(&normal.graph, &needed, Limits::default());
    end.unwrap();
    ascent.is_zero(&normal.goal).unwrap()
}

fn bound(number: &Expression) -> u32 {
    let normal = normal(number);
    let needed = normal.graph.needed(&normal.goal);
    let bits = separation_bits(&normal.graph, &needed, &normal.goal).unwrap();
    bits.try_into().unwrap()
}

/// The ends of the magnitude, to well below the bound.
fn magnitude(number: &Expression) -> [BigRational; 2] {
    let normal = normal(number);
    let needed = normal.graph.needed(&normal.goal);
    let bits = 2 * bound(number) + 128;
    let value = evaluate::number(&normal.graph, &needed, &normal.goal, bits);
    let (lo, hi) = value.enclosure().unwrap();
    if lo.is_negative() && hi.is_positive() {
        [BigRational::default(), hi.max(-lo)]
    } else {
        let ends = [lo.abs(), hi.abs()];
        [
            ends[0].clone().min(ends[1].clone()),
            ends[0].clone().max(ends[1].clone()),
        ]
    }
}

/// Below the bound exactly if the tower says zero, else not below it.
fn check(number: &Expression) {
    let least = BigRational::new(BigInt::one(), BigInt::one() << bound(number));
    let [lower, upper] = magnitude(number);
    if is_zero_in_tower(number) {
        assert!(upper < least);
    } else {
        assert!(lower >= least);
    }
}

/// By hand, where each logarithm is rounded up to the next sixteenth, and that
/// of 1 to a whole one. √2 - 1 has u = 1 + √2, l = 1, D = 2: 21/16 + 1/16.
/// √2 - √3 has u = √2 + √3, D = 4: 3 × 27/16 + 1/16. 1/(√2 - 1) has u = 1 and
/// l = 1 + √2. The root of 1 more than that, D = 4, has u = √((2 + √2)(1 + √2))
/// = 2.871 and l = 1 + √2: 3 × 25/16 + 21/16.
#[test]
fn bounds_by_hand() {
    assert_eq!(bound(&(root(2) - whole(1))), 2);
    assert_eq!(bound(&(root(2) - root(3))), 6);
    let inverse = whole(1) / (root(2) - whole(1));
    assert_eq!(bound(&inverse), 2);
    assert_eq!(bound(&(inverse + whole(1)).sqrt()), 6);
}

#[test]
fn constructed_zeros() {
    let zeros = [
        root(2) + root(3) - (whole(5) + whole(2) * root(6)).sqrt(),
        (root(2) + root(3)).square() - whole(5) - whole(2) * root(6),
        (whole(3) + whole(2) * root(2)).sqrt() - whole(1) - root(2),
        whole(1) / (root(3) - root(2)) - root(3) - root(2),
    ];
    for zero in zeros {
        assert!(is_zero_in_tower(&zero));
        check(&zero);
        check(&(zero + whole(1) / whole(1_000_000_007)));
    }
}

proptest! {
    #[test]
    fn both_decide_alike(a in expression(), b in expression()) {
        for number in [a.clone() - &b, a.clone() * &b - b.clone() * (a.clone() - whole(1))] {
            // Beyond, the tower is not what is slow.
            if bound(&number) < 20_000 {
                check(&number);
            }
        }
    }

    #[test]
    fn signs_are_those_of_the_tower(a in expression(), b in expression()) {
        let difference = a.clone() - &b;
        let zero = is_zero_in_tower(&difference);
        prop_assert_eq!(difference.sign().map(Ordering::is_eq), Ok(zero));
    }
}
