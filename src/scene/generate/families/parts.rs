//! What scenes are drawn with: fractions, and bodies made of them.

use num_rational::BigRational;

use crate::scalar::{Number, NumberError};
use crate::scene::{Disc, DiscBuilder, IntoNumber};

/// A fraction where a number is asked for: as a binary64 number if it is one.
#[derive(Clone)]
pub(super) struct Written(pub(super) BigRational);

impl IntoNumber for Written {
    fn into_number(self) -> Result<Number, NumberError> {
        Number::try_from(self.0).map(Number::in_binary64)
    }
}

pub(super) fn ratio(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

pub(super) fn whole(number: i64) -> BigRational {
    BigRational::from_integer(number.into())
}

/// How a note tells a tiny number.
pub(super) fn told(tiny: &BigRational) -> String {
    let sign = match tiny.numer().sign() {
        num_bigint::Sign::NoSign => return String::from("0"),
        num_bigint::Sign::Minus => "-",
        num_bigint::Sign::Plus => "",
    };
    format!("{sign}2^-{}", tiny.denom().bits() - 1)
}

/// Fractions as a point, for a wall or a velocity.
pub(super) fn point([x, y]: [BigRational; 2]) -> [Written; 2] {
    [Written(x), Written(y)]
}

/// A disc of mass 1.
pub(super) fn disc(
    position: [BigRational; 2],
    velocity: [BigRational; 2],
    radius: BigRational,
) -> DiscBuilder {
    Disc::at(point(position), Written(radius)).velocity(point(velocity))
}

/// Whole numbers as a point.
pub(super) fn at(x: i64, y: i64) -> [BigRational; 2] {
    [whole(x), whole(y)]
}
