//! Which numbers are squares in which field.

use proptest::prelude::*;

use crate::algebra::element::Element;
use crate::algebra::limits::Limits;
use crate::algebra::tower::Tower;

fn whole(n: i64) -> Element {
    Element::whole(n.into())
}

/// Q(√n) for each of some numbers, none of which makes another's root.
fn adjoined(radicands: &[i64]) -> Tower {
    let mut tower = Tower::new(Limits::default());
    for &n in radicands {
        tower.root(&whole(n)).unwrap();
    }
    assert_eq!(tower.height(), radicands.len());
    tower
}

/// The same tower, in which nothing is refuted by primes.
fn without_maps(mut tower: Tower) -> Tower {
    tower.embeddings.iter_mut().for_each(Vec::clear);
    tower
}

fn is_square(tower: &Tower, x: &Element) -> bool {
    let root = tower.square_root(x).unwrap();
    if let Some(root) = &root {
        assert_eq!(tower.mul(root, root).as_ref(), Ok(x));
    }
    root.is_some()
}

/// a + b√d for the first radical.
fn with_first(a: i64, b: i64) -> Element {
    whole(a).add(&whole(b).times_radical(0))
}

/// (field, number, whether it is a square): the classes of √2, √3 and √6 make
/// a square; a prime ramifies where it divides a radicand only.
#[test]
fn rationals() {
    let table: [(&[i64], i64, bool); 10] = [
        (&[], 9, true),
        (&[], 2, false),
        (&[2], 8, true),
        (&[2], 3, false),
        (&[2, 3], 6, true),
        (&[2, 3], 24, true),
        (&[2, 3], 5, false),
        (&[2, 3], -1, false),
        (&[6, 10], 15, true),
        (&[6, 10, 7], 105, true),
    ];
    for (field, number, square) in table {
        for tower in [adjoined(field), without_maps(adjoined(field))] {
            assert_eq!(
                is_square(&tower, &whole(number)),
                square,
                "{number} in {field:?}"
            );
        }
    }
}

/// 1/2 = (√2/2)², 3/2 = (√6/2)²: primes must not refute them.
#[test]
fn fractions() {
    let table = [
        (2, [1, 2], true),
        (6, [3, 2], true),
        (2, [1, 3], false),
        (6, [1, 2], false),
    ];
    for (field, [n, d], square) in table {
        let number = Element::new(vec![n.into()], d.into());
        for tower in [adjoined(&[field]), without_maps(adjoined(&[field]))] {
            assert_eq!(is_square(&tower, &number), square, "{n}/{d} in Q(√{field})");
        }
    }
}

/// 3 + 2√2 = (1 + √2)². 2 + √2 has the norm 2, which is no square. 5 + 2√6 is
/// (√2 + √3)², and no square in Q(√6): (5 ± 1)/2 are none there.
#[test]
fn irrationals() {
    let table: [(&[i64], [i64; 2], bool); 8] = [
        (&[2], [3, 2], true),
        (&[2], [3, -2], true),
        (&[2], [2, 1], false),
        (&[2], [0, 1], false),
        (&[6], [5, 2], false),
        (&[6, 2], [5, 2], true),
        (&[6, 5], [5, 2], false),
        (&[2, 3], [9, 6], true),
    ];
    for (field, [a, b], square) in table {
        for tower in [adjoined(field), without_maps(adjoined(field))] {
            let number = with_first(a, b);
            assert_eq!(
                is_square(&tower, &number),
                square,
                "{a} + {b}√ in {field:?}"
            );
        }
    }
}

/// Q(√(2 + √2)) holds √2 (2 + √2) and √(2 - √2), for their product is √2.
#[test]
fn a_cyclic_field_of_degree_four() {
    let mut tower = adjoined(&[2]);
    tower.root(&with_first(2, 1)).unwrap();
    assert_eq!(tower.height(), 2);
    for tower in [without_maps(adjoined(&[2])), adjoined(&[2])] {
        assert!(!is_square(&tower, &with_first(2, -1)));
    }
    assert!(is_square(&tower, &with_first(2, -1)));
    assert!(!is_square(&tower, &whole(3)));
}

fn element(length: usize) -> impl Strategy<Value = Element> {
    (prop::collection::vec(-9..10_i64, length), 1..9_i64).prop_map(|(numbers, d)| {
        Element::new(numbers.into_iter().map(Into::into).collect(), d.into())
    })
}

proptest! {
    /// And the primes do not refute what they must not.
    #[test]
    fn every_square_is_found(a in element(8), primes in any::<bool>()) {
        for nested in [false, true] {
            let mut tower = adjoined(&[2, 5]);
            let next = if nested { with_first(1, 1) } else { whole(7) };
            tower.root(&next).unwrap();
            let square = tower.mul(&a, &a).unwrap();
            prop_assert!(tower.embeddings[3].len() > 3);
            for map in &tower.embeddings[3] {
                prop_assert!(!map.refutes_square(&square));
            }
            let tower = if primes { tower } else { without_maps(tower) };
            prop_assert!(is_square(&tower, &square));
        }
    }

    /// The fast answer is the slow one, over a radical of a radical too.
    #[test]
    fn primes_change_no_answer(a in element(4)) {
        for nested in [false, true] {
            let field = || {
                let mut tower = adjoined(&[2]);
                let next = if nested { with_first(2, 1) } else { whole(3) };
                tower.root(&next).unwrap();
                tower
            };
            let fast = is_square(&field(), &a);
            prop_assert_eq!(fast, is_square(&without_maps(field()), &a));
        }
    }

    /// Multiplied by a radicand that is a square of the next field only.
    #[test]
    fn what_becomes_a_square(a in element(4)) {
        let lower = adjoined(&[2, 3]);
        let mut upper = adjoined(&[2, 3]);
        let radicand = with_first(5, 1);
        upper.root(&radicand).unwrap();
        let number = lower.mul(&lower.mul(&a, &a).unwrap(), &radicand).unwrap();
        prop_assert_eq!(is_square(&lower, &number), a.is_zero());
        prop_assert!(is_square(&upper, &number));
    }
}
