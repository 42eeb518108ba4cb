//! When a point meets a circle, in whole numbers: nothing of it is shared with
//! what it is compared with.
//!
//! Lengths are taken in units of one power of two and velocities in units of
//! another, so that all are whole. With a = v·v, b = d·v and c = d·d - R² and
//! D = (v·v) R² - (d × v)², whose signs are the verdict, the point meets the
//! circle at the smaller root of f(t) = a t² + 2 b t + c.
//!
//! A computed time t is judged by what f leaves of it. With w = a t + b we have
//! a f(t) = w² - D, so its error is
//!
//! ```text
//! t - (-b - √D) / a = (w + √D) / a = f(t) / (w - √D)
//! ```
//!
//! A computed time is a whole number over a power of two, so w and f(t) are exact
//! as well. Nothing cancels in the last form where w is negative, nor in the one
//! before where it is not: binary64 tells the *error* to some 2^-50 of itself, be
//! it as small as it may. What does not fit into 512 bits is left to fractions.

use num_traits::ToPrimitive;

use crate::exact::Query;
use crate::wide::Wide;

/// Bits that a length or a velocity may have, so that D has less than 508.
const BITS: i32 = 126;

/// Bits that the numerator and denominator of a time may have, so that f(t) has
/// less than 511.
const TIME_BITS: i32 = 128;

/// The largest power of two that may be the unit of time, or one over it.
const UNIT: i32 = 400;

/// The exact answer to a query.
pub(crate) struct Truth<'a> {
    query: &'a Query,
    /// Unless a number is too long.
    course: Option<Course>,
}

/// The gap as it changes: a t² + 2 b t + c.
struct Course {
    a: Wide,
    b: Wide,
    c: Wide,
    discriminant: Wide,
    reach_squared: Wide,
    /// Time is in units of this power of two.
    unit: i32,
}

impl<'a> Truth<'a> {
    pub(crate) fn of(query: &'a Query) -> Self {
        let course = Course::of(query);
        Self { query, course }
    }

    /// Whether the point meets the circle: in more than a tangent pass.
    pub(crate) fn meets(&self) -> bool {
        match &self.course {
            Some(course) => course.meets(),
            None => self.query.solve().time.is_some(),
        }
    }

    /// δ = D / (v·v R²): 0 in tangency, 1 head-on.
    pub(crate) fn tangency(&self) -> f64 {
        match &self.course {
            Some(course) => course.tangency(),
            None => self.query.solve().discriminant.to_f64().unwrap_or_default(),
        }
    }

    /// (d·d - R²) / (d·d + R²): 0 in contact, 1 far away.
    pub(crate) fn gap(&self) -> f64 {
        match &self.course {
            Some(course) => course.gap(),
            None => self.query.solve().gap.to_f64().unwrap_or_default(),
        }
    }

    /// How far a computed time is from the true one, in ulps of that: there are
    /// none below 2^-1000.
    pub(crate) fn ulps(&self, computed: f64) -> Option<f64> {
        if !self.meets() {
            return None;
        }
        let whole = self.course.as_ref();
        let whole = whole.and_then(|course| course.ulps(computed));
        whole.or_else(|| self.query.solve().ulps(computed))
    }
}

impl Course {
    fn of(query: &Query) -> Option<Self> {
        let ([x, y], [u, v]) = (query.offset, query.velocity);
        let ([x, y, reach], length) = whole([x, y, query.reach])?;
        let ([u, v], speed) = whole([u, v])?;
        let unit = length - speed;
        let a = u.square() + v.square();
        let reach_squared = reach.square();
        let course = Self {
            a,
            b: x * u + y * v,
            c: x.square() + y.square() - reach_squared,
            discriminant: a * reach_squared - (x * v - y * u).square(),
            reach_squared,
            unit,
        };
        (unit.abs() <= UNIT).then_some(course)
    }

    fn meets(&self) -> bool {
        self.b.is_negative() && self.discriminant.is_positive()
    }

    fn tangency(&self) -> f64 {
        let scale = self.a.to_f64() * self.reach_squared.to_f64();
        if scale == 0.0 {
            return 0.0;
        }
        self.discriminant.to_f64() / scale
    }

    fn gap(&self) -> f64 {
        let gap = self.c.to_f64();
        gap / (gap + 2.0 * self.reach_squared.to_f64())
    }

    /// The root of the discriminant.
    fn root(&self) -> f64 {
        self.discriminant.to_f64().sqrt()
    }

    fn ulps(&self, computed: f64) -> Option<f64> {
        let unit = f64::from(self.unit).exp2();
        let time = self.c.to_f64() / (self.root() - self.b.to_f64()) * unit;
        let size = time.max((-1000_f64).exp2());
        let ulp = size.next_up() - size;
        Some(self.error(computed)?.abs() * unit / ulp)
    }

    /// With t = m 2^-s in units of time, from w 2^s and f(t) 2^2s.
    fn error(&self, computed: f64) -> Option<f64> {
        let (mantissa, power) = parts(computed);
        let shift = power - self.unit;
        let finer = u32::try_from(-shift).unwrap_or(0);
        let m = shifted(mantissa, shift.max(0), TIME_BITS)?;
        if finer > TIME_BITS as u32 {
            return None;
        }
        let slope = self.b << finer;
        let w = self.a * m + slope;
        let left = (w + slope) * m + (self.c << (2 * finer));
        let scale = (-f64::from(finer)).exp2();
        let root = self.root();
        let slope = w.to_f64() * scale;
        Some(if w.is_negative() {
            left.to_f64() * scale * scale / (slope - root)
        } else {
            (slope + root) / self.a.to_f64()
        })
    }
}

/// Numbers in units of a power of two, and that power.
fn whole<const N: usize>(numbers: [f64; N]) -> Option<([Wide; N], i32)> {
    let parts = numbers.map(parts);
    let powers = parts.iter().filter(|part| part.0 != 0).map(|part| part.1);
    let unit = powers.min().unwrap_or(0);
    let mut whole = [Wide::from(0); N];
    for (whole, (mantissa, power)) in whole.iter_mut().zip(parts) {
        *whole = shifted(mantissa, power - unit, BITS)?;
    }
    Some((whole, unit))
}

/// The whole number m 2^s, if that has few bits.
fn shifted(mantissa: i64, shift: i32, bits: i32) -> Option<Wide> {
    let length = 64 - mantissa.unsigned_abs().leading_zeros();
    let fits = mantissa == 0 || length as i32 + shift <= bits;
    fits.then(|| Wide::from(i128::from(mantissa)) << shift.max(0) as u32)
}

/// A finite number as m 2^k with an odd m, or as zero.
fn parts(number: f64) -> (i64, i32) {
    let bits = number.to_bits();
    let exponent = (bits >> 52 & 0x7ff) as i32;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let leading = i64::from(exponent != 0) << 52;
    let size = fraction | leading;
    if size == 0 {
        return (0, 0);
    }
    let zeros = size.trailing_zeros();
    let mantissa = (size >> zeros) * if number < 0.0 { -1 } else { 1 };
    (mantissa, exponent.max(1) - 1075 + zeros as i32)
}

#[cfg(test)]
mod tests {
    use rand::{Rng, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::FORMULAS;
    use crate::queries::KINDS;

    const COUNT: usize = 300;

    fn is_near(a: f64, b: f64) -> bool {
        a == b || (a - b).abs() <= 1e-12 * b.abs()
    }

    /// The times that the formulas find, and others as close or as far as may be.
    fn times(query: &Query, random: &mut ChaCha8Rng) -> Vec<f64> {
        let found = FORMULAS.iter().filter_map(|formula| (formula.solve)(query));
        let mut times: Vec<_> = found.collect();
        let time = times.first().copied().unwrap_or(1.0);
        let power = random.random_range(-60.0_f64..10.0);
        let near = time * (1.0 + power.exp2());
        times.extend([0.0, 1.0, -time, time.next_up(), near, 1e300, 1e-300]);
        times
    }

    fn check(query: &Query, random: &mut ChaCha8Rng) {
        let (truth, fraction) = (Truth::of(query), query.solve());
        assert_eq!(truth.meets(), fraction.time.is_some(), "{query:?}");
        for (found, exact) in [
            (truth.tangency(), &fraction.discriminant),
            (truth.gap(), &fraction.gap),
        ] {
            let exact = exact.to_f64().expect("a finite number");
            assert!(is_near(found, exact), "{query:?}: {found}, {exact}");
        }
        for time in times(query, random) {
            let [found, exact] = [truth.ulps(time), fraction.ulps(time)];
            assert_eq!(found.is_some(), exact.is_some(), "{query:?}");
            let agrees = found
                .zip(exact)
                .is_none_or(|(found, exact)| is_near(found, exact));
            assert!(agrees, "{query:?} at {time}: {found:?}, {exact:?}");
        }
    }

    #[test]
    fn agrees_with_fractions() {
        let mut random = ChaCha8Rng::seed_from_u64(2);
        for kind in &KINDS {
            for _ in 0..COUNT {
                let query = (kind.make)(&mut random);
                assert!(Course::of(&query).is_some(), "{query:?}");
                check(&query, &mut random);
            }
        }
    }

    /// Whole numbers and powers of two of any size, so that much is equal, and
    /// some of it too long.
    #[test]
    fn agrees_on_a_lattice() {
        let mut random = ChaCha8Rng::seed_from_u64(3);
        for _ in 0..COUNT {
            let scales = [0; 2].map(|_| f64::from(random.random_range(-140..=140)).exp2());
            let mut number = |scale: f64| f64::from(random.random_range(-6_i8..=6)) * scale;
            let query = Query {
                offset: [number(1.0), number(scales[0])],
                velocity: [number(1.0), number(scales[1])],
                reach: number(1.0).abs() + 1.0,
            };
            check(&query, &mut random);
        }
    }

    /// A 3-4-5 triangle: from (7, 3), the circle of radius 5 is met at (4, 3).
    #[test]
    fn judges_a_time_in_ulps() {
        let query = Query {
            offset: [7.0, 3.0],
            velocity: [-1.0, 0.0],
            reach: 5.0,
        };
        let truth = Truth::of(&query);
        assert_eq!(truth.ulps(3.0), Some(0.0));
        assert_eq!(truth.ulps(3_f64.next_up()), Some(1.0));
        assert_eq!(truth.ulps(3_f64.next_down()), Some(1.0));
        assert_eq!(truth.ulps(11.0), Some(8.0 * 2_f64.powi(51)));
    }
}
