//! Which forecast comes first: a tournament tree over lower bounds of times.

/// A key for each of a fixed number of slots; an empty slot's is infinite.
///
/// A binary tree of minima in an array: to change a key costs as many steps
/// as the tree has levels, to find the least one none, to visit the k least
/// ones about k times the levels.
#[derive(Clone, Debug)]
pub(super) struct Queue {
    /// The root at 1, the children of i at 2 i and 2 i + 1, the slots last.
    minima: Vec<f64>,
    /// Where the slots start: a power of two.
    first_slot: usize,
}

impl Queue {
    /// Empty slots.
    pub(super) fn new(slots: usize) -> Self {
        let first_slot = slots.max(1).next_power_of_two();
        Self {
            minima: vec![f64::INFINITY; 2 * first_slot],
            first_slot,
        }
    }

    /// Changes the key of a slot.
    #[inline]
    pub(super) fn set(&mut self, slot: usize, key: f64) {
        let mut node = self.first_slot + slot;
        self.minima[node] = key;
        while node > 1 {
            node /= 2;
            self.minima[node] = self.minima[2 * node].min(self.minima[2 * node + 1]);
        }
    }

    /// The least key.
    #[inline]
    pub(super) fn least(&self) -> f64 {
        self.minima[1]
    }

    /// The first slot with the least key.
    #[inline]
    pub(super) fn least_slot(&self) -> usize {
        let (least, mut node) = (self.least(), 1);
        while node < self.first_slot {
            node *= 2;
            node += usize::from(self.minima[node] != least);
        }
        node - self.first_slot
    }

    /// The least key of all other slots.
    #[inline]
    pub(super) fn least_but(&self, slot: usize) -> f64 {
        let mut node = self.first_slot + slot;
        let mut least = f64::INFINITY;
        while node > 1 {
            least = least.min(self.minima[node ^ 1]);
            node /= 2;
        }
        least
    }

    /// Collects the slots whose keys are not above a limit, in their order.
    #[inline]
    pub(super) fn collect_up_to(&self, limit: f64, found: &mut Vec<usize>) {
        found.clear();
        let mut next = Some(1);
        while let Some(node) = next {
            let is_wanted = self.minima[node] <= limit;
            let is_slot = node >= self.first_slot;
            if is_wanted && is_slot {
                found.push(node - self.first_slot);
            }
            next = if is_wanted && !is_slot {
                Some(2 * node)
            } else {
                following(node)
            };
        }
    }
}

/// The root of what lies to the right of a subtree: up while that is a right
/// child, then to its sibling.
#[inline]
fn following(node: usize) -> Option<usize> {
    match node >> node.trailing_ones() {
        0 => None,
        left => Some(left + 1),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        /// Against a plain list.
        #[test]
        fn agrees_with_a_list(
            slots in 1..40_usize,
            changes in prop::collection::vec((any::<prop::sample::Index>(), 0..20_u32), 1..100),
            limit in 0..20_u32,
        ) {
            let mut queue = Queue::new(slots);
            let mut list = vec![f64::INFINITY; slots];
            for (slot, key) in changes {
                let slot = slot.index(slots);
                let key = if key == 0 { f64::INFINITY } else { key.into() };
                queue.set(slot, key);
                list[slot] = key;
                let least = list.iter().copied().fold(f64::INFINITY, f64::min);
                prop_assert_eq!(queue.least(), least);
                if least.is_finite() {
                    let first = list.iter().position(|key| *key == least);
                    prop_assert_eq!(Some(queue.least_slot()), first);
                    let others = list.iter().enumerate().filter(|(other, _)| *other != slot);
                    let least = others.fold(f64::INFINITY, |least, (_, key)| least.min(*key));
                    prop_assert_eq!(queue.least_but(slot), least);
                }
            }
            let mut found = Vec::new();
            queue.collect_up_to(limit.into(), &mut found);
            let expected: Vec<_> = (0..slots).filter(|&slot| list[slot] <= f64::from(limit)).collect();
            prop_assert_eq!(found, expected);
        }
    }
}
