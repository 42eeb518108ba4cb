//! What is answered.

use std::ops::ControlFlow;

use carom::arithmetic::Arithmetic;
use carom::body::End;
use carom::first_impact::{Class, FirstImpact, of_disc_and_wall, of_discs};
use carom::judge::Reference;
use carom::log::{Event, Header, Judgement, MIN_DIGITS, Recorder, Summary, proven_digits};
use carom::run::{Options, run};
use carom::scalar::{Exact, Filtered};
use carom::scene::Scene;
use carom::simulation::Algorithm;
use serde::Serialize;
use serde_json::value::RawValue;

use super::Method;
use super::request::{Kind, Request};
use crate::cli::check;
use crate::cli::choice::ArithmeticName;
use crate::cli::time::Time;

/// An answer, and to which question.
#[derive(Serialize)]
pub(super) struct Answer<'a> {
    id: Option<&'a RawValue>,
    #[serde(flatten)]
    content: Content,
}

/// What is said.
#[derive(Serialize)]
#[serde(untagged)]
pub(super) enum Content {
    Met(Met),
    Log(Box<LogAnswer>),
    Verdict { verdict: Box<Judgement> },
    Error { error: Problem },
}

/// How two bodies first meet.
#[derive(Serialize)]
pub(super) struct Met {
    class: Class,
    #[serde(skip_serializing_if = "Option::is_none")]
    time: Option<Time>,
    #[serde(skip_serializing_if = "Option::is_none")]
    end: Option<End>,
}

/// A proven log.
#[derive(Serialize)]
pub(super) struct LogAnswer {
    header: Header,
    events: Vec<Event>,
    summary: Summary,
}

/// Why a line has no answer.
#[derive(Serialize)]
pub(super) struct Problem {
    line: u64,
    reason: String,
}

impl<'a> Answer<'a> {
    /// The answer to a line of some number, or what is wrong with that.
    pub(super) fn new(
        id: Option<&'a RawValue>,
        answered: Result<Content, String>,
        line: u64,
    ) -> Self {
        let content = answered.unwrap_or_else(|reason| Content::Error {
            error: Problem { line, reason },
        });
        Self { id, content }
    }
}

/// Answers a request; what is simulated, by a method.
pub(super) fn to(request: &Request<'_>, method: Method) -> Result<Content, String> {
    match request.request {
        Kind::FirstImpact => first_impact(request).map(Content::Met),
        Kind::Simulate => simulate(request, method).map(|log| Content::Log(Box::new(log))),
        Kind::Judge => judge(request).map(|verdict| Content::Verdict {
            verdict: Box::new(verdict),
        }),
    }
}

fn first_impact(request: &Request<'_>) -> Result<Met, String> {
    let [a, b] = [wanted(request.a, "a")?, wanted(request.b, "b")?];
    let is_wall = b.contains("\"from\"");
    let bodies = match is_wall {
        true => format!(r#""discs": [{a}], "walls": [{b}]"#),
        false => format!(r#""discs": [{a}, {b}]"#),
    };
    let scene = Scene::from_json(&format!(r#"{{"schema": "carom/scene/1", {bodies}}}"#));
    let scene = scene.map_err(|error| named(&error.to_string()))?;
    Ok(Met::from(match is_wall {
        true => of_disc_and_wall(&scene.discs()[0], &scene.walls()[0]),
        false => of_discs(&scene.discs()[0], &scene.discs()[1]),
    }))
}

/// What is wrong with a body, by the name that it has in a request.
fn named(problem: &str) -> String {
    let names = [("discs[0]", "a"), ("discs[1]", "b"), ("walls[0]", "b")];
    let named = |(body, name)| Some(format!("{name}{}", problem.strip_prefix(body)?));
    let mut named = names.into_iter().filter_map(named);
    named.next().unwrap_or_else(|| problem.to_owned())
}

fn simulate(request: &Request<'_>, method: Method) -> Result<LogAnswer, String> {
    match method.arithmetic {
        ArithmeticName::Binary64 => simulate_in::<f64>(request, method.algorithm),
        ArithmeticName::Filtered => simulate_in::<Filtered>(request, method.algorithm),
        ArithmeticName::Exact => simulate_in::<Exact>(request, method.algorithm),
    }
}

fn simulate_in<S: Arithmetic>(
    request: &Request<'_>,
    algorithm: Algorithm,
) -> Result<LogAnswer, String> {
    let scene = scene(request)?;
    let digits = digits(request)?;
    let options = Options {
        contacts: request.contact,
        max_events: request.max_events.unwrap_or(Options::default().max_events),
        ..options(request, digits)
    };
    let go_on = &mut |_| ControlFlow::Continue(());
    let outcome = run::<S>(&scene, algorithm, &options, go_on);
    let outcome = outcome.map_err(|reason| reason.to_string())?;
    let recorder = Recorder::new(&scene, algorithm, &options, &outcome).digits(digits);
    Ok(LogAnswer {
        header: recorder.header(),
        events: recorder.events().collect(),
        summary: recorder.summary(),
    })
}

fn judge(request: &Request<'_>) -> Result<Judgement, String> {
    let scene = scene(request)?;
    let digits = digits(request)?;
    let events = request.events.as_deref();
    let events = events.ok_or("expected the key events")?;
    let log = check::logged(&scene, events)?;
    let go_on = &mut |_| ControlFlow::Continue(());
    let reference = Reference::find(&scene, &options(request, digits), go_on);
    let reference = reference.map_err(|reason| reason.to_string())?;
    Ok(Judgement::new(
        &scene,
        &reference,
        &reference.judge(&log),
        digits,
    ))
}

fn options(request: &Request<'_>, digits: u32) -> Options {
    Options {
        until: request.until.clone(),
        digits: proven_digits(digits),
        ..Options::default()
    }
}

fn digits(request: &Request<'_>) -> Result<u32, String> {
    match request.digits.unwrap_or(MIN_DIGITS) {
        digits @ MIN_DIGITS..=10_000 => Ok(digits),
        digits => Err(format!("digits: expected 20 to 10000, found {digits}")),
    }
}

fn scene(request: &Request<'_>) -> Result<Scene, String> {
    let scene = Scene::from_json(wanted(request.scene, "scene")?);
    scene.map_err(|error| error.to_string())
}

fn wanted<'a>(value: Option<&'a RawValue>, key: &str) -> Result<&'a str, String> {
    let value = value.map(RawValue::get);
    value.ok_or_else(|| format!("expected the key {key}"))
}

impl From<FirstImpact> for Met {
    fn from(met: FirstImpact) -> Self {
        Self {
            class: met.class,
            end: met.end,
            time: met.time.as_ref().map(Time::from),
        }
    }
}
