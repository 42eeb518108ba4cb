//! What comes of a look ahead.

use super::Time;
use crate::detect::{Encounter, End};
use crate::scalar::{Interval, Scalar};

/// What a disc meets, and when.
#[derive(Clone, Debug)]
pub struct Met<T> {
    /// The time.
    pub time: T,
    /// Whether the two only pass in tangency, so that nothing changes.
    pub graze: bool,
    /// Whether they touch or overlap already.
    pub overlap: bool,
    /// Whether they overlap already, and do not only touch.
    pub inside: bool,
    /// Whether they touch and neither approach nor part, but are pressed together.
    pub rest: bool,
    /// The wall's end point that is touched, unless its interior is.
    pub end: Option<End>,
}

impl<T> Met<T> {
    /// A meeting of bodies that touch and approach, at a time.
    pub(crate) fn at_once<S: Scalar>(time: &S) -> Self
    where
        T: Time<S>,
    {
        Self {
            time: T::at(time.clone()),
            graze: false,
            overlap: true,
            inside: false,
            rest: false,
            end: None,
        }
    }

    /// What an encounter amounts to, seen from a time.
    #[inline]
    pub(crate) fn after<S: Scalar>(since: &S, encounter: Encounter<S>) -> Self
    where
        T: Time<S>,
    {
        Self {
            time: T::after(since, encounter.delay),
            graze: encounter.graze,
            overlap: encounter.overlap,
            inside: encounter.inside,
            rest: encounter.rest,
            end: encounter.end,
        }
    }
}

/// What can be told of a meeting before it is computed.
#[derive(Clone, Copy, Debug)]
pub enum Glance {
    /// The bodies do not meet.
    Clear,
    /// They do, apart now, within these bounds of the time; a wall at its end
    /// point, unless in its interior.
    Ahead(Interval, Option<End>),
    /// Nothing.
    Open,
}

impl Glance {
    /// What a meeting comes to.
    #[inline]
    pub(super) fn at<S: Scalar, T: Time<S>>(met: Option<Met<T>>) -> Self {
        match met {
            None => Self::Clear,
            Some(met) if met.graze || met.overlap => Self::Open,
            Some(met) => Self::Ahead(met.time.bounds(), met.end),
        }
    }
}
