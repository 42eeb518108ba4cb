//! How far two bodies are from touching, as a function of time.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use crate::detect::Encounter;
use crate::scalar::Scalar;

pub(super) type Met<S> = Result<Option<Encounter<S>>, <S as Scalar>::Doubt>;

/// What is zero where two bodies touch, and positive where they are apart.
pub trait Gap<S: Scalar>: Sized {
    /// The sign of a derivative at the start, if those before are zero. The gap
    /// itself is the 0th.
    fn sign(&self, derivative: usize) -> Result<Ordering, S::Doubt>;

    /// When it comes down to zero from above, if so many derivatives are known to
    /// be zero at the start, and the next one is positive. Where the gap is
    /// negative at first it has to rise before.
    fn descent(&self, zeros: usize) -> Met<S>;

    /// When bodies meet that touch, if so many derivatives are known to be zero.
    /// If the first that is not is negative they approach, or would enter each
    /// other though they do not approach: one *rests* on the other.
    fn meet_from_contact(&self, zeros: usize) -> Met<S> {
        if zeros > LAST {
            return Ok(None);
        }
        match (self.sign(zeros)?, zeros) {
            (Less, 1) => Ok(Some(Encounter::now())),
            (Less, _) => Ok(Some(Encounter::rest())),
            (Equal, _) => self.meet_from_contact(zeros + 1),
            (Greater, _) => self.descent(zeros),
        }
    }
}

/// The last derivative that is looked at: at a fourth one, which would be that of
/// a circle about a body at rest, nothing falls.
const LAST: usize = 3;

/// The gap between a disc and a line on one side of it.
pub trait LineGap<S: Scalar>: Gap<S> {
    /// The same on the other side.
    #[must_use]
    fn negated(self) -> Self;

    /// The same, more by a length.
    #[must_use]
    fn raised(self, by: &S) -> Self;

    /// Whether it never becomes less, if so many derivatives are known to be zero
    /// at the start.
    fn only_grows(&self, zeros: usize) -> Result<bool, S::Doubt>;

    /// Bounds of how long it takes a disc that has just left the line to come back,
    /// if gravity takes it there.
    fn comes_back(&self) -> Option<[S; 2]>;
}

/// How long a disc bounces that has just hit a wall, of which the line is at such
/// a distance, if each impact leaves so much of its speed.
pub(super) fn bouncing<S: Scalar>(gap: &impl LineGap<S>, kept: &S) -> Option<[S; 2]> {
    let rest = S::from_integer(1) - kept;
    Some(gap.comes_back()?.map(|flown| flown / &rest))
}

/// A gap a t² + b t + c.
#[derive(Clone, Debug)]
pub struct Quadratic<S> {
    pub(super) a: S,
    pub(super) b: S,
    pub(super) c: S,
}

impl<S: Scalar> Gap<S> for Quadratic<S> {
    fn sign(&self, derivative: usize) -> Result<Ordering, S::Doubt> {
        match derivative {
            0 => self.c.sign(),
            1 => self.b.sign(),
            2 => self.a.sign(),
            _ => Ok(Equal),
        }
    }

    fn descent(&self, zeros: usize) -> Met<S> {
        match zeros {
            0 if self.c.sign()? == Less => self.descent_after_ascent(),
            0 => self.descent_from_above(),
            1 if self.a.sign()? == Less => {
                Ok(Some(Encounter::impact(self.b.clone() / -self.a.clone())))
            }
            _ => Ok(None),
        }
    }
}

impl<S: Scalar> LineGap<S> for Quadratic<S> {
    fn negated(self) -> Self {
        let Self { a, b, c } = self;
        let [a, b, c] = [-a, -b, -c];
        Self { a, b, c }
    }

    fn raised(self, by: &S) -> Self {
        let c = self.c + by;
        Self { c, ..self }
    }

    fn only_grows(&self, zeros: usize) -> Result<bool, S::Doubt> {
        Ok((zeros > 1 || self.b.sign()? != Less) && self.a.sign()? != Less)
    }

    fn comes_back(&self) -> Option<[S; 2]> {
        let falls = matches!(
            (self.a.sign(), self.b.sign()),
            (Ok(Less), Ok(Greater)) | (Ok(Greater), Ok(Less))
        );
        let flown = -self.b.clone() / &self.a;
        falls.then(|| [flown.clone(), flown])
    }
}

/// Which way it goes at first is asked only where that makes a difference: a speed that
/// is exactly nothing may be enclosed, and have no sign.
impl<S: Scalar> Quadratic<S> {
    /// When what is above zero comes to zero.
    fn descent_from_above(&self) -> Met<S> {
        let bends = self.a.sign()?;
        if bends != Less && matches!(self.b.sign(), Ok(Equal | Greater)) {
            return Ok(None);
        }
        let discriminant = self.discriminant();
        let sign = discriminant.sign()?;
        if sign == Less || bends != Less && self.b.sign()? != Less {
            return Ok(None);
        }
        if sign == Equal {
            return Ok(Some(Encounter::graze(self.turn())));
        }
        let root = discriminant.sqrt();
        Ok(Some(Encounter::impact(if self.b.to_f64() > 0.0 {
            self.late_root(root)
        } else {
            S::from_integer(2) * &self.c / (root - &self.b)
        })))
    }

    /// When what is below zero comes down to zero, from above.
    fn descent_after_ascent(&self) -> Met<S> {
        if self.a.sign()? != Less || matches!(self.b.sign(), Ok(Less | Equal)) {
            return Ok(None);
        }
        let discriminant = self.discriminant();
        if discriminant.sign()? != Greater || self.b.sign()? != Greater {
            return Ok(None);
        }
        Ok(Some(Encounter::impact(self.late_root(discriminant.sqrt()))))
    }

    /// b² - 4 a c.
    fn discriminant(&self) -> S {
        let four = S::from_integer(4) * &self.a;
        S::difference_of_products(&self.b, &self.b, &four, &self.c)
    }

    /// When it is least, or greatest.
    fn turn(&self) -> S {
        -self.b.clone() / (S::from_integer(2) * &self.a)
    }

    /// The later root of a quadratic that bends down.
    fn late_root(&self, root: S) -> S {
        (root + &self.b) / (S::from_integer(-2) * &self.a)
    }
}
