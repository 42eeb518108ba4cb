//! Exact numbers `p + q √d` for the reference: compared and rounded by ever
//! closer bounds, with nothing of carom.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

pub(crate) fn ratio(number: f64) -> BigRational {
    BigRational::from_float(number).expect("a finite number")
}

/// `p + q √d`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Surd {
    pub(crate) p: BigRational,
    pub(crate) q: BigRational,
    pub(crate) d: BigRational,
}

impl From<BigRational> for Surd {
    fn from(p: BigRational) -> Self {
        let [q, d] = [BigRational::zero(), BigRational::zero()];
        Self { p, q, d }
    }
}

impl Surd {
    /// The number times a factor, plus a term.
    pub(crate) fn mapped(&self, factor: &BigRational, term: &BigRational) -> Self {
        Self {
            p: &self.p * factor + term,
            q: &self.q * factor,
            d: self.d.clone(),
        }
    }

    /// Bounds that are so many bits after the point apart, times q.
    fn bounds(&self, bits: u32) -> [BigRational; 2] {
        let one: BigInt = BigInt::one() << bits;
        let scaled = (self.d.numer() * &one * &one).div_floor(self.d.denom());
        let root = scaled.sqrt();
        let mut ends = [root.clone(), root + 1]
            .map(|end| &self.p + &self.q * BigRational::new(end, one.clone()));
        if self.q.is_negative() {
            ends.reverse();
        }
        ends
    }

    fn is_rational(&self) -> bool {
        self.q.is_zero() || self.d.is_zero()
    }

    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        if self.is_rational() && other.is_rational() {
            return self.p.cmp(&other.p);
        }
        if self == other {
            return Ordering::Equal;
        }
        for bits in [200, 1000, 5000] {
            let ([a, b], [c, d]) = (self.bounds(bits), other.bounds(bits));
            if b < c {
                return Ordering::Less;
            }
            if a > d {
                return Ordering::Greater;
            }
        }
        panic!("{self:?} and {other:?} are too close");
    }

    /// The same, of numbers that may be equal: with P = p - p', A = q² d and
    /// B = q'² d', for q and q' of one sign, they are only if P² + B - A is
    /// -2 P q' √d', of which the squares are compared as well.
    pub(crate) fn compare_algebraically(&self, other: &Self) -> Ordering {
        let p = &self.p - &other.p;
        let [a, b] = [self, other].map(|surd| &surd.q * &surd.q * &surd.d);
        let sum = &p * &p + &b - &a;
        let may_be_equal = &sum * &sum == BigRational::from_integer(4.into()) * &p * &p * &b;
        let [low, high] = self.bounds(5000);
        let [least, most] = other.bounds(5000);
        if may_be_equal && low <= most && high >= least {
            return Ordering::Equal;
        }
        self.compare(other)
    }

    /// The nearest binary64 number.
    pub(crate) fn rounded(&self) -> f64 {
        if self.is_rational() {
            return rounded(&self.p);
        }
        for bits in [200, 1000, 5000] {
            let [low, high] = self.bounds(bits).map(|end| rounded(&end));
            if low == high {
                return low;
            }
        }
        panic!("{self:?} is too close to the middle of two numbers");
    }
}

/// The nearest binary64 number: by way of decimal digits, which the standard
/// library rounds correctly. They are so many that for numbers above 2^-100
/// whatever is half way between two of binary64 has no more.
pub(crate) fn rounded(ratio: &BigRational) -> f64 {
    let size = ratio.denom().bits() as f64 - ratio.numer().bits() as f64;
    let places = (size * std::f64::consts::LOG10_2).ceil() as i32 + 200;
    let ten = |power: i32| BigInt::from(10).pow(power.max(0) as u32);
    let numerator = ratio.numer().abs() * ten(places);
    let (digits, rest) = numerator.div_rem(&(ratio.denom() * ten(-places)));
    let sticky = u8::from(!rest.is_zero());
    let sign = if ratio.is_negative() { "-" } else { "" };
    let text = format!("{sign}{digits}{sticky}e{}", -places - 1);
    text.parse().expect("a decimal number")
}

/// The binary64 neighbour on the side in which a number points.
pub(crate) fn rounded_towards(number: &BigRational, side: &BigRational) -> f64 {
    let nearest = rounded(number);
    let exact = ratio(nearest);
    if side.is_positive() && exact < *number {
        nearest.next_up()
    } else if side.is_negative() && exact > *number {
        nearest.next_down()
    } else {
        nearest
    }
}
