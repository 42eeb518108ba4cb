//! The arithmetic of a tower against enclosures, and against its own laws.

use std::cmp::Ordering::{Equal, Greater, Less};

use num_bigint::BigInt;
use proptest::prelude::*;

use crate::algebra::element::Element;
use crate::algebra::evaluate::whole;
use crate::algebra::limits::Limits;
use crate::algebra::tower::{Stop, Tower};
use crate::scalar::{Exact, Scalar};

const BITS: u32 = 300;

/// Q(√2)(√3)(√(1 + √2)), and its radicals as enclosures.
fn tower() -> (Tower, [Exact; 3]) {
    let mut tower = Tower::new(Limits::default());
    let one = Element::whole(1.into());
    let sqrt2 = tower.root(&Element::whole(2.into())).unwrap();
    tower.root(&Element::whole(3.into())).unwrap();
    tower.root(&one.add(&sqrt2)).unwrap();
    assert_eq!(tower.height(), 3);
    let enclose = |n: i32| whole(&n.into(), BITS);
    let sqrt2 = enclose(2).sqrt();
    let nested = (enclose(1) + &sqrt2).sqrt();
    (tower, [sqrt2, enclose(3).sqrt(), nested])
}

/// The sum of the coefficients times products of radicals, term by term.
fn enclose(x: &Element, radicals: &[Exact; 3]) -> Exact {
    let product = |index: usize| {
        let within = radicals
            .iter()
            .enumerate()
            .filter(|(bit, _)| index >> bit & 1 == 1);
        within.fold(whole(&1.into(), BITS), |product, (_, radical)| {
            product * radical
        })
    };
    let terms = x.numerator.iter().enumerate();
    let sum = terms.fold(whole(&0.into(), BITS), |sum, (index, n)| {
        sum + whole(n, BITS) * product(index)
    });
    sum / whole(&x.denominator, BITS)
}

fn agree(a: &Exact, b: &Exact) -> bool {
    let (Some((a, b)), Some((c, d))) = (a.enclosure(), b.enclosure()) else {
        return false;
    };
    a <= d && c <= b
}

fn element() -> impl Strategy<Value = Element> {
    let sizes = prop_oneof![Just(1_usize), Just(2), Just(4), Just(8)];
    let numbers = sizes.prop_flat_map(|size| prop::collection::vec(-20..20_i32, size));
    (numbers, 1..30_i32)
        .prop_map(|(n, d)| Element::new(n.into_iter().map(BigInt::from).collect(), d.into()))
}

#[test]
fn what_is_no_number_is_found_out() {
    let (mut tower, _) = tower();
    let zero = Element::whole(0.into());
    assert_eq!(tower.inverse(&zero), Err(Stop::Undefined));
    assert_eq!(
        tower.root(&Element::whole((-2).into())),
        Err(Stop::Undefined)
    );
    assert_eq!(tower.root(&zero), Ok(zero));
}

#[test]
fn radicals_and_bits_are_limited() {
    let limits = Limits {
        radicals: 2,
        element_bits: 100,
        ..Limits::default()
    };
    let mut tower = Tower::new(limits);
    let root = |tower: &mut Tower, n: i32| tower.root(&Element::whole(n.into()));
    let sqrt2 = root(&mut tower, 2).unwrap();
    assert!(root(&mut tower, 3).is_ok());
    assert!(root(&mut tower, 6).is_ok(), "no new radical");
    assert_eq!(root(&mut tower, 5), Err(Stop::Budget));
    let sum = sqrt2.add(&Element::whole(1.into()));
    assert!(tower.power(&sum, 20).is_ok());
    assert_eq!(tower.power(&sum, 100), Err(Stop::Budget));
}

/// By hand: √12 = 2 √3, √(1/2) = √2 / 2.
#[test]
fn square_factors_leave_the_radical() {
    let mut tower = Tower::new(Limits::default());
    let twelve = tower.root(&Element::whole(12.into())).unwrap();
    assert_eq!(twelve, Element::new(vec![0.into(), 2.into()], 1.into()));
    assert_eq!(tower.radicand(0), Element::whole(3.into()));
    let half = tower.root(&Element::new(vec![1.into()], 2.into())).unwrap();
    let halved = [0, 0, 1, 0].map(BigInt::from);
    assert_eq!(half, Element::new(halved.to_vec(), 2.into()));
}

proptest! {
    #[test]
    fn operations_are_those_of_numbers(a in element(), b in element()) {
        let (tower, radicals) = tower();
        let [x, y] = [&a, &b].map(|n| enclose(n, &radicals));
        prop_assert!(agree(&enclose(&a.add(&b), &radicals), &(x.clone() + &y)));
        prop_assert!(agree(&enclose(&a.sub(&b), &radicals), &(x.clone() - &y)));
        prop_assert!(agree(&enclose(&tower.mul(&a, &b).unwrap(), &radicals), &(x.clone() * &y)));
        if !b.is_zero() {
            let quotient = tower.mul(&a, &tower.inverse(&b).unwrap()).unwrap();
            prop_assert!(agree(&enclose(&quotient, &radicals), &(x / y)));
        }
    }

    #[test]
    fn inverses_give_one(a in element()) {
        let (tower, _) = tower();
        if !a.is_zero() {
            let one = tower.mul(&a, &tower.inverse(&a).unwrap()).unwrap();
            prop_assert_eq!(one, Element::whole(1.into()));
            let power = tower.mul(&tower.power(&a, 3).unwrap(), &tower.power(&a, -2).unwrap());
            prop_assert_eq!(power, Ok(a));
        }
    }

    #[test]
    fn signs_are_those_of_enclosures(a in element()) {
        let (tower, radicals) = tower();
        match enclose(&a, &radicals).sign() {
            Ok(sign) => prop_assert_eq!(tower.sign(&a), Ok(sign)),
            Err(_) => prop_assert!(false, "300 bits tell the sign of a short number"),
        }
        prop_assert_eq!(a.is_zero(), tower.sign(&a) == Ok(Equal));
        prop_assert_eq!(tower.sign(&a.negated()), tower.sign(&a).map(|sign| sign.reverse()));
    }

    #[test]
    fn roots_are_positive_and_square_back(a in element()) {
        let (mut tower, radicals) = tower();
        let square = tower.mul(&a, &a).unwrap();
        let root = tower.root(&square).unwrap();
        prop_assert_eq!(tower.height(), 3);
        let size = if enclose(&a, &radicals).sign() == Ok(Less) { a.negated() } else { a.clone() };
        prop_assert_eq!(root, size);
        if tower.sign(&a) == Ok(Greater) {
            let root = tower.root(&a).unwrap();
            prop_assert_eq!(tower.mul(&root, &root), Ok(a));
        }
    }
}
