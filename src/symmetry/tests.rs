use std::collections::BTreeSet;

use num_rational::BigRational;
use proptest::prelude::*;

use super::*;
use crate::scalar::Number;
use crate::scene::{Disc, SceneBuilder};

type Written = [&'static str; 2];

fn number(text: &str) -> BigRational {
    text.parse::<Number>().unwrap().to_rational()
}

/// Discs of radius 1 with these positions and velocities.
fn scene(discs: &[(Written, Written)]) -> SceneBuilder {
    let discs = discs.iter();
    Scene::builder("test")
        .discs(discs.map(|(position, velocity)| Disc::at(*position, 1).velocity(*velocity)))
}

fn of(scene: SceneBuilder) -> Vec<Symmetry> {
    symmetries(&scene.build().unwrap())
}

/// What becomes of the discs.
fn discs(scene: SceneBuilder) -> BTreeSet<Vec<u32>> {
    let found = of(scene);
    let images: BTreeSet<_> = found.iter().map(|found| found.discs.clone()).collect();
    assert_eq!(images.len(), found.len(), "each once");
    images
}

fn set<const N: usize>(images: impl IntoIterator<Item = [u32; N]>) -> BTreeSet<Vec<u32>> {
    images.into_iter().map(Vec::from).collect()
}

/// Right, upper, left and lower disc.
const IMPLODING: [(Written, Written); 4] = [
    (["5", "0"], ["-1", "0"]),
    (["0", "5"], ["0", "-1"]),
    (["-5", "0"], ["1", "0"]),
    (["0", "-5"], ["0", "1"]),
];

/// The symmetries of the square: turns, and mirrors in its four axes.
const SQUARE: [[u32; 4]; 7] = [
    [1, 2, 3, 0],
    [2, 3, 0, 1],
    [3, 0, 1, 2],
    [0, 3, 2, 1],
    [2, 1, 0, 3],
    [1, 0, 3, 2],
    [3, 2, 1, 0],
];

const CUE: [(Written, Written); 3] = [
    (["-4", "0"], ["1", "0"]),
    (["0", "1"], ["0", "0"]),
    (["0", "-1"], ["0", "0"]),
];

/// The scene somewhere else, turned by the angle of the triangle 3-4-5.
fn elsewhere(scene: &Scene) -> SceneBuilder {
    let [cos, sin] = [number("3/5"), number("4/5")];
    let turned = |[x, y]: [BigRational; 2]| [&cos * &x - &sin * &y, &sin * &x + &cos * &y];
    let place = |at: &[Number; 2]| {
        let [x, y] = turned(at.each_ref().map(Number::to_rational));
        written([x + number("10/3"), y + number("10/3")])
    };
    let discs = scene.discs().iter().map(|disc| crate::scene::Disc {
        position: place(&disc.position),
        velocity: written(turned(disc.velocity.each_ref().map(Number::to_rational))),
        ..disc.clone()
    });
    let moved = Scene::builder("elsewhere").discs(discs);
    scene.walls().iter().fold(moved, |moved, wall| {
        moved.wall(place(&wall.from), place(&wall.to))
    })
}

fn written(vector: [BigRational; 2]) -> [Number; 2] {
    vector.map(|value| value.try_into().unwrap())
}

#[test]
fn a_square_implodes() {
    assert_eq!(discs(scene(&IMPLODING)), set(SQUARE));
    let moved = elsewhere(&scene(&IMPLODING).build().unwrap());
    assert_eq!(discs(moved), set(SQUARE));
}

#[test]
fn a_cue_and_two_discs_have_one_mirror() {
    assert_eq!(discs(scene(&CUE)), set([[0, 2, 1]]));
    let moved = elsewhere(&scene(&CUE).build().unwrap());
    assert_eq!(discs(moved), set([[0, 2, 1]]));
}

#[test]
fn a_pair_is_mirrored_or_turned() {
    let pair = |velocity| scene(&[(["-3", "0"], ["1", "1"]), (["3", "0"], velocity)]);
    assert_eq!(discs(pair(["-1", "1"])), set([[1, 0]]));
    assert_eq!(discs(pair(["-1", "-1"])), set([[1, 0]]));
    assert_eq!(discs(pair(["1", "1"])), set::<2>([]));
}

#[test]
fn a_swirl_turns_but_has_no_mirror() {
    let swirl = [
        (["5", "0"], ["0", "1"]),
        (["0", "5"], ["-1", "0"]),
        (["-5", "0"], ["0", "-1"]),
        (["0", "-5"], ["1", "0"]),
    ];
    assert_eq!(discs(scene(&swirl)), set([SQUARE[0], SQUARE[1], SQUARE[2]]));
}

#[test]
fn a_rhombus_has_two_mirrors() {
    let rhombus = ["4", "3", "-4", "-3"].map(|at| (at, ["0", "0"]));
    let rhombus: Vec<_> = (0..)
        .zip(rhombus)
        .map(|(index, (at, rest))| (if index % 2 == 0 { [at, "0"] } else { ["0", at] }, rest))
        .collect();
    assert_eq!(
        discs(scene(&rhombus)),
        set([SQUARE[1], SQUARE[3], SQUARE[4]])
    );
}

#[test]
fn points_on_a_circle() {
    let at = |x: i32, y: i32| Disc::at([x, y], 1).velocity([-x, -y]);
    let ring = [(3, 4), (4, 3)]
        .into_iter()
        .flat_map(|(x, y)| [(x, y), (-x, y), (x, -y), (-x, -y)].map(|(x, y)| at(x, y)));
    assert_eq!(of(Scene::builder("ring").discs(ring)).len(), 7);
}

#[test]
fn a_little_breaks_a_symmetry() {
    let square = scene(&IMPLODING).build().unwrap();
    let broken = |change: &dyn Fn(&mut Disc)| {
        let mut discs = square.discs().to_vec();
        change(&mut discs[0]);
        discs_of(discs)
    };
    let [more, less] = ["0x1p-60", "-0x1p-60"].map(number);
    // What stays along the axis of d0 leaves the mirror in that axis.
    let axis = set([SQUARE[3]]);
    assert_eq!(
        broken(&|disc| disc.velocity[0] = (number("-1") + &more).try_into().unwrap()),
        axis
    );
    assert_eq!(
        broken(&|disc| disc.velocity[1] = less.clone().try_into().unwrap()),
        set::<4>([])
    );
    assert_eq!(
        broken(&|disc| disc.position[0] = (number("5") + &more).try_into().unwrap()),
        axis
    );
    assert_eq!(
        broken(&|disc| disc.position[1] = more.clone().try_into().unwrap()),
        set::<4>([])
    );
    assert_eq!(
        broken(&|disc| disc.radius = (number("1") + &more).try_into().unwrap()),
        axis
    );
    assert_eq!(
        broken(&|disc| disc.mass = crate::scene::Mass::Infinite),
        axis
    );
}

fn discs_of(all: Vec<Disc>) -> BTreeSet<Vec<u32>> {
    discs(Scene::builder("test").discs(all))
}

#[test]
fn numbers_count_and_not_how_they_are_written() {
    let pair = Scene::builder("pair")
        .disc(Disc::at([0.5, 0.0], 0.25).mass("2"))
        .disc(Disc::at(["-1/2", "0"], "0.25").mass(2));
    assert_eq!(discs(pair), set([[1, 0]]));
    let tenths = Scene::builder("tenths")
        .disc(Disc::at([1, 0], 0.1))
        .disc(Disc::at([-1, 0], "0.1"));
    assert_eq!(discs(tenths), set::<2>([]));
}

#[test]
fn walls_go_with_the_discs() {
    let boxed = scene(&IMPLODING).walls_around([-9, -9], [9, 9]);
    let found = of(boxed);
    assert_eq!(found.len(), 7);
    // Lower, right, upper and left wall; a quarter turn of discs and walls.
    let turn = found
        .iter()
        .find(|found| found.discs == [1, 2, 3, 0])
        .unwrap();
    assert_eq!(turn.walls, [1, 2, 3, 0]);
    let oblong = scene(&IMPLODING).walls_around([-9, -8], [9, 8]);
    assert_eq!(discs(oblong), set([SQUARE[1], SQUARE[3], SQUARE[4]]));
    let open = scene(&IMPLODING).wall([-9, -9], [9, -9]);
    assert_eq!(discs(open), set([SQUARE[4]]));
    let askew = scene(&IMPLODING).wall([-9, -9], [10, -9]);
    assert_eq!(discs(askew), set::<4>([]));
}

/// Along the bisector of a corner: the disc stays, the walls change places.
#[test]
fn a_disc_goes_into_a_corner() {
    let corner = |velocity: Written| {
        scene(&[(["2", "1"], velocity)])
            .wall([0, 0], [5, 0])
            .wall([3, 4], [0, 0])
    };
    let mirror = Symmetry {
        discs: vec![0],
        walls: vec![1, 0],
    };
    for velocity in [["-2", "-1"], ["0", "0"]] {
        assert_eq!(of(corner(velocity)), std::slice::from_ref(&mirror));
    }
    assert_eq!(of(corner(["-2", "-1.01"])), []);
}

#[test]
fn gravity_has_to_go_with_it() {
    let at_rest = IMPLODING.map(|(position, _)| (position, ["0", "0"]));
    assert_eq!(discs(scene(&at_rest)), set(SQUARE));
    let falling = scene(&at_rest).gravity([0, -1]);
    assert_eq!(discs(falling), set([SQUARE[4]]));
    let falling = scene(&at_rest).gravity(["1", "1/3"]);
    assert_eq!(discs(falling), set::<4>([]));
    assert_eq!(
        discs(scene(&at_rest).gravity([0, 0]).linear_drag(1)),
        set(SQUARE)
    );
}

#[test]
fn what_is_not_proven_is_not_told() {
    assert_eq!(of(scene(&IMPLODING).periodic([-9, -9], [9, 9])), []);
    assert_eq!(of(scene(&[])), []);
    assert_eq!(of(scene(&[]).wall([0, 0], [1, 0])), []);
    assert_eq!(of(scene(&IMPLODING[..1])), []);
    // Concentric: any mirror in the line of motion, but no body is moved.
    assert_eq!(
        of(scene(&[
            (["0", "0"], ["1", "0"]),
            (["0", "0"], ["-1", "0"])
        ])),
        []
    );
}

#[test]
fn discs_alike_in_one_place_take_turns() {
    let pair = [IMPLODING[0], IMPLODING[0], IMPLODING[2], IMPLODING[2]];
    assert_eq!(discs(scene(&pair)), set([[2, 3, 0, 1]]));
}

#[test]
fn a_centre_too_long_to_write_is_given_up() {
    let denominators = [[3_u32, 700], [5, 500], [7, 400]]
        .map(|[base, power]| num_bigint::BigInt::from(base).pow(power));
    let ring = denominators.into_iter().flat_map(|denominator| {
        let x = BigRational::new(denominator.clone() + 1, denominator);
        [x.clone(), -x].map(|x| Disc::at([Number::try_from(x).unwrap(), Number::from(0)], 1))
    });
    assert_eq!(of(Scene::builder("long").discs(ring)), []);
}

/// A body as the oracle sees it: a sort, a position and a velocity.
type Mark = (u32, [i64; 2], [i64; 2]);

fn product(a: [i64; 2], b: [i64; 2]) -> i64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Whether an isometry takes the marks to their images: it does if and only
/// if all distances, and all products of velocities with each other and with
/// differences of positions, are the same.
fn is_isometric(marks: &[Mark], images: &[Mark]) -> bool {
    let vectors = |marks: &[Mark]| -> Vec<[i64; 2]> {
        let origin = marks[0].1;
        let arm = |at: [i64; 2]| [at[0] - origin[0], at[1] - origin[1]];
        marks
            .iter()
            .flat_map(|(_, at, velocity)| [arm(*at), *velocity])
            .collect()
    };
    let [before, after] = [vectors(marks), vectors(images)];
    let sorts = marks
        .iter()
        .zip(images)
        .all(|(mark, image)| mark.0 == image.0);
    sorts
        && (0..before.len())
            .all(|i| (0..=i).all(|j| product(before[i], before[j]) == product(after[i], after[j])))
}

fn permutations(count: usize) -> Vec<Vec<u32>> {
    let Some(last) = count.checked_sub(1) else {
        return vec![Vec::new()];
    };
    let shorter = permutations(last).into_iter();
    shorter
        .flat_map(|shorter| {
            (0..count).map(move |place| {
                let mut longer = shorter.clone();
                longer.insert(place, last as u32);
                longer
            })
        })
        .collect()
}

/// Every permutation of the bodies that keeps all distances.
fn by_trial(discs: &[Mark], walls: &[[[i64; 2]; 2]]) -> BTreeSet<(Vec<u32>, Vec<u32>)> {
    let end = |at| (u32::MAX, at, [0, 0]);
    let marks = |discs: Vec<Mark>, ends: Vec<[i64; 2]>| -> Vec<Mark> {
        discs.into_iter().chain(ends.into_iter().map(end)).collect()
    };
    let before = marks(discs.to_vec(), walls.concat());
    let mut found = BTreeSet::new();
    for disc_images in permutations(discs.len()) {
        for wall_images in permutations(walls.len()) {
            for flips in 0..1_u32 << walls.len() {
                let moved = disc_images
                    .iter()
                    .map(|image| discs[*image as usize])
                    .collect();
                let ends = wall_images.iter().enumerate().flat_map(|(place, image)| {
                    let mut ends = walls[*image as usize];
                    if flips >> place & 1 == 1 {
                        ends.reverse();
                    }
                    ends
                });
                if is_isometric(&before, &marks(moved, ends.collect())) {
                    found.insert((disc_images.clone(), wall_images.clone()));
                }
            }
        }
    }
    found
}

fn grid_point() -> impl Strategy<Value = [i64; 2]> {
    prop::array::uniform2(-1..=1_i64)
}

/// Different places; walls of different places too.
fn marks(most: usize) -> impl Strategy<Value = Vec<Mark>> {
    let velocities = prop_oneof![Just([0, 0]), grid_point()];
    let mark = (1..3_u32, grid_point(), velocities);
    prop::collection::vec(mark, 1..=most).prop_map(|mut marks| {
        marks.sort_unstable_by_key(|mark| mark.1);
        marks.dedup_by_key(|mark| mark.1);
        marks
    })
}

fn walls() -> impl Strategy<Value = Vec<[[i64; 2]; 2]>> {
    let wall = (grid_point(), grid_point()).prop_filter_map("no point", |(from, to)| {
        (from != to).then(|| [from.min(to), from.max(to)])
    });
    prop::collection::btree_set(wall, 0..4).prop_map(|walls| walls.into_iter().collect())
}

fn assert_as_by_trial(marks: &[Mark], walls: &[[[i64; 2]; 2]]) -> Result<(), TestCaseError> {
    let discs = marks.iter().map(|(sort, position, velocity)| {
        Disc::at(*position, i64::from(*sort)).velocity(*velocity)
    });
    let scene = Scene::builder("trial").discs(discs);
    let scene = walls
        .iter()
        .fold(scene, |scene, [from, to]| scene.wall(*from, *to));
    let found: Vec<_> = of(scene)
        .into_iter()
        .map(|found| (found.discs, found.walls))
        .collect();
    let mut expected = by_trial(marks, walls);
    let identity = |count| (0..count as u32).collect::<Vec<_>>();
    prop_assert!(expected.remove(&(identity(marks.len()), identity(walls.len()))));
    prop_assert_eq!(found.len(), expected.len());
    prop_assert_eq!(found.into_iter().collect::<BTreeSet<_>>(), expected);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn discs_alone_as_by_trial(marks in marks(5)) {
        assert_as_by_trial(&marks, &[])?;
    }

    #[test]
    fn discs_and_walls_as_by_trial(marks in marks(3), walls in walls()) {
        assert_as_by_trial(&marks, &walls)?;
    }
}
