//! Matched, missed, spurious and misordered impacts of one frame.
//!
//! Impacts match as the k-th impact of their pair within the frame. Order
//! matters only between impacts that share a disc; a matched impact is
//! misordered if, for one of its discs, it stands before a matched one that
//! the truth puts ahead of it.

use std::collections::HashMap;

use super::tally::{Logged, Tally, ulp};
use crate::body::{BodyId, Pair};

/// What is wrong with an impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "json",
    derive(serde::Serialize),
    serde(rename_all = "kebab-case")
)]
pub enum Fault {
    /// It is in the truth only.
    Missed,
    /// It is in the candidate only.
    Spurious,
    /// It is in both, in another order that matters.
    Misordered,
}

impl Fault {
    /// Its name in files and on pages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Missed => "missed",
            Self::Spurious => "spurious",
            Self::Misordered => "misordered",
        }
    }
}

/// The impacts of a frame, held against the true ones.
#[derive(Clone, Debug)]
pub struct FrameComparison<'a> {
    truth: &'a [Logged],
    candidate: &'a [Logged],
    /// The places of matched impacts in both, in the candidate's order.
    matches: Vec<(usize, usize)>,
    /// Which of the matches come before one that the truth puts ahead.
    misordered: Vec<bool>,
}

impl<'a> FrameComparison<'a> {
    /// Matches the impacts of a frame with the true ones.
    pub fn new(truth: &'a [Logged], candidate: &'a [Logged]) -> Self {
        let matches = match_up(truth, candidate);
        Self {
            misordered: misordered(truth, candidate, &matches),
            truth,
            candidate,
            matches,
        }
    }

    /// What is wrong: the missed impacts as the truth has them, then the others as the
    /// candidate has them.
    pub fn faults(&self) -> impl Iterator<Item = (Fault, Logged)> {
        let mut is_matched = [
            vec![false; self.truth.len()],
            vec![false; self.candidate.len()],
        ];
        for &(t, c) in &self.matches {
            is_matched[0][t] = true;
            is_matched[1][c] = true;
        }
        let [in_truth, in_candidate] = is_matched;
        let missed = unmatched(self.truth, in_truth).map(|impact| (Fault::Missed, impact));
        let spurious = unmatched(self.candidate, in_candidate);
        let misordered = self.matches.iter().zip(&self.misordered);
        let misordered = misordered.filter(|(_, is_misordered)| **is_misordered);
        missed
            .chain(spurious.map(|impact| (Fault::Spurious, impact)))
            .chain(misordered.map(|((_, c), _)| (Fault::Misordered, self.candidate[*c])))
    }

    /// How many agree, how many do not, and how far the times are from the true ones.
    pub fn tally(&self) -> Tally {
        let matched = self.matches.len();
        let is_misordered = self
            .misordered
            .iter()
            .filter(|is_misordered| **is_misordered);
        let mut tally = Tally {
            matched: matched as u64,
            missed: (self.truth.len() - matched) as u64,
            spurious: (self.candidate.len() - matched) as u64,
            misordered: is_misordered.count() as u64,
            ..Tally::default()
        };
        for &(t, c) in &self.matches {
            let time = self.truth[t].time;
            let error = (self.candidate[c].time - time).abs();
            tally.time_error = tally.time_error.max(error);
            tally.time_error_ulps = tally.time_error_ulps.max(error / ulp(time));
        }
        tally
    }
}

/// Judges the impacts of a frame against the true ones.
pub fn compare_frame(truth: &[Logged], candidate: &[Logged]) -> Tally {
    FrameComparison::new(truth, candidate).tally()
}

/// The impacts that have no match.
fn unmatched(impacts: &[Logged], is_matched: Vec<bool>) -> impl Iterator<Item = Logged> {
    let impacts = impacts.iter().zip(is_matched);
    impacts
        .filter(|(_, is_matched)| !is_matched)
        .map(|(impact, _)| *impact)
}

/// The k-th impact of each pair in one with that in the other, by the
/// candidate's order.
pub(super) fn match_up(truth: &[Logged], candidate: &[Logged]) -> Vec<(usize, usize)> {
    let mut places: HashMap<Pair, Vec<usize>> = HashMap::new();
    for (index, impact) in truth.iter().enumerate().rev() {
        places.entry(impact.pair).or_default().push(index);
    }
    let matches = candidate.iter().enumerate();
    matches
        .filter_map(|(c, impact)| Some((places.get_mut(&impact.pair)?.pop()?, c)))
        .collect()
}

/// Which matches come before one that the truth puts ahead.
fn misordered(truth: &[Logged], candidate: &[Logged], matches: &[(usize, usize)]) -> Vec<bool> {
    let mut earliest: HashMap<BodyId, usize> = HashMap::new();
    let mut misordered = vec![false; matches.len()];
    for (is_misordered, &(t, c)) in misordered.iter_mut().zip(matches).rev() {
        let Pair { a, b } = candidate[c].pair;
        let discs = [a, b]
            .into_iter()
            .filter(|body| matches!(body, BodyId::Disc(_)));
        for disc in discs {
            let ahead = earliest.entry(disc).or_insert(t);
            *is_misordered |= *ahead < t && !simultaneous(&truth[*ahead], &truth[t]);
            *ahead = t.min(*ahead);
        }
    }
    misordered
}

/// Whether two impacts are proven to happen at the same time, so that their
/// order is a convention.
fn simultaneous(one: &Logged, other: &Logged) -> bool {
    one.tie.is_some() && one.tie == other.tie
}
