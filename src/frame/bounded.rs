//! A world, with binary64 bounds of it where the arithmetic wants a filter, and
//! the pairs that may meet in it.

use super::candidates::Candidates;
use super::overlap;
use crate::body::Feature;
use crate::kernel::Kernel;
use crate::scalar::{Doubt, Interval};
use crate::world::{Obstacle, World};

/// A world whose bounds and whose candidates are kept up with it.
pub(super) struct Bounded<'a, S: Kernel> {
    pub(super) world: &'a mut World<S>,
    bounds: Option<World<Interval>>,
    candidates: &'a mut Candidates,
}

impl<'a, S: Kernel> Bounded<'a, S> {
    /// The world as it is, and the candidates for a time from then on.
    pub(super) fn new(world: &'a mut World<S>, candidates: &'a mut Candidates, time: &S) -> Self {
        let bounds = S::IS_DEAR.then(|| world.hull());
        candidates.enter(world, bounds.as_ref(), time.hull().hi());
        Self {
            world,
            bounds,
            candidates,
        }
    }

    pub(super) fn bounds(&self) -> Option<&World<Interval>> {
        self.bounds.as_ref()
    }

    /// Takes note of a disc that has changed.
    pub(super) fn update(&mut self, disc: usize) {
        if let Some(bounds) = &mut self.bounds {
            bounds.discs[disc] = self.world.discs[disc].map(S::hull);
        }
        let bounds = self.bounds.as_ref();
        self.candidates.update(self.world, bounds, disc);
    }

    /// Lists the pairs that are to be tested, each with a disc that is.
    pub(super) fn list_pairs(&mut self, is_tested: impl Fn(usize) -> bool) {
        self.candidates.list(self.world, is_tested);
    }

    /// The pairs that were listed, or all.
    pub(super) fn pairs(&self) -> impl Iterator<Item = (usize, Obstacle)> {
        self.candidates.pairs(self.world)
    }

    /// Moves apart what overlaps (P3.5). Those of it that do not approach part.
    pub(super) fn resolve_overlaps(&mut self) -> Result<(), S::Doubt> {
        self.separate_all(|world, disc, feature| {
            if !world.approaches_here(disc, feature)? {
                world.remember(disc, feature);
            }
            Ok(())
        })
    }

    /// Moves apart, to exact contact, all pairs that overlap, one after the other
    /// (P3.5). Each is told of before the next one is looked for.
    pub(super) fn separate_all(
        &mut self,
        mut tell: impl FnMut(&mut World<S>, usize, Feature) -> Result<(), S::Doubt>,
    ) -> Result<(), S::Doubt> {
        for disc in 0..self.world.discs.len() {
            let mut last = disc;
            while let Some((body, feature)) = self.separate_after(disc, last)? {
                tell(self.world, disc, feature)?;
                last = body;
            }
        }
        Ok(())
    }

    /// Moves a disc and the first body after a certain one that overlaps it apart.
    fn separate_after(
        &mut self,
        disc: usize,
        last: usize,
    ) -> Result<Option<(usize, Feature)>, S::Doubt> {
        let Self {
            world,
            bounds,
            candidates,
        } = self;
        let found = candidates.find_after(disc, last, |obstacle| {
            separate(world, bounds.as_ref(), disc, obstacle)
        })?;
        if let Some((_, feature)) = found {
            self.update(disc);
            if let Feature::Disc(other) = feature {
                self.update(other as usize);
            }
        }
        Ok(found)
    }
}

/// Moves a disc and an obstacle apart if they overlap, unless bounds say that they
/// do not.
fn separate<S: Kernel>(
    world: &mut World<S>,
    bounds: Option<&World<Interval>>,
    disc: usize,
    obstacle: Obstacle,
) -> Result<Option<Feature>, S::Doubt> {
    let surely_apart =
        || bounds.is_some_and(|bounds| matches!(bounds.overlap(disc, obstacle), Ok(None)));
    if world.is_barred(disc, obstacle) || surely_apart() {
        return Ok(None);
    }
    let touched = overlap::separate(world, disc, obstacle);
    touched.map_err(|doubt| doubt.asking(|| obstacle.ask(disc, "overlap")))
}
