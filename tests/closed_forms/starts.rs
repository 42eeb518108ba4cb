//! Bodies that touch or overlap at the start, and impacts at either end of
//! the simulated time.

use carom::run::Outcome;
use carom::scalar::Exact;
use carom::scene::Disc;

use crate::common::agree::{assert_end, assert_log};
use crate::common::{exactly, lasting};

/// Two discs of radius 1, so far apart on the x axis.
fn pair(distance: &str, velocities: [[i32; 2]; 2]) -> Outcome<Exact> {
    let scene = lasting("2")
        .disc(Disc::at([0, 0], 1).velocity(velocities[0]))
        .disc(Disc::at([distance, "0"], 1).velocity(velocities[1]));
    exactly(&scene.build().unwrap())
}

/// A disc of radius 1, so high above a wall.
fn above_wall(height: &str, velocity: [i32; 2]) -> Outcome<Exact> {
    let scene = lasting("2")
        .disc(Disc::at(["0", height], 1).velocity(velocity))
        .wall([-9, 0], [9, 0]);
    exactly(&scene.build().unwrap())
}

/// They collide where they are, as if they touched.
#[test]
fn overlap_that_grows_is_an_impact_at_once() {
    let outcome = pair("1", [[1, 0], [-1, 0]]);
    assert_log(&outcome, &[("0", "d0 d1")]);
    assert_eq!(outcome.overlaps, 1);
    assert_end(&outcome, &[["-2", "0", "-1", "0"], ["3", "0", "1", "0"]]);
    let outcome = above_wall("1/2", [3, -1]);
    assert_log(&outcome, &[("0", "d0 w0")]);
    assert_eq!(outcome.overlaps, 1);
    assert_end(&outcome, &[["6", "5/2", "3", "1"]]);
}

/// The impulse is along the line of centres (3, 4)/5 at its true length 1,
/// not at that of the radii: of (5, 0) the 3 along n go over.
#[test]
fn the_impulse_of_an_overlap_is_along_the_line_of_centres() {
    let scene = lasting("1")
        .disc(Disc::at([0, 0], 1).velocity([5, 0]))
        .disc(Disc::at(["3/5", "4/5"], 1));
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("0", "d0 d1")]);
    let first = ["16/5", "-12/5", "16/5", "-12/5"];
    assert_end(&outcome, &[first, ["12/5", "16/5", "9/5", "12/5"]]);
}

#[test]
fn overlap_that_shrinks_is_none() {
    let outcome = pair("1", [[-1, 0], [1, 0]]);
    assert_log(&outcome, &[]);
    assert_eq!(outcome.overlaps, 1);
    let outcome = above_wall("1/2", [0, 1]);
    assert_log(&outcome, &[]);
    assert_eq!(outcome.overlaps, 1);
}

/// There is no direction in which they could push each other.
#[test]
fn concentric_discs_do_not_collide() {
    for velocities in [[[1, 0], [-1, 0]], [[0, 0], [0, 0]], [[1, 2], [1, 2]]] {
        let outcome = pair("0", velocities);
        assert_log(&outcome, &[]);
        assert_eq!(outcome.overlaps, 1);
    }
}

#[test]
fn a_centre_on_a_wall_does_not_collide() {
    for velocity in [[0, 1], [0, -1], [1, 0], [9, -1], [0, 0]] {
        let outcome = above_wall("0", velocity);
        assert_log(&outcome, &[]);
        assert_eq!(outcome.overlaps, 1);
    }
}

/// Once they have parted they meet like any others: d0 leaves d1 at 2, turns
/// at the wall, and comes back to touch it.
#[test]
fn concentric_discs_meet_after_they_have_parted() {
    let scene = lasting("8")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .disc(Disc::at([0, 0], 1))
        .wall([5, -1], [5, 1]);
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("4", "d0 w0"), ("6", "d0 d1")]);
}

/// d0 leaves d1 at the very time, 2, at which a wall sends it back.
#[test]
fn concentric_discs_meet_as_soon_as_they_have_parted() {
    let scene = lasting("3")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .disc(Disc::at([0, 0], 1))
        .wall([3, -1], [3, 1]);
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("2", "d0 w0"), ("2", "d0 d1")]);
    assert_end(&outcome, &[["2", "0", "0", "0"], ["-1", "0", "-1", "0"]]);
}

/// A centre on one wall: the other one, which ends where that does, is an
/// obstacle all the same. The impact has the name of the lowest wall there.
#[test]
fn a_centre_on_a_wall_collides_with_the_next_wall() {
    let scene = lasting("2")
        .disc(Disc::at([0, -1], 2).velocity([0, 1]))
        .wall([0, 0], [0, -9])
        .wall([0, 0], [9, 0]);
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("0", "d0 w0 from")]);
    assert_end(&outcome, &[["0", "-3", "0", "-1"]]);
}

/// The disc overlaps the first wall and touches the end of the second one. The
/// first turns (2, -1) into (2, 1), which approaches that end: along the
/// normal (3, -4)/5 go 2/5, twice of which are taken.
#[test]
fn who_parts_from_an_overlapped_wall_may_meet_the_next_one() {
    let scene = lasting("1")
        .disc(Disc::at([-3, 4], 5).velocity([2, -1]))
        .wall([-9, 0], [0, 0])
        .wall([0, 0], [4, -3]);
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("0", "d0 w0"), ("0", "d0 w0 to")]);
    assert_end(&outcome, &[["-37/25", "141/25", "38/25", "41/25"]]);
}

/// The disc, of radius 3/2, overlaps the end of the first wall, (0, 0), and the
/// interior of the second one, and approaches both. That end comes first by
/// name: with the normal (-4, -3)/5 it turns (0, -1) into (24, -7)/25, which
/// approaches the second wall, and that turns it into (24, 7)/25.
#[test]
fn who_parts_from_an_overlapped_corner_may_meet_a_wall_there() {
    let scene = lasting("1")
        .disc(Disc::at(["4/5", "3/5"], "3/2").velocity([0, -1]))
        .wall([0, 0], [-4, -3])
        .wall([0, 0], [9, 0]);
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("0", "d0 w0 from"), ("0", "d0 w1")]);
    assert_end(&outcome, &[["44/25", "22/25", "24/25", "7/25"]]);
}

#[test]
fn touching_and_approaching_is_an_impact_at_once() {
    let outcome = pair("2", [[1, 0], [0, 0]]);
    assert_log(&outcome, &[("0", "d0 d1")]);
    assert_eq!(outcome.overlaps, 0);
    assert_end(&outcome, &[["0", "0", "0", "0"], ["4", "0", "1", "0"]]);
    let outcome = above_wall("1", [0, -1]);
    assert_log(&outcome, &[("0", "d0 w0")]);
    assert_eq!(outcome.overlaps, 0);
}

#[test]
fn touching_and_parting_or_sliding_is_none() {
    for velocities in [
        [[0, 0], [0, 0]],
        [[-1, 0], [0, 0]],
        [[0, 1], [0, -1]],
        [[1, 1], [1, 1]],
    ] {
        let outcome = pair("2", velocities);
        assert_log(&outcome, &[]);
        assert_eq!(outcome.overlaps, 0);
    }
    for velocity in [[0, 0], [0, 1], [9, 0], [-9, 0]] {
        let outcome = above_wall("1", velocity);
        assert_log(&outcome, &[]);
        assert_eq!(outcome.overlaps, 0);
    }
}

/// A disc that comes along a wall in contact with its line slides over its
/// end without an impact.
#[test]
fn sliding_onto_a_wall_is_none() {
    let scene = lasting("9")
        .disc(Disc::at([-5, 1], 1).velocity([1, 0]))
        .wall([0, 0], [3, 0]);
    assert_log(&exactly(&scene.build().unwrap()), &[]);
}

#[test]
fn co_moving_discs_never_meet() {
    assert_log(&pair("5/2", [[3, 1], [3, 1]]), &[]);
}

/// An impact at the very end belongs to the run, and the state is after it.
#[test]
fn the_end_belongs_to_the_run() {
    let outcome = above_wall("3", [1, -1]);
    assert_log(&outcome, &[("2", "d0 w0")]);
    assert_end(&outcome, &[["2", "1", "1", "1"]]);
    let outcome = pair("6", [[1, 0], [-1, 0]]);
    assert_log(&outcome, &[("2", "d0 d1")]);
    assert_end(&outcome, &[["2", "0", "-1", "0"], ["4", "0", "1", "0"]]);
}

#[test]
fn what_is_after_the_end_does_not() {
    let outcome = above_wall("0x3.0000000000000001p0", [0, -1]);
    assert_log(&outcome, &[]);
    let outcome = above_wall("0x2.ffffffffffffffffp0", [0, -1]);
    assert_eq!(outcome.impacts.len(), 1);
}

/// A disc bounces back into one that it still overlaps: they approach, so
/// they collide there and then.
#[test]
fn an_overlap_that_grows_anew_is_an_impact() {
    let scene = lasting("1")
        .disc(Disc::at([0, 0], 1))
        .disc(Disc::at([1, 0], 1).velocity([1, 0]))
        .wall(["5/2", "-1"], ["5/2", "1"]);
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("1/2", "d1 w0"), ("1/2", "d0 d1")]);
    assert_end(
        &outcome,
        &[["-1/2", "0", "-1", "0"], ["3/2", "0", "0", "0"]],
    );
}
