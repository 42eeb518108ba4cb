//! Scenes that are generated.

use carom::scalar::Number;
use carom::scene::generate::{cradle, galperin, gas, table1};

use super::*;

fn number(text: &str) -> Number {
    text.parse().expect("a number")
}

#[test]
fn generators_have_their_parameters() {
    let table: [(&[&str], _); 6] = [
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
fn scenes_go_to_files() {
    let scratch = Scratch::new();
    let name = scratch.name("cradle.json");
    assert_eq!(results(&["generate", "cradle", "--output", &name]), "");
    results(&["validate", &name]);
}

#[test]
fn parameters_that_make_no_scene_are_refused() {
    let table: [(&[&str], &str); 5] = [
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
    ];
    for (arguments, expected) in table {
        let (code, message) = ending(&[&["generate"], arguments].concat());
        assert_eq!(code, 2, "{arguments:?}");
        assert!(message.starts_with(expected), "{message}");
    }
}
