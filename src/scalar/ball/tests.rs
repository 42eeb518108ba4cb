use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

use super::*;

/// Balls of up to 1024 bits, some exact, some around zero, and a point in
/// each, as a fraction of its radius.
fn ball() -> impl Strategy<Value = (Ball, BigRational)> {
    let mid = (
        prop::collection::vec(any::<u32>(), 0..33),
        any::<bool>(),
        -400..-40_i64,
    );
    let rad = prop_oneof![
        Just(Radius::ZERO),
        (any::<u32>(), -500..100_i64)
            .prop_map(|(bits, exponent)| Radius::up(bits.into(), exponent)),
    ];
    let place = prop_oneof![-3..=3_i32, Just(-3), Just(3)];
    (mid, rad, place).prop_map(|((digits, negative, exponent), rad, place)| {
        let sign = if negative { Sign::Minus } else { Sign::Plus };
        let mid = Dyadic::new(BigInt::new(sign, digits), exponent);
        let offset = to_rational(rad) * BigRational::new(place.into(), 3.into());
        let point = mid.to_rational() + offset;
        (Ball { mid, rad }, point)
    })
}

fn precision() -> impl Strategy<Value = u32> {
    prop_oneof![Just(1), Just(2), 3..64_u32, Just(128), Just(1024)]
}

fn to_rational(rad: Radius) -> BigRational {
    if rad.is_zero() {
        BigRational::zero()
    } else {
        rad.to_dyadic().to_rational()
    }
}

fn contains(ball: &Ball, point: &BigRational) -> bool {
    ball.view()
        .ends()
        .is_none_or(|(lo, hi)| lo <= *point && *point <= hi)
}

fn exact(integer: i64) -> Ball {
    Ball::from_dyadic(Dyadic::new(integer.into(), 0), 64)
}

#[test]
fn unknown_stays_unknown() {
    let (unknown, zero, one) = (Ball::unknown(), exact(0), exact(1));
    let (u, z, o) = (unknown.view(), zero.view(), one.view());
    let results = [
        u.add(o, 64),
        o.sub(u, 64),
        u.mul(o, 64),
        u.div(o, 64),
        o.div(u, 64),
    ];
    let more = [
        u.square(64),
        u.sqrt(64),
        o.div(z, 64),
        z.div(z, 64),
        -unknown.clone(),
    ];
    for result in results.iter().chain(&more) {
        assert!(result.view().is_unknown());
        assert_eq!(result.view().sign(), None);
        assert_eq!(result.view().ends(), None);
        assert_eq!(result.view().hull(), Interval::UNBOUNDED);
        assert_eq!(result.view().accuracy(), Some(0));
    }
}

/// Squares run out of any range, upwards and downwards, and stay true.
#[test]
fn extremes_are_tamed() {
    let mut large = Ball::from_dyadic(Dyadic::new(3.into(), 5000), 64);
    let mut small = Ball::from_dyadic(Dyadic::new(3.into(), -5000), 64);
    for _ in 0..80 {
        large = large.view().square(64);
        small = small.view().square(64);
    }
    assert!(large.view().is_unknown());
    assert!(!small.view().is_unknown());
    assert_eq!(small.view().sign(), None);
    assert!(small.view().hull().hi() > 0.0);
}

#[test]
fn roots_of_balls_around_zero_start_there() {
    let ball = Ball {
        mid: Dyadic::zero(),
        rad: Radius::power_of_two(4),
    };
    let (lo, hi) = ball.view().sqrt(64).view().ends().unwrap();
    assert!(lo.is_zero());
    assert_eq!(hi, BigRational::from_integer(4.into()));
    let negative = exact(-4).view().sqrt(64);
    assert!(contains(&negative, &BigRational::zero()));
}

#[test]
fn accuracy_is_relative() {
    let rad = Radius::power_of_two(-50);
    let ball = |mid: i64| Ball {
        mid: Dyadic::new(mid.into(), 0),
        rad,
    };
    assert_eq!(exact(3).view().accuracy(), None);
    let certain = ball(1 << 20).view().accuracy().unwrap();
    assert!((67..=70).contains(&certain), "{certain}");
    assert_eq!(ball(0).view().accuracy(), Some(0));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn sums_enclose((a, x) in ball(), (b, y) in ball(), bits in precision()) {
        prop_assert!(contains(&a.view().add(b.view(), bits), &(&x + &y)));
        prop_assert!(contains(&a.view().sub(b.view(), bits), &(&x - &y)));
    }

    #[test]
    fn products_enclose((a, x) in ball(), (b, y) in ball(), bits in precision()) {
        prop_assert!(contains(&a.view().mul(b.view(), bits), &(&x * &y)));
        let square = a.view().square(bits);
        prop_assert!(contains(&square, &(&x * &x)));
        prop_assert!(a.view().is_exact() || square.view().hull().hi() > 0.0);
    }

    #[test]
    fn quotients_enclose((a, x) in ball(), (b, y) in ball(), bits in precision()) {
        let quotient = a.view().div(b.view(), bits);
        prop_assert!(y.is_zero() || contains(&quotient, &(&x / &y)));
        let certain = b.view().sign().is_some_and(Ordering::is_ne);
        prop_assert_eq!(quotient.view().is_unknown(), !certain);
    }

    #[test]
    fn roots_enclose((a, x) in ball(), bits in precision()) {
        let (lo, hi) = a.view().sqrt(bits).view().ends().unwrap();
        if !x.is_negative() {
            prop_assert!(&hi * &hi >= x);
            prop_assert!(!lo.is_positive() || &lo * &lo <= x);
        }
    }

    #[test]
    fn signs_are_true((a, x) in ball()) {
        if let Some(sign) = a.view().sign() {
            prop_assert_eq!(sign, x.cmp(&BigRational::zero()));
        }
    }

    #[test]
    fn accuracy_is_not_overstated((a, x) in ball()) {
        if let Some(certain) = a.view().accuracy().filter(|&certain| certain > 0) {
            let unit = x.abs() / BigRational::from_integer(BigInt::one() << certain);
            prop_assert!(to_rational(a.rad) <= unit);
        }
    }

    #[test]
    fn hulls_are_tight((a, _) in ball()) {
        let (lo, hi) = a.view().ends().unwrap();
        let hull = a.view().hull();
        let end = |end: f64| BigRational::from_float(end).unwrap();
        prop_assert!(end(hull.lo()) <= lo && hi <= end(hull.hi()));
        // A 2^-50 of the larger of midpoint and radius.
        let size = a.mid.to_rational().abs() + to_rational(a.rad);
        let slack = size / BigRational::from_integer(BigInt::one() << 50);
        prop_assert!(lo - end(hull.lo()) <= slack && end(hull.hi()) - hi <= slack);
    }

    /// What exact operands give loses next to nothing but the last bit.
    #[test]
    fn results_have_the_bits_asked_for(
        a in prop::collection::vec(1..u32::MAX, 1..40),
        b in prop::collection::vec(1..u32::MAX, 1..40),
        bits in 2..1200_u32,
    ) {
        let ball = |digits| Ball {
            mid: Dyadic::new(BigInt::new(Sign::Plus, digits), -300),
            rad: Radius::ZERO,
        };
        let (a, b) = (ball(a), ball(b));
        let results = [
            a.view().add(b.view(), bits),
            a.view().mul(b.view(), bits),
            a.view().div(b.view(), bits),
            a.view().square(bits),
            a.view().sqrt(bits),
        ];
        for result in results {
            let certain = result.view().accuracy();
            prop_assert!(certain.is_none_or(|certain| certain >= i64::from(bits) - 4));
            prop_assert!(result.mid.mantissa().bits() <= u64::from(bits) + 2 * SLACK as u64);
        }
    }
}
