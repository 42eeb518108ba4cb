//! Discs on their way, from where and when they are known.

use super::Kernel;
use crate::body::Disc;
use crate::vec2::Vec2;

/// A disc, and the time at which it is where it says.
#[derive(Debug)]
pub struct Flight<'a, S: Kernel> {
    /// The disc.
    pub disc: &'a Disc<S>,
    /// The time.
    pub since: &'a S,
    /// What pulls it.
    pub pull: &'a S::Pull,
}

impl<S: Kernel> Clone for Flight<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Kernel> Copy for Flight<'_, S> {}

/// Two discs in flight.
#[derive(Debug)]
pub struct Approach<'a, S: Kernel> {
    /// The disc that is known since the earlier time.
    pub early: Flight<'a, S>,
    /// The disc that is known since the later one.
    pub late: Flight<'a, S>,
    /// Whether the two times are known to be one.
    pub together: bool,
}

impl<S: Kernel> Approach<'_, S> {
    /// Where the later disc is, seen from the earlier one, at the later time.
    #[inline]
    pub fn offset(&self) -> Vec2<S> {
        let (early, late) = (self.early.disc, self.late.disc);
        if self.together {
            return late.position.minus(&early.position);
        }
        let start = S::position_after(self.early, &self.wait());
        late.position.minus(&start)
    }

    /// How fast the later disc moves, seen from the earlier one, at the later
    /// time.
    #[inline]
    pub fn velocity(&self) -> Vec2<S> {
        let (early, late) = (self.early.disc, self.late.disc);
        if self.together || S::IS_STRAIGHT {
            return late.velocity.minus(&early.velocity);
        }
        let start = S::velocity_after(self.early, &self.wait());
        late.velocity.minus(&start)
    }

    fn wait(&self) -> S {
        self.late.since.clone() - self.early.since
    }

    /// The sum of the radii.
    #[inline]
    pub fn reach(&self) -> S {
        self.early.disc.radius.clone() + &self.late.disc.radius
    }
}
