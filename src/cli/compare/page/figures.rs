//! The figures of the page, each with its words.

use std::collections::BTreeSet;

use carom::frame::BroadPhase;
use carom::simulation::Algorithm;
use maud::{Markup, PreEscaped, html};
use plotters::style::RGBColor;

use super::axis::{Axis, Scale, plain};
use super::frontier::frontier;
use super::growth::{Growth, Proof};
use super::plot::{Figure, Series, Spot};
use super::sweep::{Kind, Point, Sweep};
use super::table;
use crate::cli::choice::AlgorithmName;
use crate::cli::compare::colour::{self, Marker, variable};
use crate::cli::compare::row::Row;
use crate::cli::compare::units::{digits, duration, error};

fn time_axis() -> Axis {
    Axis::new("time a frame", Scale::Logarithmic, duration)
}

fn figure(drawn: &Figure, title: &str, words: &str) -> Markup {
    html! {
        figure { (PreEscaped(drawn.draw())) figcaption { b { (title) } " " (words) } }
    }
}

/// Which algorithm has which colour, and which arithmetic which shape.
pub(super) fn legend_of(rows: &[Row]) -> Markup {
    let mut algorithms: Vec<Algorithm> = rows.iter().map(|row| row.candidate.algorithm).collect();
    algorithms.dedup_by_key(|algorithm| algorithm.to_string());
    let mut arithmetics: Vec<_> = Vec::new();
    for candidate in rows.iter().map(|row| row.candidate) {
        let shape = (
            candidate.arithmetic_name(),
            colour::of_arithmetic(candidate.arithmetic),
        );
        if !arithmetics.contains(&shape) {
            arithmetics.push(shape);
        }
    }
    html! {
        ul.legend {
            @for algorithm in algorithms {
                li { (chip(colour::of_algorithm(algorithm), None)) (algorithm) }
            }
            @for (name, marker) in arithmetics { li { (chip(colour::INK, Some(marker))) (name) } }
        }
    }
}

/// A sample of a colour, or of a shape.
fn chip(colour: RGBColor, marker: Option<Marker>) -> Markup {
    let fill = variable(colour);
    html! {
        svg viewBox="0 0 14 14" aria-hidden="true" { @match marker {
            None => rect y="4" width="14" height="6" rx="3" fill=(fill) {},
            Some(Marker::Circle) => circle cx="7" cy="7" r="5.5" fill=(fill) {},
            Some(Marker::Triangle) => path d="M7 1L13 12H1Z" fill=(fill) {},
            Some(Marker::Square) => rect x="2" y="2" width="10" height="10" fill=(fill) {},
        } }
    }
}

/// Time against the two kinds of error, with what nothing else beats.
pub(super) fn pareto(rows: &[Row]) -> Markup {
    let wrong = Axis::new("wrong impacts", Scale::Logarithmic, plain);
    let place = Axis::new("position error, largest", Scale::Logarithmic, plain);
    html! {
        div.figures {
            (figure(
                &against_time(rows, wrong, |row| row.tally.wrong() as f64),
                "Time against wrong impacts.",
                "Missed, spurious and misordered ones. The dashed line is the frontier: what lies
                 above it is beaten in both by a named one. Zero has no place on a logarithmic
                 axis, so it has its own strip.",
            ))
            (figure(
                &against_time(rows, place, |row| row.tally.position_error),
                "Time against error.",
                "The farthest that a disc is from its true place at the end of a frame.",
            ))
        }
    }
}

fn against_time(rows: &[Row], y: Axis, of: impl Fn(&Row) -> f64) -> Figure {
    let rows: Vec<_> = rows.iter().filter(|row| row.failure.is_none()).collect();
    let points: Vec<_> = rows
        .iter()
        .map(|row| [row.seconds_a_frame(), of(row)])
        .collect();
    let best = frontier(&points);
    let series = rows.iter().zip(&points).enumerate();
    let series = series.map(|(index, (row, at))| Series {
        colour: colour::of_algorithm(row.candidate.algorithm),
        marker: colour::of_arithmetic(row.candidate.arithmetic),
        is_joined: false,
        points: vec![Spot {
            label: best.contains(&index).then(|| name(row)),
            is_below: best.iter().position(|of| *of == index) == Some(1),
            ..Spot::new(*at)
        }],
    });
    Figure {
        x: time_axis(),
        y,
        series: series.collect(),
        frontier: best.iter().map(|&index| points[index]).collect(),
    }
}

fn name(row: &Row) -> String {
    format!("{} {}", row.candidate, row.candidate.arithmetic_name())
}

/// What of the errors is the algorithm's, and what is rounding.
pub(super) fn parts(rows: &[Row]) -> Markup {
    let split: Vec<_> = rows.iter().filter(|row| row.split.is_some()).collect();
    html! {
        @if !split.is_empty() {
            h3 { "Whose error: the algorithm's or rounding's" }
            p { "From the candidate's own state at the start of each frame, the same algorithm takes
                that frame once more in exact arithmetic. Where that differs from the truth, the
                algorithm errs; where the candidate differs from that, its rounding does. Both count
                from the candidate's states, so chaos does not swamp them. Left out are frames
                in which exact arithmetic leaves a decision of the algorithm open." }
            (table::parts(&split))
        }
    }
}

impl Kind {
    fn title(self) -> &'static str {
        match self {
            Self::Passes => "Passes a frame",
            Self::Substeps => "Sub-steps a frame",
            Self::FrameLength => "Length of a frame",
            Self::Density => "Density",
            Self::Restitution => "Restitution",
        }
    }

    fn words(self) -> &'static str {
        match self {
            Self::Passes => "One pass of multiple is single.",
            Self::Substeps => {
                "So often a frame, retroactive moves all discs, tests for overlap and resolves it."
            }
            Self::FrameLength => {
                "The same time in shorter and longer frames, as multiples of the scene's. Each is
                 judged by its own frames; times are for what is one frame of the scene."
            }
            Self::Density => "The same discs with smaller radii, in percent of their own.",
            Self::Restitution => {
                "What an impact of two discs leaves of their approach: 1 is elastic."
            }
        }
    }

    fn axis(self, values: impl IntoIterator<Item = f64>) -> Axis {
        let (label, scale, format): (_, _, fn(f64) -> String) = match self {
            Self::Passes => ("passes", Scale::Linear, plain),
            Self::Substeps => ("sub-steps", Scale::Logarithmic, whole),
            Self::FrameLength => (
                "length of a frame, times the scene's",
                Scale::Logarithmic,
                eighth,
            ),
            Self::Density => ("radius, percent", Scale::Linear, part),
            Self::Restitution => ("coefficient of restitution", Scale::Linear, plain),
        };
        Axis::new(label, scale, format).with_ticks(values)
    }
}

fn whole(value: f64) -> String {
    value.round().to_string()
}

fn part(value: f64) -> String {
    (100.0 * value).round().to_string()
}

fn eighth(value: f64) -> String {
    match value {
        value if value > 0.9 => whole(value),
        value => format!("1/{}", (1.0 / value).round()),
    }
}

/// How error and cost move.
pub(super) fn sweeps(sweeps: &[Sweep], frames: u64, all: u64) -> Markup {
    html! {
        @if !sweeps.is_empty() {
            h3 { "How error and cost move" }
            p.pale { "Binary64, the first " (frames) " of " (all) " frames. Wrong: missed, spurious and
                misordered impacts among a hundred true ones." }
            @for sweep in sweeps { (one_sweep(sweep)) }
        }
    }
}

fn one_sweep(sweep: &Sweep) -> Markup {
    let values = sweep.lines.iter().flat_map(|(_, points)| points);
    let values: BTreeSet<_> = values.map(|point| point.value.to_bits()).collect();
    let axis = sweep.kind.axis(values.into_iter().map(f64::from_bits));
    let wrong = Axis::new("wrong, of 100 impacts", Scale::Linear, plain);
    let drawn = |y, of: &dyn Fn(&Point) -> Option<f64>| Figure {
        x: axis.clone(),
        y,
        series: sweep
            .lines
            .iter()
            .map(|(name, points)| line(*name, points, of))
            .collect(),
        frontier: Vec::new(),
    };
    html! {
        h4 { (sweep.kind.title()) }
        p { (sweep.kind.words()) (unknown(sweep)) }
        (legend(sweep))
        div.figures {
            (figure(&drawn(wrong, &Point::wrong_percent), "Wrong impacts.", ""))
            (figure(&drawn(time_axis(), &|point| Some(point.seconds)), "Cost.", ""))
        }
        details { summary { "the numbers" } (numbers(sweep)) }
    }
}

fn line(name: AlgorithmName, points: &[Point], of: &dyn Fn(&Point) -> Option<f64>) -> Series {
    let spots = points.iter();
    let spots = spots.filter_map(|point| Some(Spot::new([point.value, of(point)?])));
    Series {
        colour: colour_of(name),
        marker: Marker::Circle,
        is_joined: true,
        points: spots.collect(),
    }
}

fn colour_of(name: AlgorithmName) -> RGBColor {
    colour::of_algorithm(name.with(carom::frame::Passes::Count(1), 1))
}

fn name_of(name: AlgorithmName) -> String {
    name.with(carom::frame::Passes::Count(1), 1).to_string()
}

fn legend(sweep: &Sweep) -> Markup {
    html! {
        ul.legend { @for (name, _) in &sweep.lines {
            li { (chip(colour_of(*name), None)) (name_of(*name)) }
        } }
    }
}

/// How many frames have no known truth.
fn unknown(sweep: &Sweep) -> Markup {
    let points = sweep.lines.iter().flat_map(|(_, points)| points);
    let unknown: u64 = points.map(|point| point.unknown).sum();
    html! {
        @if unknown > 0 {
            " Of " (unknown) " frames the truth is undecided, or infinitely many impacts; they are
             left out."
        }
    }
}

fn numbers(sweep: &Sweep) -> Markup {
    let headings = [
        "algorithm",
        sweep.kind.title(),
        "matched",
        "missed",
        "spurious",
        "misordered",
        "wrong",
        "position error",
        "time a frame",
    ];
    let rows = sweep
        .lines
        .iter()
        .flat_map(|(name, points)| points.iter().map(|point| (name_of(*name), cells(point))));
    table::numbers(&headings.map(String::from), &rows.collect::<Vec<_>>())
}

fn cells(point: &Point) -> Vec<String> {
    let tally = &point.tally;
    vec![
        digits(point.value, 3),
        tally.matched.to_string(),
        tally.missed.to_string(),
        tally.spurious.to_string(),
        tally.misordered.to_string(),
        point
            .wrong_percent()
            .map(table::percent)
            .unwrap_or_default(),
        error(tally.position_error),
        duration(point.seconds),
    ]
}

/// What proof costs.
pub(super) fn growth(growth: &Growth) -> Markup {
    let longer = proofs(&growth.longer, |proof| {
        (
            [proof.impacts as f64, proof.seconds],
            Some(format!("{} bits", proof.bits)),
        )
    });
    let wider = proofs(&growth.wider, |proof| {
        let each = proof.seconds / proof.impacts as f64;
        ([f64::from(proof.bits), each], None)
    });
    let impacts = Axis::new("impacts", Scale::Logarithmic, plain);
    let time = Axis::new("time, all attempts", Scale::Logarithmic, duration);
    let bits = Axis::new("bits", Scale::Logarithmic, whole);
    let bits = bits.with_ticks(growth.wider.iter().map(|proof| f64::from(proof.bits)));
    let each = Axis::new("time an impact", Scale::Logarithmic, duration);
    let drawn = |x, y, series| Figure {
        x,
        y,
        series: vec![series],
        frontier: Vec::new(),
    };
    html! {
        h3 { "What proof costs" }
        p { "The exact timeline: each impact is proven to be next. Enclosures lose bits at every
            impact, so a longer run takes more of them from the start, and starts again where they
            do not suffice." }
        div.figures {
            (figure(&drawn(impacts, time, longer), "More impacts.",
                    "The time with all attempts, and the bits of the one that sufficed."))
            @if growth.wider.len() > 1 {
                (figure(&drawn(bits, each, wider), "More bits.",
                        "The same impacts, with as many bits as they take and with more."))
            }
        }
        details { summary { "the numbers" } (proof_numbers(growth)) }
    }
}

fn proof_numbers(growth: &Growth) -> Markup {
    let headings = ["run", "impacts", "bits", "time, all attempts", "an impact"];
    let kinds = [
        ("more impacts", &growth.longer),
        ("more bits", &growth.wider),
    ];
    let rows = kinds.into_iter().flat_map(|(name, proofs)| {
        proofs.iter().map(move |proof| {
            let each = proof.seconds / proof.impacts as f64;
            let counts = [proof.impacts.to_string(), proof.bits.to_string()];
            let times = [proof.seconds, each].map(duration);
            (name.to_owned(), counts.into_iter().chain(times).collect())
        })
    });
    table::numbers(&headings.map(String::from), &rows.collect::<Vec<_>>())
}

fn proofs(proofs: &[Proof], of: impl Fn(&Proof) -> ([f64; 2], Option<String>)) -> Series {
    let spots = proofs.iter().map(|proof| {
        let (at, label) = of(proof);
        Spot {
            label,
            ..Spot::new(at)
        }
    });
    Series {
        colour: colour::of_algorithm(Algorithm::Timeline),
        marker: Marker::Square,
        is_joined: true,
        points: spots.collect(),
    }
}

pub(super) fn phase_name(phase: BroadPhase) -> &'static str {
    match phase {
        BroadPhase::AllPairs => "all of them, as in the paper",
        BroadPhase::Grid => "those in the same cells of a grid",
        BroadPhase::Bsp => "those in the same parts of a binary space partition",
    }
}
