//! What a user of the library may write where a number is asked for.

use crate::scalar::{Number, NumberError};

/// A number as given, which may turn out to be none.
pub(super) type Given = Result<Number, NumberError>;

/// Up to here binary64 has every whole number.
const MAX_WHOLE: f64 = (1_u64 << f64::MANTISSA_DIGITS) as f64;

/// A small whole number as one would write it, without quotes: a binary64.
pub(super) fn bare(integer: i32) -> Number {
    let number = Number::try_from(f64::from(integer));
    number.unwrap_or_else(|_| Number::from(integer))
}

/// A binary64 that one would write without a decimal point.
pub(super) fn whole(number: &Number) -> Option<i64> {
    let number = number.as_binary64()?;
    let is_whole = number.fract() == 0.0 && number.abs() <= MAX_WHOLE;
    is_whole.then_some(number as i64)
}

/// A number as one would write it.
pub(super) fn shown(number: &Number) -> String {
    match whole(number) {
        Some(whole) => whole.to_string(),
        None => number.to_string(),
    }
}

/// What can stand for a number: a binary64, an integer, or an exact number as
/// text, such as `"1/60"`.
pub trait IntoNumber {
    /// The number, unless it is not finite or not a number at all.
    fn into_number(self) -> Result<Number, NumberError>;
}

impl IntoNumber for Number {
    fn into_number(self) -> Given {
        Ok(self)
    }
}

impl IntoNumber for &Number {
    fn into_number(self) -> Given {
        Ok(self.clone())
    }
}

impl IntoNumber for f64 {
    fn into_number(self) -> Given {
        Number::try_from(self)
    }
}

impl IntoNumber for i32 {
    fn into_number(self) -> Given {
        Ok(bare(self))
    }
}

impl IntoNumber for i64 {
    fn into_number(self) -> Given {
        Ok(i32::try_from(self).map_or_else(|_| Number::from(self), bare))
    }
}

impl IntoNumber for &str {
    fn into_number(self) -> Given {
        self.parse()
    }
}

/// What can stand for a point or a vector: two numbers, or a
/// [`glam::DVec2`].
pub trait IntoPoint {
    /// The coordinates.
    fn into_point(self) -> [Result<Number, NumberError>; 2];
}

impl<T: IntoNumber> IntoPoint for [T; 2] {
    fn into_point(self) -> [Given; 2] {
        self.map(IntoNumber::into_number)
    }
}

impl<X: IntoNumber, Y: IntoNumber> IntoPoint for (X, Y) {
    fn into_point(self) -> [Given; 2] {
        [self.0.into_number(), self.1.into_number()]
    }
}
