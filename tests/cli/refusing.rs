//! Bad input and bad usage: exit status 2, and one line that says why.

use super::*;

const DISC: &str = r#""position": [0, 0]"#;

/// What is said of a scene with that content, after the file's name.
fn refusal(content: impl AsRef<[u8]>) -> String {
    let scratch = Scratch::new();
    let name = scratch.write("bad.json", content);
    let (code, message) = ending(&["run", &name]);
    assert_eq!(code, 2, "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
    let rest = message.strip_prefix(&format!("carom: {name}: "));
    rest.expect("the file").trim_end().to_owned()
}

#[test]
fn faults_are_named_with_their_place() {
    let with = |keys: &str| one_disc(&format!("{DISC}, {keys}"), "");
    let table = [
        (with(r#""colour": 1"#), "discs[0]."),
        (
            with(r#""mass": 0"#),
            "discs[0].mass: expected a positive number, found 0",
        ),
        (
            with(r#""mass": "1/0""#),
            "discs[0].mass: expected a denominator other than zero",
        ),
        (
            with(r#""mass": "nan""#),
            "discs[0].mass: expected an integer (3), ",
        ),
        (
            with(r#""mass": 1e999"#),
            "discs[0].mass: expected a finite binary64",
        ),
        (with(r#""mass": "1e99999""#), "discs[0].mass: expected "),
        (with(r#""velocity": [1]"#), "discs[0].velocity"),
        (
            one_disc(r#""velocity": [0, 0]"#, ""),
            "discs[0].position: this key is missing",
        ),
        (one_disc(DISC, r#""extra": 1,"#), "extra: "),
        (
            one_disc(DISC, "").replacen(r#""radius": 1"#, r#""radius": 0"#, 1),
            "discs[0].radius: expected a positive number, found 0",
        ),
        (
            one_disc(DISC, r#""walls": [{"from": [1, 2], "to": [1, 2]}],"#),
            "walls[0]: expected two different end points",
        ),
    ];
    for (text, expected) in table {
        let message = refusal(&text);
        assert!(message.starts_with(expected), "{message} for {text}");
    }
}

#[test]
fn what_is_no_json_is_refused() {
    let nan = one_disc(r#""position": [NaN, 0]"#, "");
    assert!(refusal(nan).starts_with("line 1, column "));
    assert_eq!(
        refusal(""),
        "line 1, column 1: expected a scene, found nothing"
    );
    assert!(refusal(vec![0; 100 << 20]).starts_with("line 1, column "));
    assert!(refusal("[".repeat(1 << 20)).contains("expected"));
    let deep = format!("{{\"notes\": {}", "[".repeat(1 << 20));
    refusal(deep);
}

#[test]
fn missing_files_are_named() {
    let (code, message) = ending(&["run", "no-such-scene.json"]);
    assert_eq!(code, 2);
    assert!(message.starts_with("carom: no-such-scene.json: cannot be read: "));
    let (code, message) = ending(&["compare", "no-such-scene.json"]);
    assert_eq!(code, 2);
    assert!(message.starts_with("carom: no-such-scene.json: cannot be read: "));
}

#[test]
fn numbers_beyond_binary64_need_exact_arithmetic() {
    let scratch = Scratch::new();
    let text = one_disc(r#""position": ["1e100", 0]"#, "");
    let name = scratch.write("far.json", text);
    let (code, message) = ending(&["run", &name]);
    assert_eq!(code, 2);
    assert!(message.starts_with(&format!("carom: {name}: discs[0].position")));
    results(&["run", &name, "--arithmetic", "exact"]);
}

#[test]
fn effects_that_do_not_go_together_are_refused() {
    let both = r#""effects": {"gravity": [0, -1], "drag": {"linear": 1}},"#;
    let scratch = Scratch::new();
    let name = scratch.write("both.json", one_disc(DISC, both));
    let (code, message) = ending(&["run", &name, "--arithmetic", "filtered"]);
    assert_eq!(code, 2);
    let expected = "effects.drag: not available by the timeline in filtered, together with gravity";
    assert_eq!(message.trim_end(), format!("carom: {name}: {expected}"));
    results(&["run", &name]);
}

#[test]
fn bad_usage_is_refused() {
    let name = scene("figure-7.json");
    let table: [&[&str]; 20] = [
        &[],
        &["runn"],
        &["run"],
        &["run", &name, "--unknown"],
        &["run", &name, "--algorithm", "magic"],
        &["run", &name, "--arithmetic", "f32"],
        &["run", &name, "--passes", "2"],
        &["run", &name, "--algorithm", "multiple", "--passes", "0"],
        &[
            "run",
            &name,
            "--algorithm",
            "multiple",
            "--passes",
            "2",
            "--frame-budget",
            "1",
        ],
        &[
            "run",
            &name,
            "--algorithm",
            "multiple",
            "--frame-budget",
            "-1",
        ],
        &[
            "run",
            &name,
            "--algorithm",
            "multiple",
            "--frame-budget",
            "nan",
        ],
        &["run", &name, "--algorithm", "single", "--substeps", "2"],
        &["run", &name, "--until", "-1"],
        &["run", &name, "--until", "soon"],
        &["run", &name, "--until", "1e100"],
        &["run", &name, "--digits", "5"],
        &["run", &name, "--max-events", "0"],
        &["run", &name, "--state", "-", "--final-scene", "-"],
        &["compare", &name, "--fail-on", "everything"],
        &["schema", "nothing"],
    ];
    for arguments in table {
        let (code, message) = ending(arguments);
        assert_eq!(code, 2, "{arguments:?}");
        assert!(!message.is_empty(), "{arguments:?}");
    }
}

#[test]
fn arithmetics_have_names() {
    let name = scene("figure-7.json");
    let (code, message) = ending(&["run", &name, "--arithmetic", "f32"]);
    assert_eq!(code, 2);
    assert!(
        message.contains("expected f64, filtered or exact"),
        "{message}"
    );
}

#[test]
fn validate_names_every_bad_scene() {
    let scratch = Scratch::new();
    let good = scene("figure-7.json");
    let bad = scratch.write("bad.json", one_disc(DISC, "").replace(": 1", ": 0"));
    let worse = scratch.write("worse.json", "{");
    assert_eq!(
        results(&["validate", &good, &scene("table1-full.json")]),
        ""
    );
    let (code, message) = ending(&["validate", &bad, &good, &worse]);
    assert_eq!(code, 2);
    let lines: Vec<_> = message.lines().collect();
    assert_eq!(
        lines[0],
        format!("carom: {bad}: discs[0].radius: expected a positive number, found 0")
    );
    assert!(lines[1].starts_with(&format!("carom: {worse}: line 1, column ")));
    assert_eq!(lines.len(), 2);
}

#[test]
fn every_command_has_an_example() {
    let generators = ["table1", "gas", "galperin", "cradle"];
    let mut commands: Vec<Vec<&str>> = ["run", "compare", "validate", "generate", "schema"]
        .map(|command| vec![command])
        .into();
    commands.extend(generators.map(|kind| vec!["generate", kind]));
    for command in commands {
        let text = results(&[&command[..], &["--help"]].concat());
        assert!(text.contains("Example"), "{command:?}");
    }
}

#[test]
fn what_a_plane_that_repeats_does_not_have_is_told() {
    let name = scene("around.json");
    let told = |arguments: &[&str]| {
        let (code, message) = ending(&[&["run", &name], arguments].concat());
        assert_eq!(code, 2, "{message}");
        message.trim_end().rsplit(": ").next().map(str::to_owned)
    };
    let single = told(&["--algorithm", "single"]);
    assert_eq!(
        single.as_deref(),
        Some("not available in the algorithm single")
    );
    let at_once = told(&["--simultaneous", "reflect"]);
    assert_eq!(
        at_once.as_deref(),
        Some("not available with the rule reflect")
    );
    let cell = r#""periodic": {"from": [0, 0], "to": [9, 9]},"#;
    assert_eq!(
        refusal(one_disc(r#""position": [0, "1e7"]"#, cell)),
        "discs[0]: expected to keep within 2^19 sides of the periodic cell"
    );
    let falling = one_disc(
        DISC,
        r#""periodic": {"from": [0, 0], "to": [9, 9]}, "effects": {"gravity": [0, -1]},"#,
    );
    assert_eq!(
        refusal(falling),
        "effects.gravity: not available in a periodic scene"
    );
}
