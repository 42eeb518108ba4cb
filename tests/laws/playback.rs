//! To look at a run does not disturb it: the impacts and the end are the same to the
//! last bit, whenever the bodies are looked at in between.

use carom::arithmetic::Arithmetic;
use carom::impact::Impact;
use carom::playback::Playback;
use carom::scalar::{Exact, Filtered, Scalar};
use carom::scene::Scene;
use carom::simulation::Algorithm;
use proptest::prelude::*;

use crate::common::strategy::{Masses, boxed, cases};
use crate::common::{complete, name, numbers};

/// Bounds of numbers, all of their bits.
fn bits<S: Scalar>(number: &S) -> [u64; 2] {
    let hull = number.hull();
    [hull.lo(), hull.hi()].map(f64::to_bits)
}

fn log<S: Scalar>(impacts: &[Impact<S>]) -> Vec<(String, [u64; 2])> {
    let entry = |impact: &Impact<S>| (name(impact), bits(&impact.time));
    impacts.iter().map(entry).collect()
}

fn state<S: Scalar>(discs: &[carom::body::Disc<S>]) -> Vec<[[u64; 2]; 4]> {
    let all = |disc| numbers(disc).each_ref().map(bits);
    discs.iter().map(all).collect()
}

/// Plays a scene, looking at it after these steps, over and over.
fn look<S: Arithmetic>(scene: &Scene, steps: &[f64]) {
    let whole = complete::<S>(scene, Algorithm::Timeline);
    let precision = whole.precision;
    let mut playback = Playback::<S>::new(scene, precision).unwrap();
    let mut impacts = Vec::new();
    for step in steps.iter().cycle() {
        let step = S::from_number(&(*step).try_into().unwrap(), precision);
        impacts.extend(playback.advance(&step).unwrap());
        let looked_at = playback.discs();
        assert_eq!(looked_at.len(), scene.discs().len());
        if bits(playback.time()) == bits(&whole.time) {
            break;
        }
    }
    assert_eq!(log(&impacts), log(&whole.impacts));
    assert_eq!(state(&playback.discs()), state(&whole.end));
    let mut another = Playback::<S>::new(scene, precision).unwrap();
    let all: Vec<_> = another.impacts().map(Result::unwrap).collect();
    assert_eq!(log(&all), log(&impacts));
}

proptest! {
    #![proptest_config(cases(40))]

    #[test]
    fn looking_does_not_disturb(
        scene in boxed(Masses::Finite),
        steps in prop::collection::vec(0.01..2.0, 1..6),
        falls in any::<bool>(),
    ) {
        let scene = scene.to_builder().frame("1/7", 28);
        let scene = if falls { scene.gravity([0, -1]) } else { scene };
        let scene = scene.build().unwrap();
        look::<f64>(&scene, &steps);
        look::<Filtered>(&scene, &steps);
    }

    #[test]
    fn looking_does_not_disturb_proofs(
        scene in boxed(Masses::Finite),
        steps in prop::collection::vec(0.01..2.0, 1..6),
    ) {
        let scene = scene.to_builder().frame("1/7", 28).build().unwrap();
        look::<Exact>(&scene, &steps);
    }
}
