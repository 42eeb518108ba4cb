//! Runs that end before their end: exit status 3, and a log all the same.

use super::*;
use carom::log::Ending;

/// A disc that meets two others at 4 - √39 / 4, at the same time: enclosures
/// cannot prove that.
const TIED: &str = r#"{"schema": "carom/scene/1", "frame": {"duration": 5}, "discs": [
    {"position": [0, 0], "velocity": [1, 0], "radius": 1},
    {"position": [4, 1.25], "radius": 1},
    {"position": [4, -1.25], "radius": 1}]}"#;

/// The log of a run that is given up.
fn given_up(arguments: &[&str]) -> (Log, String) {
    let done = carom(arguments).assert().code(3);
    let output = done.get_output();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("text");
    (log(&text(&output.stdout)), text(&output.stderr))
}

#[test]
fn what_is_left_undecided_is_told() {
    let scratch = Scratch::new();
    let name = scratch.write("tied.json", TIED);
    let exactly = ["--arithmetic", "exact", "--max-bits", "256"];
    let (log, message) = given_up(&[&["run", &name], &exactly[..]].concat());
    let summary = log.summary.expect("a summary");
    assert_eq!(summary.status, Ending::Undecided);
    assert_eq!(summary.bits, Some(256));
    let question = "whether d0 and d1 or d0 and d2 meet first";
    assert_eq!(summary.question.as_deref(), Some(question));
    assert_eq!((summary.until, summary.reached), (5.0, Some(0.0)));
    assert!(message.starts_with(&format!("carom: {name}: undecided: ")));
    assert!(message.contains(question) && message.lines().count() == 1);
}

/// 64 bits are 19 digits.
#[test]
fn digits_that_are_not_proven_are_told() {
    let name = scene("figure-2.json");
    let exactly = ["--arithmetic", "exact", "--max-bits", "64"];
    let (log, _) = given_up(&[&["run", &name], &exactly[..]].concat());
    let summary = log.summary.expect("a summary");
    assert_eq!(summary.status, Ending::Undecided);
    assert_eq!(summary.bits, Some(64));
    assert_eq!(log.events.len(), 1);
}

#[test]
fn runs_end_after_so_many_impacts() {
    let name = scene("timeline-2.json");
    let (log, message) = given_up(&["run", &name, "--max-events", "2"]);
    let summary = log.summary.expect("a summary");
    assert_eq!(summary.status, Ending::EventLimit);
    assert_eq!((summary.events, log.events.len()), (2, 2));
    assert_eq!((summary.until, summary.reached), (1.0, Some(0.375)));
    assert_eq!(message.lines().count(), 1);
}

#[test]
fn comparisons_end_where_the_truth_does() {
    let scratch = Scratch::new();
    let name = scratch.write("tied.json", TIED);
    let arguments = [
        "compare",
        &name,
        "--algorithms",
        "timeline",
        "--max-bits",
        "128",
    ];
    let done = carom(&arguments).assert().code(3);
    let text = String::from_utf8_lossy(&done.get_output().stdout).into_owned();
    assert!(text.contains("undecided from t = 0 on: "), "{text}");
    let (code, _) = ending(&[&arguments[..], &["--fail-on", "undecided"]].concat());
    assert_eq!(code, 1);
}
