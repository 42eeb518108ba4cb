//! Lists of bodies, one for each of many cells.

/// No entry.
const NONE: u32 = u32::MAX;

/// The bodies in each cell, as chains through one array.
#[derive(Clone, Debug, Default)]
pub(super) struct Lists {
    heads: Vec<u32>,
    entries: Vec<Entry>,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    body: u32,
    next: u32,
}

impl Lists {
    /// So many empty lists.
    pub(super) fn reset(&mut self, cells: usize) {
        self.heads.clear();
        self.heads.resize(cells, NONE);
        self.entries.clear();
    }

    #[inline]
    pub(super) fn push(&mut self, cell: usize, body: u32) {
        let head = &mut self.heads[cell];
        let next = std::mem::replace(head, self.entries.len() as u32);
        self.entries.push(Entry { body, next });
    }

    /// The bodies in a cell, the latest first.
    #[inline]
    pub(super) fn of(&self, cell: usize) -> impl Iterator<Item = u32> {
        let entry = |at: u32| self.entries.get(at as usize);
        let chain = std::iter::successors(entry(self.heads[cell]), move |last| entry(last.next));
        chain.map(|entry| entry.body)
    }
}
