//! Linear drag: with k = 1 a disc of speed v gets v (1 - e^-t) far.

use carom::run::Outcome;
use carom::scalar::{Exact, Filtered, Scalar};
use carom::scene::{Disc, Restitution, Scene};
use carom::simulation::Algorithm;
use num_rational::BigRational;

use crate::common::{complete, exactly, in_binary64, lasting, names, ratio};

fn towards_a_wall(velocity: &str, distance: &str) -> Scene {
    lasting("50")
        .linear_drag(1)
        .disc(Disc::at([0, 0], 1).velocity([velocity, "0"]))
        .wall([distance, "-9"], [distance, "9"])
        .build()
        .unwrap()
}

/// Bounds of ln 2 from 2 artanh 1/3, of which the terms fall by more than a
/// factor of nine.
fn ln_two() -> [BigRational; 2] {
    let (mut sum, mut power) = (ratio("0"), ratio("2/3"));
    for odd in (1..130).step_by(2) {
        sum += &power / BigRational::from_integer(odd.into());
        power /= ratio("9");
    }
    [sum.clone(), sum + power]
}

/// Half of the way that 2 gets it: 1 - e^-t = 1/2.
#[test]
fn onto_a_wall_at_the_logarithm_of_two() {
    let scene = towards_a_wall("2", "2");
    let outcome = exactly(&scene);
    assert_eq!(names(&outcome.impacts), ["d0 w0"]);
    let (lo, hi) = outcome.impacts[0].time.enclosure().unwrap();
    let [low, high] = ln_two();
    assert!(lo <= high && low <= hi && hi - lo < ratio("1e-20"));
    for time in [
        in_binary64(&scene).impacts[0].time,
        complete::<Filtered>(&scene, Algorithm::Timeline).impacts[0]
            .time
            .get(),
    ] {
        assert_eq!(time, std::f64::consts::LN_2);
    }
}

/// Of speed v it gets no further than v. A wall there, or 2^-100 beyond, it never
/// meets; one that is 2^-100 nearer it does, at 100 ln 2, but for the run's end at 50.
#[test]
fn a_wall_that_is_never_reached() {
    let short = "1267650600228229401496703205375/1267650600228229401496703205376";
    let beyond = "1267650600228229401496703205377/1267650600228229401496703205376";
    let cases = [
        (beyond, 50, 0),
        ("1", 50, 0),
        (short, 50, 0),
        (short, 80, 1),
    ];
    for (distance, duration, impacts) in cases {
        let scene = lasting(&duration.to_string())
            .linear_drag(1)
            .disc(Disc::at([-1, 0], 1).velocity([1, 0]))
            .wall([distance, "-9"], [distance, "9"]);
        let outcome = exactly(&scene.build().unwrap());
        assert_eq!(outcome.impacts.len(), impacts, "{distance} {duration}");
        for impact in &outcome.impacts {
            let expected = 100.0 * std::f64::consts::LN_2;
            assert!((impact.time.to_f64() - expected).abs() < 1e-12);
        }
    }
}

/// Where numbers round, neither: 1 - e^-50 is 1 to the nearest, but warped time
/// stays below. What is half as far is met, at ln 2.
#[test]
fn a_wall_that_rounding_does_not_reach_either() {
    for (distance, impacts) in [("2", 0), ("3/2", 1)] {
        let scene = towards_a_wall("1", distance);
        let rounded = in_binary64(&scene).impacts;
        assert_eq!(rounded.len(), impacts);
        let filtered = complete::<Filtered>(&scene, Algorithm::Timeline).impacts;
        assert_eq!(filtered.len(), impacts);
        for time in rounded.iter().map(|impact| impact.time) {
            assert_eq!(time, std::f64::consts::LN_2);
        }
    }
}

/// A gap of 1 closes at ln 2, at a speed of 1, of which 1/4 and 3/4 are left to
/// the discs: half of what they would have at the start.
#[test]
fn velocities_after_an_impact() {
    let scene = lasting("2")
        .linear_drag(1)
        .disc(Disc::at([0, 0], 1).velocity([2, 0]))
        .disc(Disc::at([3, 0], 1))
        .restitution(Restitution::newton("1/2".parse().unwrap()));
    let outcome: Outcome<Exact> = exactly(&scene.build().unwrap());
    let left = (-2_f64).exp();
    let speeds = outcome.end.iter().map(|disc| disc.velocity.x.to_f64());
    for (speed, expected) in speeds.zip([0.5 * left, 1.5 * left]) {
        assert!((speed - expected).abs() < 1e-15);
    }
    // Up to ln 2, and on with 1/2 and 3/2 for what is left of 1 - e^-2.
    let rest = (1.0 - left) - 0.5;
    let places = outcome.end.iter().map(|disc| disc.position.x.to_f64());
    for (place, expected) in places.zip([1.0 + 0.5 * rest, 3.0 + 1.5 * rest]) {
        assert!((place - expected).abs() < 1e-14);
    }
}
