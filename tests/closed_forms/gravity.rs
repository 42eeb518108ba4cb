//! Discs that fall. Unless a test says otherwise, gravity is (0, -2), so that a
//! disc falls by t².

use carom::run::{Options, Outcome, Status};
use carom::scalar::{Exact, Filtered, Scalar};
use carom::scene::{Disc, Restitution, Scene, SceneBuilder};
use carom::simulation::Algorithm;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::common::agree::{assert_encloses, assert_end, assert_log, assert_surd};
use crate::common::{
    attempt, complete, exactly, in_binary64, lasting, name, names, numbers, ratio,
};

fn falling(duration: &str) -> SceneBuilder {
    lasting(duration).gravity([0, -2])
}

fn newton(coefficient: &str) -> Restitution {
    Restitution::newton(coefficient.parse().unwrap())
}

fn built(scene: SceneBuilder) -> Scene {
    scene.build().unwrap()
}

fn times(outcome: &Outcome<f64>) -> Vec<f64> {
    outcome.impacts.iter().map(|impact| impact.time).collect()
}

fn in_filtered(scene: &Scene) -> Outcome<Filtered> {
    complete(scene, Algorithm::Timeline)
}

/// Asserts what is logged in exact arithmetic, and so in filtered, for times that
/// are numbers of binary64.
#[track_caller]
fn assert_logs(scene: &Scene, expected: &[(&str, &str)]) {
    assert_log(&exactly(scene), expected);
    let found = in_filtered(scene);
    let found: Vec<_> = found
        .impacts
        .iter()
        .map(|impact| (impact.time.get(), name(impact)))
        .collect();
    let nearest = |time: &str| ratio(time).to_f64().unwrap();
    let expected: Vec<_> = expected
        .iter()
        .map(|(time, name)| (nearest(time), (*name).to_owned()))
        .collect();
    assert_eq!(found, expected);
}

/// It falls by 1 in 1, comes up as high in 1 again, and so on.
#[test]
fn an_elastic_ball_bounces_at_odd_times() {
    let scene = built(
        falling("6")
            .disc(Disc::at([0, 2], 1).velocity([1, 0]))
            .wall([-8, 0], [8, 0]),
    );
    let outcome = exactly(&scene);
    assert_logs(&scene, &[("1", "d0 w0"), ("3", "d0 w0"), ("5", "d0 w0")]);
    assert_end(&outcome, &[["6", "2", "1", "0"]]);
    assert_eq!(times(&in_binary64(&scene)), [1.0, 3.0, 5.0]);
}

/// With e = 1/2 a flight takes half as long as the one before: 1, then 1 + 1/2 +
/// 1/4 …, which is 3 altogether.
#[test]
fn a_lossy_ball_comes_to_rest_at_three() {
    let scene = built(
        falling("9")
            .disc(Disc::at([0, 2], 1))
            .wall([-8, 0], [8, 0])
            .restitution(newton("1/2")),
    );
    let outcome: Outcome<Exact> = attempt(&scene, Algorithm::Timeline, &Options::default());
    for (n, impact) in (1..).zip(&outcome.impacts) {
        let missing = BigRational::new(4.into(), num_bigint::BigInt::from(1) << n);
        assert_eq!(impact.time.enclosure().unwrap().0, ratio("3") - missing);
    }
    let Status::Accumulation(found) = &outcome.status else {
        panic!("{:?}", outcome.status);
    };
    assert!(found.proven);
    assert_eq!(found.limit, [ratio("3"), ratio("3")]);
    let rounded: Outcome<f64> = attempt(&scene, Algorithm::Timeline, &Options::default());
    let Status::Accumulation(found) = &rounded.status else {
        panic!("{:?}", rounded.status);
    };
    assert!(!found.proven);
    assert_eq!(found.limit_to_f64(), 3.0);
}

/// Relative to each other two falling discs do not: 4 - √3 is left at speed 1
/// when the second is 1 higher.
#[test]
fn two_discs_fall_alike() {
    let scene = built(
        lasting("6")
            .gravity([3, -7])
            .disc(Disc::at([0, 0], 1).velocity([1, 0]))
            .disc(Disc::at([5, 1], 1)),
    );
    let outcome = exactly(&scene);
    assert_eq!(names(&outcome.impacts), ["d0 d1"]);
    assert_surd(&outcome.impacts[0].time, ["5", "-1"], "3");
}

/// It touches at a height of √3 over the fixed disc, having fallen 4 - √3:
/// t² = 4 - √3, so (4 - t²)² = 3.
#[test]
fn onto_a_fixed_disc() {
    let scene = built(
        falling("2")
            .disc(Disc::at([1, 4], 1))
            .disc(Disc::at([0, 0], 1).infinite_mass()),
    );
    let outcome = exactly(&scene);
    assert_eq!(name(&outcome.impacts[0]), "d0 d1");
    let fallen = Exact::from_integer(4) - outcome.impacts[0].time.square();
    assert_surd(&fallen, ["0", "1"], "3");
    let time = in_binary64(&scene).impacts[0].time;
    assert!((time - (4.0 - 3_f64.sqrt()).sqrt()).abs() < 1e-15);
    // Before it touches (4 - t²)² is more than 3.
    let time = in_filtered(&scene).impacts[0].time.get();
    let middle = |other: f64| {
        let sum = [time, other].map(|number| BigRational::from_float(number).unwrap());
        sum.iter().sum::<BigRational>() / ratio("2")
    };
    let gap = |time: BigRational| (ratio("4") - &time * &time).pow(2) - ratio("3");
    assert!(gap(middle(time.next_down())) > ratio("0"));
    assert!(gap(middle(time.next_up())) < ratio("0"));
}

/// The end point is 3/5 aside: a disc of radius 1 touches it from 4/5 above,
/// having fallen 1 - 4/5 + 4/5 = 1.
#[test]
fn onto_the_end_of_a_wall() {
    let scene = built(
        falling("3/2")
            .disc(Disc::at(["-3/5", "9/5"], 1))
            .wall([0, 0], [5, 0]),
    );
    let outcome = exactly(&scene);
    assert_eq!(names(&outcome.impacts), ["d0 w0 from"]);
    assert_encloses(&outcome.impacts[0].time, "1");
    let outcome = in_filtered(&scene);
    assert_eq!(names(&outcome.impacts), ["d0 w0 from"]);
    // The scene's fractions are rounded.
    assert!((outcome.impacts[0].time.get() - 1.0).abs() < 1e-15);
}

/// It rises by 1 in 1, to where it touches the ceiling with no speed, and is
/// back on the floor at 2.
#[test]
fn an_apex_that_grazes() {
    let scene = built(
        falling("5/2")
            .disc(Disc::at([0, 1], 1).velocity([0, 2]))
            .wall([-8, 3], [8, 3])
            .wall([-8, 0], [8, 0]),
    );
    let outcome = exactly(&scene);
    assert_logs(&scene, &[("2", "d0 w1")]);
    assert_eq!([outcome.grazes, in_filtered(&scene).grazes], [1, 1]);
}

/// A little faster, it hits the ceiling: 5/2 t - t² = 1 at 1/2, where its speed
/// is 3/2, and falls back: 1 = 3/2 τ + τ² after another 1/2.
#[test]
fn a_ceiling_in_the_way() {
    let scene = built(
        falling("5/4")
            .disc(Disc::at([0, 1], 1).velocity(["0", "5/2"]))
            .wall([-8, 3], [8, 3])
            .wall([-8, 0], [8, 0]),
    );
    assert_logs(&scene, &[("1/2", "d0 w0"), ("1", "d0 w1")]);
}

/// x = t - 3 and y = 1 + 6 t - t²: it rises past the end (0, 8) of the wall, which
/// it would touch from below at y = 7, where x = -√3, and from the side within
/// 1. It turns at 3, at (0, 10), and comes down on the wall, at y = 9, at 4.
#[test]
fn around_the_end_of_a_wall() {
    let scene = falling("5")
        .disc(Disc::at([-3, 1], 1).velocity([1, 6]))
        .wall([0, 8], [9, 8]);
    assert_logs(&built(scene), &[("4", "d0 w0")]);
}

/// Down the incline, along (4, -3)/5, it is pulled with 6/5: 3/5 t². The second
/// wall stands across, 25 down, so that the disc stops at 20, with nowhere to go.
#[test]
fn down_an_incline_into_a_groove() {
    let scene = falling("9")
        .disc(Disc::at([3, 4], 5))
        .wall([-40, 30], [40, -30])
        .wall([20, -15], [26, -7])
        .restitution(newton("0"));
    let scene = built(scene);
    let outcome = exactly(&scene);
    assert_eq!(names(&outcome.impacts), ["d0 w1"]);
    assert_surd(&outcome.impacts[0].time, ["0", "1"], "100/3");
    assert_eq!(outcome.rests, 2);
    let [x, y, vx, vy] = numbers(&outcome.end[0]);
    for (number, expected) in [(x, "19"), (y, "-8"), (vx, "0"), (vy, "0")] {
        assert_encloses(&number, expected);
    }
    let outcome = in_filtered(&scene);
    assert_eq!(
        (names(&outcome.impacts), outcome.rests),
        (vec!["d0 w1".to_owned()], 2)
    );
    for (number, expected) in numbers(&outcome.end[0]).iter().zip([19.0, -8.0, 0.0, 0.0]) {
        assert!((number.get() - expected).abs() < 1e-13, "{number:?}");
    }
}

/// On a floor it slides at 3 for 2, flies off the end, 4 above the ground, and
/// lands after another 2.
#[test]
fn off_a_table() {
    let scene = built(
        falling("9/2")
            .disc(Disc::at([-6, 5], 1).velocity([3, 0]))
            .wall([-20, 4], [0, 4])
            .wall([-20, 0], [20, 0])
            .restitution(newton("0")),
    );
    let outcome = exactly(&scene);
    assert_logs(&scene, &[("4", "d0 w1")]);
    assert_eq!(outcome.rests, 2);
    assert_end(&outcome, &[["15/2", "1", "3", "0"]]);
    let outcome = in_filtered(&scene);
    assert_eq!(outcome.rests, 2);
    let end = numbers(&outcome.end[0]).map(Filtered::get);
    assert_eq!(end, [7.5, 1.0, 3.0, 0.0]);
}

/// At a speed of 1 it does not fly off, for 1² < g r = 2: it falls around the
/// end, of which nothing is known.
#[test]
fn around_the_edge_of_a_table() {
    let scene = built(
        falling("9")
            .disc(Disc::at([-6, 5], 1).velocity([1, 0]))
            .wall([-20, 4], [0, 4])
            .restitution(newton("0")),
    );
    let outcome: Outcome<Exact> = attempt(&scene, Algorithm::Timeline, &Options::default());
    assert!(matches!(outcome.status, Status::Accumulation(_)));
    assert_eq!(outcome.time.enclosure().unwrap().0, ratio("6"));
}

/// Of height 4 - t² over a piston at height t, it is hit at 1, at a speed of 3
/// relative to it: back after τ² = 3 τ.
#[test]
fn a_piston_does_not_fall() {
    let scene = falling("5")
        .disc(Disc::at([0, 4], 1))
        .disc(Disc::at([0, 0], 1).velocity([0, 1]).infinite_mass());
    let expected = [("1", "d0 d1"), ("4", "d0 d1")];
    assert_logs(&built(scene), &expected);
}

/// With gravity -2 and drag 1/2, in frames of 1/2: down at -1 for one frame, then
/// by (-2 + 1/2) / 2 more, -7/4; to the right at 3/4 of 1, and at 3/4 of that.
#[test]
fn frames_change_the_velocity_first() {
    let scene = Scene::builder("frames")
        .frame("1/2", 2)
        .gravity([0, -2])
        .linear_drag("1/2")
        .disc(Disc::at([0, 4], 1).velocity([1, 0]))
        .disc(Disc::at([9, 4], 1).infinite_mass());
    let outcome: Outcome<Exact> = complete(&built(scene), Algorithm::Single);
    assert_end(
        &outcome,
        &[["21/32", "21/8", "9/16", "-7/4"], ["9", "4", "0", "0"]],
    );
}

/// It grazes the end (0, 0) of the wall at (-4/5, 3/5), after 1/2, moving at a right
/// angle to that, by (6/5, 8/5): so it rises to 1 above the wall, and above it comes
/// down to that where 3/5 + 8/5 s - s² = 1, s = (4 + √6)/5 later.
#[test]
fn a_landing_on_a_wall_whose_end_was_grazed() {
    let scene = falling("3")
        .disc(Disc::at(["-7/5", "-9/20"], 1).velocity(["6/5", "13/5"]))
        .wall([0, 0], [9, 0]);
    let outcome = exactly(&built(scene));
    assert_eq!(names(&outcome.impacts)[0], "d0 w0");
    assert_eq!(outcome.grazes, 1);
    assert_surd(&outcome.impacts[0].time, ["13/10", "1/5"], "6");
}

/// A fixed disc is grazed in the same place, at a speed of 3/2. From then on the
/// squared distance is 1 + s² (21/20 - 12/5 s + s²): it is 1 again at s = 6/5 - √39/10.
#[test]
fn a_peg_that_is_grazed_and_then_hit() {
    let scene = falling("11/10")
        .disc(Disc::at(["-5/4", "-1/4"], "1/2").velocity(["9/10", "11/5"]))
        .disc(Disc::at([0, 0], "1/2").infinite_mass());
    let outcome = exactly(&built(scene));
    assert_eq!(names(&outcome.impacts), ["d0 d1"]);
    assert_eq!(outcome.grazes, 1);
    assert_surd(&outcome.impacts[0].time, ["17/10", "-1/10"], "39");
}

/// As off a table, of which the side is a wall too, named first: it is not in the
/// way.
#[test]
fn off_a_table_with_a_side() {
    let scene = built(
        falling("9/2")
            .disc(Disc::at([-6, 5], 1).velocity([3, 0]))
            .wall([0, 4], [0, 1])
            .wall([-20, 4], [0, 4])
            .wall([-20, 0], [20, 0])
            .restitution(newton("0")),
    );
    let outcome = exactly(&scene);
    assert_log(&outcome, &[("4", "d0 w2")]);
    assert_eq!(outcome.rests, 2);
    assert_end(&outcome, &[["15/2", "1", "3", "0"]]);
}

/// A floor of three pieces in one line, of which the last two overlap: at a speed of
/// 1, too slow to fly off at an edge, it slides from -2 to 5, and back to -8.
#[test]
fn along_a_floor_of_pieces() {
    let scene = falling("20")
        .disc(Disc::at([-2, 1], 1).velocity([1, 0]))
        .wall([-20, 0], [0, 0])
        .wall([3, 0], [0, 0])
        .wall([1, 0], [9, 0])
        .wall([6, 0], [6, 5]);
    let outcome = exactly(&built(scene));
    assert_log(&outcome, &[("7", "d0 w3")]);
    assert_eq!(outcome.rests, 1);
    assert_end(&outcome, &[["-8", "1", "-1", "0"]]);
}

/// It bounces after √2, 3√2, 5√2 and 7√2 on one floor, and after 9√2 = 12.7 on another
/// one in the same line, which it touches each time, but for the gap from 10 to 12.
#[test]
fn from_floor_to_floor() {
    let scene = falling("13")
        .disc(Disc::at([0, 3], 1).velocity([1, 0]))
        .wall([-10, 0], [10, 0])
        .wall([12, 0], [20, 0]);
    let outcome = exactly(&built(scene));
    let floors = ["d0 w0", "d0 w0", "d0 w0", "d0 w0", "d0 w1"];
    assert_eq!(names(&outcome.impacts), floors);
    for (n, impact) in (0..).zip(&outcome.impacts) {
        let expected = f64::from(2 * n + 1) * 2_f64.sqrt();
        // The root and the product are rounded, and so is the time.
        assert!((impact.time.to_f64() - expected).abs() < 2.0 * f64::EPSILON * expected);
    }
}

/// At rest beside a wall, it falls along it, past its end: no impact, ever.
#[test]
fn along_a_wall_and_past_its_end() {
    let scene = falling("5")
        .disc(Disc::at([1, 0], 1).velocity(["0", "-1/3"]))
        .wall(["0", "5"], ["0", "-7/3"]);
    let scene = built(scene);
    assert_log(&exactly(&scene), &[]);
    assert!(in_binary64(&scene).impacts.is_empty());
}

/// It hits the oblique ceiling along (4, 3) at a right angle, and without restitution:
/// there it stops, to fall anew. The ceiling is 1/2 away from it along (-3, 4)/5, in
/// which direction gravity is -8/5.
#[test]
fn a_dead_stop_at_a_ceiling() {
    let scene = falling("2")
        .disc(Disc::at([0, 0], 1).velocity(["-6/5", "8/5"]))
        .wall(["-49/10", "-18/10"], ["31/10", "42/10"])
        .restitution(newton("0"));
    let outcome = exactly(&built(scene));
    assert_eq!(names(&outcome.impacts), ["d0 w0"]);
    // 2 s - 4/5 s² = 1/2.
    assert_surd(&outcome.impacts[0].time, ["5/4", "-1/4"], "15");
}

/// What a product of four would take out of the range of binary64 is refused.
#[test]
fn gravity_that_is_too_strong_for_binary64() {
    let scene = lasting("1")
        .gravity(["0", "-1e200"])
        .disc(Disc::at([0, 0], 1));
    let scene = built(scene);
    let mut go_on = |_| std::ops::ControlFlow::Continue(());
    let options = Options::default();
    let refused = carom::run::run::<f64>(&scene, Algorithm::Timeline, &options, &mut go_on);
    assert!(refused.is_err());
    assert!(exactly(&scene).impacts.is_empty());
}
