//! Decisions that an arithmetic leaves open.

use std::convert::Infallible;
use std::error::Error;
use std::fmt;

/// A decision that enclosures of so many bits could not make.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{bits} bits do not decide {question}{}", Proof(*bound))]
pub struct Undecided {
    /// The bits of the enclosures that did not suffice.
    pub bits: u32,
    /// What was asked.
    pub question: String,
    /// The bits that would be certain to decide it, where they are known:
    /// more than the budget allows.
    pub bound: Option<u64>,
}

impl Undecided {
    /// What so many bits could not decide.
    pub fn new(bits: u32, question: impl Into<String>) -> Self {
        let question = question.into();
        Self {
            bits,
            question,
            bound: None,
        }
    }

    /// The same question, after a proof was tried and left open as well.
    #[must_use]
    pub(crate) fn after(self, proof: Self) -> Self {
        Self {
            bits: self.bits.max(proof.bits),
            bound: proof.bound,
            ..self
        }
    }

    /// A bare number whose sign `bits` bits could not tell; the caller who
    /// knows what it stands for [names](Doubt::asking) it.
    pub fn sign(bits: u32) -> Self {
        Self::new(bits, "the sign of a number")
    }
}

/// What it would take to be certain.
struct Proof(Option<u64>);

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(bits) => write!(f, " (a tie as far as they tell; a proof takes {bits})"),
            None => Ok(()),
        }
    }
}

/// The reason why a decision was not made.
pub trait Doubt: Error + Clone + Send + Sync + 'static {
    /// What was asked and is left open before it is computed; none of an arithmetic
    /// that makes every decision.
    fn open(question: impl FnOnce() -> String) -> Option<Self>;

    /// Names what was asked.
    #[must_use]
    fn asking(self, question: impl FnOnce() -> String) -> Self;

    /// The reason in its common form.
    fn into_undecided(self) -> Undecided;
}

impl Doubt for Undecided {
    fn open(question: impl FnOnce() -> String) -> Option<Self> {
        Some(Self::new(0, question()))
    }

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
    fn open(_: impl FnOnce() -> String) -> Option<Self> {
        None
    }

    fn asking(self, _: impl FnOnce() -> String) -> Self {
        self
    }

    fn into_undecided(self) -> Undecided {
        match self {}
    }
}
