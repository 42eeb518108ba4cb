//! Against Sturm's theorem, and against numbers whose powers are known.

use std::cmp::Ordering::{Equal, Greater, Less};

use num_rational::BigRational;
use proptest::prelude::*;

use super::Algebraic;
use crate::roots::tests::sturm::{self, Coefficients, ratio};
use crate::roots::tests::{dyadic, linear, power_of_two, product};
use crate::scalar::{Dyadic, Exact, Scalar};

/// The square root of a positive number, which 'number - t²' descends to.
fn root(number: BigRational) -> Algebraic {
    descent(&[number, ratio(0, 1), ratio(-1, 1)])
}

fn descent(f: &[BigRational]) -> Algebraic {
    Algebraic::first_descent(&dyadic(f)).unwrap().time
}

fn number(number: BigRational) -> Dyadic {
    dyadic(&[number]).0[0].clone()
}

/// a + b t².
fn with_square(a: BigRational, b: BigRational) -> crate::roots::Polynomial<Dyadic> {
    dyadic(&[a, ratio(0, 1), b])
}

#[test]
fn signs_at_a_root() {
    let two = root(ratio(2, 1));
    let tiny = power_of_two(-500);
    for (constant, sign) in [(-tiny.clone(), Less), (ratio(0, 1), Equal), (tiny, Greater)] {
        let beside = with_square(ratio(-2, 1) + &constant, ratio(1, 1));
        assert_eq!(two.sign_of(&beside), sign);
        // (t - 3)² - 2 + c at √2 + 3.
        let moved = product(&[linear(ratio(3, 1)), linear(ratio(3, 1))]);
        let mut moved = dyadic(&moved);
        moved.0[0] = moved.0[0].clone().add(&number(constant - ratio(2, 1)));
        assert_eq!(two.translated(&Dyadic::from(3)).sign_of(&moved), sign);
    }
    assert_eq!(
        two.sign_of(&dyadic(&[
            ratio(0, 1),
            ratio(-2, 1),
            ratio(0, 1),
            ratio(1, 1)
        ])),
        Equal
    );
    assert_eq!(two.sign_of(&dyadic(&[])), Equal);
    assert_eq!(two.sign_of(&dyadic(&[ratio(-1, 4)])), Less);
}

#[test]
fn close_numbers_are_ordered() {
    let two = root(ratio(2, 1));
    for n in [30, 100, 600, 2000] {
        let above = root(ratio(2, 1) + power_of_two(-n));
        assert_eq!(two.order(&above), Less);
        assert_eq!(above.order(&two), Greater);
        // By their difference, which is above 2^-n / 4 and below 2^-n.
        assert_eq!(
            two.translated(&number(power_of_two(-n - 2))).order(&above),
            Less
        );
        assert_eq!(
            two.translated(&number(power_of_two(-n))).order(&above),
            Greater
        );
    }
    // (t - 1)² = 2 has the same zero but for 1, and so has (2 - t²)(t² - t + 1).
    let moved = descent(&[ratio(1, 1), ratio(2, 1), ratio(-1, 1)]);
    assert_eq!(two.translated(&Dyadic::from(1)).order(&moved), Equal);
    assert_eq!(moved.translated(&Dyadic::from(-1)).order(&two), Equal);
    let factors = [
        vec![ratio(2, 1), ratio(0, 1), ratio(-1, 1)],
        vec![ratio(1, 1), ratio(-1, 1), ratio(1, 1)],
    ];
    assert_eq!(descent(&product(&factors)).order(&two), Equal);
}

#[test]
fn order_to_dyadic_numbers() {
    let three = root(ratio(9, 1));
    let tiny = power_of_two(-700);
    assert_eq!(three.order_to(&Dyadic::from(3)), Equal);
    assert_eq!(three.order_to(&number(ratio(3, 1) + &tiny)), Less);
    assert_eq!(three.order_to(&number(ratio(3, 1) - &tiny)), Greater);
    let moved = three.translated(&Dyadic::from(-5));
    assert_eq!(moved.order_to(&Dyadic::from(-2)), Equal);
    assert_eq!(moved.order_to(&number(ratio(-2, 1) + tiny)), Less);
    assert_eq!(moved.to_f64(), -2.0);
}

/// The square of √2 and of numbers near it, half way between binary64 numbers
/// and beside.
#[test]
fn ties_go_to_even() {
    let (half, unit) = (ratio(1, 2), power_of_two(-53));
    let upper = 1.0 + 2.0 * f64::EPSILON;
    let around = |constant: i64| with_square(&unit * ratio(constant, 1), half.clone());
    let (two, tiny) = (root(ratio(2, 1)), power_of_two(-300));
    let [below, above] = [ratio(2, 1) - &tiny, ratio(2, 1) + tiny].map(root);
    assert_eq!(two.value_of(&around(0)), 1.0);
    assert_eq!(
        [&below, &two, &above].map(|t| t.value_of(&around(1))),
        [1.0, 1.0, 1.0 + f64::EPSILON]
    );
    assert_eq!(
        [&below, &two, &above].map(|t| t.value_of(&around(3))),
        [1.0 + f64::EPSILON, upper, upper]
    );
    let negative = with_square(-unit, -half);
    assert_eq!(two.value_of(&negative), -1.0);
    assert_eq!(above.value_of(&negative), -1.0 - f64::EPSILON);
    let zero = two.value_of(&with_square(ratio(-2, 1), ratio(1, 1)));
    assert_eq!(zero.to_bits(), 0);
}

#[test]
fn extremes_round_as_they_should() {
    let two = root(ratio(2, 1));
    let times = |factor: BigRational| two.value_of(&with_square(ratio(0, 1), factor));
    assert_eq!(times(power_of_two(1022)), 2.0_f64.powi(1023));
    assert_eq!(times(power_of_two(1023)), f64::INFINITY);
    let limit = (power_of_two(1024) - power_of_two(970)) / ratio(2, 1);
    assert_eq!(times(limit.clone()), f64::INFINITY);
    assert_eq!(times(&limit - ratio(1, 1)), f64::MAX);
    assert_eq!(times(-limit), f64::NEG_INFINITY);
    let least = f64::from_bits(1);
    assert_eq!(times(power_of_two(-1076)).to_bits(), 0);
    assert_eq!(times(-power_of_two(-1076)).to_bits(), 0);
    assert_eq!(times(power_of_two(-1075)), least);
    assert_eq!(times(ratio(3, 1) * power_of_two(-1076)), 2.0 * least);
}

/// (t - 1)² (t - 2) (t - 3) touches zero from above, falls and rises; what is
/// opposite touches it from below, rises and falls.
#[test]
fn all_descents_are_in_order() {
    let factors = [1, 1, 2, 3].map(|zero| linear(ratio(zero, 1)));
    for (sign, expected) in [(1, &[(1.0, true), (2.0, false)][..]), (-1, &[(3.0, false)])] {
        let mut factors = factors.to_vec();
        factors.push(vec![ratio(sign, 1)]);
        let found = Algebraic::descents(&dyadic(&product(&factors))).into_iter();
        let found: Vec<_> = found
            .map(|found| (found.time.to_f64(), found.graze))
            .collect();
        assert_eq!(found, expected);
    }
}

#[test]
fn even_zeros_are_grazes() {
    // (8 - t²)².
    let square = [
        vec![ratio(8, 1), ratio(0, 1), ratio(-1, 1)],
        vec![ratio(8, 1), ratio(0, 1), ratio(-1, 1)],
    ];
    let f = dyadic(&product(&square));
    let found = Algebraic::first_descent(&f).unwrap();
    assert!(found.graze);
    assert_eq!(found.time.order(&root(ratio(8, 1))), Equal);
    // A fourfold zero, and a triple one.
    for (times, even) in [(4, true), (3, false)] {
        let mut factors = vec![linear(ratio(3, 4)); times];
        factors.push(vec![ratio(if even { 5 } else { -5 }, 1)]);
        let found = Algebraic::first_descent(&dyadic(&product(&factors))).unwrap();
        assert_eq!((found.graze, found.time.to_f64()), (even, 0.75));
    }
}

fn factor() -> impl Strategy<Value = Coefficients> {
    let small = || (-6..7_i64).prop_map(|n| ratio(n, 2));
    prop_oneof![
        (1..9_i64).prop_map(|n| linear(ratio(n, 2))),
        (1..5_i64).prop_map(|n| vec![ratio(-n, 1), ratio(0, 1), ratio(1, 1)]),
        // 1 + √n, which is √n and an offset.
        (1..5_i64).prop_map(|n| vec![ratio(1 - n, 1), ratio(-2, 1), ratio(1, 1)]),
        prop::array::uniform3(small()).prop_map(|numbers| numbers.to_vec()),
    ]
}

fn polynomial() -> impl Strategy<Value = Coefficients> {
    let binary = prop::collection::vec(-1.0..1.0_f64, 5).prop_map(|numbers| {
        numbers
            .into_iter()
            .map(|number| BigRational::from_float(number).unwrap())
            .collect()
    });
    let factors = [factor(), factor()].prop_map(|factors| product(&factors));
    prop_oneof![3 => factors, 1 => binary]
}

const WIDTH: usize = 120;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(50))]

    /// Small coefficients keep zeros that differ by far more than what Sturm's
    /// theorem leaves.
    #[test]
    fn order_is_that_of_enclosures(
        [f, g] in prop::array::uniform2(polynomial()),
        offsets in prop::array::uniform2(-2..3_i64),
    ) {
        let solved = [&f, &g].map(|f| Algebraic::first_descent(&dyadic(f)));
        let expected = [&f, &g].map(|f| sturm::descent(f, WIDTH));
        for (solved, expected) in solved.iter().zip(&expected) {
            prop_assert_eq!(solved.as_ref().map(|found| found.graze), expected.as_ref().map(|(_, graze)| *graze));
        }
        let ([Some(one), Some(other)], [Some((a, _)), Some((b, _))]) = (solved, expected) else {
            return Ok(());
        };
        let offsets = offsets.map(|offset| ratio(offset, 2));
        let [one, other] = [(one, 0), (other, 1)].map(|(found, n)| found.time.translated(&number(offsets[n].clone())));
        let [[low, high], [from, to]] = [(a, 0), (b, 1)].map(|(ends, n)| ends.map(|end| end + &offsets[n]));
        let order = if high < from { Less } else if low > to { Greater } else { Equal };
        prop_assert_eq!(one.order(&other), order);
        prop_assert_eq!(other.order(&one), order.reverse());
        prop_assert_eq!(one.order(&one), Equal);
        let [below, above] = [&low, &high].map(|end| one.order_to(&number((end * power_of_two(400)).round() / power_of_two(400))));
        prop_assert!(below.is_ge() && above.is_le());
        let bounds = one.hull();
        prop_assert!(BigRational::from_float(bounds.lo()).unwrap() <= high);
        prop_assert!(BigRational::from_float(bounds.hi()).unwrap() >= low);
    }

    #[test]
    fn values_are_rounded_to_nearest(
        f in polynomial(),
        place in prop::array::uniform3(-4.0..4.0_f64),
        offset in -4..4_i64,
    ) {
        let Some(([low, high], _)) = sturm::descent(&f, WIDTH) else {
            return Ok(());
        };
        let offset = ratio(offset, 4);
        let time = descent(&f).translated(&number(offset.clone()));
        let nearest = |ratio: BigRational| Exact::from_rational(ratio, 64).to_f64();
        let polynomials = [vec![ratio(0, 1), ratio(1, 1)], place.map(|a| BigRational::from_float(a).unwrap()).to_vec()];
        for polynomial in polynomials {
            let [below, above] = [&low, &high].map(|end| nearest(sturm::value(&polynomial, &(end + &offset))));
            let value = time.value_of(&dyadic(&polynomial));
            // They differ where the value is a tie or zero.
            prop_assert!(below.min(above) <= value && value <= below.max(above));
            prop_assert!(below == above || value == 0.0 || (below - above).abs() <= f64::EPSILON * value.abs());
        }
    }
}
