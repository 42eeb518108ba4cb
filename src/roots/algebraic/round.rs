//! The nearest binary64 of an algebraic number, and of a polynomial at one.

use std::cmp::Ordering::{Equal, Greater, Less};

use num_bigint::BigInt;

use super::super::chain::{FIRST_BITS, value_over};
use super::{Algebraic, enclosed};
use crate::roots::Polynomial;
use crate::scalar::{Dyadic, Interval, Rounding};

impl Algebraic {
    /// Binary64 bounds.
    pub(crate) fn hull(&self) -> Interval {
        let [low, high] = self.ends();
        Interval::new(low.to_f64(Rounding::Down), high.to_f64(Rounding::Up))
    }

    /// The nearest binary64, of two equally near ones the even one; an infinity
    /// beyond the largest.
    pub(crate) fn to_f64(&self) -> f64 {
        let [zero, one] = [0, 1].map(Dyadic::from);
        self.value_of(&Polynomial(
            [&zero, &one, &zero, &zero, &zero].map(Dyadic::clone),
        ))
    }

    /// The nearest binary64 of a polynomial at the number.
    pub(crate) fn value_of(&self, polynomial: &Polynomial<Dyadic>) -> f64 {
        // Around zero there is no narrowest pair of neighbours.
        if self.sign_of(polynomial) == Equal {
            return 0.0;
        }
        let at_zero = polynomial.shifted(&self.offset);
        let (mut sharper, mut bits) = (self.clone(), FIRST_BITS);
        loop {
            match sharper.bounds_of(&at_zero, bits) {
                // Not minus zero.
                Some([low, high]) if low == high => return low + 0.0,
                Some([low, high]) if low.next_up() == high => {
                    return sharper.nearer(polynomial, [low, high]) + 0.0;
                }
                _ => bits *= 2,
            }
        }
    }

    /// What bounds of a polynomial round to, by enclosures of so many bits.
    fn bounds_of(&mut self, polynomial: &Polynomial<Dyadic>, bits: u32) -> Option<[f64; 2]> {
        self.sharpen(bits);
        let polynomial = enclosed(polynomial, bits);
        let value = value_over(&polynomial, &polynomial.derivative(), &self.span);
        let ends = value.ends()?;
        Some(ends.map(|end| end.to_f64(Rounding::Nearest)))
    }

    /// To which of two neighbours the value of a polynomial is nearer.
    fn nearer(&self, polynomial: &Polynomial<Dyadic>, [low, high]: [f64; 2]) -> f64 {
        let mut excess = polynomial.clone();
        excess.0[0] = excess.0[0].clone().sub(&half_way(low, high));
        match self.sign_of(&excess) {
            Less => low,
            Greater => high,
            Equal if low.to_bits() & 1 == 0 => low,
            Equal => high,
        }
    }
}

/// Half way between two binary64 numbers, of which one may be infinite.
fn half_way(low: f64, high: f64) -> Dyadic {
    let [low, high] = [low, high].map(|number| match number.is_infinite() {
        true => Dyadic::new(BigInt::from(number.signum() as i32), 1024),
        false => Dyadic::from_f64(number),
    });
    low.add(&high).halved()
}
