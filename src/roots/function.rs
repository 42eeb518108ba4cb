//! Functions of time whose zeros can be enclosed.

use super::Polynomial;
use super::enclosure::Enclosure;

/// A function, known in enclosures.
pub(super) trait Function<E: Enclosure>: Sized {
    /// Its value at some t.
    fn at(&self, t: &E) -> E;

    /// Its derivative.
    #[must_use]
    fn derivative(&self) -> Self;

    /// The same to fewer bits.
    #[must_use]
    fn rough(&self, bits: u32) -> Self;

    /// The most bits that one of its numbers carries.
    fn bits(&self) -> u32;
}

impl<E: Enclosure> Function<E> for Polynomial<E> {
    fn at(&self, t: &E) -> E {
        self.at(t)
    }

    fn derivative(&self) -> Self {
        self.derivative()
    }

    fn rough(&self, bits: u32) -> Self {
        self.map(|a| a.rough(bits))
    }

    fn bits(&self) -> u32 {
        self.0.iter().map(E::bits).max().unwrap_or_default()
    }
}
