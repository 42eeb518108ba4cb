//! The tables of the page.

use carom::judge::Tally;
use maud::{Markup, html};

use crate::cli::compare::row::Row;
use crate::cli::compare::units::{digits, duration, error};

/// Every algorithm in every arithmetic.
pub(super) fn candidates(rows: &[Row]) -> Markup {
    html! {
        div.wide { table {
            thead { tr {
                th.name { "algorithm" }
                th.name { "arithmetic" }
                th { "time a frame" small { "median, quartiles" } }
                th { "an impact" }
                th { "matched" }
                th { "missed" }
                th { "spurious" }
                th { "misordered" }
                th { "time error" small { "ulps" } }
                th { "position error" small { "largest of a frame" } }
                th { "energy error" small { "relative" } }
                th { "overlaps" small { "deepest" } }
                th { "follows the truth" small { "for impacts" } }
                th { "undecided" small { "frames" } }
            } }
            tbody {
                @for (index, row) in rows.iter().enumerate() {
                    (candidate(row, is_first(rows, index)))
                }
            }
        } }
    }
}

/// Whether a row begins another algorithm.
fn is_first(rows: &[Row], index: usize) -> bool {
    let algorithm = |index: usize| rows[index].candidate.algorithm;
    index > 0 && algorithm(index - 1) != algorithm(index)
}

fn candidate(row: &Row, is_first: bool) -> Markup {
    let tally = &row.tally;
    let [low, high] = row.spread_a_frame();
    let arithmetic = row.candidate.arithmetic_name();
    html! {
        tr.first[is_first] data-algorithm=(row.candidate) data-arithmetic=(arithmetic) {
            th.name { (row.candidate) }
            td.name { (arithmetic)
                @if row.failure.is_some() { small { "ends after frame " (row.frames) } } }
            td { (duration(row.seconds_a_frame()))
                 small { (duration(low)) " – " (duration(high)) } }
            td { (row.seconds_an_impact().map(duration).unwrap_or_default()) }
            td data-count="matched" { (tally.matched) }
            (wrong("missed", tally.missed))
            (wrong("spurious", tally.spurious))
            (wrong("misordered", tally.misordered))
            td { @if tally.matched > 0 { (error(tally.time_error_ulps)) } @else { "–" } }
            td { (error(tally.position_error)) }
            td { (error(tally.energy_error)) }
            td { (tally.overlaps)
                 @if tally.overlaps > 0 { small { (error(tally.overlap_depth)) } } }
            td { (followed(row)) }
            td.zero[row.undecided == 0] { (row.undecided) }
        }
    }
}

fn wrong(name: &str, count: u64) -> Markup {
    html! {
        td.zero[count == 0].bad[count > 0] data-count=(name) { (count) }
    }
}

fn followed(row: &Row) -> String {
    match &row.difference {
        Some(difference) => difference.followed.to_string(),
        None => format!("all {}", row.impacts),
    }
}

/// Which part of a frame algorithm's errors is the algorithm's.
pub(super) fn parts(rows: &[&Row]) -> Markup {
    html! {
        div.wide { table {
            thead {
                tr { th.name { "" } th.name { "" }
                     th colspan="4" { "the algorithm's part" } th colspan="4" { "rounding's part" } th { "" } }
                tr { th.name { "algorithm" } th.name { "arithmetic" }
                     @for _ in 0..2 {
                         th { "missed" } th { "spurious" } th { "misordered" } th { "position error" }
                     } th { "frames left out" } }
            }
            tbody { @for row in rows { @if let Some(split) = &row.split {
                tr { th.name { (row.candidate) } td.name { (row.candidate.arithmetic_name()) }
                     (part(&split.algorithm)) (part(&split.rounding))
                     td.zero[split.undecided == 0] { (split.undecided) } }
            } } }
        } }
    }
}

fn part(tally: &Tally) -> Markup {
    html! {
        @for count in [tally.missed, tally.spurious, tally.misordered] {
            td.zero[count == 0] { (count) }
        }
        td.zero[tally.position_error == 0.0] { (error(tally.position_error)) }
    }
}

/// Any numbers: a name a row, and under each heading a value.
pub(super) fn numbers(headings: &[String], rows: &[(String, Vec<String>)]) -> Markup {
    html! {
        div.wide { table {
            thead { tr { @for (index, heading) in headings.iter().enumerate() {
                th.name[index == 0] { (heading) }
            } } }
            tbody { @for (name, values) in rows {
                tr { th.name { (name) } @for value in values { td { (value) } } }
            } }
        } }
    }
}

/// A part of a hundred.
pub(super) fn percent(value: f64) -> String {
    format!("{} %", digits(value, 2))
}
