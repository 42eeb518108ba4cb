//! What is refused, and with which words.

use super::*;

fn refusal(text: &str) -> String {
    let error = Scene::from_json(text).expect_err(text);
    error.to_string()
}

/// The example with one place changed.
fn changed(from: &str, to: &str) -> String {
    assert!(EXAMPLE.contains(from), "{from}");
    EXAMPLE.replacen(from, to, 1)
}

#[test]
fn physical_faults_say_where_what_and_instead_of_what() {
    for (from, to, message) in [
        (
            r#""radius": 1, "mass": 1"#,
            r#""radius": 0"#,
            "discs[0].radius: expected a positive number, found 0",
        ),
        (
            r#""radius": 1, "mass": "infinite""#,
            r#""radius": "-1/2""#,
            "discs[1].radius: expected a positive number, found -1/2",
        ),
        (
            r#""mass": 1"#,
            r#""mass": 0"#,
            "discs[0].mass: expected a positive number, found 0",
        ),
        (
            r#""to": [10, -1]"#,
            r#""to": ["-1.0", "-0x1p0"]"#,
            "walls[0]: expected two different end points, found (-1, -1) twice",
        ),
        (
            r#""1/60""#,
            "0",
            "frame.duration: expected a positive number, found 0",
        ),
        ("600", "0", "frame.count: expected at least 1, found 0"),
        (
            r#""9/10""#,
            r#""11/10""#,
            "effects.restitution.newton: expected a number from 0 to 1, found 11/10",
        ),
        (
            r#""9/10""#,
            r#""9/10", "walls": -1"#,
            "effects.restitution.walls: expected a number from 0 to 1, found -1",
        ),
        (
            r#""9/10""#,
            r#""9/10", "elastic_below": 0"#,
            "effects.restitution.elastic_below: expected a positive number, found 0",
        ),
        (
            r#""newton": "9/10""#,
            r#""paper": 2"#,
            "effects.restitution.paper: expected a number from 0 to 1, found 2",
        ),
        (
            r#""1/10""#,
            "-3",
            "effects.drag.linear: expected a number not below 0, found -3",
        ),
    ] {
        let text = changed(from, to);
        assert_eq!(refusal(&text), message);
        let error = Scene::from_json(&text).expect_err(message);
        assert!(matches!(error.kind(), SceneErrorKind::Physical { .. }));
    }
}

#[test]
fn the_papers_restitution_and_a_driven_body_exclude_each_other() {
    let paper = changed(r#""newton""#, r#""paper""#);
    assert!(Scene::from_json(&paper).is_ok());
    let driven = paper.replace("[0, 0]", "[0, 1]");
    assert_eq!(
        refusal(&driven),
        "effects.restitution.paper: expected no moving body of infinite mass, found discs[1]"
    );
}

#[test]
fn a_periodic_cell_has_an_area_no_walls_and_room_for_every_disc() {
    let cell = |from: &str, to: &str| {
        let periodic = format!(r#""periodic": {{"from": {from}, "to": {to}}}"#);
        changed(
            r#""walls": [{"from": [-1, -1], "to": [10, -1]}]"#,
            &periodic,
        )
    };
    assert!(Scene::from_json(&cell("[0, 0]", "[2, 2]")).is_ok());
    assert_eq!(
        refusal(&cell("[0, 3]", "[10, 3]")),
        "periodic.to[1]: expected a number greater than 3, found 3"
    );
    assert_eq!(
        refusal(&cell("[0, 0]", r#"[10, "1.99"]"#)),
        "discs[0].radius: expected at most half a side of the periodic cell, found 1"
    );
    let both = changed(
        r#""frame""#,
        r#""periodic": {"from": [0, 0], "to": [9, 9]}, "frame""#,
    );
    assert_eq!(
        refusal(&both),
        "periodic: expected a periodic cell or walls, not both, found walls: 1"
    );
}

#[test]
fn faults_of_the_format_say_where() {
    for (from, to, start) in [
        (
            r#""schema": "carom/scene/1","#,
            "",
            "schema: this key is missing",
        ),
        (
            "scene/1",
            "scene/2",
            "schema: unknown variant `carom/scene/2`",
        ),
        ("\"id\"", "\"name\"", "name: unknown field `name`"),
        (
            r#""radius": 1, "mass": 1"#,
            r#""mass": 1"#,
            "discs[0].radius: this key is missing",
        ),
        (
            "radius",
            "raduis",
            "discs[0].raduis: unknown field `raduis`",
        ),
        (
            r#"[5, "1/3"]"#,
            "[5]",
            "discs[1].position: invalid length 1",
        ),
        (
            r#"[5, "1/3"]"#,
            "[5, 6, 7]",
            "discs[1].position: expected the array to end here",
        ),
        (
            r#"[5, "1/3"]"#,
            "[5, true]",
            "discs[1].position[1]: invalid type: boolean `true`",
        ),
        (r#""1/3""#, r#""1/0""#, "discs[1].position[1]: "),
        (r#""1/3""#, r#""nan""#, "discs[1].position[1]: "),
        (
            r#""1/3""#,
            "1e999",
            "discs[1].position[1]: expected a finite binary64",
        ),
        (r#""1/3""#, r#""1e99999999999""#, "discs[1].position[1]: "),
        (r#""infinite""#, r#""heavy""#, "discs[1].mass: "),
        (r#""infinite""#, "null", "discs[1].mass: invalid type: null"),
        (
            r#", "to": [10, -1]"#,
            "",
            "walls[0].to: this key is missing",
        ),
        (
            r#"{"from": [-1, -1], "to": [10, -1]}"#,
            "[[0, 0], [1, 1]]",
            "walls[0]: invalid type",
        ),
        (
            "600",
            "1.5",
            "frame.count: invalid type: floating point `1.5`",
        ),
        (
            r#""newton""#,
            r#""walls""#,
            "effects.restitution: expected the key `newton`",
        ),
        (
            r#""9/10""#,
            r#""9/10", "paper": 1"#,
            "effects.restitution: expected the key `paper`",
        ),
        (
            r#"{"linear": "1/10"}"#,
            "{}",
            "effects.drag.linear: this key is missing",
        ),
        (
            r#"{"linear": "1/10"}"#,
            "null",
            "effects.drag: invalid type: null",
        ),
    ] {
        let text = changed(from, to);
        let message = refusal(&text);
        assert!(message.starts_with(start), "{message}");
        let error = Scene::from_json(&text).expect_err(start);
        assert!(matches!(error.kind(), SceneErrorKind::Format { .. }));
    }
}

#[test]
fn the_builder_names_the_place_of_a_number_that_is_none() {
    let disc = Disc::at([0.0, f64::NAN], 1);
    let error = Scene::builder("nan").disc(disc).build().unwrap_err();
    assert_eq!(error.place(), Some("discs[0].position[1]"));
    let wall = Scene::builder("text").wall(["0", "0"], ["one", "0"]);
    assert_eq!(wall.build().unwrap_err().place(), Some("walls[0].to[0]"));
}
