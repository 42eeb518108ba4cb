//! A binary space partition: the plane, split by lines along the axes again and
//! again, each time at the median of what is there.
//!
//! A part that is no wider than what is in it is not split: where a line has most
//! areas on both sides, it separates nothing.
//!
//! The nodes stand in one array, each before those below it, with the place where
//! those end: a walk goes through the array, and past what an area does not reach.
//!
//! Any lines will do. Those that were good for what is there go on to be so for
//! some time, while it moves: they are drawn anew only now and then.

use super::area::Area;

/// So few areas are not worth a line.
const FEW: usize = 6;

/// So many lines are not crossed to get anywhere.
const DEEPEST: usize = 48;

/// So often lines are used.
const USES: u32 = 16;

/// The lines, and the parts that they leave.
#[derive(Clone, Debug, Default)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    parts: usize,
    /// For how many areas they were drawn, and how often they may still be used.
    drawn_for: usize,
    uses: u32,
    /// The bodies in the nodes that are being split, the innermost last.
    bodies: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    side: Side,
    /// The part that it is, unless it is split.
    part: Option<u32>,
    /// The first node that is not below this one.
    end: u32,
}

/// One side of a line.
#[derive(Clone, Copy, Debug)]
struct Side {
    axis: usize,
    at: f64,
    is_low: bool,
}

impl Side {
    /// The side of no line.
    const WHOLE: Self = Self {
        axis: 0,
        at: f64::INFINITY,
        is_low: true,
    };

    /// The line itself belongs to both sides.
    #[inline]
    fn is_reached(&self, area: &Area) -> bool {
        if self.is_low {
            area.lo[self.axis] <= self.at
        } else {
            area.hi[self.axis] >= self.at
        }
    }
}

impl Tree {
    /// Splits the plane for some areas, unless it is split well enough.
    pub(super) fn adapt(&mut self, areas: &[Area]) {
        if self.uses == 0 || self.drawn_for != areas.len() {
            self.grow(areas);
            (self.drawn_for, self.uses) = (areas.len(), USES);
        }
        self.uses -= 1;
    }

    fn grow(&mut self, areas: &[Area]) {
        self.nodes.clear();
        self.parts = 0;
        self.bodies.clear();
        let bounded = areas.iter().zip(0..).filter(|(area, _)| area.is_bounded());
        self.bodies.extend(bounded.map(|(_, body)| body));
        self.grow_node(areas, 0, Side::WHOLE, DEEPEST);
    }

    /// How many parts there are.
    pub(super) fn parts(&self) -> usize {
        self.parts
    }

    /// Adds a node for the bodies from a place on, and those below it.
    fn grow_node(&mut self, areas: &[Area], start: usize, side: Side, depth: usize) {
        let node = self.nodes.len();
        let line = self.line(areas, start).filter(|_| depth > 0);
        self.nodes.push(Node {
            side,
            part: line.is_none().then_some(self.parts as u32),
            end: 0,
        });
        match line {
            None => self.parts += 1,
            Some((axis, at)) => {
                for is_low in [true, false] {
                    self.grow_side(areas, start, Side { axis, at, is_low }, depth - 1);
                }
            }
        }
        self.nodes[node].end = self.nodes.len() as u32;
    }

    fn grow_side(&mut self, areas: &[Area], start: usize, side: Side, depth: usize) {
        let end = self.bodies.len();
        for place in start..end {
            let body = self.bodies[place];
            if side.is_reached(&areas[body as usize]) {
                self.bodies.push(body);
            }
        }
        self.grow_node(areas, end, side, depth);
        self.bodies.truncate(end);
    }

    /// The line that splits the bodies from a place on, if one is worth it: across
    /// the axis along which they are spread the most.
    fn line(&mut self, areas: &[Area], start: usize) -> Option<(usize, f64)> {
        let bodies = &mut self.bodies[start..];
        if bodies.len() <= FEW {
            return None;
        }
        let area = |body: u32| &areas[body as usize];
        let spread = |axis: usize| {
            let middles = bodies.iter().map(|&body| area(body).middle(axis));
            let (lo, hi) = middles.fold((f64::MAX, f64::MIN), |(lo, hi), middle| {
                (lo.min(middle), hi.max(middle))
            });
            hi - lo
        };
        let axis = usize::from(spread(1) > spread(0));
        let half = bodies.len() / 2;
        let middle = |body: &u32| area(*body).middle(axis);
        let (_, median, _) =
            bodies.select_nth_unstable_by(half, |one, other| middle(one).total_cmp(&middle(other)));
        let at = middle(median);
        let cut = |body: &&u32| area(**body).lo[axis] <= at && area(**body).hi[axis] >= at;
        (2 * bodies.iter().filter(cut).count() < bodies.len()).then_some((axis, at))
    }

    /// Visits the parts that an area reaches.
    #[inline]
    pub(super) fn visit(&self, area: &Area, mut visit: impl FnMut(usize)) {
        let mut at = 0;
        while let Some(node) = self.nodes.get(at) {
            if !node.side.is_reached(area) {
                at = node.end as usize;
                continue;
            }
            if let Some(part) = node.part {
                visit(part as usize);
            }
            at += 1;
        }
    }
}
