//! How one candidate fares.

use std::time::Duration;

use carom::judge::{Difference, Fault, Judged, Logged, Split, Tally, first_difference};
use carom::scene::Scene;

use super::Verdict;
use super::candidate::Candidate;
use super::cost::Cost;
use super::truth::Truth;

/// A candidate, held against the truth.
pub(super) struct Row {
    pub(super) candidate: Candidate,
    /// The times that its frames take while nothing else runs.
    pub(super) cost: Cost,
    /// The impacts of all frames, and the largest errors.
    pub(super) tally: Tally,
    /// Which part of the errors is the algorithm's, where that was asked.
    pub(super) split: Option<Split>,
    /// What is wrong in it, frame by frame.
    pub(super) faults: Vec<(Fault, Logged)>,
    /// The frames judged.
    pub(super) frames: u64,
    /// The frames of which the truth could not be decided.
    pub(super) undecided: u64,
    /// The impacts of the whole run.
    pub(super) impacts: usize,
    /// Where it first leaves the true course of events.
    pub(super) difference: Option<Difference>,
    /// Why it could not be run to its end.
    pub(super) failure: Option<String>,
}

impl Row {
    /// Judges a candidate by a run.
    pub(super) fn new(scene: &Scene, candidate: Candidate, truth: &Truth, judged: Judged) -> Self {
        Self {
            candidate,
            cost: Cost::new(vec![judged.cost]),
            tally: judged.tally,
            split: judged.split,
            frames: judged.frames,
            undecided: judged.undecided,
            impacts: judged.log.len(),
            difference: difference(truth, &judged, scene),
            failure: failure(&judged),
            faults: judged.faults,
        }
    }

    /// The row with the times that the candidate takes alone, unless there are none.
    pub(super) fn with_cost(self, alone: Cost) -> Self {
        match alone.runs() {
            0 => self,
            _ => Self {
                cost: alone,
                ..self
            },
        }
    }

    /// Whether any of that is wrong with it.
    pub(super) fn has(&self, verdict: Verdict) -> bool {
        match verdict {
            Verdict::Missed => self.tally.missed > 0,
            Verdict::Spurious => self.tally.spurious > 0,
            Verdict::Misordered => self.tally.misordered > 0,
            Verdict::Undecided => self.undecided > 0 || self.failure.is_some(),
        }
    }

    /// The time that a frame takes, in seconds: the median.
    pub(super) fn seconds_a_frame(&self) -> f64 {
        self.a_frame(self.cost.median().unwrap_or_default())
    }

    /// The quartiles of that.
    pub(super) fn spread_a_frame(&self) -> [f64; 2] {
        let quartiles = self.cost.quartiles().unwrap_or_default();
        quartiles.map(|time| self.a_frame(time))
    }

    /// The time that an impact of the candidate takes, if there is one.
    pub(super) fn seconds_an_impact(&self) -> Option<f64> {
        let all = self.seconds_a_frame() * self.frames.max(1) as f64;
        (self.impacts > 0).then(|| all / self.impacts as f64)
    }

    fn a_frame(&self, time: Duration) -> f64 {
        time.as_secs_f64() / self.frames.max(1) as f64
    }
}

/// Why a candidate could not be run to its end.
fn failure(judged: &Judged) -> Option<String> {
    let endless = || String::from("infinitely many impacts before a finite time");
    let open = judged.failure.as_ref().map(ToString::to_string);
    open.or_else(|| judged.accumulates.then(endless))
}

/// The first difference, as far as both the truth and the candidate go.
fn difference(truth: &Truth, judged: &Judged, scene: &Scene) -> Option<Difference> {
    let frame = scene.frame();
    let reached = match judged.failure.is_some() || judged.accumulates {
        true => judged.frames as f64 * frame.duration.to_f64(),
        false => f64::INFINITY,
    };
    let end = reached.min(truth.reached);
    first_difference(&before(&truth.impacts, end), &before(&judged.log, end))
}

fn before(impacts: &[Logged], end: f64) -> Vec<Logged> {
    let known = impacts.iter().filter(|impact| impact.time < end);
    known.copied().collect()
}
