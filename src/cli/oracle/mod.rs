//! `carom oracle`: questions on standard input, answers on standard output, a line each.

mod answer;
mod request;

use std::io::{self, BufRead, BufReader, BufWriter, Write};

use carom::simulation::Algorithm;

use super::choice::{AlgorithmArguments, ArithmeticName};
use super::error::Error;
use super::exit::Exit;
use answer::Answer;
use request::Request;

/// So much of the input is read at once.
const BUFFER: usize = 1 << 16;

/// Answer questions, a line of JSON each, in their order.
///
/// A request names itself with any "id", which its answer repeats:
///
/// {"id": 1, "request": "first-impact", "a": DISC, "b": DISC or WALL} is answered by the
/// class of their first meeting, and its time as p + q √d.
///
/// {"id": 2, "request": "simulate", "scene": SCENE} is answered by the proven log: its
/// header, its events and its summary. It may have "until", "max_events", "digits" and
/// "contact", as the options of carom run.
///
/// {"id": 3, "request": "judge", "scene": SCENE, "events": [LINES OF A LOG]} is answered by
/// the verdict of carom check.
///
/// A line that cannot be answered is answered by {"id": …, "error": {"line": …, "reason":
/// …}}, and the next one is read.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:
  echo '{\"id\": 1, \"request\": \"first-impact\",
    \"a\": {\"position\": [0, 0], \"radius\": 1, \"velocity\": [10, 0]},
    \"b\": {\"position\": [5, 1], \"radius\": 1}}' | tr -d '\\n' | carom oracle")]
pub(super) struct Arguments {
    #[command(flatten)]
    algorithm: AlgorithmArguments,
    /// The numbers that scenes are simulated with. Only in exact arithmetic a log is
    /// proven; the others, and other algorithms, are there to be judged.
    #[arg(long, value_name = "N", default_value = "exact")]
    arithmetic: ArithmeticName,
}

/// How scenes are simulated.
#[derive(Clone, Copy, Debug)]
struct Method {
    algorithm: Algorithm,
    arithmetic: ArithmeticName,
}

pub(super) fn execute(arguments: &Arguments) -> Result<Exit, Error> {
    let method = Method {
        algorithm: arguments.algorithm.algorithm()?,
        arithmetic: arguments.arithmetic,
    };
    let input = BufReader::with_capacity(BUFFER, io::stdin().lock());
    let output = BufWriter::with_capacity(BUFFER, io::stdout().lock());
    serve(input, output, method).map_err(|reason| Error::Unwritable {
        file: String::from("standard output"),
        reason,
    })?;
    Ok(Exit::Success)
}

/// Answers all lines. What is written is sent on as soon as no further line is there.
fn serve<R: io::Read>(
    mut input: BufReader<R>,
    mut output: impl Write,
    method: Method,
) -> io::Result<()> {
    let (mut line, mut number) = (Vec::new(), 0_u64);
    loop {
        line.clear();
        if input.read_until(b'\n', &mut line)? == 0 {
            return output.flush();
        }
        number += 1;
        if !line.trim_ascii().is_empty() {
            serde_json::to_writer(&mut output, &answer_to(&line, number, method))?;
            output.write_all(b"\n")?;
        }
        if input.buffer().is_empty() {
            output.flush()?;
        }
    }
}

/// The answer to a line.
fn answer_to(line: &[u8], number: u64, method: Method) -> Answer<'_> {
    let (id, request) = Request::read(line);
    let answered = request.and_then(|request| answer::to(&request, method));
    Answer::new(id, answered, number)
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::*;

    const PROVEN: Method = Method {
        algorithm: Algorithm::Timeline,
        arithmetic: ArithmeticName::Exact,
    };

    fn answers(lines: &str) -> Vec<Value> {
        let mut output = Vec::new();
        serve(BufReader::new(lines.as_bytes()), &mut output, PROVEN).expect("text");
        let output = String::from_utf8(output).expect("text");
        let lines = output.lines().map(serde_json::from_str);
        lines.collect::<Result<_, _>>().expect("JSON")
    }

    /// 5 - √3 at speed 10.
    #[test]
    fn a_first_impact_with_a_root() {
        let answers = answers(
            r#"{"id": "x", "request": "first-impact", "a": {"position": [0, 0], "radius": 1, "velocity": [10, 0]}, "b": {"position": [5, 1], "radius": 1}}"#,
        );
        let [answer] = &answers[..] else {
            panic!("{answers:?}");
        };
        assert_eq!(
            (&answer["id"], &answer["class"]),
            (&"x".into(), &"hit".into())
        );
        let time = &answer["time"];
        assert_eq!(time["exact"]["p"], "1/2");
        assert_eq!(time["exact"]["q"], "-1/100");
        // b² - a c with a = 100, b = -50 and c = 22.
        assert_eq!(time["exact"]["d"], "300");
        assert!(
            time["lo"]
                .as_str()
                .expect("a text")
                .starts_with("0.3267949192431122706")
        );
        assert_eq!(time["f64"], 0.326_794_919_243_112_27);
    }

    #[test]
    fn a_wall_has_ends() {
        let answers = answers(
            r#"{"request": "first-impact", "a": {"position": ["-1/2", 0], "radius": "1/4", "velocity": ["1/3", 0]}, "b": {"from": [0, 0], "to": [6, 0]}}"#,
        );
        assert_eq!(answers[0]["end"], "from");
        assert_eq!(
            answers[0]["time"]["exact"],
            serde_json::json!({"p": "3/4", "q": "0", "d": "0"})
        );
        assert_eq!(
            (&answers[0]["time"]["lo"], &answers[0]["time"]["hi"]),
            (&"0.75".into(), &"0.75".into())
        );
    }

    /// A ball meets a wall at 2, and the run ends at 3.
    #[test]
    fn a_scene_is_simulated_and_a_log_judged() {
        let scene = r#"{"schema": "carom/scene/1", "id": "ball", "frame": {"duration": 3}, "discs": [{"position": [0, 0], "radius": 1, "velocity": [1, 0]}], "walls": [{"from": [3, -1], "to": [3, 1]}]}"#;
        let lines = [
            format!(r#"{{"id": 1, "request": "simulate", "scene": {scene}}}"#),
            format!(r#"{{"id": 2, "request": "simulate", "scene": {scene}, "until": "3/2"}}"#),
            format!(r#"{{"id": 3, "request": "judge", "scene": {scene}, "events": []}}"#),
        ];
        let answers = answers(&lines.join("\n"));
        assert_eq!(answers[0]["events"][0]["lo"], "2");
        assert_eq!(answers[0]["summary"]["status"], "complete");
        assert_eq!(answers[0]["header"]["scene"], "ball");
        assert_eq!(answers[1]["events"], serde_json::json!([]));
        assert_eq!(answers[2]["verdict"]["verdict"], "differs");
    }

    #[test]
    fn what_is_wrong_with_a_line_is_its_answer() {
        let lines = [
            r#"{"id": 1, "request": "guess"}"#,
            "",
            r#"{"id": [2], "request": "first-impact", "a": {"position": [0, 0], "radius": 0}, "b": {"position": [5, 1], "radius": 1}}"#,
            r#"{"id": 3, "request": "first-impact", "a": {"position": [0, 0], "radius": 1}}"#,
            r#"{"id": 4, "request": "simulate", "scene": {"schema": "carom/scene/1"}}"#,
            "{",
            r#"{"id": 5, "request": "first-impact", "a": {"position": [0, 0], "radius": 1}, "b": {"position": [5, 1], "radius": 1}}"#,
        ];
        let answers = answers(&lines.join("\n"));
        let reason = |place: usize| {
            let error = &answers[place]["error"];
            (
                error["line"].as_u64(),
                error["reason"].as_str().unwrap_or_default().to_owned(),
            )
        };
        assert_eq!(answers.len(), 6);
        assert_eq!(answers[1]["id"], serde_json::json!([2]));
        assert!(
            reason(0).1.contains("unknown variant `guess`"),
            "{:?}",
            reason(0)
        );
        let radius = "a.radius: expected a positive number, found 0";
        assert_eq!(reason(1), (Some(3), String::from(radius)));
        assert!(
            reason(2).1.contains("expected the key b"),
            "{:?}",
            reason(2)
        );
        assert!(
            reason(3).1.contains("discs: this key is missing"),
            "{:?}",
            reason(3)
        );
        assert_eq!((reason(4).0, &answers[4]["id"]), (Some(6), &Value::Null));
        assert_eq!(
            (&answers[5]["id"], &answers[5]["class"]),
            (&5.into(), &"miss".into())
        );
    }

    /// Lines that are no text.
    #[test]
    fn bytes_are_answered_too() {
        let mut output = Vec::new();
        serve(BufReader::new(&b"\xff\n{}\n"[..]), &mut output, PROVEN).expect("a buffer");
        assert_eq!(output.iter().filter(|byte| **byte == b'\n').count(), 2);
    }
}
