//! Rationals as decimals, rounded in a chosen direction.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// Which of the two neighbouring decimals to take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Direction {
    /// The lower one.
    Down,
    /// The nearer one, of two equally near ones that farther from zero.
    Nearest,
    /// The upper one.
    Up,
}

/// Numbers from 10^-6 up to 10^20 are written without an exponent.
const PLAIN_EXPONENTS: std::ops::Range<i64> = -6..20;

/// The decimal of so many significant digits that is next to a number.
pub(super) fn rounded(value: &BigRational, digits: u32, direction: Direction) -> String {
    if value.is_zero() {
        return String::from("0");
    }
    let places = i64::from(digits) - 1 - exponent(value);
    let (numerator, denominator) = scaled(value, places);
    let integer = match direction {
        Direction::Down => numerator.div_floor(&denominator),
        Direction::Nearest => {
            (numerator * 2 + &denominator * value.numer().signum()) / (denominator * 2)
        }
        Direction::Up => numerator.div_ceil(&denominator),
    };
    written(&integer, places)
}

/// The numerator and the denominator of a number times 10^`places`. Long
/// fractions are not brought to lowest terms, which would take long.
fn scaled(value: &BigRational, places: i64) -> (BigInt, BigInt) {
    let power = ten().pow(places.unsigned_abs() as u32);
    let (numerator, denominator) = (value.numer(), value.denom());
    if places >= 0 {
        (numerator * power, denominator.clone())
    } else {
        (numerator.clone(), denominator * power)
    }
}

/// The number itself: a decimal if that takes no more than so many digits,
/// otherwise a fraction.
pub(super) fn exact(value: &BigRational, digits: u32) -> String {
    let terminating = decimals(value.denom(), digits).map(|places| {
        let scaled = value * power_of_ten(places);
        (scaled.to_integer(), places)
    });
    match terminating {
        Some((integer, places)) if integer.magnitude() < ten().pow(digits).magnitude() => {
            written(&integer, places)
        }
        _ => value.to_string(),
    }
}

/// How many decimals a fraction with that denominator has, if it has no more
/// than `most`.
fn decimals(denominator: &BigInt, most: u32) -> Option<i64> {
    let five = BigInt::from(5);
    let twos = denominator.trailing_zeros().unwrap_or(0);
    let mut rest = denominator >> twos;
    let mut fives = 0;
    while fives < most && (&rest % &five).is_zero() {
        rest /= &five;
        fives += 1;
    }
    let places = twos.max(fives.into());
    (rest.is_one() && places <= most.into()).then_some(places as i64)
}

/// The exponent of the leading digit.
fn exponent(value: &BigRational) -> i64 {
    let (numerator, denominator) = (value.numer().magnitude(), value.denom().magnitude());
    let bits = numerator.bits() as f64 - denominator.bits() as f64;
    let mut exponent = (bits * std::f64::consts::LOG10_2).floor() as i64;
    let is_below = |exponent: i64| {
        let (numerator, denominator) = scaled(value, -exponent);
        numerator.magnitude() < denominator.magnitude()
    };
    while is_below(exponent) {
        exponent -= 1;
    }
    while !is_below(exponent + 1) {
        exponent += 1;
    }
    exponent
}

/// `integer` × 10^-`places`.
fn written(integer: &BigInt, places: i64) -> String {
    let sign = if integer.is_negative() { "-" } else { "" };
    let digits = integer.magnitude().to_string();
    let exponent = digits.len() as i64 - 1 - places;
    if !PLAIN_EXPONENTS.contains(&exponent) {
        let (first, rest) = digits.split_at(1);
        return format!("{sign}{}e{exponent}", joined(first, rest));
    }
    if places <= 0 {
        return format!(
            "{sign}{digits}{}",
            "0".repeat(places.unsigned_abs() as usize)
        );
    }
    let places = places as usize;
    let padded = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = padded.split_at(padded.len() - places);
    format!("{sign}{}", joined(whole, fraction))
}

fn joined(whole: &str, fraction: &str) -> String {
    match fraction {
        "" => whole.to_owned(),
        _ => format!("{whole}.{fraction}"),
    }
}

fn ten() -> BigInt {
    BigInt::from(10)
}

fn power_of_ten(exponent: i64) -> BigRational {
    let power = ten().pow(exponent.unsigned_abs() as u32);
    if exponent < 0 {
        BigRational::new_raw(BigInt::one(), power)
    } else {
        BigRational::from_integer(power)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::scalar::Number;

    fn ratio(numerator: i64, denominator: i64) -> BigRational {
        BigRational::new(numerator.into(), denominator.into())
    }

    fn read(text: &str) -> BigRational {
        text.parse::<Number>().unwrap().to_rational()
    }

    #[test]
    fn directions_differ() {
        let table = [
            (ratio(2, 3), ["0.666", "0.667", "0.667"]),
            (ratio(-2, 3), ["-0.667", "-0.667", "-0.666"]),
            (ratio(1, 8), ["0.125", "0.125", "0.125"]),
            (ratio(9999, 10), ["999", "1000", "1000"]),
            (ratio(123_456, 1), ["123000", "123000", "124000"]),
            (ratio(1, 3_000_000), ["3.33e-7", "3.33e-7", "3.34e-7"]),
        ];
        for (value, expected) in table {
            let directions = [Direction::Down, Direction::Nearest, Direction::Up];
            let found = directions.map(|direction| rounded(&value, 3, direction));
            assert_eq!(found, expected, "{value}");
        }
    }

    #[test]
    fn large_numbers_have_an_exponent() {
        let large = BigRational::from_integer(ten().pow(20) * 15);
        assert_eq!(rounded(&large, 2, Direction::Down), "1.5e21");
        assert_eq!(exact(&large, 40), "1.500000000000000000000e21");
        assert_eq!(rounded(&large, 1, Direction::Up), "2e21");
    }

    #[test]
    fn rationals_are_written_exactly() {
        let table = [
            (ratio(0, 1), "0"),
            (ratio(5, 4), "1.25"),
            (ratio(-1, 20), "-0.05"),
            (ratio(1200, 1), "1200"),
            (ratio(262, 65), "262/65"),
            (ratio(1, 128), "0.0078125"),
            (ratio(1, 1 << 20), "1/1048576"),
        ];
        for (value, expected) in table {
            assert_eq!(exact(&value, 10), expected);
        }
    }

    proptest! {
        #[test]
        fn bounds_enclose_and_are_close(
            numerator: i64,
            denominator in 1..i64::MAX,
            digits in 1..30_u32,
        ) {
            let value = ratio(numerator, denominator);
            let lo = read(&rounded(&value, digits, Direction::Down));
            let hi = read(&rounded(&value, digits, Direction::Up));
            prop_assert!(lo <= value && value <= hi);
            let unit = value.abs() * power_of_ten(1 - i64::from(digits));
            prop_assert!(&hi - &lo <= unit);
            let nearest = read(&rounded(&value, digits, Direction::Nearest));
            prop_assert!((nearest - &value).abs() * ratio(2, 1) <= unit);
        }

        #[test]
        fn exact_ones_read_back(numerator: i64, denominator in 1..10_000_i64) {
            let value = ratio(numerator, denominator);
            prop_assert_eq!(read(&exact(&value, 20)), value);
        }
    }
}
