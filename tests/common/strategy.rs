//! Random scenes, on lattices where numbers are exact: dyadic ones, so that
//! binary64 starts from the very same scene, or fractions on a line.

use carom::scalar::Number;
use carom::scene::{Disc, DiscBuilder, Restitution, Scene};
use num_rational::BigRational;
use proptest::prelude::*;
use proptest::sample::subsequence;
use proptest::test_runner::RngSeed;

use super::lasting;

/// So many cases, the same ones in every run: a law that fails must fail
/// again.
pub(crate) fn cases(count: u32) -> ProptestConfig {
    ProptestConfig {
        cases: count,
        rng_seed: RngSeed::Fixed(2002),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

/// Coordinates are multiples of this: fine enough that impacts are not
/// simultaneous by chance.
const GRAIN: f64 = 1.0 / 1024.0;

/// The box is so many cells wide and high.
const CELLS: usize = 3;

/// Each cell holds a disc, with its whole jitter, or a wall.
const CELL: f64 = 4.0;

/// A multiple of [`GRAIN`] between the two.
pub(crate) fn within(low: f64, high: f64) -> impl Strategy<Value = f64> {
    let [low, high] = [low, high].map(|end| (end / GRAIN) as i32);
    (low..=high).prop_map(|steps| f64::from(steps) * GRAIN)
}

pub(crate) fn vector(bound: f64) -> impl Strategy<Value = [f64; 2]> {
    [within(-bound, bound), within(-bound, bound)]
}

/// How heavy the discs of a scene are.
#[derive(Clone, Copy)]
pub(crate) enum Masses {
    /// All finite.
    Finite,
    /// Some are infinite. Those are at rest: one that moves would drive what
    /// is between it and a wall to infinitely many impacts.
    Any,
}

/// A disc that lies within its cell, given by its index.
fn disc(cell: usize, masses: Masses) -> impl Strategy<Value = DiscBuilder> {
    let infinite = match masses {
        Masses::Finite => 0.0,
        Masses::Any => 0.2,
    };
    let (mass, infinite) = (within(0.25, 4.0), prop::bool::weighted(infinite));
    let numbers = (within(0.5, 1.25), vector(0.7), vector(3.0), mass, infinite);
    numbers.prop_map(move |(radius, jitter, velocity, mass, infinite)| {
        let [x, y] = centre(cell);
        let disc = Disc::at([x + jitter[0], y + jitter[1]], radius);
        if infinite {
            disc.infinite_mass()
        } else {
            disc.velocity(velocity).mass(mass)
        }
    })
}

/// The middle of a cell.
fn centre(cell: usize) -> [f64; 2] {
    [cell % CELLS, cell / CELLS].map(|index| (index as f64 + 0.5) * CELL)
}

/// Two oblique walls that meet in a point, or a single one: all of it within
/// its cell, with end points in the open.
fn obstacle(cell: usize) -> impl Strategy<Value = Vec<[[f64; 2]; 2]>> {
    let bent = [vector(1.5), vector(1.5), vector(1.5)];
    (bent, any::<bool>()).prop_filter_map("a wall has a length", move |(points, is_bent)| {
        let [x, y] = centre(cell);
        let [one, two, three] = points.map(|[dx, dy]| [x + dx, y + dy]);
        let walls = vec![[one, two], [three, two]];
        let whole = walls.iter().all(|[from, to]| from != to);
        whole.then(|| walls.into_iter().take(1 + usize::from(is_bent)).collect())
    })
}

/// What impacts lose: nothing, or by Newton's coefficients.
fn losses() -> impl Strategy<Value = Restitution> {
    let quarters = || (2..=4).prop_map(|quarters| number(f64::from(quarters) / 4.0));
    let lossy = (quarters(), prop::option::of(quarters())).prop_map(|(coefficient, walls)| {
        Restitution::Newton {
            coefficient,
            walls,
            elastic_below: None,
        }
    });
    prop_oneof![Just(Restitution::Elastic), lossy]
}

fn number(value: f64) -> Number {
    Number::try_from(value).expect("a finite number")
}

/// A box with 3 to 5 discs, and up to 4 cells with walls in the open.
pub(crate) fn boxed(masses: Masses) -> impl Strategy<Value = Scene> {
    let all: Vec<usize> = (0..CELLS * CELLS).collect();
    let cells = subsequence(all, 3..=7).prop_shuffle();
    (cells, 3..=5_usize)
        .prop_flat_map(move |(cells, discs)| {
            let (discs, walls) = cells.split_at(discs.min(cells.len()));
            let discs: Vec<_> = discs.iter().map(|&cell| disc(cell, masses)).collect();
            let walls: Vec<_> = walls.iter().map(|&cell| obstacle(cell)).collect();
            (discs, walls)
        })
        .prop_map(|(discs, walls)| {
            let side = CELLS as f64 * CELL;
            let scene = lasting("4").discs(discs).walls_around([0.0; 2], [side; 2]);
            let walls = walls.into_iter().flatten();
            let scene = walls.fold(scene, |scene, [from, to]| scene.wall(from, to));
            scene.build().expect("a valid scene")
        })
}

/// A single disc among walls.
pub(crate) fn lonely() -> impl Strategy<Value = Scene> {
    boxed(Masses::Finite).prop_map(|scene| {
        let first = scene.discs()[0].clone();
        let scene = scene.to_builder().without_discs().disc(first);
        scene.build().expect("a valid scene")
    })
}

/// A box in which impacts may lose energy.
pub(crate) fn lossy() -> impl Strategy<Value = Scene> {
    (boxed(Masses::Any), losses()).prop_map(|(scene, restitution)| {
        let scene = scene.to_builder().restitution(restitution);
        scene.build().expect("a valid scene")
    })
}

/// Two discs in the open that fly towards each other, of which one may be of
/// infinite mass.
pub(crate) fn couple() -> impl Strategy<Value = Scene> {
    (crowd(), 0..=2_usize).prop_map(|(mut discs, infinite)| {
        discs.truncate(2);
        if let Some(disc) = discs.get_mut(infinite) {
            *disc = disc.clone().infinite_mass();
        }
        lasting("6").discs(discs).build().expect("a valid scene")
    })
}

/// Discs in the open that fly towards each other.
pub(crate) fn cluster() -> impl Strategy<Value = Scene> {
    crowd().prop_map(|discs| lasting("6").discs(discs).build().expect("a valid scene"))
}

/// The same with one of infinite mass among them, anywhere in the order: two
/// could drive what is between them to infinitely many impacts.
pub(crate) fn cluster_with_piston() -> impl Strategy<Value = Scene> {
    let crowd = (crowd(), any::<prop::sample::Index>());
    crowd.prop_map(|(mut discs, piston)| {
        let piston = piston.get_mut(&mut discs);
        *piston = piston.clone().infinite_mass();
        lasting("6").discs(discs).build().expect("a valid scene")
    })
}

fn crowd() -> impl Strategy<Value = Vec<DiscBuilder>> {
    let all: Vec<usize> = (0..CELLS * CELLS).collect();
    let cells = subsequence(all, 3..=6).prop_shuffle();
    cells.prop_flat_map(|cells| {
        let cells = cells.into_iter();
        cells.map(inwards).collect::<Vec<_>>()
    })
}

/// A disc that flies to somewhere near the middle.
fn inwards(cell: usize) -> impl Strategy<Value = DiscBuilder> {
    let [x, y] = centre(cell);
    let middle = CELLS as f64 * CELL / 2.0;
    (disc(cell, Masses::Finite), vector(0.5)).prop_map(move |(disc, jitter)| {
        let velocity = [middle - x, middle - y].map(|way| way / 2.0);
        disc.velocity([velocity[0] + jitter[0], velocity[1] + jitter[1]])
    })
}

/// A row of discs on the x axis between two walls: every impact is rational.
#[derive(Clone, Debug)]
pub(crate) struct Chain {
    /// Mass, radius, position and velocity of each disc, in their order.
    pub(crate) discs: Vec<Bead>,
    /// Where the walls are.
    pub(crate) walls: [BigRational; 2],
}

/// A disc of a [`Chain`].
#[derive(Clone, Debug)]
pub(crate) struct Bead {
    pub(crate) mass: BigRational,
    pub(crate) radius: BigRational,
    pub(crate) position: BigRational,
    pub(crate) velocity: BigRational,
}

/// A chain whose numbers are fractions with this denominator. With 1 there
/// are ties at every turn, with 97 hardly any. Not all of it may touch, or it
/// would rattle for ever.
pub(crate) fn chain(denominator: i64) -> impl Strategy<Value = Chain> {
    let part = move |range: std::ops::RangeInclusive<i64>| {
        let steps = range.start() * denominator..=range.end() * denominator;
        steps.prop_map(move |steps| BigRational::new(steps.into(), denominator.into()))
    };
    let bead = (part(1..=3), part(1..=2), part(0..=3), part(-3..=3));
    (prop::collection::vec(bead, 2..=4), part(1..=2)).prop_map(|(beads, gap)| {
        let mut end = BigRational::from_integer(0.into());
        let place = |(mass, radius, gap, velocity): (_, BigRational, BigRational, _)| {
            let position = &end + gap + &radius;
            end = &position + &radius;
            Bead {
                mass,
                radius,
                position,
                velocity,
            }
        };
        let discs = beads.into_iter().map(place).collect();
        let walls = [BigRational::from_integer(0.into()), end + gap];
        Chain { discs, walls }
    })
}

impl Chain {
    /// The chain as a scene that lasts so long.
    pub(crate) fn scene(&self, duration: &BigRational) -> Scene {
        let number = |value: &BigRational| Number::try_from(value.clone()).unwrap();
        let zero = || Number::from(0);
        let discs = self.discs.iter().map(|bead| {
            Disc::at([number(&bead.position), zero()], number(&bead.radius))
                .velocity([number(&bead.velocity), zero()])
                .mass(number(&bead.mass))
        });
        let scene = Scene::builder("chain")
            .frame(number(duration), 1)
            .discs(discs);
        let walls = self.walls.iter().map(number);
        let scene = walls.fold(scene, |scene, x| {
            scene.wall((x.clone(), -9), (x, Number::from(9)))
        });
        scene.build().expect("a valid scene")
    }
}
