//! What is special about a question or a scene.

use schemars::JsonSchema;
use serde::Serialize;

/// What is special about it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
pub(super) enum Flag {
    /// Bodies pass at tangency, or within 2^-19 of their reach of it.
    Grazing,
    /// Impacts are proven to be simultaneous.
    Simultaneous,
    /// Bodies overlap at the start.
    InitialOverlap,
    /// Bodies overlap at the start by less than 2^-40 of their reach, as they do when
    /// positions of bodies in contact are rounded.
    OverlapByRounding,
    /// A disc meets two walls at once.
    CornerHit,
    /// The end of a wall is met; also where the foot of the perpendicular is exactly
    /// there.
    EndPoint,
    /// Masses differ by a factor of a thousand or more, or one is infinite.
    MassRatio,
    /// Two impacts follow each other within 2^-19 of their time, and are not
    /// simultaneous.
    NearTie,
    /// Coordinates are 500 times as large as the bodies and the way between them, or
    /// more.
    LargeOffset,
    /// The bodies miss, but a quick test has them meet: boxes about two discs, or the
    /// line that a wall is a part of.
    SpuriousCandidate,
    /// A frame of the scene, or of 1/60, takes a disc eight times its diameter, or more.
    Bullet,
}
