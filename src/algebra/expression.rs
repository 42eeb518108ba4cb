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
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::{Arc, OnceLock};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

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

/// The bits of two rationals, together, up to which they are computed with
/// at once. Beyond, operations are only recorded.
const FOLDED_BITS: u64 = 1 << 14;

impl Expression {
    /// A fraction in lowest terms.
    pub fn from_rational(value: BigRational, limits: Limits) -> Self {
        let enclosure = Exact::from_rational(value.clone(), limits.bits);
        Self::new(Operation::Rational(value), enclosure, limits)
    }

    /// The rational that this is, where that is known.
    pub fn rational(&self) -> Option<&BigRational> {
        match &self.0.operation {
            Operation::Rational(value) => Some(value),
            _ => self.0.rational.get(),
        }
    }

    fn new(operation: Operation, enclosure: Exact, limits: Limits) -> Self {
        Self(Arc::new(Node {
            operation,
            enclosure,
            limits,
            sign: OnceLock::new(),
            rational: OnceLock::new(),
        }))
    }

    fn undefined(limits: Limits) -> Self {
        let anything = Exact::from_integer(1) / Exact::from_integer(0);
        Self::new(Operation::Undefined, anything, limits)
    }

    pub(super) fn operation(&self) -> &Operation {
        &self.0.operation
    }

    pub(super) fn limits(&self) -> Limits {
        self.0.limits.or_default()
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

    fn is_known_nonzero(&self) -> bool {
        self.known_sign().is_some_and(Ordering::is_ne)
    }

    fn is(&self, value: i32) -> bool {
        let value = BigInt::from(value);
        self.rational()
            .is_some_and(|r| r.is_integer() && *r.numer() == value)
    }

    fn is_same_node(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// Whether one is recorded as the other with its sign turned.
    fn is_opposite_of(&self, other: &Self) -> bool {
        let turned = |a: &Self, b: &Self| match a.operation() {
            Operation::Negate(inner) => inner.is_same_node(b),
            _ => false,
        };
        turned(self, other) || turned(other, self)
    }

    fn joined_limits(&self, other: &Self) -> Limits {
        self.0.limits.joined(other.0.limits)
    }

    /// Both numbers, if they are rational and short enough to compute with.
    fn short_rationals<'a>(&'a self, other: &'a Self) -> Option<[&'a BigRational; 2]> {
        let pair = [self.rational()?, other.rational()?];
        let length = |r: &BigRational| r.numer().bits() + r.denom().bits();
        (pair.iter().map(|r| length(r)).sum::<u64>() <= FOLDED_BITS).then_some(pair)
    }

    /// A rational result of rational operands.
    fn folded(
        &self,
        other: &Self,
        operation: impl FnOnce(&BigRational, &BigRational) -> BigRational,
    ) -> Option<Self> {
        let [a, b] = self.short_rationals(other)?;
        Some(Self::from_rational(
            operation(a, b),
            self.joined_limits(other),
        ))
    }

    fn record_add(self, other: &Self) -> Self {
        let (limits, enclosure) = (
            self.joined_limits(other),
            self.0.enclosure.clone() + &other.0.enclosure,
        );
        Self::new(Operation::Add(self, other.clone()), enclosure, limits)
    }

    fn record_multiply(self, other: &Self) -> Self {
        let limits = self.joined_limits(other);
        let enclosure = if self.is_same_node(other) {
            self.0.enclosure.square()
        } else {
            self.0.enclosure.clone() * &other.0.enclosure
        };
        Self::new(Operation::Multiply(self, other.clone()), enclosure, limits)
    }

    fn record_divide(self, other: &Self) -> Self {
        let (limits, enclosure) = (
            self.joined_limits(other),
            self.0.enclosure.clone() / &other.0.enclosure,
        );
        Self::new(Operation::Divide(self, other.clone()), enclosure, limits)
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
    const FILTERED: bool = false;

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
            return Self::undefined(limits);
        }
        if let Some(root) = self.rational().and_then(rational_root) {
            return Self::from_rational(root, limits);
        }
        self.root_of_square().unwrap_or_else(|| {
            let enclosure = self.0.enclosure.sqrt();
            Self::new(Operation::Root(self.clone()), enclosure, limits)
        })
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

impl Add<&Self> for Expression {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        if let Some(sum) = self.folded(other, |a, b| a + b) {
            return sum;
        }
        if self.is(0) {
            return other.clone();
        }
        if other.is(0) {
            return self;
        }
        if self.is_opposite_of(other) {
            return Self::from_rational(BigRational::zero(), self.joined_limits(other));
        }
        self.record_add(other)
    }
}

impl Sub<&Self> for Expression {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        self + -other.clone()
    }
}

impl Mul<&Self> for Expression {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        if let Some(product) = self.folded(other, |a, b| a * b) {
            return product;
        }
        let same = self.is_same_node(other);
        match (self.operation(), other.operation()) {
            _ if self.is(0) || other.is(1) => self,
            _ if other.is(0) || self.is(1) => other.clone(),
            _ if self.is(-1) => -other.clone(),
            _ if other.is(-1) => -self,
            (Operation::Root(radicand), _) if same => radicand.clone(),
            (Operation::Negate(a), Operation::Negate(b)) => a.clone() * b,
            _ => self.record_multiply(other),
        }
    }
}

impl Div<&Self> for Expression {
    type Output = Self;

    fn div(self, other: &Self) -> Self {
        let limits = self.joined_limits(other);
        if other.known_sign() == Some(Equal) {
            return Self::undefined(limits);
        }
        if let Some(quotient) = self.folded(other, |a, b| a / b) {
            return quotient;
        }
        let nonzero = other.is_known_nonzero();
        match () {
            () if other.is(1) || nonzero && self.is(0) => self,
            () if other.is(-1) => -self,
            () if nonzero && self.is_same_node(other) => {
                Self::from_rational(BigRational::one(), limits)
            }
            () => self.record_divide(other),
        }
    }
}

impl Neg for Expression {
    type Output = Self;

    fn neg(self) -> Self {
        let limits = self.0.limits;
        if let Some(value) = self.rational() {
            return Self::from_rational(-value, limits);
        }
        if let Operation::Negate(inner) = self.operation() {
            return inner.clone();
        }
        let enclosure = -self.0.enclosure.clone();
        Self::new(Operation::Negate(self), enclosure, limits)
    }
}

/// The operators with their right operand by value.
macro_rules! forward_by_value {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Expression {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                $operator::$method(self, &other)
            }
        }
    )*};
}

forward_by_value!(Add add, Sub sub, Mul mul, Div div);

impl Operation {
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
