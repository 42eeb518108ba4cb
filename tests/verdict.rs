//! Logs of other programs, judged: by hand, and by what carom's own algorithms are known to
//! do.

use std::ops::ControlFlow::Continue;

use carom::body::{BodyId, Pair};
use carom::judge::{Decision, Logged, Margin, Reference, Standing, Verdict};
use carom::run::Options;
use carom::scene::{Disc, Scene, SceneBuilder};

/// d0 and d2 come to d1, which rests, from two sides: d0 touches it at 1, d2 later by so
/// many ulps of 1.
fn pinched(ulps: f64) -> Scene {
    let far = 3.0 + ulps * f64::EPSILON;
    let disc = |x: f64, speed: f64| Disc::at([x, 0.0], 1).velocity([speed, 0.0]);
    let discs = [disc(-3.0, 1.0), disc(0.0, 0.0), disc(far, -1.0)];
    scene(Scene::builder("pinched").discs(discs).frame(2, 1))
}

fn scene(scene: SceneBuilder) -> Scene {
    scene.build().expect("a valid scene")
}

fn met(a: u32, b: BodyId, time: f64) -> Logged {
    Logged {
        pair: Pair::new(BodyId::Disc(a), b),
        time,
        tie: None,
    }
}

fn discs(a: u32, b: u32, time: f64) -> Logged {
    met(a, BodyId::Disc(b), time)
}

fn judged(scene: &Scene, log: &[Logged]) -> Verdict {
    let reference = Reference::find(scene, &Options::default(), &mut |_| Continue(()));
    reference.expect("a scene of the timeline").judge(log)
}

/// Equal masses swap velocities: d1 goes on to d2, and comes back to d0.
#[test]
fn the_truth_follows_itself() {
    let scene = pinched(256.0);
    let reference = Reference::find(&scene, &Options::default(), &mut |_| Continue(())).unwrap();
    let truth: Vec<_> = reference.impacts().iter().map(Logged::from).collect();
    let pairs: Vec<_> = truth.iter().map(|impact| impact.pair.to_string()).collect();
    assert_eq!(pairs, ["d0 and d1", "d1 and d2", "d0 and d1"]);
    let verdict = reference.judge(&truth);
    assert_eq!(verdict.standing, Standing::Follows);
    assert_eq!((verdict.matched, verdict.difference), (3, None));
}

/// 256 ulps can be told apart; two cannot be asked of binary64, and at one time it is a
/// matter of convention who is first.
#[test]
fn an_order_is_judged_by_its_margin() {
    let swapped = [discs(1, 2, 1.0), discs(0, 1, 1.0), discs(1, 2, 1.0)];
    let standing = |ulps| judged(&pinched(ulps), &swapped).standing;
    assert_eq!(standing(256.0), Standing::Differs);
    assert_eq!(standing(2.0), Standing::Close);
    assert_eq!(standing(0.0), Standing::Simultaneous);
}

/// After the tie at 1, in which d1 comes to rest again, d0 comes back from a wall at 4 and
/// hits d1 at 7, when d2 is at the other wall; d1 and d2 meet at 10; at 13 d1 is back at
/// d0, and d2 at the wall.
#[test]
fn a_rule_that_is_confirmed_excuses_no_more() {
    let room = pinched(0.0).to_builder().frame(14, 1);
    let room = scene(room.wall([-6, -9], [-6, 9]).wall([9, -9], [9, 9]));
    let reference = Reference::find(&room, &Options::default(), &mut |_| Continue(())).unwrap();
    let truth: Vec<_> = reference.impacts().iter().map(Logged::from).collect();
    let times: Vec<_> = truth.iter().map(|impact| impact.time).collect();
    assert_eq!(times, [1.0, 1.0, 1.0, 4.0, 7.0, 7.0, 10.0, 13.0, 13.0]);
    assert_eq!(
        reference.judge(&truth[..6]).standing,
        Standing::Simultaneous
    );
    assert_eq!(reference.judge(&truth[..7]).standing, Standing::Differs);
}

#[test]
fn a_margin_is_the_time_between_two_impacts() {
    let swapped = [discs(1, 2, 1.0), discs(0, 1, 1.0)];
    let verdict = judged(&pinched(256.0), &swapped);
    let Margin {
        of, value, ulps, ..
    } = verdict.margin.expect("a margin");
    let apart = 256.0 * f64::EPSILON;
    assert_eq!((of, value, ulps), (Decision::Order, apart, 256.0));
    assert_eq!(verdict.missed, Some(0));
}

/// d0 passes above d1, which rests: by how much, in ulps of 2.
fn passing(ulps: f64) -> Scene {
    let passer = Disc::at([-4.0, 2.0 + ulps * 2.0 * f64::EPSILON], 1).velocity([1, 0]);
    let discs = [passer, Disc::at([0, 0], 1)];
    scene(Scene::builder("passing").discs(discs).frame(8, 1))
}

#[test]
fn a_pass_is_judged_by_its_margin() {
    let invented = [discs(0, 1, 4.0)];
    let verdict = |ulps| judged(&passing(ulps), &invented);
    assert_eq!(verdict(0.0).standing, Standing::Tangent);
    assert_eq!(verdict(2.0).standing, Standing::Close);
    let far = verdict(4096.0);
    assert_eq!(far.standing, Standing::Differs);
    let Margin { of, ulps, .. } = far.margin.expect("a margin");
    assert_eq!(of, Decision::Meeting);
    // d² - R² = (R + m)² - R² is 2 R m and m², which is left out: m / 2R, some 5e-13.
    approx::assert_relative_eq!(ulps, 4096.0, max_relative = 1e-12);
    // Who truly meets, and is missed, is judged likewise.
    assert_eq!(judged(&passing(-2.0), &[]).standing, Standing::Close);
    assert_eq!(judged(&passing(-4096.0), &[]).standing, Standing::Differs);
}

/// A wall stops d0; a log that has it go through says nothing more of it.
#[test]
fn what_is_missed_is_told() {
    let ball = Disc::at([0, 0], 1).velocity([1, 0]);
    let room = Scene::builder("room").disc(ball).wall([3, -9], [3, 9]);
    let verdict = judged(&scene(room.frame(4, 1)), &[]);
    assert_eq!(verdict.standing, Standing::Differs);
    let difference = verdict.difference.expect("a difference");
    let wall = Pair::new(BodyId::Disc(0), BodyId::Wall(0));
    assert_eq!(difference.truth, Some((wall, 2.0)));
    assert_eq!((difference.candidate, verdict.missed), (None, Some(0)));
}

/// A wall's ends are as far from the path as the radius: it passes them in tangency, and
/// yet it meets the wall. A path that clips an end by little is another matter.
#[test]
fn a_wall_is_not_missed_by_little() {
    let met = |height: f64| {
        let ball = Disc::at([0.0, height], 1).velocity([1, 0]);
        let room = Scene::builder("room").disc(ball).wall([3, -1], [3, 1]);
        judged(&scene(room.frame(9, 1)), &[]).standing
    };
    assert_eq!(met(0.0), Standing::Differs);
    assert_eq!(met(2.0 - f64::EPSILON), Standing::Close);
    assert_eq!(met(1.5), Standing::Differs);
}

/// A program that tells of a contact in each of its steps.
#[test]
fn contacts_told_again_are_no_collisions() {
    let log = [
        discs(0, 1, 1.0),
        discs(0, 1, 1.01),
        discs(1, 2, 1.02),
        discs(1, 2, 1.03),
    ];
    let verdict = judged(&pinched(256.0), &log[..]);
    assert_eq!(verdict.repeats, 2);
    // d1 comes back to d0, which the log has not.
    assert_eq!((verdict.standing, verdict.matched), (Standing::Differs, 2));
}

/// Binary64 follows a gas for some hundred impacts, and is not blamed for what comes
/// then; steps of a frame err at once.
#[cfg(feature = "cli")]
#[test]
fn binary64_is_not_blamed_for_chaos() {
    use carom::run::run;
    use carom::scene::generate::gas;
    use carom::simulation::Algorithm;

    let dense = gas(7, 10, 0.3).expect("a scene").to_builder();
    let dense = scene(dense.frame(1, 40));
    let of = |algorithm| {
        let outcome = run::<f64>(
            &dense,
            algorithm,
            &Options::default(),
            &mut |_| Continue(()),
        );
        let impacts = outcome.expect("a scene of all algorithms").impacts;
        let log: Vec<_> = impacts.iter().map(Logged::from).collect();
        judged(&dense, &log)
    };
    let timeline = of(Algorithm::Timeline);
    assert_eq!(timeline.standing, Standing::Beyond);
    assert!(timeline.matched > 100, "{}", timeline.matched);
    let steps = of(Algorithm::Retroactive { substeps: 1 });
    assert_eq!(steps.standing, Standing::Differs);
    assert!(steps.matched < timeline.matched / 2);
}

/// A ball meets a wall at 2, the run ends so many ulps of 2 later: a log without the impact
/// may be right as far as binary64 can tell; as may one with it, where the run ends before.
#[test]
fn the_end_of_a_run_is_a_decision_of_its_own() {
    let room = |ulps: f64| {
        let end = 2.0 + ulps * 2.0 * f64::EPSILON;
        let ball = Disc::at([0, 0], 1).velocity([1, 0]);
        let room = Scene::builder("room").disc(ball).wall([3, -9], [3, 9]);
        scene(room.frame(end, 1))
    };
    let hit = [met(0, BodyId::Wall(0), 2.0)];
    let margin = |ulps: f64, log: &[Logged]| {
        let verdict = judged(&room(ulps), log);
        let Margin {
            of, value, ulps, ..
        } = verdict.margin.expect("a margin");
        (verdict.standing, of, value / f64::EPSILON, ulps)
    };
    let end = Decision::End;
    assert_eq!(margin(0.0, &[]), (Standing::Close, end, 0.0, 0.0));
    assert_eq!(margin(1.0, &[]), (Standing::Close, end, 2.0, 1.0));
    // Below 2 an ulp is half as long, and so the end is one that is a number.
    assert_eq!(margin(-1.0, &hit), (Standing::Close, end, 2.0, 2.0));
    for ulps in [-1024.0, 1024.0] {
        let log = if ulps < 0.0 { &hit[..] } else { &[] };
        let (standing, of, ..) = margin(ulps, log);
        assert_eq!((standing, of), (Standing::Differs, end));
    }
    assert_eq!(judged(&room(0.0), &hit).standing, Standing::Follows);
}

/// Discs that move as one and touch do not collide, and a log that says so tells of what
/// rounding makes of it. A billionth apart they do not either, and that can be told.
#[test]
fn discs_that_move_as_one_are_a_matter_of_convention() {
    let standing = |gap: f64| {
        let discs = [4.0, 6.0 + gap].map(|x| Disc::at([x, 0.0], 1).velocity([1, 0]));
        let scene = scene(Scene::builder("as one").discs(discs).frame(1, 1));
        judged(&scene, &[self::discs(0, 1, 0.5)]).standing
    };
    assert_eq!(standing(0.0), Standing::Tangent);
    assert_eq!(standing(1e-9), Standing::Differs);
}
