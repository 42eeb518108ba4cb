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
const DUE: i64 = -4;

/// The most numbers that get common axes: these take a time that grows with
/// the cube of the number. More are boxed one by one.
const MOST_NUMBERS: usize = 250;

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
#[derive(Clone, Debug)]
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

    /// The columns and, if there are fewer than numbers, the rest of each
    /// number as a column.
    fn generators(&self) -> Vec<Vec<f64>> {
        let dimension = self.rest.len();
        if self.columns.len() >= dimension {
            return self.columns.clone();
        }
        let rests = self.rest.iter().enumerate().map(|(row, rest)| {
            let mut column = vec![0.0; dimension];
            column[row] = *rest;
            column
        });
        self.columns.iter().cloned().chain(rests).collect()
    }

    /// For each number its coefficients and rest in a box about the set.
    fn boxed(&self) -> Vec<(Vec<f64>, f64)> {
        if self.rest.len() > MOST_NUMBERS {
            return self.boxed_apart();
        }
        self.boxed_along(&frame(self.rest.len(), self.generators()))
    }

    /// In a box along the coordinates: each number has a symbol of its own.
    fn boxed_apart(&self) -> Vec<(Vec<f64>, f64)> {
        let totals = self.rest.iter().zip(&self.linear);
        let totals = totals.map(|(rest, linear)| (rest + linear) * INFLATION);
        let alone = |(row, total)| {
            let mut coefficients = vec![0.0; self.rest.len()];
            coefficients[row] = total;
            (coefficients, 0.0)
        };
        totals.enumerate().map(alone).collect()
    }

    /// In a box along axes that are nearly orthogonal.
    fn boxed_along(&self, axes: &[Vec<f64>]) -> Vec<(Vec<f64>, f64)> {
        let dimension = self.rest.len();
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

#[cfg(test)]
mod tests {
    use num_rational::BigRational;
    use num_traits::Signed;
    use proptest::prelude::*;

    use super::*;

    fn ratio(number: f64) -> BigRational {
        BigRational::from_float(number).unwrap()
    }

    /// Sets in three to nine dimensions: some flat, some with columns of very
    /// different lengths; and where in it a point is.
    fn set() -> impl Strategy<Value = (Set, Vec<f64>, Vec<f64>)> {
        (3..10_usize, 0..12_usize).prop_flat_map(|(rows, columns)| {
            let entry = prop_oneof![Just(0.0), -1.0..1.0_f64];
            let column =
                (prop::collection::vec(entry, rows), 0..60_i32).prop_map(|(column, down)| {
                    column
                        .iter()
                        .map(|entry| entry * f64::from(-down).exp2())
                        .collect::<Vec<_>>()
                });
            let rest =
                (0.0..1.0_f64, 0..60_i32).prop_map(|(rest, down)| rest * f64::from(-down).exp2());
            let place = || prop_oneof![Just(-1.0), Just(1.0), -1.0..1.0_f64];
            (
                prop::collection::vec(column, columns).prop_flat_map(move |columns| {
                    let rest = rest.clone();
                    prop::collection::vec(rest, rows)
                        .prop_map(move |rest| made(columns.clone(), rest))
                }),
                prop::collection::vec(place(), columns),
                prop::collection::vec(place(), rows),
            )
        })
    }

    fn made(columns: Vec<Vec<f64>>, rest: Vec<f64>) -> Set {
        let sum =
            |row: usize| columns.iter().map(|column| column[row].abs()).sum::<f64>() * INFLATION;
        Set {
            exponent: 0,
            linear: (0..rest.len()).map(sum).collect(),
            columns,
            rest,
        }
    }

    /// The point that values of the symbols and of the rests give.
    fn point(set: &Set, symbols: &[f64], rests: &[f64]) -> Vec<BigRational> {
        let at = |row: usize| {
            let terms = set.columns.iter().zip(symbols);
            let linear: BigRational = terms
                .map(|(column, symbol)| ratio(column[row]) * ratio(*symbol))
                .sum();
            linear + ratio(set.rest[row]) * ratio(rests[row])
        };
        (0..rests.len()).map(at).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]

        /// With the new symbols at Qᵀ y / w, which must lie in [-1, 1], what
        /// is left of y must be within the rests; all of it in rationals.
        #[test]
        fn the_box_encloses_the_set((set, symbols, rests) in set()) {
            let point = point(&set, &symbols, &rests);
            let axes = frame(point.len(), set.generators());
            let mut left = point.clone();
            for (index, axis) in axes.iter().enumerate() {
                let along: BigRational = axis.iter().zip(&point).map(|(entry, part)| ratio(*entry) * part).sum();
                let extent = ratio(set.extent(axis));
                prop_assert!(along.abs() <= extent);
                for (left, (coefficients, _)) in left.iter_mut().zip(set.boxed()) {
                    *left -= ratio(coefficients[index]) * &along / &extent;
                }
            }
            for (left, (_, rest)) in left.iter().zip(set.boxed()) {
                prop_assert!(left.abs() <= ratio(rest));
            }
        }

        /// A set that is flat but for rests 2^-40 times as large is boxed
        /// about as flat.
        #[test]
        fn the_box_is_as_thin_as_the_set(direction in prop::array::uniform5(-1.0..1.0_f64)) {
            let length = dot(&direction, &direction).sqrt();
            prop_assume!(length > 0.1);
            let rest = 2.0_f64.powi(-40);
            let set = made(vec![direction.to_vec()], vec![rest; 5]);
            let axes = frame(5, set.generators());
            let extents: Vec<f64> = axes.iter().map(|axis| set.extent(axis)).collect();
            prop_assert!(extents[0] < 1.001 * length);
            prop_assert!(extents[1..].iter().all(|extent| *extent < 8.0 * rest));
        }
    }
}
