//! A number that remembers how it was made.
//!
//! An expression is a node of a graph that others share. It carries an
//! enclosure, which decides most signs, and what has been proven about it
//! since: its sign, or that it is a certain rational. Rationals are computed
//! with at once, and what is trivial is not recorded: x + 0, x - x, 1 x, 0 x,
//! -(-x), √(x²) where the sign of x is known.

use std::cmp::Ordering::{self, Equal, Greater, Less};
use std::fmt;
use std::mem;
use std::sync::{Arc, OnceLock};

use num_rational::BigRational;

use super::decide;
use super::limits::Limits;
use super::rational::{rational_root, sign_of};
use crate::scalar::{Exact, Interval, Number, Scalar, Undecided};

/// A number made from rationals by addition, subtraction, multiplication,
/// division and square roots, of which every decision is a proof.
///
/// To divide by zero, or to take the square root of a negative number, gives
/// what is no number: its sign is never decided. Where neither has been
/// decided before, the number is taken to exist.
///
/// # Examples
///
/// ```
/// use std::cmp::Ordering;
/// use carom::algebra::{Expression, Limits};
/// use carom::scalar::{Number, Scalar};
///
/// let root = |n: i32| Expression::from_number(&Number::from(n), Limits::default()).sqrt();
/// let nested = (Expression::from_integer(5) + Expression::from_integer(2) * root(6)).sqrt();
/// assert_eq!(nested.compare(&(root(2) + root(3))), Ok(Ordering::Equal));
/// # Ok::<(), carom::scalar::Undecided>(())
/// ```
#[derive(Clone)]
pub struct Expression(Arc<Node>);

struct Node {
    operation: Operation,
    enclosure: Exact,
    limits: Limits,
    /// The sign, once it is proven.
    sign: OnceLock<Ordering>,
    /// The rational that the number was proven to be.
    rational: OnceLock<BigRational>,
}

/// How a number is made.
pub(super) enum Operation {
    /// What is no number.
    Undefined,
    Rational(BigRational),
    Negate(Expression),
    Add(Expression, Expression),
    Multiply(Expression, Expression),
    Divide(Expression, Expression),
    Root(Expression),
}

impl Expression {
    /// A fraction in lowest terms.
    pub fn from_rational(value: BigRational, limits: Limits) -> Self {
        Self::record(Operation::Rational(value), limits)
    }

    /// A number, if it is known as a rational.
    pub fn from_exact(value: &Exact, limits: Limits) -> Option<Self> {
        let (lo, hi) = value.enclosure()?;
        (lo == hi).then(|| Self::from_rational(lo, limits))
    }

    /// The enclosure, or the number itself where it is known to be rational.
    pub fn to_exact(&self) -> Exact {
        self.best_enclosure(self.limits().bits)
    }

    /// The rational that this is, where that is known.
    pub fn rational(&self) -> Option<&BigRational> {
        match &self.0.operation {
            Operation::Rational(value) => Some(value),
            _ => self.0.rational.get(),
        }
    }

    /// A new node.
    pub(super) fn record(operation: Operation, limits: Limits) -> Self {
        let enclosure = operation.enclosure(limits.bits);
        Self(Arc::new(Node {
            operation,
            enclosure,
            limits,
            sign: OnceLock::new(),
            rational: OnceLock::new(),
        }))
    }

    pub(super) fn operation(&self) -> &Operation {
        &self.0.operation
    }

    /// The limits that the number carries.
    pub(super) fn own_limits(&self) -> Limits {
        self.0.limits
    }

    /// The limits of a decision.
    pub(super) fn limits(&self) -> Limits {
        self.0.limits.or_default()
    }

    pub(super) fn is_same_node(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// What tells this node from all others while it lives.
    pub(super) fn address(&self) -> usize {
        Arc::as_ptr(&self.0) as usize
    }

    /// Remembers that the number was proven to be rational.
    pub(super) fn settle(&self, value: BigRational) {
        let _ = self.0.rational.set(value);
    }

    /// The sign, where it has been proven already.
    pub(super) fn known_sign(&self) -> Option<Ordering> {
        let by_value = self.rational().map(sign_of);
        by_value
            .or_else(|| self.0.sign.get().copied())
            .or_else(|| self.0.enclosure.sign().ok())
    }

    /// The enclosure, or the rational that the number was proven to be since.
    fn best_enclosure(&self, bits: u32) -> Exact {
        match self.0.rational.get() {
            Some(value) => Exact::from_rational(value.clone(), bits),
            None => self.0.enclosure.clone(),
        }
    }

    /// |x| for x², where the sign of x is known.
    fn root_of_square(&self) -> Option<Self> {
        let Operation::Multiply(a, b) = self.operation() else {
            return None;
        };
        if !a.is_same_node(b) {
            return None;
        }
        match a.known_sign()? {
            Less => Some(-a.clone()),
            Equal | Greater => Some(a.clone()),
        }
    }
}

impl fmt::Debug for Expression {
    /// The nearest binary64: the graph may be deep.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Expression").field(&self.to_f64()).finish()
    }
}

impl Scalar for Expression {
    type Doubt = Undecided;
    type Precision = Limits;

    const ROUNDS: bool = false;
    const IS_DEAR: bool = false;

    fn from_number(number: &Number, limits: Limits) -> Self {
        Self::from_rational(number.to_rational(), limits)
    }

    fn from_integer(integer: i32) -> Self {
        Self::from_rational(BigRational::from_integer(integer.into()), Limits::NONE)
    }

    fn sign(&self) -> Result<Ordering, Undecided> {
        if let Some(sign) = self.known_sign() {
            return Ok(sign);
        }
        let sign = decide::sign(self)?;
        Ok(*self.0.sign.get_or_init(|| sign))
    }

    fn is_surely_zero(&self) -> bool {
        self.known_sign() == Some(Equal)
    }

    fn compare(&self, other: &Self) -> Result<Ordering, Undecided> {
        match self.0.enclosure.compare(&other.0.enclosure) {
            Ok(order) => Ok(order),
            Err(_) => (self.clone() - other).sign(),
        }
    }

    fn square(&self) -> Self {
        self.clone() * self
    }

    fn sqrt(&self) -> Self {
        let limits = self.0.limits;
        if self.known_sign() == Some(Less) {
            return Self::record(Operation::Undefined, limits);
        }
        if let Some(root) = self.rational().and_then(rational_root) {
            return Self::from_rational(root, limits);
        }
        let root = || Self::record(Operation::Root(self.clone()), limits);
        self.root_of_square().unwrap_or_else(root)
    }

    fn difference_of_products(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        a.clone() * b - c.clone() * d
    }

    fn not_before(self, _: &Self) -> Self {
        self
    }

    fn to_f64(&self) -> f64 {
        self.0.enclosure.to_f64()
    }

    fn hull(&self) -> Interval {
        self.0.enclosure.hull()
    }

    /// Equal where the number is known to be rational; none for what is no
    /// number, and where an enclosure of a divisor contains zero.
    fn enclosure(&self) -> Option<(BigRational, BigRational)> {
        match self.rational() {
            Some(value) => Some((value.clone(), value.clone())),
            None => self.0.enclosure.enclosure(),
        }
    }
}

impl Operation {
    fn enclosure(&self, bits: u32) -> Exact {
        self.value(|operand| operand.best_enclosure(bits), bits)
    }

    /// An enclosure, given those of the operands.
    pub(super) fn value(&self, of: impl Fn(&Expression) -> Exact, bits: u32) -> Exact {
        match self {
            Self::Undefined => Exact::from_integer(1) / Exact::from_integer(0),
            Self::Rational(value) => Exact::from_rational(value.clone(), bits),
            Self::Negate(a) => -of(a),
            Self::Add(a, b) => of(a) + of(b),
            Self::Multiply(a, b) if a.is_same_node(b) => of(a).square(),
            Self::Multiply(a, b) => of(a) * of(b),
            Self::Divide(a, b) => of(a) / of(b),
            Self::Root(a) => of(a).sqrt(),
        }
    }

    /// The operands, one to two, or none.
    pub(super) fn operands(&self) -> [Option<&Expression>; 2] {
        match self {
            Self::Undefined | Self::Rational(_) => [None, None],
            Self::Negate(a) | Self::Root(a) => [Some(a), None],
            Self::Add(a, b) | Self::Multiply(a, b) | Self::Divide(a, b) => [Some(a), Some(b)],
        }
    }

    fn take_operands(&mut self) -> Vec<Expression> {
        match mem::replace(self, Self::Undefined) {
            Self::Undefined | Self::Rational(_) => Vec::new(),
            Self::Negate(a) | Self::Root(a) => vec![a],
            Self::Add(a, b) | Self::Multiply(a, b) | Self::Divide(a, b) => vec![a, b],
        }
    }
}

impl Drop for Node {
    /// In a loop: a graph may be deeper than the stack.
    fn drop(&mut self) {
        let mut pending = self.operation.take_operands();
        while let Some(Expression(node)) = pending.pop() {
            if let Some(mut node) = Arc::into_inner(node) {
                pending.append(&mut node.operation.take_operands());
            }
        }
    }
}
