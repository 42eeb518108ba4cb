//! Fields Q(√d1)(√d2)…(√dk), each a proper extension of the one before.
//!
//! A radicand is a number of the field so far of which it is proven that it
//! is no square there (see [`square`](super::square)). The products of the
//! radicals are therefore a basis over Q, and a number is zero exactly when
//! all of its coefficients are.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::element::{Coefficients, Element, add_to, content, is_zero, subtract_from, sum};
use super::evaluate::whole;
use super::limits::Limits;
use super::modular::Embedding;
use super::rational::{rational_root, split_square};
use crate::scalar::{Exact, Scalar};

/// Why a number is not found in a tower.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stop {
    /// Too many radicals, or too long coefficients.
    Budget,
    /// It is no number: a quotient by zero, or the root of a negative number.
    Undefined,
}

/// A tower of fields.
#[derive(Debug)]
pub(super) struct Tower {
    limits: Limits,
    /// d1, d2, …, whole.
    radicands: Vec<Coefficients>,
    /// Of each field, Q the first, maps into prime fields.
    pub(super) embeddings: Vec<Vec<Embedding>>,
}

/// The bits with which the sign of an element is first looked for.
const FIRST_BITS: u32 = 128;

impl Tower {
    /// Q alone.
    pub(super) fn new(limits: Limits) -> Self {
        Self {
            limits,
            radicands: Vec::new(),
            embeddings: vec![Embedding::of_rationals()],
        }
    }

    /// How many radicals there are.
    pub(super) fn height(&self) -> usize {
        self.radicands.len()
    }

    /// The radicand of the radical after the first `level`.
    pub(super) fn radicand(&self, level: usize) -> Element {
        Element {
            numerator: self.radicands[level].clone(),
            denominator: BigInt::one(),
        }
    }

    /// The same number, if it is short enough to go on with.
    pub(super) fn within(&self, element: Element) -> Result<Element, Stop> {
        if element.bits() > self.limits.element_bits {
            return Err(Stop::Budget);
        }
        Ok(element)
    }

    pub(super) fn add(&self, a: &Element, b: &Element) -> Result<Element, Stop> {
        self.within(a.add(b))
    }

    pub(super) fn mul(&self, a: &Element, b: &Element) -> Result<Element, Stop> {
        let numerator = self.product(&a.numerator, &b.numerator);
        self.within(Element::new(numerator, &a.denominator * &b.denominator))
    }

    /// (a0 + a1√d) (b0 + b1√d) = a0 b0 + d a1 b1 + (a0 b1 + a1 b0)√d, as deep
    /// as there are radicals.
    fn product(&self, a: &[BigInt], b: &[BigInt]) -> Coefficients {
        if a.len() < b.len() {
            return self.product(b, a);
        }
        if is_zero(a) || is_zero(b) {
            return vec![BigInt::zero()];
        }
        let half = a.len() / 2;
        if half == 0 {
            return vec![&a[0] * &b[0]];
        }
        let (a0, a1) = a.split_at(half);
        if b.len() <= half {
            return join(self.product(a0, b), self.product(a1, b), half);
        }
        let (b0, b1) = b.split_at(half);
        let outer = self.product(a1, b1);
        let mut low = self.product(a0, b0);
        let high = self.mixed_product([a0, a1], [b0, b1], [&low, &outer]);
        let radicand = &self.radicands[half.trailing_zeros() as usize];
        add_to(&mut low, &self.product(&outer, radicand));
        join(low, high, half)
    }

    /// a0 b1 + a1 b0, given a0 b0 and a1 b1: one product as long as none is
    /// zero, by Karatsuba's (a0 + a1) (b0 + b1) - a0 b0 - a1 b1.
    fn mixed_product(
        &self,
        [a0, a1]: [&[BigInt]; 2],
        [b0, b1]: [&[BigInt]; 2],
        known: [&Coefficients; 2],
    ) -> Coefficients {
        if known.iter().any(|product| is_zero(product)) {
            let mut sum = self.product(a0, b1);
            add_to(&mut sum, &self.product(a1, b0));
            return sum;
        }
        let mut mixed = self.product(&sum(a0, a1), &sum(b0, b1));
        for product in known {
            subtract_from(&mut mixed, product);
        }
        mixed
    }

    /// a² - b² d for a + b√d: the product with its conjugate.
    pub(super) fn norm(&self, a: &Element, b: &Element, level: usize) -> Result<Element, Stop> {
        let square = self.mul(b, b)?;
        let scaled = self.mul(&square, &self.radicand(level))?;
        self.within(self.mul(a, a)?.sub(&scaled))
    }

    /// One divided by a number: its conjugate by its norm, which is one
    /// radical lower.
    pub(super) fn inverse(&self, x: &Element) -> Result<Element, Stop> {
        if x.is_zero() {
            return Err(Stop::Undefined);
        }
        let Some(level) = x.level().checked_sub(1) else {
            return Ok(Element::new(
                vec![x.denominator.clone()],
                x.numerator[0].clone(),
            ));
        };
        let (a, b) = x.split(level);
        let norm = self.inverse(&self.norm(&a, &b, level)?)?;
        self.mul(&a.sub(&b.times_radical(level)), &norm)
    }

    pub(super) fn power(&self, base: &Element, exponent: i64) -> Result<Element, Stop> {
        let mut square = match exponent {
            ..0 => self.inverse(base)?,
            _ => base.clone(),
        };
        let mut result = Element::whole(BigInt::one());
        let mut rest = exponent.unsigned_abs();
        while rest > 0 {
            if rest % 2 == 1 {
                result = self.mul(&result, &square)?;
            }
            rest /= 2;
            if rest > 0 {
                square = self.mul(&square, &square)?;
            }
        }
        Ok(result)
    }

    /// The square root of a number: one of the field, or where there is none
    /// a new radical.
    pub(super) fn root(&mut self, x: &Element) -> Result<Element, Stop> {
        match self.sign(x)? {
            Ordering::Less => return Err(Stop::Undefined),
            Ordering::Equal => return Ok(x.clone()),
            Ordering::Greater => {}
        }
        if let Some(root) = self.known_radical(x) {
            return Ok(root);
        }
        let Some(root) = self.square_root(x)? else {
            return self.adjoin(x);
        };
        Ok(match self.sign(&root)? {
            Ordering::Less => root.negated(),
            _ => root,
        })
    }

    /// The root of a positive number that is a rational square times a
    /// radicand: the same impact seen twice has the same one.
    fn known_radical(&self, x: &Element) -> Option<Element> {
        (0..self.height()).find_map(|level| {
            let ratio = ratio_of(x, &self.radicands[level])?;
            let radical = Element::whole(BigInt::one()).times_radical(level);
            Some(radical.scaled(&rational_root(&ratio)?))
        })
    }

    /// The root of a positive number that is not a square in the field, as a
    /// new radical: √(v / m) = √(v m) / m, less the squares that divide v m.
    fn adjoin(&mut self, x: &Element) -> Result<Element, Stop> {
        let level = self.height();
        let most = self.limits.radicals.min(Limits::MOST_RADICALS);
        if level >= most as usize {
            return Err(Stop::Budget);
        }
        let divisor = content(&x.numerator, BigInt::zero());
        let (root, free) = split_square(&(&divisor * &x.denominator));
        let radicand: Coefficients = x.numerator.iter().map(|n| n / &divisor * &free).collect();
        self.embeddings
            .push(Embedding::extend(&self.embeddings[level], &radicand));
        self.radicands.push(radicand);
        let radical = Element::whole(BigInt::one()).times_radical(level);
        Ok(radical.scaled(&BigRational::new(root, x.denominator.clone())))
    }

    /// The sign, from enclosures of growing precision: that a number is zero
    /// is known beforehand.
    pub(super) fn sign(&self, x: &Element) -> Result<Ordering, Stop> {
        if x.is_zero() {
            return Ok(Ordering::Equal);
        }
        let mut bits = FIRST_BITS;
        while bits <= self.limits.bound_bits.max(FIRST_BITS) {
            if let Ok(sign) = self.enclose(x, bits).sign() {
                return Ok(sign);
            }
            bits *= 2;
        }
        Err(Stop::Budget)
    }

    /// Encloses the numerator, which has the sign of the number.
    fn enclose(&self, x: &Element, bits: u32) -> Exact {
        let mut roots: Vec<Exact> = Vec::new();
        for radicand in &self.radicands[..x.level()] {
            roots.push(evaluate(radicand, &roots, bits).sqrt());
        }
        evaluate(&x.numerator, &roots, bits)
    }
}

fn evaluate(coefficients: &[BigInt], roots: &[Exact], bits: u32) -> Exact {
    if let [number] = coefficients {
        return whole(number, bits);
    }
    let (low, high) = coefficients.split_at(coefficients.len() / 2);
    let root = &roots[low.len().trailing_zeros() as usize];
    evaluate(low, roots, bits) + evaluate(high, roots, bits) * root
}

/// The rational that a number not zero is of another one, if it is one.
fn ratio_of(x: &Element, other: &[BigInt]) -> Option<BigRational> {
    let place = x.numerator.iter().position(|n| !n.is_zero())?;
    let (n, m) = (&x.numerator[place], other.get(place)?);
    let proportional = |(a, b): (&BigInt, &BigInt)| a * m == b * n;
    let same = x.numerator.len() == other.len()
        && !m.is_zero()
        && x.numerator.iter().zip(other).all(proportional);
    same.then(|| BigRational::new(n.clone(), m * &x.denominator))
}

/// low + high√d, where √d has `half` coefficients below.
fn join(mut low: Coefficients, high: Coefficients, half: usize) -> Coefficients {
    low.resize(half, BigInt::zero());
    low.extend(high);
    low.resize(2 * half, BigInt::zero());
    low
}
