//! Rows of discs: Newton's cradle, and the digits of π.

use std::f64::consts::PI;

use approx::assert_abs_diff_eq;
use carom::impact::Impact;
use carom::run::Outcome;
use carom::scalar::{Exact, Scalar};
use carom::scene::{Disc, Scene};

use crate::common::agree::{assert_end, assert_log, contains_zero};
use crate::common::{exactly, in_binary64, lasting, name, names, tolerance};

/// A row of discs of radius 1 on the x axis, the first few of which move.
fn row(places: &[&str], moving: usize) -> Outcome<Exact> {
    let discs = places.iter().enumerate().map(|(index, place)| {
        let speed = i32::from(index < moving);
        Disc::at([*place, "0"], 1).velocity([speed, 0])
    });
    exactly(&lasting("16").discs(discs).build().unwrap())
}

/// One comes in over a gap of 8, one leaves: the impulse passes through the
/// discs that touch pair by pair, at one time.
#[test]
fn touching_cradle() {
    let outcome = row(&["-10", "0", "2", "4", "6"], 1);
    let pairs = ["d0 d1", "d1 d2", "d2 d3", "d3 d4"];
    assert_log(&outcome, &pairs.map(|pair| ("8", pair)));
    assert!(outcome.impacts.iter().all(|impact| impact.tie == Some(0)));
    let still = |x| [x, "0", "0", "0"];
    let last = ["14", "0", "1", "0"];
    assert_end(
        &outcome,
        &[still("-2"), still("0"), still("2"), still("4"), last],
    );
}

/// Two come in, two leave. Of the touching pairs that approach, the one that
/// is named first collides: after d1 and d2 these are d0 d1 and d2 d3, and
/// so on.
#[test]
fn touching_cradle_with_two_moving() {
    let outcome = row(&["-12", "-10", "0", "2", "4"], 2);
    let pairs = ["d1 d2", "d0 d1", "d2 d3", "d1 d2", "d3 d4", "d2 d3"];
    assert_log(&outcome, &pairs.map(|pair| ("8", pair)));
    assert!(outcome.impacts.iter().all(|impact| impact.tie == Some(0)));
    let speeds = outcome.end.iter().map(|disc| disc.velocity.x.to_f64());
    assert_eq!(speeds.collect::<Vec<_>>(), [0.0, 0.0, 0.0, 1.0, 1.0]);
}

/// With gaps of 1/4 each impact is 1/4 after the one before, and none is tied.
#[test]
fn cradle_with_gaps() {
    let outcome = row(&["-10", "0", "9/4", "9/2", "27/4"], 1);
    let expected = [
        ("8", "d0 d1"),
        ("33/4", "d1 d2"),
        ("17/2", "d2 d3"),
        ("35/4", "d3 d4"),
    ];
    assert_log(&outcome, &expected);
    assert!(outcome.impacts.iter().all(|impact| impact.tie.is_none()));
}

/// Gaps of 2^-40 are gaps: the times differ by as much.
#[test]
fn cradle_with_tiny_gaps() {
    let outcome = row(&["-10", "0", "0x2.0000000001p0", "0x4.0000000002p0"], 1);
    let expected = [
        ("8", "d0 d1"),
        ("0x8.0000000001p0", "d1 d2"),
        ("0x8.0000000002p0", "d2 d3"),
    ];
    assert_log(&outcome, &expected);
    assert!(outcome.impacts.iter().all(|impact| impact.tie.is_none()));
}

/// From both sides at once onto one in the middle. The first pair's impulse
/// meets the third disc, which comes at the same time: in the end the outer
/// two have changed their velocities and the middle one stays.
#[test]
fn from_both_sides() {
    let scene = lasting("4")
        .disc(Disc::at([-4, 0], 1).velocity([1, 0]))
        .disc(Disc::at([0, 0], 1))
        .disc(Disc::at([4, 0], 1).velocity([-1, 0]));
    let outcome = exactly(&scene.build().unwrap());
    let pairs = ["d0 d1", "d1 d2", "d0 d1"];
    assert_log(&outcome, &pairs.map(|pair| ("2", pair)));
    let [first, last] = [["-4", "0", "-1", "0"], ["4", "0", "1", "0"]];
    assert_end(&outcome, &[first, ["0", "0", "0", "0"], last]);
}

/// Ties without a shared disc stand by name, and each instant has its number.
#[test]
fn ties_of_several_pairs() {
    let column = |y: i32| {
        [
            Disc::at([0, y], 1).velocity([1, 0]),
            Disc::at([3, y], 1),
            Disc::at([7, y], 1),
        ]
    };
    let scene = lasting("5").discs(column(0)).discs(column(9));
    let outcome = exactly(&scene.build().unwrap());
    let expected = [
        ("1", "d0 d1"),
        ("1", "d3 d4"),
        ("3", "d1 d2"),
        ("3", "d4 d5"),
    ];
    assert_log(&outcome, &expected);
    let ties = outcome.impacts.iter().map(|impact| impact.tie);
    assert_eq!(
        ties.collect::<Vec<_>>(),
        [Some(0), Some(0), Some(1), Some(1)]
    );
}

/// A light disc at rest between a wall and one of 100^power times its mass:
/// floor(π 10^power) impacts (G. Galperin: Playing pool with π, 2003).
fn galperin(power: u32) -> Scene {
    let mass = 100_i64.pow(power);
    let scene = lasting("15")
        .disc(Disc::at([2, 0], 1))
        .disc(Disc::at([5, 0], 1).velocity([-1, 0]).mass(mass))
        .wall([0, -1], [0, 1]);
    scene.build().unwrap()
}

/// Equal masses change places: d1 stops at 4 and lets d0 go to the wall and
/// back.
#[test]
fn three_impacts() {
    let outcome = exactly(&galperin(0));
    assert_log(&outcome, &[("1", "d0 d1"), ("2", "d0 w0"), ("3", "d0 d1")]);
    assert_end(&outcome, &[["2", "0", "0", "0"], ["16", "0", "1", "0"]]);
}

#[test]
fn the_digits_of_pi() {
    for power in 1..=3 {
        let outcome = exactly(&galperin(power));
        let digits = (PI * 10_f64.powi(power as i32)) as usize;
        assert_eq!(outcome.impacts.len(), digits);
        assert_turns(&outcome.impacts, 100_f64.powi(power as i32));
        assert_energy_is_kept(&outcome, power);
        assert_eq!(in_binary64(&galperin(power)).impacts.len(), digits);
    }
}

/// In the coordinates (√M V, √m v) each impact of the discs and the wall's
/// reversal together turn the velocity by twice α = arctan √(m/M). So the
/// k-th impact of the discs leaves the heavy one with -cos 2kα.
fn assert_turns(impacts: &[Impact<Exact>], mass: f64) {
    let angle = 2.0 * (1.0 / mass.sqrt()).atan();
    let discs = impacts.iter().filter(|impact| name(impact) == "d0 d1");
    for (impact, turns) in discs.zip(1..) {
        let velocity = impact
            .contact
            .as_ref()
            .unwrap()
            .other_velocity
            .as_ref()
            .unwrap()
            .x
            .to_f64();
        let expected = -(angle * f64::from(turns)).cos();
        assert_abs_diff_eq!(velocity, expected, epsilon = tolerance::SHORT_RUN);
    }
}

/// m v² + M V² is M in the end as at the start, as far as the enclosures tell.
fn assert_energy_is_kept(outcome: &Outcome<Exact>, power: u32) {
    let mass = Exact::from_integer(100_i32.pow(power));
    let [light, heavy] = [0, 1].map(|disc| outcome.end[disc].velocity.x.square());
    assert!(contains_zero(&(light + heavy * &mass - &mass)));
}

/// The order of the impacts alternates between discs and wall.
#[test]
fn discs_and_wall_take_turns() {
    let found = names(&exactly(&galperin(1)).impacts);
    let expected = (0..31).map(|index| if index % 2 == 0 { "d0 d1" } else { "d0 w0" });
    assert!(found.iter().map(String::as_str).eq(expected));
}
