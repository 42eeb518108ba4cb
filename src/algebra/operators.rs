//! The operators: what is trivial is not recorded.

use std::cmp::Ordering::Equal;
use std::ops::{Add, Div, Mul, Neg, Sub};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::expression::{Expression, Operation};
use super::limits::Limits;

/// The bits of two rationals, together, up to which they are computed with
/// at once. Beyond, operations are only recorded.
const FOLDED_BITS: u64 = 1 << 14;

impl Expression {
    fn is(&self, value: i32) -> bool {
        let value = BigInt::from(value);
        self.rational()
            .is_some_and(|r| r.is_integer() && *r.numer() == value)
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
        self.own_limits().joined(other.own_limits())
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
        let limits = self.joined_limits(other);
        Self::record(Operation::Add(self, other.clone()), limits)
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
        let limits = self.joined_limits(other);
        let same = self.is_same_node(other);
        match (self.operation(), other.operation()) {
            _ if self.is(0) || other.is(1) => self,
            _ if other.is(0) || self.is(1) => other.clone(),
            _ if self.is(-1) => -other.clone(),
            _ if other.is(-1) => -self,
            (Operation::Root(radicand), _) if same => radicand.clone(),
            (Operation::Negate(a), Operation::Negate(b)) => a.clone() * b,
            _ => Self::record(Operation::Multiply(self, other.clone()), limits),
        }
    }
}

impl Div<&Self> for Expression {
    type Output = Self;

    fn div(self, other: &Self) -> Self {
        let limits = self.joined_limits(other);
        if other.known_sign() == Some(Equal) {
            return Self::record(Operation::Undefined, limits);
        }
        if let Some(quotient) = self.folded(other, |a, b| a / b) {
            return quotient;
        }
        let nonzero = other.known_sign().is_some();
        match () {
            () if other.is(1) || nonzero && self.is(0) => self,
            () if other.is(-1) => -self,
            () if nonzero && self.is_same_node(other) => {
                Self::from_rational(BigRational::one(), limits)
            }
            () => Self::record(Operation::Divide(self, other.clone()), limits),
        }
    }
}

impl Neg for Expression {
    type Output = Self;

    fn neg(self) -> Self {
        let limits = self.own_limits();
        if let Some(value) = self.rational() {
            return Self::from_rational(-value, limits);
        }
        if let Operation::Negate(inner) = self.operation() {
            return inner.clone();
        }
        Self::record(Operation::Negate(self), limits)
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
