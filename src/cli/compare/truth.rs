//! What truly happens in a scene, from start to end.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use carom::arithmetic::Budget;
use carom::judge::Logged;
use carom::run::{Options, Status, run};
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
    /// The time up to which all is known.
    pub(super) reached: f64,
}

impl Truth {
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
        let open = match outcome.status {
            Status::Undecided(open) => Some(open),
            _ => None,
        };
        Ok(Self {
            impacts: outcome.impacts.iter().map(Logged::from).collect(),
            bits: outcome.precision,
            cost: begun.elapsed(),
            reached: open
                .as_ref()
                .map_or(f64::INFINITY, |_| outcome.time.to_f64()),
            open,
        })
    }
}
