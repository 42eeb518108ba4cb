//! What is remembered of few discs, and only until they change.

use std::collections::BTreeMap;

use crate::body::Feature;

/// For some discs, features that they do not collide with for now, and the turns
/// at which these had changed last.
#[derive(Clone, Debug, Default)]
pub(super) struct Notes {
    of: BTreeMap<usize, Vec<(Feature, u64)>>,
}

impl Notes {
    /// Adds a note on a disc.
    pub(super) fn add(&mut self, disc: usize, feature: Feature, turn: u64) {
        self.of.entry(disc).or_default().push((feature, turn));
    }

    /// The notes on a disc.
    #[inline]
    pub(super) fn of(&self, disc: usize) -> &[(Feature, u64)] {
        if self.of.is_empty() {
            return &[];
        }
        self.of.get(&disc).map_or(&[], Vec::as_slice)
    }

    /// Forgets a disc, which has changed.
    #[inline]
    pub(super) fn clear(&mut self, disc: usize) {
        if !self.of.is_empty() {
            self.of.remove(&disc);
        }
    }
}
