//! Bodies and end points of walls, as they are named in JSON.

use std::borrow::Cow;

use serde::de::{Deserialize, Deserializer, Error};
use serde::ser::{Serialize, Serializer};

use crate::body::{BodyId, End};

impl Serialize for BodyId {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for BodyId {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = Cow::<str>::deserialize(deserializer)?;
        body(&name).ok_or_else(|| {
            D::Error::custom(format!(
                "expected a disc (d0) or a wall (w0), found {name:?}"
            ))
        })
    }
}

fn body(name: &str) -> Option<BodyId> {
    let index = |digits: &str| {
        let all = digits.bytes().all(|digit| digit.is_ascii_digit());
        digits.parse().ok().filter(|_| all)
    };
    match name.split_at_checked(1)? {
        ("d", digits) => index(digits).map(BodyId::Disc),
        ("w", digits) => index(digits).map(BodyId::Wall),
        _ => None,
    }
}

impl Serialize for End {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for End {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = Cow::<str>::deserialize(deserializer)?;
        match name.as_ref() {
            "from" => Ok(Self::From),
            "to" => Ok(Self::To),
            _ => Err(D::Error::unknown_variant(&name, &["from", "to"])),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_read_back() {
        for id in [BodyId::Disc(0), BodyId::Disc(12), BodyId::Wall(3)] {
            assert_eq!(body(&id.to_string()), Some(id));
        }
        for name in [
            "",
            "d",
            "x1",
            "d-1",
            "d+1",
            "d1 ",
            "1",
            "é1",
            "d99999999999",
        ] {
            assert_eq!(body(name), None, "{name}");
        }
    }
}
