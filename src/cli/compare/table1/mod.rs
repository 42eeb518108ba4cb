//! `carom table1`: the paper's Table 1, redone (P6.3, P6.4).
//!
//! The frame algorithms look at all pairs, as in the paper; the timeline has its
//! grid. Beside the paper's two rows there is what it could not have: more passes,
//! matching clocks, and the timeline in every arithmetic.

mod picture;

use std::fmt::Write;
use std::path::PathBuf;
use std::time::Duration;

use carom::frame::{BroadPhase, Passes};
use carom::scalar::Number;
use carom::scene::generate::table1;
use carom::simulation::Algorithm;

use super::candidate::Candidate;
use super::cost::Effort;
use super::row::Row;
use super::{Comparison, table};
use crate::cli::choice::{ArithmeticName, BudgetArguments};
use crate::cli::error::Error;
use crate::cli::exit::Exit;
use crate::cli::output::{Output, is_standard, standard};
use picture::{Column, picture};

/// The seed of the scenes in the gallery.
const SEED: u64 = 42;

/// What goes into the costs: all pairs take long, and so get more time than usual.
const EFFORT: Effort = Effort {
    share: Duration::from_secs(2),
    rounds: 15,
};

/// What the paper reports of an algorithm, in milliseconds a frame: with the full
/// radius, and with a third of it.
const PAPER: [(Algorithm, [f64; 2]); 2] = [
    (Algorithm::Single, [24.03, 22.30]),
    (Algorithm::Multiple(Passes::Count(2)), [36.77, 31.36]),
];

/// The two scenes: their names, and what they are.
const SCENES: [(&str, &str); 2] = [
    ("table1-full", "full radius"),
    ("table1-third", "33 % of the radius"),
];

/// Redo the paper's Table 1, with what is wrong in each row.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  carom table1 --svg table-1.svg")]
pub(in crate::cli) struct Arguments {
    /// Where the picture goes; - is standard output, in place of the tables.
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    #[command(flatten)]
    budget: BudgetArguments,
}

pub(in crate::cli) fn execute(arguments: &Arguments) -> Result<Exit, Error> {
    let output = arguments.svg.as_deref().map(Output::open).transpose()?;
    let comparisons = [Number::from(1), third()].map(|scale| {
        let scene = table1(SEED, &scale)?;
        let compared = Comparison::new(scene, &candidates(), EFFORT, &arguments.budget.budget());
        compared.map_err(|reason| Error::Unsupported {
            file: String::from("table 1"),
            reason,
        })
    });
    let comparisons = comparisons.into_iter().collect::<Result<Vec<_>, _>>()?;
    if !arguments.svg.as_deref().is_some_and(is_standard) {
        Output::open(&standard())?.write_text(&text(&comparisons))?;
    }
    if let (Some(output), Some(svg)) = (output, of_comparisons(&comparisons)) {
        output.write_text(&svg)?;
    }
    Ok(Exit::Success)
}

/// The paper's 33 %.
fn third() -> Number {
    "0.33".parse().expect("a decimal")
}

fn candidates() -> Vec<Candidate> {
    let passes = (2..=5).map(|passes| Algorithm::Multiple(Passes::Count(passes)));
    let frames = std::iter::once(Algorithm::Single)
        .chain(passes)
        .chain([Algorithm::Synchronised(Passes::Count(2))]);
    let candidate = |(algorithm, arithmetic)| Candidate {
        algorithm,
        arithmetic,
        broad_phase: BroadPhase::AllPairs,
    };
    let frames = frames.map(|algorithm| (algorithm, ArithmeticName::Binary64));
    let arithmetics = [
        ArithmeticName::Binary64,
        ArithmeticName::Filtered,
        ArithmeticName::Exact,
    ];
    let timelines = arithmetics.map(|arithmetic| (Algorithm::Timeline, arithmetic));
    frames.chain(timelines).map(candidate).collect()
}

fn text(comparisons: &[Comparison]) -> String {
    let mut text: String = comparisons.iter().map(table::render).collect();
    for (comparison, column) in comparisons.iter().zip(0..) {
        let Some(ratio) = ratio(&comparison.rows) else {
            continue;
        };
        let [(_, single), (_, multiple)] = PAPER;
        let paper = multiple[column] / single[column];
        let (_, name) = SCENES[column];
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "{name}: two passes take {ratio:.2} times the time of one; the paper: {paper:.2}"
        );
    }
    text
}

/// How much longer two passes take than one.
fn ratio(rows: &[Row]) -> Option<f64> {
    let seconds = |algorithm| {
        let mut found = rows.iter().filter(|row| {
            row.candidate.algorithm == algorithm
                && row.candidate.arithmetic == ArithmeticName::Binary64
        });
        found.next().map(Row::seconds_a_frame)
    };
    let [(single, _), (multiple, _)] = PAPER;
    Some(seconds(multiple)? / seconds(single)?)
}

/// The picture, if both scenes of the paper are among the comparisons.
pub(super) fn of_comparisons(comparisons: &[Comparison]) -> Option<String> {
    let columns = SCENES.iter().enumerate().map(|(column, (id, title))| {
        let mut found = comparisons.iter().filter(|known| known.scene.id() == *id);
        Some(Column {
            title,
            rows: rows(&found.next()?.rows),
            paper: PAPER.map(|(algorithm, times)| (algorithm, times[column])),
        })
    });
    let columns: Vec<_> = columns.collect::<Option<_>>()?;
    let [full, third] = columns.try_into().ok()?;
    Some(picture(&[full, third]))
}

/// The rows of the picture: binary64, and the timeline in every arithmetic.
fn rows(rows: &[Row]) -> Vec<&Row> {
    let rows = rows.iter().filter(|row| {
        let candidate = row.candidate;
        candidate.algorithm == Algorithm::Timeline
            || candidate.arithmetic == ArithmeticName::Binary64
    });
    rows.collect()
}
