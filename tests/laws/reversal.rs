//! Elastic impacts run backwards as well: with all velocities reversed at the
//! end, the impacts come again from last to first, and the discs return.

use carom::arithmetic::Budget;
use carom::run::{Options, Outcome, Status};
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::{Disc, Scene};
use carom::simulation::Algorithm;
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;

use crate::common::agree::{distance, rational};
use crate::common::strategy::{Masses, boxed, cases, chain, cluster};
use crate::common::{attempt, exactly, names, numbers, tolerance};

/// The end of a run with all velocities reversed, as a scene.
fn turned(scene: &Scene, end: &Outcome<Exact>, round: impl Fn(&Exact) -> BigRational) -> Scene {
    let number = |value: &Exact| Number::try_from(round(value)).unwrap();
    let discs = scene.discs().iter().zip(&end.end).map(|(disc, end)| {
        let [x, y, vx, vy] = numbers(end);
        Disc {
            position: [number(&x), number(&y)],
            velocity: [number(&-vx), number(&-vy)],
            ..disc.clone()
        }
    });
    scene
        .to_builder()
        .without_discs()
        .discs(discs)
        .build()
        .unwrap()
}

/// The middle of an enclosure, cut to so many bits after the binary point.
fn rounded(value: &Exact) -> BigRational {
    let (lo, hi) = value.enclosure().unwrap();
    let unit = BigInt::from(1) << tolerance::TURNING_BITS;
    let units = (lo + hi) / BigInt::from(2) * &unit;
    BigRational::new(units.floor().to_integer(), unit)
}

/// With bits enough for the turning point.
fn precisely(scene: &Scene) -> Outcome<Exact> {
    let budget = Budget {
        first_bits: 512,
        ..Budget::default()
    };
    let options = Options {
        budget,
        ..Options::default()
    };
    let outcome = attempt(scene, Algorithm::Timeline, &options);
    assert_eq!(outcome.status, Status::Complete, "{scene:?}");
    outcome
}

fn mirrored<T>(mut list: Vec<T>) -> Vec<T> {
    list.reverse();
    list
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn runs_return(scene in prop_oneof![boxed(Masses::Any), cluster()]) {
        let there = precisely(&scene);
        let back = precisely(&turned(&scene, &there, rounded));
        prop_assert_eq!(names(&back.impacts), mirrored(names(&there.impacts)));
        for (one, other) in there.impacts.iter().zip(back.impacts.iter().rev()) {
            let mirrored = there.time.clone() - &other.time;
            prop_assert!(distance(&one.time, &mirrored) < tolerance::RETURN);
        }
        for (start, end) in there.start.iter().zip(&back.end) {
            let [x, y, vx, vy] = numbers(end);
            let numbers = numbers(start).into_iter().zip([x, y, -vx, -vy]);
            for (start, end) in numbers {
                prop_assert!(distance(&start, &end) < tolerance::RETURN);
            }
        }
    }

    /// In fractions the return is exact. A tie has a first and a last impact,
    /// and need not come again the other way round.
    #[test]
    fn chains_return_exactly(chain in chain(97)) {
        let scene = chain.scene(&BigRational::from_integer(4.into()));
        let there = exactly(&scene);
        prop_assume!(there.impacts.iter().all(|impact| impact.tie.is_none()));
        let back = exactly(&turned(&scene, &there, rational));
        prop_assert_eq!(names(&back.impacts), mirrored(names(&there.impacts)));
        for (start, end) in there.start.iter().zip(&back.end) {
            let [x, y, vx, vy] = numbers(end);
            let returned = [x, y, -vx, -vy].map(|value| rational(&value));
            prop_assert_eq!(numbers(start).map(|value| rational(&value)), returned);
        }
    }
}
