//! The order of algebraic numbers, and the signs of polynomials at them.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::super::chain::{FIRST_BITS, sign_over};
use super::super::whole::Whole;
use super::{Algebraic, enclosed, hull};
use crate::roots::Polynomial;
use crate::scalar::{Dyadic, Interval, Scalar};

impl Algebraic {
    /// The number, greater by another one.
    pub(crate) fn translated(&self, by: &Dyadic) -> Self {
        Self {
            offset: self.offset.clone().add(by).normalised(),
            ..self.clone()
        }
    }

    /// The order against a dyadic number: the zero is beyond a place in its span
    /// where f is still of the sign that it has before.
    pub(crate) fn order_to(&self, number: &Dyadic) -> Ordering {
        let place = number.clone().sub(&self.offset);
        if place.compare(&self.span.low) == Less {
            return Greater;
        }
        if place.compare(&self.span.high) == Greater {
            return Less;
        }
        match self.f.exactly_at(&place).sign() {
            Equal => Equal,
            sign if sign == self.span.before => Greater,
            _ => Less,
        }
    }

    /// The order of two numbers: by what this one is to the other one's span, and
    /// within, to the other one's polynomial.
    pub(crate) fn order(&self, other: &Self) -> Ordering {
        let ([low, high], [from, to]) = (self.ends(), other.ends());
        if high.compare(&from) == Less || self.order_to(&from) == Less {
            return Less;
        }
        if low.compare(&to) == Greater || self.order_to(&to) == Greater {
            return Greater;
        }
        match self.sign_of(&other.f.shifted(&-other.offset.clone())) {
            Equal => Equal,
            sign if sign == other.span.before => Less,
            _ => Greater,
        }
    }

    /// The sign of a polynomial at the number.
    pub(crate) fn sign_of(&self, polynomial: &Polynomial<Dyadic>) -> Ordering {
        let at_zero = polynomial.shifted(&self.offset);
        self.sign_roughly(&at_zero)
            .unwrap_or_else(|| self.sign_surely(&at_zero))
    }

    /// By binary64 bounds.
    fn sign_roughly(&self, polynomial: &Polynomial<Dyadic>) -> Option<Ordering> {
        let [low, high] = [&self.span.low, &self.span.high].map(hull);
        let zero = Interval::new(low.lo(), high.hi());
        polynomial.map(hull).at(&zero).sign().ok()
    }

    /// By enclosures, once it is ruled out that the polynomial is zero.
    fn sign_surely(&self, polynomial: &Polynomial<Dyadic>) -> Ordering {
        let (mut sharper, mut bits) = (self.clone(), FIRST_BITS);
        if let Some(sign) = sharper.sign_to(polynomial, bits) {
            return sign;
        }
        if sharper.is_zero_of(polynomial) {
            return Equal;
        }
        loop {
            bits *= 2;
            if let Some(sign) = sharper.sign_to(polynomial, bits) {
                return sign;
            }
        }
    }

    /// By enclosures of so many bits.
    fn sign_to(&mut self, polynomial: &Polynomial<Dyadic>, bits: u32) -> Option<Ordering> {
        self.sharpen(bits);
        let polynomial = enclosed(polynomial, bits);
        sign_over(&polynomial, &polynomial.derivative(), &self.span)
    }

    /// Whether a polynomial has the same zero: then so does the common divisor,
    /// which has no other one in the span, and that one simple.
    fn is_zero_of(&self, polynomial: &Polynomial<Dyadic>) -> bool {
        let common = Whole::of(&self.f)
            .common(&Whole::of(polynomial))
            .to_dyadic();
        let [low, high] =
            [&self.span.low, &self.span.high].map(|end| common.exactly_at(end).sign());
        low == Equal || low != high
    }
}

impl Polynomial<Dyadic> {
    /// The polynomial that is at t what this one is at t + `by`.
    pub(crate) fn shifted(&self, by: &Dyadic) -> Self {
        let mut coefficients = self.0.clone();
        if !by.is_zero() {
            for round in 0..4 {
                for power in (round..4).rev() {
                    let carried = coefficients[power + 1].mul(by);
                    coefficients[power] = coefficients[power].clone().add(&carried).normalised();
                }
            }
        }
        Self(coefficients)
    }
}
