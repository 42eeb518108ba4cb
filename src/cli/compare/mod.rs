//! `carom compare`: accuracy against time, for every algorithm and
//! arithmetic.

mod candidate;
mod colour;
mod cost;
mod page;
mod report;
mod row;
mod table;
pub(super) mod table1;
mod truth;
mod units;

use std::path::{Path, PathBuf};
use std::time::Duration;

use carom::arithmetic::Budget;
use carom::scalar::Exact;
use carom::scene::Scene;
use carom::simulation::Algorithm;
use carom::support::{Unsupported, check_support};
use clap::ValueEnum;
use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

use super::choice::{AlgorithmName, ArithmeticName, BudgetArguments, Phase};
use super::error::Error;
use super::exit::Exit;
use super::output::{Output, check_distinct, is_standard, standard};
use super::progress;
use candidate::{Candidate, Selection};
use cost::{Effort, in_turn};
use page::Study;
use report::Report;
use row::Row;
use truth::Truth;

/// What goes into the costs of a scene's candidates.
const EFFORT: Effort = Effort {
    share: Duration::from_millis(500),
    rounds: 15,
};

/// Compare algorithms and arithmetics with what truly happens.
///
/// Frame by frame: the truth of a frame is the exact timeline, started from
/// the candidate's own state at the start of that frame. Then, for the whole
/// run, where each candidate first leaves the true course of events.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  carom compare scenes/table1-full.json
  carom compare scenes/table1-full.json --html report.html
  carom compare scenes/*.json --algorithms timeline --arithmetics f64 --fail-on missed,spurious")]
pub(super) struct Arguments {
    /// The scenes; - is standard input.
    #[arg(value_name = "SCENE", required = true)]
    scenes: Vec<PathBuf>,
    /// Where the results go as JSON; - is standard output, in place of the
    /// table.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Where the results go as a page that needs nothing else, with figures; it also
    /// has runs of changed scenes, which take a while.
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// End with status 1 if a candidate has any of these.
    #[arg(long, value_name = "VERDICT", value_delimiter = ',')]
    fail_on: Vec<Verdict>,
    /// The passes a frame of multiple, a row each; synchronised has the first
    /// of them.
    #[arg(
        long,
        value_name = "K",
        value_delimiter = ',',
        default_value = "2,3,4,5",
        value_parser = clap::value_parser!(u32).range(1..)
    )]
    passes: Vec<u32>,
    /// The steps a frame of retroactive.
    #[arg(long, value_name = "N", default_value_t = 1,
        value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    substeps: u32,
    /// The algorithms.
    #[arg(
        long,
        value_name = "A",
        value_delimiter = ',',
        default_value = "retroactive,single,multiple,synchronised,timeline"
    )]
    algorithms: Vec<AlgorithmName>,
    /// The numbers that they compute with.
    #[arg(
        long,
        value_name = "N",
        value_delimiter = ',',
        default_value = "f64,filtered,exact"
    )]
    arithmetics: Vec<ArithmeticName>,
    /// How the frame algorithms find pairs that may meet; it changes only what they
    /// cost. The timeline has its grid.
    #[arg(long, value_name = "PHASE", value_enum, default_value = "grid")]
    broad_phase: Phase,
    #[command(flatten)]
    budget: BudgetArguments,
}

/// What may be wrong with a candidate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Verdict {
    /// An impact in the truth only.
    Missed,
    /// An impact in the candidate only.
    Spurious,
    /// Impacts in another order that matters.
    Misordered,
    /// A decision that the budget left open.
    Undecided,
}

/// A scene with what truly happens in it, and how the candidates fare.
struct Comparison {
    scene: Scene,
    truth: Truth,
    rows: Vec<Row>,
}

impl Comparison {
    /// The truth and the time that each takes alone, then all judgements side
    /// by side.
    fn new(
        scene: Scene,
        candidates: &[Candidate],
        effort: Effort,
        budget: &Budget,
    ) -> Result<Self, Unsupported> {
        check(&scene, candidates)?;
        let truth = Truth::find(&scene, budget)?;
        let runners = candidates.iter();
        let mut runners: Vec<_> = runners.map(|all| all.runner(&scene, budget)).collect();
        let costs = in_turn(runners.len(), effort, |index| runners[index].time());
        drop(runners);
        let bar = progress::stages(candidates.len() as u64);
        let jobs = candidates.par_iter().zip(costs);
        let rows = jobs.map(|(candidate, cost)| {
            let judged = candidate.judge_and_split(&scene, budget)?;
            bar.inc(1);
            Ok(Row::new(&scene, *candidate, &truth, judged).with_cost(cost))
        });
        let rows: Result<Vec<_>, _> = rows.collect();
        bar.finish_and_clear();
        let rows = rows?;
        Ok(Self { scene, truth, rows })
    }
}

pub(super) fn execute(arguments: &Arguments) -> Result<Exit, Error> {
    check_distinct(&[("--json", &arguments.json), ("--html", &arguments.html)])?;
    let paths = arguments.scenes.iter();
    let scenes: Vec<_> = paths.map(Scene::read).collect::<Result<_, _>>()?;
    let json = arguments.json.as_deref();
    let json = json.map(Output::open).transpose()?;
    let html = arguments.html.as_deref();
    let html = html.map(Output::open).transpose()?;
    let mut comparisons = Vec::new();
    for (scene, path) in scenes.into_iter().zip(&arguments.scenes) {
        let comparison = arguments.compare(scene, path)?;
        if !arguments.writes_to_standard() {
            let text = table::render(&comparison);
            Output::open(&standard())?.write_text(&text)?;
        }
        comparisons.push(comparison);
    }
    if let Some(output) = json {
        let report = Report::new(&comparisons);
        output.write(|writer| {
            serde_json::to_writer_pretty(&mut *writer, &report)?;
            writer.write_all(b"\n")
        })?;
    }
    if let Some(output) = html {
        output.write_text(&arguments.page(&comparisons))?;
    }
    Ok(arguments.judge(&comparisons))
}

impl Arguments {
    /// Whether a report takes the place of the table.
    fn writes_to_standard(&self) -> bool {
        let reports = [&self.json, &self.html].into_iter().flatten();
        reports.into_iter().any(|path| is_standard(path))
    }

    /// The page, with its runs of changed scenes.
    fn page(&self, comparisons: &[Comparison]) -> String {
        let (phase, budget) = (self.broad_phase.of_frames(), self.budget.budget());
        let studies = comparisons.iter();
        let studies = studies.map(|each| Study::run(each, &self.algorithms, phase, &budget));
        page::page(comparisons, &studies.collect::<Vec<_>>(), phase)
    }

    fn compare(&self, scene: Scene, path: &Path) -> Result<Comparison, Error> {
        let candidates = self.selection().candidates();
        let compared = Comparison::new(scene, &candidates, EFFORT, &self.budget.budget());
        compared.map_err(|reason| Error::Unsupported {
            file: path.display().to_string(),
            reason,
        })
    }

    fn selection(&self) -> Selection<'_> {
        Selection {
            algorithms: &self.algorithms,
            arithmetics: &self.arithmetics,
            passes: &self.passes,
            substeps: self.substeps,
            broad_phase: self.broad_phase.of_frames(),
        }
    }

    fn judge(&self, comparisons: &[Comparison]) -> Exit {
        let mut rows = comparisons.iter().flat_map(|comparison| &comparison.rows);
        let failed = rows.any(|row| self.fail_on.iter().any(|verdict| row.has(*verdict)));
        let mut truths = comparisons.iter().map(|comparison| &comparison.truth);
        if failed {
            Exit::Difference
        } else if truths.any(|truth| !truth.is_whole()) {
            Exit::OutOfBudget
        } else {
            Exit::Success
        }
    }
}

/// Whether the truth can be found and each candidate can be run.
fn check(scene: &Scene, candidates: &[Candidate]) -> Result<(), Unsupported> {
    check_support::<Exact>(scene, Algorithm::Timeline)?;
    candidates
        .iter()
        .try_for_each(|candidate| candidate.check(scene))
}
