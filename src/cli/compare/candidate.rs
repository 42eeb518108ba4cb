//! What is compared: algorithms, each in several arithmetics.

use std::fmt;
use std::ops::ControlFlow;

use carom::arithmetic::{Arithmetic, Budget};
use carom::frame::{BroadPhase, Passes};
use carom::judge::{Judged, judge, judge_and_split};
use carom::run::{Options, run};
use carom::scalar::{Exact, Filtered};
use carom::scene::Scene;
use carom::simulation::Algorithm;
use carom::support::{Unsupported, check_support};

use super::cost::{Run, Runner};
use crate::cli::choice::{AlgorithmName, ArithmeticName};
use crate::cli::replay::Pane;

/// An algorithm in an arithmetic.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    pub(super) algorithm: Algorithm,
    pub(super) arithmetic: ArithmeticName,
    /// How a frame algorithm finds pairs.
    pub(super) broad_phase: BroadPhase,
}

/// Which candidates are wanted.
pub(super) struct Selection<'a> {
    pub(super) algorithms: &'a [AlgorithmName],
    pub(super) arithmetics: &'a [ArithmeticName],
    pub(super) passes: &'a [u32],
    pub(super) substeps: u32,
    pub(super) broad_phase: BroadPhase,
}

impl Selection<'_> {
    /// Every algorithm in every arithmetic.
    pub(super) fn candidates(&self) -> Vec<Candidate> {
        let algorithms = self.algorithms.iter();
        let algorithms = algorithms.flat_map(|name| {
            let passes = self.passes_of(*name).iter();
            passes.map(|&passes| name.with(Passes::Count(passes), self.substeps))
        });
        let all = algorithms.flat_map(|algorithm| {
            let arithmetics = self.arithmetics.iter();
            arithmetics.map(move |&arithmetic| Candidate {
                algorithm,
                arithmetic,
                broad_phase: self.broad_phase,
            })
        });
        all.collect()
    }

    /// The numbers of passes with which an algorithm is run.
    fn passes_of(&self, name: AlgorithmName) -> &[u32] {
        match name {
            AlgorithmName::Multiple => self.passes,
            // Those without passes have no use for the number.
            _ => &self.passes[..1],
        }
    }
}

impl Candidate {
    /// What truly happens.
    pub(super) const TRUTH: Self = Self {
        algorithm: Algorithm::Timeline,
        arithmetic: ArithmeticName::Exact,
        broad_phase: BroadPhase::Grid,
    };

    /// Its run, to be played; none where a replay cannot show the scene.
    pub(super) fn pane(&self, scene: &Scene, budget: &Budget) -> Option<Pane> {
        match self.arithmetic {
            ArithmeticName::Binary64 => self.pane_in::<f64>(scene, budget),
            ArithmeticName::Filtered => self.pane_in::<Filtered>(scene, budget),
            ArithmeticName::Exact => self.pane_in::<Exact>(scene, budget),
        }
    }

    fn pane_in<S: Arithmetic>(&self, scene: &Scene, budget: &Budget) -> Option<Pane> {
        if scene.periodic().is_some() {
            return None;
        }
        let options = Options {
            budget: *budget,
            max_events: u64::MAX,
            contacts: true,
            frame_broad_phase: self.broad_phase,
            ..Options::default()
        };
        let go_on = &mut |_| ControlFlow::Continue(());
        let outcome = run::<S>(scene, self.algorithm, &options, go_on).ok()?;
        Some(Pane::new(scene, self.algorithm, &outcome))
    }

    pub(super) fn check(&self, scene: &Scene) -> Result<(), Unsupported> {
        match self.arithmetic {
            ArithmeticName::Binary64 => check_support::<f64>(scene, self.algorithm),
            ArithmeticName::Filtered => check_support::<Filtered>(scene, self.algorithm),
            ArithmeticName::Exact => check_support::<Exact>(scene, self.algorithm),
        }
    }

    pub(super) fn judge(&self, scene: &Scene, budget: &Budget) -> Result<Judged, Unsupported> {
        let judge = match self.arithmetic {
            ArithmeticName::Binary64 => judge::<f64>,
            ArithmeticName::Filtered => judge::<Filtered>,
            ArithmeticName::Exact => judge::<Exact>,
        };
        judge(scene, self.algorithm, self.broad_phase, budget)
    }

    /// The same, and which part of the errors is the algorithm's.
    pub(super) fn judge_and_split(
        &self,
        scene: &Scene,
        budget: &Budget,
    ) -> Result<Judged, Unsupported> {
        let judge = match self.arithmetic {
            ArithmeticName::Binary64 => judge_and_split::<f64>,
            ArithmeticName::Filtered => judge_and_split::<Filtered>,
            ArithmeticName::Exact => judge_and_split::<Exact>,
        };
        judge(scene, self.algorithm, self.broad_phase, budget)
    }

    /// What takes its time.
    pub(super) fn runner<'a>(&self, scene: &'a Scene, budget: &'a Budget) -> Box<dyn Run + 'a> {
        let (algorithm, phase) = (self.algorithm, self.broad_phase);
        match self.arithmetic {
            ArithmeticName::Binary64 => {
                Box::new(Runner::<f64>::new(scene, algorithm, phase, budget))
            }
            ArithmeticName::Filtered => {
                Box::new(Runner::<Filtered>::new(scene, algorithm, phase, budget))
            }
            ArithmeticName::Exact => {
                Box::new(Runner::<Exact>::new(scene, algorithm, phase, budget))
            }
        }
    }

    pub(super) fn arithmetic_name(&self) -> &'static str {
        match self.arithmetic {
            ArithmeticName::Binary64 => f64::NAME,
            ArithmeticName::Filtered => Filtered::NAME,
            ArithmeticName::Exact => Exact::NAME,
        }
    }

    /// The passes or steps a frame, of an algorithm that has them.
    pub(super) fn parameter(&self) -> Option<u32> {
        match self.algorithm {
            Algorithm::Multiple(Passes::Count(count))
            | Algorithm::Synchronised(Passes::Count(count))
            | Algorithm::Retroactive { substeps: count } => Some(count),
            _ => None,
        }
    }
}

impl fmt::Display for Candidate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.algorithm)?;
        self.parameter()
            .map_or(Ok(()), |parameter| write!(f, " {parameter}"))
    }
}
