//! Numbers and bodies as vectors write them: no digit is lost, and no reader rounds.

use carom::scalar::Number;
use carom::scene::{Disc, Mass, Wall};
use schemars::JsonSchema;
use serde::Serialize;

/// An exact number, as scenes take it: a binary64 in hexadecimal, such as 0x1.8p+1, or
/// a fraction, such as -1/3.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(transparent)]
pub(super) struct Text(String);

/// A disc.
#[derive(Serialize, JsonSchema)]
pub(super) struct DiscText {
    pub(super) position: [Text; 2],
    pub(super) velocity: [Text; 2],
    pub(super) radius: Text,
    /// A number, or the word infinite; 1 if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Text")]
    pub(super) mass: Option<Text>,
}

/// A wall.
#[derive(Serialize, JsonSchema)]
pub(super) struct WallText {
    pub(super) from: [Text; 2],
    pub(super) to: [Text; 2],
}

/// What a disc meets.
#[derive(Serialize, JsonSchema)]
#[serde(untagged)]
pub(super) enum BodyText {
    Disc(DiscText),
    Wall(WallText),
}

impl Text {
    pub(super) fn new(text: impl Into<String>) -> Self {
        Self(text.into())
    }

    fn point(point: &[Number; 2]) -> [Self; 2] {
        point.each_ref().map(Self::from)
    }
}

impl From<&Number> for Text {
    fn from(number: &Number) -> Self {
        Self(match number.as_binary64() {
            Some(number) => hexadecimal(number),
            None => number.to_string(),
        })
    }
}

impl From<&Disc> for DiscText {
    fn from(disc: &Disc) -> Self {
        Self {
            position: Text::point(&disc.position),
            velocity: Text::point(&disc.velocity),
            radius: Text::from(&disc.radius),
            mass: match &disc.mass {
                mass if *mass == Mass::default() => None,
                Mass::Finite(mass) => Some(Text::from(mass)),
                Mass::Infinite => Some(Text::new("infinite")),
            },
        }
    }
}

impl From<&Wall> for WallText {
    fn from(wall: &Wall) -> Self {
        Self {
            from: Text::point(&wall.from),
            to: Text::point(&wall.to),
        }
    }
}

/// A finite binary64, as the C language writes it with `%a`.
fn hexadecimal(number: f64) -> String {
    const FRACTION: u32 = f64::MANTISSA_DIGITS - 1;
    let bits = number.abs().to_bits();
    let fraction = format!("{:013x}", bits & ((1 << FRACTION) - 1));
    let (lead, exponent) = match (bits >> FRACTION) as i32 {
        0 if number == 0.0 => (0, 0),
        0 => (0, f64::MIN_EXP - 1),
        biased => (1, biased - f64::MAX_EXP + 1),
    };
    let point = if fraction.bytes().all(|digit| digit == b'0') {
        ""
    } else {
        "."
    };
    let sign = if number < 0.0 { "-" } else { "" };
    let fraction = fraction.trim_end_matches('0');
    format!("{sign}0x{lead}{point}{fraction}p{exponent:+}")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 0.1 is 0x1.999999999999ap-4: its digits are those of 1/10, rounded.
    #[test]
    fn binary64_is_written_as_it_is() {
        let table = [
            (3.0, "0x1.8p+1"),
            (-1.0, "-0x1p+0"),
            (0.0, "0x0p+0"),
            (0.1, "0x1.999999999999ap-4"),
            (f64::MAX, "0x1.fffffffffffffp+1023"),
            (f64::MIN_POSITIVE, "0x1p-1022"),
            (f64::from_bits(1), "0x0.0000000000001p-1022"),
        ];
        for (number, text) in table {
            assert_eq!(hexadecimal(number), text);
            let read: Number = text.parse().expect(text);
            assert_eq!(read.to_f64(), number);
        }
    }
}
