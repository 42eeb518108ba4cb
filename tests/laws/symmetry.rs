//! Where a scene is, how it is turned, how fast all of it moves and which disc
//! is named first makes no difference.

use carom::body::{BodyId, Pair};
use carom::scene::Scene;
use proptest::prelude::*;

use super::change::Change;
use crate::common::agree::agree;
use crate::common::strategy::{cases, cluster_with_piston, lossy};
use crate::common::{exactly, names, numbers};

/// The changed scene has the same log, and ends where the change takes the
/// end of the first.
fn assert_follows(scene: &Scene, change: &Change) {
    let (before, after) = (exactly(scene), exactly(&change.of(scene)));
    assert_eq!(names(&before.impacts), names(&after.impacts));
    assert_eq!(before.grazes, after.grazes);
    for (one, other) in before.impacts.iter().zip(&after.impacts) {
        assert!(agree(&one.time, &other.time), "{one:?} {other:?}");
    }
    for (one, other) in before.end.iter().zip(&after.end) {
        let expected = change.of_disc(one, &before.time);
        for (expected, found) in expected.iter().zip(&numbers(other)) {
            assert!(agree(expected, found), "{expected:?} {found:?}");
        }
    }
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn translation(scene in lossy()) {
        let shift = ["1234567.0625", "-1/3"];
        assert_follows(&scene, &Change { shift, ..Change::NONE });
    }

    /// By the angle of the triangle 3-4-5.
    #[test]
    fn rotation(scene in lossy()) {
        let matrix = [["3/5", "-4/5"], ["4/5", "3/5"]];
        assert_follows(&scene, &Change { matrix, ..Change::NONE });
    }

    #[test]
    fn reflection(scene in lossy()) {
        let matrix = [["-1", "0"], ["0", "1"]];
        assert_follows(&scene, &Change { matrix, ..Change::NONE });
        let matrix = [["0", "1"], ["1", "0"]];
        assert_follows(&scene, &Change { matrix, ..Change::NONE });
    }

    /// Walls do not move, so there are none; a body of infinite mass does.
    #[test]
    fn galilean_shift(scene in cluster_with_piston()) {
        let drift = ["7/3", "-5/2"];
        assert_follows(&scene, &Change { drift, ..Change::NONE });
    }

    /// The discs in reverse order: no two impacts of these scenes are
    /// simultaneous, so nothing depends on names.
    #[test]
    fn relabelling(scene in prop_oneof![lossy(), cluster_with_piston()]) {
        let reversed = scene.discs().iter().rev().cloned();
        let reversed = scene.to_builder().without_discs().discs(reversed);
        let (before, after) = (exactly(&scene), exactly(&reversed.build().unwrap()));
        let last = scene.discs().len() as u32 - 1;
        prop_assert_eq!(before.impacts.len(), after.impacts.len());
        for (one, other) in before.impacts.iter().zip(&after.impacts) {
            prop_assert_eq!(relabelled(one.pair, last), other.pair);
            prop_assert_eq!(one.end, other.end);
            prop_assert!(agree(&one.time, &other.time));
        }
        for (one, other) in before.end.iter().zip(after.end.iter().rev()) {
            let same = numbers(one).iter().zip(&numbers(other)).all(|(a, b)| agree(a, b));
            prop_assert!(same, "{one:?} {other:?}");
        }
    }
}

fn relabelled(pair: Pair, last: u32) -> Pair {
    let rename = |body| match body {
        BodyId::Disc(index) => BodyId::Disc(last - index),
        BodyId::Wall(_) => body,
    };
    Pair::new(rename(pair.a), rename(pair.b))
}
