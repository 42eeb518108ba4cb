//! A periodic scene is the plane with all copies of its discs in it.

use carom::arithmetic::Arithmetic;
use carom::body::BodyId;
use carom::impact::Impact;
use carom::scalar::{Exact, Filtered, Number, Scalar};
use carom::scene::{Disc, Scene};
use carom::simulation::Algorithm;
use proptest::prelude::*;

use crate::common::strategy::cases;
use crate::common::{complete, exactly, name, names, numbers, ratio};

/// The side of the cell.
const SIDE: i32 = 12;

/// How many cells on each side of the middle one are filled in the plane: nothing from
/// beyond gets to the middle one in time.
const AROUND: i32 = 2;

/// Nothing gets from one cell through another until then, at speeds up to 3 in each
/// direction at first, and at most √(4 · 18) in all, by energy.
const END: &str = "5/4";

/// Four discs of different radii, on a lattice with room for them.
fn discs() -> impl Strategy<Value = Vec<Disc>> {
    let disc = (-2..=2_i32, -2..=2_i32, -9..=9_i32, -9..=9_i32, 4..=8_i32);
    prop::collection::vec(disc, 4).prop_map(|all| {
        let place = |(index, (dx, dy, vx, vy, radius)): (usize, (i32, i32, i32, i32, i32))| {
            let [column, row] = [index as i32 % 2, index as i32 / 2];
            let coordinate = |cell: i32, moved: i32| text(6 * 4 * cell + 2 * moved, 4);
            Disc::at(
                [
                    coordinate(column, dx).as_str(),
                    coordinate(row, dy).as_str(),
                ],
                text(radius, 4).as_str(),
            )
            .velocity([text(vx, 3).as_str(), text(vy, 3).as_str()])
        };
        let scene = Scene::builder("discs").discs(all.into_iter().enumerate().map(place));
        scene.build().expect("a valid scene").discs().to_vec()
    })
}

fn text(numerator: i32, denominator: i32) -> String {
    format!("{numerator}/{denominator}")
}

fn periodic(discs: &[Disc], side: i32, end: &str) -> Scene {
    let scene = Scene::builder("periodic").frame(end, 1);
    let scene = scene.periodic([0, 0], [side, SIDE]);
    scene
        .discs(discs.iter().cloned())
        .build()
        .expect("a valid scene")
}

/// A disc, so many cells further on.
fn copy(disc: &Disc, cell: [i32; 2]) -> Disc {
    let moved = |axis: usize| {
        let place = disc.position[axis].to_rational() + ratio(&(SIDE * cell[axis]).to_string());
        Number::try_from(place).expect("a number")
    };
    Disc {
        position: [moved(0), moved(1)],
        ..disc.clone()
    }
}

/// What a disc of the middle cell collides with, and when.
type Course = Vec<(String, f64)>;

/// The courses of the discs by a periodic run.
fn courses(impacts: &[Impact<Exact>], discs: usize) -> Vec<Course> {
    let mut courses = vec![Vec::new(); discs];
    for impact in impacts {
        let cell = *impact.image.as_deref().expect("which copy");
        let [a, b] = [impact.pair.a, impact.pair.b].map(number);
        let time = impact.time.to_f64();
        courses[a].push((format!("{b} {cell:?}"), time));
        courses[b].push((format!("{a} {:?}", cell.map(|cell| -cell)), time));
    }
    courses
}

/// Proven times up to 4, to the nearest binary64 or the next one.
fn assert_same(one: &[Course], other: &[Course]) {
    let names = |courses: &[Course]| -> Vec<Vec<String>> {
        let names = |course: &Course| course.iter().map(|(name, _)| name.clone()).collect();
        courses.iter().map(names).collect()
    };
    assert_eq!(names(one), names(other));
    for ((_, one), (_, other)) in one.iter().flatten().zip(other.iter().flatten()) {
        assert!(
            (one - other).abs() <= f64::EPSILON * 2.0,
            "{one} and {other}"
        );
    }
}

fn number(body: BodyId) -> usize {
    match body {
        BodyId::Disc(disc) => disc as usize,
        BodyId::Wall(wall) => panic!("w{wall} in a periodic scene"),
    }
}

/// The same by a run of the plane with copies in it, the middle ones first.
fn courses_in_plane(discs: &[Disc]) -> Vec<Course> {
    let cells = (-AROUND..=AROUND).flat_map(|y| (-AROUND..=AROUND).map(move |x| [x, y]));
    let mut cells: Vec<[i32; 2]> = cells.collect();
    cells.sort_by_key(|[x, y]| x.abs() + y.abs());
    let copies = cells
        .iter()
        .flat_map(|cell| discs.iter().map(|disc| copy(disc, *cell)));
    let scene = Scene::builder("plane").frame(END, 1).discs(copies);
    let run = exactly(&scene.build().expect("a valid scene"));
    let mut courses = vec![Vec::new(); discs.len()];
    for impact in &run.impacts {
        let [a, b] = [impact.pair.a, impact.pair.b].map(number);
        for (one, other) in [(a, b), (b, a)] {
            if one < discs.len() {
                let cell = cells[other / discs.len()].map(i64::from);
                let name = format!("{} {cell:?}", other % discs.len());
                courses[one].push((name, impact.time.to_f64()));
            }
        }
    }
    courses
}

/// The courses of all copies of a disc in one, in the order of the times, without which
/// copies collide.
fn courses_of_copies(impacts: &[Impact<Exact>], discs: usize) -> Vec<Course> {
    let mut courses = vec![Vec::new(); discs];
    for impact in impacts {
        let [a, b] = [impact.pair.a, impact.pair.b].map(|body| number(body) % discs);
        for (one, other) in [(a, b), (b, a)] {
            courses[one].push((other.to_string(), impact.time.to_f64()));
        }
    }
    courses
}

/// The same with every impact twice.
fn twice(courses: Vec<Course>) -> Vec<Course> {
    let twice = |course: Course| course.into_iter().flat_map(|one| [one.clone(), one]);
    let courses = courses.into_iter();
    courses.map(|course| twice(course).collect()).collect()
}

/// By hand: d1 meets the copy of d0 at 13, a cell further on, after 2. Then d0 moves in
/// its place, from 1, and meets d1 itself at 11 after 8 more.
fn around<S: Arithmetic>() -> Vec<(String, f64, [i64; 2])> {
    let discs = [
        Disc::at([1, 5], 1).velocity([0, 0]),
        Disc::at([9, 5], 1).velocity([1, 0]),
    ];
    let scene = Scene::builder("around").frame(10, 1).discs(discs);
    let scene = scene.periodic([0, 0], [SIDE, SIDE]).build().unwrap();
    let run = complete::<S>(&scene, Algorithm::Timeline);
    let impacts = run.impacts.iter();
    let told = impacts.map(|impact| {
        let cell = *impact.image.as_deref().expect("which copy");
        (name(impact), impact.time.to_f64(), cell)
    });
    told.collect()
}

#[test]
fn around_the_cell() {
    let expected = [("d0 d1", 2.0, [-1, 0]), ("d0 d1", 10.0, [0, 0])];
    let expected = expected.map(|(pair, time, cell)| (pair.to_owned(), time, cell));
    assert_eq!(around::<f64>(), expected);
    assert_eq!(around::<Filtered>(), expected);
    assert_eq!(around::<Exact>(), expected);
}

/// A disc that touches its own copies never collides with them. By hand: above and below
/// there is a gap of 1, which d1 and d0 cross in turn.
#[test]
fn as_wide_as_the_cell() {
    let discs = [
        Disc::at([6, 3], 3).velocity([0, 0]),
        Disc::at([6, 9], 3).velocity([0, 1]),
    ];
    let scene = Scene::builder("wide").frame(3, 1).discs(discs);
    let scene = scene.periodic([0, 0], [6, 13]).build().unwrap();
    let run = exactly(&scene);
    let told = run.impacts.iter().map(|impact| {
        let cell = *impact.image.as_deref().expect("which copy");
        (impact.time.to_f64(), cell)
    });
    let expected = [(1.0, [0, -1]), (2.0, [0, 0]), (3.0, [0, -1])];
    assert_eq!(told.collect::<Vec<_>>(), expected);
}

proptest! {
    #![proptest_config(cases(60))]

    /// Against the timeline of the plane, which knows nothing of copies.
    #[test]
    fn is_the_plane_with_all_copies(discs in discs()) {
        let run = exactly(&periodic(&discs, SIDE, END));
        assert_same(&courses(&run.impacts, discs.len()), &courses_in_plane(&discs));
    }

    /// A cell of twice the width, with each disc twice, has each impact twice.
    #[test]
    fn a_cell_twice_as_wide(discs in discs()) {
        let count = discs.len();
        let further = discs.iter().map(|disc| copy(disc, [1, 0]));
        let both: Vec<_> = discs.iter().cloned().chain(further).collect();
        let run = exactly(&periodic(&discs, SIDE, "4"));
        let wide = exactly(&periodic(&both, 2 * SIDE, "4"));
        let expected = twice(courses_of_copies(&run.impacts, count));
        assert_same(&courses_of_copies(&wide.impacts, count), &expected);
    }

    /// Binary64 follows the truth, and shifting the rectangle changes nothing at all.
    #[test]
    fn binary64_follows(discs in discs()) {
        let scene = periodic(&discs, SIDE, END);
        let truth = exactly(&scene);
        for run in [
            names(&complete::<f64>(&scene, Algorithm::Timeline).impacts),
            names(&complete::<Filtered>(&scene, Algorithm::Timeline).impacts),
        ] {
            prop_assert_eq!(run, names(&truth.impacts));
        }
        let [x, y] = [3, -5].map(|corner| [corner, corner + SIDE]);
        let shifted = scene.to_builder().periodic([x[0], y[0]], [x[1], y[1]]);
        let shifted = exactly(&shifted.build().unwrap());
        let all = |end: &[carom::body::Disc<Exact>]| -> Vec<_> {
            end.iter().flat_map(numbers).map(|number| number.hull()).collect()
        };
        prop_assert_eq!(all(&shifted.end), all(&truth.end));
    }
}

/// After 20 000 impacts in a dense gas: the squares of the distances of all pairs, of
/// the copies that are nearest, against the diameter.
#[cfg(feature = "cli")]
fn closest<S: Arithmetic<Precision = ()>>() -> f64 {
    use carom::playback::Playback;

    let scene = carom::scene::generate::periodic_gas(3, 200, 0.65).expect("a scene");
    let side = scene.periodic().expect("a cell").sides()[0].to_f64();
    let end = Number::from(10_000);
    let mut playback = Playback::<S>::until(&scene, &end, ()).expect("a scene that runs");
    let mut closest = f64::INFINITY;
    for _ in 0..10 {
        assert_eq!(playback.impacts().take(2000).count(), 2000);
        let discs = playback.discs();
        for (index, one) in discs.iter().enumerate() {
            for other in &discs[..index] {
                let offset = other.position.minus(&one.position);
                let [x, y] = [offset.x, offset.y].map(|part| {
                    let part = part.to_f64();
                    part - side * (part / side).round()
                });
                closest = closest.min(x.hypot(y));
            }
        }
    }
    closest
}

/// Places are up to some 60 from the origin, where binary64 rounds by 7e-15.
#[cfg(feature = "cli")]
#[test]
fn nothing_gets_into_anything() {
    assert!(closest::<f64>() > 1.0 - 1e-13, "{}", closest::<f64>());
    assert!(
        closest::<Filtered>() > 1.0 - 1e-13,
        "{}",
        closest::<Filtered>()
    );
}
