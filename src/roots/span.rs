//! Where the sign of a function is not known, and how that is narrowed.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::enclosure::{Enclosure, Place};
use super::function::Function;

/// What is known of a function between two places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// It is of the same sign everywhere.
    Clear,
    /// It is monotone, and has one zero, which is simple.
    Simple,
    /// Nothing.
    Open,
}

/// A part of the positive numbers, ends included, and the signs on both sides.
#[derive(Clone, Debug)]
pub(super) struct Span<P> {
    pub(super) low: P,
    pub(super) high: P,
    pub(super) before: Ordering,
    pub(super) after: Ordering,
    pub(super) kind: Kind,
}

impl<P: Place> Span<P> {
    /// A place where the sign is known.
    pub(super) fn clear(low: P, high: P, sign: Ordering) -> Self {
        let (before, after, kind) = (sign, sign, Kind::Clear);
        Self {
            low,
            high,
            before,
            after,
            kind,
        }
    }

    /// A part of which the signs around are not yet known.
    pub(super) fn open(low: P, high: P) -> Self {
        let (before, after, kind) = (Equal, Equal, Kind::Open);
        Self {
            low,
            high,
            before,
            after,
            kind,
        }
    }

    /// A part in which a function comes down to zero, once.
    pub(super) fn falling(low: P, high: P) -> Self {
        Self {
            low,
            high,
            before: Greater,
            after: Less,
            kind: Kind::Simple,
        }
    }

    /// The same between places of another kind.
    pub(super) fn map<Q>(&self, change: impl Fn(&P) -> Q) -> Span<Q> {
        Span {
            low: change(&self.low),
            high: change(&self.high),
            before: self.before,
            after: self.after,
            kind: self.kind,
        }
    }

    /// The zero between two parts that are clear, or clear beside them.
    pub(super) fn between(left: &Self, right: &Self) -> Option<Self> {
        let (before, after) = (left.after, right.before);
        let (low, high) = (left.high.clone(), right.low.clone());
        let kind = Kind::Simple;
        (before != after).then_some(Self {
            low,
            high,
            before,
            after,
            kind,
        })
    }

    /// Encloses a simple zero more narrowly, by a step of the interval Newton
    /// method or else by halves; false if no more than this is known of the
    /// function.
    pub(super) fn narrow<E: Enclosure<Place = P>, F: Function<E>>(
        &mut self,
        f: &F,
        slope: &F,
    ) -> bool {
        let (low, high) = (self.low.clone(), self.high.clone());
        let middle = P::middle(&low, &high);
        let value = f.at(&E::at(&middle));
        let steep = slope.at(&E::between(&low, &high));
        if steep.sign().is_ok_and(Ordering::is_ne) {
            self.meet((E::at(&middle) - value.clone() / steep).ends());
        }
        let is_halved = |span: &Self| P::is_halved([&span.low, &span.high], [&low, &high]);
        if is_halved(self) {
            return low.order(&high).is_ne();
        }
        let ends = match value.sign() {
            Ok(Equal) => [middle.clone(), middle],
            Ok(sign) if sign == self.before => [middle, high.clone()],
            Ok(_) => [low.clone(), middle],
            Err(_) => return false,
        };
        let inner = ends[0].order(&low) == Greater || ends[1].order(&high).is_lt();
        self.meet(Some(ends));
        inner
    }

    /// Takes note of the sign at a place, if it is known.
    pub(super) fn learn(&mut self, place: &P, sign: Option<Ordering>) {
        let Some(sign) = sign.filter(|sign| sign.is_ne()) else {
            return;
        };
        let (low, high) = (self.low.clone(), self.high.clone());
        self.meet(Some(if sign == self.before {
            [place.clone(), high]
        } else {
            [low, place.clone()]
        }));
    }

    /// Leaves what is also between other ends.
    fn meet(&mut self, ends: Option<[P; 2]>) {
        let Some([low, high]) = ends else { return };
        if low.order(&self.low) == Greater {
            self.low = low;
        }
        if high.order(&self.high).is_lt() {
            self.high = high;
        }
    }
}
