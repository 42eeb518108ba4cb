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

use super::{Basis, Form, GUARD, UNDERFLOW};
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
    list: Vec<Variable>,
    /// The symbols that matter, and their basis.
    symbols: Vec<u32>,
    basis: Option<Basis>,
    /// The unit of coefficients.
    exponent: i64,
    /// The bits that the input carries, and those worth computing with.
    bits: [u32; 2],
}

/// How far an input is from its midpoint.
struct Variable {
    /// In units of 2 to the common exponent, for each symbol.
    coefficients: Vec<f64>,
    linear: Radius,
    rest: Radius,
}

impl Variable {
    fn new(form: &Form, exponent: i64, symbols: &[u32]) -> Self {
        let mut coefficients = vec![0.0; symbols.len()];
        let mut place = 0;
        for (symbol, coefficient) in &form.terms {
            place += symbols[place..].partition_point(|other| other < symbol);
            coefficients[place] = coefficient * power_of_two(form.exponent - exponent);
        }
        let underflow = match form.terms.is_empty() {
            true => Radius::ZERO,
            false => Radius::power_of_two(exponent + UNDERFLOW),
        };
        Self {
            coefficients,
            linear: form.linear,
            rest: form.rest.add(underflow),
        }
    }
}

impl Variables {
    fn of<P: Step>(input: &P::Input<Exact>) -> Option<Self> {
        let (forms, bits) = (RefCell::new(Vec::new()), Cell::new((0, 0)));
        P::map_input(input, |number| {
            let (most, mut useful) = bits.get();
            if is_variable(number, forms.borrow().len()) {
                forms.borrow_mut().push(number.error());
                useful = useful.max(number.accuracy().unwrap_or(0));
            }
            bits.set((most.max(number.bits), useful));
        });
        let (most, useful) = bits.get();
        let worthwhile = most >= Exact::STEP_BITS && !forms.borrow().is_empty();
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
        let symbols = symbols(&forms);
        let variables = forms
            .iter()
            .map(|form| Variable::new(form, exponent, &symbols));
        Self {
            list: variables.collect(),
            symbols,
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
        let slopes = || self.list.iter().zip(slope.partials());
        if slopes().all(|(_, slope)| *slope == Interval::ZERO) {
            return Some(middle.clone().with_bits(self.bits[0]));
        }
        let ball = middle.to_ball();
        let mut coefficients = vec![0.0; self.symbols.len()];
        let mut rest = ball.view().radius().add(self.underflow());
        for (variable, slope) in slopes() {
            let nearest = slope.to_f64();
            let error = (*slope - Interval::point(nearest)).magnitude();
            let rounding = Radius::magnitude(nearest).mul(Radius::power_of_two(ROUNDING));
            rest = rest
                .add(Radius::magnitude(slope.magnitude()).mul(variable.rest))
                .add(Radius::magnitude(error).add(rounding).mul(variable.linear));
            for (sum, coefficient) in coefficients.iter_mut().zip(&variable.coefficients) {
                *sum += nearest * coefficient;
            }
        }
        let form = self.form(coefficients, rest)?;
        let known = !form.total().is_unknown();
        known.then(|| Exact::with_form(ball.into_middle(), form, self.bits[0]))
    }

    fn form(&self, coefficients: Vec<f64>, rest: Radius) -> Option<Form> {
        let Some(basis) = &self.basis else {
            return Some(Form::unknown(rest));
        };
        let terms = self.symbols.iter().copied().zip(coefficients).collect();
        Form::new(basis, terms, self.exponent, rest)
    }

    /// What may be lost in sums of coefficients that are too small for
    /// binary64.
    fn underflow(&self) -> Radius {
        match &self.basis {
            Some(_) => Radius::power_of_two(self.exponent + UNDERFLOW),
            None => Radius::ZERO,
        }
    }
}

/// The symbols of all forms, in ascending order.
fn symbols(forms: &[Arc<Form>]) -> Vec<u32> {
    let terms = forms.iter().flat_map(|form| &form.terms);
    let mut symbols: Vec<u32> = terms.map(|(symbol, _)| *symbol).collect();
    symbols.sort_unstable();
    symbols.dedup();
    symbols
}

/// Whether a number is one of the variables, after so many others.
fn is_variable(number: &Exact, before: usize) -> bool {
    before < Gradient::VARIABLES && !number.is_rational()
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering::Greater;

    use num_rational::BigRational;
    use proptest::prelude::*;

    use super::*;
    use crate::scalar::Number;
    use crate::scalar::dyadic::Dyadic;

    const BITS: u32 = 2048;

    /// A rotation by the angle of 3 + 4i, if the first number is above one
    /// half: bounds of the two, one by one, grow by 7/5 each time, the truth
    /// does not grow at all.
    enum Rotation {}

    impl Step for Rotation {
        type Input<T> = [T; 2];
        type Output<T> = [T; 2];

        fn apply<T: Scalar>([x, y]: &[T; 2]) -> Result<Option<[T; 2]>, T::Doubt> {
            let part = |n: i32| T::from_integer(n) / T::from_integer(5);
            let half = T::from_integer(1) / T::from_integer(2);
            let far = (x.square() + y.square()).compare(&half)? == Greater;
            let turned = [
                T::difference_of_products(x, &part(3), y, &part(4)),
                x.clone() * part(4) + y.clone() * part(3),
            ];
            Ok(far.then_some(turned))
        }

        fn map_input<T, U>(input: &[T; 2], make: impl Fn(&T) -> U) -> [U; 2] {
            [make(&input[0]), make(&input[1])]
        }

        fn map_output<T, U>(output: &[T; 2], make: impl Fn(&T) -> U) -> [U; 2] {
            Self::map_input(output, make)
        }
    }

    /// An enclosure about a number, that far from it at most.
    fn about(number: f64, error: i64) -> Exact {
        let middle = Dyadic::from_f64(number);
        Exact::with_form(middle, Form::unknown(Radius::power_of_two(error)), BITS)
    }

    fn accuracy(number: &Exact) -> i64 {
        number.accuracy().unwrap()
    }

    fn turned(mut point: [Exact; 2], times: usize) -> [Exact; 2] {
        for _ in 0..times {
            point = Exact::step::<Rotation>(|| point.clone()).unwrap();
            Exact::rebase(point.iter_mut());
        }
        point
    }

    #[test]
    fn a_rotation_hardly_wraps() {
        let point = turned([about(1.0, -1000), about(0.25, -1000)], 300);
        assert!(
            point.iter().map(accuracy).max().unwrap() > 990,
            "{:?}",
            point.map(|n| accuracy(&n))
        );
        let mut plain = [about(1.0, -1000), about(0.25, -1000)];
        for _ in 0..300 {
            plain = Rotation::apply(&plain).unwrap().unwrap();
        }
        assert!(plain.iter().map(accuracy).max().unwrap() < 900);
    }

    #[test]
    fn what_is_exact_or_short_takes_no_step() {
        let number = |bits| Exact::from_number(&Number::from(1), bits);
        assert!(Exact::step::<Rotation>(|| [number(BITS), number(BITS)]).is_none());
        let short = || number(Exact::STEP_BITS - 1) / Exact::from_integer(3);
        assert!(Exact::step::<Rotation>(|| [short().sqrt(), short()]).is_none());
        let long = || (number(Exact::STEP_BITS) / Exact::from_integer(3)).sqrt();
        let result = Exact::step::<Rotation>(|| [long(), long()]);
        assert!(result.unwrap()[0].form.is_some());
    }

    /// 1/2 + 2^-60 is above one half, which binary64 does not see.
    #[test]
    fn what_binary64_does_not_decide_takes_no_step() {
        let tiny = Exact::from_number(&"0x1p-60".parse().unwrap(), BITS);
        let half = Exact::from_number(&"1/2".parse().unwrap(), BITS);
        let close = (half.clone() + &tiny).sqrt();
        assert_eq!(close.square().compare(&half), Ok(Greater));
        let input = [close, about(0.0, -1000)];
        assert!(Rotation::apply(&input).unwrap().is_some());
        assert!(Exact::step::<Rotation>(|| input).is_none());
    }

    /// Symbols of one basis say nothing about another.
    #[test]
    fn bases_do_not_mix() {
        let [mut x, _] = turned([about(1.0, -1000), about(0.25, -1000)], 1);
        let [_, mut y] = turned([about(1.0, -1000), about(0.25, -1000)], 1);
        Exact::rebase([&mut x].into_iter());
        Exact::rebase([&mut y].into_iter());
        let [a, b] = [&x, &y].map(|number| number.error().basis.clone().unwrap());
        assert!(!a.is(&b));
        let together = Exact::step::<Rotation>(|| [x, y]).unwrap();
        assert!(together.iter().all(|number| accuracy(number) < 1000));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(100))]

        /// The images of the corners and of a point within, in rationals.
        #[test]
        fn images_are_enclosed(
            [x, y] in prop::array::uniform2(0.75..1.0_f64),
            errors in prop::array::uniform2(-40..-10_i64),
            places in prop::array::uniform2(prop_oneof![Just(-1.0), Just(1.0), -1.0..1.0_f64]),
        ) {
            let ratio = |number: f64| BigRational::from_float(number).unwrap();
            let fifths = |n: i32| BigRational::new(n.into(), 5.into());
            let at = |middle: f64, error: i64, place: f64| ratio(middle) + ratio((error as f64).exp2()) * ratio(place);
            let mut point = [at(x, errors[0], places[0]), at(y, errors[1], places[1])];
            let mut input = [about(x, errors[0]), about(y, errors[1])];
            for _ in 0..5 {
                point = [
                    &point[0] * fifths(3) - &point[1] * fifths(4),
                    &point[0] * fifths(4) + &point[1] * fifths(3),
                ];
                let Some(output) = Exact::step::<Rotation>(|| input.clone()) else { break };
                input = output;
                Exact::rebase(input.iter_mut());
                for (number, part) in input.iter().zip(&point) {
                    let (lo, hi) = number.enclosure().unwrap();
                    prop_assert!(lo <= *part && *part <= hi);
                }
            }
        }
    }
}
