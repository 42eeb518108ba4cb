//! Scenes that are made: what they promise, checked exactly.

use carom::scalar::Number;
use carom::scene::generate::{MAX_POWER, cradle, galperin, gas, table1};
use carom::scene::{Disc, Mass, Scene};
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::{committed, committed_scenes, exact, number, point, ratio};

/// Whether the centres are nearer than the sum of the radii.
fn overlap(a: &Disc, b: &Disc) -> bool {
    let [ax, ay] = exact(&a.position);
    let [bx, by] = exact(&b.position);
    let [dx, dy] = [bx - ax, by - ay];
    let reach = a.radius.to_rational() + b.radius.to_rational();
    &dx * &dx + &dy * &dy < &reach * &reach
}

fn assert_apart(scene: &Scene) {
    for (index, disc) in scene.discs().iter().enumerate() {
        for other in &scene.discs()[..index] {
            assert!(!overlap(disc, other), "{}: {disc:?}, {other:?}", scene.id());
        }
    }
}

/// The box goes from the origin to its third corner.
fn assert_inside(scene: &Scene) {
    let corner = exact(&scene.walls()[2].from);
    for disc in scene.discs() {
        let radius = disc.radius.to_rational();
        for (place, side) in exact(&disc.position).iter().zip(&corner) {
            assert!(*place >= radius && place + &radius <= *side, "{disc:?}");
        }
    }
}

#[test]
fn the_committed_table_1_is_what_seed_42_gives() {
    for (name, scale) in [("table1-full", "1"), ("table1-third", "0.33")] {
        let scene = table1(42, &number(scale)).expect("a scene");
        let file = committed(&format!("{name}.json"));
        let text = std::fs::read_to_string(file).expect("the file");
        assert_eq!(scene.id(), name);
        assert!(scene.to_json() == text, "{name} is stale");
    }
}

#[test]
fn table_1_has_the_papers_discs() {
    let full = table1(7, &number(1)).expect("a scene");
    let third = table1(7, &number("33/100")).expect("a scene");
    for (scene, radius) in [(&full, ratio(15, 1)), (&third, ratio(99, 20))] {
        assert_eq!(scene.discs().len(), 150);
        assert_eq!(scene.walls().len(), 4);
        assert_eq!(scene.frame().total(), ratio(10, 1));
        assert_eq!(scene.discs()[149].radius.to_rational(), radius);
        assert_apart(scene);
        assert_inside(scene);
    }
    let paths = |scene: &Scene| -> Vec<_> {
        let discs = scene.discs().iter();
        discs
            .map(|disc| (disc.position.clone(), disc.velocity.clone()))
            .collect()
    };
    assert_eq!(paths(&full), paths(&third));
    let limit = ratio(90_000, 1);
    for disc in full.discs() {
        let [x, y] = exact(&disc.velocity);
        assert!(&x * &x + &y * &y <= limit);
    }
    assert_ne!(full, table1(8, &number(1)).expect("a scene"));
}

#[test]
fn a_gas_starts_apart_and_inside() {
    for (count, packing) in [(1, 0.7), (2, 0.05), (100, 0.78), (90, 0.5), (64, 1e-9)] {
        let scene = gas(3, count, packing).expect("a scene");
        assert_eq!(scene.discs().len(), count as usize);
        assert_apart(&scene);
        assert_inside(&scene);
        assert_eq!(scene, gas(3, count, packing).expect("a scene"));
    }
}

#[test]
fn a_gas_has_unit_variance() {
    let scene = gas(5, 1000, 0.1).expect("a scene");
    let parts: Vec<f64> = scene
        .discs()
        .iter()
        .flat_map(|disc| disc.velocity.iter().map(Number::to_f64))
        .collect();
    let count = parts.len() as f64;
    let mean = parts.iter().sum::<f64>() / count;
    let variance = parts.iter().map(|part| part * part).sum::<f64>() / count;
    // Four standard deviations: 4 / sqrt(2000) and 4 sqrt(2 / 2000).
    assert!(mean.abs() < 0.09, "{mean}");
    assert!((variance - 1.0).abs() < 0.13, "{variance}");
}

#[test]
fn a_gas_that_does_not_fit_is_refused() {
    for packing in [0.0, -0.5, 0.79, f64::NAN, f64::INFINITY] {
        let error = gas(1, 100, packing).expect_err("no gas");
        assert_eq!(error.place(), Some("packing"));
    }
    assert_eq!(gas(1, 0, 0.5).expect_err("no gas").place(), Some("count"));
}

/// The digits of π, counted on a line without any of the library's detection:
/// `wall` and `between` are the free distances before the light disc and
/// behind it.
fn impacts_on_a_line(mass: BigRational) -> (usize, BigRational) {
    let [one, two] = [ratio(1, 1), ratio(2, 1)];
    let [mut wall, mut between] = [one.clone(), one.clone()];
    let [mut light, mut heavy] = [BigRational::zero(), -one.clone()];
    let (mut count, mut time) = (0, BigRational::zero());
    loop {
        let closing = &light - &heavy;
        let to_wall = light.is_negative().then(|| -&wall / &light);
        let to_heavy = closing.is_positive().then(|| &between / &closing);
        let (wait, hits_wall) = match (to_wall, to_heavy) {
            (None, None) => return (count, time),
            (Some(wait), None) => (wait, true),
            (None, Some(wait)) => (wait, false),
            (Some(a), Some(b)) if a < b => (a, true),
            (Some(_), Some(b)) => (b, false),
        };
        wall += &light * &wait;
        between -= &closing * &wait;
        time += wait;
        count += 1;
        if hits_wall {
            light = -light;
        } else {
            let push = &two * &closing / (&one + &mass);
            light -= &push * &mass;
            heavy += push;
        }
    }
}

#[test]
fn galperins_discs_have_time_for_every_digit() {
    for (power, expected) in [(0, 3), (1, 31), (2, 314)] {
        let scene = galperin(power).expect("a scene");
        let Mass::Finite(mass) = &scene.discs()[1].mass else {
            panic!("a finite mass");
        };
        let (count, last) = impacts_on_a_line(mass.to_rational());
        assert_eq!(count, expected);
        assert!(last < scene.frame().total(), "{last}");
        assert_apart(&scene);
    }
    assert!(galperin(MAX_POWER).is_ok());
    let error = galperin(MAX_POWER + 1).expect_err("too many digits");
    assert_eq!(error.place(), Some("power"));
}

#[test]
fn a_cradle_touches_or_keeps_its_gap() {
    let touching = cradle(5, 1, &number(0)).expect("a scene");
    let places = ["-10", "0", "2", "4", "6"];
    for (disc, x) in touching.discs().iter().zip(places) {
        assert_eq!(exact(&disc.position), point(x, "0"));
    }
    assert_eq!(touching.frame().total(), ratio(16, 1));
    let apart = cradle(5, 2, &number("1/4")).expect("a scene");
    let places = ["-49/4", "-10", "0", "9/4", "9/2"];
    let speeds = ["1", "1", "0", "0", "0"];
    for ((disc, x), speed) in apart.discs().iter().zip(places).zip(speeds) {
        assert_eq!(exact(&disc.position), point(x, "0"));
        assert_eq!(exact(&disc.velocity), point(speed, "0"));
    }
    assert_eq!(apart.frame().total(), ratio(37, 2));
    assert_apart(&touching);
    assert_apart(&apart);
}

#[test]
fn a_cradle_without_a_disc_to_strike_is_refused() {
    for (count, moving, gap, place) in [
        (5, 0, 0, "moving"),
        (5, 5, 0, "moving"),
        (0, 1, 0, "moving"),
        (5, 1, -1, "gap"),
    ] {
        let error = cradle(count, moving, &number(gap)).expect_err(place);
        assert_eq!(error.place(), Some(place));
    }
}

#[test]
fn every_committed_scene_but_one_starts_apart() {
    for path in committed_scenes() {
        let scene = Scene::read(path).expect("a scene");
        if scene.id() != "figure-6-still-still" {
            assert_apart(&scene);
        }
    }
}
