//! Comparisons as one page that needs nothing else.
//!
//! Counts on it are those of the JSON report, from the same rows.

mod axis;
mod figures;
mod frontier;
mod growth;
mod machine;
pub(super) mod plot;
mod sweep;
mod table;

use carom::arithmetic::Budget;
use carom::frame::BroadPhase;
use carom::simulation::Algorithm;
use maud::{Markup, PreEscaped, html};

use self::growth::Growth;
use self::machine::Machine;
use self::sweep::{Kind, Sweep};
use super::candidate::Candidate;
use super::row::Row;
use super::truth::Truth;
use super::units::duration;
use super::{Comparison, table1};
use crate::cli::choice::AlgorithmName;
use crate::cli::html;
use crate::cli::replay::{self, Replay};

const STYLE: &str = include_str!("style.css");

/// What the page has beyond the comparisons: runs of changed scenes.
pub(super) struct Study {
    frames: u64,
    sweeps: Vec<Sweep>,
    growth: Option<Growth>,
    /// A candidate and the truth, to be played; none of a periodic scene.
    replay: Option<Replay>,
}

impl Study {
    /// Runs a scene with one thing changed after the other.
    pub(super) fn run(
        comparison: &Comparison,
        names: &[AlgorithmName],
        phase: BroadPhase,
        budget: &Budget,
    ) -> Self {
        let Comparison { scene, truth, .. } = comparison;
        let part = sweep::shortened(scene, truth);
        let part = part.unwrap_or_else(|| scene.clone());
        let kinds = Kind::ALL.into_iter();
        let sweeps = kinds.filter_map(|kind| Sweep::run(kind, &part, names, phase, budget));
        Self {
            frames: part.frame().count,
            sweeps: sweeps.collect(),
            growth: Growth::run(scene, truth, &part, budget),
            replay: played(comparison, budget),
        }
    }
}

/// The candidate that is played beside the truth: the first of the paper's multiple
/// collision algorithm, or else of all.
fn played(comparison: &Comparison, budget: &Budget) -> Option<Replay> {
    let Comparison { scene, rows, .. } = comparison;
    let is_multiple = |row: &&Row| matches!(row.candidate.algorithm, Algorithm::Multiple(_));
    let row = rows.iter().find(is_multiple).or(rows.first())?;
    let pane = row.candidate.pane(scene, budget)?;
    let pane = pane.with_faults(&row.faults, [row.frames, row.undecided]);
    let truth = Candidate::TRUTH.pane(scene, budget)?;
    Some(Replay::beside(pane, truth))
}

/// The page that shows comparisons, each with its study.
pub(super) fn page(comparisons: &[Comparison], studies: &[Study], phase: BroadPhase) -> String {
    let body = html! {
        h1 { "What accuracy costs" }
        p.pale { "Discs and walls collide: how wrong each way to simulate them is, and how long
            it takes. The truth is the exact timeline, every impact in its proven order." }
        nav { @for comparison in comparisons {
            a href={ "#" (comparison.scene.id()) } { (comparison.scene.id()) }
        } a href="#method" { "method" } }
        (redone(comparisons, phase))
        @for (comparison, study) in comparisons.iter().zip(studies) {
            (section(comparison, study))
        }
        (method(phase))
        (replay::script())
    };
    let style = format!("{STYLE}{}", replay::STYLE);
    html::page("What accuracy costs · carom", &style, &body)
}

/// The paper's Table 1, where its two scenes are compared.
fn redone(comparisons: &[Comparison], phase: BroadPhase) -> Markup {
    let picture = table1::of_comparisons(comparisons);
    html! {
        @if let Some(picture) = picture {
            section id="table-1" {
                h2 { "The paper's Table 1, redone" }
                div.wide { (PreEscaped(plot::for_page(&picture))) }
                p.pale { "Pairs that the frame algorithms look at: " (figures::phase_name(phase))
                    ". " code { "carom table1" } " has them look at all, as in the paper." }
            }
        }
    }
}

fn section(comparison: &Comparison, study: &Study) -> Markup {
    let Comparison { scene, truth, rows } = comparison;
    let frame = scene.frame();
    html! {
        section id=(scene.id()) {
            h2 { (scene.id()) }
            @if let Some(notes) = scene.notes() { p.pale { (notes) } }
            ul.facts {
                (fact(scene.discs().len(), "discs"))
                (fact(scene.walls().len(), "walls"))
                (fact(frame.count, &format!("frames of {}", frame.duration)))
                (fact(truth.impacts.len(), "impacts in truth"))
                (fact(truth.bits, "bits to prove them"))
                (fact(duration(truth.cost.as_secs_f64()), "for the proof, all attempts"))
            }
            (ending(truth))
            h3 { "Accuracy against time" }
            (figures::legend_of(rows))
            (figures::pareto(rows))
            (table::candidates(rows))
            (failures(rows))
            p.pale { "Each frame is judged from the candidate's own state at its start, taken exactly.
                Energy: of a frame's end, against its truth. Overlaps: pairs at the ends of all
                frames, decided exactly, by however little they overlap." }
            (figures::parts(rows))
            (figures::sweeps(&study.sweeps, study.frames, frame.count))
            @if let Some(growth) = &study.growth { (figures::growth(growth)) }
            @if let Some(replay) = &study.replay { h3 { "Replay" } (replay.part(scene)) }
        }
    }
}

fn fact(value: impl maud::Render, name: &str) -> Markup {
    html! { li { b { (value) } (name) } }
}

fn ending(truth: &Truth) -> Markup {
    html! {
        @if let Some(open) = &truth.open {
            p { "Undecided from t = " (truth.reached) " on: " (open.to_string()) }
        }
        @if let Some(end) = &truth.accumulation { p { "Accumulation: " (end.to_string()) } }
    }
}

/// The candidates that could not be run to their ends, which are not in the figures.
fn failures(rows: &[Row]) -> Markup {
    html! {
        @for row in rows { @if let Some(failure) = &row.failure {
            p { (row.candidate) " " (row.candidate.arithmetic_name()) " ends after frame "
                (row.frames) ", and is not in the figures: " (failure) }
        } }
    }
}

fn method(phase: BroadPhase) -> Markup {
    let machine = Machine::find();
    html! {
        section id="method" {
            h2 { "Method" }
            p { b { "Counts are exact." } " The truth of a frame is the exact timeline from the
                candidate's own state at the start of the frame, so that one error does not condemn
                what follows. Matched impacts are in both, missed ones in the truth only, spurious
                ones in the candidate only; misordered ones are in both, in another order that
                matters. The same command gives the same counts on every machine." }
            p { b { "Times are taken alone and in turn." } " Before anything is judged, all candidates
                run all frames once, one after the other, and again, until each has had its share of
                time or " (super::EFFORT.rounds) " runs; shown is the median, with the quartiles (of
                up to four runs the fastest and the slowest). In exact arithmetic it is the attempt
                whose bits suffice." }
            p { b { "Sweeps" } " judge a scene's first frames, as many as have about 2000 impacts, in
                binary64." }
            dl {
                @for (name, value) in machine.facts() { dt { (name) } dd { (value) } }
                dt { "pairs of a frame algorithm" } dd { (figures::phase_name(phase)) }
                dt { "this page" } dd { code { (machine::command()) } }
            }
        }
    }
}
