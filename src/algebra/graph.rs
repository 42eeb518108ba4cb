//! Expressions in a normal form in which what is equal mostly is the same.
//!
//! Every number is a rational [`Multiple`] of a term, or rational. Terms are
//! kept once (hash-consing):
//!
//! | term | normal form |
//! |---|---|
//! | sum | whole coefficients without a common divisor, the first positive; no sums within |
//! | product | powers of different terms; of a root at most the first; no products within |
//! | root | √(f x): a whole number f without square factors (that are easily found), a term x |
//!
//! So x - y is the negative of y - x, √a √a is a, √(r² x) is r √x, and √(x²)
//! is |x| where the enclosure of x tells its sign. Two numbers of one form are
//! equal; two of different form may be equal all the same. Sums and products
//! of many parts are not opened any more, for the cost would be quadratic.

use std::cmp::Ordering::{self, Less};
use std::collections::{BTreeMap, HashMap};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::evaluate;
use super::rational::{sign_of, split_square};
use super::term::{LONGEST_RATIONAL, Multiple, NoForm, Power, Term};
use crate::scalar::{Exact, Scalar};

/// Terms, each once.
#[derive(Debug)]
pub(super) struct Graph {
    bits: u32,
    terms: Vec<Term>,
    enclosures: Vec<Exact>,
    places: HashMap<Term, usize>,
}

impl Graph {
    /// No terms, of which each will be enclosed to so many bits.
    pub(super) fn new(bits: u32) -> Self {
        Self {
            bits,
            terms: Vec::new(),
            enclosures: Vec::new(),
            places: HashMap::new(),
        }
    }

    pub(super) fn terms(&self) -> &[Term] {
        &self.terms
    }

    /// The terms that a number is made of, in their order.
    pub(super) fn needed(&self, number: &Multiple) -> Vec<usize> {
        let mut wanted = vec![false; self.terms.len()];
        if let Some(term) = number.term {
            wanted[term] = true;
        }
        for place in (0..self.terms.len()).rev() {
            if wanted[place] {
                for operand in self.terms[place].operands() {
                    wanted[operand] = true;
                }
            }
        }
        (0..self.terms.len())
            .filter(|&place| wanted[place])
            .collect()
    }

    /// The sign, where the enclosure tells it.
    pub(super) fn sign(&self, number: &Multiple) -> Option<Ordering> {
        let factor = sign_of(&number.factor);
        match number.term {
            None => Some(factor),
            Some(term) => Some(product_of_signs(factor, self.term_sign(term)?)),
        }
    }

    fn term_sign(&self, term: usize) -> Option<Ordering> {
        self.enclosures[term].sign().ok()
    }

    fn intern(&mut self, term: Term) -> usize {
        if let Some(&place) = self.places.get(&term) {
            return place;
        }
        let place = self.terms.len();
        let enclosure = evaluate::term(&term, |operand| &self.enclosures[operand], self.bits);
        self.enclosures.push(enclosure);
        self.terms.push(term.clone());
        self.places.insert(term, place);
        place
    }

    /// The sum.
    pub(super) fn add(&mut self, a: &Multiple, b: &Multiple) -> Result<Multiple, NoForm> {
        let mut constant = BigRational::zero();
        let mut parts = BTreeMap::new();
        self.collect(a, &mut constant, &mut parts);
        self.collect(b, &mut constant, &mut parts);
        parts.retain(|_, coefficient| !coefficient.is_zero());
        self.sum(constant, parts).checked()
    }

    /// Adds a number to a sum that is being made.
    fn collect(
        &self,
        number: &Multiple,
        constant: &mut BigRational,
        parts: &mut BTreeMap<usize, BigRational>,
    ) {
        let Some(term) = number.term else {
            *constant += &number.factor;
            return;
        };
        let mut add = |term: usize, coefficient: BigRational| {
            *parts.entry(term).or_default() += coefficient;
        };
        match self.terms[term].as_short_sum() {
            None => add(term, number.factor.clone()),
            Some((more, summands)) => {
                *constant += &number.factor * more;
                for (part, coefficient) in summands {
                    add(*part, &number.factor * coefficient);
                }
            }
        }
    }

    /// A sum of parts that are not zero.
    fn sum(&mut self, constant: BigRational, mut parts: BTreeMap<usize, BigRational>) -> Multiple {
        if constant.is_zero()
            && parts.len() == 1
            && let Some((term, factor)) = parts.pop_first()
        {
            return Multiple::of(factor, term);
        }
        let Some(first) = parts.values().next() else {
            return Multiple::rational(constant);
        };
        let content = content(&constant, parts.values()) * first.signum();
        // Whole by the choice of the content.
        let whole = |coefficient: BigRational| (coefficient / &content).to_integer();
        let term = Term::Sum {
            constant: whole(constant),
            parts: parts
                .into_iter()
                .map(|(term, part)| (term, whole(part)))
                .collect(),
        };
        Multiple::of(content, self.intern(term))
    }

    /// The product.
    pub(super) fn multiply(&mut self, a: &Multiple, b: &Multiple) -> Result<Multiple, NoForm> {
        let factors = [a, b]
            .into_iter()
            .filter_map(|number| Some((number.term?, 1)));
        self.product(&a.factor * &b.factor, factors.collect())
    }

    /// One divided by a number.
    pub(super) fn invert(&mut self, number: &Multiple) -> Result<Multiple, NoForm> {
        if number.is_zero() {
            return Err(NoForm::Undefined);
        }
        let factors = number.term.iter().map(|&term| (term, -1)).collect();
        self.product(number.factor.recip(), factors)
    }

    /// A rational times powers of terms.
    fn product(
        &mut self,
        mut factor: BigRational,
        mut pending: Vec<Power>,
    ) -> Result<Multiple, NoForm> {
        let mut powers: BTreeMap<usize, i64> = BTreeMap::new();
        while let Some((term, exponent)) = pending.pop() {
            if let Some(factors) = self.terms[term].as_short_product() {
                pending.extend(factors.iter().map(|(x, power)| (*x, power * exponent)));
                continue;
            }
            let power = powers.entry(term).or_default();
            *power += exponent;
            if let Term::Root { factor: f, of } = &self.terms[term] {
                let squares = power.div_euclid(2);
                *power = power.rem_euclid(2);
                factor *= power_of(f, squares)?;
                pending.extend(of.filter(|_| squares != 0).map(|of| (of, squares)));
            }
        }
        powers.retain(|_, power| *power != 0);
        self.powers(factor, powers).checked()
    }

    fn powers(&mut self, factor: BigRational, powers: BTreeMap<usize, i64>) -> Multiple {
        let powers: Vec<_> = powers.into_iter().collect();
        match powers[..] {
            _ if factor.is_zero() => Multiple::rational(factor),
            [] => Multiple::rational(factor),
            [(term, 1)] => Multiple::of(factor, term),
            _ => Multiple::of(factor, self.intern(Term::Product(powers))),
        }
    }

    /// The square root.
    pub(super) fn root(&mut self, number: &Multiple) -> Result<Multiple, NoForm> {
        if number.is_zero() {
            return Ok(number.clone());
        }
        if self.sign(number) == Some(Less) {
            return Err(NoForm::Undefined);
        }
        let (mut outside, inside, sign) = self.halve(number.term);
        let radicand = self.product(number.factor.clone(), inside)?;
        // √(n / m) = √(n m) / m.
        let denominator = radicand.factor.denom();
        let (root, factor) = split_square(&(radicand.factor.numer() * denominator));
        let scale = BigRational::new(root * sign, denominator.clone());
        if !(factor.is_one() && radicand.term.is_none()) {
            let of = radicand.term;
            outside.push((self.intern(Term::Root { factor, of }), 1));
        }
        self.product(scale, outside)
    }

    /// Splits a term into y² z with the sign of y: the powers that y has, and
    /// z.
    fn halve(&self, term: Option<usize>) -> (Vec<Power>, Vec<Power>, i32) {
        let (mut outside, mut inside, mut sign) = (Vec::new(), Vec::new(), 1);
        for (term, power) in self.factors(term) {
            let half = power.div_euclid(2);
            match self.term_sign(term) {
                Some(order) if half != 0 && order.is_ne() => {
                    outside.push((term, half));
                    inside.push((term, power.rem_euclid(2)));
                    if order == Less && half % 2 != 0 {
                        sign = -sign;
                    }
                }
                _ => inside.push((term, power)),
            }
        }
        (outside, inside, sign)
    }

    fn factors(&self, term: Option<usize>) -> Vec<Power> {
        match term.map(|term| (term, self.terms[term].as_short_product())) {
            None => Vec::new(),
            Some((term, None)) => vec![(term, 1)],
            Some((_, Some(factors))) => factors.to_vec(),
        }
    }
}

/// The positive rational that divides all of some rationals, not all of them
/// zero, so that whole numbers without a common divisor remain.
fn content<'a>(
    constant: &'a BigRational,
    parts: impl Iterator<Item = &'a BigRational>,
) -> BigRational {
    let start = (constant.numer().abs(), constant.denom().clone());
    let (divisor, multiple) = parts.fold(start, |(divisor, multiple), part| {
        (divisor.gcd(part.numer()), multiple.lcm(part.denom()))
    });
    BigRational::new(divisor, multiple)
}

fn product_of_signs(a: Ordering, b: Ordering) -> Ordering {
    match a {
        Ordering::Less => b.reverse(),
        Ordering::Equal => Ordering::Equal,
        Ordering::Greater => b,
    }
}

/// A power of a whole number that is not zero.
fn power_of(base: &BigInt, exponent: i64) -> Result<BigRational, NoForm> {
    let magnitude = exponent.unsigned_abs();
    if base.bits().saturating_mul(magnitude) > LONGEST_RATIONAL && !base.magnitude().is_one() {
        return Err(NoForm::TooLong);
    }
    // At most 2^16.
    let power = BigRational::from_integer(base.pow(magnitude as u32));
    Ok(if exponent < 0 { power.recip() } else { power })
}
