//! What truly happens in a scene, from start to end.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use carom::arithmetic::Budget;
use carom::judge::Logged;
use carom::run::{Accumulation, Options, Status, run};
use carom::scalar::{Exact, Scalar, Undecided};
use carom::scene::Scene;
use carom::simulation::Algorithm;
use carom::support::Unsupported;

use crate::cli::progress::RunBar;

/// The exact timeline of a scene.
pub(super) struct Truth {
    /// The impacts, in order.
    pub(super) impacts: Vec<Logged>,
    /// The bits that it took.
    pub(super) bits: u32,
    /// The time that it took, with the attempts that had too few bits.
    pub(super) cost: Duration,
    /// What could not be decided, if anything.
    pub(super) open: Option<Undecided>,
    /// Infinitely many impacts in which it ends, if it does.
    pub(super) accumulation: Option<Accumulation>,
    /// The time up to which all is known.
    pub(super) reached: f64,
}

impl Truth {
    /// Whether it goes to the end of the scene.
    pub(super) fn is_whole(&self) -> bool {
        self.open.is_none() && self.accumulation.is_none()
    }

    /// Runs the exact timeline.
    pub(super) fn find(scene: &Scene, budget: &Budget) -> Result<Self, Unsupported> {
        let options = Options {
            budget: *budget,
            max_events: u64::MAX,
            ..Options::default()
        };
        let mut bar = RunBar::new();
        let begun = Instant::now();
        let outcome = run::<Exact>(scene, Algorithm::Timeline, &options, &mut |progress| {
            bar.show(progress);
            ControlFlow::Continue(())
        })?;
        let (open, accumulation) = match outcome.status {
            Status::Undecided(open) => (Some(open), None),
            Status::Accumulation(found) => (None, Some(found)),
            _ => (None, None),
        };
        let is_whole = open.is_none() && accumulation.is_none();
        Ok(Self {
            impacts: outcome.impacts.iter().map(Logged::from).collect(),
            bits: outcome.precision,
            cost: begun.elapsed(),
            reached: match is_whole {
                true => f64::INFINITY,
                false => outcome.time.to_f64(),
            },
            open,
            accumulation,
        })
    }
}
