//! From the normal form into a tower that grows with it.

use num_bigint::BigInt;

use super::element::Element;
use super::graph::{Graph, Multiple, Term};
use super::limits::Limits;
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
        let end = needed.iter().try_for_each(|&place| {
            let element = ascent.climb(&graph.terms()[place])?;
            ascent.elements[place] = Some(element);
            Ok(())
        });
        (ascent, end)
    }

    /// The element that a number is, if its term was reached.
    pub(super) fn element(&self, number: &Multiple) -> Option<Element> {
        match number.term {
            None => Some(Element::rational(&number.factor)),
            Some(term) => Some(self.elements[term].as_ref()?.scaled(&number.factor)),
        }
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
