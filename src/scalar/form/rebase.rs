//! New symbols for all numbers, one for each.
//!
//! A number m + c·ε ± rest becomes m + w ε', with w the bound of the whole. How
//! its error hung together with those of others is forgotten, which plain
//! enclosures do at every operation. Here it happens once in some ten impacts
//! of a disc, when the rests have grown, which know of nothing either: a few
//! bits then, instead of some at every impact.
//!
//! Lohner's method (Enclosing the solutions of ordinary initial and boundary
//! value problems, 1987) would keep the shape of the set, by axes from an
//! orthogonal decomposition of all coefficients. For gases of 2 to 100 discs
//! that saved at most 5 % of the bits lost, and only where it was done several
//! times as often; it takes a time that grows with the cube of the number of
//! discs.

use std::sync::Arc;

use super::{Basis, Form};
use crate::scalar::ball::Ball;
use crate::scalar::radius::Radius;

/// New symbols are due when the largest rest is more than 2 to this times the
/// largest part that symbols explain.
const DUE: i64 = -4;

/// A number that gets a new symbol.
pub(in crate::scalar) struct Enclosed<'a> {
    pub(in crate::scalar) ball: &'a Ball,
    pub(in crate::scalar) form: &'a mut Arc<Form>,
}

/// Gives numbers new symbols, if it is time for that.
pub(in crate::scalar) fn rebase(numbers: Vec<Enclosed<'_>>) {
    if !is_due(&numbers) {
        return;
    }
    let basis = Basis::new();
    for (symbol, number) in (0..).zip(numbers) {
        let bound = number.ball.view().radius();
        *number.form = Arc::new(Form::of_symbol(&basis, symbol, bound));
    }
}

fn is_due(numbers: &[Enclosed<'_>]) -> bool {
    let largest = |part: fn(&Form) -> Radius| numbers.iter().map(|number| part(number.form)).max();
    let linear = largest(|form| form.linear);
    let rest = largest(|form| form.rest);
    matches!((linear, rest), (Some(linear), Some(rest)) if rest.top() > linear.top() + DUE)
}
