//! Numbers made from rationals by + - × ÷ and square roots, whose every
//! decision is a proof.
//!
//! An impact of rational data happens at a root of a quadratic, the next one at
//! a root of a quadratic over that: all of a run are such *constructible*
//! numbers. Enclosures tell their order unless they are equal. An
//! [`Expression`] decides that too. It asks, in this order:
//!
//! 1. the **enclosure** that it carries, and one of a few more bits, which
//!    shows most of what is only nearly zero;
//! 2. the **normal form**: what has the same one is equal;
//! 3. an **evaluation** of a few more bits, which shows what is only nearly
//!    zero; and where the separation bound asks for no more, zero as well;
//! 4. a **tower** of fields Q(√d1)(√d2)…: every new radicand is either proven
//!    to be a square, so that no radical is needed, or proven not to be one.
//!    In a true tower a number is zero exactly if its coefficients are. What
//!    is proven not to be zero shows its sign to an enclosure of enough bits;
//! 5. the **separation bound** of Burnikel, Funke, Mehlhorn, Schirra and
//!    Schmitt: a number closer to zero than that is zero.
//!
//! What is not settled within the [`Limits`] is
//! [`Undecided`](crate::scalar::Undecided), with the bits that were tried and
//! those that the bound asks for. Nothing is ever taken to be zero because it
//! looks so.
//!
//! What was proven about a number stays with it, for all that is made of it
//! later.
//!
//! # Examples
//!
//! A point moves on a circle of radius 1 and is seen to be there exactly:
//!
//! ```
//! use std::cmp::Ordering;
//! use carom::algebra::Expression;
//! use carom::scalar::Scalar;
//!
//! let root = |n| Expression::from_integer(n).sqrt();
//! let (x, y) = (root(6) - root(2), root(6) + root(2));
//! let power = x.square() + y.square() - Expression::from_integer(16);
//! assert_eq!(power.sign()?, Ordering::Equal);
//! # Ok::<(), carom::scalar::Undecided>(())
//! ```

mod ascent;
mod bound;
mod build;
mod decide;
mod element;
mod evaluate;
mod expression;
mod glance;
mod graph;
mod limits;
mod modular;
mod operators;
mod rational;
mod square;
mod term;
mod tower;

pub use expression::Expression;
pub use limits::Limits;

#[cfg(test)]
mod tests;
