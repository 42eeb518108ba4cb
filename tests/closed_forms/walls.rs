//! A disc and walls.

use carom::run::Outcome;
use carom::scalar::Exact;
use carom::scene::Disc;

use crate::common::agree::{assert_end, assert_log, assert_surd, rational};
use crate::common::{exactly, lasting, names, ratio};

/// A gap of 4 closes at 2; what is normal to the wall is reversed. From below
/// it is the same, for walls have two sides.
#[test]
fn both_sides() {
    for side in [1, -1] {
        let scene = lasting("3")
            .disc(Disc::at([0, 5 * side], 1).velocity([1, -2 * side]))
            .wall([-9, 0], [9, 0]);
        let outcome = exactly(&scene.build().unwrap());
        assert_log(&outcome, &[("2", "d0 w0")]);
        let [height, speed] = [3 * side, 2 * side].map(|number| number.to_string());
        assert_end(&outcome, &[["3", &height, "1", &speed]]);
    }
}

/// The wall's normal is (4, -3)/5, so the centre (5, 0) is at 4 and closes
/// the 3 that are left at 4. Of (-5, 0), twice the -4 along the normal turn:
/// (-5, 0) + 8 (4, -3)/5 = (7, -24)/5.
#[test]
fn oblique_of_rational_length() {
    let scene = lasting("7/4")
        .disc(Disc::at([5, 0], 1).velocity([-5, 0]))
        .wall([0, 0], [6, 8]);
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("3/4", "d0 w0")]);
    assert_end(&outcome, &[["53/20", "-24/5", "7/5", "-24/5"]]);
}

/// The centre is 2√2 from the line x = y and closes 2√2 - 1 at √2: after
/// 2 - √2/2.
#[test]
fn oblique_of_irrational_length() {
    let scene = lasting("2")
        .disc(Disc::at([4, 0], 1).velocity([-1, 1]))
        .wall([0, 0], [4, 4]);
    let outcome = exactly(&scene.build().unwrap());
    assert_eq!(names(&outcome.impacts), ["d0 w0"]);
    assert_surd(&outcome.impacts[0].time, ["2", "-1/2"], "2");
    let end = &outcome.end[0];
    assert_eq!(rational(&end.velocity.x), ratio("1"));
    assert_eq!(rational(&end.velocity.y), ratio("-1"));
}

/// A disc of radius 5 meets the end point (10, 4) when it is 3 short of it:
/// the triangle 3-4-5. n = (3, 4)/5, and (1, 0) - 2 (3/5) n = (7, -24)/25.
/// The line of the wall's interior was crossed before, at 5.
#[test]
fn end_points() {
    for (from, to, end) in [([10, 4], [10, 20], "from"), ([10, 20], [10, 4], "to")] {
        let scene = lasting("8")
            .disc(Disc::at([0, 0], 5).velocity([1, 0]))
            .wall(from, to);
        let outcome = exactly(&scene.build().unwrap());
        assert_log(&outcome, &[("7", &format!("d0 w0 {end}"))]);
        assert_end(&outcome, &[["182/25", "-24/25", "7/25", "-24/25"]]);
    }
}

/// A wall that lies in the direction of motion is met at its near end.
#[test]
fn end_on() {
    let scene = lasting("5")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .wall([9, 0], [4, 0]);
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("3", "d0 w0 to")]);
    assert_end(&outcome, &[["1", "0", "-1", "0"]]);
}

/// The interior ends where the foot of the perpendicular is an end point:
/// that is logged, and the response is the same.
#[test]
fn foot_of_the_perpendicular_at_the_end() {
    for (x, name) in [(0, "d0 w0 from"), (5, "d0 w0 to"), (3, "d0 w0")] {
        let scene = lasting("3")
            .disc(Disc::at([x, 3], 1).velocity([0, -1]))
            .wall([0, 0], [5, 0]);
        let outcome = exactly(&scene.build().unwrap());
        assert_log(&outcome, &[("2", name)]);
        assert_end(&outcome, &[[&x.to_string(), "2", "0", "1"]]);
    }
}

fn against_a_point(ends: [[[&str; 2]; 2]; 2]) -> Outcome<Exact> {
    let [first, second] = ends;
    let scene = lasting("4")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .wall(first[0], first[1])
        .wall(second[0], second[1]);
    exactly(&scene.build().unwrap())
}

/// Two walls that meet in a point turned towards the disc: one impact, under
/// the name of the lower wall.
#[test]
fn coincident_end_points_are_one() {
    let (tip, up, down) = (["4", "0"], ["8", "4"], ["8", "-4"]);
    for (ends, name) in [
        ([[tip, up], [down, tip]], "d0 w0 from"),
        ([[up, tip], [tip, down]], "d0 w0 to"),
        ([[up, tip], [["4.0", "0"], down]], "d0 w0 to"),
    ] {
        let outcome = against_a_point(ends);
        assert_log(&outcome, &[("3", name)]);
        assert_end(&outcome, &[["2", "0", "-1", "0"]]);
    }
}

/// A point that lies on another wall without being its end is no end of it.
#[test]
fn a_wall_that_ends_on_another_one() {
    let scene = lasting("4")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .wall([4, -4], [4, 4])
        .wall([4, 0], [9, 0]);
    let outcome = exactly(&scene.build().unwrap());
    assert_eq!(names(&outcome.impacts), ["d0 w0"]);
    assert_end(&outcome, &[["2", "0", "-1", "0"]]);
}

/// Into the corner along the diagonal: both walls at once, the lower first.
#[test]
fn into_a_corner() {
    let scene = lasting("4")
        .disc(Disc::at([4, 4], 1).velocity([-1, -1]))
        .wall([0, 0], [9, 0])
        .wall([0, 0], [0, 9]);
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("3", "d0 w0"), ("3", "d0 w1")]);
    let ties = outcome.impacts.iter().map(|impact| impact.tie);
    assert_eq!(ties.collect::<Vec<_>>(), [Some(0), Some(0)]);
    assert_end(&outcome, &[["2", "2", "1", "1"]]);
}

/// In a channel 6 wide a disc of radius 1 goes to and fro every 4 / 2.
#[test]
fn to_and_fro() {
    let scene = lasting("9")
        .disc(Disc::at([1, 0], 1).velocity([2, 0]))
        .wall([-3, -1], [-3, 1])
        .wall([3, -1], [3, 1]);
    let outcome = exactly(&scene.build().unwrap());
    let times = outcome.impacts.iter().map(|impact| rational(&impact.time));
    let expected = ["1/2", "5/2", "9/2", "13/2", "17/2"].map(ratio);
    assert_eq!(times.collect::<Vec<_>>(), expected);
    let walls = ["d0 w1", "d0 w0", "d0 w1", "d0 w0", "d0 w1"];
    assert_eq!(names(&outcome.impacts), walls);
}

/// d1 comes along the line of the first wall, with its centre on it, and turns
/// at the end of the third one at 5/2, when it is at x = -7/2. From there on
/// it is at (t - 6, 3), and d0 at (-2, t - 1). They meet at a distance of 2 =
/// √2 |t - 4|, at 4 - √2, and exchange what they have along (-1, 1): (-1, 1)/2
/// and (1, -1)/2. So d0 goes on at (1, 0), along the wall below.
#[test]
fn the_end_of_one_wall_on_the_line_of_another() {
    let scene = lasting("5")
        .disc(Disc::at([-2, -1], "1/2").velocity([0, 1]))
        .disc(Disc::at([-1, 3], "3/2").velocity([-1, 0]))
        .wall([-5, -5], [3, -5])
        .wall([-5, 3], [3, 3])
        .wall([-5, 3], [-5, -5]);
    let outcome = exactly(&scene.build().unwrap());
    assert_eq!(names(&outcome.impacts), ["d1 w1 from", "d0 d1"]);
    assert_surd(&outcome.impacts[1].time, ["4", "-1"], "2");
}
