//! Impacts that lose energy.

use carom::run::Outcome;
use carom::scalar::{Exact, Number};
use carom::scene::{Disc, Restitution};

use crate::common::agree::{assert_end, assert_log};
use crate::common::{exactly, lasting};

fn number(text: &str) -> Number {
    text.parse().unwrap()
}

fn newton(discs: &str, walls: Option<&str>, elastic_below: Option<&str>) -> Restitution {
    Restitution::Newton {
        coefficient: number(discs),
        walls: walls.map(number),
        elastic_below: elastic_below.map(number),
    }
}

/// A disc that runs into an equal one at rest, 2 away: the impact is at
/// 2 / `speed`.
fn push(speed: &str, restitution: Restitution) -> Outcome<Exact> {
    let scene = lasting("2")
        .disc(Disc::at([0, 0], 1).velocity([speed, "0"]))
        .disc(Disc::at([4, 0], 1))
        .restitution(restitution);
    exactly(&scene.build().unwrap())
}

/// A disc that falls on a wall obliquely and touches it at 1.
fn fall(restitution: Restitution) -> Outcome<Exact> {
    let scene = lasting("2")
        .disc(Disc::at([0, 3], 1).velocity([1, -2]))
        .wall([-9, 0], [9, 0])
        .restitution(restitution);
    exactly(&scene.build().unwrap())
}

/// From v the first disc keeps (1 - e)/2 and the second one gets (1 + e)/2:
/// together v, and apart at e v. The impact is at 1/2, at 2 and 4.
#[test]
fn newtons_coefficient() {
    for (e, first, second) in [
        ("0", ["5", "0", "2", "0"], ["7", "0", "2", "0"]),
        ("1/2", ["7/2", "0", "1", "0"], ["17/2", "0", "3", "0"]),
        ("1", ["2", "0", "0", "0"], ["10", "0", "4", "0"]),
    ] {
        let outcome = push("4", newton(e, None, None));
        assert_log(&outcome, &[("1/2", "d0 d1")]);
        assert_end(&outcome, &[first, second]);
    }
}

/// Masses of 1 and 3: the centre of mass goes on at v/4, and the relative
/// velocity is halved and turned: v/4 - 3/4 v/2 and v/4 + 1/4 v/2.
#[test]
fn newtons_coefficient_with_unequal_masses() {
    let scene = lasting("1/2")
        .disc(Disc::at([0, 0], 1).velocity([8, 0]))
        .disc(Disc::at([6, 0], 1).mass(3))
        .restitution(newton("1/2", None, None));
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("1/2", "d0 d1")]);
    assert_end(&outcome, &[["4", "0", "-1", "0"], ["6", "0", "3", "0"]]);
}

/// Relative to a piston of 1, a disc at rest leaves with e: at 1 + e.
#[test]
fn newtons_coefficient_with_a_piston() {
    let scene = lasting("3")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]).infinite_mass())
        .disc(Disc::at([5, 0], 1))
        .restitution(newton("1/2", None, None));
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("3", "d0 d1")]);
    assert_end(&outcome, &[["3", "0", "1", "0"], ["5", "0", "3/2", "0"]]);
}

/// The velocity along the wall is kept.
#[test]
fn walls_have_their_own_coefficient() {
    for (restitution, height, speed) in [
        (newton("1/2", None, None), "2", "1"),
        (newton("1", Some("1/2"), None), "2", "1"),
        (newton("1/2", Some("1"), None), "3", "2"),
        (newton("1", Some("0"), None), "1", "0"),
    ] {
        let outcome = fall(restitution);
        assert_log(&outcome, &[("1", "d0 w0")]);
        assert_end(&outcome, &[["2", height, "1", speed]]);
    }
    let discs = push("4", newton("1/2", Some("1"), None));
    assert_end(&discs, &[["7/2", "0", "1", "0"], ["17/2", "0", "3", "0"]]);
}

/// Below 3 nothing is lost; 3 itself is not below.
#[test]
fn slow_impacts_are_elastic() {
    let slow = || newton("1/2", None, Some("3"));
    let outcome = push("2", slow());
    assert_end(&outcome, &[["2", "0", "0", "0"], ["6", "0", "2", "0"]]);
    let outcome = push("3", slow());
    assert_end(&outcome, &[["3", "0", "3/4", "0"], ["7", "0", "9/4", "0"]]);
    let outcome = push("4", slow());
    assert_end(&outcome, &[["7/2", "0", "1", "0"], ["17/2", "0", "3", "0"]]);
}

/// It is the normal speed that counts: 2 of a fall at (1, -2), of which the
/// speed is √5.
#[test]
fn slow_is_meant_along_the_normal() {
    let end = |elastic_below| fall(newton("0", None, Some(elastic_below)));
    assert_end(&end("2"), &[["2", "1", "1", "0"]]);
    assert_end(&end("2.1"), &[["2", "3", "1", "2"]]);
}

/// A normal of length 2: the closing speed is 4 although v·n is 8.
#[test]
fn slow_is_meant_along_the_unit_normal() {
    let outcome = push("4", newton("0", None, Some("5")));
    assert_end(&outcome, &[["2", "0", "0", "0"], ["10", "0", "4", "0"]]);
}

/// After the elastic response both whole velocities are multiplied by 1 - C.
#[test]
fn the_papers_coefficient() {
    for (loss, first, second) in [
        ("0", ["2", "0", "0", "0"], ["10", "0", "4", "0"]),
        ("1/4", ["2", "0", "0", "0"], ["17/2", "0", "3", "0"]),
        ("1", ["2", "0", "0", "0"], ["4", "0", "0", "0"]),
    ] {
        let outcome = push("4", Restitution::paper(number(loss)));
        assert_log(&outcome, &[("1/2", "d0 d1")]);
        assert_end(&outcome, &[first, second]);
    }
}

/// Unlike Newton's it slows the motion along the wall, too.
#[test]
fn the_papers_coefficient_at_a_wall() {
    let outcome = fall(Restitution::paper(number("1/2")));
    assert_log(&outcome, &[("1", "d0 w0")]);
    assert_end(&outcome, &[["3/2", "2", "1/2", "1"]]);
}

/// A ball that stops on a wall stays: no impact follows, for nothing moves it.
#[test]
fn a_perfectly_inelastic_fall_ends() {
    let scene = lasting("100")
        .disc(Disc::at([0, 3], 1).velocity([0, -2]))
        .wall([-9, 0], [9, 0])
        .restitution(newton("0", None, None));
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("1", "d0 w0")]);
    assert_end(&outcome, &[["0", "1", "0", "0"]]);
}

/// d0 touches the wall at 1, above 2, slides on at a speed of 1 and is past the
/// wall's end at 3. At 9, above 10, d1 comes down upon it: below is no wall.
#[test]
fn a_disc_that_slides_past_the_end_of_a_wall_leaves_it() {
    let scene = lasting("20")
        .disc(Disc::at([1, 2], 1).velocity([1, -1]))
        .disc(Disc::at([10, 12], 1).velocity([0, -1]))
        .wall([0, 0], [4, 0])
        .restitution(newton("1", Some("0"), None));
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("1", "d0 w0"), ("9", "d0 d1")]);
    assert_end(&outcome, &[["21", "-10", "1", "-1"], ["10", "3", "0", "0"]]);
}
