//! The time of a meeting: bounds, and all that it takes to know it exactly.

use std::cmp::Ordering::{self, Greater, Less};
use std::convert::Infallible;

use super::course::{Course, Ray};
use super::exact;
use super::float::{Float, Twofold};
use super::screen::{self, Rounded};
use super::surd::Surd;
use crate::kernel::Time;
use crate::scalar::{Dyadic, Filtered, Interval, Rounding};
use crate::vec2::Vec2;

/// The time of a meeting.
#[derive(Clone, Debug)]
pub struct Moment {
    lo: f64,
    hi: f64,
    course: Course,
    /// What has been found out when it came.
    sharp: Option<Sharp>,
}

/// A time to two words, and rounded.
#[derive(Clone, Copy, Debug)]
struct Sharp {
    /// Since the start of the course.
    delay: Rounded<Twofold>,
    nearest: f64,
}

impl Moment {
    #[inline]
    fn within([lo, hi]: [f64; 2], course: Course) -> Self {
        Self {
            lo,
            hi,
            course,
            sharp: None,
        }
    }

    /// The time at which some course leads to a meeting, after about a delay.
    #[inline]
    pub(super) fn after(delay: Rounded<f64>, course: Course) -> Self {
        let start = course.start().unwrap_or_default();
        Self::within(delay.after(start).bounds(), course)
    }

    /// The exact time at which some course leads to a meeting.
    pub(super) fn of(time: &Surd, course: Course) -> Self {
        let nearest = time.to_f64();
        Self::within([nearest.next_down(), nearest.next_up()], course)
    }

    #[inline]
    fn known(time: f64) -> Self {
        Self::within([time, time], Course::Known)
    }

    /// The time exactly, unless it is a number.
    pub(super) fn surd(&self) -> Option<Surd> {
        exact::time(&self.course)
    }

    /// The time to two words, if these tell how it rounds.
    fn sharp(&self) -> Option<Sharp> {
        if let Some(sharp) = &self.sharp {
            return Some(*sharp);
        }
        let start = self.course.start()?;
        let delay: Rounded<Twofold> = screen::delay(&self.course)?;
        let time = delay.after(start);
        let nearest = time.value.nearest(time.error)?;
        Some(Sharp { delay, nearest })
    }

    /// The nearest binary64 number.
    fn nearest(&self) -> f64 {
        let exact = || self.surd().map_or(self.lo, |time| time.to_f64());
        self.sharp().map_or_else(exact, |sharp| sharp.nearest)
    }

    /// How long a disc has been in flight then, to two words.
    fn flown(&self, disc: &Ray) -> Option<Rounded<Twofold>> {
        match self.course.start() {
            Some(start) => Some(self.sharp()?.delay.since(start, disc.since)),
            None => Some(Rounded {
                value: Twofold::difference(self.lo, disc.since),
                error: 0.0,
            }),
        }
    }

    /// Where a disc is then, rounded.
    pub(super) fn place_of(&self, disc: &Ray) -> Vec2<Filtered> {
        let quick = self.flown(disc).and_then(|flown| {
            let [x, y] = disc
                .after(flown)
                .map(|place| place.value.nearest(place.error));
            Some(Vec2::new(Filtered::new(x?), Filtered::new(y?)))
        });
        quick.unwrap_or_else(|| match self.surd() {
            Some(time) => disc.rounded_at(&time),
            None => disc.at(self.lo).rounded(),
        })
    }

    fn order_exactly(&self, other: &Self) -> Ordering {
        match (self.surd(), other.surd()) {
            (Some(one), Some(two)) => one.order(&two),
            (Some(one), None) => one.order_to(&Dyadic::from_f64(other.lo)),
            (None, Some(two)) => two.order_to(&Dyadic::from_f64(self.lo)).reverse(),
            (None, None) => self.lo.total_cmp(&other.lo),
        }
    }
}

impl Time<Filtered> for Moment {
    #[inline]
    fn at(time: Filtered) -> Self {
        Self::known(time.get())
    }

    fn after(since: &Filtered, delay: Filtered) -> Self {
        Self::known((*since + delay).get())
    }

    #[inline]
    fn order(&self, other: &Self) -> Result<Ordering, Infallible> {
        Ok(if self.hi < other.lo {
            Less
        } else if self.lo > other.hi {
            Greater
        } else {
            self.order_exactly(other)
        })
    }

    #[inline]
    fn order_to(&self, time: &Filtered) -> Result<Ordering, Infallible> {
        self.order(&Self::known(time.get()))
    }

    fn order_to_rest(&self, end: &Filtered, begun: &Filtered) -> Result<Ordering, Infallible> {
        let rest = (*end - begun).get();
        if self.hi < rest.next_down() {
            return Ok(Less);
        }
        if self.lo > rest.next_up() {
            return Ok(Greater);
        }
        let rest = Dyadic::from_f64(end.get()).sub(&Dyadic::from_f64(begun.get()));
        Ok(match self.surd() {
            Some(time) => time.order_to(&rest),
            None => Dyadic::from_f64(self.lo).compare(&rest),
        })
    }

    #[inline]
    fn bounds(&self) -> Interval {
        Interval::new(self.lo, self.hi)
    }

    #[inline]
    fn value(&self) -> Filtered {
        Filtered::new(self.nearest())
    }

    fn value_after(&self, since: &Filtered) -> Filtered {
        let start = Dyadic::from_f64(since.get());
        Filtered::new(match self.surd() {
            Some(delay) => delay.plus(&start).to_f64(),
            None => start
                .add(&Dyadic::from_f64(self.lo))
                .to_f64(Rounding::Nearest),
        })
    }

    /// Rounding keeps the order: there is nothing to lift.
    #[inline]
    fn settled(self, _: &Filtered) -> Self {
        let sharp = self.sharp();
        Self { sharp, ..self }
    }
}
