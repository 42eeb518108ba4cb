//! The lines of an event log.

use serde::{Deserialize, Serialize};

use super::contact::Contact;
use super::quantity::Quantity;
use crate::body::{BodyId, End};

/// The first line: what was run, and how.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct Header {
    /// The format's name and version.
    pub schema: EventsFormat,
    /// The scene's name.
    pub scene: String,
    /// The algorithm.
    pub algorithm: String,
    /// The arithmetic.
    pub arithmetic: String,
    /// The version of carom.
    pub carom: String,
    /// The bits of exact arithmetic's enclosures.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "u32"))]
    pub bits: Option<u32>,
    /// How often exact arithmetic started again with more bits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "u32"))]
    pub restarts: Option<u32>,
    /// How many of the bits were lost up to the end, by the disc that is known
    /// least.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "u32"))]
    pub bits_lost: Option<u32>,
    /// How many leading bits the closest two different times had in common of
    /// which it had to be found out which is the first, at most: how well
    /// conditioned the scene is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "u32"))]
    pub closest_bits: Option<u32>,
    /// The most passes a frame, of an algorithm that has them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "u32"))]
    pub passes: Option<u32>,
    /// The milliseconds after which a frame's passes end, where that is what
    /// ends them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "f64"))]
    pub frame_budget: Option<f64>,
    /// The steps a frame, of an algorithm that has them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "u32"))]
    pub substeps: Option<u32>,
    /// The rule for simultaneous impacts that share a disc, of an algorithm
    /// that has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "String"))]
    pub simultaneous: Option<String>,
    /// How many pairs overlapped at the start, if any did.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "u64"))]
    pub overlaps: Option<u64>,
}

/// The name and version of the format of event logs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "cli", schemars(inline))]
pub enum EventsFormat {
    /// The first version.
    #[serde(rename = "carom/events/1")]
    Events1,
}

/// The line of an impact. Another program's log needs only the time and the
/// two bodies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct Event {
    /// Its place in the log, from zero on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "u64"))]
    pub n: Option<u64>,
    /// When it happens; in exact arithmetic the binary64 nearest to that. Of
    /// a frame algorithm, the time on the first body's clock.
    pub time: f64,
    /// A lower bound of the true time, a decimal or a fraction; in exact
    /// arithmetic only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "String"))]
    pub lo: Option<String>,
    /// An upper bound, equal to the lower one if the time is rational.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "String"))]
    pub hi: Option<String>,
    /// The time on the second body's clock, where that differs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "f64"))]
    pub time_b: Option<f64>,
    /// The frame in which a frame algorithm found it, from zero on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "u64"))]
    pub frame: Option<u64>,
    /// The pass or the step within the frame, from one on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "u32"))]
    pub pass: Option<u32>,
    /// The disc, of two discs the one with the lower index.
    pub a: BodyId,
    /// The other disc, or the wall.
    pub b: BodyId,
    /// The wall's end point that is hit, if it is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "End"))]
    pub end: Option<End>,
    /// In a periodic scene, which copy of the second body the first one meets: so many
    /// cells further on, as places go on beyond the cell.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "[i64; 2]"))]
    pub image: Option<[i64; 2]>,
    /// The number that impacts proven to be simultaneous share.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "u32"))]
    pub tie: Option<u32>,
    /// The circumstances, if they were asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "Contact"))]
    pub contact: Option<Contact>,
}

/// The last line: how the run ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct Summary {
    /// The number of impacts.
    pub events: u64,
    /// The number of tangent passes.
    pub grazes: u64,
    /// The number of contacts that became resting.
    pub resting: u64,
    /// The time at which the run was to end.
    pub until: f64,
    /// The time that the run reached instead.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "f64"))]
    pub reached: Option<f64>,
    /// How it ended.
    pub status: Ending,
    /// What was left undecided.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "String"))]
    pub question: Option<String>,
    /// The bits that did not decide it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "u32"))]
    pub bits: Option<u32>,
    /// The time that infinitely many impacts approach: expected, or proven to
    /// lie within bounds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "Quantity"))]
    pub limit: Option<Quantity>,
    /// Whether it is proven that they do.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "bool"))]
    pub proven: Option<bool>,
    /// The pairs that then collide in turn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "Vec<[BodyId; 2]>"))]
    pub word: Option<Vec<[BodyId; 2]>>,
    /// The kinetic energy of the discs of finite mass, at the start and at
    /// the end.
    pub energy: [f64; 2],
    /// Their momentum, at the start and at the end.
    pub momentum: [[f64; 2]; 2],
}

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Ending {
    /// At its end.
    Complete,
    /// The arithmetic's budget ran out.
    Undecided,
    /// Infinitely many impacts approach a finite time.
    Accumulation,
    /// There were as many impacts as allowed.
    EventLimit,
    /// It was stopped from outside.
    Interrupted,
}
