//! Algorithms and arithmetics, as they are chosen on the command line.

use std::str::FromStr;
use std::time::Duration;

use carom::arithmetic::{Arithmetic as _, Budget};
use carom::frame::{self, Passes};
use carom::scalar::{Exact, Filtered, Number};
use carom::simulation::Algorithm;
use carom::timeline::{self, Simultaneous};
use clap::{Args, ValueEnum};

use super::error::Error;

/// The passes of the multiple collision algorithm, unless others are asked
/// for.
const DEFAULT_PASSES: u32 = 2;

/// An algorithm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum AlgorithmName {
    /// Step, test for overlap, resolve.
    Retroactive,
    /// The single collision algorithm: one impact a disc and frame.
    Single,
    /// The multiple collision algorithm: several passes, local clocks.
    Multiple,
    /// The same with synchronised clocks.
    Synchronised,
    /// Event-driven: every impact in its order.
    Timeline,
}

/// An arithmetic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ArithmeticName {
    Binary64,
    Filtered,
    Exact,
}

impl FromStr for ArithmeticName {
    type Err = &'static str;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        match name {
            f64::NAME => Ok(Self::Binary64),
            Filtered::NAME => Ok(Self::Filtered),
            Exact::NAME => Ok(Self::Exact),
            _ => Err("expected f64, filtered or exact"),
        }
    }
}

/// The choice of an algorithm.
#[derive(Args, Debug)]
pub(super) struct AlgorithmArguments {
    /// How the scene is simulated.
    #[arg(long, value_name = "A", value_enum, default_value = "timeline")]
    algorithm: AlgorithmName,
    /// The most passes a frame of multiple and synchronised [default: 2].
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u32).range(1..))]
    passes: Option<u32>,
    /// Instead of a number of passes: the milliseconds after which there are
    /// no more in a frame.
    #[arg(long, value_name = "MS", value_parser = milliseconds, conflicts_with = "passes")]
    frame_budget: Option<Duration>,
    /// The steps a frame of retroactive [default: 1].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    substeps: Option<u32>,
}

impl AlgorithmArguments {
    /// The algorithm, unless an option does not belong to it.
    pub(super) fn algorithm(&self) -> Result<Algorithm, Error> {
        let has_passes = matches!(
            self.algorithm,
            AlgorithmName::Multiple | AlgorithmName::Synchronised
        );
        let misplaced = [
            ("--passes", self.passes.is_some() && !has_passes),
            ("--frame-budget", self.frame_budget.is_some() && !has_passes),
            (
                "--substeps",
                self.substeps.is_some() && self.algorithm != AlgorithmName::Retroactive,
            ),
        ];
        match misplaced.into_iter().find(|(_, misplaced)| *misplaced) {
            Some((option, _)) => Err(Error::Usage(format!(
                "{option}: not an option of the algorithm {}",
                self.algorithm.with(self.passes(), 1)
            ))),
            None => Ok(self
                .algorithm
                .with(self.passes(), self.substeps.unwrap_or(1))),
        }
    }

    /// Whether it depends on the clock how a run goes.
    pub(super) fn has_frame_budget(&self) -> bool {
        self.frame_budget.is_some()
    }

    fn passes(&self) -> Passes {
        match self.frame_budget {
            Some(budget) => Passes::Budget(budget),
            None => Passes::Count(self.passes.unwrap_or(DEFAULT_PASSES)),
        }
    }
}

impl AlgorithmName {
    /// The algorithm with its parameters.
    pub(super) fn with(self, passes: Passes, substeps: u32) -> Algorithm {
        match self {
            Self::Retroactive => Algorithm::Retroactive { substeps },
            Self::Single => Algorithm::Single,
            Self::Multiple => Algorithm::Multiple(passes),
            Self::Synchronised => Algorithm::Synchronised(passes),
            Self::Timeline => Algorithm::Timeline,
        }
    }
}

/// A rule for simultaneous impacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Rule {
    /// One pair at a time, in the order of names, until none approaches.
    Sequential,
    /// All at once, keeping energy and the symmetry of the scene.
    Reflect,
}

impl Rule {
    pub(super) fn simultaneous(self) -> Simultaneous {
        match self {
            Self::Sequential => Simultaneous::Sequential,
            Self::Reflect => Simultaneous::Reflect,
        }
    }
}

/// A way to find what may meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Phase {
    /// Every pair is looked at.
    AllPairs,
    /// What is in the same cells of a grid.
    Grid,
    /// What is in the same parts of a binary space partition, which the timeline
    /// does not have.
    Bsp,
}

impl Phase {
    /// That of a frame algorithm.
    pub(super) fn of_frames(self) -> frame::BroadPhase {
        match self {
            Self::AllPairs => frame::BroadPhase::AllPairs,
            Self::Grid => frame::BroadPhase::Grid,
            Self::Bsp => frame::BroadPhase::Bsp,
        }
    }

    /// That of the timeline, if it has it.
    pub(super) fn of_timeline(self) -> Option<timeline::BroadPhase> {
        match self {
            Self::AllPairs => Some(timeline::BroadPhase::AllPairs),
            Self::Grid => Some(timeline::BroadPhase::Grid),
            Self::Bsp => None,
        }
    }
}

/// What exact arithmetic may cost.
#[derive(Args, Debug)]
pub(super) struct BudgetArguments {
    /// The most bits that exact arithmetic tries before it leaves a decision
    /// open.
    #[arg(
        long,
        value_name = "N",
        default_value_t = Budget::default().most_bits,
        value_parser = clap::value_parser!(u32).range(64..=1 << 20)
    )]
    max_bits: u32,
}

impl BudgetArguments {
    pub(super) fn budget(&self) -> Budget {
        let usual = Budget::default();
        Budget {
            first_bits: usual.first_bits.min(self.max_bits),
            most_bits: self.max_bits,
        }
    }
}

/// A time that is not before the start.
pub(super) fn duration(text: &str) -> Result<Number, String> {
    let number: Number = text.parse().map_err(|error| format!("{error}"))?;
    match number.sign().is_ge() {
        true => Ok(number),
        false => Err(String::from("expected a time that is not negative")),
    }
}

fn milliseconds(text: &str) -> Result<Duration, &'static str> {
    let expected = "expected a number of milliseconds that is not negative";
    let number: f64 = text.parse().map_err(|_| expected)?;
    Duration::try_from_secs_f64(number / 1e3).map_err(|_| expected)
}
