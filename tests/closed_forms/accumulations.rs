//! Infinitely many impacts before a finite time.
//!
//! Of three discs on a line let ℓ_n be the speed at which the n-th impact
//! happens. Equal masses of restitution e give ℓ_{n+2} = (1 + e)/2 ℓ_{n+1} - e ℓ_n,
//! for the first of two impacts takes e ℓ_n from the next one of its pair and
//! the second one adds (1 + e)/2 ℓ_{n+1}. The gap that opens at e ℓ_n for τ_n
//! closes at ℓ_{n+2} in τ_{n+1} = e ℓ_n τ_n / ℓ_{n+2}.

use carom::run::{Accumulation, Options, Outcome, Status};
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::{Disc, DiscBuilder, Restitution, Scene, SceneBuilder};
use carom::simulation::Algorithm;
use num_rational::BigRational;

use crate::common::agree::assert_log;
use crate::common::{attempt, exactly, lasting, names, ratio};

fn number(text: &str) -> Number {
    text.parse().unwrap()
}

fn newton(coefficient: &str, elastic_below: Option<&str>) -> Restitution {
    Restitution::Newton {
        coefficient: number(coefficient),
        walls: None,
        elastic_below: elastic_below.map(number),
    }
}

/// A disc of speed 1 that hits a second one at 1, with a third one beyond.
fn row(duration: &str, e: &str, third: DiscBuilder) -> SceneBuilder {
    lasting(duration)
        .disc(Disc::at([-3, 0], 1).velocity([1, 0]))
        .disc(Disc::at([0, 0], 1))
        .disc(third)
        .restitution(newton(e, None))
}

/// The third disc at rest, 1 away from the second.
fn resting(duration: &str, e: &str) -> Scene {
    row(duration, e, Disc::at([3, 0], 1)).build().unwrap()
}

/// With e = 4/95, λ = 8/19 and 1/10: from λ² - 99/190 λ + 4/95. The first impact
/// adds 99/190 to -1/10, so that ℓ_1 = 8/19 ℓ_0; the gap is 8/19 then.
fn geometric(duration: &str) -> SceneBuilder {
    let third = Disc::at(["441/190", "0"], 1).velocity(["1/10", "0"]);
    row(duration, "4/95", third)
}

fn run(scene: &Scene) -> Outcome<Exact> {
    attempt(scene, Algorithm::Timeline, &Options::default())
}

fn accumulation<S: Scalar>(outcome: &Outcome<S>) -> &Accumulation {
    match &outcome.status {
        Status::Accumulation(found) => found,
        other => panic!("{other:?} at {:?}", outcome.time),
    }
}

fn assert_limit(outcome: &Outcome<Exact>, limit: &str) {
    let found = accumulation(outcome);
    assert!(found.proven);
    assert_eq!(found.limit, [ratio(limit), ratio(limit)]);
    let (lo, hi) = (ratio("0"), ratio(limit));
    for impact in &outcome.impacts {
        let (time, _) = impact.time.enclosure().unwrap();
        assert!(lo < time && time <= hi);
    }
}

/// τ_n = (19/80)^n from 1 on: 1 + 1 / (1 - 19/80).
#[test]
fn a_geometric_collapse() {
    let outcome = run(&geometric("9").build().unwrap());
    assert_limit(&outcome, "141/61");
    let first = [("1", "d0 d1"), ("2", "d1 d2"), ("179/80", "d0 d1")];
    let log = Outcome {
        impacts: outcome.impacts[..3].to_vec(),
        ..outcome.clone()
    };
    assert_log(&log, &first);
    let word = &accumulation(&outcome).word;
    let pairs: Vec<_> = word
        .iter()
        .map(|pair| format!("{} {}", pair.a, pair.b))
        .collect();
    let last = names(&outcome.impacts[outcome.impacts.len() - 2..]);
    assert_eq!(pairs, last);
}

#[test]
fn a_run_that_ends_before_is_complete() {
    let outcome = exactly(&geometric("2").build().unwrap());
    assert_log(&outcome, &[("1", "d0 d1"), ("2", "d1 d2")]);
    assert_limit(&run(&geometric("141/61").build().unwrap()), "141/61");
    let almost = exactly(&geometric("2.3114").build().unwrap());
    assert!(almost.impacts.len() > 5);
}

/// ℓ_0 = 1, ℓ_1 = 99/190 and a gap of 1.
#[test]
fn a_collapse_off_the_eigenvector() {
    let (e, kick) = (ratio("4/95"), ratio("99/190"));
    let [mut before, mut speed] = [ratio("1"), kick.clone()];
    let mut interval = ratio("1") / &speed;
    let mut time = ratio("1");
    for _ in 0..50 {
        time += &interval;
        let next = &kick * &speed - &e * &before;
        interval = &e * &before * &interval / &next;
        (before, speed) = (speed, next);
    }
    let limit = ratio("27/8");
    assert!(time < limit && &limit - time < ratio("1e-30"));
    assert_limit(&run(&resting("9", "4/95")), "27/8");
}

/// λ = (13 ± √69) / 50. ℓ_n is a multiple of λ1^(n+1) - λ2^(n+1), and the sum of
/// the intervals 1 / (ℓ_1 - λ2 ℓ_0) = 1 / λ1, for λ1 + λ2 = ℓ_1.
#[test]
fn an_irrational_limit() {
    let outcome = run(&resting("9", "1/25"));
    let found = accumulation(&outcome);
    assert!(found.proven);
    // x = 1 + (13 - √69) / 2, so that (15 - 2 x)² = 69.
    let square = |x: &BigRational| {
        let root = ratio("15") - ratio("2") * x;
        &root * &root
    };
    let [lo, hi] = &found.limit;
    assert!(square(lo) >= ratio("69") && ratio("69") >= square(hi));
    assert!(hi - lo < ratio("1e-20"));
}

/// Just above 7 - 4√3 = 0.0717967…: ℓ_n is a multiple of r^n sin((n + 1) φ) with
/// r² = e and 2 r cos φ = (1 + e)/2, and positive while (n + 1) φ < π.
#[test]
fn above_the_threshold_the_impacts_end() {
    for e in [0.072_f64, 0.0719, 0.08, 0.1] {
        let outcome = exactly(&resting("100000", &e.to_string()));
        let angle = ((1.0 + e) / 4.0 / e.sqrt()).acos();
        let expected = (std::f64::consts::PI / angle).ceil() - 1.0;
        assert_eq!(outcome.impacts.len() as f64, expected, "{e}");
    }
    let below = run(&resting("100000", "0.0717"));
    assert!(accumulation(&below).proven);
}

/// A disc between a wall and one of mass M that comes with 1 and hits it at 1,
/// 3 before the wall. e = 1/2 and s = M / (M + 1) give T = 9/4 s - 1 and D = 1/4,
/// and ℓ_1 = 3/2 s. M = 9: μ = 5/8 and 2/5, ρ = (1/2 + 2/5) / (3/2) = 3/5, and
/// 3 / (27/20 - 3/5) = 4. M = 8: μ = 1/2 twice, ρ = 2/3, and 3 / (4/3 - 2/3) = 9/2.
#[test]
fn a_disc_between_a_wall_and_a_heavy_one() {
    let scene = |mass: &str| {
        lasting("1000")
            .wall([0, -9], [0, 9])
            .disc(Disc::at([4, 0], 1))
            .disc(Disc::at([7, 0], 1).velocity([-1, 0]).mass(number(mass)))
            .restitution(newton("1/2", None))
            .build()
            .unwrap()
    };
    assert_limit(&run(&scene("9")), "5");
    assert_limit(&run(&scene("8")), "11/2");
    exactly(&scene("7.9"));
}

/// All move along the wall, too, at a speed that takes them past its end or not.
#[test]
fn a_collapse_that_slides_along_a_wall() {
    let scene = |speed: &str| {
        lasting("9")
            .wall([0, -9], [0, 9])
            .disc(Disc::at([4, 0], 1).velocity(["0", speed]))
            .disc(Disc::at([7, 0], 1).velocity(["-1", speed]).mass(9))
            .restitution(newton("1/2", None))
            .build()
            .unwrap()
    };
    assert_limit(&run(&scene("3/2")), "5");
    exactly(&scene("2"));
}

/// A piston that leaves no room at 7, whatever is lost.
#[test]
fn a_disc_that_is_squeezed() {
    let laws = [
        Restitution::Elastic,
        newton("1/2", None),
        newton("0", None),
        newton("1/2", Some("3")),
    ];
    for law in laws {
        let scene = lasting("9")
            .disc(Disc::at([0, 0], 1).velocity([1, 0]).infinite_mass())
            .disc(Disc::at([4, 0], 1))
            .wall([10, -9], [10, 9])
            .restitution(law);
        assert_limit(&run(&scene.build().unwrap()), "7");
    }
}

/// Discs that stick: the second reaches the third at 3, and both pairs collide
/// for ever at that time.
#[test]
fn perfectly_inelastic_discs_collapse_at_once() {
    let outcome = run(&resting("9", "0"));
    assert_limit(&outcome, "3");
}

/// One that comes from aside at 100 hits the third disc before 141/61 = 2.31….
#[test]
fn nothing_is_claimed_where_another_disc_interferes() {
    let disturbed = |height: &str| {
        let fourth = Disc::at(["2.6", height], 1).velocity([0, -100]);
        geometric("9").disc(fourth).build().unwrap()
    };
    let outcome = run(&disturbed("227"));
    assert!(names(&outcome.impacts).contains(&String::from("d2 d3")));
    assert!(outcome.time.to_f64() > 2.25);
    assert_limit(&run(&disturbed("240")), "141/61");
}

/// A wall in the way of the third disc, which the three would reach together
/// before 141/61: their centre of mass, at 0.62 then, is 2 behind the disc.
#[test]
fn nothing_is_claimed_where_a_wall_interferes() {
    let scene = geometric("9").wall(["3.6", "-9"], ["3.6", "9"]);
    let outcome = run(&scene.build().unwrap());
    assert_ne!(accumulation(&outcome).limit[0], ratio("141/61"));
    assert!(names(&outcome.impacts).contains(&String::from("d2 w0")));
}

/// The second disc a little aside. On a line λ = (51 ± √1801) / 200, and the
/// limit is 1 + 1 / λ1 = 3.1404…. λ1 = 0.467 is above the cube root of 1/50.
#[test]
fn a_collapse_in_the_plane() {
    let scene = lasting("9")
        .disc(Disc::at([-3, 0], 1).velocity([1, 0]))
        .disc(Disc::at(["0", "1/1000"], 1))
        .disc(Disc::at([3, 0], 1))
        .restitution(newton("1/50", None));
    let scene = scene.build().unwrap();
    let outcome = run(&scene);
    let found = accumulation(&outcome);
    assert!(found.proven);
    assert!(&found.limit[1] - &found.limit[0] < ratio("1e-20"));
    let expected = 1.0 + 200.0 / (51.0 + 1801_f64.sqrt());
    assert!((accumulation(&outcome).limit_to_f64() - expected).abs() < 1e-4);
    let computed = attempt::<f64>(&scene, Algorithm::Timeline, &Options::default());
    let found = accumulation(&computed);
    assert!(!found.proven);
    assert!((found.limit_to_f64() - expected).abs() < 1e-4);
}

/// Two collapses at once, one the mirror image of the other: neither is ever
/// alone before the other.
#[test]
fn two_collapses_at_one_time() {
    let mut scene = lasting("9").restitution(newton("4/95", None));
    for height in [0, 10] {
        scene = scene
            .disc(Disc::at([-3, height], 1).velocity([1, 0]))
            .disc(Disc::at([0, height], 1))
            .disc(Disc::at([3, height], 1));
    }
    let outcome = run(&scene.build().unwrap());
    let found = accumulation(&outcome);
    assert!((found.limit_to_f64() - 3.375).abs() < 1e-9);
    assert_eq!(found.word.len(), 4);
}

/// Four discs: recognised, not proven.
#[test]
fn four_discs_collapse() {
    let scene = lasting("99")
        .disc(Disc::at([-3, 0], 1).velocity([1, 0]))
        .disc(Disc::at([0, 0], 1))
        .disc(Disc::at([3, 0], 1))
        .disc(Disc::at(["13/2", "0"], 1).velocity([-1, 0]))
        .restitution(newton("1/10", None));
    let outcome = run(&scene.build().unwrap());
    assert!(!accumulation(&outcome).proven);
}

#[test]
fn binary64_expects_but_does_not_prove() {
    let scene = geometric("9").build().unwrap();
    let outcome = attempt::<f64>(&scene, Algorithm::Timeline, &Options::default());
    let found = accumulation(&outcome);
    assert!(!found.proven);
    assert!((found.limit_to_f64() - 141.0 / 61.0).abs() < 1e-12);
}

/// The line through the discs at (0, 0), turned by an angle of tangent 3/4 and
/// of tangent 1: the same limit, though enclosures cannot tell a line.
#[test]
fn a_collapse_on_an_oblique_line() {
    let straight = run(&resting("9", "1/50"));
    for [x, y, length] in [["4/5", "3/5", "1"], ["1", "1", "0x1.6a09e667f3bcdp0"]] {
        let along = |distance: &str| {
            let part = |unit| ratio(unit) * ratio(distance) / ratio(length);
            [part(x), part(y)].map(|part| Number::try_from(part).unwrap())
        };
        let scene = lasting("9")
            .disc(Disc::at(along("-3"), 1).velocity(along("1")))
            .disc(Disc::at([0, 0], 1))
            .disc(Disc::at(along("3"), 1))
            .restitution(newton("1/50", None));
        let outcome = run(&scene.build().unwrap());
        let (found, expected) = (accumulation(&outcome), accumulation(&straight));
        assert!(found.proven && expected.proven);
        let apart = found.limit_to_f64() - expected.limit_to_f64();
        assert!(apart.abs() < 1e-14, "{x} {y}: {apart}");
    }
}

/// e = 7/100 is below the threshold on a line, but its λ1 = 0.312 is below the
/// cube root of e: aside of the line nothing is proven.
#[test]
fn curvature_prevails_near_the_threshold() {
    let scene = lasting("9")
        .disc(Disc::at([-3, 0], 1).velocity([1, 0]))
        .disc(Disc::at(["0", "1/10"], 1))
        .disc(Disc::at([3, 0], 1))
        .restitution(newton("7/100", None));
    let outcome = run(&scene.build().unwrap());
    assert_eq!(outcome.status, Status::Complete);
}
