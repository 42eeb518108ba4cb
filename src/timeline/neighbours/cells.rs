//! Lists of discs, one for each of many cells, most of them short.

use std::collections::BTreeMap;

/// So many discs alike fit into a cell.
pub(super) const ROOM: usize = 4;

/// No disc.
const NONE: u32 = u32::MAX;

/// The discs in each cell, in no order: some in an array, the others apart.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    few: Vec<[u32; ROOM]>,
    others: BTreeMap<u32, Vec<u32>>,
}

impl Cells {
    /// So many empty cells.
    pub(super) fn new(count: usize) -> Self {
        Self {
            few: vec![[NONE; ROOM]; count],
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

    /// Adds the discs in a cell's array to a list of so many, which has room for
    /// all of an array; and tells how many there are then. Without branches, for
    /// how many there are is as good as random.
    #[inline]
    pub(super) fn list(&self, cell: u32, list: &mut [u32], count: usize) -> usize {
        let few = &self.few[cell as usize];
        list[count..count + ROOM].copy_from_slice(few);
        let more: u32 = few.iter().map(|disc| u32::from(*disc != NONE)).sum();
        count + more as usize
    }

    /// Whether any cell has more discs than that.
    #[inline]
    pub(super) fn have_others(&self) -> bool {
        !self.others.is_empty()
    }

    /// The discs in a cell that are not in its array.
    pub(super) fn others(&self, cell: u32) -> &[u32] {
        self.others.get(&cell).map_or(&[], Vec::as_slice)
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
                    let mut found = vec![NONE; ROOM];
                    let count = cells.list(cell, &mut found, 0);
                    found.truncate(count);
                    found.extend(cells.others(cell));
                    let expected: BTreeSet<u32> =
                        (0..20).filter(|disc| place[*disc as usize] == Some(cell)).collect();
                    prop_assert_eq!(found.len(), expected.len());
                    prop_assert_eq!(BTreeSet::from_iter(found), expected);
                }
            }
        }
    }
}
