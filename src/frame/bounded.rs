//! A world, with binary64 bounds of it where the arithmetic wants a filter.

use super::overlap;
use crate::body::Feature;
use crate::kernel::Kernel;
use crate::scalar::{Doubt, Interval};
use crate::world::{Obstacle, World};

/// A world whose bounds are kept up with it.
pub(super) struct Bounded<'a, S: Kernel> {
    pub(super) world: &'a mut World<S>,
    bounds: Option<World<Interval>>,
}

impl<'a, S: Kernel> Bounded<'a, S> {
    pub(super) fn new(world: &'a mut World<S>) -> Self {
        Self {
            bounds: S::IS_DEAR.then(|| world.hull()),
            world,
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
    }

    /// Moves apart what overlaps (P3.5). Those of it that do not approach part.
    pub(super) fn resolve_overlaps(&mut self) -> Result<(), S::Doubt> {
        for (disc, obstacle) in self.world.pairs() {
            let Some(feature) = self.separate(disc, obstacle)? else {
                continue;
            };
            if !self.world.approaches_here(disc, feature)? {
                self.world.remember(disc, feature);
            }
        }
        Ok(())
    }

    /// Moves a disc and an obstacle apart if they overlap, to exact contact.
    pub(super) fn separate(
        &mut self,
        disc: usize,
        obstacle: Obstacle,
    ) -> Result<Option<Feature>, S::Doubt> {
        if self.world.is_barred(disc, obstacle) || self.surely_apart(disc, obstacle) {
            return Ok(None);
        }
        let touched = overlap::separate(self.world, disc, obstacle);
        let touched = touched.map_err(|doubt| doubt.asking(|| obstacle.ask(disc, "overlap")))?;
        if touched.is_some() {
            self.update(disc);
            if let Obstacle::Disc(other) = obstacle {
                self.update(other);
            }
        }
        Ok(touched)
    }

    fn surely_apart(&self, disc: usize, obstacle: Obstacle) -> bool {
        let bounds = self.bounds.as_ref();
        bounds.is_some_and(|bounds| matches!(bounds.overlap(disc, obstacle), Ok(None)))
    }
}
