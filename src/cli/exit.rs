//! How the program ends.

use std::process::ExitCode;

use carom::run::Status;

/// The exit status.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Exit {
    /// All as expected.
    Success,
    /// A judged difference.
    Difference,
    /// Bad usage or input.
    BadInput,
    /// The budget ran out.
    OutOfBudget,
    /// The user has had enough: 128 and the number of the signal.
    Interrupted,
}

impl Exit {
    pub(super) fn code(self) -> u8 {
        match self {
            Self::Success => 0,
            Self::Difference => 1,
            Self::BadInput => 2,
            Self::OutOfBudget => 3,
            Self::Interrupted => 130,
        }
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit.code())
    }
}

impl From<&Status> for Exit {
    fn from(status: &Status) -> Self {
        match status {
            Status::Complete => Self::Success,
            Status::Undecided(_) | Status::Accumulation(_) | Status::EventLimit => {
                Self::OutOfBudget
            }
            Status::Interrupted => Self::Interrupted,
        }
    }
}
