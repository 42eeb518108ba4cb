//! Decisions that an arithmetic leaves open.

use std::convert::Infallible;
use std::error::Error;

/// A decision that enclosures of so many bits could not make.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{bits} bits do not decide {question}")]
pub struct Undecided {
    /// The bits of the enclosures that did not suffice.
    pub bits: u32,
    /// What was asked.
    pub question: String,
}

impl Undecided {
    /// A bare number whose sign `bits` bits could not tell; the caller who
    /// knows what it stands for [names](Doubt::asking) it.
    pub fn sign(bits: u32) -> Self {
        let question = String::from("the sign of a number");
        Self { bits, question }
    }
}

/// The reason why a decision was not made.
pub trait Doubt: Error + Clone + Send + Sync + 'static {
    /// Names what was asked.
    #[must_use]
    fn asking(self, question: impl FnOnce() -> String) -> Self;

    /// The reason in its common form.
    fn into_undecided(self) -> Undecided;
}

impl Doubt for Undecided {
    fn asking(self, question: impl FnOnce() -> String) -> Self {
        Self {
            question: question(),
            ..self
        }
    }

    fn into_undecided(self) -> Undecided {
        self
    }
}

/// For arithmetics that make every decision.
impl Doubt for Infallible {
    fn asking(self, _: impl FnOnce() -> String) -> Self {
        self
    }

    fn into_undecided(self) -> Undecided {
        match self {}
    }
}
