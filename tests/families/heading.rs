//! A frame of reference in which cases are written once, and placed in the
//! plane along an axis or obliquely.

use carom::scalar::Number;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Pow;

/// A whole number.
pub(crate) fn whole(number: i64) -> BigRational {
    BigRational::from_integer(number.into())
}

/// A power of a whole number, such as 2^-300.
pub(crate) fn power(base: i64, exponent: i32) -> BigRational {
    whole(base).pow(exponent)
}

/// The numbers ± 2^-k, with k.
pub(crate) fn nudges(bits: impl Iterator<Item = i32>) -> impl Iterator<Item = (i32, BigRational)> {
    bits.flat_map(|k| [(k, power(2, -k)), (k, -power(2, -k))])
}

/// A Pythagorean triple (a, b, c): the direction (a, b), in which all lengths
/// are c times as long. It turns and scales, so that times stay the same; as
/// there is no division, dyadic numbers stay dyadic.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Heading(i64, i64, i64);

/// Along the axis, and obliquely in three quadrants.
pub(crate) const HEADINGS: [Heading; 4] = [
    Heading(1, 0, 1),
    Heading(3, 4, 5),
    Heading(-5, 12, 13),
    Heading(8, -15, 17),
];

impl Heading {
    /// A point or vector, given along and across the direction.
    pub(crate) fn point(self, along: &BigRational, across: &BigRational) -> [Number; 2] {
        let [a, b] = [self.0, self.1].map(whole);
        [&a * along - &b * across, &b * along + &a * across].map(number)
    }

    /// The same of whole numbers.
    pub(crate) fn at(self, along: i64, across: i64) -> [Number; 2] {
        self.point(&whole(along), &whole(across))
    }

    /// A length.
    pub(crate) fn length(self, length: &BigRational) -> Number {
        number(whole(self.2) * length)
    }

    /// The length of so many units.
    pub(crate) fn units(self, count: i64) -> Number {
        self.length(&whole(count))
    }

    /// A vector of the plane, seen from this frame.
    pub(crate) fn seen(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [a, b, c] = [self.0, self.1, self.2].map(|n| n as f64);
        [(a * x + b * y) / (c * c), (a * y - b * x) / (c * c)]
    }
}

/// A number as a scene has it.
pub(crate) fn number(value: BigRational) -> Number {
    Number::try_from(value).expect("within the range of numbers")
}

/// The power of ten as a whole number.
pub(crate) fn ten_to(exponent: u32) -> BigRational {
    BigRational::from_integer(BigInt::from(10).pow(exponent))
}
