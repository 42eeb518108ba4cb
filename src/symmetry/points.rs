//! What an isometry has to map onto each other: discs, and the ends of walls.

use std::collections::{HashMap, HashSet};
use std::hash::Hash;

use num_rational::BigRational;
use num_traits::Zero;

use super::index::{Key, exact, key, mass_key, vector_key};
use super::isometry::{Vector, difference, dot};
use crate::scene::{Disc, Scene};

/// The most bits that the numerator and the denominator of a coordinate of
/// the centre may take together.
pub const CENTRE_BITS: u64 = 1 << 11;

/// The centre of a scene's symmetries, and the points that tell most about
/// them.
pub(super) struct Points {
    centre: Vector,
    /// Vectors from the centre.
    alike: Vec<Vector>,
}

impl Points {
    /// None for a scene without a disc, of one point, or with a centre that
    /// is too long to write.
    pub(super) fn new(scene: &Scene) -> Option<Self> {
        let discs = scene.discs();
        let kinds = numbered(discs.iter().map(kind));
        let smallest = smallest_group(kinds.iter().zip(discs))?.into_iter();
        let centre = centroid(smallest.map(|disc| exact(&disc.position)))?;
        let arm = |point: &Vector| difference(point, &centre);
        let discs = kinds.into_iter().zip(discs).map(|(kind, disc)| {
            let arm = arm(&exact(&disc.position));
            ((Some(kind), invariants(&arm, &exact(&disc.velocity))), arm)
        });
        let at_rest = [BigRational::zero(), BigRational::zero()];
        let ends = distinct_ends(scene).into_iter().map(|end| {
            let arm = arm(&end);
            ((None, invariants(&arm, &at_rest)), arm)
        });
        let arms = discs.chain(ends);
        let alike = smallest_group(arms.filter(|(_, arm)| !arm.iter().all(Zero::is_zero)))?;
        Some(Self { centre, alike })
    }

    /// The point that every symmetry fixes.
    pub(super) fn centre(&self) -> &Vector {
        &self.centre
    }

    /// A point that is like as few others as any, and these, as vectors from
    /// the centre, not zero: at least one.
    pub(super) fn fewest_alike(&self) -> &[Vector] {
        &self.alike
    }
}

/// What discs that are mapped onto each other agree in, wherever the centre is:
/// radius, mass and the square of the speed.
type Kind = (Key, Option<Key>, Key);

fn kind(disc: &Disc) -> Kind {
    let velocity = exact(&disc.velocity);
    (
        key(&disc.radius.to_rational()),
        mass_key(disc),
        key(&dot(&velocity, &velocity)),
    )
}

/// What no isometry about the centre changes of a point that is so far from
/// there and has this velocity.
fn invariants(arm: &Vector, velocity: &Vector) -> [Key; 2] {
    vector_key(&[dot(arm, arm), dot(arm, velocity)])
}

/// The ends of all walls, each point once.
fn distinct_ends(scene: &Scene) -> Vec<Vector> {
    let ends = scene.walls().iter().flat_map(|wall| [&wall.from, &wall.to]);
    let mut known = HashSet::new();
    ends.map(exact)
        .filter(|end| known.insert(vector_key(end)))
        .collect()
}

/// A number for each key: the same for the same key, and in the order in which
/// they first appear.
fn numbered<K: Eq + Hash>(keys: impl Iterator<Item = K>) -> Vec<usize> {
    let mut known = HashMap::new();
    keys.map(|key| {
        let next = known.len();
        *known.entry(key).or_insert(next)
    })
    .collect()
}

/// The values of the key that has the fewest, of several the one that comes
/// first.
fn smallest_group<K: Eq + Hash, V>(items: impl Iterator<Item = (K, V)>) -> Option<Vec<V>> {
    let (keys, values): (Vec<K>, Vec<V>) = items.unzip();
    let mut groups: Vec<Vec<V>> = Vec::new();
    for (number, value) in numbered(keys.into_iter()).into_iter().zip(values) {
        if number == groups.len() {
            groups.push(Vec::new());
        }
        groups[number].push(value);
    }
    groups.into_iter().min_by_key(Vec::len)
}

fn centroid(points: impl ExactSizeIterator<Item = Vector>) -> Option<Vector> {
    let count = BigRational::from_integer(points.len().into());
    let mut sum = [BigRational::zero(), BigRational::zero()];
    for [x, y] in points {
        sum = [&sum[0] + x, &sum[1] + y];
        if sum.iter().any(|part| length(part) > CENTRE_BITS) {
            return None;
        }
    }
    Some(sum.map(|part| part / &count))
}

fn length(ratio: &BigRational) -> u64 {
    ratio.numer().bits() + ratio.denom().bits()
}
