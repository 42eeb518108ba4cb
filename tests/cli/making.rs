//! Scenes that are generated.

use carom::scalar::Number;
use carom::scene::generate::{
    Family, Rack, break_shot, corner, cradle, galperin, gas, mirror, ring, scene_of, table1,
    transformed,
};

use super::*;

fn number(text: &str) -> Number {
    text.parse().expect("a number")
}

#[test]
fn generators_have_their_parameters() {
    let table: [(&[&str], _); 16] = [
        (&["table1"], table1(42, &number("1"))),
        (
            &["table1", "--seed", "7", "--scale", "0.33"],
            table1(7, &number("0.33")),
        ),
        (
            &["gas", "--seed", "3", "--count", "20", "--packing", "0.2"],
            gas(3, 20, 0.2),
        ),
        (&["galperin", "--power", "3"], galperin(3)),
        (&["cradle"], cradle(5, 1, &number("0"))),
        (
            &["cradle", "--count", "7", "--moving", "2", "--gap", "1/8"],
            cradle(7, 2, &number("1/8")),
        ),
        (&["break"], break_shot(5, &Rack::Gap(number("1/10")))),
        (
            &["break", "--rows", "2", "--gap", "0"],
            break_shot(2, &Rack::Gap(number("0"))),
        ),
        (&["break", "--touching"], break_shot(5, &Rack::Touching)),
        (&["ring", "--count", "20"], ring(20)),
        (
            &["mirror", "--seed", "3", "--count", "20", "--packing", "0.2"],
            mirror(3, 20, 0.2),
        ),
        (&["corner"], corner(&["0", "1"].map(number))),
        (
            &["corner", "--wedge", "-3/5,4/5"],
            corner(&["-3/5", "4/5"].map(number)),
        ),
        (&["gas"], gas(42, 100, 0.3)),
        (&["family", "near-tie"], scene_of(Family::NearTie, 42, 0)),
        (
            &["family", "bullets", "--seed", "7", "--index", "3"],
            scene_of(Family::Bullets, 7, 3),
        ),
    ];
    for (arguments, expected) in table {
        let text = results(&[&["generate"], arguments].concat());
        assert!(
            text == expected.expect("a scene").to_json(),
            "{arguments:?}"
        );
    }
}

#[test]
fn any_scene_can_be_elsewhere() {
    let scene = ring(8).expect("a scene");
    let table: [(&[&str], _, _); 4] = [
        (&["--shift", "10/3"], ["1", "0"], ["10/3", "0"]),
        (&["--shift", "-1,0.5"], ["1", "0"], ["-1", "1/2"]),
        (&["--rotate", "-3/5,4/5"], ["-3/5", "4/5"], ["0", "0"]),
        (
            &["--rotate", "3/5,4/5", "--shift", "10/3"],
            ["3/5", "4/5"],
            ["10/3", "0"],
        ),
    ];
    for (arguments, rotate, shift) in table {
        let text = results(&[&["generate", "ring"], arguments].concat());
        let expected = transformed(&scene, &rotate.map(number), &shift.map(number));
        assert!(
            text == expected.expect("a scene").to_json(),
            "{arguments:?}"
        );
        // The options stand anywhere.
        assert_eq!(
            text,
            results(&[&["generate"], arguments, &["ring"]].concat())
        );
    }
}

#[test]
fn scenes_go_to_files() {
    let scratch = Scratch::new();
    let name = scratch.name("cradle.json");
    assert_eq!(results(&["generate", "cradle", "--output", &name]), "");
    results(&["validate", &name]);
}

#[test]
fn parameters_that_make_no_scene_are_refused() {
    let table: [(&[&str], &str); 10] = [
        (&["gas", "--packing", "0.9"], "carom: packing: expected "),
        (&["gas", "--packing", "nan"], "carom: packing: "),
        (
            &["galperin", "--power", "99"],
            "carom: power: expected at most 15",
        ),
        (
            &["cradle", "--moving", "5"],
            "carom: moving: expected from 1 to ",
        ),
        (
            &["cradle", "--gap=-1"],
            "carom: gap: expected a number not below 0",
        ),
        (
            &["break", "--rows", "0"],
            "carom: rows: expected from 1 to 1000",
        ),
        (
            &["ring", "--count", "6"],
            "carom: count: expected a multiple of 4",
        ),
        (
            &["corner", "--wedge", "0,-1"],
            "carom: wedge: expected a point above",
        ),
        (
            &["ring", "--rotate", "1,1"],
            "carom: rotate: expected a rational point",
        ),
        (
            &["ring", "--shift", "x"],
            "error: invalid value 'x' for '--shift",
        ),
    ];
    for (arguments, expected) in table {
        let (code, message) = ending(&[&["generate"], arguments].concat());
        assert_eq!(code, 2, "{arguments:?}");
        assert!(message.starts_with(expected), "{message}");
    }
}
