//! Boxes with sides along the axes.

/// All points that are, in both coordinates, between two ends, these included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Area {
    pub(super) lo: [f64; 2],
    pub(super) hi: [f64; 2],
}

impl Area {
    /// The whole plane.
    pub(crate) const WHOLE: Self = Self {
        lo: [f64::NEG_INFINITY; 2],
        hi: [f64::INFINITY; 2],
    };

    /// The points from `lo` to `hi`, which must not be below `lo`; the whole plane
    /// if one of these numbers is not finite.
    pub(crate) fn new(lo: [f64; 2], hi: [f64; 2]) -> Self {
        let ends = [lo, hi];
        if ends.as_flattened().iter().all(|end| end.is_finite()) {
            Self { lo, hi }
        } else {
            Self::WHOLE
        }
    }

    /// Whether it is not the whole plane.
    pub(super) fn is_bounded(&self) -> bool {
        self.hi[0] < f64::INFINITY
    }

    /// Whether there is a point in both.
    // As likely as not each: quicker without branches.
    #[inline]
    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        (self.lo[0] <= other.hi[0])
            & (other.lo[0] <= self.hi[0])
            & (self.lo[1] <= other.hi[1])
            & (other.lo[1] <= self.hi[1])
    }

    /// About the middle, along an axis.
    pub(super) fn middle(&self, axis: usize) -> f64 {
        self.lo[axis] / 2.0 + self.hi[axis] / 2.0
    }

    /// About the mean of width and height, or the largest number.
    pub(super) fn size(&self) -> f64 {
        let half = |axis: usize| self.hi[axis] / 2.0 - self.lo[axis] / 2.0;
        (half(0) + half(1)).min(f64::MAX)
    }
}
