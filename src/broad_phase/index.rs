//! Where bodies may be, looked up by area.

use super::BroadPhase;
use super::area::Area;
use super::bsp::Tree;
use super::grid::Grid;
use super::lists::Lists;

/// The areas of some bodies, and in which parts of the plane they are.
///
/// A body that has moved is entered once more, and stays where it was: its area
/// as it is now tells whether it is found there.
#[derive(Clone, Debug, Default)]
pub(crate) struct Index {
    areas: Vec<Area>,
    partition: Partition,
    lists: Lists,
    /// Those whose areas are too large to be entered anywhere.
    everywhere: Vec<u32>,
    /// The latest look that has found each body.
    found: Vec<u64>,
    looks: u64,
}

/// How the plane is divided.
#[derive(Clone, Debug, Default)]
enum Partition {
    /// Not at all.
    #[default]
    Whole,
    Grid(Grid),
    Tree(Tree),
}

impl Index {
    /// Enters bodies anew, each with its area.
    pub(crate) fn rebuild(&mut self, phase: BroadPhase, areas: impl Iterator<Item = Area>) {
        self.areas.clear();
        self.areas.extend(areas);
        self.partition.adapt(phase, &self.areas);
        self.lists.reset(self.partition.parts());
        self.everywhere.clear();
        self.found.clear();
        self.found.resize(self.areas.len(), 0);
        self.looks = 0;
        for body in 0..self.areas.len() {
            self.enter(body as u32);
        }
    }

    /// Enters a body that is elsewhere now.
    pub(crate) fn replace(&mut self, body: usize, area: Area) {
        self.areas[body] = area;
        self.enter(body as u32);
    }

    fn enter(&mut self, body: u32) {
        let Self {
            areas,
            partition,
            lists,
            everywhere,
            ..
        } = self;
        let area = &areas[body as usize];
        if !partition.visit(area, |part| lists.push(part, body)) {
            everywhere.push(body);
        }
    }

    /// Visits every other body whose area overlaps that of a body: each once, in
    /// no order.
    pub(crate) fn look_about(&mut self, body: usize, mut visit: impl FnMut(usize)) {
        self.looks += 1;
        let Self {
            areas,
            partition,
            lists,
            everywhere,
            found,
            looks,
        } = self;
        let area = areas[body];
        found[body] = *looks;
        let mut find = |other: u32| {
            let other = other as usize;
            if found[other] != *looks && area.overlaps(&areas[other]) {
                found[other] = *looks;
                visit(other);
            }
        };
        if partition.visit(&area, |part| lists.of(part).for_each(&mut find)) {
            everywhere.iter().copied().for_each(find);
        } else {
            (0..areas.len() as u32).for_each(find);
        }
    }
}

impl Partition {
    /// Divides the plane anew for some areas.
    fn adapt(&mut self, phase: BroadPhase, areas: &[Area]) {
        match (phase, &mut *self) {
            (BroadPhase::Bsp, Self::Tree(tree)) => tree.adapt(areas),
            (BroadPhase::Bsp, _) => {
                let mut tree = Tree::default();
                tree.adapt(areas);
                *self = Self::Tree(tree);
            }
            (BroadPhase::Grid, _) => *self = Grid::of(areas).map_or(Self::Whole, Self::Grid),
            (BroadPhase::AllPairs, _) => *self = Self::Whole,
        }
    }

    fn parts(&self) -> usize {
        match self {
            Self::Whole => 1,
            Self::Grid(grid) => grid.places(),
            Self::Tree(tree) => tree.parts(),
        }
    }

    /// Visits the parts that an area touches, unless they are too many: it says
    /// whether it did.
    #[inline]
    fn visit(&self, area: &Area, mut visit: impl FnMut(usize)) -> bool {
        match self {
            Self::Whole => visit(0),
            Self::Grid(grid) => match grid.cells(area) {
                Some(cells) => grid.visit(cells, visit),
                None => return false,
            },
            Self::Tree(tree) if area.is_bounded() => tree.visit(area, visit),
            Self::Tree(_) => return false,
        }
        true
    }
}
