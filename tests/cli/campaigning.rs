//! Campaigns against other programs; carom itself stands in for them, and the shell.

use super::*;

/// carom as a program that answers questions.
fn implementation(options: &str) -> String {
    format!("'{}' oracle {options}", env!("CARGO_BIN_EXE_carom"))
}

/// How a campaign ends, what it says, and its summary.
fn campaign(command: &str, arguments: &[&str]) -> (i32, String, Value) {
    let scratch = Scratch::new();
    let json = scratch.name("summary.json");
    let call = ["campaign", "--impl", command, "--json", &json];
    let (status, message) = ending(&[&call[..], arguments].concat());
    let summary = serde_json::from_str(&scratch.read("summary.json")).expect("JSON");
    (status, message, summary)
}

/// How many scenes of all families are of a class.
fn count(summary: &Value, class: &str) -> u64 {
    let rows = summary["families"].as_array().expect("rows");
    let counts = rows
        .iter()
        .map(|row| row["counts"][class].as_u64().expect("a count"));
    counts.sum()
}

#[test]
fn exact_arithmetic_follows_itself() {
    let (status, message, summary) = campaign(&implementation(""), &["--count", "3"]);
    assert_eq!((status, message), (0, String::new()));
    assert_eq!(count(&summary, "follows"), 27);
    assert_eq!(summary["schema"], "carom/campaign/1");
}

/// One impact a frame: of a cradle, struck at one end, the impulse stays on its way.
#[test]
fn what_a_program_misses_is_found_and_made_small() {
    let scratch = Scratch::new();
    let output = scratch.name("out");
    let command = implementation("--algorithm single --arithmetic f64");
    let arguments = ["--count", "20", "--family", "cradles", "--output", &output];
    let (status, message, summary) = campaign(&command, &arguments);
    assert_eq!(status, 1);
    let findings = summary["findings"].as_array().expect("findings");
    let missed = findings.iter().find(|finding| finding["class"] == "missed");
    let missed = missed.expect("a finding")["scene"]
        .as_str()
        .expect("a name");
    assert!(
        message.contains(&format!("{missed}: missed: ")),
        "{message}"
    );
    let file = format!("out/scenes/{missed}-missed.json");
    let small = carom::scene::Scene::from_json(&scratch.read(&file)).expect("a scene");
    assert!(small.discs().len() <= 3, "{}", small.to_json());
    let notes = small.notes().expect("notes");
    let replay = notes
        .split("To replay it: carom ")
        .nth(1)
        .expect("a command");
    let words: Vec<_> = shell_words::split(replay).expect("words");
    let words: Vec<_> = words.iter().map(String::as_str).collect();
    let told = carom(&words).assert().code(1);
    let told = String::from_utf8_lossy(&told.get_output().stdout).into_owned();
    assert!(told.starts_with(&format!("{missed}: missed: ")), "{told}");
}

#[test]
fn what_is_no_answer_is_a_finding() {
    let arguments = ["--count", "1", "--family", "random", "--timeout", "1"];
    let class_of = |command: &str| {
        let (status, message, summary) = campaign(command, &arguments);
        let finding = &summary["findings"][0];
        assert_eq!(status, 1, "{message}");
        assert_eq!(finding["scene"], "random-1-0");
        finding["class"].as_str().expect("a class").to_owned()
    };
    assert_eq!(class_of("sh -c 'read line; exec sleep 30'"), "timeout");
    assert_eq!(class_of("sh -c 'read line; exit 3'"), "crash");
    assert_eq!(class_of("/nowhere/nothing"), "crash");
    for garbage in [
        "hello",
        "{}",
        r#"{"id": 2, "events": []}"#,
        r#"{"id": 1}"#,
        r#"{"id": 1, "events": [{"time": 1, "a": "d0", "b": "d900"}]}"#,
        r#"{"id": 1, "events": [{"time": null, "a": "d0", "b": "d1"}]}"#,
    ] {
        let command = format!("sh -c 'while read line; do echo '\\''{garbage}'\\''; done'");
        assert_eq!(class_of(&command), "garbage", "{garbage}");
    }
    assert_eq!(
        class_of("sh -c 'while read line; do printf cut; exit; done'"),
        "garbage"
    );
}

#[test]
fn what_a_program_declines_is_no_finding() {
    let answer = r#"{\"id\": 1, \"error\": {\"reason\": \"no walls\"}}"#;
    let command = format!("sh -c \"while read line; do echo '{answer}'; done\"");
    let (status, _, summary) = campaign(&command, &["--count", "1", "--family", "random"]);
    assert_eq!((status, count(&summary, "declined")), (0, 1));
}

/// However the work is cut, and on however many threads.
#[test]
fn outcomes_do_not_depend_on_the_cut() {
    let command = implementation("--algorithm multiple --arithmetic f64");
    let findings = |arguments: &[&str]| {
        let (_, _, summary) = campaign(&command, arguments);
        summary["findings"].as_array().expect("findings").clone()
    };
    let all = findings(&["--count", "4", "--threads", "2"]);
    assert!(!all.is_empty());
    assert_eq!(findings(&["--count", "4", "--threads", "1"]), all);
    let cut = [
        findings(&["--count", "2"]),
        findings(&["--count", "2", "--start", "2"]),
    ];
    let mut cut = cut.concat();
    let place = |finding: &Value| {
        let place = all.iter().position(|other| other == finding);
        place.expect("it is there")
    };
    cut.sort_by_key(place);
    assert_eq!(cut, all);
}

#[test]
fn a_campaign_goes_on_where_it_was_left() {
    let scratch = Scratch::new();
    let output = scratch.name("out");
    let command = implementation("--arithmetic filtered");
    let arguments = ["--family", "random,bullets", "--output", &output];
    let with = |count: &str| campaign(&command, &[&arguments[..], &["--count", count]].concat());
    let (status, message, _) = with("3");
    assert_eq!((status, message), (0, String::new()));
    let lines = scratch.read("out/outcomes.jsonl");
    assert_eq!(lines.lines().count(), 7, "a header and six scenes");
    // The last line is cut off, as where a machine goes down.
    scratch.write("out/outcomes.jsonl", &lines[..lines.len() - 9]);
    let (status, message, summary) = with("4");
    assert_eq!(status, 0);
    assert_eq!(message, "carom: 5 of 8 scenes were done\n");
    assert_eq!(count(&summary, "follows"), 8);
    let (status, message) = ending(&[
        "campaign", "--impl", &command, "--output", &output, "--seed", "2",
    ]);
    assert!(
        status == 2 && message.contains("of another campaign"),
        "{message}"
    );
    // What is no file of a campaign stays as it is, with its last line.
    scratch.write("out/outcomes.jsonl", "my own");
    let (status, _) = ending(&["campaign", "--impl", &command, "--output", &output]);
    assert_eq!(
        (status, scratch.read("out/outcomes.jsonl").as_str()),
        (2, "my own")
    );
}

#[test]
fn known_findings_are_expected_until_they_pass() {
    let scratch = Scratch::new();
    let list = |finding: &str| {
        let entry = format!(
            r#"[{{"family": "random", "finding": "{finding}", "reason": "no answers yet"}}]"#
        );
        scratch.write("known.json", entry)
    };
    let arguments = |known: &str| {
        let fixed = ["--count", "1", "--family", "random", "--known"];
        let mut arguments: Vec<_> = fixed.map(String::from).to_vec();
        arguments.push(known.to_owned());
        arguments
    };
    let ends = |command: &str, known: &str| {
        let arguments = arguments(known);
        let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
        let (status, message, _) = campaign(command, &arguments);
        (status, message)
    };
    assert_eq!(ends("false", &list("crash")), (0, String::new()));
    let (status, message) = ends(&implementation(""), &list("crash"));
    assert_eq!(status, 1);
    assert!(
        message.contains("random: crash (no answers yet)"),
        "{message}"
    );
    let (status, message) = ends("false", &list("missed"));
    assert!(
        status == 1 && message.contains("random-1-0: crash"),
        "{message}"
    );
    let known = list("follows");
    let call = ["campaign", "--impl", "false", "--known", &known];
    let (status, message) = ending(&call);
    assert!(
        status == 2 && message.contains("[0].finding: expected"),
        "{message}"
    );
}

/// A time that is a little off is a finding only where that is asked.
#[test]
fn late_impacts_are_findings_on_request() {
    let scratch = Scratch::new();
    let room = r#""position": [0, 0], "velocity": [1, 0]"#;
    let walls = r#""frame": {"duration": 3}, "walls": [{"from": [3, -9], "to": [3, 9]}],"#;
    let file = scratch.write("room.json", one_disc(room, walls));
    let answer = r#"{"id": 1, "events": [{"time": 2.25, "a": "d0", "b": "w0"}]}"#;
    let command = format!("sh -c 'while read line; do echo '\\''{answer}'\\''; done'");
    let call = ["campaign", "--impl", &command, "--scene", &file];
    let (status, _) = ending(&call);
    assert_eq!(status, 0);
    let (status, _) = ending(&[&call[..], &["--time-tolerance", "1/4"]].concat());
    assert_eq!(status, 2, "it is a binary64");
    for (tolerance, expected) in [("0.25", 0), ("0.2", 1)] {
        let (status, _) = ending(&[&call[..], &["--time-tolerance", tolerance]].concat());
        assert_eq!(status, expected, "{tolerance}");
    }
}
