//! What comes of a scene: the program's log, held against the truth.

use std::ops::ControlFlow;

use carom::judge::{Difference, Reference, Standing, Verdict};
use carom::log::{Event, Judgement, MIN_DIGITS, proven_digits};
use carom::run::{Options, Status};
use carom::scene::Scene;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::foreign::{Failure, Foreign};
use crate::cli::check;

/// So many impacts are asked for: generated scenes have far fewer, and a program that
/// rounds may find millions where a disc gets stuck between two walls.
const MAX_EVENTS: u64 = 10_000;

/// How the program fares with a scene.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Class {
    /// It follows the truth to the end.
    Follows,
    /// It differs by a convention: of simultaneous impacts, or tangent passes.
    Convention,
    /// It differs where binary64 no longer carries the order.
    Beyond,
    /// It differs by what is closer than binary64 resolves.
    Close,
    /// It says that it does not simulate such scenes.
    Declined,
    /// It is not seen to be wrong, and the truth is not known to the end.
    Unknown,
    /// It lets a disc go past an impact.
    Missed,
    /// It has a disc collide where nothing is.
    Spurious,
    /// Its order is right, and a time further from the truth than is allowed.
    Inaccurate,
    /// It does not answer in time.
    Timeout,
    /// It ends.
    Crash,
    /// Its answer makes no sense.
    Garbage,
}

impl Class {
    pub(super) const ALL: [Self; 12] = [
        Self::Follows,
        Self::Convention,
        Self::Beyond,
        Self::Close,
        Self::Declined,
        Self::Unknown,
        Self::Missed,
        Self::Spurious,
        Self::Inaccurate,
        Self::Timeout,
        Self::Crash,
        Self::Garbage,
    ];

    /// Whether something is wrong with the program.
    pub(super) fn is_finding(self) -> bool {
        self >= Self::Missed
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Follows => "follows",
            Self::Convention => "convention",
            Self::Beyond => "beyond",
            Self::Close => "close",
            Self::Declined => "declined",
            Self::Unknown => "unknown",
            Self::Missed => "missed",
            Self::Spurious => "spurious",
            Self::Inaccurate => "inaccurate",
            Self::Timeout => "timeout",
            Self::Crash => "crash",
            Self::Garbage => "garbage",
        }
    }
}

/// What comes of a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(super) struct Outcome {
    /// How the program fares with it.
    pub(super) class: Class,
    /// The largest error of a time, as far as the order is right.
    pub(super) time_error: f64,
    /// What is wrong, or why there is nothing to judge.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    pub(super) detail: Option<String>,
}

impl Outcome {
    fn unjudged(class: Class, detail: String) -> Self {
        Self {
            class,
            time_error: 0.0,
            detail: Some(detail),
        }
    }
}

/// An answer to a question.
#[derive(Deserialize)]
struct Answer {
    #[serde(default)]
    id: Value,
    #[serde(default)]
    events: Option<Vec<Event>>,
    #[serde(default)]
    error: Option<Value>,
}

/// Asks a program about scenes, and judges what it says.
pub(super) struct Examiner<'a> {
    foreign: Foreign<'a>,
    options: &'a Options,
    /// The largest error of a time that is none.
    tolerance: Option<f64>,
    asked: u64,
}

impl<'a> Examiner<'a> {
    pub(super) fn new(foreign: Foreign<'a>, options: &'a Options, tolerance: Option<f64>) -> Self {
        Self {
            foreign,
            options,
            tolerance,
            asked: 0,
        }
    }

    /// What comes of a scene.
    pub(super) fn examine(&mut self, scene: &Scene) -> Outcome {
        let events = match self.events(scene) {
            Ok(events) => events,
            Err(outcome) => return outcome,
        };
        let log = match check::logged(scene, &events) {
            Ok(log) => log,
            Err(reason) => return Outcome::unjudged(Class::Garbage, reason),
        };
        let go_on = &mut |_| ControlFlow::Continue(());
        let reference = match Reference::find(scene, self.options, go_on) {
            Ok(reference) => reference,
            Err(reason) => return Outcome::unjudged(Class::Unknown, reason.to_string()),
        };
        let verdict = reference.judge(&log);
        let class = self.class(&verdict, reference.status());
        let judgement = Judgement::new(scene, &reference, &verdict, MIN_DIGITS);
        let told = judgement.difference.as_ref().map(check::told);
        Outcome {
            class,
            time_error: verdict.time_error,
            detail: told.map(|lines| lines.join("; ")),
        }
    }

    /// The program's log, or why there is none.
    fn events(&mut self, scene: &Scene) -> Result<Vec<Event>, Outcome> {
        self.asked += 1;
        let id = self.asked;
        // In JSON a line can only end where a blank may be.
        let scene = scene.to_json().replace('\n', " ");
        let question = format!(
            r#"{{"id": {id}, "request": "simulate", "max_events": {MAX_EVENTS}, "scene": {scene}}}"#
        );
        let line = self.foreign.ask(question).map_err(Outcome::from)?;
        let garbage = |reason: String| Outcome::unjudged(Class::Garbage, reason);
        let answer = serde_json::from_slice(&line).map_err(|error| error.to_string());
        let answer = answer.and_then(|answer: Answer| match answer.id == id {
            true => Ok(answer),
            false => Err(format!("expected the id {id}, found {}", answer.id)),
        });
        let answer = answer.map_err(|reason| {
            self.foreign.stop();
            garbage(reason)
        })?;
        match (answer.error, answer.events) {
            (Some(error), _) => Err(Outcome::unjudged(Class::Declined, error.to_string())),
            (None, Some(events)) => Ok(events),
            (None, None) => Err(garbage(String::from("expected the key events"))),
        }
    }

    fn class(&self, verdict: &Verdict, status: &Status) -> Class {
        let is_late = |tolerance| verdict.time_error > tolerance;
        match (verdict.standing, &verdict.difference) {
            (Standing::Differs, Some(difference)) => wrong(difference),
            _ if self.tolerance.is_some_and(is_late) => Class::Inaccurate,
            _ if !matches!(status, Status::Complete) => Class::Unknown,
            (Standing::Follows | Standing::Differs, _) => Class::Follows,
            (Standing::Simultaneous | Standing::Tangent, _) => Class::Convention,
            (Standing::Beyond, _) => Class::Beyond,
            (Standing::Close, _) => Class::Close,
        }
    }
}

/// Whether a disc goes past its next impact, or has another one before that.
fn wrong(difference: &Difference) -> Class {
    match (difference.truth, difference.candidate) {
        (Some((_, truth)), Some((_, other))) if other < truth => Class::Spurious,
        (Some(_), _) => Class::Missed,
        (None, _) => Class::Spurious,
    }
}

impl From<Failure> for Outcome {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Timeout => Self::unjudged(Class::Timeout, String::from("no answer in time")),
            Failure::Crash(ending) => Self::unjudged(Class::Crash, ending),
            Failure::Garbage(what) => Self::unjudged(Class::Garbage, what),
        }
    }
}

/// The options of the truth.
pub(super) fn options() -> Options {
    Options {
        digits: proven_digits(MIN_DIGITS),
        max_events: MAX_EVENTS,
        ..Options::default()
    }
}
