//! Runs that end before their end: exit status 3, and a log all the same.

use super::*;
use carom::log::Ending;

/// A disc that meets two others at the same irrational time. That its speed has
/// too many digits to be held as a rational leaves nothing but enclosures, and
/// these cannot prove it; that there is a fourth disc leaves no symmetry.
fn tied() -> String {
    let speed = format!("1.{}", "3".repeat(1300));
    r#"{"schema": "carom/scene/1", "frame": {"duration": 3}, "discs": [
    {"position": [0, 0], "velocity": ["SPEED", 0], "radius": 1},
    {"position": [4, 1.25], "radius": 1},
    {"position": [4, -1.25], "radius": 1},
    {"position": [40, 40], "radius": 1}]}"#
        .replace("SPEED", &speed)
}

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
    let name = scratch.write("tied.json", tied());
    let exactly = ["--arithmetic", "exact", "--max-bits", "256"];
    let (log, message) = given_up(&[&["run", &name], &exactly[..]].concat());
    let summary = log.summary.expect("a summary");
    assert_eq!(summary.status, Ending::Undecided);
    assert_eq!(summary.bits, Some(256));
    let question = "whether d0 and d1 or d0 and d2 meet first";
    assert_eq!(summary.question.as_deref(), Some(question));
    assert_eq!((summary.until, summary.reached), (3.0, Some(0.0)));
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

/// Three discs that collapse: ℓ_1 = 8/19 and a gap of 8/19 after the impact at
/// 1, and λ2 = 1/10 (McNamara and Young 1992), so that the limit is
/// 1 + 8/19 / (8/19 - 1/10) = 141/61.
const COLLAPSE: &str = r#"{"schema": "carom/scene/1", "frame": {"duration": 1, "count": 9},
    "effects": {"restitution": {"newton": "4/95"}}, "discs": [
    {"position": [-3, 0], "velocity": [1, 0], "radius": 1},
    {"position": [0, 0], "radius": 1},
    {"position": ["441/190", 0], "velocity": ["1/10", 0], "radius": 1}]}"#;

#[test]
fn infinitely_many_impacts_are_told() {
    let scratch = Scratch::new();
    let name = scratch.write("collapse.json", COLLAPSE);
    let (log, message) = given_up(&["run", &name, "--arithmetic", "exact"]);
    let summary = log.summary.expect("a summary");
    assert_eq!(summary.status, Ending::Accumulation);
    assert_eq!(summary.proven, Some(true));
    let limit = carom::log::Bounds {
        nearest: 141.0 / 61.0,
        lo: String::from("141/61"),
        hi: String::from("141/61"),
    };
    assert_eq!(summary.limit, Some(Quantity::Proven(limit)));
    let pair = |a, b| [BodyId::Disc(a), BodyId::Disc(b)];
    assert_eq!(summary.word, Some(vec![pair(0, 1), pair(1, 2)]));
    let last = log.events.last().expect("an impact").time;
    assert_eq!((summary.until, summary.reached), (9.0, Some(last)));
    let expected =
        "infinitely many impacts of d0 and d1, d1 and d2 before t = 2.3114754098360657\n";
    assert_eq!(message, format!("carom: {name}: accumulation: {expected}"));
}

#[test]
fn what_is_extrapolated_is_called_so() {
    let scratch = Scratch::new();
    let name = scratch.write("collapse.json", COLLAPSE);
    let (log, message) = given_up(&["run", &name]);
    let summary = log.summary.expect("a summary");
    assert_eq!(summary.status, Ending::Accumulation);
    assert_eq!(summary.proven, Some(false));
    assert!(matches!(summary.limit, Some(Quantity::Computed(limit))
        if (limit - 141.0 / 61.0).abs() < 1e-12));
    assert!(message.ends_with(", which is extrapolated and not proven\n"));
}

/// The limit is in the third frame. The timeline itself ends before that
/// frame; frame algorithms go on, but of it there is no truth to judge by.
#[test]
fn comparisons_end_where_impacts_accumulate() {
    let scratch = Scratch::new();
    let name = scratch.write("collapse.json", COLLAPSE);
    let json = scratch.name("results.json");
    let arguments = ["--algorithms", "timeline,single", "--json", &json];
    let done = carom(&[&["compare", &name], &arguments[..]].concat())
        .assert()
        .code(3);
    let text = String::from_utf8_lossy(&done.get_output().stdout).into_owned();
    assert!(
        text.contains("; accumulation: infinitely many impacts of d0 and d1, "),
        "{text}"
    );
    let report: Value = serde_json::from_str(&scratch.read("results.json")).expect("JSON");
    let truth = &report["scenes"][0]["truth"]["accumulation"];
    assert_eq!(
        (&truth["limit"], &truth["proven"]),
        (&Value::from(141.0 / 61.0), &Value::Bool(true))
    );
    let rows = report["scenes"][0]["rows"].as_array().expect("rows");
    for row in rows {
        let is_timeline = row["algorithm"] == "timeline";
        assert_eq!(row["frames"], if is_timeline { 2 } else { 9 });
        assert_eq!(row["failure"].is_string(), is_timeline);
    }
}

#[test]
fn comparisons_end_where_the_truth_does() {
    let scratch = Scratch::new();
    let name = scratch.write("tied.json", tied());
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
