//! `fuzz-check`: scenes checked once more.

use super::*;

#[test]
fn a_scene_without_findings() {
    let (code, message) = ending(&[
        "fuzz-check",
        &scene("figure-7.json"),
        &scene("figure-2.json"),
    ]);
    assert_eq!((code, message.as_str()), (0, ""));
}

#[test]
fn what_is_no_scene_or_not_simulated() {
    let scratch = Scratch::new();
    let heavy = one_disc(
        r#""position": [0, 0]"#,
        r#""effects": {"gravity": [0, -1]},"#,
    );
    let table = [
        ("no scene", "line 1"),
        (
            heavy.as_str(),
            "effects.gravity: not available where runs are checked",
        ),
    ];
    for (content, expected) in table {
        let name = scratch.write("bad.json", content);
        let (code, message) = ending(&["fuzz-check", &name]);
        assert_eq!(code, 2, "{message}");
        assert!(
            message.starts_with(&format!("carom: {name}: {expected}")),
            "{message}"
        );
    }
}
