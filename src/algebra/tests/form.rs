//! What the normal form alone knows to be equal.

use proptest::prelude::*;

use super::{expression, normal, root, whole};
use crate::algebra::Expression;
use crate::algebra::term::NoForm;
use crate::scalar::Scalar;

/// Whether the difference has the form of zero.
fn same(a: &Expression, b: &Expression) -> bool {
    normal(&(a.clone() - b)).goal.is_zero()
}

#[test]
fn rules() {
    let (x, y) = (root(2) + root(3), root(5) - whole(7));
    let two = whole(2);
    let table = [
        (x.clone() + &y, y.clone() + &x),
        (x.clone() * &y, y.clone() * &x),
        (x.clone() - &y, -(y.clone() - &x)),
        (root(8), two.clone() * root(2)),
        (root(2) * root(2), two.clone()),
        ((x.clone() * &two).square(), whole(4) * x.square()),
        (x.square().sqrt(), x.clone()),
        ((x.clone() - whole(9)).square().sqrt(), whole(9) - &x),
        ((x.square() * whole(12)).sqrt(), two.clone() * root(3) * &x),
        (x.clone() / &y * &y, x.clone()),
        (two.clone() / root(2), root(2)),
        ((whole(1) / whole(3)).sqrt(), root(3) / whole(3)),
        ((x.clone() + &y) - &x, y.clone()),
        (x.sqrt() * x.sqrt() * &y, x.clone() * &y),
        (
            whole(6) * &x + whole(4) * &y,
            two * (whole(3) * &x + whole(2) * &y),
        ),
    ];
    for (place, (a, b)) in table.iter().enumerate() {
        assert!(same(a, b), "rule {place}");
    }
    assert!(!same(&x, &y));
}

#[test]
fn what_is_no_number_has_no_form() {
    let zero = root(2) * root(2) - whole(2);
    let undefined = [
        whole(1) / whole(0),
        root(-1),
        whole(1) / (root(8) - whole(2) * root(2)),
        (whole(1) - root(2)).sqrt() + whole(1),
    ];
    for number in undefined {
        let form = super::Normal::of(&number, 256);
        assert_eq!(form.map(|normal| normal.goal), Err(NoForm::Undefined));
        assert!(number.sign().is_err());
    }
    assert!(zero.sign().is_ok());
}

proptest! {
    #[test]
    fn rearranging_changes_no_form(a in expression(), b in expression(), c in expression()) {
        let add = |x: &Expression, y: &Expression| x.clone() + y;
        let mul = |x: &Expression, y: &Expression| x.clone() * y;
        prop_assert!(same(&add(&add(&a, &b), &c), &add(&b, &add(&c, &a))));
        prop_assert!(same(&mul(&mul(&a, &b), &c), &mul(&b, &mul(&c, &a))));
        prop_assert!(same(&(a.clone() - &b).square(), &(b.clone() - &a).square()));
    }

    /// The form is the number: both enclose the same value.
    #[test]
    fn forms_keep_the_value(a in expression(), b in expression()) {
        let number = (a.square() + whole(1)).sqrt() - a * &b + &b;
        let normal = normal(&number);
        let needed = normal.graph.needed(&normal.goal);
        let value = super::super::evaluate::number(&normal.graph, &needed, &normal.goal, 500);
        let ((lo, hi), (from, to)) = (value.enclosure().unwrap(), number.enclosure().unwrap());
        prop_assert!(lo <= to && from <= hi);
    }
}
