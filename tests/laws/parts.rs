//! A run in parts is the run: stopped and gone on from its state, or frame by
//! frame. And nothing is ever inside anything else.

use carom::arithmetic::Arithmetic;
use carom::impact::Impact;
use carom::run::{Options, Status};
use carom::scalar::{Exact, Number};
use carom::scene::Scene;
use carom::simulation::{Algorithm, Simulation};
use num_rational::BigRational;
use proptest::prelude::*;

use crate::common::agree::{agree, rational};
use crate::common::strategy::{Bead, Chain, Masses, boxed, cases, chain, lossy};
use crate::common::{attempt, exactly, in_binary64, name, names, numbers, tolerance};

fn whole(number: i64) -> BigRational {
    BigRational::from_integer(number.into())
}

fn log(impacts: &[Impact<Exact>], start: &BigRational) -> Vec<(BigRational, String)> {
    let logged = |impact: &Impact<Exact>| (rational(&impact.time) + start, name(impact));
    impacts.iter().map(logged).collect()
}

fn frame_by_frame<S: Arithmetic>(
    scene: &Scene,
    precision: S::Precision,
) -> (Vec<Impact<S>>, Vec<[S; 4]>) {
    let mut simulation = Simulation::<S>::new(scene, Algorithm::Timeline, precision).unwrap();
    let frames = 0..scene.frame().count;
    let impacts = frames.flat_map(|_| simulation.next_frame().unwrap());
    let impacts = impacts.collect();
    (impacts, simulation.discs().iter().map(numbers).collect())
}

/// The scene in 28 frames, whose ends binary64 does not have.
fn framed(scene: &Scene) -> Scene {
    scene.to_builder().frame("1/7", 28).build().unwrap()
}

/// The chain as it is at the end of a run.
fn resumed(chain: &Chain, end: &[carom::body::Disc<Exact>]) -> Chain {
    let discs = chain.discs.iter().zip(end).map(|(bead, disc)| Bead {
        position: rational(&disc.position.x),
        velocity: rational(&disc.velocity.x),
        ..bead.clone()
    });
    Chain {
        discs: discs.collect(),
        ..chain.clone()
    }
}

proptest! {
    #![proptest_config(cases(100))]

    /// The state in the middle, as a scene of its own, goes on as if nothing
    /// had been: with ties, and where the middle is the time of an impact.
    #[test]
    fn stop_and_resume(chain in prop_oneof![chain(1), chain(2), chain(97)]) {
        let one_run = exactly(&chain.scene(&whole(4)));
        let first = exactly(&chain.scene(&whole(2)));
        let then = resumed(&chain, &first.end);
        let second = exactly(&then.scene(&whole(2)));
        let mut in_parts = log(&first.impacts, &whole(0));
        in_parts.extend(log(&second.impacts, &whole(2)));
        prop_assert_eq!(in_parts, log(&one_run.impacts, &whole(0)));
        for (one, other) in one_run.end.iter().zip(&second.end) {
            prop_assert_eq!(numbers(one).map(|n| rational(&n)), numbers(other).map(|n| rational(&n)));
        }
    }

    /// An end within the run is where the run then is.
    #[test]
    fn an_earlier_end_is_a_part(scene in lossy()) {
        let options = Options { until: Some(Number::from(2)), ..Options::default() };
        let part = attempt::<f64>(&scene, Algorithm::Timeline, &options);
        prop_assert_eq!(&part.status, &Status::Complete);
        let whole = in_binary64(&scene);
        let expected = whole.impacts.iter().filter(|impact| impact.time <= 2.0);
        let expected: Vec<_> = expected.map(|impact| (name(impact), impact.time)).collect();
        let found = part.impacts.iter().map(|impact| (name(impact), impact.time));
        prop_assert_eq!(found.collect::<Vec<_>>(), expected);
    }

    /// In binary64 to the last bit, for the timeline does not start anew.
    #[test]
    fn frames_do_not_matter_in_binary64(scene in lossy()) {
        let scene = framed(&scene);
        let whole = in_binary64(&scene);
        let (impacts, end) = frame_by_frame::<f64>(&scene, ());
        let times = |impacts: &[Impact<f64>]| -> Vec<_> {
            impacts.iter().map(|impact| impact.time).collect()
        };
        prop_assert_eq!(names(&impacts), names(&whole.impacts));
        prop_assert_eq!(times(&impacts), times(&whole.impacts));
        let expected: Vec<_> = whole.end.iter().map(numbers).collect();
        prop_assert_eq!(end, expected);
    }
}

proptest! {
    #![proptest_config(cases(100))]

    #[test]
    fn frames_do_not_matter_in_exact_arithmetic(scene in lossy()) {
        let scene = framed(&scene);
        let whole = exactly(&scene);
        let (impacts, end) = frame_by_frame::<Exact>(&scene, whole.precision);
        prop_assert_eq!(names(&impacts), names(&whole.impacts));
        for (one, other) in impacts.iter().zip(&whole.impacts) {
            prop_assert!(agree(&one.time, &other.time));
        }
        for (one, other) in end.iter().zip(whole.end.iter().map(numbers)) {
            prop_assert!(one.iter().zip(&other).all(|(one, other)| agree(one, other)));
        }
    }

    /// Whatever the timeline may have missed, it would show here.
    #[test]
    fn nothing_gets_into_anything(scene in boxed(Masses::Any)) {
        let scene = framed(&scene);
        let mut simulation = Simulation::<f64>::new(&scene, Algorithm::Timeline, ()).unwrap();
        for _ in 0..scene.frame().count {
            simulation.next_frame().unwrap();
            let discs = simulation.discs();
            for (index, disc) in discs.iter().enumerate() {
                let others = discs[index + 1..].iter();
                let discs = others.map(|other| apart(disc, other));
                let walls = scene.walls().iter().map(|wall| above(disc, wall));
                prop_assert!(discs.chain(walls).all(|gap| gap > -tolerance::SHORT_RUN));
            }
        }
    }
}

/// The gap between two discs.
fn apart(one: &carom::body::Disc<f64>, other: &carom::body::Disc<f64>) -> f64 {
    let [x, y] = [
        other.position.x - one.position.x,
        other.position.y - one.position.y,
    ];
    x.hypot(y) - one.radius - other.radius
}

/// The gap between a disc and a wall.
fn above(disc: &carom::body::Disc<f64>, wall: &carom::scene::Wall) -> f64 {
    let [from, to] = [&wall.from, &wall.to].map(|[x, y]| [x.to_f64(), y.to_f64()]);
    let (along, offset) = (
        [to[0] - from[0], to[1] - from[1]],
        [disc.position.x - from[0], disc.position.y - from[1]],
    );
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let part = (dot(offset, along) / dot(along, along)).clamp(0.0, 1.0);
    let [x, y] = [offset[0] - part * along[0], offset[1] - part * along[1]];
    x.hypot(y) - disc.radius
}
