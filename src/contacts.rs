//! Who touches whom by construction.
//!
//! Bodies that were moved to their contact touch exactly, but an enclosure of
//! their distance cannot show it, and a rounded one shows something else. So
//! it is remembered, for as long as neither has moved away. Whether they collide is
//! then a matter of their velocities alone (D18).

use std::collections::BTreeMap;

use prefetch_index::prefetch_index;

use crate::body::Feature;

/// For each disc, what it touches.
#[derive(Clone, Debug, Default)]
pub struct Contacts {
    of: Vec<Touched>,
    /// The features that discs touch several of.
    several: BTreeMap<usize, Vec<Feature>>,
}

/// What a disc touches: mostly no more than what it collided with last.
#[derive(Clone, Copy, Debug, Default)]
enum Touched {
    #[default]
    Nothing,
    One(Feature),
    Several,
}

impl Contacts {
    /// No contacts, for so many discs.
    pub fn none(discs: usize) -> Self {
        Self {
            of: vec![Touched::Nothing; discs],
            several: BTreeMap::new(),
        }
    }

    /// What a disc touches.
    #[inline]
    pub fn of(&self, disc: usize) -> &[Feature] {
        match &self.of[disc] {
            Touched::Nothing => &[],
            Touched::One(feature) => std::slice::from_ref(feature),
            Touched::Several => &self.several[&disc],
        }
    }

    /// Fetches what a disc touches into the cache.
    #[inline]
    pub(crate) fn fetch(&self, disc: usize) {
        prefetch_index(&self.of, disc);
    }

    /// Notes that a disc and a feature touch.
    pub fn join(&mut self, disc: usize, feature: Feature) {
        self.add(disc, feature);
        if let Feature::Disc(other) = feature {
            self.add(other as usize, Feature::Disc(disc as u32));
        }
    }

    /// Notes that a disc has moved, so that it touches nothing any more but
    /// what it `keeps`.
    #[inline]
    pub fn leave(&mut self, disc: usize, keeps: impl Fn(Feature) -> bool) {
        match self.of[disc] {
            Touched::Nothing => {}
            Touched::One(feature) if keeps(feature) => {}
            Touched::One(feature) => {
                self.of[disc] = Touched::Nothing;
                self.forget(disc, feature);
            }
            Touched::Several => self.leave_several(disc, keeps),
        }
    }

    fn leave_several(&mut self, disc: usize, keeps: impl Fn(Feature) -> bool) {
        let features = self.several.remove(&disc).unwrap_or_default();
        let (kept, left): (Vec<_>, Vec<_>) = features.into_iter().partition(|&one| keeps(one));
        self.put(disc, kept);
        for feature in left {
            self.forget(disc, feature);
        }
    }

    /// Notes that a feature does not touch a disc any more.
    fn forget(&mut self, disc: usize, feature: Feature) {
        if let Feature::Disc(other) = feature {
            self.remove(other as usize, Feature::Disc(disc as u32));
        }
    }

    fn add(&mut self, disc: usize, feature: Feature) {
        match self.of[disc] {
            Touched::Nothing => self.of[disc] = Touched::One(feature),
            Touched::One(other) if other == feature => {}
            Touched::One(other) => self.put(disc, vec![other, feature]),
            Touched::Several => {
                let features = self.several.entry(disc).or_default();
                if !features.contains(&feature) {
                    features.push(feature);
                }
            }
        }
    }

    fn remove(&mut self, disc: usize, feature: Feature) {
        match self.of[disc] {
            Touched::One(other) if other == feature => self.of[disc] = Touched::Nothing,
            Touched::Nothing | Touched::One(_) => {}
            Touched::Several => {
                let mut features = self.several.remove(&disc).unwrap_or_default();
                features.retain(|other| *other != feature);
                self.put(disc, features);
            }
        }
    }

    fn put(&mut self, disc: usize, features: Vec<Feature>) {
        self.of[disc] = match features[..] {
            [] => Touched::Nothing,
            [feature] => Touched::One(feature),
            _ => {
                self.several.insert(disc, features);
                Touched::Several
            }
        };
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
