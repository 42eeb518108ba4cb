//! Which forecast comes first: a tournament tree over lower bounds of times.

/// So many keys are in one group: those of a cache line.
const WIDTH: usize = 8;

/// Ranks of keys, of which the least one is that of the group a level further up.
type Group = [u64; WIDTH];

/// The rank of an empty slot.
const EMPTY: u64 = rank(f64::INFINITY);

/// What is no slot, but fills the last group of a level: after every limit.
const NO_SLOT: u64 = u64::MAX;

/// A key for each of a fixed number of slots; an empty slot's is infinite.
///
/// A tree of minima, level by level: to change a key costs as many steps as the
/// tree has levels that this changes, to find the least one as many as there
/// are.
#[derive(Clone, Debug)]
pub(super) struct Queue {
    /// The slots first, a single group last.
    levels: Vec<Vec<Group>>,
    least: u64,
}

/// A whole number for each binary64, in the same order.
#[inline]
const fn rank(key: f64) -> u64 {
    let bits = (key + 0.0).to_bits();
    if bits >> 63 == 0 {
        bits | 1 << 63
    } else {
        !bits
    }
}

/// The number of a rank.
#[inline]
fn key(rank: u64) -> f64 {
    f64::from_bits(if rank >> 63 == 1 {
        rank & !(1 << 63)
    } else {
        !rank
    })
}

impl Queue {
    /// Empty slots.
    pub(super) fn new(slots: usize) -> Self {
        let mut levels = Vec::new();
        let mut count = slots.max(1);
        while count > 1 || levels.is_empty() {
            let mut groups = vec![[NO_SLOT; WIDTH]; count.div_ceil(WIDTH)];
            groups.as_flattened_mut()[..count].fill(EMPTY);
            count = groups.len();
            levels.push(groups);
        }
        Self {
            levels,
            least: EMPTY,
        }
    }

    /// Changes the key of a slot.
    #[inline]
    pub(super) fn set(&mut self, slot: usize, key: f64) {
        let (mut place, mut rank) = (slot, rank(key));
        for level in &mut self.levels {
            let group = &mut level[place / WIDTH];
            let own = &mut group[place % WIDTH];
            if *own == rank {
                return;
            }
            *own = rank;
            rank = least_of(group);
            place /= WIDTH;
        }
        self.least = rank;
    }

    /// The least key.
    #[inline]
    pub(super) fn least(&self) -> f64 {
        key(self.least)
    }

    /// The first slot with the least key.
    #[inline]
    pub(super) fn least_slot(&self) -> usize {
        self.levels.iter().rev().fold(0, |place, level| {
            let is_least = |rank: &u64| *rank == self.least;
            let first = level[place].iter().position(is_least);
            WIDTH * place + first.unwrap_or_default()
        })
    }

    /// The least key of all other slots.
    #[inline]
    pub(super) fn least_but(&self, slot: usize) -> f64 {
        let (mut place, mut least) = (slot, EMPTY);
        for level in &self.levels {
            let mut others = level[place / WIDTH];
            others[place % WIDTH] = EMPTY;
            least = least.min(least_of(&others));
            place /= WIDTH;
        }
        key(least)
    }

    /// Collects the slots whose keys are not above a limit, in their order.
    #[inline]
    pub(super) fn collect_up_to(&self, limit: f64, found: &mut Vec<usize>) {
        found.clear();
        collect(&self.levels, 0, rank(limit), found);
    }
}

/// Collects from a group of the last of some levels: no deeper than these are
/// many.
fn collect(levels: &[Vec<Group>], group: usize, limit: u64, found: &mut Vec<usize>) {
    let Some((level, below)) = levels.split_last() else {
        found.push(group);
        return;
    };
    let wanted = level[group].map(|rank| u8::from(rank <= limit));
    let mut left = u64::from_le_bytes(wanted);
    while left != 0 {
        let place = WIDTH * group + left.trailing_zeros() as usize / 8;
        collect(below, place, limit, found);
        left &= left - 1;
    }
}

#[inline]
fn least_of([a, b, c, d, e, f, g, h]: &Group) -> u64 {
    let (left, right) = (a.min(b).min(c.min(d)), e.min(f).min(g.min(h)));
    *left.min(right)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        /// Against a plain list.
        #[test]
        fn agrees_with_a_list(
            slots in 1..200_usize,
            changes in prop::collection::vec((any::<prop::sample::Index>(), -5..20_i32), 1..100),
            limit in -5..20_i32,
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
            for limit in [limit.into(), f64::INFINITY] {
                let mut found = Vec::new();
                queue.collect_up_to(limit, &mut found);
                let expected: Vec<_> = (0..slots).filter(|&slot| list[slot] <= limit).collect();
                prop_assert_eq!(found, expected);
            }
        }
    }
}
