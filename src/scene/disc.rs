//! Discs, as written.

use super::input::{Given, IntoNumber, IntoPoint, bare};
use crate::scalar::{Number, NumberError};

/// A disc at the start of a scene.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "json",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct Disc {
    /// The centre.
    pub position: [Number; 2],
    /// The velocity; at rest if absent.
    #[cfg_attr(feature = "json", serde(default = "at_rest"))]
    pub velocity: [Number; 2],
    /// The radius, a positive number.
    pub radius: Number,
    /// The mass, a positive number or infinite; 1 if absent.
    #[cfg_attr(feature = "json", serde(default))]
    pub mass: Mass,
}

/// What a disc weighs.
#[derive(Clone, Debug, PartialEq)]
pub enum Mass {
    /// A positive number.
    Finite(Number),
    /// The disc is never deflected, though it may move.
    Infinite,
}

impl Disc {
    /// A disc at rest, of mass 1.
    pub fn at(position: impl IntoPoint, radius: impl IntoNumber) -> DiscBuilder {
        DiscBuilder {
            position: position.into_point(),
            velocity: at_rest().map(Ok),
            radius: radius.into_number(),
            mass: Ok(Mass::default()),
        }
    }
}

impl Default for Mass {
    /// Mass 1.
    fn default() -> Self {
        Self::Finite(bare(1))
    }
}

fn at_rest() -> [Number; 2] {
    [bare(0), bare(0)]
}

/// A disc in the making. What is wrong with its numbers is told when the
/// scene is built.
#[derive(Clone, Debug)]
#[must_use = "a disc in the making belongs to no scene yet"]
pub struct DiscBuilder {
    pub(super) position: [Given; 2],
    pub(super) velocity: [Given; 2],
    pub(super) radius: Given,
    pub(super) mass: Result<Mass, NumberError>,
}

impl DiscBuilder {
    /// Sets the velocity.
    pub fn velocity(mut self, velocity: impl IntoPoint) -> Self {
        self.velocity = velocity.into_point();
        self
    }

    /// Sets the mass.
    pub fn mass(mut self, mass: impl IntoNumber) -> Self {
        self.mass = mass.into_number().map(Mass::Finite);
        self
    }

    /// Makes the disc one that collisions never deflect.
    pub fn infinite_mass(mut self) -> Self {
        self.mass = Ok(Mass::Infinite);
        self
    }
}

impl From<Disc> for DiscBuilder {
    fn from(disc: Disc) -> Self {
        Self {
            position: disc.position.map(Ok),
            velocity: disc.velocity.map(Ok),
            radius: Ok(disc.radius),
            mass: Ok(disc.mass),
        }
    }
}
