//! A comparison as a table, with the first differences in words.

use std::fmt::Write;

use carom::scene::Scene;
use comfy_table::{CellAlignment, Table, presets};

use super::Comparison;
use super::row::Row;
use super::truth::Truth;
use super::units::duration;

const HEADINGS: [&str; 10] = [
    "algorithm",
    "arithmetic",
    "time a frame",
    "matched",
    "missed",
    "spurious",
    "misordered",
    "time error",
    "position error",
    "undecided",
];

/// The columns of names, which are aligned to the left.
const NAMES: usize = 2;

/// The comparison as text for people.
pub(super) fn render(comparison: &Comparison) -> String {
    let Comparison { scene, truth, rows } = comparison;
    let mut text = format!(
        "{}\n{}\n\n{}\n\n",
        title(scene),
        truth_line(truth),
        table(rows)
    );
    for row in rows {
        let name = format!("{} {}", row.candidate, row.candidate.arithmetic_name());
        // Writing to a string does not fail.
        let _ = writeln!(text, "{name}: {}", course(row));
    }
    text.push('\n');
    text
}

fn title(scene: &Scene) -> String {
    let frame = scene.frame();
    format!(
        "{}: discs: {}, walls: {}, frames: {} of {}",
        scene.id(),
        scene.discs().len(),
        scene.walls().len(),
        frame.count,
        frame.duration,
    )
}

fn truth_line(truth: &Truth) -> String {
    let found = format!(
        "exact timeline: {} impacts, {} bits, {}",
        truth.impacts.len(),
        truth.bits,
        duration(truth.cost.as_secs_f64()),
    );
    match (&truth.open, &truth.accumulation) {
        (Some(open), _) => format!("{found}; undecided from t = {} on: {open}", truth.reached),
        (None, Some(end)) => format!("{found}; accumulation: {end}"),
        (None, None) => found,
    }
}

fn table(rows: &[Row]) -> Table {
    let mut table = Table::new();
    table
        .load_preset(presets::ASCII_MARKDOWN)
        .set_header(HEADINGS);
    for row in rows {
        table.add_row(cells(row));
    }
    for column in table.column_iter_mut().skip(NAMES) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

fn cells(row: &Row) -> [String; HEADINGS.len()] {
    let tally = &row.tally;
    let time_error = match tally.matched {
        0 => String::from("-"),
        _ => error(tally.time_error),
    };
    [
        row.candidate.to_string(),
        row.candidate.arithmetic_name().to_owned(),
        duration(row.seconds_a_frame()),
        tally.matched.to_string(),
        tally.missed.to_string(),
        tally.spurious.to_string(),
        tally.misordered.to_string(),
        time_error,
        error(tally.position_error),
        row.undecided.to_string(),
    ]
}

/// Where a candidate leaves the truth.
fn course(row: &Row) -> String {
    let course = match &row.difference {
        Some(difference) => difference.to_string(),
        None => format!("follows the truth throughout, impacts: {}", row.impacts),
    };
    match &row.failure {
        Some(open) => format!("{course}; ends after frame {}: {open}", row.frames),
        None => course,
    }
}

fn error(size: f64) -> String {
    match size {
        0.0 => String::from("0"),
        _ => format!("{size:.1e}"),
    }
}
