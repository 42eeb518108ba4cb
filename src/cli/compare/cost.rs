//! How long candidates take, one at a time and in turn.
//!
//! A machine's speed drifts. So there are rounds: in each of them every candidate
//! runs once, and a drift hits all alike. All times are kept.

use std::time::{Duration, Instant};

use carom::arithmetic::{Arithmetic, Budget, Shortfall};
use carom::frame::BroadPhase;
use carom::scene::Scene;
use carom::simulation::{Algorithm, Simulation};

/// How much of a comparison's time goes into costs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    /// A candidate that has taken so long has no further run.
    pub(super) share: Duration,
    /// The most runs of a candidate.
    pub(super) rounds: usize,
}

/// The times that one candidate has taken, in ascending order; none for one that
/// cannot be run.
#[derive(Clone, Debug, Default)]
pub(super) struct Cost {
    times: Vec<Duration>,
}

impl Cost {
    pub(super) fn new(mut times: Vec<Duration>) -> Self {
        times.sort();
        Self { times }
    }

    /// How often it ran.
    pub(super) fn runs(&self) -> usize {
        self.times.len()
    }

    pub(super) fn median(&self) -> Option<Duration> {
        self.times.get(self.times.len() / 2).copied()
    }

    /// The first and the third quartile; of up to four runs, the fastest and the
    /// slowest.
    pub(super) fn quartiles(&self) -> Option<[Duration; 2]> {
        let last = self.times.len().checked_sub(1)?;
        let low = last / 4;
        Some([self.times[low], self.times[last - low]])
    }
}

/// Runs every candidate once a round, in their order, and each until it has had
/// its share of time or all rounds. `run` gives the time of a run, or nothing if
/// the candidate has none; it is then not asked again.
pub(super) fn in_turn(
    candidates: usize,
    effort: Effort,
    mut run: impl FnMut(usize) -> Option<Duration>,
) -> Vec<Cost> {
    let mut times = vec![Vec::new(); candidates];
    let mut waiting: Vec<usize> = (0..candidates).collect();
    for _ in 0..effort.rounds {
        waiting.retain(|&candidate| {
            let Some(time) = run(candidate) else {
                return false;
            };
            times[candidate].push(time);
            times[candidate].iter().sum::<Duration>() < effort.share
        });
    }
    times.into_iter().map(Cost::new).collect()
}

/// A candidate that can be run over and over.
pub(super) trait Run {
    /// The time that all frames take, with as many bits as they need; none if
    /// the budget does not suffice.
    fn time(&mut self) -> Option<Duration>;
}

/// An algorithm in an arithmetic, and the precision that it has turned out to need.
pub(super) struct Runner<'a, S: Arithmetic> {
    scene: &'a Scene,
    algorithm: Algorithm,
    phase: BroadPhase,
    budget: &'a Budget,
    precision: S::Precision,
}

impl<'a, S: Arithmetic> Runner<'a, S> {
    pub(super) fn new(
        scene: &'a Scene,
        algorithm: Algorithm,
        phase: BroadPhase,
        budget: &'a Budget,
    ) -> Self {
        Self {
            scene,
            algorithm,
            phase,
            budget,
            precision: S::first_precision(budget),
        }
    }

    /// Runs all frames, or fails after a part of them.
    fn attempt(&self) -> Result<(), f64> {
        let frames = self.scene.frame().count;
        let simulation = Simulation::<S>::new(self.scene, self.algorithm, self.precision);
        let mut simulation = simulation.map_err(|_| 0.0)?.with_broad_phase(self.phase);
        for frame in 0..frames {
            let impacts = simulation.next_frame();
            impacts.map_err(|_| frame as f64 / frames as f64)?;
            if simulation.accumulation().is_some() {
                break;
            }
        }
        Ok(())
    }
}

impl<S: Arithmetic> Run for Runner<'_, S> {
    fn time(&mut self) -> Option<Duration> {
        loop {
            let begun = Instant::now();
            let progress = match self.attempt() {
                Ok(()) => return Some(begun.elapsed()),
                Err(progress) => progress,
            };
            let short = Shortfall { progress, left: 0 };
            self.precision = S::next_precision(self.budget, self.precision, short)?;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seconds(times: &[u64]) -> Cost {
        Cost::new(times.iter().copied().map(Duration::from_secs).collect())
    }

    /// Candidates of 1, 4 and 20 seconds, with a share of 10 seconds: the third
    /// has had it after its first run, the second after its third.
    #[test]
    fn all_run_in_turn() {
        let effort = Effort {
            share: Duration::from_secs(10),
            rounds: 5,
        };
        let mut order = Vec::new();
        let costs = in_turn(3, effort, |candidate| {
            order.push(candidate);
            Some(Duration::from_secs([1, 4, 20][candidate]))
        });
        assert_eq!(order, [0, 1, 2, 0, 1, 0, 1, 0, 0]);
        let runs: Vec<_> = costs.iter().map(Cost::runs).collect();
        assert_eq!(runs, [5, 3, 1]);
    }

    #[test]
    fn what_cannot_run_is_asked_once() {
        let effort = Effort {
            share: Duration::MAX,
            rounds: 3,
        };
        let mut order = Vec::new();
        let costs = in_turn(2, effort, |candidate| {
            order.push(candidate);
            (candidate == 1).then_some(Duration::ZERO)
        });
        assert_eq!(order, [0, 1, 1, 1]);
        assert_eq!(costs[0].median(), None);
        assert_eq!(costs[0].quartiles(), None);
    }

    #[test]
    fn a_median_has_as_many_below_as_above() {
        let table: [(&[u64], u64, [u64; 2]); 5] = [
            (&[7], 7, [7, 7]),
            (&[9, 1, 5], 5, [1, 9]),
            (&[5, 4, 3, 2, 1], 3, [2, 4]),
            (&[1, 2, 3, 4, 5, 6, 7], 4, [2, 6]),
            (&[9, 8, 7, 6, 5, 4, 3, 2, 1], 5, [3, 7]),
        ];
        for (times, median, quartiles) in table {
            let cost = seconds(times);
            assert_eq!(cost.median(), Some(Duration::from_secs(median)));
            assert_eq!(
                cost.quartiles(),
                Some(quartiles.map(Duration::from_secs)),
                "{times:?}"
            );
        }
    }
}
