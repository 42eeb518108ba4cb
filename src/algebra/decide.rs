//! The sign of a number that its enclosure does not tell.
//!
//! The cheapest proof first: see the [module](super) for their order.

use std::cmp::Ordering::{self, Equal};

use num_rational::BigRational;

use super::ascent::Ascent;
use super::bound::separation_bits;
use super::build::Normal;
use super::evaluate::{self, bits_of_zero};
use super::expression::{Expression, Operation};
use super::glance;
use super::limits::Limits;
use super::term::NoForm;
use super::tower::Stop;
use crate::scalar::{Exact, Scalar, Undecided};

/// The bits up to which an evaluation costs less than a tower.
const CHEAP_BITS: u64 = 2048;

/// The bits up to which a sign is looked for that no bound promises.
const VAIN_BITS: u64 = 1 << 14;

/// The bits that an evaluation takes beyond those of its result, at first.
const GUARD_BITS: u64 = 64;

/// The sign, proven.
pub(super) fn sign(number: &Expression) -> Result<Ordering, Undecided> {
    if let Some(sign) = glance::sign(number) {
        return Ok(sign);
    }
    let limits = number.limits();
    let normal = Normal::of(number, limits.bits).map_err(|why| no_form(why, limits.bits))?;
    let sign = Question::new(&normal, limits).answer()?;
    settle(&normal, sign);
    Ok(sign)
}

/// Remembers what the form alone tells of every number on the way, and what
/// it means that the last of them is zero.
fn settle(normal: &Normal<'_>, sign: Ordering) {
    for (node, form) in &normal.nodes {
        if form.term.is_none() {
            node.settle(form.factor.clone());
        }
    }
    if let (Equal, Some((goal, _))) = (sign, normal.nodes.last()) {
        settle_zero(goal);
    }
}

/// A number is zero; where it is the sum of another and a rational, that other
/// one is rational too.
fn settle_zero(zero: &Expression) {
    zero.settle(BigRational::default());
    if let Operation::Add(a, b) = zero.operation() {
        for (part, rest) in [(a, b), (b, a)] {
            if let Some(value) = rest.rational() {
                part.settle(-value);
            }
        }
    }
}

fn no_form(why: NoForm, bits: u32) -> Undecided {
    let question = match why {
        NoForm::Undefined => "the sign of a quotient by zero, or of the root of a negative number",
        NoForm::TooLong => "the sign of a number made of rationals too long to compute with",
    };
    Undecided::new(bits, question)
}

/// One decision.
struct Question<'a> {
    normal: &'a Normal<'a>,
    /// The terms that the number is made of.
    needed: Vec<usize>,
    limits: Limits,
    /// The number is zero or at least 2^-bound.
    bound: Option<u64>,
    /// The most bits of an evaluation so far.
    tried: u32,
}

impl<'a> Question<'a> {
    fn new(normal: &'a Normal<'a>, limits: Limits) -> Self {
        let needed = normal.graph.needed(&normal.goal);
        let bound = separation_bits(&normal.graph, &needed, &normal.goal);
        Self {
            normal,
            needed,
            limits,
            bound,
            tried: limits.bits,
        }
    }

    fn answer(&mut self) -> Result<Ordering, Undecided> {
        if let Some(sign) = self.normal.graph.sign(&self.normal.goal) {
            return Ok(sign);
        }
        if let Some(sign) = self.approach(self.enough(), CHEAP_BITS) {
            return Ok(sign);
        }
        match self.is_zero_in_tower() {
            Ok(true) => Ok(Equal),
            Err(Stop::Undefined) => Err(no_form(NoForm::Undefined, self.tried)),
            Ok(false) => self
                .approach(0, self.most_bits())
                .ok_or_else(|| self.open()),
            Err(Stop::Budget) => self.by_bound().ok_or_else(|| self.open()),
        }
    }

    /// Evaluates with so many bits at first, then twice as many, until the
    /// sign shows or the bound proves that there is none.
    fn approach(&mut self, first: u64, most: u64) -> Option<Ordering> {
        let mut bits = first.max(2 * u64::from(self.tried)).min(most);
        while bits > self.tried.into() {
            let sign = self.evaluate(bits)?;
            if sign.is_some() {
                return sign;
            }
            bits = (2 * bits).min(most);
        }
        None
    }

    /// The bound, if it is within the budget.
    fn usable_bound(&self) -> Option<u64> {
        self.bound
            .filter(|&bound| bound <= self.limits.bound_bits.into())
    }

    /// The bits that should be enough for the bound.
    fn enough(&self) -> u64 {
        self.usable_bound()
            .map_or(u64::MAX, |bound| bound + GUARD_BITS)
    }

    /// Whether the number is zero, by its coefficients in a tower.
    fn is_zero_in_tower(&self) -> Result<bool, Stop> {
        let (ascent, end) = Ascent::of(&self.normal.graph, &self.needed, self.limits);
        for (node, form) in &self.normal.nodes {
            if let Some(value) = ascent.rational(form) {
                node.settle(value);
            }
        }
        end?;
        // All terms were reached.
        ascent.is_zero(&self.normal.goal).ok_or(Stop::Budget)
    }

    /// Evaluates with as many bits as the separation bound asks for. Where
    /// those are too many, only what is not zero can show, and to look for it
    /// at great length is mostly in vain.
    fn by_bound(&mut self) -> Option<Ordering> {
        match self.usable_bound() {
            Some(_) => self.approach(self.enough(), self.most_bits()),
            None => self.approach(0, VAIN_BITS.min(self.most_bits())),
        }
    }

    /// Twice what a bound may ask for: operations that cancel lose bits.
    fn most_bits(&self) -> u64 {
        2 * u64::from(self.limits.bound_bits)
    }

    /// One evaluation: the sign, if it shows; nothing at all past the budget.
    fn evaluate(&mut self, bits: u64) -> Option<Option<Ordering>> {
        let bits = u32::try_from(bits).ok()?;
        let work = u64::from(bits) * self.needed.len() as u64;
        if work > self.limits.work {
            return None;
        }
        self.tried = self.tried.max(bits);
        let Normal { graph, goal, .. } = self.normal;
        let value = evaluate::number(graph, &self.needed, goal, bits);
        Some(self.sign_of(&value))
    }

    fn sign_of(&self, value: &Exact) -> Option<Ordering> {
        let is_zero = || {
            let bound = i64::try_from(self.usable_bound()?).ok()?;
            (bits_of_zero(value)? >= bound).then_some(Equal)
        };
        value.sign().ok().or_else(is_zero)
    }

    fn open(&self) -> Undecided {
        Undecided {
            bound: self.bound,
            ..Undecided::sign(self.tried)
        }
    }
}
