//! From the normal form into a tower that grows with it.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::element::Element;
use super::graph::Graph;
use super::limits::Limits;
use super::term::{Multiple, Term};
use super::tower::{Stop, Tower};

/// The terms of a graph as elements of one tower.
pub(super) struct Ascent {
    pub(super) tower: Tower,
    elements: Vec<Option<Element>>,
}

impl Ascent {
    /// Takes the terms into a tower, one after the other, until one does not
    /// fit; tells why it stopped.
    pub(super) fn of(graph: &Graph, needed: &[usize], limits: Limits) -> (Self, Result<(), Stop>) {
        let mut ascent = Self {
            tower: Tower::new(limits),
            elements: vec![None; graph.terms().len()],
        };
        let most = limits.element_bits.saturating_mul(Limits::ELEMENTS);
        let mut bits = 0;
        let end = needed.iter().try_for_each(|&place| {
            let element = ascent.climb(&graph.terms()[place])?;
            bits += element.bits();
            ascent.elements[place] = Some(element);
            if bits > most {
                Err(Stop::Budget)
            } else {
                Ok(())
            }
        });
        (ascent, end)
    }

    /// The element that a number is a multiple of, if its term was reached.
    fn term(&self, number: &Multiple) -> Option<&Element> {
        self.elements[number.term?].as_ref()
    }

    /// Whether a number is zero, if its term was reached.
    pub(super) fn is_zero(&self, number: &Multiple) -> Option<bool> {
        match number.term {
            None => Some(number.is_zero()),
            Some(_) => self.term(number).map(Element::is_zero),
        }
    }

    /// The rational that a number of a term is, where the tower shows it.
    pub(super) fn rational(&self, number: &Multiple) -> Option<BigRational> {
        let value = self.term(number)?.to_rational()?;
        Some(value * &number.factor)
    }

    fn climb(&mut self, term: &Term) -> Result<Element, Stop> {
        match term {
            Term::Sum { constant, parts } => self.sum(constant, parts),
            Term::Product(factors) => self.product(factors),
            Term::Root { factor, of } => {
                let radicand = self.multiple(factor, *of)?;
                self.tower.root(&radicand)
            }
        }
    }

    fn sum(&self, constant: &BigInt, parts: &[(usize, BigInt)]) -> Result<Element, Stop> {
        let mut sum = Element::whole(constant.clone());
        for (part, coefficient) in parts {
            let part = self.multiple(coefficient, Some(*part))?;
            sum = self.tower.add(&sum, &part)?;
        }
        Ok(sum)
    }

    fn product(&self, factors: &[(usize, i64)]) -> Result<Element, Stop> {
        let mut product = Element::whole(BigInt::from(1));
        for (factor, exponent) in factors {
            let factor = self.reached(*factor)?;
            let power = self.tower.power(factor, *exponent)?;
            product = self.tower.mul(&product, &power)?;
        }
        Ok(product)
    }

    fn multiple(&self, factor: &BigInt, term: Option<usize>) -> Result<Element, Stop> {
        let factor = factor.clone();
        match term {
            None => Ok(Element::whole(factor)),
            Some(term) => Ok(self.reached(term)?.scaled(&factor.into())),
        }
    }

    /// An earlier term.
    fn reached(&self, term: usize) -> Result<&Element, Stop> {
        self.elements[term].as_ref().ok_or(Stop::Budget)
    }
}
