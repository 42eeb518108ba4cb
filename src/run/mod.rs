//! A whole run of a scene: its impacts, its end, and whether it got there.
//!
//! Exact arithmetic leaves a decision open where its enclosures are too wide.
//! The run then starts again with more bits, as many as the attempt's progress
//! lets expect, until all is decided or the budget is spent.

mod accumulation;
mod attempt;

use std::ops::ControlFlow;

use num_rational::BigRational;

use crate::arithmetic::{Arithmetic, Budget, Shortfall};
use crate::body::Disc;
use crate::frame;
use crate::impact::Impact;
use crate::scalar::{Number, Scalar, Undecided};
use crate::scene::Scene;
use crate::simulation::Algorithm;
use crate::support::{Unsupported, check_distances, check_number, check_support};
use crate::symmetry::symmetries;
use crate::timeline::{BroadPhase, Simultaneous};
use attempt::Attempt;

pub use accumulation::Accumulation;

/// What a run may cost, and where it ends.
#[derive(Clone, Debug)]
pub struct Options {
    /// The end, unless it is that of the scene's last frame.
    pub until: Option<Number>,
    /// The number of impacts after which the run is ended.
    pub max_events: u64,
    /// The precision of exact arithmetic.
    pub budget: Budget,
    /// The decimal digits of the times that exact arithmetic must prove.
    pub digits: u32,
    /// Whether the circumstances of each impact are kept.
    pub contacts: bool,
    /// How the timeline resolves simultaneous impacts that share a disc.
    pub simultaneous: Simultaneous,
    /// How the timeline finds what a disc may meet.
    pub broad_phase: BroadPhase,
    /// How the frame algorithms find the pairs that they test.
    pub frame_broad_phase: frame::BroadPhase,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            until: None,
            max_events: 10_000_000,
            budget: Budget::default(),
            digits: 20,
            contacts: false,
            simultaneous: Simultaneous::default(),
            broad_phase: BroadPhase::default(),
            frame_broad_phase: frame::BroadPhase::default(),
        }
    }
}

impl Options {
    /// When the run of a scene is to end.
    pub(crate) fn end_of(&self, scene: &Scene) -> BigRational {
        match &self.until {
            Some(until) => until.to_rational(),
            None => scene.frame().total(),
        }
    }
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Status {
    /// It got to its end.
    Complete,
    /// A decision was still open when the budget was spent.
    Undecided(Undecided),
    /// Infinitely many impacts precede a finite time, not after its end.
    Accumulation(Accumulation),
    /// There were as many impacts as allowed.
    EventLimit,
    /// It was stopped from outside.
    Interrupted,
}

/// How far a run has got.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// The simulated time.
    pub time: f64,
    /// The simulated time at the end.
    pub until: f64,
    /// The impacts so far.
    pub impacts: u64,
}

/// What a run gives.
#[derive(Clone, Debug)]
pub struct Outcome<S: Scalar> {
    /// How it ended.
    pub status: Status,
    /// Its impacts, in order.
    pub impacts: Vec<Impact<S>>,
    /// How many tangent passes there were.
    pub grazes: u64,
    /// How many contacts became resting.
    pub rests: u64,
    /// The least relative difference of two different times of which the
    /// timeline had to find out which is the first, or less; if there were any.
    pub closest_call: Option<f64>,
    /// How many attempts failed before, for want of precision.
    pub restarts: u32,
    /// How many pairs overlapped at the start.
    pub overlaps: u64,
    /// The discs at the start.
    pub start: Vec<Disc<S>>,
    /// The discs at the end.
    pub end: Vec<Disc<S>>,
    /// The time of the end.
    pub time: S,
    /// What the arithmetic computed with.
    pub precision: S::Precision,
}

/// Runs a scene. `watch` is told of the progress now and then, and may stop
/// the run.
///
/// # Errors
///
/// The scene asks for something that cannot be simulated.
pub fn run<S: Arithmetic>(
    scene: &Scene,
    algorithm: Algorithm,
    options: &Options,
    watch: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Outcome<S>, Unsupported> {
    check_support::<S>(scene, algorithm)?;
    check_rule(scene, options)?;
    if let Some(until) = &options.until {
        check_number::<S>("until", until)?;
        check_distances(scene, &until.to_rational())?;
    }
    // What proves nothing has no use for them.
    let symmetries = match algorithm {
        Algorithm::Timeline if !S::ROUNDS => symmetries(scene),
        _ => Vec::new(),
    };
    let mut precision = S::first_precision(&options.budget);
    let mut restarts = 0;
    loop {
        let mut attempt = Attempt::<S>::new(scene, options, &symmetries, precision, &mut *watch);
        let outcome = attempt.run(scene, algorithm);
        let outcome = Outcome {
            restarts,
            ..outcome
        };
        let Status::Undecided(_) = outcome.status else {
            return Ok(outcome);
        };
        let short = outcome.shortfall(attempt.progress(&outcome.time), options.max_events);
        match S::next_precision(&options.budget, precision, short) {
            Some(next) => precision = next,
            None => return Ok(outcome),
        }
        restarts += 1;
    }
}

/// Copies of discs collide one pair at a time.
fn check_rule(scene: &Scene, options: &Options) -> Result<(), Unsupported> {
    if scene.periodic().is_none() || options.simultaneous == Simultaneous::Sequential {
        return Ok(());
    }
    Err(Unsupported::Combination {
        place: "periodic",
        circumstance: format!("with the rule {}", options.simultaneous),
    })
}

/// The certain bits of a disc's most certain number, of those that are not
/// exact.
fn certain_bits<S: Arithmetic>(disc: &Disc<S>) -> Option<u32> {
    let Disc {
        position, velocity, ..
    } = disc;
    let numbers = [&position.x, &position.y, &velocity.x, &velocity.y];
    numbers.into_iter().filter_map(S::certain_bits).max()
}

impl Progress {
    /// The part of the run that is done.
    pub fn fraction(&self) -> f64 {
        (self.time / self.until).clamp(0.0, 1.0)
    }
}

impl<S: Arithmetic> Outcome<S> {
    /// How many bits are certain of every disc at the end, in that of its
    /// numbers that is most certain; none where all are exact, or where the
    /// arithmetic proves nothing.
    pub fn certain_bits(&self) -> Option<u32> {
        self.end.iter().filter_map(certain_bits).min()
    }

    /// How a run that failed came to its end, which is that of the time or of
    /// the number of impacts.
    fn shortfall(&self, progress: Progress, max_events: u64) -> Shortfall {
        let impacts = self.impacts.len() as f64 / max_events as f64;
        let bits = S::bits(self.precision).unwrap_or_default();
        Shortfall {
            progress: progress.fraction().max(impacts.min(1.0)),
            left: self.certain_bits().unwrap_or(bits).min(bits),
        }
    }

    /// A run that otherwise went well lacks a decision.
    fn demand(&mut self, open: Undecided) {
        if !matches!(self.status, Status::Undecided(_)) {
            self.status = Status::Undecided(open);
        }
    }

    /// Each time in the log must be known to so many digits.
    fn check_digits(&mut self, digits: u32) {
        let vague = self
            .impacts
            .iter()
            .find(|impact| !impact.time.has_digits(digits));
        if let Some(impact) = vague {
            let question = format!("{digits} digits of the time at which {} meet", impact.pair);
            let bits = S::bits(self.precision).unwrap_or_default();
            self.demand(Undecided::new(bits, question));
        }
    }
}
