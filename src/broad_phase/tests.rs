//! Every way to divide the plane against the definition.

use std::collections::BTreeSet;

use proptest::prelude::*;

use super::*;

const ALL: [BroadPhase; 3] = [BroadPhase::AllPairs, BroadPhase::Grid, BroadPhase::Bsp];

/// Points of a lattice, so that many areas only touch; anything; and what is far
/// away or very near.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => (-8..8_i32).prop_map(f64::from),
        8 => -50.0..50.0_f64,
        1 => (-1000..1000_i32).prop_map(|exponent| f64::from(exponent).exp2()),
        1 => prop::sample::select(vec![0.0, -0.0, 1e300, -1e300, f64::MAX, f64::MIN, 5e-324]),
    ]
}

/// Widths from nothing to very much.
fn width() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => Just(0.0),
        4 => (0..4_i32).prop_map(f64::from),
        4 => 0.0..3.0_f64,
        1 => (-60.0..60.0_f64).prop_map(f64::exp2),
    ]
}

fn area() -> impl Strategy<Value = Area> {
    let bounded = ([coordinate(), coordinate()], [width(), width()])
        .prop_map(|(lo, width)| Area::new(lo, [0, 1].map(|axis| lo[axis] + width[axis])));
    prop_oneof![20 => bounded, 1 => Just(Area::WHOLE)]
}

/// What an index finds about a body, each once.
fn found(index: &mut Index, body: usize) -> BTreeSet<usize> {
    let mut found = Vec::new();
    index.look_about(body, |other| found.push(other));
    let set: BTreeSet<_> = found.iter().copied().collect();
    assert_eq!(set.len(), found.len(), "each once");
    set
}

fn expected(areas: &[Area], body: usize) -> BTreeSet<usize> {
    let overlap = |one: &Area, other: &Area| {
        (0..2).all(|axis| one.lo[axis].max(other.lo[axis]) <= one.hi[axis].min(other.hi[axis]))
    };
    let others = (0..areas.len()).filter(|&other| other != body);
    others
        .filter(|&other| overlap(&areas[body], &areas[other]))
        .collect()
}

fn assert_right(index: &mut Index, areas: &[Area], phase: BroadPhase) {
    for body in 0..areas.len() {
        let found = found(index, body);
        assert_eq!(found, expected(areas, body), "{phase:?}, body {body}");
    }
}

fn assert_all_right(areas: &[Area]) {
    for phase in ALL {
        let mut index = Index::default();
        index.rebuild(phase, areas.iter().copied());
        assert_right(&mut index, areas, phase);
    }
}

proptest! {
    /// Also after some have moved, and when it is used again.
    #[test]
    fn precisely_what_overlaps_is_found(
        areas in prop::collection::vec(area(), 0..60),
        others in prop::collection::vec(area(), 0..60),
        moves in prop::collection::vec((any::<prop::sample::Index>(), area()), 0..20),
    ) {
        for phase in ALL {
            let mut index = Index::default();
            // Of as many bodies, so that lines may be kept.
            let others = others.iter().chain(&areas).take(areas.len());
            index.rebuild(phase, others.copied());
            index.rebuild(phase, areas.iter().copied());
            assert_right(&mut index, &areas, phase);
            let mut areas = areas.clone();
            let moves = if areas.is_empty() { &[] } else { &moves[..] };
            for (body, area) in moves {
                let body = body.index(areas.len());
                areas[body] = *area;
                index.replace(body, *area);
            }
            assert_right(&mut index, &areas, phase);
        }
    }

    /// Many of one size, as discs are.
    #[test]
    fn many_alike(corners in prop::collection::vec([0.0..40.0_f64, 0.0..40.0_f64], 200..400)) {
        let areas: Vec<_> = corners
            .into_iter()
            .map(|lo| Area::new(lo, lo.map(|end| end + 1.0)))
            .collect();
        assert_all_right(&areas);
    }
}

#[test]
fn degenerate_areas() {
    let point = Area::new([1.0; 2], [1.0; 2]);
    let tiny = Area::new([0.0; 2], [5e-324; 2]);
    let large = Area::new([-1e300; 2], [1e300; 2]);
    let largest = Area::new([f64::MIN; 2], [f64::MAX; 2]);
    assert_all_right(&[]);
    assert_all_right(&[point]);
    for area in [point, tiny, large, largest, Area::WHOLE] {
        assert_all_right(&[area; 40]);
    }
    let row = |step: f64| {
        let place = move |index: i32| [f64::from(index) * step, 0.0];
        (0..60).map(move |index| Area::new(place(index), place(index)))
    };
    assert_all_right(&row(1.0).collect::<Vec<_>>());
    assert_all_right(&row(1e298).chain([point, large]).collect::<Vec<_>>());
    assert_all_right(&row(1e-310).chain([point, tiny]).collect::<Vec<_>>());
}

#[test]
fn what_is_not_finite_is_everywhere() {
    for end in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(Area::new([end, 0.0], [1.0, 1.0]), Area::WHOLE);
        assert_eq!(Area::new([0.0, 0.0], [1.0, end]), Area::WHOLE);
    }
}

/// A tree of discs in a row is no deeper than it has to be: as a walk goes to a
/// few parts only, so does it see few bodies.
#[test]
fn few_parts_are_seen() {
    let place = |index: i32| f64::from(index) * 3.0;
    let areas: Vec<_> = (0..10_000)
        .map(|index| {
            let [x, y] = [index % 100, index / 100].map(place);
            Area::new([x, y], [x + 1.0, y + 1.0])
        })
        .collect();
    let mut tree = bsp::Tree::default();
    tree.adapt(&areas);
    for area in &areas {
        let mut parts = 0;
        tree.visit(area, |_| parts += 1);
        assert!((1..=4).contains(&parts), "{parts}");
    }
}

/// Rounded down, also below zero, and nothing overflows.
#[test]
fn cells_of_coordinates() {
    let found = [2.0, 2.5, -0.5, -3.0].map(super::cell);
    assert_eq!(found, [Some(2), Some(2), Some(-1), Some(-3)]);
    for far in [1e10, -1e10, 1e300, -1e300, f64::NEG_INFINITY, f64::NAN] {
        assert_eq!(super::cell(far), None);
    }
}
