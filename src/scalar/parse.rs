//! Reading numbers from text, exactly.

use num_bigint::{BigInt, BigUint, Sign};
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::{Number, NumberError};

/// An integer, a fraction, a decimal or a hexadecimal number, in lowest
/// terms. The text must not be longer than [`Number::MAX_LENGTH`].
pub(super) fn parse_rational(text: &str) -> Result<BigRational, NumberError> {
    let (sign, magnitude) = split_sign(text);
    let ratio = parse_magnitude(magnitude)?;
    Ok(if sign == Sign::Minus { -ratio } else { ratio })
}

fn split_sign(text: &str) -> (Sign, &str) {
    match text.strip_prefix('-') {
        Some(rest) => (Sign::Minus, rest),
        None => (Sign::Plus, text.strip_prefix('+').unwrap_or(text)),
    }
}

/// A positional notation with an optional exponent.
struct Notation {
    radix: u32,
    /// What introduces the exponent.
    markers: [char; 2],
    /// What the exponent is a power of.
    base: u32,
    /// By how much each digit after the point lowers the exponent.
    step: i64,
}

const DECIMAL: Notation = Notation {
    radix: 10,
    markers: ['e', 'E'],
    base: 10,
    step: 1,
};

const HEXADECIMAL: Notation = Notation {
    radix: 16,
    markers: ['p', 'P'],
    base: 2,
    step: 4,
};

/// A power by which no text of the allowed length is scaled into the range:
/// its digits amount to at most 4 bits each.
const MAX_POWER: u64 = 4 * Number::MAX_LENGTH as u64 + Number::RANGE as u64;

fn parse_magnitude(text: &str) -> Result<BigRational, NumberError> {
    if let Some(digits) = text.strip_prefix("0x").or(text.strip_prefix("0X")) {
        return parse_positional(digits, &HEXADECIMAL);
    }
    match text.split_once('/') {
        Some((numerator, denominator)) => parse_fraction(numerator, denominator),
        None => parse_positional(text, &DECIMAL),
    }
}

fn parse_fraction(numerator: &str, denominator: &str) -> Result<BigRational, NumberError> {
    let numerator = parse_digits(numerator, DECIMAL.radix)?;
    let denominator = parse_digits(denominator, DECIMAL.radix)?;
    if denominator.is_zero() {
        return Err(NumberError::ZeroDenominator);
    }
    Ok(BigRational::new(numerator.into(), denominator.into()))
}

fn parse_positional(text: &str, notation: &Notation) -> Result<BigRational, NumberError> {
    let (digits, exponent) = match text.split_once(notation.markers) {
        Some((digits, exponent)) => (digits, parse_exponent(exponent)?),
        None => (text, 0),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let integer = parse_digits(&[whole, fraction].concat(), notation.radix)?;
    let below_point = notation.step * fraction.len() as i64;
    scale(integer, notation.base, exponent.saturating_sub(below_point))
}

/// One digit or more, and nothing else.
fn parse_digits(text: &str, radix: u32) -> Result<BigUint, NumberError> {
    // The parser of integers also takes signs and underscores.
    if !text.chars().all(|digit| digit.is_digit(radix)) {
        return Err(NumberError::Malformed);
    }
    BigUint::parse_bytes(text.as_bytes(), radix).ok_or(NumberError::Malformed)
}

/// A decimal integer, or the nearest one of 64 bits.
fn parse_exponent(text: &str) -> Result<i64, NumberError> {
    let (sign, digits) = split_sign(text);
    if digits.is_empty() || !digits.bytes().all(|digit| digit.is_ascii_digit()) {
        return Err(NumberError::Malformed);
    }
    let magnitude = digits.parse().unwrap_or(i64::MAX);
    Ok(if sign == Sign::Minus {
        -magnitude
    } else {
        magnitude
    })
}

/// `integer` × `base`^`exponent`, unless the power alone shows that it is out
/// of range.
fn scale(integer: BigUint, base: u32, exponent: i64) -> Result<BigRational, NumberError> {
    if integer.is_zero() {
        return Ok(BigRational::zero());
    }
    if exponent.unsigned_abs() > MAX_POWER {
        return Err(NumberError::OutOfRange);
    }
    let power = BigInt::from(base).pow(exponent.unsigned_abs() as u32);
    Ok(if exponent < 0 {
        BigRational::new(integer.into(), power)
    } else {
        BigRational::new_raw(BigInt::from(integer) * power, BigInt::one())
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn read(text: &str) -> Result<String, NumberError> {
        text.parse::<Number>().map(|number| number.to_string())
    }

    #[test]
    fn good_texts() {
        let table = [
            ("3", "3"),
            ("+3", "3"),
            ("-0", "0"),
            ("007", "7"),
            ("-1/3", "-1/3"),
            ("+6/4", "3/2"),
            ("0/5", "0"),
            ("6/3", "2"),
            ("0.1", "1/10"),
            ("-0.25", "-1/4"),
            (".5", "1/2"),
            ("5.", "5"),
            ("1e3", "1000"),
            ("1E+3", "1000"),
            ("1.5e-2", "3/200"),
            ("12.5e1", "125"),
            ("1e-30", "1/1000000000000000000000000000000"),
            ("0e999999999999999999999", "0"),
            ("0.000e-999999999999999999999", "0"),
            ("0x10", "16"),
            ("0x1.8p+1", "3"),
            ("-0X.8P0", "-1/2"),
            ("0xffp-8", "255/256"),
            ("0x1p-4", "1/16"),
            ("0x1e1", "481"),
        ];
        for (text, number) in table {
            assert_eq!(read(text).as_deref(), Ok(number), "{text}");
        }
    }

    #[test]
    fn malformed_texts() {
        let table = [
            " ",
            "1 ",
            " 1",
            "-",
            "+",
            "--1",
            "+-1",
            ".",
            "e5",
            "1e",
            "1e+",
            "1e5.0",
            "1e--5",
            "1e5e5",
            "1.2.3",
            "1_000",
            "1,5",
            "abc",
            "NaN",
            "inf",
            "-infinity",
            "/",
            "1/",
            "/2",
            "1/2/3",
            "1/-2",
            "1.5/2",
            "1/0x2",
            "0x",
            "0x.",
            "0xg",
            "0x1p",
            "0x1.8p1.0",
            "0x-1",
            "1p3",
            "½",
            "１",
            "1e１",
        ];
        for text in table {
            assert_eq!(read(text), Err(NumberError::Malformed), "{text}");
        }
    }

    #[test]
    fn empty_texts_and_zero_denominators() {
        assert_eq!(read(""), Err(NumberError::Empty));
        assert_eq!(read("1/0"), Err(NumberError::ZeroDenominator));
        assert_eq!(read("0/00"), Err(NumberError::ZeroDenominator));
    }

    #[test]
    fn absurd_sizes() {
        let huge = [
            "1e999999999",
            "-1e-999999999",
            "1e99999999999999999999999999",
            "1e-99999999999999999999999999",
            "0x1p999999999",
            "0x1p4097",
            "0x1p-4097",
            "0x1.000001p4096",
            "-1e1234",
        ];
        for text in huge {
            assert_eq!(read(text), Err(NumberError::OutOfRange), "{text}");
        }
        for text in ["0x1p4096", "-0x1p-4096", "1e1233", "1e-1233"] {
            assert!(read(text).is_ok(), "{text}");
        }
    }

    #[test]
    fn long_texts() {
        let zeros = "0".repeat(Number::MAX_LENGTH - 1);
        assert_eq!(read(&format!("{zeros}1")).as_deref(), Ok("1"));
        let length = Number::MAX_LENGTH + 1;
        assert_eq!(
            read(&format!("{zeros}12")),
            Err(NumberError::TooLong(length))
        );
        // Digits and power, each absurd, make up for each other.
        let digits = "0".repeat(16_000);
        assert_eq!(read(&format!("1{digits}e-16000")).as_deref(), Ok("1"));
        assert_eq!(read(&format!("0x1{digits}p-64000")).as_deref(), Ok("1"));
        assert_eq!(read(&format!("0.{digits}1e16001")).as_deref(), Ok("1"));
    }

    proptest! {
        #[test]
        fn no_text_is_too_strange(text in "[-+0-9a-fxXpPeE./_ ]{0,12}") {
            let _ = text.parse::<Number>();
        }

        #[test]
        fn any_text_at_all(text in ".{0,20}") {
            let _ = text.parse::<Number>();
        }
    }
}
