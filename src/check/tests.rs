//! What is wrong is found: records of right runs, with one thing changed.

use super::flight::judge;
use super::record::{Claim, names};
use super::*;
use crate::body::End;
use crate::scene::{Disc, SceneBuilder};
use crate::world::Obstacle;

/// Head-on at 1: unit discs with 4 between their centres, at a speed of 2.
fn head_on() -> SceneBuilder {
    let moving = Disc::at([0, 0], 1).velocity([2, 0]);
    Scene::builder("test")
        .frame(4, 1)
        .disc(moving)
        .disc(Disc::at([4, 0], 1))
}

fn record(scene: SceneBuilder) -> Record {
    Record::of::<f64>(&scene.build().unwrap(), 10).unwrap()
}

fn verdict(record: &Record) -> Option<Kind> {
    let judged = judge(record, true, trial::<f64>(Run::Timeline));
    judged.err().map(|finding| finding.kind)
}

/// The kind of what is found after a change.
fn changed(scene: SceneBuilder, change: impl FnOnce(&mut Record)) -> Option<Kind> {
    let mut record = record(scene);
    assert_eq!(verdict(&record), None);
    change(&mut record);
    verdict(&record)
}

fn claim(pair: (usize, Obstacle), time: f64) -> Claim {
    let end = None;
    Claim { pair, end, time }
}

/// A disc that passes another by 2⁻⁴⁰.
#[test]
fn a_spurious_impact() {
    let passing = Disc::at([-4.0, 2.0 + 2_f64.powi(-40)], 1).velocity([1, 0]);
    let scene = Scene::builder("pass")
        .frame(9, 1)
        .disc(Disc::at([0, 0], 1))
        .disc(passing);
    let kind = changed(scene, |record| {
        record.claims.push(claim((0, Obstacle::Disc(1)), 4.0));
        record.states.push(record.states[0].clone());
    });
    assert_eq!(kind, Some(Kind::Spurious));
}

/// Both are moved and made to flee, the first one faster, to where they touch.
#[test]
fn an_impact_of_bodies_that_part() {
    let kind = changed(head_on(), |record| {
        let [first, second] = &mut record.states[0][..] else {
            unreachable!("there are two discs")
        };
        (first.position[0], first.velocity[0]) = (4.0, -2.0);
        (second.position[0], second.velocity[0]) = (5.0, -1.0);
    });
    assert_eq!(kind, Some(Kind::Spurious));
}

/// Too late or too early by 2⁻⁴⁰.
#[test]
fn a_wrong_time() {
    for sign in [1.0, -1.0] {
        let off = |record: &mut Record| record.claims[0].time += sign * 2_f64.powi(-40);
        assert_eq!(changed(head_on(), off), Some(Kind::Mistimed));
    }
}

#[test]
fn time_does_not_go_back() {
    let scene = head_on().wall([6, -2], [6, 2]);
    let kind = changed(scene, |record| record.claims[1].time = 0.5);
    assert_eq!(kind, Some(Kind::Mistimed));
}

#[test]
fn a_missed_impact() {
    let kind = changed(head_on(), |record| {
        record.claims.clear();
        record.states.truncate(1);
    });
    assert_eq!(kind, Some(Kind::Missed));
}

/// d2 meets the wall at 2, after d0 and d1 have met.
#[test]
fn a_misordered_impact() {
    let scene = head_on()
        .disc(Disc::at([0, 9], 1).velocity([0, 1]))
        .wall([-2, 12], [2, 12]);
    let kind = changed(scene, |record| record.claims.swap(0, 1));
    assert_eq!(kind, Some(Kind::Misordered));
}

/// Beside the wall's end, which is said to be its interior.
#[test]
fn a_wrong_part_of_a_wall() {
    let falling = Disc::at([-0.5, 3.0], 1).velocity([0, -1]);
    let scene = || {
        Scene::builder("end")
            .frame(4, 1)
            .disc(falling.clone())
            .wall([0, 0], [4, 0])
    };
    assert_eq!(record(scene()).claims[0].end, Some(End::From));
    for end in [None, Some(End::To)] {
        let kind = changed(scene(), |record| record.claims[0].end = end);
        assert_eq!(kind, Some(Kind::Spurious));
    }
    let inside = Disc::at([0.5, 3.0], 1).velocity([0, -1]);
    let scene = Scene::builder("interior")
        .frame(4, 1)
        .disc(inside)
        .wall([0, 0], [4, 0]);
    let kind = changed(scene, |record| record.claims[0].end = Some(End::From));
    assert_eq!(kind, Some(Kind::Spurious));
}

#[test]
fn energy_that_is_gained() {
    let kind = changed(head_on(), |record| {
        record.states[1][1].velocity[0] += 2_f64.powi(-40)
    });
    assert_eq!(kind, Some(Kind::Energy));
}

#[test]
fn an_overlap_after_an_impact() {
    let kind = changed(head_on(), |record| {
        record.states[1][0].position[0] += 2_f64.powi(-40)
    });
    assert_eq!(kind, Some(Kind::Overlap));
}

#[test]
fn a_number_that_is_none() {
    let kind = changed(head_on(), |record| {
        record.states[1][0].velocity[1] = f64::NAN
    });
    assert_eq!(kind, Some(Kind::NotFinite));
}

#[test]
fn another_bit() {
    let (one, mut other) = (record(head_on()), record(head_on()));
    assert!(one.is_identical(&other));
    other.states[1][1].velocity[1] = -0.0;
    assert!(!one.is_identical(&other));
}

#[test]
fn a_panic() {
    let found = guarded(trial::<f64>(Run::Timeline), || panic!("at {}", 7));
    assert_eq!(found.unwrap_err().kind, Kind::Panic(String::from("at 7")));
}

#[test]
fn findings_are_readable() {
    let fault = (Kind::Missed, 17.25);
    let pair = (0, Obstacle::Wall(3));
    let finding = trial::<f64>(Run::Resumed { after: 4 }).finding(fault, 5, Some(pair), 1.5);
    assert_eq!(finding.pair, Some(names(pair)));
    assert_eq!(
        finding.to_string(),
        "timeline resumed after impact 4: missed impact: d0 and w3, impact 5 at 1.5, \
         17.250 times the margin (f64)"
    );
}
