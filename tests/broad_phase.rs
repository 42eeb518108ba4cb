//! The ways to find what a disc may meet lead to the same impacts: here on the
//! timeline.

mod frames;

use crate::common::strategy::cases;
use crate::common::{attempt, name};
use carom::arithmetic::Arithmetic;
use carom::run::{Options, Outcome, Status};
use carom::scalar::{Exact, Filtered, Number};
use carom::scene::{Disc, DiscBuilder, Restitution, Scene, SceneBuilder};
use carom::simulation::Algorithm;
use carom::timeline::BroadPhase;
use proptest::prelude::*;

const MOST_IMPACTS: u64 = 150;

fn run<S: Arithmetic>(scene: &Scene, broad_phase: BroadPhase) -> Outcome<S> {
    let options = Options {
        max_events: MOST_IMPACTS,
        broad_phase,
        ..Options::default()
    };
    attempt(scene, Algorithm::Timeline, &options)
}

/// What must not depend on the broad phase.
fn told<S: Arithmetic>(outcome: &Outcome<S>) -> (Vec<(String, u64)>, u64, Status) {
    let impacts = outcome.impacts.iter();
    let impacts = impacts.map(|impact| (name(impact), impact.time.to_f64().to_bits()));
    (impacts.collect(), outcome.grazes, outcome.status.clone())
}

fn assert_same<S: Arithmetic>(scene: &Scene) {
    let [all, grid] = [BroadPhase::AllPairs, BroadPhase::Grid].map(|phase| run::<S>(scene, phase));
    assert_eq!(told(&all), told(&grid), "{}", S::NAME);
}

/// How the discs of a scene differ.
#[derive(Clone, Copy, Debug)]
enum Kind {
    Alike,
    /// Radii of 1 : 100.
    Mixed,
    /// Among others that are alike, one that is large, one that is fast, one of
    /// infinite mass that moves, and one that does not.
    Odd,
}

/// A disc somewhere in a cell of four by four, of which many are in a row.
fn disc(cell: usize, kind: Kind) -> impl Strategy<Value = DiscBuilder> {
    let numbers = ([0.0..1.0_f64, 0.0..1.0_f64], [-1.0..1.0_f64, -1.0..1.0_f64]);
    (numbers, 0.0..1.0_f64).prop_map(move |((place, velocity), size)| {
        let radius = match kind {
            Kind::Mixed => 1.5 * 100_f64.powf(-size),
            Kind::Alike | Kind::Odd => 1.0,
        };
        let [column, row] = [cell % 7, cell / 7].map(|index| index as f64 * 4.0 + 1.5);
        let position = [column + place[0], row + place[1]];
        let disc = |radius, velocity: [f64; 2]| Disc::at(position, radius).velocity(velocity);
        match (kind, cell) {
            (Kind::Odd, 8) => disc(2.0, velocity).mass(7),
            (Kind::Odd, 10) => disc(1.0, velocity.map(|speed| 400.0 * speed)),
            (Kind::Odd, 12) => disc(1.0, velocity).infinite_mass(),
            (Kind::Odd, 22) => disc(1.0, [0.0; 2]).infinite_mass(),
            _ => disc(radius, velocity),
        }
    })
}

/// Some forty discs, in a box or in the open, with a few walls across.
fn scene(kind: Kind) -> impl Strategy<Value = Scene> {
    let discs: Vec<_> = (0..42).map(|cell| disc(cell, kind)).collect();
    let end = || [-10.0..40.0_f64, -10.0..40.0_f64];
    let walls = prop::collection::vec((end(), end()), 0..4);
    (discs, walls, any::<bool>(), [-1e4..1e4_f64, -1e4..1e4_f64]).prop_map(
        |(discs, walls, is_boxed, [x, y])| {
            let mut scene = Scene::builder("test").frame(20, 1);
            for disc in discs {
                scene = scene.disc(disc);
            }
            if is_boxed {
                scene = scene.walls_around([-0.5, -0.5], [30.0, 26.0]);
            }
            for (from, to) in walls {
                scene = scene.wall(from, to);
            }
            scene = scene.wall([x, y], [y - 1.0, x]);
            scene.build().expect("a valid scene")
        },
    )
}

/// What a block of sixteen by sixteen is filled with.
#[derive(Clone, Copy, Debug)]
enum Block {
    /// One disc.
    Large,
    /// Four by four.
    Small,
    /// Ten by ten.
    Tiny,
}

/// How the discs in blocks move.
#[derive(Clone, Copy, Debug)]
struct Traits {
    /// Large discs as fast as small ones; otherwise they are slow.
    is_wild: bool,
    /// Large discs are no longer deflected.
    is_firm: bool,
    /// Large discs may overlap what is about them at the start.
    overlaps: bool,
}

/// A disc somewhere in a cell, now and then a fast one.
fn disc_in(corner: [f64; 2], size: f64, traits: Traits) -> impl Strategy<Value = DiscBuilder> {
    let numbers = ([0.0..1.0_f64, 0.0..1.0_f64], [-1.0..1.0_f64, -1.0..1.0_f64]);
    (numbers, 0.5..1.0_f64, 0..200).prop_map(move |((place, velocity), part, chance)| {
        let is_large = size > 10.0;
        let grown = if is_large && traits.overlaps {
            1.3
        } else {
            0.45
        };
        let radius = grown * size * part;
        let free = (size / 2.0 - radius).max(0.0);
        let position = [0, 1].map(|axis| corner[axis] + size / 2.0 + free * (place[axis] - 0.5));
        let speed = match (is_large, chance) {
            (true, _) if !traits.is_wild => 1.0 / 16.0,
            (_, 0) => 300.0,
            _ => 1.0,
        };
        let disc = Disc::at(position, radius).mass(size * size);
        match is_large && traits.is_firm {
            true => disc.infinite_mass(),
            false => disc.velocity(velocity.map(|component| component * speed)),
        }
    })
}

/// A few hundred discs of three sizes, the largest some twenty times as large as
/// the smallest, in a box or in the open, and some walls.
fn sizes() -> impl Strategy<Value = SceneBuilder> {
    let block = prop::sample::select(vec![Block::Large, Block::Small, Block::Tiny]);
    let traits = [any::<bool>(), any::<bool>(), any::<bool>()];
    let traits = traits.prop_map(|[is_wild, is_firm, overlaps]| Traits {
        is_wild,
        is_firm,
        overlaps,
    });
    let end = || [-10.0..60.0_f64, -10.0..60.0_f64];
    let walls = prop::collection::vec((end(), end()), 0..4);
    (prop::collection::vec(block, 9), traits).prop_flat_map(move |(blocks, traits)| {
        let discs = blocks.into_iter().enumerate().flat_map(|(place, block)| {
            let corner = [place % 3, place / 3].map(|index| 16.0 * index as f64);
            discs_of(corner, block, traits)
        });
        let discs: Vec<_> = discs.collect();
        (discs, walls.clone(), any::<bool>()).prop_map(|(discs, walls, is_boxed)| {
            let mut scene = Scene::builder("test").frame(20, 1).discs(discs);
            if is_boxed {
                scene = scene.walls_around([-1.0, -1.0], [49.0, 49.0]);
            }
            walls
                .into_iter()
                .fold(scene, |scene, (from, to)| scene.wall(from, to))
        })
    })
}

fn discs_of(
    [x, y]: [f64; 2],
    block: Block,
    traits: Traits,
) -> Vec<impl Strategy<Value = DiscBuilder>> {
    let rows = match block {
        Block::Large => 1,
        Block::Small => 4,
        Block::Tiny => 10,
    };
    let size = 16.0 / f64::from(rows);
    let cells = (0..rows).flat_map(|row| (0..rows).map(move |column| [column, row]));
    let corners =
        cells.map(|[column, row]| [x + f64::from(column) * size, y + f64::from(row) * size]);
    corners
        .map(|corner| disc_in(corner, size, traits))
        .collect()
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn discs_alike(scene in scene(Kind::Alike)) {
        assert_same::<f64>(&scene);
        assert_same::<Filtered>(&scene);
    }

    #[test]
    fn mixed_radii(scene in scene(Kind::Mixed)) {
        assert_same::<f64>(&scene);
        assert_same::<Filtered>(&scene);
    }

    #[test]
    fn odd_discs(scene in scene(Kind::Odd)) {
        assert_same::<f64>(&scene);
        assert_same::<Filtered>(&scene);
    }
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn many_sizes(scene in sizes()) {
        let scene = scene.build().expect("a valid scene");
        assert_same::<f64>(&scene);
        assert_same::<Filtered>(&scene);
    }

    #[test]
    fn many_sizes_that_fall(scene in sizes()) {
        let scene = scene.gravity([0.5, -2.0]).build().expect("a valid scene");
        assert_same::<f64>(&scene);
        assert_same::<Filtered>(&scene);
    }

    #[test]
    fn many_sizes_that_lose_energy(scene in sizes(), drag in any::<bool>()) {
        let scene = scene.restitution(Restitution::newton("9/10".parse::<Number>().unwrap()));
        let scene = if drag { scene.linear_drag("1/8") } else { scene };
        let scene = scene.build().expect("a valid scene");
        assert_same::<f64>(&scene);
        assert_same::<Filtered>(&scene);
    }
}

proptest! {
    #![proptest_config(cases(2))]

    #[test]
    fn many_sizes_exactly(scene in sizes(), falls in any::<bool>()) {
        let scene = if falls { scene.gravity([0, -1]) } else { scene };
        assert_same::<Exact>(&scene.build().expect("a valid scene"));
    }
}

proptest! {
    #![proptest_config(cases(6))]

    #[test]
    fn exactly(scene in prop_oneof![scene(Kind::Alike), scene(Kind::Mixed), scene(Kind::Odd)]) {
        assert_same::<Exact>(&scene);
    }
}

/// Discs that fly apart for ever end the run at once, however long it lasts.
#[test]
fn the_open_has_an_end() {
    let mut scene = Scene::builder("test").frame("1e30", 1);
    for index in 0..40 {
        let place = f64::from(index) * 3.0;
        scene = scene.disc(Disc::at([place, 0.0], 1).velocity([place, 1.0]));
    }
    let outcome = run::<f64>(&scene.build().unwrap(), BroadPhase::Grid);
    assert_eq!(
        (outcome.impacts.len(), outcome.status),
        (0, Status::Complete)
    );
}
