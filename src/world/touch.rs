//! What touches and what overlaps.

use std::cmp::Ordering::{self, Greater};

use super::{Obstacle, World};
use crate::body::{Disc, Feature};
use crate::detect::{Overlap, overlap_circle, overlap_segment};
use crate::scalar::{Doubt, Scalar};
use crate::vec2::Vec2;

impl<S: Scalar> World<S> {
    /// How many pairs overlap.
    ///
    /// # Errors
    ///
    /// An enclosure does not decide it.
    pub fn count_overlaps(&self) -> Result<u64, S::Doubt> {
        let bounds = S::FILTERED.then(|| self.hull());
        let surely_apart = |disc, obstacle| {
            let bounds = bounds.as_ref();
            bounds.is_some_and(|world| matches!(world.overlap(disc, obstacle), Ok(None)))
        };
        let mut count = 0;
        for (disc, obstacle) in self.pairs() {
            if !self.is_barred(disc, obstacle) && !surely_apart(disc, obstacle) {
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
                let second = &self.discs[other];
                let offset = second.position.minus(&body.position);
                let reach = body.radius.clone() + &second.radius;
                let overlap = overlap_circle(&offset, &reach)?;
                Ok(overlap.map(|overlap| (Feature::Disc(other as u32), overlap)))
            }
            Obstacle::Wall(wall) => {
                let segment = &self.walls[wall].segment;
                let overlap = overlap_segment(&body.position, &body.radius, segment)?;
                Ok(overlap.map(|overlap| (self.feature(wall, overlap.end), overlap)))
            }
        }
    }

    /// What of an obstacle a disc touches by construction.
    #[inline]
    pub fn contact(&self, disc: usize, obstacle: Obstacle) -> Option<Feature> {
        let mut touched = self.contacts.of(disc).iter().copied();
        touched.find(|feature| self.is_part_of(*feature, obstacle))
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
        let Disc {
            position, velocity, ..
        } = &self.discs[disc];
        let closing = match feature {
            Feature::Wall(wall) => {
                let segment = &self.walls[wall as usize].segment;
                return segment.is_approached(position, velocity);
            }
            Feature::Corner(corner) => {
                let offset = self.corner_position(corner).minus(position);
                velocity.dot(&offset)
            }
            Feature::Disc(index) => {
                let closing = velocity.minus(&self.discs[index as usize].velocity);
                closing.dot(&other.minus(position))
            }
        };
        Ok(closing.sign()? == Greater)
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

    /// Forgets what a disc touches that has moved in a direction; only a wall
    /// along which it has moved, and not past an end, it goes on to touch.
    pub(crate) fn leave_contacts(&mut self, disc: usize, direction: &Vec2<S>) {
        let (walls, place) = (&self.walls, &self.discs[disc].position);
        self.contacts.leave(disc, |feature| {
            let Feature::Wall(wall) = feature else {
                return false;
            };
            let segment = &walls[wall as usize].segment;
            let slides = segment.along.cross(direction).sign();
            slides.is_ok_and(Ordering::is_eq) && segment.is_surely_beside(place)
        });
    }
}
