//! Exact arithmetic: bounds that enclose the truth, with all their digits.

use super::*;

/// (20 - √15) / 40 = 0.40317541634481457787051836500544000972917695736771…
#[test]
fn irrational_times_are_enclosed() {
    let name = scene("figure-2.json");
    let log = run(&[&name, "--arithmetic", "exact"]);
    let event = &log.events[0];
    assert_eq!(Ok(event.time), "0.40317541634481457787".parse());
    assert_eq!(
        bounds(event),
        ["0.4031754163448145778705", "0.4031754163448145778706"]
    );
    let log = run(&[&name, "--arithmetic", "exact", "--digits", "40"]);
    assert_eq!(
        bounds(&log.events[0]),
        [
            "0.403175416344814577870518365005440009729176",
            "0.403175416344814577870518365005440009729177"
        ]
    );
}

#[test]
fn rational_times_are_exact() {
    let log = run(&[&scene("timeline-1.json"), "--arithmetic", "exact"]);
    assert_eq!(bounds(&log.events[0]), ["0.375", "0.375"]);
    assert_eq!(bounds(&log.events[1]), ["5/12", "5/12"]);
    assert_eq!(log.events[1].time, 5.0 / 12.0);
}

/// A bare 0.1 is the binary64 nearest to it, a string is a tenth.
#[test]
fn numbers_are_what_is_written() {
    let scratch = Scratch::new();
    let time = |speed: &str| {
        let rest = r#""walls": [{"from": [2, -1], "to": [2, 1]}], "frame": {"duration": 20},"#;
        let keys = format!(r#""position": [0, 0], "velocity": [{speed}, 0]"#);
        let name = scratch.write("speed.json", one_disc(&keys, rest));
        let log = run(&[&name, "--arithmetic", "exact"]);
        bounds(&log.events[0]).map(str::to_owned)
    };
    assert_eq!(time("\"0.1\""), ["10", "10"]);
    // 0.1 is 3602879701896397 / 2^55.
    let expected = "36028797018963968/3602879701896397";
    assert_eq!(time("0.1"), [expected, expected]);
}

#[test]
fn states_have_bounds() {
    let name = scene("timeline-1.json");
    let arguments = ["--arithmetic", "exact", "--until", "5/12", "--state", "-"];
    let text = results(&[&["run", &name], &arguments[..]].concat());
    let expected = concat!(
        r#"{"schema":"carom/state/1","scene":"timeline-1","#,
        r#""time":{"f64":0.4166666666666667,"lo":"5/12","hi":"5/12"},"discs":[{"#,
        r#""position":[{"f64":1.3333333333333333,"lo":"4/3","hi":"4/3"},"#,
        r#"{"f64":1.0,"lo":"1","hi":"1"}],"#,
        r#""velocity":[{"f64":8.0,"lo":"8","hi":"8"},{"f64":12.0,"lo":"12","hi":"12"}]}]}"#,
        "\n",
    );
    assert_eq!(text, expected);
    let state = State::from_json(&text).expect("a state");
    assert_eq!(state.to_json(), text);
}

/// Two discs and a wall: floor(π 10^k) impacts.
#[test]
fn impacts_count_the_digits_of_pi() {
    let scratch = Scratch::new();
    for (power, impacts) in [("0", 3), ("1", 31), ("2", 314)] {
        let name = scratch.name("pi.json");
        results(&["generate", "galperin", "--power", power, "--output", &name]);
        let log = run(&[&name, "--arithmetic", "exact"]);
        assert_eq!(log.events.len(), impacts);
        let [start, end] = log.summary.expect("a summary").energy;
        assert_eq!(start, end);
    }
}

/// A disc that meets two others at times that differ by 3.1e-18, relative to
/// them: that is 2^-58.2 (`scenes/hard/f64-order2d-0.json`).
#[test]
fn the_header_tells_how_close_it_was() {
    let scratch = Scratch::new();
    let case = std::fs::read_to_string(scene("hard/f64-order2d-0.json")).expect("the case");
    let case: serde_json::Value = serde_json::from_str(&case).expect("JSON");
    let name = scratch.write("close.json", case["scene"].to_string());
    let header = run(&[&name, "--arithmetic", "exact"])
        .header
        .expect("a header");
    assert_eq!(header.closest_bits, Some(58));
    assert_eq!((header.bits, header.restarts), (Some(128), Some(0)));
    assert!(header.bits_lost.is_some_and(|lost| lost < 32));
}

/// The rule is named, and belongs to the timeline.
#[test]
fn rules_for_simultaneous_impacts() {
    let name = scene("figure-2.json");
    for rule in ["sequential", "reflect"] {
        let header = run(&[&name, "--simultaneous", rule])
            .header
            .expect("a header");
        assert_eq!(header.simultaneous.as_deref(), Some(rule));
    }
    let misplaced = ["--algorithm", "single", "--simultaneous", "reflect"];
    let (code, message) = ending(&[&["run", &*name], &misplaced[..]].concat());
    assert_eq!(code, 2);
    assert!(message.contains("--simultaneous: not an option of the algorithm single"));
}
