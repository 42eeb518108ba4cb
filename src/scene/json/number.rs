//! Numbers and masses in JSON: bare ones are binary64, strings are exact.

use std::fmt;

use serde::de::{Deserialize, Deserializer, Error, Visitor};
use serde::ser::{Serialize, Serializer};

use crate::scalar::Number;
use crate::scene::Mass;
use crate::scene::input::whole;

/// The mass of a body that collisions never deflect.
const INFINITE: &str = "infinite";

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberVisitor)
    }
}

struct NumberVisitor;

impl Visitor<'_> for NumberVisitor {
    type Value = Number;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, or an exact number as a string")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Number, E> {
        Number::try_from(number).map_err(E::custom)
    }

    /// The nearest binary64, as for every bare number.
    fn visit_u64<E: Error>(self, number: u64) -> Result<Number, E> {
        self.visit_f64(number as f64)
    }

    /// The nearest binary64, as for every bare number.
    fn visit_i64<E: Error>(self, number: i64) -> Result<Number, E> {
        self.visit_f64(number as f64)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Number, E> {
        text.parse().map_err(E::custom)
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match (self.as_binary64(), whole(self)) {
            (None, _) => serializer.collect_str(self),
            (Some(_), Some(whole)) => serializer.serialize_i64(whole),
            (Some(number), None) => serializer.serialize_f64(number),
        }
    }
}

impl<'de> Deserialize<'de> for Mass {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(MassVisitor)
    }
}

struct MassVisitor;

impl Visitor<'_> for MassVisitor {
    type Value = Mass;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a number, an exact number as a string, or {INFINITE:?}")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Mass, E> {
        NumberVisitor.visit_f64(number).map(Mass::Finite)
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<Mass, E> {
        NumberVisitor.visit_u64(number).map(Mass::Finite)
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Mass, E> {
        NumberVisitor.visit_i64(number).map(Mass::Finite)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Mass, E> {
        match text {
            INFINITE => Ok(Mass::Infinite),
            _ => NumberVisitor.visit_str(text).map(Mass::Finite),
        }
    }
}

impl Serialize for Mass {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Finite(mass) => mass.serialize(serializer),
            Self::Infinite => serializer.serialize_str(INFINITE),
        }
    }
}
