//! What touches and what overlaps.

use std::cmp::Ordering;

use super::{Obstacle, World};
use crate::body::Feature;
use crate::detect::Overlap;
use crate::kernel::{Kernel, Pull};
use crate::scalar::Doubt;
use crate::vec2::Vec2;

impl<S: Kernel> World<S> {
    /// How many pairs overlap, in a plane that does not repeat.
    ///
    /// # Errors
    ///
    /// An enclosure does not decide it.
    pub fn count_overlaps(&self) -> Result<u64, S::Doubt> {
        let mut count = 0;
        for (disc, obstacle) in self.close_pairs() {
            if !self.is_barred(disc, obstacle) {
                let overlap = self.overlap(disc, obstacle);
                let overlap =
                    overlap.map_err(|doubt| doubt.asking(|| obstacle.ask(disc, "overlap")))?;
                count += u64::from(overlap.is_some());
            }
        }
        Ok(count)
    }

    /// The overlap of a disc and an obstacle, if there is one, and what of the
    /// obstacle is nearest.
    ///
    /// # Errors
    ///
    /// An enclosure does not decide it.
    pub fn overlap(
        &self,
        disc: usize,
        obstacle: Obstacle,
    ) -> Result<Option<(Feature, Overlap<S>)>, S::Doubt> {
        if self.contact(disc, obstacle).is_some() {
            return Ok(None);
        }
        let body = &self.discs[disc];
        match obstacle {
            Obstacle::Disc(other) => {
                let overlap = S::overlap_discs(body, &self.discs[other])?;
                Ok(overlap.map(|overlap| (Feature::Disc(other as u32), overlap)))
            }
            Obstacle::Wall(wall) => {
                let segment = &self.walls[wall].segment;
                let overlap = S::overlap_wall(body, segment)?;
                Ok(overlap.map(|overlap| (self.feature(wall, overlap.end), overlap)))
            }
        }
    }

    /// What of an obstacle a disc touches by construction.
    // A call of its own costs a percent of what an impact does in binary64.
    #[inline(always)]
    pub fn contact(&self, disc: usize, obstacle: Obstacle) -> Option<Feature> {
        if !S::REMEMBERS_CONTACTS {
            return None;
        }
        let mut touched = self.contacts.of(disc).iter().copied();
        touched.find(|feature| self.is_part_of(*feature, obstacle))
    }

    /// Takes note that a disc has got to the interior of a wall, if that is what it
    /// has met.
    pub(crate) fn touch_wall(&mut self, disc: usize, feature: Feature) {
        if let Feature::Wall(wall) = feature {
            let body = &mut self.discs[disc];
            body.position = S::place_at_wall(body, &self.walls[wall as usize].segment);
        }
    }

    /// The obstacles that a disc touches by construction.
    pub(crate) fn touched(&self, disc: usize) -> impl Iterator<Item = Obstacle> {
        let features = self.contacts.of(disc).iter();
        features.flat_map(|&feature| self.obstacles_of(feature))
    }

    /// The obstacles that a feature is part of.
    fn obstacles_of(&self, feature: Feature) -> impl Iterator<Item = Obstacle> {
        let (disc, walls) = match feature {
            Feature::Disc(other) => (Some(Obstacle::Disc(other as usize)), 0..0),
            Feature::Wall(wall) => (None, wall as usize..wall as usize + 1),
            Feature::Corner(_) => (None, 0..self.walls.len()),
        };
        let walls = walls.map(Obstacle::Wall);
        disc.into_iter()
            .chain(walls.filter(move |wall| self.is_part_of(feature, *wall)))
    }

    /// Whether a disc moves towards a feature that it touches, another disc
    /// being where `other` says.
    ///
    /// # Errors
    ///
    /// An enclosure does not decide it.
    pub fn approaches(
        &self,
        disc: usize,
        feature: Feature,
        other: &Vec2<S>,
    ) -> Result<bool, S::Doubt> {
        let disc = &self.discs[disc];
        match feature {
            Feature::Wall(wall) => S::approaches_wall(disc, &self.walls[wall as usize].segment),
            Feature::Corner(corner) => {
                S::approaches_point(disc, self.corner_position(corner), &Vec2::zero())
            }
            Feature::Disc(index) => {
                let velocity = &self.discs[index as usize].velocity;
                S::approaches_point(disc, other, velocity)
            }
        }
    }

    /// Whether a disc moves towards a feature that it touches where all are.
    ///
    /// # Errors
    ///
    /// An enclosure does not decide it.
    pub fn approaches_here(&self, disc: usize, feature: Feature) -> Result<bool, S::Doubt> {
        let other = match feature {
            Feature::Disc(other) => self.discs[other as usize].position.clone(),
            Feature::Wall(_) | Feature::Corner(_) => Vec2::zero(),
        };
        self.approaches(disc, feature, &other)
    }

    /// Remembers that a disc and a feature touch.
    pub(crate) fn join(&mut self, disc: usize, feature: Feature) {
        if S::REMEMBERS_CONTACTS {
            self.contacts.join(disc, feature);
        }
    }

    /// Forgets what a disc touches that has moved in a direction to where it
    /// is; only a wall along which it moved it goes on to touch, up to its end.
    pub(crate) fn leave_contacts(&mut self, disc: usize, direction: &Vec2<S>) {
        let (walls, position) = (&self.walls, &self.discs[disc].position);
        let pull = S::Pull::of(&self.pulls, disc);
        self.contacts.leave(disc, |feature| {
            let Feature::Wall(wall) = feature else {
                return false;
            };
            if !S::IS_STRAIGHT {
                return pull.is_held_by(wall as usize);
            }
            let segment = &walls[wall as usize].segment;
            let across = segment.along.cross(direction);
            across.sign().is_ok_and(Ordering::is_eq) && segment.is_surely_beside(position)
        });
    }
}
