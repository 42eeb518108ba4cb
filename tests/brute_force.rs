//! The exact timeline against programs that share none of its formulas: what
//! they know is written from the physics, in `brute_force/`.

#[path = "brute_force/fractions.rs"]
mod fractions;
#[path = "brute_force/gaps.rs"]
mod gaps;
#[path = "brute_force/plane.rs"]
mod plane;

use std::cell::Cell;

use approx::assert_abs_diff_eq;
use carom::impact::Impact;
use carom::scalar::{Exact, Scalar};
use carom::scene::Scene;
use num_rational::BigRational;
use proptest::prelude::*;

use crate::common::agree::rational;
use crate::common::strategy::{Chain, cases, chain, cluster_with_piston, lossy};
use crate::common::{exactly, in_binary64, name, names, tolerance};

/// Scenes of a kind, with so many impacts in all that they say something.
fn compare(scenes: impl Strategy<Value = Scene>, least: usize) {
    let impacts = Cell::new(0);
    proptest!(cases(200), |(scene in scenes)| {
        impacts.set(impacts.get() + assert_same_run(&scene));
    });
    assert!(impacts.get() > least, "only {} impacts", impacts.get());
}

#[test]
fn boxes() {
    compare(lossy(), 1000);
}

#[test]
fn clusters_with_a_piston() {
    compare(cluster_with_piston(), 500);
}

/// The order, the times and the end; how many impacts there were.
fn assert_same_run(scene: &Scene) -> usize {
    let expected = plane::run(scene);
    let outcome = exactly(scene);
    assert_same(&outcome.impacts, &expected.impacts);
    assert_same(&in_binary64(scene).impacts, &expected.impacts);
    for (disc, position) in outcome.end.iter().zip(&expected.positions) {
        let found = [disc.position.x.to_f64(), disc.position.y.to_f64()];
        assert_abs_diff_eq!(&found[..], &position[..], epsilon = tolerance::SHORT_RUN);
    }
    expected.impacts.len()
}

fn assert_same<S: Scalar>(found: &[Impact<S>], expected: &[plane::Event]) {
    let expected_names: Vec<_> = expected.iter().map(|event| event.name.clone()).collect();
    assert_eq!(names(found), expected_names);
    for (impact, event) in found.iter().zip(expected) {
        let time = impact.time.to_f64();
        assert_abs_diff_eq!(time, event.time, epsilon = tolerance::SHORT_RUN);
    }
}

/// On a line: everything is equal, with ties and without.
#[test]
fn chains() {
    for denominator in [1, 2, 97] {
        let impacts = Cell::new(0);
        proptest!(cases(100), |(chain in chain(denominator))| {
            impacts.set(impacts.get() + assert_equal(&chain));
        });
        assert!(impacts.get() > 500, "only {} impacts", impacts.get());
    }
}

/// How many impacts there were.
fn assert_equal(chain: &Chain) -> usize {
    let until = BigRational::from_integer(4.into());
    let expected = fractions::run(chain, &until);
    let outcome = exactly(&chain.scene(&until));
    let found = outcome.impacts.iter().map(logged);
    assert_eq!(found.collect::<Vec<_>>(), expected.impacts);
    for (disc, bead) in outcome.end.iter().zip(&expected.discs) {
        assert_eq!(rational(&disc.position.x), bead.position);
        assert_eq!(rational(&disc.velocity.x), bead.velocity);
    }
    expected.impacts.len()
}

fn logged(impact: &Impact<Exact>) -> (BigRational, String) {
    (rational(&impact.time), name(impact))
}
