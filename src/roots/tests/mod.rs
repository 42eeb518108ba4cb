//! Descents against chosen zeros, closed forms, and Sturm's theorem.

pub(super) mod sturm;

use std::cmp::Ordering::{Equal, Greater, Less};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

use super::algebraic::Algebraic;
use super::{Descent, Polynomial, Roots};
use crate::scalar::{Dyadic, Exact, Interval, Scalar};
use sturm::{Coefficients, ratio};

const BITS: u32 = 256;

pub(super) fn power_of_two(exponent: i32) -> BigRational {
    ratio(2, 1).pow(exponent)
}

/// The product of polynomials.
pub(super) fn product(factors: &[Coefficients]) -> Coefficients {
    let start = vec![ratio(1, 1)];
    factors.iter().fold(start, |product, factor| {
        let mut sum = vec![BigRational::zero(); product.len() + factor.len() - 1];
        for (i, a) in product.iter().enumerate() {
            for (j, b) in factor.iter().enumerate() {
                sum[i + j] += a * b;
            }
        }
        sum
    })
}

/// t - r.
pub(super) fn linear(root: BigRational) -> Coefficients {
    vec![-root, ratio(1, 1)]
}

fn coefficient(f: &[BigRational], power: usize) -> BigRational {
    f.get(power).cloned().unwrap_or_default()
}

pub(super) fn exact(f: &[BigRational]) -> Polynomial<Exact> {
    Polynomial(std::array::from_fn(|power| {
        Exact::from_rational(coefficient(f, power), BITS)
    }))
}

fn interval(f: &[BigRational]) -> Polynomial<Interval> {
    exact(f).map(Exact::hull)
}

fn binary64(f: &[BigRational]) -> Polynomial<f64> {
    exact(f).map(Exact::to_f64)
}

/// A polynomial whose coefficients are dyadic.
pub(super) fn dyadic(f: &[BigRational]) -> Polynomial<Dyadic> {
    Polynomial(std::array::from_fn(|power| {
        let ratio = coefficient(f, power);
        let exponent = ratio.denom().bits() as i64 - 1;
        assert_eq!(*ratio.denom(), BigInt::one() << exponent);
        Dyadic::new(ratio.numer().clone(), -exponent)
    }))
}

fn solved(f: &[BigRational]) -> Option<Descent<Exact>> {
    Exact::descent(&exact(f)).unwrap()
}

/// The descent, and whether a graze, at rational times.
fn rational(f: &[BigRational]) -> Option<(BigRational, bool)> {
    solved(f).map(|Descent { time, graze }| {
        assert!(time.is_rational(), "{time:?}");
        (time.enclosure().unwrap().0, graze)
    })
}

/// The first descent of what has these zeros, by counting them: the sign before a
/// zero turns with each zero that is not below it.
fn expected(zeros: &[BigRational], positive: bool) -> Option<(BigRational, bool)> {
    let mut places = zeros.to_vec();
    places.retain(Signed::is_positive);
    places.sort();
    let is_descent = |place: &BigRational| {
        let turns = zeros.iter().filter(|zero| *zero >= place).count();
        (turns % 2 == 0) == positive
    };
    let place = places.into_iter().find(is_descent)?;
    let even = zeros.iter().filter(|zero| **zero == place).count() % 2 == 0;
    Some((place, even))
}

/// Whether an enclosure holds a number x with this square, and is narrow.
fn is_root_of(time: &Exact, square: &BigRational) -> bool {
    let (low, high) = time.enclosure().unwrap();
    let narrow = (&high - &low) * power_of_two(BITS as i32 - 8) < high;
    narrow && &low * &low <= *square && *square <= &high * &high
}

#[test]
fn a_disc_falls_onto_a_disc() {
    // |(1, 4 - t²/2)|² = 2²: 4 - t²/2 = √3, t = √(2 (4 - √3)).
    let f = [
        ratio(13, 1),
        ratio(0, 1),
        ratio(-4, 1),
        ratio(0, 1),
        ratio(1, 4),
    ];
    let number = |n: i32| Exact::from_integer(n).with_bits(BITS);
    let time = ((number(4) - number(3).sqrt()) * number(2)).sqrt();
    let found = solved(&f).unwrap();
    assert!(!found.graze && found.time.accuracy().unwrap() >= i64::from(BITS) - 8);
    assert!((found.time - &time).sign().is_err());

    let near = f64::descent(&binary64(&f)).unwrap().unwrap();
    assert!((near.time - time.to_f64()).abs() <= f64::EPSILON * 2.0 && !near.graze);
    let bounds = Interval::descent(&interval(&f)).unwrap().unwrap().time;
    assert!(bounds.lo() <= time.hull().lo() && time.hull().hi() <= bounds.hi());
    assert!(bounds.hi() - bounds.lo() < 1e-14);
    let sharp = Algebraic::first_descent(&dyadic(&f)).unwrap().time;
    assert_eq!(sharp.to_f64(), time.to_f64());
}

#[test]
fn a_disc_falls_past_a_disc() {
    // |(2, 8 - t²/2)|² = 2²: it touches at t = 4, where 4 + (8 - 8)² = 4.
    let f = [
        ratio(64, 1),
        ratio(0, 1),
        ratio(-8, 1),
        ratio(0, 1),
        ratio(1, 4),
    ];
    assert_eq!(rational(&f), Some((ratio(4, 1), true)));
    assert!(Interval::descent(&interval(&f)).is_err());
    let seen = f64::descent(&binary64(&f)).unwrap().unwrap();
    assert_eq!((seen.time, seen.graze), (4.0, true));
    // Twice as far above: at √(2 · 16).
    let f = [
        ratio(256, 1),
        ratio(0, 1),
        ratio(-16, 1),
        ratio(0, 1),
        ratio(1, 4),
    ];
    let found = solved(&f).unwrap();
    assert!(found.graze && is_root_of(&found.time, &ratio(32, 1)));
}

/// (t - 1)² - 4^-n has its first zero at 1 - 2^-n.
#[test]
fn close_zeros_are_told_apart() {
    let far = [
        vec![ratio(1, 1), ratio(0, 1), ratio(1, 1)],
        linear(ratio(-5, 1)),
    ];
    for n in [10, 27, 100, 333, 600] {
        for extra in [&far[..0], &far[..1], &far[1..]] {
            let square = product(&[linear(ratio(1, 1)), linear(ratio(1, 1))]);
            let with = |constant: BigRational| {
                let mut close = square.clone();
                close[0] += constant;
                product(&[&[close], extra].concat())
            };
            let below = with(-power_of_two(-2 * n));
            let first = (ratio(1, 1) - power_of_two(-n), false);
            assert_eq!(rational(&below), Some(first.clone()));
            let sharp = Algebraic::first_descent(&dyadic(&below)).unwrap();
            assert_eq!(sharp.time.order_to(&dyadic(&[first.0]).0[0]), Equal);
            assert_eq!(rational(&with(ratio(0, 1))), Some((ratio(1, 1), true)));
            assert!(solved(&with(power_of_two(-2 * n))).is_none());
        }
    }
}

/// The two zeros near 1 are those of (t - 1)² = 2 · 4^-n.
#[test]
fn close_surds_are_enclosed() {
    for n in [60, 200, 500] {
        let mut f = product(&[linear(ratio(1, 1)), linear(ratio(1, 1))]);
        f[0] -= power_of_two(1 - 2 * n);
        let f = product(&[f, vec![ratio(3, 1), ratio(1, 1), ratio(1, 1)]]);
        let (low, high) = solved(&f).unwrap().time.enclosure().unwrap();
        let square = |time: BigRational| (ratio(1, 1) - time).pow(2);
        assert!(square(high) <= power_of_two(1 - 2 * n));
        assert!(square(low) >= power_of_two(1 - 2 * n));
    }
}

#[test]
fn zeros_of_all_sizes() {
    let sizes = [-600, -3, 0, 500];
    for skipped in 0..4 {
        let zeros = sizes[skipped..]
            .iter()
            .map(|size| linear(power_of_two(*size)));
        let f = product(&zeros.collect::<Vec<_>>());
        // The sign at 0 is that of (-1)^degree.
        let first = usize::from(skipped % 2 == 1) + skipped;
        let expected = sizes.get(first).map(|size| (power_of_two(*size), false));
        assert_eq!(rational(&f), expected);
        let sharp = Algebraic::first_descent(&dyadic(&f));
        let time = sharp.map(|sharp| sharp.time.to_f64());
        let near = f64::descent(&binary64(&f)).unwrap().map(|near| near.time);
        let error = time.zip(near).map(|(time, near)| (near / time - 1.0).abs());
        assert!(error.is_none_or(|error| error <= 4.0 * f64::EPSILON));
        assert_eq!(time.is_some(), near.is_some());
        assert_eq!(time, sizes.get(first).map(|size| f64::from(*size).exp2()));
    }
}

/// Enclosed coefficients: (t - √2)² - 4^-n is decided if the enclosures are much
/// narrower than 2^-n, and for an even zero never.
#[test]
fn enclosed_coefficients() {
    let with = |constant: BigRational, bits: u32| {
        let number = |n: i32| Exact::from_integer(n).with_bits(bits);
        let root = number(2).sqrt();
        let constant = Exact::from_rational(ratio(2, 1) + constant, bits);
        let linear = -(root * number(2));
        Exact::descent(&Polynomial([
            constant,
            linear,
            number(1),
            number(0),
            number(0),
        ]))
    };
    for n in [20, 100, 400] {
        let bits = 2 * n as u32 + 50;
        let time = with(-power_of_two(-2 * n), bits).unwrap().unwrap().time;
        let moved = time + Exact::from_rational(power_of_two(-n), bits);
        assert_eq!(moved.square().compare(&Exact::from_integer(2)).ok(), None);
        assert!(moved.accuracy().unwrap() > i64::from(n));
        assert!(with(power_of_two(-2 * n), bits).unwrap().is_none());
        assert!(with(ratio(0, 1), bits).is_err());
        assert!(with(-power_of_two(-2 * n), n as u32 / 2).is_err());
    }
}

/// A place, often the same one twice.
fn place() -> impl Strategy<Value = BigRational> {
    (-2..6_i64, prop::sample::select(vec![1, 1, 1, 3, 4])).prop_map(|(n, d)| ratio(n, d))
}

/// t² + b t + c without zeros.
fn positive() -> impl Strategy<Value = Coefficients> {
    (-6..6_i64, 1..20_i64)
        .prop_map(|(b, more)| vec![ratio(b * b + more, 4), ratio(b, 1), ratio(1, 1)])
}

fn coefficients() -> impl Strategy<Value = Coefficients> {
    let small = prop::collection::vec((-6..6_i64).prop_map(|n| ratio(n, 2)), 5);
    let binary = prop::collection::vec(-1.0..1.0_f64, 5).prop_map(|numbers| {
        numbers
            .into_iter()
            .map(|number| BigRational::from_float(number).unwrap())
            .collect()
    });
    prop_oneof![small, binary]
}

/// Σ |aᵢ| tⁱ.
fn size(f: &[BigRational], t: &BigRational) -> BigRational {
    let magnitudes: Vec<_> = f.iter().map(Signed::abs).collect();
    sturm::value(&magnitudes, t)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn chosen_zeros(
        zeros in prop::collection::vec(place(), 0..5),
        quadratic in positive(),
        is_positive in any::<bool>(),
    ) {
        let mut factors: Vec<_> = zeros.iter().cloned().map(linear).collect();
        if zeros.len() <= 2 {
            factors.push(quadratic);
        }
        factors.push(vec![ratio(if is_positive { 7 } else { -7 }, 3)]);
        let f = product(&factors);
        let expected = expected(&zeros, is_positive);
        prop_assert_eq!(rational(&f), expected.clone());
        if let Ok(found) = Interval::descent(&interval(&f)) {
            prop_assert_eq!(found.is_some(), expected.is_some());
            let (low, high) = found.map_or_else(Default::default, |found| found.time.enclosure().unwrap());
            let place = expected.map_or_else(Default::default, |(place, _)| place);
            prop_assert!(low <= place && place <= high);
        }
    }

    /// Zeros that are multiples of 1/16 leave coefficients that binary64 holds.
    #[test]
    fn binary64_finds_binary64_zeros(
        zeros in prop::collection::btree_set(-300..1000_i64, 1..5),
        is_positive in any::<bool>(),
    ) {
        let zeros: Vec<_> = zeros.into_iter().map(|n| ratio(n, 16)).collect();
        let mut factors: Vec<_> = zeros.iter().cloned().map(linear).collect();
        factors.push(vec![ratio(if is_positive { 1 } else { -1 }, 1)]);
        let found = f64::descent(&binary64(&product(&factors))).unwrap();
        let found = found.map(|found| (BigRational::from_float(found.time).unwrap(), found.graze));
        prop_assert_eq!(found, expected(&zeros, is_positive));
    }

    /// With coefficients that are enclosed, whose common factor changes nothing.
    #[test]
    fn enclosed_coefficients_leave_the_same(f in coefficients()) {
        let three = Exact::from_integer(3).with_bits(BITS).sqrt();
        let found = Exact::descent(&exact(&f).map(|a| three.clone() * a));
        let expected = solved(&f);
        let is_random = f.iter().any(|a| a.denom().bits() > 10);
        prop_assert!(found.is_ok() || !is_random);
        if let Ok(found) = found {
            prop_assert_eq!(found.is_some(), expected.is_some());
            if let Some((found, expected)) = found.zip(expected) {
                prop_assert!(!expected.graze && (found.time.clone() - &expected.time).sign() != Ok(Less));
                prop_assert!((found.time.clone() - &expected.time).sign() != Ok(Greater));
                prop_assert!(!is_random || found.time.accuracy().is_some_and(|bits| bits > 200));
            }
        }
    }

    #[test]
    fn as_sturm_has_it(f in coefficients()) {
        let expected = sturm::descent(&f, 100);
        let found = solved(&f);
        prop_assert_eq!(
            found.as_ref().map(|found| found.graze),
            expected.as_ref().map(|(_, graze)| *graze)
        );
        let Some((found, ([low, high], graze))) = found.zip(expected) else {
            return Ok(());
        };
        let (from, to) = found.time.enclosure().unwrap();
        prop_assert!(low <= to && from <= high);
        prop_assert!(found.time.accuracy().is_none_or(|bits| bits >= i64::from(BITS) - 8));
        if let Ok(rough) = Interval::descent(&interval(&f)) {
            let (from, to) = rough.unwrap().time.enclosure().unwrap();
            prop_assert!(!graze && from <= high && low <= to);
        }
    }

    /// What the module of binary64 says of its errors.
    #[test]
    fn binary64_descends_where_it_should_or_faintly(f in coefficients()) {
        let exactly: Coefficients = binary64(&f).0.map(|a| BigRational::from_float(a).unwrap()).to_vec();
        let found = f64::descent(&binary64(&f)).unwrap();
        let expected = solved(&exactly);
        if let Some(time) = found.as_ref().map(|found| found.time) {
            let [low, at, high] = [time.next_down(), time, time.next_up()].map(|t| BigRational::from_float(t).unwrap());
            let value = |t: &BigRational| sturm::value(&exactly, t);
            let faint = value(&at).abs() <= size(&exactly, &at) * ratio(100, 1) * power_of_two(-106);
            prop_assert!(faint || !(value(&low) * value(&high)).is_positive());
        }
        // Random coefficients have no zeros so close that they are not told apart.
        let is_graze = expected.as_ref().is_some_and(|expected| expected.graze);
        if !is_graze && f.iter().any(|a| a.denom().bits() > 10) {
            prop_assert_eq!(found.is_some(), expected.is_some());
            if let Some((found, expected)) = found.zip(expected) {
                prop_assert!((found.time - expected.time.to_f64()).abs() <= found.time * f64::EPSILON);
            }
        }
    }
}
