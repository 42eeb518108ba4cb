//! The judgement of a log as JSON, `carom/verdict/1`.

use serde::Serialize;

use super::event::{Ending, Event};
use super::quantity::Bounds;
use crate::body::{BodyId, Pair};
use crate::judge::{Logged, Margin, Reference, Standing, Verdict};
use crate::scene::Scene;

/// What the judgement of a log comes to.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct Judgement {
    /// The format's name and version.
    pub schema: VerdictFormat,
    /// The scene's name.
    pub scene: String,
    /// How the log stands to the truth.
    pub verdict: Standing,
    /// The impacts that truly happen.
    pub impacts: u64,
    /// How the exact run ended, beyond which nothing is known.
    pub truth: Ending,
    /// The impacts of the log that are the true ones, before the first difference.
    pub matched: u64,
    /// The largest error of their times.
    pub time_error: f64,
    /// The same in ulps of the true time.
    pub time_error_ulps: f64,
    /// How many lines only tell again of a contact.
    pub repeats: u64,
    /// The first difference, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "FirstDifference"))]
    pub difference: Option<FirstDifference>,
}

/// The name and version of the format of judgements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "cli", schemars(inline))]
pub enum VerdictFormat {
    /// The first version.
    #[serde(rename = "carom/verdict/1")]
    Verdict1,
}

/// Where a log leaves the truth.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct FirstDifference {
    /// When.
    pub time: f64,
    /// The disc whose next impact is not the true one.
    pub disc: BodyId,
    /// What it truly meets next, if anything.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "TrueImpact"))]
    pub truth: Option<TrueImpact>,
    /// What the log has it meet instead, if anything.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "LoggedImpact"))]
    pub log: Option<LoggedImpact>,
    /// How close the decision was, where that is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "cli", schemars(with = "Margin"))]
    pub margin: Option<Margin>,
}

/// An impact that truly happens.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct TrueImpact {
    /// The disc, of two discs the one with the lower index.
    pub a: BodyId,
    /// The other disc, or the wall.
    pub b: BodyId,
    /// The binary64 nearest to its time.
    pub time: f64,
    /// A lower bound of the time.
    pub lo: String,
    /// An upper bound of the time.
    pub hi: String,
}

/// An impact as another program logs it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct LoggedImpact {
    /// The disc, of two discs the one with the lower index.
    pub a: BodyId,
    /// The other disc, or the wall.
    pub b: BodyId,
    /// Its time.
    pub time: f64,
}

impl Judgement {
    /// The judgement of a log, with so many digits of true times.
    pub fn new(scene: &Scene, reference: &Reference<'_>, verdict: &Verdict, digits: u32) -> Self {
        let difference = verdict.difference.as_ref();
        Self {
            schema: VerdictFormat::Verdict1,
            scene: scene.id().to_owned(),
            verdict: verdict.standing,
            impacts: reference.impacts().len() as u64,
            truth: reference.status().into(),
            matched: verdict.matched,
            time_error: verdict.time_error,
            time_error_ulps: verdict.time_error_ulps,
            repeats: verdict.repeats as u64,
            difference: difference.map(|difference| FirstDifference {
                time: difference.time,
                disc: difference.disc,
                truth: verdict
                    .missed
                    .and_then(|place| TrueImpact::new(reference, place, digits)),
                log: difference.candidate.map(LoggedImpact::from),
                margin: verdict.margin,
            }),
        }
    }
}

impl TrueImpact {
    fn new(reference: &Reference<'_>, place: usize, digits: u32) -> Option<Self> {
        let impact = &reference.impacts()[place];
        let Bounds { nearest, lo, hi } = Bounds::new(&impact.time, digits)?;
        let Pair { a, b } = impact.pair;
        Some(Self {
            a,
            b,
            time: nearest,
            lo,
            hi,
        })
    }
}

impl From<(Pair, f64)> for LoggedImpact {
    fn from((Pair { a, b }, time): (Pair, f64)) -> Self {
        Self { a, b, time }
    }
}

impl From<&Event> for Logged {
    /// The impact that a line tells, whichever body that names first.
    fn from(event: &Event) -> Self {
        Self {
            pair: Pair::new(event.a, event.b),
            time: event.time,
            tie: None,
        }
    }
}
