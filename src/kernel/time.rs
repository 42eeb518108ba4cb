//! The time of a meeting, which need not be a number of the arithmetic.

use std::cmp::Ordering;
use std::fmt::Debug;

use crate::scalar::{Interval, Scalar};

/// A time at which bodies meet.
pub trait Time<S: Scalar>: Clone + Debug + Send + Sync + 'static {
    /// A time that is known as a number.
    fn at(time: S) -> Self;

    /// The time that is a delay later than another.
    fn after(since: &S, delay: S) -> Self;

    /// The order of two times.
    fn order(&self, other: &Self) -> Result<Ordering, S::Doubt>;

    /// Which comes first, this or a time that is known as a number.
    fn order_to(&self, time: &S) -> Result<Ordering, S::Doubt>;

    /// The order of this, as a delay, against what is left from `begun` to
    /// `end`.
    fn order_to_rest(&self, end: &S, begun: &S) -> Result<Ordering, S::Doubt>;

    /// Binary64 bounds.
    fn bounds(&self) -> Interval;

    /// The time as a number, rounded at most once.
    fn value(&self) -> S;

    /// The time that is this, as a delay, later than another; as a number,
    /// rounded at most once.
    fn value_after(&self, since: &S) -> S;

    /// The time, when it has come: with what several uses of it share, and lifted
    /// to `floor` where rounding alone put it before.
    #[must_use]
    fn settled(self, floor: &S) -> Self;
}

/// A number may be its own kind of time.
impl<S: Scalar> Time<S> for S {
    #[inline]
    fn at(time: S) -> Self {
        time
    }

    #[inline]
    fn after(since: &S, delay: S) -> Self {
        since.clone() + delay
    }

    #[inline]
    fn order(&self, other: &Self) -> Result<Ordering, S::Doubt> {
        self.compare(other)
    }

    #[inline]
    fn order_to(&self, time: &S) -> Result<Ordering, S::Doubt> {
        self.compare(time)
    }

    #[inline]
    fn order_to_rest(&self, end: &S, begun: &S) -> Result<Ordering, S::Doubt> {
        self.compare(&(end.clone() - begun))
    }

    #[inline]
    fn bounds(&self) -> Interval {
        self.hull()
    }

    #[inline]
    fn value(&self) -> S {
        self.clone()
    }

    #[inline]
    fn value_after(&self, since: &S) -> S {
        since.clone() + self
    }

    #[inline]
    fn settled(self, floor: &S) -> Self {
        self.not_before(floor)
    }
}
