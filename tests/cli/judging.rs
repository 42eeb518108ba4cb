//! Logs of other programs, judged: what is written, and how it ends.

use super::*;

/// A ball of radius 1 that meets walls at 3 and at -3: at 2, 6 and 10.
fn room(scratch: &Scratch) -> String {
    let walls = r#""frame": {"duration": 12},
        "walls": [{"from": [3, -9], "to": [3, 9]}, {"from": [-3, -9], "to": [-3, 9]}],"#;
    let keys = r#""position": [0, 0], "velocity": [1, 0]"#;
    scratch.write("room.json", one_disc(keys, walls))
}

const RIGHT: &str = r#"{"time": 2, "a": "d0", "b": "w0"}
{"time": 6.5, "a": "w1", "b": "d0"}
{"time": 10, "a": "d0", "b": "w0"}
"#;

const WRONG: &str = r#"{"time": 2, "a": "d0", "b": "w0"}
{"time": 10, "a": "d0", "b": "w0"}
"#;

/// What is written to standard output, and the exit status.
fn check(log: &str, options: &[&str]) -> (String, i32) {
    let scratch = Scratch::new();
    let (scene, log) = (room(&scratch), scratch.write("log.jsonl", log));
    let arguments = ["check", &scene, "--events", &log];
    let output = carom(&[&arguments, options].concat())
        .output()
        .expect("a process");
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    let text = String::from_utf8(output.stdout).expect("text");
    (text, output.status.code().expect("an exit status"))
}

fn verdict(log: &str) -> Value {
    serde_json::from_str(&check(log, &["--json", "-"]).0).expect("JSON")
}

/// Time errors are told, and not blamed: the order is right.
#[test]
fn a_log_that_follows_the_truth() {
    let (text, status) = check(RIGHT, &[]);
    assert!(text.contains("follows the truth"), "{text}");
    assert_eq!(status, 0);
    let verdict = verdict(RIGHT);
    assert_eq!(verdict["schema"], "carom/verdict/1");
    assert_eq!(verdict["verdict"], "follows");
    assert_eq!(
        (&verdict["matched"], &verdict["impacts"]),
        (&3.into(), &3.into())
    );
    assert_eq!(verdict["time_error"], 0.5);
    assert_eq!(verdict.get("difference"), None);
}

#[test]
fn a_log_that_differs_ends_with_1_and_names_the_first_impact() {
    let (text, status) = check(WRONG, &[]);
    assert!(
        text.contains("d0 and w1 meet at 6, between 6 and 6"),
        "{text}"
    );
    assert_eq!(status, 1);
    let verdict = verdict(WRONG);
    assert_eq!(
        (&verdict["verdict"], &verdict["matched"]),
        (&"differs".into(), &1.into())
    );
    let difference = &verdict["difference"];
    assert_eq!(
        (&difference["disc"], &difference["time"]),
        (&"d0".into(), &6.0.into())
    );
    let truth = &difference["truth"];
    assert_eq!(
        (&truth["b"], &truth["lo"], &truth["hi"]),
        (&"w1".into(), &"6".into(), &"6".into())
    );
    // The wall that is hit last is told of again.
    assert_eq!(
        (&verdict["repeats"], difference.get("log")),
        (&1.into(), None)
    );
}

/// The truth may end sooner than the scene.
#[test]
fn a_log_up_to_a_time() {
    let log = RIGHT.lines().next().expect("a line");
    assert_eq!(check(log, &["--until", "11/2"]).1, 0);
    assert_eq!(check(log, &[]).1, 1);
}

#[test]
fn junit_has_a_case_that_fails_or_not() {
    for (log, failures) in [(RIGHT, 0), (WRONG, 1)] {
        let (text, _) = check(log, &["--junit", "-"]);
        assert!(
            text.contains(&format!(r#"tests="1" failures="{failures}""#)),
            "{text}"
        );
        assert_eq!(text.matches("<failure").count(), failures);
    }
}

/// Carom's own log, from standard input.
#[test]
fn a_log_from_standard_input() {
    let name = scene("table1-third.json");
    let log = results(&["run", &name, "--until", "1/2"]);
    let mut check = carom(&["check", &name, "--events", "-", "--until", "1/2"]);
    let done = check.write_stdin(log).assert().success();
    let text = String::from_utf8_lossy(&done.get_output().stdout).into_owned();
    assert!(
        text.starts_with("table1-third: follows the truth"),
        "{text}"
    );
}

#[test]
fn what_is_no_log_of_the_scene_is_refused() {
    let scratch = Scratch::new();
    let scene = room(&scratch);
    for (line, problem) in [
        (
            r#"{"time": 1, "a": "d0", "b": "w2"}"#,
            "impact 0: expected a disc of the scene",
        ),
        (
            r#"{"time": 1, "a": "w0", "b": "w1"}"#,
            "impact 0: expected a disc of the scene",
        ),
        (r#"{"time": 1, "a": "d0"}"#, "line 1: missing field `b`"),
        ("nonsense", "line 1:"),
    ] {
        let log = scratch.write("log.jsonl", line);
        let (status, message) = ending(&["check", &scene, "--events", &log]);
        assert_eq!(status, 2);
        assert!(message.contains(problem), "{message}");
    }
    let (status, message) = ending(&["check", "-", "--events", "-"]);
    assert!(
        status == 2 && message.contains("expected only one"),
        "{message}"
    );
}

/// The truth at 6 is at the left wall; the log goes on at the right one, which it has met
/// last, and so only tells of that again.
#[test]
fn a_replay_marks_the_first_difference() {
    let (page, status) = check(WRONG, &["--html", "-"]);
    assert_eq!(status, 1);
    let data = drawing::replay_data(&page);
    assert_eq!(data["difference"]["time"], 6.0);
    let faults = data["panes"][0]["faults"].as_array().expect("faults");
    let told = faults.iter().map(|fault| {
        let place = fault["places"][0][1].as_f64().expect("a number");
        (fault["kind"].as_str(), fault["time"].as_f64(), place)
    });
    assert_eq!(
        told.collect::<Vec<_>>(),
        [(Some("missed"), Some(6.0), -2.0)]
    );
    let (page, status) = check(RIGHT, &["--html", "-"]);
    let data = drawing::replay_data(&page);
    assert_eq!((status, &data["difference"]), (0, &Value::Null));
    assert!(page.contains("The log has the true impacts"), "{page}");
}
