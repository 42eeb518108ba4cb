//! Families of small scenes, as many of each as one asks for.
//!
//! A family stands for one kind of difficulty, and every scene of it has that: it is
//! made so, not found by chance. A scene depends on its family, the seed and its number
//! alone, and so work on many can be cut in any way.
//!
//! Places, velocities and radii are binary64 numbers where they can be, and fractions
//! where they cannot. All are drawn as fractions, along the axes; [`place`] turns them.

mod bullets;
mod corners;
mod cradles;
mod galperin;
mod mass_ratios;
mod near_graze;
mod near_tie;
mod parts;
mod place;
mod scatter;

use std::fmt;
use std::str::FromStr;

use super::random::Random;
use crate::scene::{Scene, SceneBuilder, SceneError};

/// What the scenes of a family have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Family {
    /// Two to six discs of all sizes and masses, in a box or without walls; some lose
    /// energy.
    Random,
    /// A disc passes another, or the end of a wall, at tangency or within 2^-20 to 2^-70
    /// of it.
    NearGraze,
    /// Two impacts, with or without a common disc, at the same time or within 2^-20 to
    /// 2^-60 of it.
    NearTie,
    /// Small discs so fast that a frame takes them many times their size, against thin
    /// plates, narrow gaps and each other.
    Bullets,
    /// Lines of discs that touch or nearly do, struck at one end or at both.
    Cradles,
    /// A disc into a wedge, at ends of walls, and into a mouth as wide as itself.
    Corners,
    /// As random ones, but 10^3 to 10^9 away from the origin.
    Offsets,
    /// Masses that differ by factors of 10^3 to 10^12, and infinite ones.
    MassRatios,
    /// Two discs and a wall: the ratio of the masses alone says how often they meet.
    Galperin,
}

impl Family {
    /// All families.
    pub const ALL: [Self; 9] = [
        Self::Random,
        Self::NearGraze,
        Self::NearTie,
        Self::Bullets,
        Self::Cradles,
        Self::Corners,
        Self::Offsets,
        Self::MassRatios,
        Self::Galperin,
    ];

    /// The family's name, such as `near-graze`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::NearGraze => "near-graze",
            Self::NearTie => "near-tie",
            Self::Bullets => "bullets",
            Self::Cradles => "cradles",
            Self::Corners => "corners",
            Self::Offsets => "offsets",
            Self::MassRatios => "mass-ratios",
            Self::Galperin => "galperin",
        }
    }

    fn draw(self, random: &mut Random) -> Result<SceneBuilder, SceneError> {
        match self {
            Self::Random => Ok(scatter::random(random)),
            Self::NearGraze => near_graze::draw(random),
            Self::NearTie => near_tie::draw(random),
            Self::Bullets => bullets::draw(random),
            Self::Cradles => cradles::draw(random),
            Self::Corners => corners::draw(random),
            Self::Offsets => Ok(scatter::offset(random)),
            Self::MassRatios => Ok(mass_ratios::draw(random)),
            Self::Galperin => galperin::draw(random),
        }
    }
}

impl fmt::Display for Family {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Family {
    type Err = SceneError;

    fn from_str(text: &str) -> Result<Self, SceneError> {
        let named = Self::ALL.into_iter().find(|family| family.name() == text);
        named.ok_or_else(|| {
            let expected = format!("one of {}", Self::ALL.map(Self::name).join(", "));
            SceneError::physical("family", expected, text)
        })
    }
}

/// The scene of that number, from 0, in a family: the same seed and number give the same
/// scene on every platform and with every version, whatever else is drawn.
///
/// # Errors
///
/// None is known: a scene that could not be built would be told so.
pub fn scene_of(family: Family, seed: u64, index: u64) -> Result<Scene, SceneError> {
    let scene = family.draw(&mut Random::keyed(key(family, seed, index)))?;
    scene.id(format!("{family}-{seed}-{index}")).build()
}

/// The seed, the number and the family's name, one after the other.
fn key(family: Family, seed: u64, index: u64) -> [u8; 32] {
    let parts = [&seed.to_le_bytes()[..], &index.to_le_bytes()];
    let bytes = parts.concat().into_iter().chain(family.name().bytes());
    let mut key = [0; 32];
    key.iter_mut().zip(bytes).for_each(|(to, from)| *to = from);
    key
}
