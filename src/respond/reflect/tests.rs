//! What is expected is worked out by hand, in line or in the plane; laws are
//! checked in rationals, apart from the code under test.

use num_rational::BigRational;
use num_traits::Zero;
use proptest::prelude::*;

use super::*;
use crate::scalar::{Exact, Number};

type Contact = ClusterContact<Exact>;
type Vector = [BigRational; 2];

fn number<S: Scalar<Precision = P>, P: Default>(text: &str) -> S {
    let number: Number = text.parse().unwrap();
    S::from_number(&number, P::default())
}

fn vector<S: Scalar<Precision = P>, P: Default>([x, y]: [&str; 2]) -> Vec2<S> {
    Vec2::new(number(x), number(y))
}

/// Responses look at neither positions nor radii.
fn disc<S: Scalar<Precision = P>, P: Default>(velocity: [&str; 2], mass: &str) -> Disc<S> {
    Disc {
        position: Vec2::zero(),
        velocity: vector(velocity),
        radius: S::from_integer(1),
        mass: match mass {
            "infinite" => Mass::Infinite,
            mass => Mass::Finite(number(mass)),
        },
        last: None,
    }
}

fn contact<S: Scalar<Precision = P>, P: Default>(
    first: usize,
    second: impl Into<Option<usize>>,
    normal: [&str; 2],
) -> ClusterContact<S> {
    ClusterContact {
        first,
        second: second.into(),
        normal: Normal::at_overlap(vector(normal)),
    }
}

fn rational(value: &Exact) -> BigRational {
    let (lo, hi) = value.enclosure().expect("a number");
    assert_eq!(lo, hi, "a rational");
    lo
}

fn plain(vector: &Vec2<Exact>) -> Vector {
    [rational(&vector.x), rational(&vector.y)]
}

fn all_velocities(discs: &[Disc<Exact>]) -> Vec<Vector> {
    discs.iter().map(|disc| plain(&disc.velocity)).collect()
}

#[track_caller]
fn assert_velocities(discs: &[Disc<Exact>], expected: &[[&str; 2]]) {
    let expected: Vec<_> = expected.iter().map(|&pair| plain(&vector(pair))).collect();
    assert_eq!(all_velocities(discs), expected);
}

/// A row of touching discs with these velocities along it, after the impact.
fn row(speeds: &[&str], masses: &[&str], restitution: &Restitution<Exact>) -> Vec<String> {
    let discs = speeds.iter().zip(masses);
    let mut discs: Vec<_> = discs
        .map(|(speed, mass)| disc([speed, "0"], mass))
        .collect();
    let contacts: Vec<Contact> = (1..discs.len())
        .map(|index| contact(index - 1, index, ["2", "0"]))
        .collect();
    let reflection = reflect_cluster(&mut discs, &contacts, restitution).unwrap();
    assert!(matches!(reflection, Reflection::Parted(_)));
    let velocities = all_velocities(&discs);
    velocities
        .iter()
        .map(|[speed, _]| speed.to_string())
        .collect()
}

fn equal_row(speeds: &[&str], restitution: &Restitution<Exact>) -> Vec<String> {
    row(speeds, &vec!["1"; speeds.len()], restitution)
}

fn newton(coefficient: &str) -> Restitution<Exact> {
    Restitution::Newton {
        discs: number(coefficient),
        walls: number(coefficient),
        elastic_below: None,
    }
}

#[test]
fn a_cradle_lets_out_as_many_as_come_in() {
    let elastic = |speeds: &[&str]| equal_row(speeds, &Restitution::Elastic);
    assert_eq!(
        elastic(&["1", "0", "0", "0", "0"]),
        ["0", "0", "0", "0", "1"]
    );
    assert_eq!(
        elastic(&["1", "1", "0", "0", "0"]),
        ["0", "0", "0", "1", "1"]
    );
    assert_eq!(
        elastic(&["1", "0", "0", "0", "-1"]),
        ["-1", "0", "0", "0", "1"]
    );
}

/// Both contacts of the middle disc press, so that p is the common velocity.
#[test]
fn what_comes_from_both_sides_goes_there() {
    let found = equal_row(&["2", "0", "-1"], &Restitution::Elastic);
    assert_eq!(found, ["-4/3", "2/3", "5/3"]);
    let found = row(&["1", "0", "-1"], &["1", "2", "3"], &Restitution::Elastic);
    assert_eq!(found, ["-5/3", "-2/3", "1/3"]);
}

#[test]
fn losses_blend_the_projection_and_the_reflection() {
    let speeds = ["1", "0", "0"];
    assert_eq!(equal_row(&speeds, &newton("0")), ["1/3", "1/3", "1/3"]);
    assert_eq!(equal_row(&speeds, &newton("1/2")), ["1/6", "1/6", "2/3"]);
    assert_eq!(equal_row(&speeds, &newton("1")), ["0", "0", "1"]);
}

#[test]
fn the_papers_loss_damps_each_disc_once() {
    let paper = Restitution::Paper {
        kept: number("1/2"),
    };
    // The last contact opens, and its second disc takes no part.
    let found = equal_row(&["1", "0", "0", "3"], &paper);
    assert_eq!(found, ["0", "0", "1/2", "3"]);
}

#[test]
fn the_least_coefficient_holds_for_the_cluster() {
    let restitution = Restitution::Newton {
        discs: number("1"),
        walls: number("0"),
        elastic_below: None,
    };
    // A disc strikes one that touches a wall: the wall keeps both.
    let mut discs: Vec<Disc<Exact>> = vec![disc(["1", "0"], "1"), disc(["0", "0"], "1")];
    let contacts = [contact(0, 1, ["2", "0"]), contact(1, None, ["1", "0"])];
    let struck = reflect_cluster(&mut discs, &contacts, &restitution).unwrap();
    assert_eq!(struck, Reflection::Parted(vec![0, 1]));
    assert_velocities(&discs, &[["0", "0"], ["0", "0"]]);
}

#[test]
fn slow_clusters_are_elastic() {
    let restitution = |limit| Restitution::Newton {
        discs: number("0"),
        walls: number("0"),
        elastic_below: Some(number(limit)),
    };
    let speeds = ["1", "0", "0"];
    assert_eq!(equal_row(&speeds, &restitution("2")), ["0", "0", "1"]);
    assert_eq!(equal_row(&speeds, &restitution("1")), ["1/3", "1/3", "1/3"]);
}

/// Cue into two discs with normals n = (c, ±s): both contacts close by c, the
/// response is 2 to itself and c² - s² to the other, so that λ = c/(2 + c² - s²)
/// and v₀ = 1 - 4 λ c, v₁ = 2 λ n.
#[test]
fn a_cue_strikes_two_discs_at_once() {
    let mut discs: Vec<Disc<Exact>> = vec![
        disc(["1", "0"], "1"),
        disc(["0", "0"], "1"),
        disc(["0", "0"], "1"),
    ];
    let contacts = [
        contact(0, 1, ["8/5", "6/5"]),
        contact(0, 2, ["8/5", "-6/5"]),
    ];
    let struck = reflect_cluster(&mut discs, &contacts, &Restitution::Elastic).unwrap();
    assert_eq!(struck, Reflection::Parted(vec![0, 1]));
    assert_velocities(
        &discs,
        &[["-7/57", "0"], ["32/57", "8/19"], ["32/57", "-8/19"]],
    );
}

/// The break of Chatterjee and Ruina: all three discs touch; c² = 3/4.
#[test]
fn the_symmetric_break_is_enclosed() {
    let number = |integer| Exact::from_number(&Number::from(integer), 128);
    let root = number(3).sqrt();
    let mut discs: Vec<Disc<Exact>> = vec![
        disc(["1", "0"], "1"),
        disc(["0", "0"], "1"),
        disc(["0", "0"], "1"),
    ];
    let struck = |second, y| ClusterContact {
        first: 0,
        second: Some(second),
        normal: Normal::at_contact(Vec2::new(root.clone(), number(y)), &number(2)),
    };
    let contacts = [struck(1, 1), struck(2, -1), contact(1, 2, ["0", "-2"])];
    let reflection = reflect_cluster(&mut discs, &contacts, &Restitution::Elastic).unwrap();
    assert_eq!(reflection, Reflection::Parted(vec![0, 1]));
    for (disc, fifths) in discs.iter().zip([-1, 3, 3]) {
        let (lo, hi) = disc.velocity.x.enclosure().unwrap();
        let expected = BigRational::new(fifths.into(), 5.into());
        assert!(lo <= expected && expected <= hi);
        assert!(hi - lo < BigRational::new(1.into(), (1_u64 << 60).into()));
    }
}

/// A cue disc, d0, at the tip of a triangle of five rows of discs of radius
/// 1: of each where it is, in steps from row to row and from disc to disc, and
/// its mirror image.
fn rack() -> Vec<([i32; 2], usize)> {
    let mut places = vec![([-1, 1], 0)];
    for row in 0..5 {
        let first = places.len();
        let place = |index: i32| ([row, 2 * index - row], first + (row - index) as usize);
        places.extend((0..=row).map(place));
    }
    places
}

/// The cue comes along the first disc's axis, and touches it; neighbours in
/// different rows touch, and in their row if `in_rows`.
fn rack_contacts<S: Scalar>(steps: [S; 2], in_rows: bool) -> Vec<ClusterContact<S>> {
    let places = rack();
    let across = |first: usize, second: usize| {
        let [[x1, y1], [x2, y2]] = [first, second].map(|disc| places[disc].0);
        let [x, y] = [x2 - x1, y2 - y1];
        let neighbours = [x, y.abs()] == [1, 1] || (in_rows && [x, y] == [0, 2]);
        neighbours.then(|| {
            let [step, half] = steps.clone();
            Vec2::new(step * S::from_integer(x), half * S::from_integer(y))
        })
    };
    let cue = Vec2::new(S::from_integer(2), S::from_integer(0));
    let pairs = (1..16).flat_map(|first| (first + 1..16).map(move |second| (first, second)));
    let pairs = pairs.filter_map(|(first, second)| Some((first, second, across(first, second)?)));
    [(0, 1, cue)]
        .into_iter()
        .chain(pairs)
        .map(|(first, second, direction)| ClusterContact {
            first,
            second: Some(second),
            normal: Normal::at_overlap(direction),
        })
        .collect()
}

fn rack_discs<S: Scalar<Precision = P>, P: Default>() -> Vec<Disc<S>> {
    let rest = (1..16).map(|_| disc(["0", "0"], "1"));
    [disc(["1", "0"], "1")].into_iter().chain(rest).collect()
}

#[test]
fn a_touching_rack_breaks_symmetrically() {
    let before = rack_discs::<Exact, u32>();
    let contacts = rack_contacts::<Exact>(["8/5", "6/5"].map(number), false);
    assert_eq!(contacts.len(), 21);
    let (after, _) = resolved(&before, &contacts, &Restitution::Elastic);
    assert_eq!(energy(&after), energy(&before));
    assert_eq!(momentum(&after), momentum(&before));
    assert_parted(&after, &contacts);
    for (disc, (_, image)) in after.iter().zip(rack()) {
        let [x, y] = plain(&disc.velocity);
        assert_eq!([x, -y], plain(&after[image].velocity));
    }
}

/// Equilateral, all neighbours touch: of 31 contacts in the plane, no more
/// than 29 can be independent.
#[test]
fn a_full_rack_breaks_in_binary64() {
    let mut discs = rack_discs::<f64, ()>();
    let contacts = rack_contacts([3_f64.sqrt(), 1.0], true);
    assert_eq!(contacts.len(), 31);
    let reflection = reflect_cluster(&mut discs, &contacts, &Restitution::Elastic).unwrap();
    assert!(matches!(reflection, Reflection::Parted(_)));
    let energy: f64 = discs.iter().map(|disc| disc.velocity.norm_squared()).sum();
    let pushed: f64 = discs.iter().map(|disc| disc.velocity.x).sum();
    assert!((energy - 1.0).abs() < 1e-12 && (pushed - 1.0).abs() < 1e-12);
    assert!(
        contacts
            .iter()
            .all(|contact| contact.closing(&discs) < 1e-12)
    );
    for (disc, (_, image)) in discs.iter().zip(rack()) {
        let across = disc.velocity.y + discs[image].velocity.y;
        let along = disc.velocity.x - discs[image].velocity.x;
        assert!(across.abs() < 1e-9 && along.abs() < 1e-9, "{disc:?}");
    }
}

fn against_walls(velocity: [&str; 2], normals: [[&str; 2]; 2]) -> (Vec<Disc<Exact>>, Reflection) {
    let mut discs = vec![disc(velocity, "3")];
    let contacts = normals.map(|normal| contact(0, None, normal));
    let reflection = reflect_cluster(&mut discs, &contacts, &Restitution::Elastic).unwrap();
    (discs, reflection)
}

#[test]
fn a_right_angle_reverses() {
    let (discs, reflection) = against_walls(["3", "-1/7"], [["5", "0"], ["0", "-1"]]);
    assert_eq!(reflection, Reflection::Parted(vec![0, 1]));
    assert_velocities(&discs, &[["-3", "1/7"]]);
}

/// Floor and slope: of (1, -1) both walls take a part; for (1, -1/2) the
/// slope's push alone lifts the disc from the floor.
#[test]
fn an_obtuse_wedge() {
    let walls = [["0", "-1"], ["4/5", "-3/5"]];
    let (discs, _) = against_walls(["1", "-1"], walls);
    assert_velocities(&discs, &[["-1", "1"]]);
    let (discs, reflection) = against_walls(["1", "-1/2"], walls);
    assert_velocities(&discs, &[["-19/25", "41/50"]]);
    assert_eq!(reflection, Reflection::Parted(vec![0, 1]));
}

/// In a wedge of the angle α = arccos 4/5 the disc comes in along the floor.
/// Unfolded, it goes straight on; after three reflections its direction is
/// that of 4α.
#[test]
fn an_acute_wedge_takes_three_rounds() {
    let (discs, _) = against_walls(["1", "0"], [["0", "-1"], ["4/5", "3/5"]]);
    assert_velocities(&discs, &[["-527/625", "336/625"]]);
}

#[test]
fn a_disc_without_play_is_jammed() {
    let (discs, reflection) = against_walls(["1/3", "2"], [["1", "0"], ["-1", "0"]]);
    assert_eq!(reflection, Reflection::Jammed);
    assert_velocities(&discs, &[["1/3", "2"]]);
    let (discs, reflection) = against_walls(["0", "2"], [["1", "0"], ["-1", "0"]]);
    assert_eq!(reflection, Reflection::Parted(vec![]));
    assert_velocities(&discs, &[["0", "2"]]);
}

#[test]
fn two_squeezed_discs_are_jammed() {
    let mut discs = vec![disc(["1", "0"], "1"), disc(["1/3", "0"], "2")];
    let contacts = [
        contact(0, 1, ["2", "0"]),
        contact(0, None, ["-1", "0"]),
        contact(1, None, ["1", "0"]),
    ];
    let reflection = reflect_cluster(&mut discs, &contacts, &Restitution::Elastic).unwrap();
    assert_eq!(reflection, Reflection::Jammed);
    assert_velocities(&discs, &[["1", "0"], ["1/3", "0"]]);
}

/// A disc of mass 100 strikes a light one that touches a wall: 31 impacts, of
/// which 16 are between the discs. Each of those, with the bounce before it,
/// turns (10 v, w) of the heavy and the light disc by 2α with tan α = 1/10.
#[test]
fn galperins_discs_touch() {
    let mut discs = vec![disc(["0", "0"], "1"), disc(["-1", "0"], "100")];
    let contacts = [contact(0, 1, ["2", "0"]), contact(0, None, ["-1", "0"])];
    let reflection = reflect_cluster(&mut discs, &contacts, &Restitution::Elastic).unwrap();
    assert_eq!(reflection, Reflection::Parted(vec![0, 1]));
    let part = |part: i32| BigRational::new(part.into(), 101.into());
    let zero = BigRational::zero();
    let turned = (0..16).fold([part(101), zero.clone()], |[x, y], _| {
        [&x * part(99) - &y * part(20), x * part(20) + y * part(99)]
    });
    let ten = BigRational::from_integer(10.into());
    let [light, heavy] = [&discs[0], &discs[1]].map(|disc| plain(&disc.velocity));
    assert_eq!(heavy, [-&turned[0], zero.clone()]);
    assert_eq!(light, [-ten * &turned[1], zero]);
}

#[test]
fn infinite_masses_are_not_deflected() {
    let elastic = Restitution::Elastic;
    // The row bounces off its last disc.
    let found = row(&["1", "0", "0"], &["1", "1", "infinite"], &elastic);
    assert_eq!(found, ["-1", "0", "0"]);
    // A moving one throws all others out at twice its speed.
    let found = row(&["1", "0", "0"], &["infinite", "1", "1"], &elastic);
    assert_eq!(found, ["1", "2", "2"]);
    let found = row(&["1", "0", "0"], &["infinite", "1", "1"], &newton("0"));
    assert_eq!(found, ["1", "1", "1"]);
}

#[test]
fn what_does_not_approach_is_left_alone() {
    let mut discs: Vec<Disc<Exact>> = vec![disc(["0", "5"], "1"), disc(["1", "0"], "1")];
    for contacts in [
        vec![contact(0, 1, ["2", "0"])],
        vec![contact(0, 1, ["2", "0"]), contact(0, None, ["-1", "0"])],
    ] {
        let struck = reflect_cluster(&mut discs, &contacts, &newton("1/2")).unwrap();
        assert_eq!(struck, Reflection::Parted(vec![]));
        assert_velocities(&discs, &[["0", "5"], ["1", "0"]]);
    }
}

/// Bit by bit, in both arithmetics.
#[test]
fn a_single_contact_is_an_impact_of_two() {
    single::<f64, ()>();
    single::<Exact, u32>();
}

fn single<S: Scalar<Precision = P>, P: Default>() {
    let restitutions: [Restitution<S>; 4] = [
        Restitution::Elastic,
        Restitution::Paper {
            kept: number("1/3"),
        },
        Restitution::Newton {
            discs: number("7/10"),
            walls: number("1/10"),
            elastic_below: None,
        },
        Restitution::Newton {
            discs: number("7/10"),
            walls: number("1/10"),
            elastic_below: Some(number("100")),
        },
    ];
    for restitution in &restitutions {
        for mass in ["3/7", "infinite"] {
            let discs: Vec<Disc<S>> = vec![disc(["1.3", "1/3"], "1.1"), disc(["-1/7", "-2"], mass)];
            let pair = contact(0, 1, ["0.3", "0.7"]);
            let [mut first, mut second] = [discs[0].clone(), discs[1].clone()];
            collide_discs(&mut first, &mut second, &pair.normal, restitution).unwrap();
            assert_same(discs.clone(), pair, restitution, &[first, second]);
        }
        let discs: Vec<Disc<S>> = vec![disc(["1.3", "1/3"], "1.1")];
        let wall = contact(0, None, ["0.3", "0.7"]);
        let mut alone = discs[0].clone();
        collide_wall(&mut alone, &wall.normal, restitution).unwrap();
        assert_same(discs, wall, restitution, &[alone]);
    }
}

fn assert_same<S: Scalar>(
    mut discs: Vec<Disc<S>>,
    contact: ClusterContact<S>,
    restitution: &Restitution<S>,
    expected: &[Disc<S>],
) {
    let struck = reflect_cluster(&mut discs, &[contact], restitution).unwrap();
    assert_eq!(struck, Reflection::Parted(vec![0]));
    assert_eq!(format!("{discs:?}"), format!("{expected:?}"));
}

/// Unit normals from Pythagorean triples, and their images.
const NORMALS: [[i32; 3]; 5] = [[1, 0, 1], [3, 4, 5], [5, 12, 13], [8, 15, 17], [7, 24, 25]];

fn normal() -> impl Strategy<Value = Normal<Exact>> {
    let signs = (any::<bool>(), any::<bool>(), any::<bool>());
    (0..NORMALS.len(), signs, 1..4).prop_map(|(index, (flip_x, flip_y, swap), scale)| {
        let [mut x, mut y, length] = NORMALS[index];
        if swap {
            (x, y) = (y, x);
        }
        let [x, y] = [(x, flip_x), (y, flip_y)].map(|(part, flip)| {
            let part = if flip { -part } else { part };
            Exact::from_integer(part * scale) / Exact::from_integer(length)
        });
        Normal::at_contact(Vec2::new(x, y), &Exact::from_integer(scale))
    })
}

fn body() -> impl Strategy<Value = Disc<Exact>> {
    (-4..5, -4..5, 1..5).prop_map(|(x, y, mass)| Disc {
        velocity: Vec2::new(Exact::from_integer(x), Exact::from_integer(y)),
        mass: Mass::Finite(Exact::from_integer(mass)),
        ..disc(["0", "0"], "1")
    })
}

/// Each disc but the first touches one before it; maybe the first touches a
/// wall. Such contacts can always part.
fn tree(walls: bool) -> impl Strategy<Value = (Vec<Disc<Exact>>, Vec<Contact>)> {
    let links = prop::collection::vec((any::<prop::sample::Index>(), normal()), 1..7);
    (links, normal(), any::<bool>()).prop_flat_map(move |(links, side, has_wall)| {
        let count = links.len() + 1;
        let links = (1..).zip(links).map(|(second, (parent, normal))| Contact {
            first: parent.index(second),
            second: Some(second),
            normal,
        });
        let wall = Contact {
            first: 0,
            second: None,
            normal: side,
        };
        let contacts: Vec<_> = links.chain((walls && has_wall).then_some(wall)).collect();
        (prop::collection::vec(body(), count), Just(contacts))
    })
}

/// Four discs that all touch each other, of the curvatures 2, 2, 3 and 15, at
/// (±1/2, 0), (0, 2/3) and (0, 4/15): six contacts, of which five are
/// independent.
fn gasket() -> impl Strategy<Value = (Vec<Disc<Exact>>, Vec<Contact>)> {
    let places = [["-1/2", "0"], ["1/2", "0"], ["0", "2/3"], ["0", "4/15"]];
    let places = places.map(vector::<Exact, u32>);
    let contacts: Vec<_> = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]
        .into_iter()
        .map(|(first, second)| Contact {
            first,
            second: Some(second),
            normal: Normal::at_overlap(places[second].minus(&places[first])),
        })
        .collect();
    (prop::collection::vec(body(), 4), Just(contacts))
}

fn dot(a: &Vector, b: &Vector) -> BigRational {
    &a[0] * &b[0] + &a[1] * &b[1]
}

fn mass(disc: &Disc<Exact>) -> BigRational {
    match &disc.mass {
        Mass::Finite(mass) => rational(mass),
        Mass::Infinite => unreachable!("no such disc here"),
    }
}

fn energy(discs: &[Disc<Exact>]) -> BigRational {
    discs.iter().fold(BigRational::zero(), |sum, disc| {
        let velocity = plain(&disc.velocity);
        sum + mass(disc) * dot(&velocity, &velocity)
    })
}

fn momentum(discs: &[Disc<Exact>]) -> Vector {
    [0, 1].map(|axis| {
        discs.iter().fold(BigRational::zero(), |sum, disc| {
            sum + mass(disc) * &plain(&disc.velocity)[axis]
        })
    })
}

/// How fast a contact opens.
fn opening(discs: &[Disc<Exact>], contact: &Contact) -> BigRational {
    let normal = plain(&contact.normal.direction);
    let first = dot(&plain(&discs[contact.first].velocity), &normal);
    match contact.second {
        Some(second) => dot(&plain(&discs[second].velocity), &normal) - first,
        None => -first,
    }
}

fn resolved(
    discs: &[Disc<Exact>],
    contacts: &[Contact],
    restitution: &Restitution<Exact>,
) -> (Vec<Disc<Exact>>, Vec<usize>) {
    let mut after = discs.to_vec();
    match reflect_cluster(&mut after, contacts, restitution).unwrap() {
        Reflection::Parted(struck) => (after, struck),
        Reflection::Jammed => panic!("these can part"),
    }
}

fn assert_parted(discs: &[Disc<Exact>], contacts: &[Contact]) {
    for contact in contacts {
        assert!(opening(discs, contact) >= BigRational::zero());
    }
}

/// The place of each after the rotation of all places by one, twice.
fn moved_by_two(place: usize, count: usize) -> usize {
    (place + 2) % count
}

proptest! {
    #[test]
    fn energy_is_kept_and_nothing_approaches(
        (discs, contacts) in prop_oneof![tree(true), gasket()],
    ) {
        let (after, _) = resolved(&discs, &contacts, &Restitution::Elastic);
        prop_assert_eq!(energy(&after), energy(&discs));
        assert_parted(&after, &contacts);
    }

    #[test]
    fn momentum_is_kept((discs, contacts) in prop_oneof![tree(false), gasket()]) {
        for restitution in [Restitution::Elastic, newton("0"), newton("1/3")] {
            let (after, _) = resolved(&discs, &contacts, &restitution);
            prop_assert_eq!(momentum(&after), momentum(&discs));
        }
    }

    /// The less is kept, the less energy there is; with nothing kept, what
    /// was struck does not part, or another contact has parted it.
    #[test]
    fn losses_lose((discs, contacts) in prop_oneof![tree(true), gasket()]) {
        let energies = ["0", "1/3", "2/3", "1"].map(|coefficient| {
            let (after, _) = resolved(&discs, &contacts, &newton(coefficient));
            assert_parted(&after, &contacts);
            energy(&after)
        });
        prop_assert!(energies.is_sorted());
    }

    /// The projection is what no other velocity without approach is nearer
    /// to: the angle between v - p and z - p is not acute for any such z.
    #[test]
    fn nothing_kept_is_the_projection(
        (discs, contacts) in prop_oneof![tree(true), gasket()],
    ) {
        let (nearest, struck) = resolved(&discs, &contacts, &newton("0"));
        let (other, _) = resolved(&discs, &contacts, &Restitution::Elastic);
        let angle = |z: &[Disc<Exact>]| {
            (0..discs.len()).fold(BigRational::zero(), |sum, index| {
                let [v, p, z] = [&discs[index], &nearest[index], &z[index]]
                    .map(|disc| plain(&disc.velocity));
                let [to_v, to_z] = [v, z].map(|[x, y]| [x - &p[0], y - &p[1]]);
                sum + mass(&discs[index]) * dot(&to_v, &to_z)
            })
        };
        prop_assert!(angle(&other) <= BigRational::zero());
        let rest: Vec<_> = discs.iter().map(|disc| Disc { velocity: Vec2::zero(), ..disc.clone() }).collect();
        prop_assert!(angle(&rest).is_zero(), "the cone goes through zero");
        prop_assert_eq!(struck.is_empty(), nearest.iter().zip(&discs).all(|(p, v)| {
            plain(&p.velocity) == plain(&v.velocity)
        }));
    }

    #[test]
    fn names_do_not_matter((discs, contacts) in prop_oneof![tree(true), gasket()]) {
        let restitution = newton("1/2");
        for restitution in [&Restitution::Elastic, &restitution] {
            let (after, struck) = resolved(&discs, &contacts, restitution);
            let (discs, contacts) = renamed(&discs, &contacts);
            let (other, other_struck) = resolved(&discs, &contacts, restitution);
            for (place, disc) in after.iter().enumerate() {
                let renamed = &other[moved_by_two(place, other.len())];
                prop_assert_eq!(plain(&disc.velocity), plain(&renamed.velocity));
            }
            let last = contacts.len() - 1;
            let mut renamed: Vec<_> = other_struck.iter().map(|index| last - index).collect();
            renamed.reverse();
            prop_assert_eq!(struck, renamed);
        }
    }

    #[test]
    fn mirrored_clusters_end_mirrored((discs, contacts) in prop_oneof![tree(true), gasket()]) {
        let (after, struck) = resolved(&discs, &contacts, &newton("1/2"));
        let others: Vec<_> = discs.iter().map(mirrored_disc).collect();
        let images: Vec<_> = contacts.iter().map(|contact| Contact {
            normal: Normal { direction: mirrored(&contact.normal.direction), ..contact.normal.clone() },
            ..*contact
        }).collect();
        let (other, other_struck) = resolved(&others, &images, &newton("1/2"));
        prop_assert_eq!(struck, other_struck);
        let expected: Vec<_> = after.iter().map(mirrored_disc).collect();
        prop_assert_eq!(all_velocities(&other), all_velocities(&expected));
    }

    #[test]
    fn the_length_of_normals_does_not_matter((discs, contacts) in tree(true)) {
        let (after, _) = resolved(&discs, &contacts, &newton("1/2"));
        let longer: Vec<_> = contacts.iter().enumerate().map(|(index, contact)| {
            let factor = Exact::from_integer(index as i32 + 2);
            Contact {
                normal: Normal::at_overlap(contact.normal.direction.scaled(&factor)),
                ..*contact
            }
        }).collect();
        let (other, _) = resolved(&discs, &longer, &newton("1/2"));
        prop_assert_eq!(all_velocities(&after), all_velocities(&other));
    }

    #[test]
    fn binary64_comes_near((discs, contacts) in prop_oneof![tree(true), gasket()]) {
        let (exact, _) = resolved(&discs, &contacts, &Restitution::Elastic);
        let mut rounded: Vec<Disc<f64>> = discs.iter().map(|disc| disc.map(Exact::to_f64)).collect();
        let contacts: Vec<_> = contacts.iter().map(|contact| ClusterContact {
            first: contact.first,
            second: contact.second,
            normal: Normal::at_overlap(contact.normal.direction.map(Exact::to_f64)),
        }).collect();
        let reflection = reflect_cluster(&mut rounded, &contacts, &Restitution::Elastic).unwrap();
        prop_assert!(matches!(reflection, Reflection::Parted(_)));
        let energy = |parts: &[Vec2<f64>]| -> f64 {
            parts.iter().zip(&rounded).map(|(v, disc)| match disc.mass {
                Mass::Finite(mass) => mass * v.norm_squared(),
                Mass::Infinite => 0.0,
            }).sum()
        };
        let found: Vec<_> = rounded.iter().map(|disc| disc.velocity).collect();
        let expected: Vec<_> = exact.iter().map(|disc| disc.velocity.map(Exact::to_f64)).collect();
        prop_assert!((energy(&found) - energy(&expected)).abs() <= 1e-9);
    }
}

/// Discs moved on by two places, contacts in reverse order and between discs
/// the other way around.
fn renamed(discs: &[Disc<Exact>], contacts: &[Contact]) -> (Vec<Disc<Exact>>, Vec<Contact>) {
    let count = discs.len();
    let mut moved = discs.to_vec();
    for (place, disc) in discs.iter().enumerate() {
        moved[moved_by_two(place, count)] = disc.clone();
    }
    let turned = contacts.iter().rev().map(|contact| {
        let first = moved_by_two(contact.first, count);
        match contact.second.map(|second| moved_by_two(second, count)) {
            None => Contact {
                first,
                ..contact.clone()
            },
            Some(second) => Contact {
                first: second,
                second: Some(first),
                normal: Normal {
                    direction: -contact.normal.direction.clone(),
                    ..contact.normal.clone()
                },
            },
        }
    });
    (moved, turned.collect())
}

fn mirrored(vector: &Vec2<Exact>) -> Vec2<Exact> {
    Vec2::new(-vector.x.clone(), vector.y.clone())
}

fn mirrored_disc(disc: &Disc<Exact>) -> Disc<Exact> {
    Disc {
        velocity: mirrored(&disc.velocity),
        ..disc.clone()
    }
}
