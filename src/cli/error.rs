//! What can go wrong, in one line each.

use std::fmt;
use std::io;

use carom::scene::SceneError;
use carom::support::Unsupported;

/// Why a command has no result.
#[derive(Debug, thiserror::Error)]
pub(super) enum Error {
    /// The command line makes no sense.
    #[error("{0}")]
    Usage(String),
    /// A scene cannot be read, or makes no sense.
    #[error("{0}")]
    Scene(#[from] SceneError),
    /// A log cannot be read, or is of other bodies.
    #[error("{file}: {reason}")]
    Log { file: String, reason: String },
    /// A scene cannot be simulated.
    #[error("{file}: {reason}")]
    Unsupported { file: String, reason: Unsupported },
    /// A result cannot be written.
    #[error("{file}: cannot be written: {reason}")]
    Unwritable { file: String, reason: io::Error },
}

impl Error {
    /// Whether whoever read the results has had enough of them.
    pub(super) fn is_broken_pipe(&self) -> bool {
        matches!(self, Self::Unwritable { reason, .. }
            if reason.kind() == io::ErrorKind::BrokenPipe)
    }
}

/// Tells the user something, if there is anywhere to tell it.
pub(super) fn report(message: &impl fmt::Display) {
    use io::Write;
    // Where even standard error is closed, the exit status has to do.
    let _ = writeln!(io::stderr().lock(), "carom: {message}");
}
