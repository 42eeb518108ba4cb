//! A run to be played: one pane, or two in step of which the second is the truth. It
//! loads nothing; trajectories are drawn from the legs between impacts, in closed form.

mod fault;

use carom::arithmetic::Arithmetic;
use carom::body::Pair;
use carom::judge::{Difference, Fault, Logged, first_difference};
use carom::run::{Outcome, Status};
use carom::scalar::Number;
use carom::scene::Scene;
use carom::simulation::Algorithm;
use maud::{Markup, PreEscaped, html};
use serde::Serialize;

use super::html;
use super::motion::{Motion, Point};
use fault::Misplaced;

/// How a replay looks.
pub(super) const STYLE: &str = include_str!("replay.css");

/// What plays all replays of a page; at its end.
const SCRIPT: &str = concat!(
    include_str!("motion.js"),
    include_str!("canvas.js"),
    include_str!("replay.js")
);

/// A run in a replay.
#[derive(Debug, Serialize)]
pub(super) struct Pane {
    title: String,
    motion: Motion,
    /// What is wrong with it, in the order of time.
    faults: Vec<Misplaced>,
    /// The frames that were judged, and those of which the truth is not known; none if
    /// nothing was judged.
    #[serde(skip)]
    judged: Option<[u64; 2]>,
    #[serde(skip)]
    log: Vec<Logged>,
    /// The time up to which the run is known.
    #[serde(skip)]
    reached: f64,
}

#[derive(Serialize)]
struct Data<'a> {
    scene: &'a str,
    /// The duration of a frame.
    frame: f64,
    walls: Vec<[Point; 2]>,
    panes: &'a [Pane],
    difference: Option<&'a Parting>,
}

/// Where a run leaves the truth.
#[derive(Debug, Serialize)]
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
            faults: Vec::new(),
            judged: None,
            reached,
        }
    }

    /// The same with marks at what is wrong in it; and how many frames were judged, and of
    /// how many of them the truth is not known.
    pub(super) fn with_faults(self, faults: &[(Fault, Logged)], judged: [u64; 2]) -> Self {
        Self {
            faults: fault::placed(&self.motion, faults),
            judged: Some(judged),
            ..self
        }
    }
}

/// One pane or two, and where they part.
#[derive(Debug)]
pub(super) struct Replay {
    panes: Vec<Pane>,
    difference: Option<Parting>,
    /// What there is to say of the truth, if the replay is about that.
    told: Option<String>,
}

impl Replay {
    /// A run alone.
    pub(super) fn of(pane: Pane) -> Self {
        Self {
            panes: vec![pane],
            difference: None,
            told: None,
        }
    }

    /// A run beside the truth.
    pub(super) fn beside(run: Pane, truth: Pane) -> Self {
        let difference = parting(&run, &truth);
        let told = match &difference {
            Some(found) => format!("The run {}.", found.text),
            None => String::from("Both have the same impacts of each disc in the same order."),
        };
        Self {
            panes: vec![run, truth],
            difference,
            told: Some(told),
        }
    }

    /// The truth, with the first impact of a log that is not the true one.
    pub(super) fn of_log(truth: Pane, found: Option<&Difference>) -> Self {
        let truly = found.and_then(|found| found.truth);
        let logged = found.and_then(|found| found.candidate);
        let fault = |kind, impact: Option<(Pair, f64)>| {
            let (pair, time) = impact?;
            let tie = None;
            Some((kind, Logged { pair, time, tie }))
        };
        let faults = [fault(Fault::Missed, truly), fault(Fault::Spurious, logged)];
        let faults: Vec<_> = faults.into_iter().flatten().collect();
        let told = found.map_or_else(
            || String::from("The log has the true impacts of each disc in their order."),
            |found| {
                format!(
                    "The log {found}. A dashed ring is where that truly happens, a ring with a \
                     cross where the discs of the log's impact truly are at its time."
                )
            },
        );
        Self {
            panes: vec![Pane {
                faults: fault::placed(&truth.motion, &faults),
                ..truth
            }],
            difference: found.map(Parting::from),
            told: Some(told),
        }
    }

    /// A page of its own.
    pub(super) fn page(self, scene: &Scene) -> String {
        let title = format!("{}: replay", scene.id());
        let body = html! {
            h1 { (title) }
            (self.part(scene))
            (script())
        };
        let style = format!("{}{STYLE}", include_str!("page.css"));
        html::page(&title, &style, &body)
    }

    /// A part of a page that has the style and, after it, the script.
    pub(super) fn part(&self, scene: &Scene) -> Markup {
        let has_truth = self.told.is_some();
        html! {
            div.replay tabindex="0" {
                div.panes {
                    @for pane in &self.panes { figure { figcaption { (pane.title) } canvas {} } }
                }
                canvas.axis aria-hidden="true" {}
                input.time type="range" min="0" max="1" step="any" value="0" aria-label="Time";
                (controls(has_truth))
                @if let Some(told) = &self.told { p.parting { (told) } }
                (legend(&self.panes[0]))
                (keys(has_truth))
                script.data type="application/json" { (PreEscaped(self.data(scene))) }
            }
        }
    }

    /// The data, such that no text in it ends the script.
    fn data(&self, scene: &Scene) -> String {
        let number = |point: &[Number; 2]| point.each_ref().map(Number::to_f64);
        let walls = scene.walls().iter();
        let data = Data {
            scene: scene.id(),
            frame: scene.frame().duration.to_f64(),
            walls: walls.map(|w| [number(&w.from), number(&w.to)]).collect(),
            panes: &self.panes,
            difference: self.difference.as_ref(),
        };
        let json = serde_json::to_string(&data).expect("all keys are strings");
        json.replace("</", "<\\/").replace("<!--", "<\\u0021--")
    }
}

/// What plays the replays before it.
pub(super) fn script() -> Markup {
    html! { script { (PreEscaped(SCRIPT)) } }
}

fn controls(has_truth: bool) -> Markup {
    html! {
        div.controls {
            button.play { "Play" }
            button.previous { "Previous impact" }
            button.next { "Next impact" }
            @if has_truth {
                button.wrong { "Next wrong impact" }
                button.difference { "First difference" }
            }
            label { "Speed "
                input.speed type="range" min="-3" max="3" step="0.5" value="0"; }
            output.clock {}
        }
    }
}

/// What the marks mean, and how many there are of each.
fn legend(run: &Pane) -> Markup {
    let Some([frames, undecided]) = run.judged else {
        return html! {};
    };
    let item = |kind: Fault, meaning: &str| {
        let count = run.faults.iter().filter(|fault| fault.kind == kind).count();
        html! { li class=(kind.name()) { b { (count) " " (kind.name()) } ": " (meaning) } }
    };
    html! {
        ul.faults {
            (item(Fault::Missed, "a dashed ring; in the truth only"))
            (item(Fault::Spurious, "a ring with a cross; in the run only"))
            (item(Fault::Misordered, "two rings; in another order that matters"))
        }
        p.pale { "Each of " (frames) " frames is judged from the run's own state at its start,
            so that one error does not condemn what follows; the panes are whole runs from one
            start."
            @if undecided > 0 { " Of " (undecided) " frames the truth is not known." }
        }
    }
}

fn keys(has_truth: bool) -> Markup {
    html! {
        p.pale {
            kbd { "space" } " play, " kbd { "←" } " " kbd { "→" } " move, "
            kbd { "p" } " " kbd { "n" } " previous and next impact"
            @if has_truth {
                ", " kbd { "w" } " next wrong impact, " kbd { "d" } " first difference"
            }
        }
    }
}

/// Where a run leaves the truth, as far as both are known.
fn parting(run: &Pane, truth: &Pane) -> Option<Parting> {
    let end = run.reached.min(truth.reached);
    let known = |pane: &Pane| {
        let log = pane.log.iter().filter(|impact| impact.time < end);
        log.copied().collect::<Vec<_>>()
    };
    first_difference(&known(truth), &known(run)).map(|found| Parting::from(&found))
}

impl From<&Difference> for Parting {
    fn from(found: &Difference) -> Self {
        Self {
            time: found.time,
            text: found.to_string(),
        }
    }
}
