//! What bounds a scene: walls, or a cell that repeats.

use crate::scalar::Number;

/// A two-sided segment. A disc meets its interior or one of its end points.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "json",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct Wall {
    /// One end point.
    pub from: [Number; 2],
    /// The other end point, different from the first.
    pub to: [Number; 2],
}

/// The rectangle that a periodic scene repeats in both directions.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "json",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct Cell {
    /// The lower left corner.
    pub from: [Number; 2],
    /// The upper right corner.
    pub to: [Number; 2],
}

impl Cell {
    /// The lengths of the sides.
    ///
    /// # Panics
    ///
    /// If they are no numbers: those of a [`Scene`](super::Scene) are.
    pub fn sides(&self) -> [Number; 2] {
        [0, 1].map(|axis| {
            let side = self.to[axis].to_rational() - self.from[axis].to_rational();
            Number::try_from(side).expect("the sides of a scene's cell are numbers")
        })
    }
}
