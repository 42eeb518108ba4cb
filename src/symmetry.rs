//! The symmetries of a scene, exactly.
//!
//! A symmetry is an isometry of the plane that maps a scene onto itself: each
//! disc onto one of the same radius and mass whose velocity is the image of
//! its own, each wall onto a wall, gravity onto itself. What happens in a scene
//! and its image is the same, so impacts that a symmetry maps onto each other
//! happen at the same time, which no enclosure could prove.
//!
//! An isometry that maps a finite set of points onto itself fixes their
//! centroid, and that of each part of them that it maps onto itself. So all of
//! them are sought among the isometries about one point c, the centroid of the
//! smallest set of discs that agree in radius, mass and speed:
//!
//! - **Rotations.** The points of a scene are rational; unless all lie on a
//!   line through c, so is the matrix of a symmetry, and of a finite order,
//!   for some power of it maps each point onto itself. The trace 2 cos α of
//!   a matrix of finite order is an algebraic integer, and of the rational
//!   numbers only the integers are: cos α is 0, ±1/2 or ±1. With cos α = ±1/2
//!   the sine is irrational, so there are only the turns by 90, 180 and 270
//!   degrees. On a line through c there is only that by 180 degrees.
//! - **Reflections.** Any point p other than c goes to some q of the same
//!   distance, and p and q alone tell the axis: the bisector of p and q, or if
//!   the two are the same, the line through c and p. It is a rational matrix:
//!   with d = p - q it maps x to x - 2 (d·x / d·d) d. For p, a point is taken
//!   that has the fewest such q.
//!
//! Everything is computed in rationals; a symmetry that is told is one.
//!
//! Points are told apart by what no isometry about c changes: radius, mass,
//! speed, the distance from c and the product of that with the velocity. A
//! scene without symmetry usually has no two discs alike, which takes a time
//! proportional to its size to see. Where the centroid of a large set takes
//! more than [`CENTRE_BITS`] bits to write, no symmetry is told; neither is any
//! of a periodic scene, or of one in which all discs have one centre and there
//! is no wall. Bodies that coincide and are alike are interchangeable: each
//! goes to one of them.

mod index;
mod isometry;
mod points;

use crate::scene::Scene;

use index::Index;
use isometry::Isometry;
use points::Points;

pub use points::CENTRE_BITS;

/// A symmetry of a scene, by what becomes of its bodies.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Symmetry {
    /// For each disc, the disc that it is mapped onto.
    pub discs: Vec<u32>,
    /// For each wall, the wall that it is mapped onto.
    pub walls: Vec<u32>,
}

impl Symmetry {
    /// Whether it maps each body onto itself.
    pub fn is_identity(&self) -> bool {
        let fixed = |images: &[u32]| (0..).zip(images).all(|(index, image)| index == *image);
        fixed(&self.discs) && fixed(&self.walls)
    }
}

/// All symmetries of a scene but the identity: rotations first, each
/// permutation of its bodies once.
///
/// # Examples
///
/// ```
/// use carom::scene::{Disc, Scene};
/// use carom::symmetry::symmetries;
///
/// let scene = Scene::builder("a cue and two discs")
///     .disc(Disc::at([-4, 0], 1).velocity([1, 0]))
///     .disc(Disc::at([0, 1], 1))
///     .disc(Disc::at([0, -1], 1))
///     .build()?;
/// let mirror = &symmetries(&scene)[0];
/// assert_eq!(mirror.discs, [0, 2, 1]);
/// # Ok::<(), carom::scene::SceneError>(())
/// ```
pub fn symmetries(scene: &Scene) -> Vec<Symmetry> {
    if scene.periodic().is_some() {
        return Vec::new();
    }
    let Some(points) = Points::new(scene) else {
        return Vec::new();
    };
    let index = Index::new(scene);
    let mut found = Vec::new();
    for isometry in candidates(&points) {
        let symmetry = index.symmetry(&isometry);
        let symmetry = symmetry.filter(|symmetry| !symmetry.is_identity());
        found.extend(symmetry.filter(|symmetry| !found.contains(symmetry)));
    }
    found
}

/// The isometries that may be symmetries.
fn candidates(points: &Points) -> impl Iterator<Item = Isometry> + '_ {
    let rotations = (1..4).map(|quarters| Isometry::rotation(points.centre(), quarters));
    let [from, alike @ ..] = points.fewest_alike() else {
        unreachable!("a point is like itself")
    };
    // Discs in the same place are no two points.
    let others = alike.iter().filter(move |to| *to != from);
    let bisectors = others.map(move |to| Isometry::bisector(points.centre(), from, to));
    let through = Isometry::axis(points.centre(), from);
    rotations.chain([through]).chain(bisectors)
}

#[cfg(test)]
mod tests;
