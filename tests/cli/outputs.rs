//! What goes where, and reads back.

use std::io::{BufRead, BufReader};
use std::process::{self, Stdio};

use super::*;

#[test]
fn a_scene_may_come_from_standard_input() {
    let text = fs::read_to_string(scene("figure-7.json")).expect("a scene");
    let done = carom(&["run", "-"]).write_stdin(text).assert().success();
    let text = String::from_utf8(done.get_output().stdout.clone()).expect("text");
    assert_eq!(meetings(&log(&text)), [(0.5, "d0 d1".into())]);
}

#[test]
fn logs_read_back() {
    let table1 = scene("table1-third.json");
    let runs: [&[&str]; 4] = [
        &[&table1, "--until", "1"],
        &[
            &table1,
            "--until",
            "1",
            "--arithmetic",
            "exact",
            "--contact",
        ],
        &[
            &table1,
            "--until",
            "1",
            "--algorithm",
            "multiple",
            "--contact",
        ],
        &[&table1, "--until", "1", "--algorithm", "retroactive"],
    ];
    for arguments in runs {
        let text = results(&[&["run"], arguments].concat());
        let log = log(&text);
        let mut lines = text.lines();
        assert_eq!(lines.next(), Some(&*json(&log.header)));
        for event in &log.events {
            assert_eq!(lines.next(), Some(&*json(event)));
        }
        let summary = format!(r#"{{"summary":{}}}"#, json(&log.summary));
        assert_eq!(lines.next(), Some(&*summary));
        assert_eq!(lines.next(), None);
        assert!(!log.events.is_empty());
    }
}

fn json(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).expect("text")
}

#[test]
fn logs_of_others_need_only_time_and_bodies() {
    let log = log("{\"time\": 1, \"a\": \"d0\", \"b\": \"w1\", \"colour\": \"red\"}\n\n");
    assert_eq!(meetings(&log), [(1.0, "d0 w1".into())]);
    assert!(log.header.is_none() && log.summary.is_none());
}

#[test]
fn what_is_no_log_is_refused() {
    let table = [
        ("{", "line 1: "),
        ("{\"time\": 1}", "line 1: missing field `a`"),
        (
            "\n{\"time\": 1, \"a\": \"d\", \"b\": \"d1\"}",
            "line 2: a: expected a disc (d0)",
        ),
        (
            "{\"schema\": \"carom/state/1\"}",
            "line 1: schema: unknown variant",
        ),
        (
            "{\"summary\": {\"events\": -1}}",
            "line 1: summary.events: ",
        ),
        ("3", "line 1: "),
    ];
    for (text, expected) in table {
        let message = Log::read(text.as_bytes()).expect_err("a fault").to_string();
        assert!(message.starts_with(expected), "{message}");
    }
    let event = "{\"time\": 1, \"a\": \"d0\", \"b\": \"d1\"}";
    let header = results(&["run", &scene("figure-7.json")]);
    let late = format!("{event}\n{header}");
    assert!(Log::read(late.as_bytes()).is_err());
    assert!(Log::read(format!("{header}{event}").as_bytes()).is_err());
}

#[test]
fn results_go_to_files() {
    let scratch = Scratch::new();
    let [events, state, end] =
        ["log.jsonl", "state.json", "end.json"].map(|name| scratch.name(name));
    let name = scene("figure-7.json");
    let files = [
        "--events",
        &events,
        "--state",
        &state,
        "--final-scene",
        &end,
    ];
    assert_eq!(results(&[&["run", &name], &files[..]].concat()), "");
    assert_eq!(log(&scratch.read("log.jsonl")).events.len(), 1);
    let state = State::from_json(&scratch.read("state.json")).expect("a state");
    assert_eq!(state.discs.len(), 2);
    results(&["validate", &end]);
}

#[test]
fn a_result_that_cannot_be_written_is_told() {
    let name = scene("figure-7.json");
    let nowhere = "no-such-directory/log.jsonl";
    for option in ["--events", "--state", "--final-scene"] {
        let (code, message) = ending(&["run", &name, option, nowhere]);
        assert_eq!(code, 2);
        assert!(message.starts_with("carom: no-such-directory/log.jsonl: cannot be written: "));
    }
}

/// From (-4, 0) on at velocity -4, for three more frames: to 0 - 12.
#[test]
fn a_final_scene_goes_on() {
    let scratch = Scratch::new();
    let end = scratch.name("end.json");
    let name = scene("figure-7.json");
    results(&[
        "run",
        &name,
        "--until",
        "1",
        "--events",
        "-",
        "--final-scene",
        &end,
    ]);
    let text = results(&["run", &end, "--state", "-"]);
    let state = State::from_json(&text).expect("a state");
    assert_eq!(numbers(&state.discs[0].position), [-12.0, 0.0]);
    assert_eq!(numbers(&state.discs[1].position), [4.0, 0.0]);
}

/// At 2/5 the disc is at 1 + 8/40 and 6 - 12 · 2/5, both 6/5, and 1/5 from the
/// wall that it meets at speed 12: after 1/60.
#[test]
fn a_final_scene_has_digits() {
    let scratch = Scratch::new();
    let name = scene("timeline-1.json");
    let exactly = ["--arithmetic", "exact"];
    let arguments = ["--until", "2/5", "--digits", "20", "--final-scene", "-"];
    let text = results(&[&["run", &name], &exactly[..], &arguments].concat());
    assert!(text.contains(r#""position": ["6/5", "6/5"]"#), "{text}");
    let end = scratch.write("end.json", text);
    let log = run(&[&[&*end], &exactly[..]].concat());
    assert_eq!(bounds(&log.events[0]), ["1/60", "1/60"]);
    assert_eq!(log.events.len(), 1);
}

#[test]
fn whoever_reads_only_the_first_line_breaks_nothing() {
    let mut process = process::Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(["run", &scene("table1-third.json")])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("a process");
    let mut line = String::new();
    let mut output = BufReader::with_capacity(64, process.stdout.take().expect("its output"));
    output.read_line(&mut line).expect("a line");
    drop(output);
    let output = process.wait_with_output().expect("its end");
    assert!(line.starts_with(r#"{"schema":"carom/events/1","#));
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    assert!(output.status.success());
}

#[test]
fn the_committed_schemas_are_fresh() {
    for format in ["scene", "events", "state", "verdict", "campaign", "vectors"] {
        let file = repository().join(format!("schema/{format}.schema.json"));
        let committed = fs::read_to_string(file).expect("the schema");
        assert!(
            results(&["schema", format]) == committed,
            "stale: carom schema {format} > schema/{format}.schema.json"
        );
    }
}
