//! Scenes that are made: what they promise, checked exactly.

use carom::scalar::Number;
use carom::scene::generate::{
    MAX_POWER, MAX_ROWS, Rack, break_shot, corner, cradle, galperin, gas, mirror, ring, table1,
    transformed,
};
use carom::scene::{Disc, Mass, Scene};
use carom::symmetry::symmetries;
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

pub(super) fn assert_apart(scene: &Scene) {
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

/// Whether a scene has the disc that `image` makes of each of its own.
fn maps_onto_itself(scene: &Scene, image: impl Fn([BigRational; 2]) -> [BigRational; 2]) -> bool {
    let paths = |disc: &Disc| [exact(&disc.position), exact(&disc.velocity)];
    let all: Vec<_> = scene.discs().iter().map(paths).collect();
    all.iter()
        .all(|path| all.contains(&path.clone().map(&image)))
}

/// The square of the distance of two discs.
fn distance_squared(a: &Disc, b: &Disc) -> BigRational {
    let [ax, ay] = exact(&a.position);
    let [bx, by] = exact(&b.position);
    let [dx, dy] = [bx - ax, by - ay];
    &dx * &dx + &dy * &dy
}

#[test]
fn a_break_is_its_own_mirror_image() {
    let racks = ["0", "1/10", "3"].map(|gap| Rack::Gap(number(gap)));
    for rack in racks.into_iter().chain([Rack::Touching]) {
        let scene = break_shot(5, &rack).expect("a scene");
        assert_eq!(scene.discs().len(), 16);
        assert_apart(&scene);
        assert!(maps_onto_itself(&scene, |[x, y]| [x, -y]), "{rack:?}");
        assert_eq!(exact(&scene.discs()[1].position), point("0", "0"));
    }
    // The first disc of the third row and its neighbours.
    let apart = break_shot(3, &Rack::Gap(number("1/2"))).expect("a scene");
    let [tip, second, third, last] = [1, 2, 4, 5].map(|index| &apart.discs()[index]);
    assert_eq!(exact(&third.position), point("35/8", "-5/2"));
    assert_eq!(distance_squared(third, last), ratio(25, 4));
    // 65/16 of the square of 5/4.
    assert_eq!(distance_squared(second, third), ratio(1625, 256));
    assert_eq!(distance_squared(tip, second), ratio(1625, 256));
    let touching = break_shot(3, &Rack::Touching).expect("a scene");
    let [tip, second, third, last] = [1, 2, 4, 5].map(|index| &touching.discs()[index]);
    assert_eq!(distance_squared(third, last), ratio(144, 25));
    for (a, b) in [(tip, second), (second, third), (second, last)] {
        assert_eq!(distance_squared(a, b), ratio(4, 1));
    }
}

#[test]
fn a_break_without_a_rack_is_refused() {
    for (rows, gap, place) in [
        (0, "1", "rows"),
        (MAX_ROWS + 1, "1", "rows"),
        (5, "-1", "gap"),
    ] {
        let error = break_shot(rows, &Rack::Gap(number(gap))).expect_err(place);
        assert_eq!(error.place(), Some(place));
    }
}

#[test]
fn a_ring_has_the_symmetries_of_the_square() {
    for count in [4, 8, 12, 16, 20, 40, 100, 104] {
        let scene = ring(count).expect("a scene");
        assert_eq!(scene.discs().len(), count as usize);
        assert_apart(&scene);
        assert!(maps_onto_itself(&scene, |[x, y]| [-y, x]));
        assert!(maps_onto_itself(&scene, |[x, y]| [x, -y]));
        let scale = ratio(count.into(), 1);
        for disc in scene.discs() {
            let [x, y] = exact(&disc.position);
            assert_eq!(&x * &x + &y * &y, &scale * &scale);
            assert_eq!(exact(&disc.velocity), [-x / &scale, -y / &scale]);
        }
    }
    for count in [0, 1, 6, 42] {
        assert_eq!(ring(count).expect_err("no ring").place(), Some("count"));
    }
}

#[test]
fn a_mirrored_gas_is_its_own_image() {
    let scene = mirror(3, 20, 0.5).expect("a scene");
    let half = gas(3, 20, 0.5).expect("a scene");
    assert_eq!(scene.discs()[..20], *half.discs());
    assert_apart(&scene);
    assert!(maps_onto_itself(&scene, |[x, y]| [-x, y]));
    for (disc, image) in scene.discs().iter().zip(&scene.discs()[20..]) {
        let [x, y] = exact(&disc.position);
        assert_eq!(exact(&image.position), [-x, y]);
    }
    let [side, height] = exact(&half.walls()[2].from);
    let [left, right] = [&scene.walls()[0].from, &scene.walls()[2].from].map(exact);
    assert_eq!(left, [-&side, BigRational::zero()]);
    assert_eq!(right, [side, height]);
}

/// After so much time, the disc touches both walls.
#[test]
fn a_disc_meets_both_walls_of_a_corner() {
    for wedge in [
        ["0", "1"],
        ["3/5", "4/5"],
        ["-4/5", "3/5"],
        ["-20/29", "21/29"],
    ] {
        let scene = corner(&wedge.map(number)).expect("a scene");
        let [disc] = scene.discs() else {
            panic!("one disc");
        };
        let [x, y] = exact(&disc.position);
        let [vx, vy] = exact(&disc.velocity);
        let centre = [x + vx, y + vy];
        for wall in scene.walls() {
            assert_eq!(exact(&wall.from), point("0", "0"));
            let [ex, ey] = exact(&wall.to);
            let length_squared = &ex * &ex + &ey * &ey;
            let area = &centre[0] * &ey - &centre[1] * &ex;
            assert_eq!(&area * &area, length_squared, "a radius away");
            let along = &centre[0] * &ex + &centre[1] * &ey;
            assert!(
                along.is_positive() && along < length_squared,
                "within the wall"
            );
        }
        let ends = scene.walls().iter().map(|wall| exact(&wall.to));
        let lengths: Vec<_> = ends.map(|[x, y]| &x * &x + &y * &y).collect();
        assert_eq!(lengths[0], lengths[1]);
    }
    for wedge in [["0", "-1"], ["1", "0"], ["1/2", "1/2"]] {
        let error = corner(&wedge.map(number)).expect_err("no wedge");
        assert_eq!(error.place(), Some("wedge"));
    }
}

#[test]
fn symmetric_scenes_have_their_symmetries_everywhere() {
    let table = [
        (break_shot(5, &Rack::Gap(number("1/10"))), 1),
        (break_shot(5, &Rack::Touching), 1),
        (ring(4), 7),
        (ring(20), 7),
        (mirror(3, 20, 0.5), 1),
        (corner(&["3/5", "4/5"].map(number)), 1),
        (gas(3, 20, 0.5), 0),
    ];
    for (scene, expected) in table {
        let scene = scene.expect("a scene");
        let moved = transformed(
            &scene,
            &["-3/5", "4/5"].map(number),
            &["10/3", "1"].map(number),
        );
        let found = symmetries(&scene);
        assert_eq!(found.len(), expected, "{}", scene.id());
        assert_eq!(found, symmetries(&moved.expect("a scene")));
    }
}

#[test]
fn a_scene_elsewhere_is_the_same_scene() {
    let scene = Scene::builder("here")
        .disc(Disc::at([5, 10], 1).velocity(["1", "1/3"]).mass(7))
        .wall([0, 0], [0.5, -1.0])
        .gravity([0, -5])
        .build()
        .expect("a scene");
    let moved = transformed(
        &scene,
        &["3/5", "4/5"].map(number),
        &["10/3", "0"].map(number),
    );
    let moved = moved.expect("a scene");
    let disc = &moved.discs()[0];
    assert_eq!(exact(&disc.position), point("-5/3", "10"));
    assert_eq!(exact(&disc.velocity), point("1/3", "1"));
    assert_eq!(disc.mass, scene.discs()[0].mass);
    assert_eq!(exact(&moved.walls()[0].from), point("10/3", "0"));
    assert_eq!(exact(&moved.walls()[0].to), point("133/30", "-1/5"));
    assert_eq!(
        moved.effects().gravity.as_ref().map(exact),
        Some(point("4", "-3"))
    );
    let still = transformed(&scene, &[1, 0].map(number), &[0, 0].map(number));
    assert_eq!(still.expect("a scene"), scene, "as it was written");
    let error = transformed(&scene, &["3/5", "3/5"].map(number), &[0, 0].map(number));
    assert_eq!(error.expect_err("no turn").place(), Some("rotate"));
}

#[test]
fn a_cell_is_shifted_but_not_turned() {
    let scene = Scene::builder("cell").periodic([0, 0], [10, 10]).build();
    let scene = scene.expect("a scene");
    let moved = transformed(&scene, &[1, 0].map(number), &["1/3", "-1"].map(number));
    let cell = moved.expect("a scene").periodic().cloned().expect("a cell");
    assert_eq!(exact(&cell.from), point("1/3", "-1"));
    assert_eq!(exact(&cell.to), point("31/3", "9"));
    let error = transformed(&scene, &[0, 1].map(number), &[0, 0].map(number));
    assert_eq!(error.expect_err("no turn").place(), Some("rotate"));
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
