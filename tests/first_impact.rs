//! First impacts in closed form: by hand, and against the decisions of the timeline, which
//! are computed otherwise.

use std::cmp::Ordering;

use carom::body::End;
use carom::first_impact::{Class, FirstImpact, of_disc_and_wall, of_discs};
use carom::playback::Playback;
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::{Disc, DiscBuilder, Scene, SceneBuilder};
use proptest::prelude::*;

fn scene(scene: SceneBuilder) -> Scene {
    scene.frame(1000, 1).build().expect("a valid scene")
}

fn two(one: DiscBuilder, other: DiscBuilder) -> FirstImpact {
    let scene = scene(Scene::builder("two").discs([one, other]));
    of_discs(&scene.discs()[0], &scene.discs()[1])
}

fn with_wall(disc: DiscBuilder, [from, to]: [[i32; 2]; 2]) -> FirstImpact {
    let scene = scene(Scene::builder("wall").disc(disc).wall(from, to));
    of_disc_and_wall(&scene.discs()[0], &scene.walls()[0])
}

fn moving(position: [i32; 2], velocity: [i32; 2]) -> DiscBuilder {
    Disc::at(position, 1).velocity(velocity)
}

fn rational(met: &FirstImpact) -> String {
    let time = met.time.as_ref().expect("a time");
    assert!(time.is_rational());
    time.p.to_string()
}

/// Radii 1 and 1; the centres are 2 apart when they touch.
#[test]
fn discs_of_every_class() {
    let still = || moving([0, 0], [0, 0]);
    let class = |position, velocity| two(moving(position, velocity), still()).class;
    assert_eq!(class([-5, 0], [1, 0]), Class::Hit);
    assert_eq!(class([-5, 0], [-1, 0]), Class::Miss);
    assert_eq!(class([-5, 3], [1, 0]), Class::Miss);
    assert_eq!(class([-5, 2], [1, 0]), Class::Graze);
    assert_eq!(class([-2, 0], [1, 0]), Class::TouchingApproaching);
    assert_eq!(class([-2, 0], [0, 1]), Class::TouchingSeparating);
    assert_eq!(class([-2, 0], [-1, 1]), Class::TouchingSeparating);
    assert_eq!(class([-1, 0], [1, 0]), Class::Overlap);
    assert_eq!(rational(&two(moving([-5, 0], [1, 0]), still())), "3");
    assert_eq!(rational(&two(moving([-5, 2], [1, 0]), still())), "5");
    // Overlapping discs collide at once if they approach, and not if they are concentric.
    let time = |position| two(moving(position, [1, 0]), still()).time;
    assert!(time([-1, 0]).is_some() && time([1, 0]).is_none() && time([0, 0]).is_none());
}

/// At height 1 the centres are √3 apart in x when they touch: 4 - √3 at speed 1.
#[test]
fn a_time_with_a_root() {
    let met = two(moving([-4, 1], [1, 0]), moving([0, 0], [0, 0]));
    let time = met.time.expect("a time");
    let parts = [&time.p, &time.q, &time.d].map(ToString::to_string);
    assert_eq!(parts, ["4", "-1", "3"]);
}

/// A wall from 0 to 6 on the axis; the disc has radius 1.
#[test]
fn walls_of_every_class() {
    let met = |position, velocity| with_wall(moving(position, velocity), [[0, 0], [6, 0]]);
    let class = |position, velocity| met(position, velocity).class;
    let above = met([3, 5], [0, -2]);
    assert_eq!(
        (above.class, above.end, &*rational(&above)),
        (Class::Hit, None, "2")
    );
    let corner = met([6, 5], [0, -1]);
    assert_eq!((corner.class, corner.end), (Class::Hit, Some(End::To)));
    let end = met([-4, 0], [1, 0]);
    assert_eq!(
        (end.class, end.end, &*rational(&end)),
        (Class::Hit, Some(End::From), "3")
    );
    assert_eq!(class([3, 5], [0, 2]), Class::Miss);
    assert_eq!(class([9, 5], [0, -1]), Class::Miss);
    assert_eq!(class([7, 5], [0, -1]), Class::Graze);
    assert_eq!(class([-4, 1], [1, 0]), Class::Graze);
    assert_eq!(class([3, 1], [1, -1]), Class::TouchingApproaching);
    assert_eq!(class([3, 1], [1, 0]), Class::TouchingSeparating);
    assert_eq!(class([-1, 0], [1, 0]), Class::TouchingApproaching);
    assert_eq!(class([3, 0], [0, 1]), Class::Overlap);
    assert_eq!(met([3, 0], [0, 1]).time, None);
}

/// What the exact timeline makes of one pair: the time of its first impact, if it has one.
fn first_of_timeline(scene: &Scene) -> Option<Exact> {
    let mut playback = Playback::<Exact>::new(scene, 256).expect("a decided start");
    let first = playback.impacts().next()?;
    Some(first.expect("a decided impact").time)
}

/// Both agree on whether the two collide, and on 60 digits of the time.
fn agree(scene: &Scene, met: &FirstImpact) {
    let collide = matches!(met.class, Class::Hit | Class::TouchingApproaching)
        || met.class == Class::Overlap && met.time.is_some();
    let time = met.time.as_ref().filter(|_| collide);
    // The scene ends at 1000.
    let found = first_of_timeline(scene);
    let Some(time) = time else {
        assert!(found.is_none(), "{met:?}");
        return;
    };
    let (lo, hi) = time.enclosure(200);
    let [lo, hi] = [lo, hi].map(|end| Number::try_from(end).expect("a number"));
    let found = found.unwrap_or_else(|| panic!("no impact: {met:?}"));
    let slack = Exact::from_number(&"1e-60".parse().unwrap(), 256);
    let after = |end: Number| Exact::from_number(&end, 256) - &found;
    let is_off = |apart: Exact| apart.compare(&slack) == Ok(Ordering::Greater);
    let (early, late) = (after(lo), -after(hi));
    assert!(
        !is_off(early) && !is_off(late),
        "{met:?}: {}",
        found.to_f64()
    );
}

fn place() -> impl Strategy<Value = [i32; 2]> {
    [-6..=6_i32, -6..=6]
}

proptest! {
    #[test]
    fn discs_meet_as_the_timeline_says(
        places in [place(), place()],
        velocities in [place(), place()],
        radii in [1..=3_i32, 1..=3],
    ) {
        let discs = [0, 1].map(|disc: usize| {
            Disc::at(places[disc], radii[disc]).velocity(velocities[disc])
        });
        let scene = scene(Scene::builder("two").discs(discs));
        agree(&scene, &of_discs(&scene.discs()[0], &scene.discs()[1]));
    }

    #[test]
    fn walls_are_met_as_the_timeline_says(
        at in place(),
        velocity in place(),
        radius in 1..=3_i32,
        ends in [place(), place()],
    ) {
        prop_assume!(ends[0] != ends[1]);
        let disc = Disc::at(at, radius).velocity(velocity);
        let scene = scene(Scene::builder("wall").disc(disc).wall(ends[0], ends[1]));
        agree(&scene, &of_disc_and_wall(&scene.discs()[0], &scene.walls()[0]));
    }
}
