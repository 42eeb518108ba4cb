//! A run as a page of its own, to be played: one pane, or two in step of which the
//! second is the truth. It loads nothing; trajectories are drawn from the legs between
//! impacts, in closed form.

use carom::arithmetic::Arithmetic;
use carom::judge::{Logged, first_difference};
use carom::run::{Outcome, Status};
use carom::scalar::Number;
use carom::scene::Scene;
use carom::simulation::Algorithm;
use maud::{Markup, PreEscaped, html};
use serde::Serialize;

use super::html;
use super::motion::{Motion, Point};

const STYLE: &str = include_str!("replay.css");
const SCRIPT: &str = include_str!("replay.js");

/// A run in a replay.
#[derive(Debug, Serialize)]
pub(super) struct Pane {
    title: String,
    motion: Motion,
    #[serde(skip)]
    log: Vec<Logged>,
    /// The time up to which the run is known.
    #[serde(skip)]
    reached: f64,
}

#[derive(Serialize)]
struct Replay<'a> {
    scene: &'a str,
    walls: Vec<[Point; 2]>,
    panes: &'a [Pane],
    difference: Option<Parting>,
}

/// Where the first pane leaves the second.
#[derive(Serialize)]
struct Parting {
    time: f64,
    text: String,
}

impl Pane {
    /// A run that has kept the circumstances of its impacts.
    pub(super) fn new<S: Arithmetic>(
        scene: &Scene,
        algorithm: Algorithm,
        outcome: &Outcome<S>,
    ) -> Self {
        let motion = Motion::new(scene, algorithm, outcome);
        let (reached, limit) = match outcome.status {
            Status::Complete => (f64::INFINITY, String::new()),
            _ => (motion.until, format!(", up to t = {}", motion.until)),
        };
        Self {
            title: format!("{}, {algorithm}, {}{limit}", scene.id(), S::NAME),
            log: outcome.impacts.iter().map(Logged::from).collect(),
            motion,
            reached,
        }
    }
}

/// The page of one run, or of a run and the truth.
pub(super) fn page(scene: &Scene, panes: &[Pane]) -> String {
    let title = format!("{}: replay", scene.id());
    let body = html! {
        h1 { (title) }
        div #panes {
            @for pane in panes { figure { figcaption { (pane.title) } canvas {} } }
        }
        (controls(panes.len() > 1))
        script #data type="application/json" { (PreEscaped(data(scene, panes))) }
        script { (PreEscaped(SCRIPT)) }
    };
    html::page(&title, STYLE, &body)
}

fn controls(has_truth: bool) -> Markup {
    html! {
        canvas #axis aria-hidden="true" {}
        input #time type="range" min="0" max="1" step="any" value="0" aria-label="Time";
        div #controls {
            button #play { "Play" }
            button #previous { "Previous impact" }
            button #next { "Next impact" }
            @if has_truth { button #difference { "First difference" } }
            label { "Speed " input #speed type="range" min="-3" max="3" step="0.5" value="0"; }
            output #clock {}
        }
        p #parting {}
        p.keys {
            kbd { "space" } " play, " kbd { "←" } " " kbd { "→" } " move, "
            kbd { "p" } " " kbd { "n" } " previous and next impact"
            @if has_truth { ", " kbd { "d" } " first difference" }
        }
    }
}

/// The data, such that no text in it ends the script.
fn data(scene: &Scene, panes: &[Pane]) -> String {
    let number = |point: &[Number; 2]| point.each_ref().map(Number::to_f64);
    let walls = scene.walls().iter();
    let difference = match panes {
        [run, truth] => parting(run, truth),
        _ => None,
    };
    let replay = Replay {
        scene: scene.id(),
        walls: walls.map(|w| [number(&w.from), number(&w.to)]).collect(),
        panes,
        difference,
    };
    let json = serde_json::to_string(&replay).expect("all keys are strings");
    json.replace("</", "<\\/").replace("<!--", "<\\u0021--")
}

/// Where a run leaves the truth, as far as both are known.
fn parting(run: &Pane, truth: &Pane) -> Option<Parting> {
    let end = run.reached.min(truth.reached);
    let known = |pane: &Pane| {
        let log = pane.log.iter().filter(|impact| impact.time < end);
        log.copied().collect::<Vec<_>>()
    };
    first_difference(&known(truth), &known(run)).map(|found| Parting {
        time: found.time,
        text: found.to_string(),
    })
}
