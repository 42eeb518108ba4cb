//! A line of JSON in, a line of JSON out.

use std::io::{self, BufRead, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};

use carom::scene::Scene;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

use crate::plain::{Disc, Plain, Wall};

/// A program that finds impacts. What it does not offer is told in words.
pub trait Engine {
    /// The impacts of a scene, in order.
    fn simulate(&mut self, scene: &Plain) -> Result<Vec<Impact>, String>;

    /// When a disc first meets something, if ever.
    fn first_impact(&mut self, disc: &Disc, other: &Body) -> Result<Option<f64>, String>;
}

/// What a disc may meet.
#[derive(Clone, Debug)]
pub enum Body {
    /// Another disc.
    Disc(Disc),
    /// A wall.
    Wall(Wall),
}

/// An impact: when, and of which bodies.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Impact {
    time: f64,
    a: String,
    b: String,
}

impl Impact {
    /// Of two discs.
    pub fn of_discs(time: f64, i: usize, j: usize) -> Self {
        let (a, b) = (format!("d{}", i.min(j)), format!("d{}", i.max(j)));
        Self { time, a, b }
    }

    /// Of a disc and a wall.
    pub fn with_wall(time: f64, i: usize, j: usize) -> Self {
        let (a, b) = (format!("d{i}"), format!("w{j}"));
        Self { time, a, b }
    }
}

#[derive(Deserialize)]
struct Request<'a> {
    request: String,
    #[serde(borrow, default)]
    scene: Option<&'a RawValue>,
    #[serde(borrow, default)]
    a: Option<&'a RawValue>,
    #[serde(borrow, default)]
    b: Option<&'a RawValue>,
}

/// The name alone, of a line that is no request otherwise.
#[derive(Default, Deserialize)]
struct Named<'a> {
    #[serde(borrow, default)]
    id: Option<&'a RawValue>,
}

#[derive(Serialize)]
struct Answer<'a> {
    id: Option<&'a RawValue>,
    #[serde(flatten)]
    content: Content,
}

#[derive(Serialize)]
#[serde(untagged)]
enum Content {
    Events {
        events: Vec<Impact>,
    },
    Meeting {
        class: &'static str,
        #[serde(skip_serializing_if = "Option::is_none")]
        time: Option<Time>,
    },
    Error {
        error: Problem,
    },
}

#[derive(Serialize)]
struct Time {
    f64: f64,
}

#[derive(Serialize)]
struct Problem {
    reason: String,
}

/// Answers all lines of standard input, until it ends.
pub fn serve(engine: &mut dyn Engine) -> io::Result<()> {
    serve_lines(engine, io::stdin().lock(), io::stdout().lock())
}

fn serve_lines(
    engine: &mut dyn Engine,
    mut input: impl BufRead,
    mut output: impl Write,
) -> io::Result<()> {
    let mut line = Vec::new();
    while input.read_until(b'\n', &mut line)? > 0 {
        if !line.trim_ascii().is_empty() {
            serde_json::to_writer(&mut output, &answer(engine, &line))?;
            output.write_all(b"\n")?;
            output.flush()?;
        }
        line.clear();
    }
    Ok(())
}

fn answer<'a>(engine: &mut dyn Engine, line: &'a [u8]) -> Answer<'a> {
    let named = serde_json::from_slice::<Named<'_>>(line).unwrap_or_default();
    let told = catch_unwind(AssertUnwindSafe(|| content(engine, line)));
    let told = told.unwrap_or_else(|_| Err(String::from("the engine panicked")));
    Answer {
        id: named.id,
        content: told.unwrap_or_else(|reason| Content::Error {
            error: Problem { reason },
        }),
    }
}

fn content(engine: &mut dyn Engine, line: &[u8]) -> Result<Content, String> {
    let request: Request = serde_json::from_slice(line).map_err(|error| error.to_string())?;
    match request.request.as_str() {
        "simulate" => {
            let scene = plain(wanted(request.scene, "scene")?)?;
            let events = engine.simulate(&scene)?;
            match events.iter().all(|event| event.time.is_finite()) {
                true => Ok(Content::Events { events }),
                false => Err(String::from("the engine's time is not finite")),
            }
        }
        "first-impact" => {
            let (disc, other) = bodies(wanted(request.a, "a")?, wanted(request.b, "b")?)?;
            meeting(engine.first_impact(&disc, &other)?)
        }
        other => Err(format!("expected simulate or first-impact, found {other}")),
    }
}

fn meeting(time: Option<f64>) -> Result<Content, String> {
    let class = if time.is_some() { "hit" } else { "miss" };
    let time = time.map(|f64| Time { f64 });
    match time.as_ref().is_none_or(|time| time.f64.is_finite()) {
        true => Ok(Content::Meeting { class, time }),
        false => Err(String::from("the engine's time is not finite")),
    }
}

fn plain(scene: &str) -> Result<Plain, String> {
    Plain::new(&Scene::from_json(scene).map_err(|error| error.to_string())?)
}

/// A disc and what it meets, read as a scene of these two.
fn bodies(a: &str, b: &str) -> Result<(Disc, Body), String> {
    let is_wall = b.contains("\"from\"");
    let bodies = match is_wall {
        true => format!(r#""discs": [{a}], "walls": [{b}]"#),
        false => format!(r#""discs": [{a}, {b}]"#),
    };
    let scene = plain(&format!(r#"{{"schema": "carom/scene/1", {bodies}}}"#))?;
    let other = match is_wall {
        true => Body::Wall(scene.walls[0]),
        false => Body::Disc(scene.discs[1]),
    };
    Ok((scene.discs[0], other))
}

fn wanted<'a>(value: Option<&'a RawValue>, key: &str) -> Result<&'a str, String> {
    let value = value.map(RawValue::get);
    value.ok_or_else(|| format!("expected the key {key}"))
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;

    /// Answers with what it is asked, or panics.
    struct Echo;

    impl Engine for Echo {
        fn simulate(&mut self, scene: &Plain) -> Result<Vec<Impact>, String> {
            assert!(!scene.discs.is_empty(), "an engine may panic");
            Ok(vec![Impact::of_discs(scene.until(), 2, 1)])
        }

        fn first_impact(&mut self, disc: &Disc, other: &Body) -> Result<Option<f64>, String> {
            match other {
                Body::Disc(other) => Ok(Some(disc.radius + other.radius)),
                Body::Wall(_) => Err(String::from("no walls")),
            }
        }
    }

    fn answers(lines: &[u8]) -> Vec<Value> {
        let mut output = Vec::new();
        serve_lines(&mut Echo, lines, &mut output).expect("text");
        let lines = output.split(|byte| *byte == b'\n');
        let lines = lines.filter(|line| !line.is_empty());
        lines
            .map(|line| serde_json::from_slice(line).expect("JSON"))
            .collect()
    }

    #[test]
    fn each_line_has_its_answer() {
        let answers = answers(
            br#"{"id": "x", "request": "simulate", "scene": {"schema": "carom/scene/1", "discs": [{"position": [0, 0], "radius": 1}], "frame": {"duration": "1/2", "count": 3}}}

{"id": [2], "request": "first-impact", "a": {"position": [0, 0], "radius": "0x1p-1"}, "b": {"position": [5, 0], "radius": 1}}
{"id": 3, "request": "first-impact", "a": {"position": [0, 0], "radius": 1}, "b": {"from": [5, 0], "to": [6, 0]}}
"#,
        );
        let event = json!({"time": 1.5, "a": "d1", "b": "d2"});
        assert_eq!(answers[0], json!({"id": "x", "events": [event]}));
        let hit = json!({"id": [2], "class": "hit", "time": {"f64": 1.5}});
        assert_eq!(answers[1], hit);
        assert_eq!(answers[2]["error"]["reason"], "no walls");
        assert_eq!(answers.len(), 3);
    }

    #[test]
    fn bad_lines_are_answered_too() {
        let answers = answers(
            b"{\n\xff\n[]\n{\"id\": 4, \"request\": \"guess\"}\n\
            {\"id\": 5, \"request\": \"simulate\"}\n\
            {\"id\": 6, \"request\": \"simulate\", \"scene\": {\"schema\": \"carom/scene/1\", \"discs\": []}}\n\
            {\"id\": 7, \"request\": \"first-impact\", \"a\": {\"position\": [0, 0], \"radius\": 0}, \"b\": {}}\n",
        );
        assert_eq!(answers.len(), 7);
        assert!(
            answers
                .iter()
                .all(|answer| answer["error"]["reason"].is_string())
        );
        assert_eq!(answers[5]["error"]["reason"], "the engine panicked");
        let ids: Vec<_> = answers.iter().map(|answer| answer["id"].clone()).collect();
        assert_eq!(
            ids[2..],
            [Value::Null, 4.into(), 5.into(), 6.into(), 7.into()]
        );
    }
}
