//! Where clocks do not matter, the algorithms give the truth, or the same.

use carom::arithmetic::Arithmetic;
use carom::frame::Passes;
use carom::run::{Options, Outcome};
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::{Disc, Scene};
use carom::simulation::Algorithm::{self, Multiple, Single, Synchronised, Timeline};
use num_rational::BigRational;
use proptest::prelude::*;

use super::ALL;
use crate::common::agree::{agree, rational};
use crate::common::strategy::{cases, cluster_with_piston, couple, lonely, lossy, vector};
use crate::common::{attempt, complete, exactly, lasting, names, numbers};

/// More passes than any frame of these scenes needs.
const MANY: Passes = Passes::Count(64);

fn framed(scene: &Scene, duration: &str, count: u64) -> Scene {
    scene.to_builder().frame(duration, count).build().unwrap()
}

/// The same impacts at the same times.
fn assert_same_log(one: &Outcome<Exact>, other: &Outcome<Exact>) {
    assert_eq!(names(&one.impacts), names(&other.impacts));
    for (one, other) in one.impacts.iter().zip(&other.impacts) {
        assert!(agree(&one.time, &other.time), "{one:?} {other:?}");
        let on_other_clock = other.other_time.as_ref().unwrap_or(&other.time);
        assert!(agree(&one.time, on_other_clock), "{other:?}");
    }
}

fn assert_same_run(one: &Outcome<Exact>, other: &Outcome<Exact>) {
    assert_same_log(one, other);
    for (one, other) in one.end.iter().zip(&other.end) {
        let numbers = numbers(one).into_iter().zip(numbers(other));
        assert!(
            numbers.into_iter().all(|(a, b)| agree(&a, &b)),
            "{one:?} {other:?}"
        );
    }
}

/// Everything of two runs that is logged, to the last bit.
fn assert_identical<S: Arithmetic>(scene: &Scene, one: Algorithm, other: Algorithm) {
    let all = |outcome: Outcome<S>| {
        let impacts = outcome.impacts.iter();
        let impacts: Vec<_> = impacts
            .map(|impact| (impact.step, format!("{:?}", impact.time)))
            .collect();
        (
            names(&outcome.impacts),
            impacts,
            format!("{:?}", outcome.end),
        )
    };
    assert_eq!(all(complete(scene, one)), all(complete(scene, other)));
}

proptest! {
    #![proptest_config(cases(100))]

    /// Nothing to collide with: p + v t.
    #[test]
    fn free_motion(position in vector(9.0), velocity in vector(9.0)) {
        let scene = lasting("1").disc(Disc::at(position, 1).velocity(velocity));
        let scene = framed(&scene.build().unwrap(), "1/7", 5);
        let truth = exactly(&scene).end.remove(0);
        let truth = numbers(&truth).map(|number| rational(&number));
        for algorithm in ALL {
            let outcome = complete::<Exact>(&scene, algorithm);
            prop_assert!(outcome.impacts.is_empty());
            let found = numbers(&outcome.end[0]).map(|number| rational(&number));
            prop_assert_eq!(&found, &truth);
        }
    }

    /// One pass is the single collision algorithm (P4.5), and before anything
    /// has collided all clocks agree.
    #[test]
    fn one_pass_is_the_single_collision_algorithm(scene in lossy()) {
        let scene = framed(&scene, "1/4", 16);
        for algorithm in [Multiple(Passes::Count(1)), Synchronised(Passes::Count(1))] {
            assert_identical::<f64>(&scene, Single, algorithm);
            assert_identical::<Exact>(&scene, Single, algorithm);
        }
    }

    /// A single disc has the only clock: each pass takes its next impact, in
    /// one frame or in many.
    #[test]
    fn a_lonely_disc(scene in lonely()) {
        let truth = exactly(&scene);
        for scene in [framed(&scene, "4", 1), framed(&scene, "1/4", 16)] {
            for algorithm in [Multiple(MANY), Synchronised(MANY)] {
                assert_same_run(&truth, &complete(&scene, algorithm));
            }
        }
    }

    /// The only impact of a frame, of two discs in the open.
    #[test]
    fn a_couple(scene in couple()) {
        let truth = exactly(&scene);
        for algorithm in [Multiple(Passes::Count(2)), Multiple(MANY), Synchronised(MANY)] {
            assert_same_run(&truth, &complete(&scene, algorithm));
        }
        assert_same_log(&truth, &complete(&scene, Single));
    }

    /// Of several discs in a frame that ends before their second impact: with
    /// the clocks brought together nothing else is found.
    #[test]
    fn the_first_impact_of_several_discs(scene in prop_oneof![cluster_with_piston(), lossy()]) {
        let scene = until_second_impact(&scene);
        let truth = exactly(&scene);
        prop_assert!(truth.impacts.len() <= 1);
        assert_same_run(&truth, &complete(&scene, Synchronised(MANY)));
        assert_same_log(&truth, &first_pass(&complete(&scene, Single), &truth));
    }
}

/// The scene in one frame that ends half way between its first two impacts.
fn until_second_impact(scene: &Scene) -> Scene {
    let impacts = exactly(scene).impacts;
    let [first, second, ..] = &impacts[..] else {
        return scene.clone();
    };
    let middle = (first.time.to_f64() + second.time.to_f64()) / 2.0;
    scene.to_builder().frame(middle, 1).build().unwrap()
}

/// What a run and the truth have in common, as a log.
fn first_pass(outcome: &Outcome<Exact>, truth: &Outcome<Exact>) -> Outcome<Exact> {
    let mut outcome = outcome.clone();
    let known = names(&truth.impacts);
    outcome
        .impacts
        .retain(|impact| known.contains(&crate::common::name(impact)));
    outcome
}

/// In a frame's first pass both clocks start at zero: there is one time, even
/// where it is irrational.
#[test]
fn clocks_that_agree_are_logged_as_one() {
    let scene = lasting("4")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .disc(Disc::at([4, 1], 1))
        .build()
        .unwrap();
    for algorithm in [Single, Multiple(MANY), Synchronised(MANY)] {
        let outcome = complete::<Exact>(&scene, algorithm);
        assert!(outcome.impacts[0].other_time.is_none(), "{algorithm:?}");
    }
}

/// d3 falls on d0 at 3.65 - √3, before which d2, on its way back from d1, has
/// got into d0. The second pass lets these two collide at once: d0 and d3 then
/// still show the same irrational time, and a third pass has to compare them.
#[test]
fn clocks_that_show_the_same_time_are_decided() {
    let scene = lasting("4")
        .disc(Disc::at([0, 0], 1))
        .disc(Disc::at([12, 0], 1).infinite_mass())
        .disc(Disc::at([9, 0], 1).velocity([5, 0]))
        .disc(Disc::at(["-1", "3.65"], 1).velocity([0, -1]))
        .build()
        .unwrap();
    let outcome = complete::<Exact>(&scene, Synchronised(Passes::Count(3)));
    assert_eq!(names(&outcome.impacts)[..3], ["d0 d3", "d1 d2", "d0 d2"]);
}

/// Whatever is simulated up to a time in the middle of a frame goes on to the
/// frame's end.
#[test]
fn an_end_within_a_frame_is_the_end_of_the_frame() {
    let scene = lasting("1").disc(Disc::at([0, 0], 1).velocity([1, 0]));
    let scene = framed(&scene.build().unwrap(), "1", 5);
    let options = Options {
        until: Some("5/2".parse::<Number>().unwrap()),
        ..Options::default()
    };
    let outcome = attempt::<Exact>(&scene, Single, &options);
    let three = BigRational::from_integer(3.into());
    assert_eq!(rational(&outcome.end[0].position.x), three);
    let outcome = attempt::<Exact>(&scene, Timeline, &options);
    assert_eq!(
        rational(&outcome.end[0].position.x),
        crate::common::ratio("5/2")
    );
}
