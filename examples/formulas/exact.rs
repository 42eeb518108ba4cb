//! When a point meets a circle, in fractions: nothing of it is shared with
//! what it is compared with.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

/// A point at `offset` from the centre of a circle, not within it, that moves
/// at `velocity`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Query {
    /// Where the point is.
    pub(crate) offset: [f64; 2],
    /// Where it moves in a unit of time.
    pub(crate) velocity: [f64; 2],
    /// The radius of the circle.
    pub(crate) reach: f64,
}

/// The exact answer to a query.
pub(crate) struct Truth {
    /// When the point meets the circle, to more than 200 bits, if it does: in
    /// more than a tangent pass.
    pub(crate) time: Option<BigRational>,
    /// δ = D / (v·v R²) with the discriminant D: 0 in tangency, 1 head-on.
    pub(crate) discriminant: BigRational,
    /// (d·d - R²) / (d·d + R²): 0 in contact, 1 far away.
    pub(crate) gap: BigRational,
}

/// Bits after the binary point of a root's square.
const BITS: u32 = 512;

impl Query {
    /// The answer, from (v·v) t² + 2 (d·v) t + c = 0.
    pub(crate) fn solve(&self) -> Truth {
        let [[x, y], [u, v]] = [self.offset, self.velocity].map(|vector| vector.map(fraction));
        let reach = fraction(self.reach);
        let approach = &x * &u + &y * &v;
        let speed_squared = &u * &u + &v * &v;
        let moment = &x * &v - &y * &u;
        let scale = &speed_squared * &reach * &reach;
        let discriminant = &scale - &moment * &moment;
        let [distance, reach] = [&x * &x + &y * &y, &reach * &reach];
        let gap = &distance - &reach;
        let meets = approach.is_negative() && discriminant.is_positive();
        Truth {
            time: meets.then(|| &gap / (root(&discriminant) - &approach)),
            discriminant: if scale.is_zero() {
                scale
            } else {
                discriminant / scale
            },
            gap: gap / (distance + reach),
        }
    }
}

impl Truth {
    /// How far a computed time is from the true one.
    pub(crate) fn error(&self, computed: f64) -> Option<BigRational> {
        let time = self.time.as_ref()?;
        Some((fraction(computed) - time).abs())
    }

    /// The same in ulps of the true time: there are none below 2^-1000.
    pub(crate) fn ulps(&self, computed: f64) -> Option<f64> {
        let size = self.time.as_ref()?.to_f64()?.max(1000_f64.exp2().recip());
        let ulp = fraction(size.next_up() - size);
        (self.error(computed)? / ulp).to_f64()
    }
}

/// A binary64 number as a fraction; what is none counts as zero.
pub(crate) fn fraction(number: f64) -> BigRational {
    BigRational::from_float(number).unwrap_or_default()
}

/// The square root of a positive number, rounded down.
pub(crate) fn root(square: &BigRational) -> BigRational {
    let scaled = (square.numer() * square.denom()) << BITS;
    BigRational::new(
        scaled.sqrt(),
        square.denom() * (BigInt::from(1) << (BITS / 2)),
    )
}
