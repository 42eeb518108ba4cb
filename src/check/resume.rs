//! A run stopped at an impact, written as a scene, read, and resumed.
//!
//! Writing rounds each position by no more than a margin. So the scene that is
//! read is judged like any other, and what the first run met next must be right
//! for that scene, too, within two margins.

use std::ops::ControlFlow;

use super::bodies::Motion;
use super::finding::{Finding, Run};
use super::flight::judge as judge_record;
use super::record::Record;
use super::window::Window;
use super::{Effort, trial};
use crate::arithmetic::Arithmetic;
use crate::log::end_scene;
use crate::run::{Options, run};
use crate::scene::Scene;
use crate::simulation::Algorithm;

/// The impacts of a resumed run that are judged.
const IMPACTS: usize = 2;

/// Stops and resumes a recorded run at some of its impacts, evenly spread.
///
/// # Errors
///
/// The first finding.
pub(super) fn judge<S: Arithmetic>(
    scene: &Scene,
    record: &Record,
    effort: &Effort,
) -> Result<(), Finding> {
    let step = record
        .claims
        .len()
        .div_ceil(effort.resumptions.max(1))
        .max(1);
    let stops = (0..record.claims.len()).step_by(step);
    stops
        .take(effort.resumptions)
        .try_for_each(|after| resume_after::<S>(scene, record, after))
}

fn resume_after<S: Arithmetic>(
    scene: &Scene,
    record: &Record,
    after: usize,
) -> Result<(), Finding> {
    let Some(rest) = rest::<S>(scene, after) else {
        return Ok(());
    };
    let Some(resumed) = Record::of::<S>(&rest, IMPACTS) else {
        return Ok(());
    };
    let trial = trial::<S>(Run::Resumed { after });
    judge_record(&resumed, scene.effects().restitution.is_elastic(), trial)?;
    let Some(next) = record.claims.get(after + 1) else {
        return Ok(());
    };
    let states = resumed.states[0].iter().zip(&record.states[after + 1]);
    let states: Vec<_> = states
        .map(|(state, flown)| Motion {
            pace: flown.pace,
            ..*state
        })
        .collect();
    let window = Window {
        clock: next.time,
        slack: 2.0,
        ..Window::new(
            &resumed.bodies,
            &states,
            next.time - record.claims[after].time,
        )
    };
    let verified = window.verify(next);
    verified.map_err(|fault| trial.finding(fault, after + 1, Some(next.pair), next.time))
}

/// The scene in which a run stands after an impact, by way of a file; none if
/// it has numbers that no run takes.
fn rest<S: Arithmetic>(scene: &Scene, after: usize) -> Option<Scene> {
    let options = Options {
        max_events: after as u64 + 1,
        ..Options::default()
    };
    let mut go_on = |_| ControlFlow::Continue(());
    let outcome = run::<S>(scene, Algorithm::Timeline, &options, &mut go_on).ok()?;
    let rest = end_scene(scene, &outcome, None).ok()?;
    let read = Scene::from_json(&rest.to_json()).expect("what is written is read");
    crate::support::check_support::<S>(&read, Algorithm::Timeline).ok()?;
    Some(read)
}
