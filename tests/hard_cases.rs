//! The hard cases in `scenes/hard`, whose answers were computed or derived
//! elsewhere: each is run in exact arithmetic and held against them.

#![cfg(feature = "json")]

use std::fs;
use std::ops::ControlFlow;
use std::path::PathBuf;

use carom::frame::Passes;
use carom::impact::Impact;
use carom::run::{Options, Outcome, Status, run};
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::Scene;
use carom::simulation::Algorithm;
use num_bigint::BigInt;
use num_rational::BigRational;
use serde_json::Value;

fn load(name: &str) -> (Scene, Value) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("scenes/hard/{name}.json"));
    let case: Value = serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap();
    let scene = Scene::from_json(&case["scene"].to_string()).unwrap();
    (scene, case)
}

fn names() -> Vec<String> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("scenes/hard");
    let files = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let mut names: Vec<_> = files
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "json")
        })
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    names.sort();
    names
}

fn run_exactly(scene: &Scene, algorithm: Algorithm, options: &Options) -> Outcome<Exact> {
    run(
        scene,
        algorithm,
        options,
        &mut |_| ControlFlow::Continue(()),
    )
    .unwrap()
}

/// As many digits as the answers have.
fn precise() -> Options {
    Options {
        digits: 50,
        ..Options::default()
    }
}

fn rational(text: &Value) -> BigRational {
    let text = text.as_str().unwrap();
    text.to_lowercase().parse::<Number>().unwrap().to_rational()
}

/// Whether a number agrees with an expected one: exactly where both are
/// rational, otherwise to within the given number of decimals.
fn agrees(number: &Exact, expected: &Value) -> bool {
    let expected = rational(expected);
    let (lo, hi) = number.enclosure().unwrap();
    let slack = BigRational::new(1.into(), BigInt::from(10).pow(45));
    let scale = BigRational::from_integer(1.into()) + expected.clone().max(-expected.clone());
    let slack = slack * scale;
    lo - &slack <= expected && expected <= hi + &slack
}

fn check_impact(name: &str, impact: &Impact<Exact>, expected: &Value) {
    let place = format!("{name}: {} at {}", impact.pair, impact.time.to_f64());
    assert_eq!(
        impact.pair.a.to_string(),
        expected["a"].as_str().unwrap(),
        "{place}"
    );
    assert_eq!(
        impact.pair.b.to_string(),
        expected["b"].as_str().unwrap(),
        "{place}"
    );
    assert!(agrees(&impact.time, &expected["time"]), "{place}");
    if expected["rational"] == true {
        assert!(impact.time.is_rational(), "{place}");
    }
    assert_eq!(impact.end.is_some(), expected["end"] == true, "{place}");
    if expected["simultaneous"] == true {
        assert!(impact.tie.is_some(), "{place}");
    }
}

fn check_discs<'a>(name: &str, discs: impl IntoIterator<Item = [&'a Exact; 4]>, expected: &Value) {
    let expected = expected.as_array().unwrap();
    for (index, (disc, expected)) in discs.into_iter().zip(expected).enumerate() {
        for (number, expected) in disc.into_iter().zip(expected.as_array().unwrap()) {
            let found = number.to_f64();
            assert!(
                agrees(number, expected),
                "{name}: d{index}: {found}, not {expected}"
            );
        }
    }
}

fn coordinates(outcome: &Outcome<Exact>) -> impl Iterator<Item = [&Exact; 4]> {
    outcome.end.iter().map(|disc| {
        let (position, velocity) = (&disc.position, &disc.velocity);
        [&position.x, &position.y, &velocity.x, &velocity.y]
    })
}

fn check_timeline(name: &str) {
    let (scene, case) = load(name);
    let limit = case["max_events"].as_u64();
    let options = Options {
        max_events: limit.unwrap_or(u64::MAX),
        ..precise()
    };
    let outcome = run_exactly(&scene, Algorithm::Timeline, &options);
    let ended = limit.map_or(Status::Complete, |_| Status::EventLimit);
    assert_eq!(outcome.status, ended, "{name}");
    let expected = &case["timeline"];
    let log = expected["log"].as_array().unwrap();
    for (impact, expected) in outcome.impacts.iter().zip(log) {
        check_impact(name, impact, expected);
    }
    assert_eq!(outcome.impacts.len(), log.len(), "{name}");
    assert_eq!(
        outcome.grazes,
        expected["grazes"].as_u64().unwrap(),
        "{name}"
    );
    check_final(name, &scene, expected);
}

/// The state at the time for which it is given: that of the last impact, or
/// one that is no impact's.
fn check_final(name: &str, scene: &Scene, expected: &Value) {
    let time = &expected["final"]["time"];
    let log = expected["log"].as_array().unwrap();
    let is_last = log.last().is_some_and(|last| {
        let apart = rational(&last["time"]) - rational(time);
        let close = BigRational::new(1.into(), BigInt::from(10).pow(40));
        -&close < apart && apart < close
    });
    let until = time.as_str().unwrap().parse().unwrap();
    let options = Options {
        max_events: if is_last { log.len() as u64 } else { u64::MAX },
        until: (!is_last).then_some(until),
        ..precise()
    };
    let outcome = run_exactly(scene, Algorithm::Timeline, &options);
    check_discs(name, coordinates(&outcome), &expected["final"]["discs"]);
}

/// The frames of a case for an algorithm with so many passes.
fn check_frames(name: &str, scene: &Scene, algorithm: Algorithm, frames: &Value) {
    for (index, frame) in frames.as_array().unwrap().iter().enumerate() {
        let until = i32::try_from(index + 1).unwrap();
        let options = Options {
            until: Some(Number::from(until)),
            ..precise()
        };
        let outcome = run_exactly(scene, algorithm, &options);
        assert_eq!(outcome.status, Status::Complete, "{name}");
        let impacts = outcome.impacts.iter();
        let impacts: Vec<_> = impacts
            .filter(|impact| impact.step.unwrap().frame == index as u64)
            .collect();
        let log = frame["log"].as_array().unwrap();
        assert_eq!(
            impacts.len(),
            log.len(),
            "{name} {algorithm:?} frame {index}"
        );
        for (impact, expected) in impacts.into_iter().zip(log) {
            check_frame_impact(name, impact, expected, index);
        }
        check_discs(name, coordinates(&outcome), &frame["state"]);
    }
}

fn check_frame_impact(name: &str, impact: &Impact<Exact>, expected: &Value, frame: usize) {
    let second = match &expected["j"] {
        Value::String(wall) => wall.replace("wall ", "w"),
        disc => format!("d{disc}"),
    };
    assert_eq!(
        impact.pair.a.to_string(),
        format!("d{}", expected["i"]),
        "{name}"
    );
    assert_eq!(impact.pair.b.to_string(), second, "{name}");
    assert_eq!(
        u64::from(impact.step.unwrap().pass),
        expected["pass"].as_u64().unwrap()
    );
    let start = Exact::from_integer(i32::try_from(frame).unwrap());
    let clock = impact.time.clone() - &start;
    assert!(agrees(&clock, &expected["time_i"]), "{name}");
    let other = impact.other_time.as_ref().unwrap_or(&impact.time).clone() - &start;
    assert!(
        expected["time_j"].is_null() || agrees(&other, &expected["time_j"]),
        "{name}"
    );
}

#[test]
fn the_timeline_gives_the_certified_answers() {
    for name in names() {
        let (_, case) = load(&name);
        if !case["timeline"].is_null() {
            check_timeline(&name);
        }
    }
}

#[test]
fn the_frame_algorithms_give_the_answers_of_the_readings() {
    for name in names() {
        let (scene, case) = load(&name);
        for passes in 1..=4 {
            let key = format!("passes={passes}");
            let count = Passes::Count(passes);
            for algorithm in [Algorithm::Multiple(count), Algorithm::Synchronised(count)] {
                let frames = &case[algorithm.to_string()][&key];
                if !frames.is_null() {
                    check_frames(&name, &scene, algorithm, frames);
                }
                if passes == 1 && matches!(algorithm, Algorithm::Multiple(_)) && !frames.is_null() {
                    check_frames(&name, &scene, Algorithm::Single, frames);
                }
            }
        }
    }
}
