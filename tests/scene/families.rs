//! Families of scenes: each has what it is named for.

use std::f64::consts::PI;

use carom::arithmetic::Budget;
use carom::body::BodyId;
use carom::first_impact::{Class, of_disc_and_wall, of_discs};
use carom::impact::Impact;
use carom::run::{Options, Outcome, Status};
use carom::scalar::{Exact, Scalar};
use carom::scene::generate::{Family, scene_of};
use carom::scene::{Mass, Scene};
use carom::simulation::Algorithm;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::{exact, ratio};
use crate::common::attempt;

const SEED: u64 = 42;

fn sample(family: Family) -> impl Iterator<Item = Scene> {
    (0..30).map(move |index| scene_of(family, SEED, index).expect("a scene"))
}

/// The exact run, within a small budget.
fn run(scene: &Scene) -> Outcome<Exact> {
    let options = Options {
        max_events: 400,
        budget: Budget {
            most_bits: 1 << 12,
            ..Budget::default()
        },
        ..Options::default()
    };
    let outcome = attempt(scene, Algorithm::Timeline, &options);
    assert_eq!(outcome.status, Status::Complete, "{}", scene.to_json());
    outcome
}

fn nameless(scene: &Scene) -> Scene {
    scene.to_builder().id("").build().expect("a scene")
}

/// 2^-`exponent`.
fn power(exponent: u32) -> BigRational {
    ratio(1, 1 << exponent)
}

#[test]
fn names_are_read_back() {
    for family in Family::ALL {
        assert_eq!(
            family.to_string().parse::<Family>().expect("a family"),
            family
        );
    }
    let error = "nearly".parse::<Family>().expect_err("no family");
    assert_eq!(error.place(), Some("family"));
    assert!(error.to_string().contains("random, near-graze"), "{error}");
}

#[test]
fn a_scene_depends_on_its_number_alone_and_no_two_agree() {
    for family in Family::ALL {
        let backwards = (0..200).rev().map(|index| scene_of(family, SEED, index));
        let mut scenes: Vec<_> = backwards.map(|scene| scene.expect("a scene")).collect();
        scenes.reverse();
        for (index, scene) in scenes.iter().enumerate() {
            assert_eq!(scene.id(), format!("{family}-42-{index}"));
            assert_eq!(Scene::from_json(&scene.to_json()).expect("a scene"), *scene);
        }
        assert!(sample(family).eq(scenes[..30].iter().cloned()));
        let scenes: Vec<_> = scenes.iter().map(nameless).collect();
        for (index, scene) in scenes.iter().enumerate() {
            assert!(!scenes[..index].contains(scene), "{family} {index}");
        }
        let other = scene_of(family, SEED + 1, 0).expect("a scene");
        assert_ne!(nameless(&other), scenes[0], "another seed");
    }
}

#[test]
fn scenes_are_small_and_start_apart() {
    for scene in Family::ALL.into_iter().flat_map(sample) {
        assert!((1..=8).contains(&scene.discs().len()), "{}", scene.id());
        assert!(scene.walls().len() <= 6, "{}", scene.id());
        super::generated::assert_apart(&scene);
        for disc in scene.discs() {
            for wall in scene.walls() {
                let class = of_disc_and_wall(disc, wall).class;
                assert_ne!(class, Class::Overlap, "{}", scene.to_json());
            }
        }
    }
}

/// And something happens in most of them.
#[test]
fn every_run_is_decided_within_a_small_budget() {
    for family in Family::ALL {
        let counts: Vec<_> = sample(family)
            .map(|scene| run(&scene).impacts.len())
            .collect();
        let idle = counts.iter().filter(|count| **count == 0).count();
        let most = if family == Family::Galperin { 314 } else { 120 };
        assert!(idle <= 12, "{family}: {counts:?}");
        assert!(
            counts.iter().all(|count| *count <= most),
            "{family}: {counts:?}"
        );
    }
}

/// What becomes of the first disc and what it passes.
#[test]
fn near_grazes_are_grazes_hits_and_misses() {
    let classes: Vec<_> = sample(Family::NearGraze)
        .map(|scene| pass(&scene))
        .collect();
    for class in [Class::Graze, Class::Hit, Class::Miss] {
        assert!(classes.contains(&class), "{class:?}");
    }
    assert_eq!(classes.len(), 30);
}

/// The class, which must be that of the reach that the notes tell.
fn pass(scene: &Scene) -> Class {
    let disc = &scene.discs()[0];
    let class = match scene.discs().get(1) {
        Some(other) => of_discs(disc, other).class,
        None => of_disc_and_wall(disc, &scene.walls()[0]).class,
    };
    let notes = scene.notes().expect("notes");
    let more = notes.rsplit_once("by ").expect("a reach").1;
    let expected = match more {
        "0." => Class::Graze,
        more if more.starts_with('-') => Class::Miss,
        _ => Class::Hit,
    };
    assert_eq!(class, expected, "{notes} {}", scene.to_json());
    class
}

#[test]
fn near_ties_are_within_2_to_the_minus_19() {
    let mut kinds = [false; 4];
    for scene in sample(Family::NearTie) {
        let impacts = run(&scene).impacts;
        let [first, second] = [0, 1].map(|index| &impacts[index]);
        let bounds = |time: &Exact| time.enclosure().expect("bounds");
        let (lo, _) = bounds(&first.time);
        let (_, hi) = bounds(&second.time);
        assert!(hi - lo < power(19), "{}", scene.to_json());
        let shared = first.pair.shares_disc(&second.pair);
        kinds[2 * usize::from(first.tie.is_some()) + usize::from(shared)] = true;
    }
    assert_eq!(kinds, [true; 4], "ties or not, with a shared disc or not");
}

/// A frame takes a bullet more than eight times its diameter.
#[test]
fn bullets_outrun_themselves() {
    for scene in sample(Family::Bullets) {
        let bullet = &scene.discs()[0];
        let [x, y] = exact(&bullet.velocity);
        let frame = scene.frame().duration.to_rational();
        let step = (&x * &x + &y * &y) * &frame * &frame;
        let size = bullet.radius.to_rational() * ratio(16, 1);
        assert!(step > &size * &size, "{}", scene.to_json());
    }
}

/// All centres of a cradle are on a line, and some discs are a sixteenth of a hypotenuse
/// apart or less.
#[test]
fn cradles_are_lines_that_nearly_touch() {
    let mut touching = 0;
    for scene in sample(Family::Cradles) {
        let places: Vec<_> = scene
            .discs()
            .iter()
            .map(|disc| exact(&disc.position))
            .collect();
        let from = |index: usize| [0, 1].map(|axis: usize| &places[index][axis] - &places[0][axis]);
        let [dx, dy] = from(1);
        for index in 2..places.len() {
            let [x, y] = from(index);
            assert_eq!(&dx * y, &dy * x, "{}", scene.id());
        }
        let close = |a: usize| {
            let [a, b] = [&scene.discs()[a], &scene.discs()[a + 1]];
            let reach = a.radius.to_rational() + b.radius.to_rational();
            let [ax, ay] = exact(&a.position);
            let [bx, by] = exact(&b.position);
            let apart = (&ax - &bx) * (&ax - &bx) + (&ay - &by) * (&ay - &by);
            touching += i32::from(apart == &reach * &reach);
            let near = reach + ratio(17, 16);
            apart <= &near * &near
        };
        assert!(
            (0..places.len() - 1)
                .map(close)
                .fold(false, |any, is| any | is)
        );
    }
    assert!(touching > 10, "{touching}");
}

/// Ends are hit, or two walls at once.
#[test]
fn corners_have_ends_and_ties() {
    let runs: Vec<_> = sample(Family::Corners)
        .map(|scene| run(&scene).impacts)
        .collect();
    let ends = runs
        .iter()
        .filter(|run| run.iter().any(|impact| impact.end.is_some()));
    assert!(ends.count() >= 5);
    let ties = runs
        .iter()
        .filter(|run| run.iter().any(|impact| impact.tie.is_some()));
    assert!(ties.count() >= 2);
    let meets_walls = |run: &[Impact<Exact>]| {
        run.iter()
            .any(|impact| matches!(impact.pair.b, BodyId::Wall(_)))
    };
    assert!(runs.iter().filter(|run| meets_walls(run)).count() >= 25);
}

#[test]
fn offsets_are_far_out_in_binary64() {
    for scene in sample(Family::Offsets) {
        for disc in scene.discs() {
            for number in &disc.position {
                let number = number.as_binary64().expect("a binary64").abs();
                assert!((800.0..1.1e9).contains(&number), "{number}");
            }
        }
    }
}

#[test]
fn mass_ratios_are_a_thousand_or_more() {
    let mut infinite = 0;
    for scene in sample(Family::MassRatios) {
        let finite = |disc: &carom::scene::Disc| match &disc.mass {
            Mass::Finite(mass) => mass.to_f64(),
            Mass::Infinite => f64::INFINITY,
        };
        let masses: Vec<_> = scene.discs().iter().map(finite).collect();
        let largest = masses.iter().copied().fold(0.0, f64::max);
        let smallest = masses.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(largest >= 999.0 * smallest, "{masses:?}");
        infinite += i32::from(largest.is_infinite());
    }
    assert!((3..25).contains(&infinite), "{infinite}");
}

/// ⌈π/α⌉ - 1 with α = arctan √(m/M); where π/α is whole, its rounded value may not be.
#[test]
fn galperins_count_is_that_of_the_theory() {
    for scene in sample(Family::Galperin) {
        let [light, heavy] = [0, 1].map(|index: usize| match &scene.discs()[index].mass {
            Mass::Finite(mass) => mass.to_rational(),
            Mass::Infinite => panic!("a finite mass"),
        });
        let angle = (light / heavy).to_f64().expect("a number").sqrt().atan();
        let expected = (PI / angle - 1e-9).ceil() as usize - 1;
        assert_eq!(run(&scene).impacts.len(), expected, "{}", scene.id());
    }
}
