//! New symbols for all numbers: Lohner's method.
//!
//! The numbers x about their midpoints m form the set m + A ε + r δ, with the
//! coefficients A and the rests r. For an orthogonal Q it lies within
//! m + Q w ε', where w bounds Qᵀ(A ε + r δ) entry by entry. As Q is the
//! orthogonal factor of A with its longest column first, this box is about as
//! long and as thin as the set, so that little is gained by the enclosure
//! where the dynamics pull it long (Lohner: Enclosing the solutions of
//! ordinary initial and boundary value problems, 1987; Nedialkov and Jackson: A
//! new perspective on the wrapping effect in interval methods, 2001).
//!
//! Q is computed in binary64 and is orthogonal only nearly. For any Q,
//! y = Q (Qᵀ y) + (I - Q Qᵀ) y, and bounds of I - Q Qᵀ give the new rests.

use std::sync::Arc;

use super::orthogonal::{dot, frame, rounding};
use super::{Basis, Form, UNDERFLOW};
use crate::scalar::ball::Ball;
use crate::scalar::radius::Radius;
use crate::scalar::rounding::power_of_two;

/// New symbols are due when the largest rest is more than 2 to this times the
/// largest part that symbols explain.
const DUE: i64 = -10;

/// More than sums and products of a few thousand bounds, each rounded to
/// nearest, lose.
const INFLATION: f64 = 1.0 + 1e-11;

/// A number that gets new symbols.
pub(in crate::scalar) struct Enclosed<'a> {
    pub(in crate::scalar) ball: &'a mut Ball,
    pub(in crate::scalar) form: &'a mut Arc<Form>,
}

impl Enclosed<'_> {
    fn total(&self) -> Radius {
        self.ball.view().radius()
    }

    /// Takes the new form, unless it says much less than was known.
    fn replace(&mut self, form: Form) {
        let total = self.total();
        *self.form = if form.total().top() > total.top() + 20 {
            Arc::new(Form::unknown(total))
        } else {
            self.ball.limit(form.total());
            Arc::new(form)
        };
    }
}

/// Gives numbers new symbols, if it is time for that.
pub(in crate::scalar) fn rebase(mut numbers: Vec<Enclosed<'_>>) {
    if !is_due(&numbers) {
        return;
    }
    let set = Set::of(&numbers);
    let basis = Basis::new();
    let forms: Vec<_> = set.boxed().into_iter().collect();
    for (number, (coefficients, rest)) in numbers.iter_mut().zip(forms) {
        let rest = Radius::magnitude(rest).mul(Radius::power_of_two(set.exponent));
        if let Some(form) = Form::new(&basis, coefficients, set.exponent, rest) {
            number.replace(form);
        }
    }
}

fn is_due(numbers: &[Enclosed<'_>]) -> bool {
    let largest = |part: fn(&Form) -> Radius| numbers.iter().map(|number| part(number.form)).max();
    let linear = largest(|form| form.linear);
    let rest = largest(|form| form.rest);
    matches!((linear, rest), (Some(linear), Some(rest)) if rest.top() > linear.top() + DUE)
}

/// The errors of all numbers in units of 2^`exponent`, at most about 1.
struct Set {
    exponent: i64,
    /// For each symbol, the coefficients of all numbers.
    columns: Vec<Vec<f64>>,
    /// For each number, bounds of what the symbols explain and of the rest.
    linear: Vec<f64>,
    rest: Vec<f64>,
}

impl Set {
    fn of(numbers: &[Enclosed<'_>]) -> Self {
        let exponent = numbers.iter().map(|number| number.total().top()).max();
        let exponent = exponent.unwrap_or(0);
        let basis = numbers.iter().find_map(|number| number.form.basis.as_ref());
        let mut set = Self {
            exponent,
            columns: Vec::new(),
            linear: Vec::new(),
            rest: Vec::new(),
        };
        for (row, number) in numbers.iter().enumerate() {
            set.take(row, numbers.len(), number, basis);
        }
        set
    }

    /// Takes over a number's form, or its radius where the symbols are others.
    fn take(&mut self, row: usize, rows: usize, number: &Enclosed<'_>, basis: Option<&Basis>) {
        let form = &**number.form;
        let shift = form.exponent - self.exponent;
        let common = match (&form.basis, basis) {
            (Some(own), Some(common)) => own.is(common) && shift > UNDERFLOW,
            _ => false,
        };
        let [linear, rest] = if common {
            [form.linear, form.rest]
        } else {
            [Radius::ZERO, number.total()]
        };
        self.linear.push(linear.to_f64(self.exponent));
        self.rest
            .push(rest.to_f64(self.exponent) + power_of_two(UNDERFLOW));
        if common {
            self.columns.resize(
                self.columns.len().max(form.coefficients.len()),
                vec![0.0; rows],
            );
            let unit = power_of_two(shift);
            for (column, coefficient) in self.columns.iter_mut().zip(&form.coefficients) {
                column[row] = coefficient * unit;
            }
        }
    }

    /// The columns and, for each number, one for its rest.
    fn generators(&self) -> Vec<Vec<f64>> {
        let dimension = self.rest.len();
        let rests = self.rest.iter().enumerate().map(|(row, rest)| {
            let mut column = vec![0.0; dimension];
            column[row] = *rest;
            column
        });
        self.columns.iter().cloned().chain(rests).collect()
    }

    /// For each number its coefficients and rest in a box about the set.
    fn boxed(&self) -> Vec<(Vec<f64>, f64)> {
        let dimension = self.rest.len();
        let axes = frame(dimension, self.generators());
        let extents: Vec<_> = axes.iter().map(|axis| self.extent(axis)).collect();
        let rows: Vec<Vec<f64>> = (0..dimension)
            .map(|row| axes.iter().map(|axis| axis[row]).collect())
            .collect();
        let defects = self.defects(&rows);
        let scaled = |row: &Vec<f64>| {
            let entries = row.iter().zip(&extents);
            entries.map(|(entry, extent)| entry * extent).collect()
        };
        rows.iter()
            .zip(defects)
            .map(|(row, defect)| {
                let coefficients: Vec<f64> = scaled(row);
                let sum: f64 = coefficients.iter().map(|term| term.abs()).sum();
                (coefficients, (defect + sum * f64::EPSILON) * INFLATION)
            })
            .collect()
    }

    /// A bound of how far the set reaches along a vector.
    fn extent(&self, axis: &[f64]) -> f64 {
        let along: f64 = self
            .columns
            .iter()
            .map(|column| dot(axis, column).abs())
            .sum();
        let rounding = rounding(axis.len());
        let errors = self.rest.iter().zip(&self.linear);
        let bounds = axis.iter().zip(errors);
        let rest: f64 = bounds
            .map(|(entry, (rest, linear))| entry.abs() * (rest + linear * rounding))
            .sum();
        (along + rest + power_of_two(UNDERFLOW)) * INFLATION
    }

    /// Bounds of (I - Q Qᵀ) y for y in the set, from the rows of Q.
    fn defects(&self, rows: &[Vec<f64>]) -> Vec<f64> {
        let totals: Vec<f64> = self
            .rest
            .iter()
            .zip(&self.linear)
            .map(|(rest, linear)| rest + linear)
            .collect();
        let lengths: Vec<f64> = rows
            .iter()
            .map(|row| dot(row, row).sqrt() * INFLATION)
            .collect();
        let rounding = rounding(rows.len());
        let mut defects = vec![power_of_two(UNDERFLOW); rows.len()];
        for i in 0..rows.len() {
            for j in 0..=i {
                let product = dot(&rows[i], &rows[j]);
                let defect = (product - f64::from(u8::from(i == j))).abs()
                    + rounding * lengths[i] * lengths[j];
                defects[i] += defect * totals[j];
                if i != j {
                    defects[j] += defect * totals[i];
                }
            }
        }
        defects
    }
}
