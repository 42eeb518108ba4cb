//! Which forecast comes first: a tournament tree over lower bounds of times.
//!
//! What is collected as the first ones mostly gets a new key before anything else is
//! asked. So a few of them are taken out of the tree at once.

use prefetch_index::prefetch_index;

/// So many keys are in one group: those of a cache line.
const WIDTH: usize = 8;

/// So many entries are out of the tree at most, unless more are looked ahead for.
const FEW: usize = 16;

/// The key of an empty slot; and what fills the last group of a level, where that has more
/// places than there are slots.
const EMPTY: f64 = f64::INFINITY;

/// Keys, of which the least one is in the group a level further up.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Group([f64; WIDTH]);

/// A slot and its key.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Entry {
    key: f64,
    slot: u32,
}

/// A level of the tree.
#[derive(Clone, Debug)]
struct Level {
    groups: Vec<Group>,
    /// Whose keys these are; none on the first level, where that is plain.
    slots: Vec<[u32; WIDTH]>,
}

/// A key for each of a fixed number of slots; an empty slot's is infinite.
///
/// A tree of minima, level by level: to change a key costs as many steps as the
/// tree has levels that this changes.
#[derive(Clone, Debug)]
pub(super) struct Queue {
    /// The slots first, a single group last.
    levels: Vec<Level>,
    /// The first entry in the tree.
    first: Entry,
    /// The entries that are out of it.
    taken: Vec<Entry>,
}

impl Level {
    #[inline]
    fn at(&self, place: usize) -> Entry {
        let (group, own) = (place / WIDTH, place % WIDTH);
        Entry {
            key: self.groups[group].0[own],
            slot: self
                .slots
                .get(group)
                .map_or(place as u32, |slots| slots[own]),
        }
    }

    /// Puts an entry at a place. Gives the slot of what was there.
    #[inline]
    fn replace(&mut self, place: usize, entry: Entry) -> u32 {
        let (group, own) = (place / WIDTH, place % WIDTH);
        self.groups[group].0[own] = entry.key;
        match self.slots.get_mut(group) {
            Some(slots) => std::mem::replace(&mut slots[own], entry.slot),
            None => entry.slot,
        }
    }

    /// The first entry of a group.
    #[inline]
    fn first(&self, group: usize) -> Entry {
        let (place, key) = first_of(&self.groups[group]);
        let slot = match self.slots.get(group) {
            Some(slots) => slots[place],
            None => (WIDTH * group + place) as u32,
        };
        Entry { key, slot }
    }
}

impl Queue {
    /// Empty slots.
    pub(super) fn new(slots: usize) -> Self {
        let mut levels = Vec::new();
        let mut count = slots.max(1);
        while count > 1 || levels.is_empty() {
            count = count.div_ceil(WIDTH);
            let is_first = levels.is_empty();
            levels.push(Level {
                groups: vec![Group([EMPTY; WIDTH]); count],
                slots: vec![[0; WIDTH]; if is_first { 0 } else { count }],
            });
        }
        Self {
            levels,
            first: Entry {
                key: EMPTY,
                slot: 0,
            },
            taken: Vec::new(),
        }
    }

    /// Changes the key of a slot.
    #[inline]
    pub(super) fn set(&mut self, slot: usize, key: f64) {
        if !self.taken.is_empty() {
            self.taken.retain(|taken| taken.slot as usize != slot);
        }
        self.put(Entry {
            // What is not a number comes last.
            key: key.min(EMPTY),
            slot: slot as u32,
        });
    }

    /// Changes an entry of the tree.
    #[inline]
    fn put(&mut self, entry: Entry) {
        let (mut place, mut entry) = (entry.slot as usize, entry);
        for level in 0..self.levels.len() {
            let before = self.levels[level].replace(place, entry);
            place /= WIDTH;
            let first = match self.levels.get(level + 1) {
                Some(above) => above.at(place),
                None => self.first,
            };
            if entry.key >= first.key {
                if before != first.slot {
                    return;
                }
                entry = self.levels[level].first(place);
            }
        }
        self.first = entry;
    }

    /// The least key.
    #[inline]
    pub(super) fn least(&self) -> f64 {
        let taken = self.taken.iter().map(|entry| entry.key);
        taken.fold(self.first.key, lesser)
    }

    /// Fetches the key of a slot into the cache.
    #[inline]
    pub(super) fn fetch(&self, slot: usize) {
        prefetch_index(&self.levels[0].groups, slot / WIDTH);
        if let Some(level) = self.levels.get(1) {
            prefetch_index(&level.groups, slot / WIDTH / WIDTH);
            prefetch_index(&level.slots, slot / WIDTH / WIDTH);
        }
    }

    /// Takes the next entries out of the tree until so many are, and lists their slots.
    #[inline]
    pub(super) fn look_ahead(&mut self, count: usize, found: &mut Vec<usize>) {
        while self.taken.len() < count && self.first.key < EMPTY {
            found.push(self.first.slot as usize);
            self.take();
            self.fetch(self.first.slot as usize);
        }
    }

    /// Takes the first entry out of the tree.
    #[inline]
    fn take(&mut self) {
        let first = self.first;
        self.taken.push(first);
        self.put(Entry {
            key: EMPTY,
            ..first
        });
    }

    /// The least key of all other slots.
    pub(super) fn least_but(&self, slot: usize) -> f64 {
        let is_other = |taken: &&Entry| taken.slot as usize != slot;
        let taken = self.taken.iter().filter(is_other).map(|entry| entry.key);
        let (mut place, mut least) = (slot, taken.fold(EMPTY, lesser));
        for level in &self.levels {
            let mut others = level.groups[place / WIDTH];
            others.0[place % WIDTH] = EMPTY;
            least = lesser(least, first_of(&others).1);
            place /= WIDTH;
        }
        least
    }

    /// Collects the slots that may be the first, in their order: those with keys up to
    /// the `end` of the first one with the least key.
    #[inline]
    pub(super) fn collect_front(&mut self, end: impl Fn(usize) -> f64, found: &mut Vec<usize>) {
        let least = self.least();
        self.collect_up_to(least, found);
        let end = found.first().map_or(least, |first| end(*first));
        if end > least {
            self.collect_up_to(end, found);
        }
    }

    /// Collects the slots whose keys are not above a limit, in their order; none that is
    /// empty.
    #[inline]
    fn collect_up_to(&mut self, limit: f64, found: &mut Vec<usize>) {
        if self.taken.len() >= FEW {
            self.put_back(limit);
        }
        while self.first.key <= limit && self.first.key < EMPTY && self.taken.len() < FEW {
            self.take();
        }
        let due = self.taken.iter().filter(|entry| entry.key <= limit);
        found.clear();
        found.extend(due.map(|entry| entry.slot as usize));
        if self.first.key <= limit {
            list(&self.levels, 0, limit, found);
        }
        found.sort_unstable();
    }

    /// Puts back into the tree what is after a limit.
    fn put_back(&mut self, limit: f64) {
        for place in (0..self.taken.len()).rev() {
            if self.taken[place].key > limit {
                let late = self.taken.swap_remove(place);
                self.put(late);
            }
        }
    }
}

/// Lists the slots of a group of the last of some levels whose keys are not above a limit.
/// No deeper than these are many.
fn list(levels: &[Level], group: usize, limit: f64, found: &mut Vec<usize>) {
    let Some((level, below)) = levels.split_last() else {
        found.push(group);
        return;
    };
    for (place, key) in level.groups[group].0.iter().enumerate() {
        if *key <= limit && *key < EMPTY {
            list(below, WIDTH * group + place, limit, found);
        }
    }
}

/// The place of the least key of a group, the first one of those alike, and the key.
#[inline(always)]
fn first_of(Group([a, b, c, d, e, f, g, h]): &Group) -> (usize, f64) {
    type Numbered = (usize, f64);
    let lesser = |one: Numbered, other: Numbered| if other.1 < one.1 { other } else { one };
    let [left, right] = [
        [(0, *a), (1, *b), (2, *c), (3, *d)],
        [(4, *e), (5, *f), (6, *g), (7, *h)],
    ]
    .map(|[a, b, c, d]| lesser(lesser(a, b), lesser(c, d)));
    lesser(left, right)
}

/// The lesser of two numbers, in one instruction: keys are numbers.
#[inline(always)]
fn lesser(one: f64, other: f64) -> f64 {
    if other < one { other } else { one }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// A limit to collect up to: the least key, some number, or none.
    fn limit() -> impl Strategy<Value = Option<f64>> {
        prop_oneof![
            Just(None),
            (-5..20_i32).prop_map(|limit| Some(limit.into())),
            Just(Some(f64::INFINITY)),
        ]
    }

    proptest! {
        /// Against a plain list.
        #[test]
        fn agrees_with_a_list(
            slots in 1..200_usize,
            changes in prop::collection::vec(
                (any::<prop::sample::Index>(), -5..20_i32, limit(), 0..9_usize),
                1..100,
            ),
        ) {
            let mut queue = Queue::new(slots);
            let mut list = vec![f64::INFINITY; slots];
            for (slot, key, limit, ahead) in changes {
                let slot = slot.index(slots);
                let key = if key == 0 { f64::INFINITY } else { key.into() };
                queue.set(slot, key);
                list[slot] = key;
                let least = list.iter().copied().fold(f64::INFINITY, f64::min);
                prop_assert_eq!(queue.least(), least);
                let mut next = Vec::new();
                queue.look_ahead(ahead, &mut next);
                prop_assert!(next.iter().all(|&slot| list[slot] < f64::INFINITY));
                prop_assert_eq!(queue.least(), least);
                let limit = limit.unwrap_or(least);
                let mut found = Vec::new();
                queue.collect_up_to(limit, &mut found);
                let is_found = |slot: &usize| list[*slot] <= limit && list[*slot] < f64::INFINITY;
                let expected: Vec<_> = (0..slots).filter(is_found).collect();
                prop_assert_eq!(&found, &expected);
                prop_assert_eq!(queue.least(), least);
                let others = list.iter().enumerate().filter(|(other, _)| *other != slot);
                let others = others.fold(f64::INFINITY, |least, (_, key)| least.min(*key));
                prop_assert_eq!(queue.least_but(slot), others);
                queue.collect_front(|slot| list[slot] + 1.0, &mut found);
                let is_found = |slot: &usize| list[*slot] <= least + 1.0 && list[*slot] < f64::INFINITY;
                let expected: Vec<_> = (0..slots).filter(is_found).collect();
                prop_assert_eq!(&found, &expected);
            }
        }
    }
}
