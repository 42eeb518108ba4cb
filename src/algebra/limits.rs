//! How far a proof may go before the question is left open.

/// The budget of one decision.
///
/// A number carries the limits that it was made with; a result, the greater
/// of each that its operands carry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The bits of the enclosure that every number carries, which decides
    /// nearly all signs.
    pub bits: u32,
    /// The most bits that the separation bound may ask for.
    pub bound_bits: u32,
    /// The most radicals that a tower of fields is built from, up to
    /// [`MOST_RADICALS`](Self::MOST_RADICALS).
    pub radicals: u32,
    /// The most bits of an element of the tower, all its coefficients
    /// together. All elements together may have
    /// [`ELEMENTS`](Self::ELEMENTS) times as many.
    pub element_bits: u64,
    /// The most terms times bits that one evaluation may take.
    pub work: u64,
}

impl Limits {
    /// An element of a tower of n radicals has 2^n coefficients.
    pub const MOST_RADICALS: u32 = 12;

    /// How many elements of the greatest length a tower may take.
    pub const ELEMENTS: u64 = 64;

    /// Those of a number that comes without any: what it meets decides.
    pub(super) const NONE: Self = Self {
        bits: 0,
        bound_bits: 0,
        radicals: 0,
        element_bits: 0,
        work: 0,
    };

    /// Those of a question that enclosures of so many bits have left open: the
    /// more bits have been spent on it, the more effort is worth while. From
    /// 8192 bits on, the usual ones.
    pub fn after(bits: u32) -> Self {
        let usual = Self::default();
        let scale = (bits / 128).max(1);
        Self {
            bits: usual.bits,
            bound_bits: usual.bound_bits.min(scale << 11),
            radicals: usual.radicals.min(4 + scale.ilog2()),
            element_bits: usual.element_bits.min(u64::from(scale) << 17),
            work: usual.work.min(u64::from(scale) << 21),
        }
    }

    /// The greater of each.
    pub(super) fn joined(self, other: Self) -> Self {
        Self {
            bits: self.bits.max(other.bits),
            bound_bits: self.bound_bits.max(other.bound_bits),
            radicals: self.radicals.max(other.radicals),
            element_bits: self.element_bits.max(other.element_bits),
            work: self.work.max(other.work),
        }
    }

    /// These, or where no operand came with any, the usual ones.
    pub(super) fn or_default(self) -> Self {
        if self == Self::NONE {
            Self::default()
        } else {
            self
        }
    }
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            bits: 256,
            bound_bits: 1 << 17,
            radicals: 8,
            element_bits: 1 << 23,
            work: 1 << 27,
        }
    }
}
