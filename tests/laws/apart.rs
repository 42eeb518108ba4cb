//! What is far from everything else does not matter to it: two gases in one scene are two
//! runs, to the last bit. Together they are so many discs that the timeline fetches into
//! the cache what comes next; alone they are not.

use carom::body::Pair;
use carom::scene::{Disc, DiscBuilder, Scene};
use carom::timeline::Timeline;
use carom::world::World;

/// So many discs in a row, and rows, of each gas.
const ROWS: u32 = 93;

/// How far the second gas is from the first one.
const FAR: f64 = 4096.0;

const IMPACTS: usize = 4_000;

/// A gas in the open, from a place on.
fn gas(left: f64, seed: f64) -> Vec<DiscBuilder> {
    let cells = (0..ROWS).flat_map(|row| (0..ROWS).map(move |column| [column, row].map(f64::from)));
    let disc = |[x, y]: [f64; 2]| {
        // As good as random.
        let speed = |factor: f64| (factor * (x * 12.9898 + y * 78.233 + seed)).sin();
        Disc::at([left + 2.5 * x, 2.5 * y], 1).velocity([speed(437.0), speed(589.0)])
    };
    cells.map(disc).collect()
}

/// The first impacts: when, and whose.
fn impacts(discs: Vec<DiscBuilder>) -> Vec<(f64, Pair)> {
    let scene = Scene::builder("gas").discs(discs).frame(1, 1);
    let scene = scene.build().expect("a valid scene");
    let Ok(mut timeline) = Timeline::new(World::<f64>::new(&scene, ()), &f64::MAX);
    let next = || {
        let Ok(impact) = timeline.next_impact(&f64::MAX);
        impact.map(|impact| (impact.time, impact.pair))
    };
    std::iter::from_fn(next).take(IMPACTS).collect()
}

/// The pair where so many discs precede it.
fn later(Pair { a, b }: Pair, by: u32) -> Pair {
    use carom::body::BodyId::{Disc, Wall};
    let later = |body| match body {
        Disc(index) => Disc(index + by),
        Wall(index) => Wall(index),
    };
    Pair::new(later(a), later(b))
}

#[test]
fn gases_apart_are_as_each_alone() {
    let [near, far] = [gas(0.0, 1.0), gas(FAR, 2.0)];
    let together = impacts([near.clone(), far.clone()].concat());
    let others = impacts(far).into_iter();
    let others = others.map(|(time, pair)| (time, later(pair, ROWS * ROWS)));
    let mut alone: Vec<_> = impacts(near).into_iter().chain(others).collect();
    alone.sort_by(|one, other| one.0.total_cmp(&other.0));
    assert_eq!(together.len(), IMPACTS);
    assert_eq!(together, alone[..IMPACTS]);
}
