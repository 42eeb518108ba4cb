//! How one candidate fares.

use std::time::Duration;

use carom::arithmetic::Budget;
use carom::judge::{Difference, Judged, Logged, Tally, first_difference};
use carom::scene::Scene;
use carom::support::Unsupported;

use super::Verdict;
use super::candidate::Candidate;
use super::truth::Truth;

/// A candidate, held against the truth.
pub(super) struct Row {
    pub(super) candidate: Candidate,
    /// The time that its frames took.
    pub(super) cost: Duration,
    /// The impacts of all frames, and the largest errors.
    pub(super) tally: Tally,
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
    /// Runs and judges a candidate.
    pub(super) fn judge(
        scene: &Scene,
        candidate: Candidate,
        truth: &Truth,
        budget: &Budget,
    ) -> Result<Self, Unsupported> {
        let judged = candidate.judge(scene, budget)?;
        Ok(Self {
            candidate,
            cost: judged.cost,
            tally: judged.tally,
            frames: judged.frames,
            undecided: judged.undecided,
            impacts: judged.log.len(),
            difference: difference(truth, &judged, scene),
            failure: failure(&judged),
        })
    }

    /// The row with the time that the candidate takes alone, where that was
    /// measured.
    pub(super) fn with_cost(self, alone: Option<Duration>) -> Self {
        Self {
            cost: alone.unwrap_or(self.cost),
            ..self
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

    /// The time that a frame took, in seconds.
    pub(super) fn seconds_a_frame(&self) -> f64 {
        self.cost.as_secs_f64() / self.frames.max(1) as f64
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
