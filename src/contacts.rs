//! Who touches whom by construction.
//!
//! Bodies that were moved to their contact touch exactly, but an enclosure of
//! their distance cannot show it, and a rounded one shows something else. So
//! it is remembered, for as long as neither has moved away. Whether they collide is
//! then a matter of their velocities alone (D18).

use prefetch_index::prefetch_index;

use crate::body::Feature;

/// For each disc, what it touches.
#[derive(Clone, Debug, Default)]
pub struct Contacts {
    of: Vec<Touched>,
}

/// What a disc touches: mostly no more than what it collided with last.
#[derive(Clone, Debug, Default)]
enum Touched {
    #[default]
    Nothing,
    One(Feature),
    #[expect(clippy::box_collection, reason = "it is rare, and so takes less room")]
    Several(Box<Vec<Feature>>),
}

impl Touched {
    #[inline]
    fn features(&self) -> &[Feature] {
        match self {
            Self::Nothing => &[],
            Self::One(feature) => std::slice::from_ref(feature),
            Self::Several(features) => features,
        }
    }

    fn add(&mut self, feature: Feature) {
        match self {
            Self::Nothing => *self = Self::One(feature),
            Self::One(other) if *other == feature => {}
            Self::One(other) => *self = Self::Several(Box::new(vec![*other, feature])),
            Self::Several(features) if features.contains(&feature) => {}
            Self::Several(features) => features.push(feature),
        }
    }

    fn retain(&mut self, keeps: impl Fn(Feature) -> bool) {
        match self {
            Self::Nothing => {}
            Self::One(feature) if keeps(*feature) => {}
            Self::One(_) => *self = Self::Nothing,
            Self::Several(features) => features.retain(|feature| keeps(*feature)),
        }
    }
}

impl Contacts {
    /// No contacts, for so many discs.
    pub fn none(discs: usize) -> Self {
        Self {
            of: vec![Touched::Nothing; discs],
        }
    }

    /// What a disc touches.
    #[inline]
    pub fn of(&self, disc: usize) -> &[Feature] {
        self.of[disc].features()
    }

    /// Fetches what a disc touches into the cache.
    #[inline]
    pub(crate) fn fetch(&self, disc: usize) {
        prefetch_index(&self.of, disc);
    }

    /// Notes that a disc and a feature touch.
    pub fn join(&mut self, disc: usize, feature: Feature) {
        self.of[disc].add(feature);
        if let Feature::Disc(other) = feature {
            self.of[other as usize].add(Feature::Disc(disc as u32));
        }
    }

    /// Notes that a disc has moved, so that it touches nothing any more but
    /// what it `keeps`.
    #[inline]
    pub fn leave(&mut self, disc: usize, keeps: impl Fn(Feature) -> bool) {
        if !self.of[disc].features().is_empty() {
            self.leave_some(disc, keeps);
        }
    }

    fn leave_some(&mut self, disc: usize, keeps: impl Fn(Feature) -> bool) {
        let mut left = std::mem::take(&mut self.of[disc]);
        for feature in left.features().iter().filter(|feature| !keeps(**feature)) {
            if let Feature::Disc(other) = *feature {
                let own = Feature::Disc(disc as u32);
                self.of[other as usize].retain(|feature| feature != own);
            }
        }
        left.retain(keeps);
        self.of[disc] = left;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_contact_ends_for_both_discs() {
        let mut contacts = Contacts::none(3);
        contacts.join(0, Feature::Disc(2));
        contacts.join(2, Feature::Wall(1));
        assert_eq!(contacts.of(2), [Feature::Disc(0), Feature::Wall(1)]);
        contacts.leave(0, |_| false);
        assert_eq!(contacts.of(0), []);
        assert_eq!(contacts.of(2), [Feature::Wall(1)]);
        contacts.leave(2, |feature| feature == Feature::Wall(1));
        assert_eq!(contacts.of(2), [Feature::Wall(1)]);
    }
}
