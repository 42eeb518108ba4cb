//! Drag, which is linear: `{"linear": k}`.

use serde::de::Deserializer;
use serde::ser::{Serialize, Serializer};

use super::object;
use crate::scalar::Number;

/// Linear drag, v' = -k v.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub(in crate::scene) struct Drag {
    /// The rate k, not negative.
    linear: Number,
}

pub(in crate::scene) fn deserialize<'de, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Option<Number>, D::Error> {
    let drag: Drag = object::one(deserializer)?;
    Ok(Some(drag.linear))
}

pub(in crate::scene) fn serialize<S: Serializer>(
    rate: &Option<Number>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let drag = rate.clone().map(|linear| Drag { linear });
    drag.serialize(serializer)
}
