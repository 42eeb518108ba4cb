//! Who touches whom by construction.
//!
//! Bodies that were moved to their contact touch exactly, but an enclosure of
//! their distance cannot show it, and a rounded one shows something else. So
//! it is remembered, for as long as neither has moved away. Whether they collide is
//! then a matter of their velocities alone (D18).

use crate::body::Feature;

/// For each disc, what it touches.
#[derive(Clone, Debug, Default)]
pub struct Contacts {
    of: Vec<Vec<Feature>>,
}

impl Contacts {
    /// No contacts, for so many discs.
    pub fn none(discs: usize) -> Self {
        Self {
            of: vec![Vec::new(); discs],
        }
    }

    /// What a disc touches.
    #[inline]
    pub fn of(&self, disc: usize) -> &[Feature] {
        &self.of[disc]
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
    pub fn leave(&mut self, disc: usize, keeps: impl Fn(Feature) -> bool) {
        let mut left = std::mem::take(&mut self.of[disc]);
        for feature in left.iter().filter(|feature| !keeps(**feature)) {
            if let Feature::Disc(other) = *feature {
                let own = Feature::Disc(disc as u32);
                self.of[other as usize].retain(|feature| *feature != own);
            }
        }
        left.retain(|feature| keeps(*feature));
        self.of[disc] = left;
    }

    fn add(&mut self, disc: usize, feature: Feature) {
        if !self.of[disc].contains(&feature) {
            self.of[disc].push(feature);
        }
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
