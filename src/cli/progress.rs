//! A bar that shows how far a run is, once it takes long enough to wonder.

use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

use carom::run::Progress;
use indicatif::{ProgressBar, ProgressStyle};

/// Shorter runs show no bar.
const PATIENCE: Duration = Duration::from_millis(500);

/// The steps of the bar.
const STEPS: u64 = 1000;

/// A run's bar. There is none unless standard error is a terminal.
pub(super) struct RunBar {
    begun: Instant,
    is_wanted: bool,
    bar: Option<ProgressBar>,
}

impl RunBar {
    pub(super) fn new() -> Self {
        Self {
            begun: Instant::now(),
            is_wanted: io::stderr().is_terminal(),
            bar: None,
        }
    }

    /// Shows how far the run is.
    pub(super) fn show(&mut self, progress: Progress) {
        if !self.is_wanted || self.begun.elapsed() < PATIENCE {
            return;
        }
        let bar = self.bar.get_or_insert_with(|| bar(STEPS, RUN));
        bar.set_position((progress.fraction() * STEPS as f64) as u64);
        bar.set_message(format!("{} impacts", progress.impacts));
    }
}

impl Drop for RunBar {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

const RUN: &str = "{wide_bar} {percent:>3} %  {msg}  {elapsed} (about {eta} to go)";

const STAGES: &str = "{wide_bar} {pos}/{len}  {elapsed}";

/// A bar for so many stages, which clears itself away at the end.
pub(super) fn stages(count: u64) -> ProgressBar {
    if io::stderr().is_terminal() {
        bar(count, STAGES)
    } else {
        ProgressBar::hidden()
    }
}

fn bar(length: u64, template: &str) -> ProgressBar {
    let style = ProgressStyle::with_template(template);
    let bar = ProgressBar::new(length);
    match style {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
