//! Which forecast comes first: a tournament tree over lower bounds of times.

/// So many keys are in one group: those of a cache line.
const WIDTH: usize = 8;

/// Keys, of which the least one is that of the group a level further up.
type Group = [f64; WIDTH];

/// The key of an empty slot, and of what fills the last group of a level.
const EMPTY: f64 = f64::INFINITY;

/// A key for each of a fixed number of slots; an empty slot's is infinite.
///
/// A tree of minima, level by level: to change a key costs as many steps as the
/// tree has levels that this changes, to find the least one as many as there
/// are.
#[derive(Clone, Debug)]
pub(super) struct Queue {
    /// The slots first, a single group last.
    levels: Vec<Vec<Group>>,
    least: f64,
}

impl Queue {
    /// Empty slots.
    pub(super) fn new(slots: usize) -> Self {
        let mut levels = Vec::new();
        let mut count = slots.max(1);
        while count > 1 || levels.is_empty() {
            count = count.div_ceil(WIDTH);
            levels.push(vec![[EMPTY; WIDTH]; count]);
        }
        Self {
            levels,
            least: EMPTY,
        }
    }

    /// Changes the key of a slot to a number.
    #[inline]
    pub(super) fn set(&mut self, slot: usize, key: f64) {
        debug_assert!(!key.is_nan(), "a key is a number");
        let (mut place, mut key) = (slot, key);
        for level in &mut self.levels {
            let group = &mut level[place / WIDTH];
            let own = &mut group[place % WIDTH];
            if *own == key {
                return;
            }
            *own = key;
            key = least_of(group);
            place /= WIDTH;
        }
        self.least = key;
    }

    /// The least key.
    #[inline]
    pub(super) fn least(&self) -> f64 {
        self.least
    }

    /// The least key of all other slots.
    #[inline]
    pub(super) fn least_but(&self, slot: usize) -> f64 {
        let (mut place, mut least) = (slot, EMPTY);
        for level in &self.levels {
            let others = without(&level[place / WIDTH], place % WIDTH);
            least = lesser(least, least_of(&others));
            place /= WIDTH;
        }
        least
    }

    /// Collects, in their order, the slots whose keys are not above the `end` of the
    /// first one with the least key. There must be a slot that is not empty.
    #[inline]
    pub(super) fn collect_front(&self, found: &mut Vec<usize>, end: impl Fn(usize) -> f64) {
        let first = self.first();
        let end = end(first);
        if self.least_but(first) > end {
            // Mostly there are no others.
            found.clear();
            found.push(first);
        } else {
            self.collect_up_to(end, found);
        }
    }

    /// The first slot with the least key.
    #[inline]
    fn first(&self) -> usize {
        let levels = self.levels.iter().rev();
        levels.fold(0, |place, level| {
            WIDTH * place + first_up_to(&level[place], self.least)
        })
    }

    /// Collects the slots, but for empty ones, whose keys are not above a limit, in
    /// their order: those of a level take the place of those of the level above.
    fn collect_up_to(&self, limit: f64, found: &mut Vec<usize>) {
        let limit = limit.min(f64::MAX);
        found.clear();
        found.push(0);
        for level in self.levels.iter().rev() {
            let groups = found.len();
            for place in 0..groups {
                let group = found[place];
                let keys = level[group].iter().enumerate();
                let sought = keys.filter(|(_, key)| **key <= limit);
                found.extend(sought.map(|(place, _)| WIDTH * group + place));
            }
            found.drain(..groups);
        }
    }
}

/// The place of the first key of a group that is not above a limit; there must be one.
/// All comparisons at once: one after the other they would wait for each other.
#[inline]
fn first_up_to(group: &Group, limit: f64) -> usize {
    let is_sought = group.map(|key| u8::from(key <= limit));
    u64::from_le_bytes(is_sought).trailing_zeros() as usize / 8
}

/// Of each place in a group: it alone is beyond all keys, the others are before.
const BUT: [Group; WIDTH] = {
    let mut but = [[f64::NEG_INFINITY; WIDTH]; WIDTH];
    let mut place = 0;
    while place < WIDTH {
        but[place][place] = EMPTY;
        place += 1;
    }
    but
};

/// A group in which a place is empty.
#[inline]
fn without(group: &Group, place: usize) -> Group {
    let but = &BUT[place];
    [0, 1, 2, 3, 4, 5, 6, 7].map(|other| greater(group[other], but[other]))
}

#[inline]
fn least_of(group: &Group) -> f64 {
    let half = |keys: [f64; 4], others: [f64; 4]| {
        let [a, b, c, d] = keys;
        let [e, f, g, h] = others;
        [lesser(a, e), lesser(b, f), lesser(c, g), lesser(d, h)]
    };
    let [a, b, c, d, e, f, g, h] = *group;
    let [a, b, c, d] = half([a, b, c, d], [e, f, g, h]);
    lesser(lesser(a, c), lesser(b, d))
}

/// The lesser of two numbers: one instruction, which `f64::min` is not.
#[inline]
fn lesser(one: f64, other: f64) -> f64 {
    if one < other { one } else { other }
}

/// The greater of two numbers.
#[inline]
fn greater(one: f64, other: f64) -> f64 {
    if one > other { one } else { other }
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
                    let mut front = Vec::new();
                    queue.collect_front(&mut front, |first| list[first] + 1.0);
                    let expected: Vec<_> =
                        (0..slots).filter(|&slot| list[slot] <= least + 1.0).collect();
                    prop_assert_eq!(front, expected);
                    let others = list.iter().enumerate().filter(|(other, _)| *other != slot);
                    let least = others.fold(f64::INFINITY, |least, (_, key)| least.min(*key));
                    prop_assert_eq!(queue.least_but(slot), least);
                }
            }
            for limit in [limit.into(), f64::INFINITY] {
                let mut found = Vec::new();
                queue.collect_up_to(limit, &mut found);
                let is_sought = |slot: &usize| list[*slot] <= limit && list[*slot].is_finite();
                let expected: Vec<_> = (0..slots).filter(is_sought).collect();
                prop_assert_eq!(found, expected);
            }
        }
    }
}
