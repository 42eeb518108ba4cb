//! Comparisons as JSON, `carom/compare/1`.

use carom::body::Pair;
use carom::frame::Passes;
use carom::judge::{Difference, Split, Tally};
use carom::simulation::Algorithm;
use serde::Serialize;

use super::Comparison;
use super::row::Row;
use super::truth::Truth;

/// All comparisons of a call.
#[derive(Serialize)]
pub(super) struct Report<'a> {
    schema: &'static str,
    carom: &'static str,
    scenes: Vec<SceneReport<'a>>,
}

#[derive(Serialize)]
struct SceneReport<'a> {
    scene: &'a str,
    frames: u64,
    frame_duration: f64,
    truth: TruthReport,
    rows: Vec<RowReport>,
}

#[derive(Serialize)]
struct TruthReport {
    impacts: usize,
    bits: u32,
    seconds: f64,
    undecided: Option<OpenReport>,
    accumulation: Option<LimitReport>,
}

/// The time that infinitely many impacts approach.
#[derive(Serialize)]
struct LimitReport {
    limit: f64,
    proven: bool,
}

/// A decision that was left open, and when.
#[derive(Serialize)]
struct OpenReport {
    time: f64,
    question: String,
}

#[derive(Serialize)]
struct RowReport {
    algorithm: String,
    passes: Option<u32>,
    substeps: Option<u32>,
    arithmetic: &'static str,
    seconds_a_frame: f64,
    seconds_a_frame_quartiles: [f64; 2],
    runs: usize,
    seconds_an_impact: Option<f64>,
    impacts: usize,
    matched: u64,
    missed: u64,
    spurious: u64,
    misordered: u64,
    time_error: f64,
    time_error_ulps: f64,
    position_error: f64,
    energy_error: f64,
    overlaps: u64,
    overlap_depth: f64,
    split: Option<SplitReport>,
    frames: u64,
    undecided_frames: u64,
    failure: Option<String>,
    first_difference: Option<DifferenceReport>,
}

/// The parts of a frame algorithm's errors.
#[derive(Serialize)]
struct SplitReport {
    algorithm: PartReport,
    rounding: PartReport,
    undecided_frames: u64,
}

#[derive(Serialize)]
struct PartReport {
    missed: u64,
    spurious: u64,
    misordered: u64,
    position_error: f64,
}

#[derive(Serialize)]
struct DifferenceReport {
    time: f64,
    followed: usize,
    disc: carom::body::BodyId,
    truth: Option<MeetingReport>,
    candidate: Option<MeetingReport>,
    text: String,
}

#[derive(Serialize)]
struct MeetingReport {
    time: f64,
    a: carom::body::BodyId,
    b: carom::body::BodyId,
}

impl<'a> Report<'a> {
    pub(super) fn new(comparisons: &'a [Comparison]) -> Self {
        Self {
            schema: "carom/compare/1",
            carom: env!("CARGO_PKG_VERSION"),
            scenes: comparisons.iter().map(SceneReport::new).collect(),
        }
    }
}

impl<'a> SceneReport<'a> {
    fn new(comparison: &'a Comparison) -> Self {
        let frame = comparison.scene.frame();
        Self {
            scene: comparison.scene.id(),
            frames: frame.count,
            frame_duration: frame.duration.to_f64(),
            truth: TruthReport::new(&comparison.truth),
            rows: comparison.rows.iter().map(RowReport::new).collect(),
        }
    }
}

impl TruthReport {
    fn new(truth: &Truth) -> Self {
        let open = truth.open.as_ref();
        Self {
            impacts: truth.impacts.len(),
            bits: truth.bits,
            seconds: truth.cost.as_secs_f64(),
            undecided: open.map(|open| OpenReport {
                time: truth.reached,
                question: open.question.clone(),
            }),
            accumulation: truth.accumulation.as_ref().map(|found| LimitReport {
                limit: found.limit_to_f64(),
                proven: found.proven,
            }),
        }
    }
}

impl RowReport {
    fn new(row: &Row) -> Self {
        let Row {
            candidate, tally, ..
        } = row;
        Self {
            algorithm: candidate.algorithm.to_string(),
            passes: passes(candidate.algorithm),
            substeps: substeps(candidate.algorithm),
            arithmetic: candidate.arithmetic_name(),
            seconds_a_frame: row.seconds_a_frame(),
            seconds_a_frame_quartiles: row.spread_a_frame(),
            runs: row.cost.runs(),
            seconds_an_impact: row.seconds_an_impact(),
            impacts: row.impacts,
            matched: tally.matched,
            missed: tally.missed,
            spurious: tally.spurious,
            misordered: tally.misordered,
            time_error: tally.time_error,
            time_error_ulps: tally.time_error_ulps,
            position_error: tally.position_error,
            energy_error: tally.energy_error,
            overlaps: tally.overlaps,
            overlap_depth: tally.overlap_depth,
            split: row.split.as_ref().map(SplitReport::from),
            frames: row.frames,
            undecided_frames: row.undecided,
            failure: row.failure.clone(),
            first_difference: row.difference.as_ref().map(DifferenceReport::new),
        }
    }
}

impl From<&Split> for SplitReport {
    fn from(split: &Split) -> Self {
        Self {
            algorithm: PartReport::from(&split.algorithm),
            rounding: PartReport::from(&split.rounding),
            undecided_frames: split.undecided,
        }
    }
}

impl From<&Tally> for PartReport {
    fn from(tally: &Tally) -> Self {
        Self {
            missed: tally.missed,
            spurious: tally.spurious,
            misordered: tally.misordered,
            position_error: tally.position_error,
        }
    }
}

impl DifferenceReport {
    fn new(difference: &Difference) -> Self {
        Self {
            time: difference.time,
            followed: difference.followed,
            disc: difference.disc,
            truth: difference.truth.map(MeetingReport::from),
            candidate: difference.candidate.map(MeetingReport::from),
            text: difference.to_string(),
        }
    }
}

impl From<(Pair, f64)> for MeetingReport {
    fn from((pair, time): (Pair, f64)) -> Self {
        Self {
            time,
            a: pair.a,
            b: pair.b,
        }
    }
}

fn passes(algorithm: Algorithm) -> Option<u32> {
    match algorithm {
        Algorithm::Multiple(Passes::Count(count))
        | Algorithm::Synchronised(Passes::Count(count)) => Some(count),
        _ => None,
    }
}

fn substeps(algorithm: Algorithm) -> Option<u32> {
    match algorithm {
        Algorithm::Retroactive { substeps } => Some(substeps),
        _ => None,
    }
}
