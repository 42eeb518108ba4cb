//! What acts on a disc between impacts.

use std::fmt::Debug;

use crate::body::{Disc, Wall};
use crate::scalar::{Interval, Scalar};
use crate::vec2::Vec2;

/// What acts on a disc in flight, and what holds it: by default nothing, as where
/// motion is straight.
pub trait Pull<S: Scalar>: Clone + Debug + Default + Send + Sync + 'static {
    /// That of a disc, among those of all.
    #[inline]
    fn of(pulls: &[Self], disc: usize) -> &Self {
        &pulls[disc]
    }

    /// Bounds of a disc's acceleration up to its next impact, if there is any.
    #[inline]
    fn acceleration(&self, disc: &Disc<S>) -> Option<Vec2<Interval>> {
        let _ = disc;
        None
    }

    /// The walls that hold the disc, which rests on them or slides along one.
    #[inline]
    fn holders(&self) -> [Option<usize>; 2] {
        [None; 2]
    }

    /// Whether anything holds the disc.
    fn is_held(&self) -> bool {
        self.holders() != [None; 2]
    }

    /// Whether a wall holds the disc.
    fn is_held_by(&self, wall: usize) -> bool {
        self.holders().contains(&Some(wall))
    }

    /// Whether the disc moves, by construction, at a right angle to the normal of
    /// what it touched last.
    fn skims(&self) -> bool {
        false
    }

    /// Notes that it does.
    fn skim(&mut self) {}

    /// Notes that the disc touches a wall and does not move towards it: the wall
    /// holds it if it is pulled there.
    fn rest_on(
        &mut self,
        disc: &mut Disc<S>,
        wall: usize,
        walls: &[Wall<S>],
    ) -> Result<(), S::Doubt> {
        let _ = (disc, wall, walls);
        Ok(())
    }

    /// Notes that nothing holds the disc any more.
    fn let_go(&mut self) {}

    /// Notes that the disc has slid off at the end of a wall. Tells whether it
    /// flies off, rather than fall around the end.
    fn slide_off(&mut self, disc: &Disc<S>, corner: &Vec2<S>) -> Result<bool, S::Doubt> {
        let _ = (disc, corner);
        Ok(true)
    }
}

impl<S: Scalar> Pull<S> for () {
    /// Nothing, without a look: that would be a part of what a pair costs.
    #[inline]
    fn of(_: &[()], _: usize) -> &() {
        &()
    }
}
