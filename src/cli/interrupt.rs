//! Ctrl-C: the first ends a run in good order, the second at once.

use std::process;
use std::sync::atomic::{AtomicBool, Ordering};

use super::exit::Exit;

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Lets runs end in good order from now on.
pub(super) fn listen() {
    let handler = || {
        if INTERRUPTED.swap(true, Ordering::Relaxed) {
            process::exit(Exit::Interrupted.code().into());
        }
    };
    // Where signals cannot be had, Ctrl-C ends the program at once, as ever.
    let _ = ctrlc::set_handler(handler);
}

/// Whether there was a Ctrl-C.
pub(super) fn is_interrupted() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}
