//! Both programs as they are run, with answers derived by hand.

use std::io::Write;
use std::process::{Command, Stdio};

use serde_json::{Value, json};

/// No step of the engine that steps is longer.
const STEP: f64 = 1.0 / 60.0;

/// The answers of a program to lines.
fn ask(program: &str, lines: &[String]) -> Vec<Value> {
    let mut child = Command::new(program)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut input = child.stdin.take().expect("a pipe");
    input
        .write_all(lines.join("\n").as_bytes())
        .expect("a pipe");
    drop(input);
    let output = child.wait_with_output().expect("the program ends");
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).expect("text");
    let answers = text
        .lines()
        .map(|line| serde_json::from_str(line).expect("JSON"));
    answers.collect()
}

fn disc(position: Value, velocity: Value) -> Value {
    json!({"position": position, "velocity": velocity, "radius": 1})
}

/// A gap of 5 - 2, closing at 1 + 2: at 1. Then they swap their velocities, and part.
fn head_on() -> Value {
    let discs = [
        disc(json!([0, 0]), json!([1, 0])),
        disc(json!([5, 0]), json!([-2, 0])),
    ];
    json!({"schema": "carom/scene/1", "discs": discs, "frame": {"duration": "3/2", "count": 2}})
}

/// The way to the wall is 3 - 1 at speed 1: at 2. Then it leaves.
fn into_a_wall() -> Value {
    let walls = [json!({"from": [3, -1], "to": [3, 1]})];
    let discs = [disc(json!([0, 0]), json!([1, 0]))];
    json!({"schema": "carom/scene/1", "discs": discs, "walls": walls, "frame": {"duration": 3}})
}

/// The other is 3 aside, and 2 would be a touch.
fn miss() -> Value {
    let discs = [
        disc(json!([0, 0]), json!([1, 0])),
        disc(json!([5, "0x1.8p+1"]), json!([0, 0])),
    ];
    json!({"schema": "carom/scene/1", "discs": discs, "frame": {"duration": 10}})
}

/// Three of one mass on a line: the first meets the second at 1, which meets the third 2
/// later.
fn three() -> Value {
    let discs = [
        disc(json!([0, 0]), json!([1, 0])),
        disc(json!([3, 0]), json!([0, 0])),
        disc(json!([7, 0]), json!([0, 0])),
    ];
    json!({"schema": "carom/scene/1", "discs": discs, "frame": {"duration": 5}})
}

fn periodic() -> Value {
    let cell = json!({"from": [0, 0], "to": [10, 10]});
    json!({"schema": "carom/scene/1", "discs": [disc(json!([5, 5]), json!([1, 0]))], "periodic": cell})
}

fn simulate(id: u32, scene: Value) -> String {
    json!({"id": id, "request": "simulate", "scene": scene}).to_string()
}

fn first_impact(id: u32, a: &Value, b: &Value) -> String {
    json!({"id": id, "request": "first-impact", "a": a, "b": b}).to_string()
}

fn first_of(id: u32, scene: &Value) -> String {
    let other = scene["walls"].get(0).unwrap_or(&scene["discs"][1]);
    first_impact(id, &scene["discs"][0], other)
}

/// Checks the impacts of an answer: the bodies, and the times within one step.
fn assert_impacts(answer: &Value, expected: &[(f64, &str, &str)], step: f64) {
    let events = answer["events"].as_array().expect("events");
    assert_eq!(events.len(), expected.len(), "{answer}");
    for (event, (time, a, b)) in events.iter().zip(expected) {
        assert_eq!(
            (&event["a"], &event["b"]),
            (&json!(a), &json!(b)),
            "{answer}"
        );
        let found = event["time"].as_f64().expect("a time");
        assert!((found - time).abs() <= step, "{answer}");
    }
}

/// Runs, then what is answered by an error, then a run again.
fn check_runs(program: &str, step: f64) {
    let answers = ask(
        program,
        &[
            simulate(1, head_on()),
            simulate(2, into_a_wall()),
            simulate(3, miss()),
            String::from("{\"id\": 4, \"request\""),
            simulate(5, periodic()),
            simulate(6, three()),
        ],
    );
    assert_eq!(answers.len(), 6);
    assert_impacts(&answers[0], &[(1.0, "d0", "d1")], step);
    assert_impacts(&answers[1], &[(2.0, "d0", "w0")], step);
    assert_impacts(&answers[2], &[], step);
    assert!(answers[3]["error"]["reason"].is_string());
    assert!(
        answers[4]["error"]["reason"]
            .as_str()
            .expect("a reason")
            .contains("periodic")
    );
    assert_impacts(
        &answers[5],
        &[(1.0, "d0", "d1"), (3.0, "d1", "d2")],
        2.0 * step,
    );
    let ids: Vec<_> = answers.iter().map(|answer| &answer["id"]).collect();
    assert_eq!(json!(ids), json!([1, 2, 3, null, 5, 6]));
}

#[test]
fn rapier2d_runs() {
    // A contact that begins may be told a step late, and rounding may cost one more.
    check_runs(env!("CARGO_BIN_EXE_rapier2d"), 2.0 * STEP);
}

#[test]
fn rapier2d_has_no_first_impacts() {
    let answers = ask(env!("CARGO_BIN_EXE_rapier2d"), &[first_of(1, &head_on())]);
    assert!(answers[0]["error"]["reason"].is_string());
}

/// From 19.6 above, with gravity 9.8: 2 until the wall is met.
#[test]
fn rapier2d_falls() {
    let scene = json!({
        "schema": "carom/scene/1", "frame": {"duration": 3},
        "discs": [disc(json!([0, "103/5"]), json!([0, 0]))],
        "walls": [{"from": [-9, 0], "to": [9, 0]}],
        "effects": {"gravity": [0, "-9.8"]},
    });
    let answers = ask(env!("CARGO_BIN_EXE_rapier2d"), &[simulate(1, scene)]);
    assert_impacts(&answers[0], &[(2.0, "d0", "w0")], 2.0 * STEP);
}

#[test]
fn parry2d_runs() {
    check_runs(env!("CARGO_BIN_EXE_parry2d"), 1e-12);
}

#[test]
fn parry2d_first_impacts() {
    let scenes = [head_on(), into_a_wall(), miss()];
    let lines = (1..).zip(&scenes).map(|(id, scene)| first_of(id, scene));
    let answers = ask(env!("CARGO_BIN_EXE_parry2d"), &lines.collect::<Vec<_>>());
    for (answer, time) in answers.iter().zip([1.0, 2.0]) {
        assert_eq!(answer["class"], "hit");
        let found = answer["time"]["f64"].as_f64().expect("a time");
        assert!((found - time).abs() < 1e-12, "{answer}");
    }
    assert_eq!(answers[2], json!({"id": 3, "class": "miss"}));
}

/// From 1 to the wall at 2: 1. Back at speed 1/2, from 2 to 1 takes 2. And a disc of infinite
/// mass meets no wall.
#[test]
fn parry2d_has_newtons_law_and_infinite_masses() {
    let mut slow = into_a_wall();
    slow["walls"] = json!([{"from": [3, -1], "to": [3, 1]}, {"from": [0, -1], "to": [0, 1]}]);
    slow["discs"][0]["position"] = json!([1, 0]);
    slow["frame"] = json!({"duration": 4});
    slow["effects"] = json!({"restitution": {"newton": 1, "walls": "1/2"}});
    let mut heavy = into_a_wall();
    heavy["discs"][0]["mass"] = json!("infinite");
    let lines = [simulate(1, slow), simulate(2, heavy)];
    let answers = ask(env!("CARGO_BIN_EXE_parry2d"), &lines);
    assert_impacts(&answers[0], &[(1.0, "d0", "w0"), (3.0, "d0", "w1")], 1e-12);
    assert_impacts(&answers[1], &[], 0.0);
}

/// Sizes whose squares binary64 does not have: an error, and no miss.
#[test]
fn parry2d_tells_of_times_that_are_none() {
    let mut huge = head_on();
    for disc in huge["discs"].as_array_mut().expect("discs") {
        disc["radius"] = json!("0x1p400");
    }
    huge["discs"][0]["velocity"] = json!(["0x1p400", 0]);
    huge["discs"][1]["position"] = json!(["0x3p400", 0]);
    let answers = ask(
        env!("CARGO_BIN_EXE_parry2d"),
        &[simulate(1, huge.clone()), first_of(2, &huge)],
    );
    for answer in &answers {
        assert!(answer["error"]["reason"].is_string(), "{answer}");
    }
}
