//! Exact numbers: small programs run in enclosures and, where there is no root
//! to take, in fractions of another library.
#![no_main]

use arbitrary::{Arbitrary, Unstructured};
use carom::scalar::{Exact, Number, Scalar};
use libfuzzer_sys::fuzz_target;
use num_rational::BigRational;
use num_traits::{One, Pow, Signed, Zero};

/// A number in two representations; the fraction is known of rationals only.
#[derive(Clone)]
struct Both {
    exact: Exact,
    ratio: Option<BigRational>,
}

/// Numbers whose fractions get longer than this are dropped: they cost time.
const MOST_BITS: u64 = 4096;

fuzz_target!(|bytes: &[u8]| {
    let mut input = Unstructured::new(bytes);
    // An error is the end of the input.
    let _ = run(&mut input);
});

fn run(input: &mut Unstructured) -> arbitrary::Result<()> {
    let bits = 32 + u32::from(u8::arbitrary(input)?);
    let mut stack = vec![written(input, bits)?];
    while !input.is_empty() && stack.len() < 32 {
        let next = match input.int_in_range(0..=9)? {
            0..=2 => written(input, bits)?,
            3 => root(input.choose(&stack)?),
            operation => {
                let (one, other) = (input.choose(&stack)?, input.choose(&stack)?);
                combined(operation, one, other)
            }
        };
        agrees(&next);
        compares(input.choose(&stack)?, &next);
        laws(input.choose(&stack)?, input.choose(&stack)?, &next);
        stack.push(next);
    }
    Ok(())
}

/// A number as it may be written: a fraction, a decimal, a binary64.
fn written(input: &mut Unstructured, bits: u32) -> arbitrary::Result<Both> {
    let (numerator, shift) = (i64::arbitrary(input)?, input.int_in_range(0..=62)?);
    let numerator = numerator >> shift;
    let (text, ratio) = match input.int_in_range(0..=3)? {
        0 => fraction(numerator, i64::from(u32::arbitrary(input)?) + 1),
        1 => decimal(numerator, input.int_in_range(-40..=40)?),
        2 => hexadecimal(numerator, input.int_in_range(-200..=200)?),
        _ => return Ok(binary(f64::from_bits(u64::arbitrary(input)?), bits)),
    };
    let number: Number = text.parse().expect("a number");
    assert_eq!(number.to_rational(), ratio, "{text}");
    Ok(both(&number, bits))
}

fn both(number: &Number, bits: u32) -> Both {
    Both {
        exact: Exact::from_number(number, bits),
        ratio: Some(number.to_rational()),
    }
}

fn binary(value: f64, bits: u32) -> Both {
    let value = if value.abs() < 2_f64.powi(200) {
        value
    } else {
        1.5
    };
    both(&Number::try_from(value).expect("finite"), bits)
}

fn fraction(numerator: i64, denominator: i64) -> (String, BigRational) {
    let ratio = BigRational::new(numerator.into(), denominator.into());
    (format!("{numerator}/{denominator}"), ratio)
}

fn decimal(digits: i64, exponent: i32) -> (String, BigRational) {
    let power = power(10, exponent);
    (
        format!("{digits}e{exponent}"),
        power * BigRational::from_integer(digits.into()),
    )
}

fn hexadecimal(digits: i64, exponent: i32) -> (String, BigRational) {
    let sign = if digits < 0 { "-" } else { "" };
    let text = format!("{sign}0x{:x}p{exponent:+}", digits.unsigned_abs());
    (
        text,
        power(2, exponent) * BigRational::from_integer(digits.into()),
    )
}

fn power(base: i32, exponent: i32) -> BigRational {
    BigRational::from_integer(base.into()).pow(exponent)
}

fn combined(operation: i32, one: &Both, other: &Both) -> Both {
    let (a, b) = (one.exact.clone(), &other.exact);
    let exact = match operation {
        4 => a + b,
        5 => a - b,
        6 | 7 => a * b,
        8 => Exact::difference_of_products(&a, b, b, b),
        _ => a / b,
    };
    let ratio = one.ratio.as_ref().zip(other.ratio.as_ref());
    let ratio = ratio.and_then(|(a, b)| match operation {
        4 => Some(a + b),
        5 => Some(a - b),
        6 | 7 => Some(a * b),
        8 => Some(a * b - b * b),
        _ => (!b.is_zero()).then(|| a / b),
    });
    let ratio = ratio.filter(|ratio| ratio.numer().bits() + ratio.denom().bits() < MOST_BITS);
    Both { exact, ratio }
}

/// The root of a square is the magnitude; that of another number, squared, is
/// the number.
fn root(of: &Both) -> Both {
    let square = of.exact.square();
    let ratio = of.ratio.as_ref().map(Signed::abs);
    let magnitude = Both {
        exact: square.sqrt(),
        ratio,
    };
    agrees(&magnitude);
    let root = magnitude.exact.sqrt();
    if let (Some(ratio), Some((lo, hi))) = (&magnitude.ratio, root.enclosure()) {
        assert!(!hi.is_negative() && hi.pow(2) >= *ratio);
        assert!(lo.is_negative() || lo.pow(2) <= *ratio);
    }
    Both {
        exact: root,
        ratio: None,
    }
}

/// The enclosure holds the truth, and is no wider than a point if it says so;
/// the nearest binary64 and the hull are about the truth, too.
fn agrees(number: &Both) {
    let (Some(truth), Some((lo, hi))) = (&number.ratio, number.exact.enclosure()) else {
        return;
    };
    assert!(
        lo <= *truth && *truth <= hi,
        "{:?} is not {truth}",
        number.exact
    );
    assert!(!number.exact.is_rational() || lo == hi);
    if let Ok(sign) = number.exact.sign() {
        assert_eq!(sign, truth.cmp(&BigRational::zero()));
    }
    let hull = number.exact.hull();
    let below = BigRational::from_float(hull.lo()).is_none_or(|lo| lo <= *truth);
    let above = BigRational::from_float(hull.hi()).is_none_or(|hi| *truth <= hi);
    assert!(below && above, "{hull:?} does not hold {truth}");
}

/// Decided comparisons are true, and the same from either side.
fn compares(one: &Both, other: &Both) {
    let order = one.exact.compare(&other.exact);
    if let (Ok(order), Some(a), Some(b)) = (&order, &one.ratio, &other.ratio) {
        assert_eq!(*order, a.cmp(b));
    }
    if let (Ok(order), Ok(reverse)) = (order, other.exact.compare(&one.exact)) {
        assert_eq!(order, reverse.reverse());
    }
}

/// The laws of a field hold as far as enclosures tell.
fn laws(a: &Both, b: &Both, c: &Both) {
    let [a, b, c] = [a, b, c].map(|both| both.exact.clone());
    let zero_at = |difference: Exact| {
        if let Some((lo, hi)) = difference.enclosure() {
            assert!(!lo.is_positive() && !hi.is_negative(), "{difference:?}");
        }
    };
    zero_at((a.clone() + &b) + &c - (a.clone() + &(b.clone() + &c)));
    zero_at((a.clone() * &b) * &c - a.clone() * &(b.clone() * &c));
    zero_at(a.clone() * &(b.clone() + &c) - (a.clone() * &b + &(a.clone() * &c)));
    zero_at(a.square() - a.clone() * &a);
    if b.sign().is_ok_and(|sign| sign.is_ne()) {
        zero_at(a.clone() / &b * &b - &a);
    }
    let one = Exact::from_number(&Number::try_from(BigRational::one()).expect("one"), 64);
    zero_at(a.clone() * one - a);
}
