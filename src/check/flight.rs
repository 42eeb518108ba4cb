//! A recorded timeline held against the truth, impact by impact.
//!
//! Before each impact the stored state, taken exactly, flies on to the time of
//! the impact: the two must touch and approach there, and no pair may have got
//! into each other before. So an early error does not condemn what follows, and
//! no error is hidden behind an earlier one.

use super::bodies::discs;
use super::energy::drift;
use super::finding::{Finding, Kind, Run};
use super::record::{Claim, Record, names};
use super::verify::Fault;
use super::window::Window;
use crate::world::Obstacle;

/// Judges a record.
///
/// # Errors
///
/// The first finding.
pub(super) fn judge(record: &Record, elastic: bool, trial: Trial) -> Result<(), Finding> {
    let mut flight = Flight::new(record, trial);
    for index in 0..record.claims.len() {
        flight.judge_impact(index, elastic)?;
    }
    match record.until {
        Some(until) => flight.judge_end(until),
        None => Ok(()),
    }
}

/// Which run is judged.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trial {
    pub(super) run: Run,
    pub(super) arithmetic: &'static str,
}

impl Trial {
    pub(super) fn finding(
        self,
        (kind, beyond): Fault,
        impact: usize,
        pair: Option<(usize, Obstacle)>,
        time: f64,
    ) -> Finding {
        Finding {
            kind,
            run: self.run,
            arithmetic: self.arithmetic,
            impact,
            pair: pair.map(names),
            time,
            beyond,
        }
    }
}

/// A record on its way through its impacts.
struct Flight<'a> {
    record: &'a Record,
    trial: Trial,
    /// Pairs that overlap without a direction, or nearly so, at the start: they
    /// do not collide until they have parted.
    nested: Vec<(usize, Obstacle)>,
}

impl<'a> Flight<'a> {
    fn new(record: &'a Record, trial: Trial) -> Self {
        let start = Window::new(&record.bodies, &record.states[0], 0.0);
        let is_nested =
            |&pair: &(usize, Obstacle)| start.course(pair).distances()[0] <= start.margin(pair);
        Self {
            record,
            trial,
            nested: record.bodies.pairs().filter(is_nested).collect(),
        }
    }

    fn judge_impact(&mut self, index: usize, elastic: bool) -> Result<(), Finding> {
        let (record, trial) = (self.record, self.trial);
        let claim = &record.claims[index];
        let (before, after) = (&record.states[index], &record.states[index + 1]);
        let finding = |fault, pair| trial.finding(fault, index, Some(pair), claim.time);
        if !claim.time.is_finite() || !after.iter().all(|motion| motion.is_finite()) {
            return Err(finding((Kind::NotFinite, 0.0), claim.pair));
        }
        let since = before.iter().map(|motion| motion.since);
        if claim.time < since.fold(0.0, f64::max) {
            return Err(finding((Kind::Mistimed, 0.0), claim.pair));
        }
        let window = Window::new(&record.bodies, before, claim.time);
        self.part(&window);
        if !self.nested.contains(&claim.pair) {
            window
                .verify(claim)
                .map_err(|fault| finding(fault, claim.pair))?;
        }
        self.judge_others(&window, index)?;
        self.nested.retain(|&pair| pair != claim.pair);
        if let Some(beyond) = drift(record, index, elastic) {
            return Err(finding((Kind::Energy, beyond), claim.pair));
        }
        self.judge_overlaps(index)
    }

    /// Pairs that begin a flight apart are nested no more. One that parts within
    /// a flight does not meet again in it.
    fn part(&mut self, window: &Window) {
        self.nested.retain(|&pair| !window.starts_apart(pair));
    }

    /// No pair gets into each other before an impact.
    fn judge_others(&self, window: &Window, index: usize) -> Result<(), Finding> {
        for pair in self.pairs() {
            if let Some(beyond) = window.depth(pair) {
                let fault = (self.unresolved(pair, index), beyond);
                return Err(self.trial.finding(fault, index, Some(pair), window.time));
            }
        }
        Ok(())
    }

    fn pairs(&self) -> impl Iterator<Item = (usize, Obstacle)> {
        let pairs = self.record.bodies.pairs();
        pairs.filter(|pair| !self.nested.contains(pair))
    }

    /// What it is that a pair has got into each other before an impact.
    fn unresolved(&self, pair: (usize, Obstacle), index: usize) -> Kind {
        let mut later = self.record.claims[index..].iter();
        match later.position(|claim: &Claim| claim.pair == pair) {
            Some(0) => Kind::Mistimed,
            Some(_) => Kind::Misordered,
            None => Kind::Missed,
        }
    }

    /// Each impact of a disc may leave it deeper in another, by the margin of the
    /// flight up to that impact: all its discs' flights add up, the fast ones before
    /// they were slowed down included.
    fn judge_overlaps(&self, index: usize) -> Result<(), Finding> {
        let record = self.record;
        let claim = &record.claims[index];
        let (first, after) = (&record.states[0], &record.states[index + 1]);
        let start = Window::new(&record.bodies, first, 0.0);
        let window = Window::new(&record.bodies, after, claim.time);
        let changed = |pair: &(usize, Obstacle)| {
            discs(*pair).any(|disc| discs(claim.pair).any(|other| other == disc))
        };
        for pair in self.pairs().filter(changed) {
            let blur: f64 = discs(pair).map(|disc| after[disc].blur).sum();
            let allowed = 1.0 + blur / window.margin(pair);
            let floor = start.course(pair).distances()[0];
            let beyond = window.overlap(pair, floor) / allowed;
            if beyond > 1.0 {
                let fault = (Kind::Overlap, beyond);
                return Err(self.trial.finding(fault, index, Some(pair), claim.time));
            }
        }
        Ok(())
    }

    /// No pair has got into each other at the end.
    fn judge_end(&mut self, until: f64) -> Result<(), Finding> {
        let record = self.record;
        let index = record.claims.len();
        let window = Window::new(&record.bodies, &record.states[index], until);
        self.part(&window);
        self.judge_others(&window, index)
    }
}
