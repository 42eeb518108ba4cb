//! Finding the bodies of a scene by what they are.

use std::collections::HashMap;
use std::hash::Hash;

use num_bigint::BigInt;
use num_rational::BigRational;

use super::Symmetry;
use super::isometry::{Isometry, Vector};
use crate::scalar::Number;
use crate::scene::{Disc, Mass, Scene, Wall};

/// A rational as it is in lowest terms, which is hashed and compared faster
/// than the rational itself.
pub(super) type Key = (BigInt, BigInt);

pub(super) fn key(ratio: &BigRational) -> Key {
    (ratio.numer().clone(), ratio.denom().clone())
}

pub(super) fn vector_key(vector: &Vector) -> [Key; 2] {
    vector.each_ref().map(key)
}

/// None for an infinite mass.
pub(super) fn mass_key(disc: &Disc) -> Option<Key> {
    match &disc.mass {
        Mass::Finite(mass) => Some(key(&mass.to_rational())),
        Mass::Infinite => None,
    }
}

/// A point as written, exactly.
pub(super) fn exact(point: &[Number; 2]) -> Vector {
    point.each_ref().map(Number::to_rational)
}

/// The bodies of a scene, and where to find each.
pub(super) struct Index {
    gravity: Option<Vector>,
    discs: Places<Body>,
    walls: Places<[Vector; 2]>,
}

/// A disc, exactly.
struct Body {
    position: Vector,
    velocity: Vector,
    radius: Key,
    /// None if infinite.
    mass: Option<Key>,
}

impl Index {
    pub(super) fn new(scene: &Scene) -> Self {
        Self {
            gravity: scene.effects().gravity.as_ref().map(exact),
            discs: Places::new(scene.discs().iter().map(body).collect()),
            walls: Places::new(scene.walls().iter().map(ends).collect()),
        }
    }

    /// What becomes of the bodies, if an isometry is a symmetry.
    pub(super) fn symmetry(&self, isometry: &Isometry) -> Option<Symmetry> {
        let falls = self.gravity.as_ref();
        if falls.is_some_and(|gravity| isometry.vector(gravity) != *gravity) {
            return None;
        }
        Some(Symmetry {
            discs: self.discs.images(|body| body.image(isometry))?,
            walls: self.walls.images(|ends| ends.image(isometry))?,
        })
    }
}

fn body(disc: &Disc) -> Body {
    Body {
        position: exact(&disc.position),
        velocity: exact(&disc.velocity),
        radius: key(&disc.radius.to_rational()),
        mass: mass_key(disc),
    }
}

fn ends(wall: &Wall) -> [Vector; 2] {
    [exact(&wall.from), exact(&wall.to)]
}

/// What is found by all that it is.
trait Found {
    type Identity: Eq + Hash;

    /// All that it is.
    fn identity(&self) -> Self::Identity;

    /// All that its image is.
    fn image(&self, isometry: &Isometry) -> Self::Identity;
}

impl Body {
    fn moved(&self, position: &Vector, velocity: &Vector) -> <Self as Found>::Identity {
        let [position, velocity] = [position, velocity].map(vector_key);
        (position, velocity, self.radius.clone(), self.mass.clone())
    }
}

impl Found for Body {
    type Identity = ([Key; 2], [Key; 2], Key, Option<Key>);

    fn identity(&self) -> Self::Identity {
        self.moved(&self.position, &self.velocity)
    }

    fn image(&self, isometry: &Isometry) -> Self::Identity {
        self.moved(
            &isometry.point(&self.position),
            &isometry.vector(&self.velocity),
        )
    }
}

/// A wall is the same with its ends exchanged.
impl Found for [Vector; 2] {
    type Identity = [[Key; 2]; 2];

    fn identity(&self) -> Self::Identity {
        let mut ends = self.each_ref().map(vector_key);
        ends.sort_unstable();
        ends
    }

    fn image(&self, isometry: &Isometry) -> Self::Identity {
        self.each_ref().map(|end| isometry.point(end)).identity()
    }
}

/// Bodies of one sort, and where to find them.
struct Places<T: Found> {
    bodies: Vec<T>,
    places: HashMap<T::Identity, Vec<u32>>,
}

impl<T: Found> Places<T> {
    fn new(bodies: Vec<T>) -> Self {
        let mut places: HashMap<_, Vec<u32>> = HashMap::new();
        for (place, body) in (0..).zip(&bodies) {
            places.entry(body.identity()).or_default().push(place);
        }
        Self { bodies, places }
    }

    /// The place of each body's image, if all are among the bodies and no two
    /// at one place: of several that are alike, each image takes the next.
    fn images(&self, image: impl Fn(&T) -> T::Identity) -> Option<Vec<u32>> {
        let mut taken = vec![0; self.bodies.len()];
        let image_of = |body| {
            let alike = self.places.get(&image(body))?;
            let taken: &mut usize = &mut taken[alike[0] as usize];
            *taken += 1;
            alike.get(*taken - 1).copied()
        };
        self.bodies.iter().map(image_of).collect()
    }
}
