//! Gravity alone, and elastic impacts, run backwards as well: with all velocities
//! reversed at the end, the impacts come again from last to first, and the discs
//! return.

use carom::arithmetic::Arithmetic;
use carom::body::Disc;
use carom::effects::course;
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::Scene;
use carom::timeline::Setup;
use carom::world::World;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::GENERIC;
use super::case::Family;
use crate::common::{name, numbers};

/// The bits of the enclosures.
const BITS: u32 = 256;

/// More than any of these runs has.
const MOST_IMPACTS: usize = 60;

/// A run: what is hit, when, and where all discs end.
struct Run<S> {
    names: Vec<String>,
    times: Vec<S>,
    end: Vec<Disc<S>>,
}

/// Follows a scene whose discs start otherwise; none if that is not decided, there are
/// too many impacts, or any two at a time.
fn follow<S: Arithmetic>(
    scene: &Scene,
    start: Option<&[Disc<S>]>,
    precision: S::Precision,
) -> Option<Run<S>> {
    let mut world = World::<S>::new(scene, precision);
    if let Some(start) = start {
        world.discs = start.to_vec();
    }
    let end = S::from_rational(scene.frame().total(), precision);
    let setup = Setup::default();
    let mut course = course(world, scene.effects(), &end, &setup, precision).ok()?;
    let (mut names, mut times) = (Vec::new(), Vec::new());
    while let Some(impact) = course.next_impact(&end).ok()? {
        names.push(name(&impact));
        times.push(impact.time);
        if names.len() > MOST_IMPACTS {
            return None;
        }
    }
    let end = course.discs_at(&end);
    Some(Run { names, times, end })
}

fn turned<S: Scalar>(discs: &[Disc<S>]) -> Vec<Disc<S>> {
    let turn = |disc: &Disc<S>| Disc {
        velocity: disc.velocity.map(|component| -component.clone()),
        last: None,
        ..disc.clone()
    };
    discs.iter().map(turn).collect()
}

/// A scene there and back.
fn there_and_back<S: Arithmetic>(scene: &Scene, precision: S::Precision) -> Option<[Run<S>; 2]> {
    let there = follow::<S>(scene, None, precision)?;
    let back = follow(scene, Some(&turned(&there.end)), precision)?;
    Some([there, back])
}

/// The numbers that discs start with, and those that they return with.
fn returns<S: Scalar>(scene: &Scene, back: &Run<S>) -> Vec<(BigRational, S)> {
    let starts = scene.discs().iter().flat_map(|disc| {
        let numbers = disc.position.iter().chain(&disc.velocity);
        numbers.map(Number::to_rational).collect::<Vec<_>>()
    });
    let back = turned(&back.end);
    starts.zip(back.iter().flat_map(numbers)).collect()
}

fn scenes() -> impl Iterator<Item = Scene> {
    let open = Family {
        boxed: false,
        walls: 4,
        pegs: 2,
        ..GENERIC
    };
    let seeds = [GENERIC, open].into_iter();
    seeds.flat_map(|family| (0..30).map(move |seed| family.case(seed).scene()))
}

/// The way back starts from all that the end may be, so it leads to all that the start
/// may have been: proven, without any tolerance.
#[test]
fn enclosures_return_to_the_start() {
    let mut returned = 0;
    for scene in scenes() {
        let Some([there, back]) = there_and_back::<Exact>(&scene, BITS) else {
            continue;
        };
        let mirrored: Vec<_> = there.names.iter().rev().cloned().collect();
        assert_eq!(back.names, mirrored, "{scene:?}");
        let end = Exact::from_rational(scene.frame().total(), BITS);
        for (time, other) in there.times.iter().rev().zip(&back.times) {
            assert!(contains(
                &(end.clone() - time - other),
                &BigRational::default()
            ));
        }
        for (start, end) in returns(&scene, &back) {
            assert!(contains(&end, &start), "{start} {end:?}");
        }
        returned += usize::from(!there.names.is_empty());
    }
    assert!(returned > 20, "only {returned} runs return");
}

fn contains(number: &Exact, value: &BigRational) -> bool {
    let (lo, hi) = number.enclosure().unwrap();
    lo <= *value && *value <= hi
}

/// Rounding to 53 bits instead of [`BITS`] makes errors that are greater by the
/// difference, as long as they are small: those of enclosures, which allow for more
/// than the way back undoes, bound them. Both round some ten times in a formula.
#[test]
fn numbers_return_as_close_as_enclosures_allow() {
    let mut returned = 0;
    for scene in scenes() {
        let exact = there_and_back::<Exact>(&scene, BITS);
        let (Some([_, exact]), Some([_, back])) = (exact, there_and_back::<f64>(&scene, ())) else {
            continue;
        };
        let bounds = returns(&scene, &exact)
            .into_iter()
            .map(|(_, end)| error(&end));
        let bounds: Vec<f64> = bounds.map(|error| 10.0 * error).collect();
        if bounds.iter().any(|bound| *bound > 1e-3) {
            continue;
        }
        let widest = bounds.iter().copied().fold(f64::EPSILON, f64::max);
        for (start, end) in returns(&scene, &back) {
            let off = (start.to_f64().unwrap() - end).abs();
            assert!(off <= widest, "{off} {widest}");
        }
        returned += usize::from(!back.names.is_empty());
    }
    assert!(returned > 20, "only {returned} runs return");
}

/// That of an enclosure, if it had but the bits of binary64.
fn error(number: &Exact) -> f64 {
    let (lo, hi) = number.enclosure().unwrap();
    let bits = BITS - f64::MANTISSA_DIGITS;
    (hi - lo).to_f64().unwrap() * f64::from(bits).exp2()
}
