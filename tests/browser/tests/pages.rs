//! Replays and reports: they load without errors and from one file, and do what they say.

use carom_browser::{Page, carom, scene};
use serde_json::Value;
use std::collections::HashMap;

const DESK: [u32; 2] = [1200, 900];
const PHONE: [u32; 2] = [360, 740];

/// One impact a frame: the disc waits at 2 from 1/2 to 1, where in truth it is on its way
/// back at 4.
#[test]
fn the_slider_moves_bodies() {
    let figure = scene("figure-7.json");
    let page = Page::of(&["run", &figure, "--algorithm", "single", "--html"], DESK);
    let x = |time: f64, pane: usize| {
        page.slide(".time", time);
        page.places(pane)[0][0]
    };
    let start = x(0.0, 0);
    for (time, [run, truth]) in [(0.25, [1.0, 1.0]), (0.75, [2.0, 1.0]), (1.25, [1.0, -1.0])] {
        let moved = [0, 1].map(|pane| x(time, pane) - start);
        assert!((moved[0] - run).abs() < 1e-9, "{moved:?} at {time}");
        assert!((moved[1] - truth).abs() < 1e-9, "{moved:?} at {time}");
    }
    assert_eq!(page.troubles(), Vec::<String>::new());
}

/// The lines of a log that are impacts: time and bodies.
fn impacts(arguments: &[&str]) -> Vec<(f64, [String; 2])> {
    let log = carom(&[&["run"], arguments].concat());
    let lines = log
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).expect("JSON"));
    let impacts = lines.filter(|line| line.get("n").is_some());
    let body = |line: &Value, key: &str| line[key].as_str().expect("a name").to_owned();
    impacts
        .map(|line| {
            let time = line["time"].as_f64().expect("a time");
            (time, ["a", "b"].map(|key| body(&line, key)))
        })
        .collect()
}

/// When two logs part: the first impact of a disc with another body than in the other log.
fn parting(one: &[(f64, [String; 2])], other: &[(f64, [String; 2])]) -> f64 {
    let by_disc = |log: &[(f64, [String; 2])]| {
        let mut courses: HashMap<String, Vec<(f64, [String; 2])>> = HashMap::new();
        for impact in log {
            for body in impact.1.iter().filter(|body| body.starts_with('d')) {
                courses
                    .entry(body.clone())
                    .or_default()
                    .push(impact.clone());
            }
        }
        courses
    };
    let (one, other) = (by_disc(one), by_disc(other));
    let partings = one.iter().filter_map(|(disc, course)| {
        let beside = other.get(disc)?;
        let mut pairs = course.iter().zip(beside);
        let (left, right) = pairs.find(|(left, right)| left.1 != right.1)?;
        Some(left.0.min(right.0))
    });
    partings.fold(f64::INFINITY, f64::min)
}

/// 150 discs and some 6700 impacts: the button leads to where the logs part, and the run
/// plays.
#[test]
fn the_first_difference_is_where_the_logs_part() {
    let table = scene("table1-full.json");
    let multiple = ["run", &table, "--algorithm", "multiple"];
    let page = Page::of(&[&multiple[..], &["--html"]].concat(), DESK);
    let truth = impacts(&[&table, "--arithmetic", "exact"]);
    let expected = parting(&impacts(&multiple[1..]), &truth);
    page.click(".difference");
    assert_eq!(page.number("replays[0].time"), expected);
    page.click(".next");
    let next = truth
        .iter()
        .map(|impact| impact.0)
        .find(|time| *time > expected);
    let at = page.number("replays[0].time");
    assert!(at > expected && Some(at) <= next, "{at}, {next:?}");
    page.click(".play");
    page.until(&format!("replays[0].time > {at} + 0.5"));
    page.click(".play");
    assert_eq!(page.value("replays[0].playing"), false);
    assert_eq!(page.troubles(), Vec::<String>::new());
}

/// Steps of a frame miss the only impact of figure 7, at 1/2, and nothing else is wrong.
#[test]
fn wrong_impacts_are_found() {
    let figure = scene("figure-7.json");
    let page = Page::of(
        &["run", &figure, "--algorithm", "retroactive", "--html"],
        DESK,
    );
    page.press("w");
    assert_eq!(page.number("replays[0].time"), 0.5);
    let legend = page.value("document.querySelector('.faults .missed b').textContent");
    assert_eq!(legend, "1 missed");
    page.press("w");
    assert_eq!(page.number("replays[0].time"), 0.5, "there is no other one");
}

#[test]
fn the_keyboard_is_enough() {
    let figure = scene("figure-5.json");
    let page = Page::of(&["run", &figure, "--html"], DESK);
    // Impacts at 4/10 and 7/10, the end at 1.
    let after = |key: &str| {
        page.press(key);
        page.number("replays[0].time")
    };
    let near = |time: f64, expected: f64| assert!((time - expected).abs() < 1e-9, "{time}");
    near(after("n"), 0.4);
    near(after("n"), 0.7);
    near(after("p"), 0.4);
    near(after("ArrowRight"), 0.405);
    near(after("ArrowLeft"), 0.4);
    page.press(" ");
    page.until("replays[0].time === 1");
    assert_eq!(page.troubles(), Vec::<String>::new());
}

#[test]
fn it_fits_a_phone_and_the_dark() {
    let table = scene("figure-8.json");
    let page = Page::of(&["run", &table, "--algorithm", "multiple", "--html"], PHONE);
    let wide = page.number("document.documentElement.scrollWidth");
    assert!(wide <= f64::from(PHONE[0]), "{wide}");
    let ground = "getComputedStyle(document.body).backgroundColor";
    let light = page.value(ground);
    page.darken();
    page.until(&format!("{ground} !== {light}"));
}

/// The report has a replay for each scene, which play apart.
#[test]
fn a_report_can_be_played() {
    let scenes = [scene("figure-7.json"), scene("figure-8.json")];
    let arguments = ["compare", &scenes[0], &scenes[1], "--html"];
    let page = Page::of(&arguments, DESK);
    assert_eq!(page.number("replays.length"), 2.0);
    page.slide("section:nth-of-type(2) .time", 0.5);
    assert_eq!(page.number("replays[1].time"), 0.5);
    assert_eq!(page.number("replays[0].time"), 0.0);
    assert_eq!(page.troubles(), Vec::<String>::new());
}
