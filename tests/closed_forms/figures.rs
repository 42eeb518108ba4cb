//! The paper's figures and timelines, as they are in `scenes`.

use std::path::Path;

use carom::frame::Passes;
use carom::run::Outcome;
use carom::scalar::Exact;
use carom::scene::{Restitution, Scene};
use carom::simulation::Algorithm::{self, Multiple, Retroactive, Single, Synchronised};

use crate::common::agree::{assert_end, assert_log, assert_surd, rational};
use crate::common::{complete, exactly, names};

fn figure(name: &str) -> Scene {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    Scene::read(root.join(format!("scenes/{name}.json"))).unwrap()
}

fn stepped(name: &str, algorithm: Algorithm) -> Outcome<Exact> {
    complete(&figure(name), algorithm)
}

/// (5 - 10t)² + 1/16 = 1, so 10t = 5 - √15/4.
#[test]
fn figure_2() {
    let outcome = exactly(&figure("figure-2"));
    assert_eq!(names(&outcome.impacts), ["d0 d1"]);
    assert_surd(&outcome.impacts[0].time, ["1/2", "-1/40"], "15");
}

/// At the end of the frame the disc is behind the other one. With 4 steps it
/// is found in the middle of the other, where their line of centres is
/// normal to the motion: it is pushed 3/4 aside but nothing approaches. With
/// 12 steps it is found 5/6 before it, at the fifth.
#[test]
fn figure_2_retroactively() {
    let fixed = ["5", "1/4", "0", "0"];
    let outcome = stepped("figure-2", Retroactive { substeps: 1 });
    assert_log(&outcome, &[]);
    assert_end(&outcome, &[["10", "0", "10", "0"], fixed]);
    let outcome = stepped("figure-2", Retroactive { substeps: 4 });
    assert_log(&outcome, &[]);
    assert_end(&outcome, &[["10", "-3/4", "10", "0"], fixed]);
    let outcome = stepped("figure-2", Retroactive { substeps: 12 });
    assert_log(&outcome, &[("5/12", "d0 d1")]);
    assert_eq!(outcome.impacts[0].step.unwrap().pass, 5);
}

/// The velocity goes over whole, or half of it with the paper's C = 1/2.
#[test]
fn figure_4() {
    let lossy = figure("figure-4");
    let outcome = exactly(&lossy);
    assert_log(&outcome, &[("1/2", "d0 d1")]);
    assert_end(&outcome, &[["2", "0", "0", "0"], ["5", "0", "2", "0"]]);
    let elastic = lossy.to_builder().restitution(Restitution::Elastic);
    let outcome = exactly(&elastic.build().unwrap());
    assert_log(&outcome, &[("1/2", "d0 d1")]);
    assert_end(&outcome, &[["2", "0", "0", "0"], ["6", "0", "4", "0"]]);
}

/// At 2/5 the centres are (8, 6)/5 apart, and the 8 at which they close along
/// (4, 3)/5 change sides: d0 gets (8, -24)/5, d1 (22, 24)/5. At 7/10 d0 is
/// 2 above d2, which takes its -24/5 along y.
#[test]
fn figure_5() {
    let log = [("2/5", "d0 d1"), ("7/10", "d0 d2")];
    let outcome = exactly(&figure("figure-5"));
    assert_log(&outcome, &log);
    let first = ["104/25", "-36/25", "8/5", "0"];
    let second = ["186/25", "102/25", "22/5", "24/5"];
    let third = ["92/25", "-122/25", "0", "-24/5"];
    assert_end(&outcome, &[first, second, third]);
    // Of the second pass both d0 and d2 stay at their collision.
    let passes = stepped("figure-5", Multiple(Passes::Count(2)));
    assert_log(&passes, &log);
    let first = ["92/25", "-36/25", "8/5", "0"];
    let third = ["92/25", "-86/25", "0", "-24/5"];
    assert_end(&passes, &[first, second, third]);
    // A third pass finds nothing, and all move on.
    let passes = stepped("figure-5", Synchronised(Passes::Count(3)));
    assert_log(&passes, &log);
    assert_eq!(passes.impacts[1].step.unwrap().pass, 2);
}

/// One pass finds only the first impact; both discs stay there.
#[test]
fn figure_5_with_a_single_collision() {
    let outcome = stepped("figure-5", Single);
    assert_log(&outcome, &[("2/5", "d0 d1")]);
    let first = ["16/5", "0", "8/5", "-24/5"];
    let second = ["24/5", "6/5", "22/5", "24/5"];
    assert_end(&outcome, &[first, second, ["92/25", "-86/25", "0", "0"]]);
}

/// At 1/2 the centres are (8, 6)/5 apart. Along n = (4, 3)/5 the parts 4 and
/// -24/5 change places: 44/5 n = (176, 132)/25.
#[test]
fn figure_6_moving_moving() {
    let outcome = exactly(&figure("figure-6-moving-moving"));
    assert_log(&outcome, &[("1/2", "d0 d1")]);
    let first = ["37/25", "-66/25", "-51/25", "-132/25"];
    let second = ["153/25", "46/25", "101/25", "32/25"];
    assert_end(&outcome, &[first, second]);
}

/// Of (8, 0) the part 32/5 n = (128, 96)/25 goes over.
#[test]
fn figure_6_moving_still() {
    let outcome = exactly(&figure("figure-6-moving-still"));
    assert_log(&outcome, &[("1/2", "d0 d1")]);
    let first = ["136/25", "-48/25", "72/25", "-96/25"];
    let second = ["204/25", "78/25", "128/25", "96/25"];
    assert_end(&outcome, &[first, second]);
}

/// The frame algorithms part the two by 1/4 (4, 3)/5 each; the timeline
/// leaves them alone.
#[test]
fn figure_6_still_still() {
    let outcome = exactly(&figure("figure-6-still-still"));
    assert_log(&outcome, &[]);
    assert_eq!(outcome.overlaps, 1);
    assert_end(&outcome, &[["0", "0", "0", "0"], ["6/5", "9/10", "0", "0"]]);
    for algorithm in [
        Retroactive { substeps: 1 },
        Single,
        Multiple(Passes::Count(2)),
    ] {
        let outcome = stepped("figure-6-still-still", algorithm);
        assert_log(&outcome, &[]);
        let first = ["-1/5", "-3/20", "0", "0"];
        assert_end(&outcome, &[first, ["7/5", "21/20", "0", "0"]]);
    }
}

/// In three frames at d = 4 the disc should go 3d: 2 there and 10 back. It
/// goes 2.5d where it must wait at its collision for the frame to end.
#[test]
fn figure_7() {
    let fixed = ["4", "0", "0", "0"];
    let outcome = exactly(&figure("figure-7"));
    assert_log(&outcome, &[("1/2", "d0 d1")]);
    assert_end(&outcome, &[["-8", "0", "-4", "0"], fixed]);
    let outcome = stepped("figure-7", Single);
    assert_log(&outcome, &[("1/2", "d0 d1")]);
    assert_end(&outcome, &[["-6", "0", "-4", "0"], fixed]);
}

/// A second pass lets it go on: the full d, 2 there and 2 back.
#[test]
fn figure_8() {
    let fixed = ["4", "0", "0", "0"];
    for algorithm in [
        Algorithm::Timeline,
        Multiple(Passes::Count(2)),
        Synchronised(Passes::Count(2)),
    ] {
        let outcome = stepped("figure-8", algorithm);
        assert_log(&outcome, &[("1/2", "d0 d1")]);
        assert_end(&outcome, &[["0", "0", "-4", "0"], fixed]);
    }
    let outcome = stepped("figure-8", Single);
    assert_end(&outcome, &[["2", "0", "-4", "0"], fixed]);
}

/// x = 4 - 8t is 1 at 3/8, y = 6 - 12t is 1 at 5/12.
#[test]
fn timeline_1() {
    let outcome = exactly(&figure("timeline-1"));
    assert_log(&outcome, &[("3/8", "d0 w1"), ("5/12", "d0 w0")]);
    assert_end(&outcome, &[["6", "8", "8", "12"]]);
}

/// The centres are (6, -8)/5, (0, -2), (8, 6)/5 and (8, 6)/5 apart at the four
/// impacts; along these, equal discs change the parts of their velocities:
/// 24/5 and 4/5, 10 and -2, 32/5 and -2/5, -28/5 and -26/3.
#[test]
fn timeline_2() {
    let log = [
        ("1/4", "d0 d1"),
        ("3/8", "d2 d3"),
        ("1/2", "d0 d2"),
        ("3/4", "d1 d3"),
    ];
    let end = [
        ["87/25", "9/25", "4/25", "-22/25"],
        ["104/75", "-373/50", "-304/75", "-226/25"],
        ["168/25", "126/25", "86/25", "152/25"],
        ["189/50", "-151/25", "-22/25", "-204/25"],
    ];
    for algorithm in [Algorithm::Timeline, Synchronised(Passes::Count(5))] {
        let mut outcome = stepped("timeline-2", algorithm);
        // A pass takes what is first for its objects, not first of all.
        outcome.impacts.sort_by_key(|impact| rational(&impact.time));
        assert_log(&outcome, &log);
        assert_end(&outcome, &end);
    }
}
