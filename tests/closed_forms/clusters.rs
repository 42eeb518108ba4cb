//! What touches at one time, resolved at once: the `reflect` rule.

use carom::run::{Options, Outcome, Status};
use carom::scalar::Exact;
use carom::scene::{Disc, SceneBuilder};
use carom::simulation::Algorithm;
use carom::timeline::Simultaneous;

use crate::common::agree::{assert_end, assert_log};
use crate::common::{attempt, lasting};

/// The run of a scene, up to its tenth impact.
fn follow(scene: SceneBuilder) -> Outcome<Exact> {
    let options = Options {
        max_events: 10,
        simultaneous: Simultaneous::Reflect,
        ..Options::default()
    };
    attempt(&scene.build().unwrap(), Algorithm::Timeline, &options)
}

/// On a line, d1 overlaps d2 and hits it, while d0 touches d1 and moves with it.
/// Equal masses exchange their velocities, whatever the distance: then d1
/// rests, and d0 moves away from it.
#[test]
fn of_an_overlap() {
    let outcome = follow(
        lasting("1")
            .disc(Disc::at([-4, 0], "5/2").velocity([-1, 0]))
            .disc(Disc::at([1, 0], "5/2").velocity([-1, 0]))
            .disc(Disc::at([-2, 0], "3/2")),
    );
    assert_eq!(outcome.status, Status::Complete);
    assert_log(&outcome, &[("0", "d1 d2")]);
    let first = ["-5", "0", "-1", "0"];
    assert_end(
        &outcome,
        &[first, ["1", "0", "0", "0"], ["-3", "0", "-1", "0"]],
    );
}

/// Two walls end where d0 touches them: one contact. d1 hits d0, d0 the
/// corner, and d0 hits d1.
#[test]
fn with_a_corner() {
    let outcome = follow(
        lasting("2")
            .disc(Disc::at([0, 0], 1))
            .disc(Disc::at([3, 0], 1).velocity([-1, 0]))
            .wall([-1, 0], [-2, 5])
            .wall([-1, 0], [-2, -5]),
    );
    assert_eq!(outcome.status, Status::Complete);
    assert_log(&outcome, &[("1", "d0 d1"), ("1", "d0 w0 from")]);
    assert_end(&outcome, &[["0", "0", "0", "0"], ["3", "0", "1", "0"]]);
}

/// Two discs that nothing deflects touch d1 from the right, one at rest and one
/// that moves away at 3. At 10, d1 hits both. The nearest velocity that
/// approaches neither is 0, so it goes back at -10.
#[test]
fn with_two_bodies_on_one_side() {
    let right = |y: &str| Disc::at(["4", y], 5).infinite_mass();
    let outcome = follow(
        lasting("1/10")
            .disc(right("0").velocity([3, 0]))
            .disc(Disc::at([-6, 0], 5).velocity([10, 0]))
            .disc(right("0")),
    );
    assert_eq!(outcome.status, Status::Complete);
    assert_log(&outcome, &[("0", "d0 d1"), ("0", "d1 d2")]);
    let first = ["43/10", "0", "3", "0"];
    assert_end(
        &outcome,
        &[first, ["-7", "0", "-10", "0"], ["4", "0", "0", "0"]],
    );
}

/// A disc without any play between two walls hits them in turn, for ever.
#[test]
fn that_jams() {
    let outcome = follow(
        lasting("1")
            .disc(Disc::at([0, 0], 1).velocity([0, 1]))
            .wall([-9, -1], [9, -1])
            .wall([-9, 1], [9, 1]),
    );
    assert_eq!(outcome.status, Status::EventLimit);
    assert_log(&outcome, &[("0", "d0 w1"), ("0", "d0 w0")].repeat(5));
}
