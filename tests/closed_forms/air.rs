//! Discs that fall through air. With gravity (0, -1) and drag 1, what starts at
//! rest has fallen by t - 1 + e^-t, and tends to a speed of 1.

use carom::run::{Options, Outcome, Status};
use carom::scalar::{Exact, Scalar};
use carom::scene::{Disc, Restitution, SceneBuilder};
use carom::simulation::Algorithm;
use num_rational::BigRational;
use num_traits::One;

use crate::common::{attempt, exactly, in_binary64, lasting, names, ratio};

fn sinking(duration: &str) -> SceneBuilder {
    lasting(duration).gravity([0, -1]).linear_drag(1)
}

fn floor(scene: SceneBuilder) -> SceneBuilder {
    scene.wall([-9, 0], [9, 0])
}

/// Bounds of e^-x, for 0 ≤ x ≤ 8, by its series: the terms alternate, and fall
/// from the ninth one on.
fn exp_minus(x: &BigRational) -> [BigRational; 2] {
    let (mut term, mut sum) = (BigRational::one(), BigRational::one());
    for n in 1..=80 {
        term = -term * x / BigRational::from_integer(n.into());
        sum += &term;
    }
    let next = &sum - &term;
    [sum.clone().min(next.clone()), sum.max(next)]
}

/// Asserts that an increasing function, of a time and of e to the minus of that,
/// comes to zero within the bounds of a time, which are narrow.
#[track_caller]
fn assert_zero(time: &Exact, f: impl Fn(&BigRational, &BigRational) -> BigRational) {
    let (lo, hi) = time.enclosure().expect("bounds");
    assert!(&hi - &lo < ratio("1e-20"));
    let zero = ratio("0");
    assert!(exp_minus(&lo).iter().any(|power| f(&lo, power) <= zero));
    assert!(exp_minus(&hi).iter().any(|power| f(&hi, power) >= zero));
}

/// Asserts that a time is a known number.
#[track_caller]
fn assert_time(time: &Exact, expected: &str) {
    assert_zero(time, |t, _| t - ratio(expected));
}

/// Asserts the impacts, and that binary64 has them at the same times.
#[track_caller]
fn impacts(scene: SceneBuilder, expected: &[&str]) -> Outcome<Exact> {
    let scene = scene.build().unwrap();
    let (outcome, rounded) = (exactly(&scene), in_binary64(&scene));
    assert_eq!(names(&outcome.impacts), expected);
    assert_eq!(names(&rounded.impacts), expected);
    for (one, other) in outcome.impacts.iter().zip(&rounded.impacts) {
        assert!((one.time.to_f64() - other.time).abs() < 1e-13);
    }
    outcome
}

/// By 1: t + e^-t = 2.
#[test]
fn a_fall_onto_the_floor() {
    let scene = floor(sinking("2").disc(Disc::at([0, 2], 1)));
    let outcome = impacts(scene, &["d0 w0"]);
    assert_zero(&outcome.impacts[0].time, |t, e| t + e - ratio("2"));
}

/// Up with speed 1 from the floor: its way is 2 s - t, for s = 1 - e^-t. Down again
/// at 2 (1 - e^-t) = t.
#[test]
fn a_throw() {
    let thrown = Disc::at([0, 1], 1).velocity([0, 1]);
    let outcome = impacts(floor(sinking("2").disc(thrown)), &["d0 w0"]);
    let two = || ratio("2");
    assert_zero(&outcome.impacts[0].time, |t, e| t - two() + two() * e);
}

/// What starts with the speed that it tends to keeps it: 3 in 3.
#[test]
fn at_terminal_velocity() {
    let disc = Disc::at([0, 4], 1).velocity([0, -1]);
    let outcome = impacts(floor(sinking("7/2").disc(disc)), &["d0 w0"]);
    assert_time(&outcome.impacts[0].time, "3");
}

/// Gravity does not act upon what goes on along a vertical wall's normal: v = 2
/// gets it 1 far at ln 2, e^-t = 1/2, as without gravity; it never gets to 2.
#[test]
fn onto_upright_walls() {
    let wall = |x: &str| {
        let disc = Disc::at([0, 0], 1).velocity([2, 0]);
        sinking("40").disc(disc).wall([x, "-99"], [x, "9"])
    };
    let outcome = impacts(wall("2"), &["d0 w0"]);
    assert_zero(&outcome.impacts[0].time, |_, e| ratio("1/2") - e);
    impacts(wall("3"), &[]);
}

/// Two that fall are straight in relation to each other, in s: a gap of 1, at 2,
/// closes at ln 2. They are as high as each other all the time.
#[test]
fn two_that_fall() {
    let scene = sinking("1")
        .disc(Disc::at([0, 0], 1).velocity([2, 3]))
        .disc(Disc::at([3, 0], 1).velocity([0, 3]));
    let outcome = impacts(scene, &["d0 d1"]);
    assert_zero(&outcome.impacts[0].time, |_, e| ratio("1/2") - e);
    let [one, other] = [0, 1].map(|disc| outcome.end[disc].position.y.to_f64());
    assert!((one - other).abs() < 1e-15);
}

/// From a gap of 3 above a fixed disc of the same radius, past which it is by 6/5:
/// they touch where it is 8/5 higher, having fallen by 7/5.
#[test]
fn onto_a_fixed_disc() {
    let scene = sinking("5/2")
        .disc(Disc::at(["6/5", "3"], 1))
        .disc(Disc::at([0, 0], 1).infinite_mass());
    let outcome = impacts(scene, &["d0 d1"]);
    assert_zero(&outcome.impacts[0].time, |t, e| t - ratio("12/5") + e);
}

/// The same onto the upper end of an upright wall, past which it is by 3/5: where
/// it is 4/5 higher.
#[test]
fn onto_the_end_of_a_wall() {
    let scene = sinking("5/2")
        .disc(Disc::at(["3/5", "11/5"], 1))
        .wall([0, 0], [0, -2]);
    let outcome = impacts(scene, &["d0 w0 from"]);
    assert_zero(&outcome.impacts[0].time, |t, e| t - ratio("12/5") + e);
}

/// A piston is not slowed down. It closes a gap of 1 at 1 and gives the disc twice
/// its speed, which gets it 2 (1 - e^-t) far: there is the piston when that is t.
#[test]
fn a_piston_without_gravity() {
    let scene = lasting("3")
        .linear_drag(1)
        .disc(Disc::at([-3, 0], 1).velocity([1, 0]).infinite_mass())
        .disc(Disc::at([0, 0], 1));
    let outcome = impacts(scene, &["d0 d1", "d0 d1"]);
    assert_time(&outcome.impacts[0].time, "1");
    let later = outcome.impacts[1].time.clone() - &outcome.impacts[0].time;
    assert_zero(&later, |t, e| t - ratio("2") + ratio("2") * e);
}

/// A ball that stops, and one that is kept going by slow impacts that take nothing.
#[test]
fn losses() {
    let ball = || floor(sinking("9").disc(Disc::at([0, 2], 1)));
    let newton = |below: Option<&str>| Restitution::Newton {
        coefficient: "1/2".parse().unwrap(),
        walls: None,
        elastic_below: below.map(|speed| speed.parse().unwrap()),
    };
    let scene = ball().restitution(newton(None)).build().unwrap();
    let stops: Outcome<Exact> = attempt(&scene, Algorithm::Timeline, &Options::default());
    let Status::Accumulation(found) = stops.status else {
        panic!("{:?}", stops.status)
    };
    let [low, high] = found.limit;
    assert!(low < high && ratio("2") < low && high < ratio("5"));
    let scene = ball().restitution(newton(Some("1/8"))).build().unwrap();
    let goes_on = in_binary64(&scene);
    assert_eq!(goes_on.status, Status::Complete);
    assert!(goes_on.impacts.len() > 20);
}
