//! A whole computation in mean-value form.
//!
//! For x within X about the midpoint m, f(x) lies in f(m) + J (x - m), where J
//! bounds the derivatives of f over X (Moore: Methods and Applications of
//! Interval Analysis, 1979). f(m) is computed in balls with as many bits as
//! are of use, J in binary64 intervals, so that it knows the derivatives to a
//! relative error of some 2^-50; this error times the extent of X, the
//! roundings of f(m), and J times the rests of the inputs make up the rest of
//! the output.
//!
//! Decisions on the way are those of J, valid for all of X.

use std::cell::{Cell, RefCell};
use std::sync::Arc;

use super::{Basis, Form, GUARD, LEAST_BITS, UNDERFLOW};
use crate::scalar::dyadic::Dyadic;
use crate::scalar::gradient::Gradient;
use crate::scalar::radius::Radius;
use crate::scalar::rounding::power_of_two;
use crate::scalar::step::Step;
use crate::scalar::{Exact, Interval, Scalar};

/// Sums of so many products as there are variables round by less than this
/// part of the sum of their magnitudes.
const ROUNDING: i64 = -48;

/// The output of a step with forms; none where that does not pay, or where
/// binary64 bounds do not decide what has to be.
pub(in crate::scalar) fn step<P: Step>(input: &P::Input<Exact>) -> Option<P::Output<Exact>> {
    let variables = Variables::of::<P>(input)?;
    let slopes = variables.slopes::<P>(input)?;
    let middle = P::apply(&variables.middle::<P>(input)).ok()??;
    let (next, failed) = (Cell::new(0), Cell::new(false));
    let output = P::map_output(&middle, |value| {
        let slope = &slopes[next.replace(next.get() + 1)];
        variables.compose(value, slope).unwrap_or_else(|| {
            failed.set(true);
            value.clone()
        })
    });
    (!failed.get()).then_some(output)
}

/// The inputs that are not known exactly, as far as there is room for them.
struct Variables {
    forms: Vec<Arc<Form>>,
    /// The basis and the unit of the forms that have symbols.
    basis: Option<Basis>,
    exponent: i64,
    /// The bits that the input carries, and those worth computing with.
    bits: [u32; 2],
}

impl Variables {
    fn of<P: Step>(input: &P::Input<Exact>) -> Option<Self> {
        let (forms, bits) = (RefCell::new(Vec::new()), Cell::new((0, 0)));
        P::map_input(input, |number| {
            let (most, useful) = bits.get();
            let useful = if is_variable(number, forms.borrow().len()) {
                forms.borrow_mut().push(number.error());
                useful.max(number.accuracy().unwrap_or(0))
            } else {
                useful
            };
            bits.set((most.max(number.bits), useful));
        });
        let (most, useful) = bits.get();
        let worthwhile = most >= LEAST_BITS && !forms.borrow().is_empty();
        let useful = most.min((useful + 2 * GUARD) as u32);
        worthwhile.then(|| Self::new(forms.into_inner(), [most, useful]))
    }

    /// Symbols of another basis than the first one's are of no use, nor are
    /// terms far smaller than others.
    fn new(mut forms: Vec<Arc<Form>>, bits: [u32; 2]) -> Self {
        let basis = forms.iter().find_map(|form| form.basis.clone());
        let is_common = |form: &Form| match (&form.basis, &basis) {
            (Some(own), Some(common)) => own.is(common),
            _ => false,
        };
        let common = forms.iter().filter(|form| is_common(form));
        let exponent = common.map(|form| form.exponent).max().unwrap_or(0);
        for form in &mut forms {
            if !is_common(form) || form.exponent - exponent < UNDERFLOW {
                *form = Arc::new(Form::unknown(form.total()));
            }
        }
        Self {
            forms,
            basis,
            exponent,
            bits,
        }
    }

    /// Maps an input, telling which variable a number is.
    fn map<P: Step, T>(
        &self,
        input: &P::Input<Exact>,
        make: impl Fn(&Exact, Option<usize>) -> T,
    ) -> P::Input<T> {
        let next = Cell::new(0);
        P::map_input(input, |number| {
            let index = next.get();
            if !is_variable(number, index) {
                return make(number, None);
            }
            next.set(index + 1);
            make(number, Some(index))
        })
    }

    /// Bounds of all derivatives.
    fn slopes<P: Step>(&self, input: &P::Input<Exact>) -> Option<Vec<Gradient>> {
        let input = self.map::<P, _>(input, |number, index| match index {
            Some(index) => Gradient::variable(number.hull(), index),
            None => Gradient::constant(number.hull()),
        });
        let output = P::apply(&input).ok()??;
        let slopes = RefCell::new(Vec::new());
        P::map_output(&output, |slope| slopes.borrow_mut().push(*slope));
        Some(slopes.into_inner())
    }

    /// The input in the middle of what is enclosed.
    fn middle<P: Step>(&self, input: &P::Input<Exact>) -> P::Input<Exact> {
        self.map::<P, _>(input, |number, index| {
            let number = if index.is_some() {
                number.middle()
            } else {
                number.clone()
            };
            number.with_bits(self.bits[1])
        })
    }

    /// The number about the value that the step has in the middle.
    fn compose(&self, middle: &Exact, slope: &Gradient) -> Option<Exact> {
        let slopes = || self.forms.iter().zip(slope.partials());
        if slopes().all(|(_, slope)| *slope == Interval::ZERO) {
            return Some(middle.clone().with_bits(self.bits[0]));
        }
        let mut coefficients = Vec::new();
        let ball = middle.to_ball();
        let mut rest = ball.view().radius();
        for (form, slope) in slopes() {
            let nearest = slope.to_f64();
            let error = (*slope - Interval::point(nearest)).magnitude();
            let rounding = Radius::magnitude(nearest).mul(Radius::power_of_two(ROUNDING));
            rest = rest
                .add(Radius::magnitude(slope.magnitude()).mul(form.rest))
                .add(Radius::magnitude(error).add(rounding).mul(form.linear));
            if form.basis.is_some() {
                let factor = nearest * power_of_two(form.exponent - self.exponent);
                add_scaled(&mut coefficients, factor, &form.coefficients);
            }
        }
        self.finish(ball.into_middle(), coefficients, rest)
    }

    fn finish(&self, middle: Dyadic, coefficients: Vec<f64>, rest: Radius) -> Option<Exact> {
        let form = match &self.basis {
            Some(basis) => {
                let underflow = Radius::power_of_two(self.exponent + UNDERFLOW);
                Form::new(basis, coefficients, self.exponent, rest.add(underflow))?
            }
            None => Form::unknown(rest),
        };
        let known = !form.total().is_unknown();
        known.then(|| Exact::with_form(middle, form, self.bits[0]))
    }
}

/// Whether a number is one of the variables, after so many others.
fn is_variable(number: &Exact, before: usize) -> bool {
    before < Gradient::VARIABLES && !number.is_rational()
}

/// Adds a multiple of a vector; an empty one is zero.
fn add_scaled(sum: &mut Vec<f64>, factor: f64, terms: &[f64]) {
    if sum.len() < terms.len() {
        sum.resize(terms.len(), 0.0);
    }
    for (sum, term) in sum.iter_mut().zip(terms) {
        *sum += factor * term;
    }
}
