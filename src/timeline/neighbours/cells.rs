//! Lists of discs, one for each of many cells, most of them short.

use std::collections::BTreeMap;

use prefetch_index::prefetch_index;

/// So many discs alike fit into a cell.
const ROOM: usize = 4;

/// So many cells have their bits in one word.
const WORD: usize = u64::BITS as usize;

/// No disc.
const NONE: u32 = u32::MAX;

/// How many places of an array are filled: those of which the highest bit is not set,
/// which no disc has.
#[inline]
fn filled(few: &[u32; ROOM]) -> usize {
    let empty: i32 = few.iter().map(|disc| disc.cast_signed() >> 31).sum();
    (ROOM as i32 + empty) as usize
}

/// The discs in each cell, in no order: some in an array, the others apart.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    few: Vec<[u32; ROOM]>,
    /// A bit for each cell that is not empty.
    filled: Vec<u64>,
    others: BTreeMap<u32, Vec<u32>>,
}

impl Cells {
    /// So many empty cells.
    pub(super) fn new(count: usize) -> Self {
        Self {
            few: vec![[NONE; ROOM]; count],
            filled: vec![0; count.div_ceil(WORD)],
            others: BTreeMap::new(),
        }
    }

    /// Puts a disc into a cell.
    #[inline]
    pub(super) fn insert(&mut self, cell: u32, disc: u32) {
        let few = &mut self.few[cell as usize];
        match few.iter_mut().find(|place| **place == NONE) {
            Some(place) => *place = disc,
            None => self.others.entry(cell).or_default().push(disc),
        }
        self.filled[cell as usize / WORD] |= 1 << (cell as usize % WORD);
    }

    /// Takes a disc out of its cell; the last of its array, or one that is not in
    /// it, gets its place.
    #[inline]
    pub(super) fn remove(&mut self, cell: u32, disc: u32) {
        let few = &mut self.few[cell as usize];
        let count = few.iter().take_while(|place| **place != NONE).count();
        let other = match few[ROOM - 1] {
            NONE => NONE,
            _ => self.take_other(cell, disc),
        };
        let few = &mut self.few[cell as usize];
        let Some(place) = few.iter().position(|place| *place == disc) else {
            return;
        };
        if other == NONE {
            few[place] = few[count - 1];
            few[count - 1] = NONE;
        } else {
            few[place] = other;
        }
        if few[0] == NONE {
            self.filled[cell as usize / WORD] &= !(1 << (cell as usize % WORD));
        }
    }

    /// Takes a disc out of those that are not in a cell's array, or any of them if
    /// it is not there.
    #[cold]
    fn take_other(&mut self, cell: u32, disc: u32) -> u32 {
        let Some(others) = self.others.get_mut(&cell) else {
            return NONE;
        };
        let place = others.iter().position(|other| *other == disc);
        let taken = others.swap_remove(place.unwrap_or(others.len() - 1));
        if others.is_empty() {
            self.others.remove(&cell);
        }
        taken
    }

    /// Fetches a cell into the cache.
    #[inline]
    pub(super) fn fetch(&self, cell: u32) {
        prefetch_index(&self.few, cell as usize);
    }

    /// Adds to a list the discs in some cells. Without branches on how many there are, for
    /// that is as good as random.
    #[inline]
    pub(super) fn list<const N: usize>(&self, cells: [u32; N], list: &mut Vec<u32>) {
        let (mut count, mut last) = (list.len(), NONE);
        list.resize(count + N * ROOM, NONE);
        for cell in cells {
            let few = &self.few[cell as usize];
            list[count..count + ROOM].copy_from_slice(few);
            count += filled(few);
            last &= few[ROOM - 1];
        }
        list.truncate(count);
        if last != NONE {
            let others = |cell| self.others.get(&cell).into_iter().flatten();
            list.extend(cells.into_iter().flat_map(others));
        }
    }

    /// Adds to a list the discs in all cells from one to another.
    pub(super) fn list_between(&self, first: u32, last: u32, list: &mut Vec<u32>) {
        let [start, end] = [first, last].map(|cell| cell as usize / WORD);
        for word in start..=end {
            let mut filled = self.filled[word];
            if word == start {
                filled &= u64::MAX << (first as usize % WORD);
            }
            if word == end {
                filled &= u64::MAX >> (WORD - 1 - last as usize % WORD);
            }
            while filled != 0 {
                self.list_one((word * WORD) as u32 + filled.trailing_zeros(), list);
                filled &= filled - 1;
            }
        }
    }

    /// Adds all discs to a list.
    pub(super) fn list_all(&self, list: &mut Vec<u32>) {
        self.list_between(0, self.few.len() as u32 - 1, list);
    }

    /// Adds the discs in a cell to a list.
    fn list_one(&self, cell: u32, list: &mut Vec<u32>) {
        let few = self.few[cell as usize].iter();
        list.extend(few.take_while(|disc| **disc != NONE));
        if let Some(others) = self.others.get(&cell) {
            list.extend(others);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use proptest::prelude::*;

    use super::*;

    proptest! {
        /// Against sets: each disc is moved to a cell, again and again.
        #[test]
        fn agree_with_sets(moves in prop::collection::vec((0..20_u32, 0..3_u32), 1..200)) {
            let mut cells = Cells::new(3);
            let mut place = [None; 20];
            for (disc, cell) in moves {
                if let Some(before) = place[disc as usize].replace(cell) {
                    cells.remove(before, disc);
                }
                cells.insert(cell, disc);
                for cell in 0..3 {
                    let [mut found, mut alone] = [vec![], vec![]];
                    cells.list([cell], &mut found);
                    cells.list_between(cell, cell, &mut alone);
                    prop_assert_eq!(&found, &alone);
                    let expected: BTreeSet<u32> =
                        (0..20).filter(|disc| place[*disc as usize] == Some(cell)).collect();
                    prop_assert_eq!(found.len(), expected.len());
                    prop_assert_eq!(BTreeSet::from_iter(found), expected);
                }
                let mut all = vec![];
                cells.list_all(&mut all);
                prop_assert_eq!(all.len(), place.iter().flatten().count());
            }
        }
    }
}
