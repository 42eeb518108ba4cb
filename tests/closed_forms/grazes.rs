//! Tangent passes, which are counted but are no impacts, and what is next to
//! them.

use carom::run::Outcome;
use carom::scalar::Exact;
use carom::scene::Disc;

use crate::common::agree::{assert_end, assert_log};
use crate::common::{exactly, lasting, names};

#[track_caller]
fn assert_grazes(outcome: &Outcome<Exact>, count: u64) {
    assert_log(outcome, &[]);
    assert_eq!(outcome.grazes, count);
}

/// The centres pass at the distance 1 + 1.
#[test]
fn of_two_discs() {
    let scene = lasting("10")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .disc(Disc::at([5, 2], 1));
    let outcome = exactly(&scene.build().unwrap());
    assert_grazes(&outcome, 1);
    assert_end(&outcome, &[["10", "0", "1", "0"], ["5", "2", "0", "0"]]);
}

/// The same, not along an axis: from (0, 0) in the direction (3, 4), past
/// 10 (3, 4)/5 + 2 (-4, 3)/5.
#[test]
fn of_two_discs_obliquely() {
    let scene = lasting("10")
        .disc(Disc::at([0, 0], 1).velocity([3, 4]))
        .disc(Disc::at(["22/5", "46/5"], 1));
    assert_grazes(&exactly(&scene.build().unwrap()), 1);
}

/// 2^-40 closer it is an impact, 2^-40 further away nothing.
#[test]
fn nearly() {
    let past = |y: &str| {
        let scene = lasting("10")
            .disc(Disc::at([0, 0], 1).velocity([1, 0]))
            .disc(Disc::at(["5", y], 1));
        exactly(&scene.build().unwrap())
    };
    let closer = past("0x1.fffffffffep+0");
    assert_eq!(
        (names(&closer.impacts), closer.grazes),
        (vec!["d0 d1".into()], 0)
    );
    assert_grazes(&past("0x1.0000000001p+1"), 0);
}

/// Both posts of a gap as wide as the disc are grazed at once.
#[test]
fn of_two_posts() {
    let scene = lasting("10")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .disc(Disc::at([4, 2], 1).infinite_mass())
        .disc(Disc::at([4, -2], 1).infinite_mass());
    assert_grazes(&exactly(&scene.build().unwrap()), 2);
}

/// A disc flies past a wall's end point at the distance of its radius.
#[test]
fn of_a_wall_end() {
    for (from, to) in [([4, 1], [4, 5]), ([4, 5], [4, 1])] {
        let scene = lasting("10")
            .disc(Disc::at([0, 0], 1).velocity([1, 0]))
            .wall(from, to);
        assert_grazes(&exactly(&scene.build().unwrap()), 1);
    }
}

/// A gap between two walls that is as wide as the disc.
#[test]
fn of_a_gap_in_a_wall() {
    let scene = lasting("10")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .wall([4, 1], [4, 5])
        .wall([4, -1], [4, -5]);
    assert_grazes(&exactly(&scene.build().unwrap()), 2);
}

/// Two walls that meet in a point are grazed there once.
#[test]
fn of_a_corner() {
    let scene = lasting("10")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .wall([4, 1], [2, 5])
        .wall([6, 5], [4, 1]);
    assert_grazes(&exactly(&scene.build().unwrap()), 1);
}

/// A disc that has grazed another one still meets what is behind it, and
/// grazes it again on its way back.
#[test]
fn are_passed_on_the_way_back_too() {
    let scene = lasting("20")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .disc(Disc::at([5, 2], 1))
        .wall([10, -1], [10, 1]);
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("9", "d0 w0")]);
    assert_eq!(outcome.grazes, 2);
    assert_end(&outcome, &[["-2", "0", "-1", "0"], ["5", "2", "0", "0"]]);
}
