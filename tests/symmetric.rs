//! Symmetric scenes, the natural source of ties: all is decided, wherever in
//! the plane they are, and what symmetry promises holds.

#![cfg(feature = "cli")]

use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;

use carom::body::{BodyId, Pair};
use carom::run::{Options, Outcome, Status, run};
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::generate::{Rack, break_shot, corner, cradle, mirror, ring, transformed};
use carom::scene::{Disc, Scene};
use carom::simulation::Algorithm;
use carom::symmetry::{Symmetry, symmetries};
use carom::timeline::Simultaneous::{self, Reflect, Sequential};
use num_rational::BigRational;

const MOST_IMPACTS: u64 = 200;

fn number(text: &str) -> Number {
    text.parse().expect(text)
}

fn ratio(text: &str) -> BigRational {
    number(text).to_rational()
}

fn follow(scene: &Scene, rule: Simultaneous) -> Outcome<Exact> {
    let options = Options {
        max_events: MOST_IMPACTS,
        simultaneous: rule,
        ..Options::default()
    };
    let go_on = &mut |_| ControlFlow::Continue(());
    let outcome = run::<Exact>(scene, Algorithm::Timeline, &options, go_on).unwrap();
    assert!(
        matches!(outcome.status, Status::Complete | Status::EventLimit),
        "{}, {rule}: {:?}",
        scene.id(),
        outcome.status
    );
    outcome
}

fn scenes() -> Vec<Scene> {
    let gap = |text| Rack::Gap(number(text));
    [
        break_shot(5, &gap("1/1000")),
        break_shot(5, &gap("1/10")),
        break_shot(5, &Rack::Touching),
        ring(12),
        ring(40),
        mirror(7, 4, 0.3),
        mirror(7, 20, 0.3),
        corner(&[number("0"), number("1")]),
        corner(&[number("-3/5"), number("4/5")]),
        cradle(5, 2, &number("0")),
    ]
    .into_iter()
    .map(Result::unwrap)
    .collect()
}

/// Turned by (3/5, 4/5) and shifted by 10/3.
fn elsewhere(scene: &Scene) -> Scene {
    let turn = [number("3/5"), number("4/5")];
    let shift = [number("10/3"), number("10/3")];
    transformed(scene, &turn, &shift).unwrap()
}

/// Times, pairs and ties; of simultaneous impacts without a common disc the
/// order is the names', so the logs are the same line by line.
fn log(outcome: &Outcome<Exact>) -> Vec<(Pair, Option<u32>)> {
    let impacts = outcome.impacts.iter();
    impacts.map(|impact| (impact.pair, impact.tie)).collect()
}

/// Whether two enclosures have a number in common.
fn may_be_equal(one: &Exact, other: &Exact) -> bool {
    let [one, other] = [one, other].map(|number| number.enclosure().unwrap());
    one.0 <= other.1 && other.0 <= one.1
}

#[test]
fn all_is_decided_wherever_the_scene_is() {
    for scene in scenes() {
        for rule in [Sequential, Reflect] {
            let here = follow(&scene, rule);
            let there = follow(&elsewhere(&scene), rule);
            assert_eq!(log(&here), log(&there), "{}, {rule}", scene.id());
            for (one, other) in here.impacts.iter().zip(&there.impacts) {
                assert!(may_be_equal(&one.time, &other.time), "{}", scene.id());
            }
        }
    }
}

fn image(symmetry: &Symmetry, pair: Pair) -> Pair {
    let image = |body| match body {
        BodyId::Disc(disc) => BodyId::Disc(symmetry.discs[disc as usize]),
        BodyId::Wall(wall) => BodyId::Wall(symmetry.walls[wall as usize]),
    };
    Pair::new(image(pair.a), image(pair.b))
}

/// With `reflect` nothing breaks the symmetry: each impact's image happens at
/// the same time, so it is in the same tie. (The last group may be cut off.)
#[test]
fn reflect_keeps_the_symmetry() {
    for scene in scenes() {
        let outcome = follow(&scene, Reflect);
        let last = outcome.impacts.last().and_then(|impact| impact.tie);
        let mut ties: BTreeMap<u32, BTreeSet<Pair>> = BTreeMap::new();
        for (pair, tie) in log(&outcome) {
            if let Some(tie) = tie {
                ties.entry(tie).or_default().insert(pair);
            }
        }
        for symmetry in symmetries(&scene) {
            for (pair, tie) in log(&outcome) {
                let image = image(&symmetry, pair);
                if tie != last && image != pair {
                    let together = tie.is_some_and(|tie| ties[&tie].contains(&image));
                    assert!(together, "{}: {pair} without {image}", scene.id());
                }
            }
        }
    }
}

/// Whether the enclosure of a number is narrow and holds a rational.
fn is_about(number: &Exact, expected: &str) -> bool {
    let (lo, hi) = number.enclosure().unwrap();
    let expected = ratio(expected);
    lo <= expected && expected <= hi && &hi - &lo < ratio("1e-20")
}

/// A disc at speed 1 into two touching ones. The normals are (√3, ±1)/2, the
/// impulses are equal; with j that of one of them, the disc keeps 1 - √3 j
/// and each of the others gets √3/2 j along x, and energy demands
/// (1 - √3 j)² + 2 j² = 1, so j = 2√3/5: -1/5, 3/5 and ±√3/5. By pairs in turn
/// it is another answer, with the same energy.
#[test]
fn a_disc_into_two_that_touch() {
    let scene = Scene::builder("two")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .disc(Disc::at([4, 1], 1))
        .disc(Disc::at([4, -1], 1))
        .frame(9, 1)
        .build()
        .unwrap();
    let outcome = follow(&scene, Reflect);
    let names: Vec<_> = log(&outcome)
        .iter()
        .map(|(pair, _)| pair.to_string())
        .collect();
    assert_eq!(names, ["d0 and d1", "d0 and d2"]);
    let velocities = outcome.end.iter().map(|disc| &disc.velocity.x);
    for (velocity, expected) in velocities.zip(["-1/5", "3/5", "3/5"]) {
        assert!(is_about(velocity, expected), "{}", velocity.to_f64());
    }
    let sideways = &outcome.end[1].velocity.y;
    assert!(is_about(&sideways.square(), "3/25"));
    let by_turns = follow(&scene, Sequential);
    assert!(!is_about(&by_turns.end[0].velocity.x, "-1/5"));
}

/// Newton's cradle, two of five coming in, touching: two leave, whatever the
/// rule; equal masses on a line exchange velocities.
#[test]
fn a_cradle() {
    for gap in ["0", "1/1000"] {
        let scene = cradle(5, 2, &number(gap)).unwrap();
        for rule in [Sequential, Reflect] {
            let outcome = follow(&scene, rule);
            let velocities: Vec<_> = outcome
                .end
                .iter()
                .map(|disc| disc.velocity.x.to_f64())
                .collect();
            let speed = velocities[4];
            assert_eq!(velocities, [0.0, 0.0, 0.0, speed, speed], "{gap}, {rule}");
        }
    }
}

/// Energy is kept by both rules.
#[test]
fn conservation() {
    for scene in scenes() {
        for rule in [Sequential, Reflect] {
            let outcome = follow(&scene, rule);
            let energy = |discs: &[carom::body::Disc<Exact>]| {
                discs.iter().fold(Exact::from_integer(0), |sum, disc| {
                    // All masses are equal.
                    sum + disc.velocity.norm_squared()
                })
            };
            let [before, after] = [&outcome.start, &outcome.end].map(|discs| energy(discs));
            assert!(may_be_equal(&before, &after), "{}, {rule}", scene.id());
        }
    }
}
