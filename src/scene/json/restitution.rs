//! Restitution in JSON, where its kind shows in its keys.

use super::present;
use crate::scalar::Number;
use crate::scene::Restitution;

/// Every key that a restitution may have; which go together is checked after
/// reading, so that an error names the key.
#[derive(Default, serde::Serialize, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(in crate::scene) struct Keys {
    #[serde(deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    newton: Option<Number>,
    #[serde(deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    walls: Option<Number>,
    #[serde(deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    elastic_below: Option<Number>,
    #[serde(deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    paper: Option<Number>,
}

impl TryFrom<Keys> for Restitution {
    type Error = &'static str;

    fn try_from(keys: Keys) -> Result<Self, Self::Error> {
        match keys {
            Keys {
                newton: Some(coefficient),
                walls,
                elastic_below,
                paper: None,
            } => Ok(Self::Newton {
                coefficient,
                walls,
                elastic_below,
            }),
            Keys {
                newton: None,
                walls: None,
                elastic_below: None,
                paper: Some(loss),
            } => Ok(Self::Paper { loss }),
            Keys { paper: Some(_), .. } => Err("expected the key `paper` alone, found others"),
            Keys { paper: None, .. } => Err("expected the key `newton` or `paper`, found neither"),
        }
    }
}

impl From<Restitution> for Keys {
    fn from(restitution: Restitution) -> Self {
        match restitution {
            Restitution::Elastic => Self::default(),
            Restitution::Newton {
                coefficient,
                walls,
                elastic_below,
            } => Self {
                newton: Some(coefficient),
                walls,
                elastic_below,
                paper: None,
            },
            Restitution::Paper { loss } => Self {
                paper: Some(loss),
                ..Self::default()
            },
        }
    }
}
