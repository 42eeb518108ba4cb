//! In a mirror bodies fall the same way: a scene seen in one has the log of the
//! scene, and ends where the mirror shows its end.

use carom::run::{Options, Outcome, Status};
use carom::scalar::{Exact, Scalar};
use carom::simulation::Algorithm;

use super::case::{Ball, Case, Family, Point};
use super::{GENERIC, LATTICE};
use crate::common::agree::agree;
use crate::common::{attempt, names, numbers};

/// The case in a mirror across one axis.
fn mirrored(case: &Case, axis: usize) -> Case {
    let turned = |mut point: Point| {
        point[axis] = -point[axis];
        point
    };
    Case {
        gravity: turned(case.gravity),
        balls: case
            .balls
            .iter()
            .map(|ball| Ball {
                place: turned(ball.place),
                velocity: turned(ball.velocity),
                ..*ball
            })
            .collect(),
        walls: case.walls.iter().map(|wall| wall.map(turned)).collect(),
        ..*case
    }
}

/// A run and that of the mirror's scene, by what they hit, when they do, and the
/// numbers of the discs at the end; of the other one, as seen in the mirror again.
fn beside<S: Scalar>(
    [one, other]: &[Outcome<S>; 2],
    axis: usize,
    are_same: impl Fn(&S, &S) -> bool,
) -> bool {
    let times = one.impacts.iter().zip(&other.impacts);
    let mut discs = one.end.iter().zip(&other.end);
    names(&one.impacts) == names(&other.impacts)
        && times.into_iter().all(|(a, b)| are_same(&a.time, &b.time))
        && discs.all(|(a, b)| {
            let pairs = numbers(a).into_iter().zip(numbers(b)).enumerate();
            pairs
                .into_iter()
                .all(|(place, (a, b))| match place % 2 == axis {
                    true => are_same(&a, &-b),
                    false => are_same(&a, &b),
                })
        })
}

const FAMILIES: [Family; 3] = [
    GENERIC,
    LATTICE,
    Family {
        boxed: false,
        walls: 4,
        pegs: 2,
        drag: 0.5,
        ..GENERIC
    },
];

fn options(max_events: u64) -> Options {
    Options {
        max_events,
        ..Options::default()
    }
}

/// So many cases of each family, each with an axis.
fn cases(count: u64) -> impl Iterator<Item = (Case, usize)> {
    let families = FAMILIES.iter();
    let cases = families.flat_map(move |family| (0..count).map(|seed| (family.case(seed), seed)));
    cases.map(|(case, seed)| (case, seed as usize % 2))
}

/// To the last bit: rounding to nearest knows no sign.
#[test]
fn in_binary64() {
    for (case, axis) in cases(60) {
        let run = |case: &Case| attempt::<f64>(&case.scene(), Algorithm::Timeline, &options(200));
        let runs = [run(&case), run(&mirrored(&case, axis))];
        assert!(beside(&runs, axis, |a, b| a == b), "{case:?}");
    }
}

/// Enclosures of the same numbers have some in common.
#[test]
fn in_exact_arithmetic() {
    let mut decided = 0;
    for (case, axis) in cases(12) {
        let run = |case: &Case| attempt::<Exact>(&case.scene(), Algorithm::Timeline, &options(10));
        let runs = [run(&case), run(&mirrored(&case, axis))];
        let is_open = |run: &Outcome<Exact>| matches!(run.status, Status::Undecided(_));
        if !runs.iter().any(is_open) {
            assert!(beside(&runs, axis, agree), "{case:?}");
            decided += 1;
        }
    }
    assert!(decided > 24, "only {decided} runs are decided");
}
