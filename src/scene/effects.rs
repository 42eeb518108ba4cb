//! What acts on the discs besides free motion.

use crate::scalar::Number;

/// The effects of a scene. What is absent is not simulated and costs nothing.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "json",
    derive(serde::Serialize, serde::Deserialize),
    serde(default, deny_unknown_fields)
)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct Effects {
    /// What impacts leave of the motion; elastic if absent.
    #[cfg_attr(
        feature = "json",
        serde(
            deserialize_with = "super::json::object::one",
            skip_serializing_if = "Restitution::is_elastic"
        )
    )]
    pub restitution: Restitution,
    /// The acceleration of every disc of finite mass.
    #[cfg_attr(
        feature = "json",
        serde(
            deserialize_with = "super::json::present",
            skip_serializing_if = "Option::is_none"
        )
    )]
    #[cfg_attr(feature = "cli", schemars(with = "[Number; 2]"))]
    pub gravity: Option<[Number; 2]>,
    /// Linear drag: the rate k, not negative, at which the velocity of every
    /// disc of finite mass decays, v' = -k v.
    #[cfg_attr(
        feature = "json",
        serde(with = "super::json::linear", skip_serializing_if = "Option::is_none")
    )]
    #[cfg_attr(feature = "cli", schemars(with = "super::json::linear::Drag"))]
    pub drag: Option<Number>,
}

/// What impacts leave of the motion.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "json",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        try_from = "super::json::restitution::Keys",
        into = "super::json::restitution::Keys"
    )
)]
pub enum Restitution {
    /// Impacts lose nothing.
    #[default]
    Elastic,
    /// Newton's law: the normal relative speed after an impact is so many
    /// times that before.
    Newton {
        /// From 0, perfectly inelastic, to 1, elastic.
        coefficient: Number,
        /// The coefficient of impacts with walls, where it differs.
        walls: Option<Number>,
        /// Impacts with a normal relative speed below this positive number
        /// lose nothing: the usual cure for inelastic collapse.
        elastic_below: Option<Number>,
    },
    /// The paper's convention: after the elastic response, the whole velocity
    /// is multiplied by 1 - C.
    ///
    /// It is not invariant under a change of the frame of reference, nor does
    /// it conserve momentum, and beside a moving body of infinite mass it has
    /// no consistent meaning.
    Paper {
        /// C, from 0, elastic, to 1, all energy lost.
        loss: Number,
    },
}

impl Restitution {
    /// Newton's law with one coefficient for all impacts.
    pub fn newton(coefficient: Number) -> Self {
        Self::Newton {
            coefficient,
            walls: None,
            elastic_below: None,
        }
    }

    /// The paper's convention.
    pub fn paper(loss: Number) -> Self {
        Self::Paper { loss }
    }

    /// Whether impacts lose nothing because nothing else was asked for.
    pub fn is_elastic(&self) -> bool {
        *self == Self::Elastic
    }
}
