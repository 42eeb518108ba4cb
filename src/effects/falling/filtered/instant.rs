//! The time of a meeting: bounds, and all that it takes to know it exactly.

use std::cmp::Ordering::{self, Greater, Less};
use std::convert::Infallible;

use super::body::{Body, Course, Parted};
use super::exact::{self, divided};
use super::parabola::Parabola;
use crate::detect::End;
use crate::effects::Falling;
use crate::effects::falling::segment::Touched;
use crate::filtered::Line;
use crate::kernel::Time;
use crate::roots::Polynomial;
use crate::roots::algebraic::Algebraic;
use crate::scalar::{Dyadic, Filtered, Interval, Rounding, Scalar};

/// The time of a meeting of bodies of which some fall.
#[derive(Clone, Debug)]
pub struct Instant {
    lo: f64,
    hi: f64,
    course: Course,
    /// The end point of a wall that is touched.
    end: Option<End>,
    /// Boxed, for most times never come.
    exact: Option<Box<Algebraic>>,
}

impl Instant {
    fn known(time: f64) -> Self {
        Self {
            lo: time,
            hi: time,
            course: Course::Known,
            end: None,
            exact: None,
        }
    }

    /// The time at which some course leads to a meeting, after about a delay.
    pub(super) fn after(course: Course, end: Option<End>, delay: Interval) -> Self {
        let time = point(course.start()) + delay;
        let (lo, hi) = (time.lo(), time.hi());
        Self {
            lo,
            hi,
            course,
            end,
            exact: None,
        }
    }

    /// The same after just that delay.
    pub(super) fn exactly_after(course: Course, end: Option<End>, delay: &Algebraic) -> Self {
        let time = delay.translated(&Dyadic::from_f64(course.start()));
        let bounds = time.hull();
        Self {
            lo: bounds.lo(),
            hi: bounds.hi(),
            course,
            end,
            exact: Some(Box::new(time)),
        }
    }

    /// The time exactly, unless it is a number.
    fn algebraic(&self) -> Option<Algebraic> {
        if let Some(exact) = &self.exact {
            return Some((**exact).clone());
        }
        let start = Dyadic::from_f64(self.course.start());
        let found = || exact::meeting(&self.course)?.delay.time().cloned();
        let delay = self.enclosed().or_else(found)?;
        Some(delay.translated(&start))
    }

    /// The delay as the only zero in the bounds, if that is plain.
    fn enclosed(&self) -> Option<Algebraic> {
        let delay = Interval::new(self.lo, self.hi) - point(self.course.start());
        let bounds = Interval::new(delay.lo().max(0.0), delay.hi());
        let f = match &self.course {
            Course::Known => return None,
            Course::Discs { pair, parted } => discs(pair, *parted),
            Course::Wall(disc, line, touched) => match self.end {
                None => interior(disc, line, *touched, &bounds)?,
                Some(end) => corner(disc, line, *touched, end),
            },
            Course::Leaving(disc, line) => leaving(disc, line, self.end?),
        };
        Algebraic::within(&f, bounds)
    }

    /// The value of a polynomial of the time since another one, rounded.
    fn value_of(&self, [c, b, a]: [f64; 3], since: f64) -> f64 {
        if b == 0.0 && a == 0.0 {
            return c;
        }
        let since = Dyadic::from_f64(since);
        let zero = Dyadic::zero;
        let [c, b, a] = [c, b, a].map(Dyadic::from_f64);
        let polynomial = Polynomial([c, b, a.halved(), zero(), zero()]);
        match self.algebraic() {
            Some(time) => time.translated(&-since).value_of(&polynomial),
            None => {
                let flown = Dyadic::from_f64(self.lo).sub(&since);
                polynomial.exactly_at(&flown).to_f64(Rounding::Nearest)
            }
        }
    }

    /// Where a disc is then, rounded.
    pub(super) fn place_of(&self, disc: &Body) -> [f64; 2] {
        [0, 1].map(|axis| {
            let way = [disc.position, disc.velocity, disc.pull].map(|vector| vector[axis]);
            self.value_of(way, disc.since)
        })
    }

    /// How fast it moves then, rounded.
    pub(super) fn speed_of(&self, disc: &Body) -> [f64; 2] {
        [0, 1].map(|axis| self.value_of([disc.velocity[axis], disc.pull[axis], 0.0], disc.since))
    }

    fn order_exactly(&self, other: &Self) -> Ordering {
        match (self.algebraic(), other.algebraic()) {
            (Some(one), Some(two)) => one.order(&two),
            (Some(one), None) => one.order_to(&Dyadic::from_f64(other.lo)),
            (None, Some(two)) => two.order_to(&Dyadic::from_f64(self.lo)).reverse(),
            (None, None) => self.lo.total_cmp(&other.lo),
        }
    }

    /// The nearest binary64 number, after another time.
    fn nearest_after(&self, since: f64) -> f64 {
        let since = Dyadic::from_f64(since);
        match self.algebraic() {
            Some(time) => time.translated(&since).to_f64(),
            None => since
                .add(&Dyadic::from_f64(self.lo))
                .to_f64(Rounding::Nearest),
        }
    }
}

/// The nearest binary64 bounds of a number.
fn hull(number: &Dyadic) -> Interval {
    let [lo, hi] = [Rounding::Down, Rounding::Up].map(|rounding| number.to_f64(rounding));
    Interval::new(lo, hi)
}

fn point(number: f64) -> Interval {
    Interval::new(number, number)
}

fn discs(pair: &[Body; 2], parted: Parted) -> Polynomial<Dyadic> {
    let [one, other] = pair.each_ref().map(|disc| Dyadic::from_f64(disc.radius));
    let gap = Parabola::between(pair).gap(&one.add(&other));
    divided(&gap, parted as usize)
}

/// What is zero when a disc touches the interior of a wall.
fn interior(
    disc: &Body,
    line: &Line,
    touched: Touched,
    bounds: &Interval,
) -> Option<Polynomial<Dyadic>> {
    let (side, _) = exact::sides(disc, line);
    if matches!(touched, Touched::Interior { .. }) {
        let then = side.polynomial().map(hull).at(bounds).sign().ok()?;
        if then == side.0[0].sign() {
            return Some(side.on(then).divided());
        }
    }
    let radius = Dyadic::from_f64(disc.radius);
    let reach_squared = radius.mul(&radius).mul(&line.along().squared());
    Some(side.squared_above(&reach_squared))
}

/// The same for an end point.
fn corner(disc: &Body, line: &Line, touched: Touched, end: End) -> Polynomial<Dyadic> {
    let gap = exact::end_gap(disc, line, end, &Dyadic::from_f64(disc.radius));
    let power = match touched {
        Touched::End { end: at, skims } if at == end => 1 + usize::from(skims),
        _ => 0,
    };
    divided(&gap, power)
}

/// What is zero when the foot gets to the end of a wall.
fn leaving(disc: &Body, line: &Line, end: End) -> Polynomial<Dyadic> {
    let place = exact::place(disc, line, end);
    match place.0[0].sign() {
        Greater => place.polynomial(),
        _ => place.divided(),
    }
}

impl Time<Falling<Filtered>> for Instant {
    #[inline]
    fn at(time: Falling<Filtered>) -> Self {
        Self::known(time.0.get())
    }

    fn after(since: &Falling<Filtered>, delay: Falling<Filtered>) -> Self {
        Self::known((since.0 + delay.0).get())
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

    fn order_to(&self, time: &Falling<Filtered>) -> Result<Ordering, Infallible> {
        self.order(&Self::known(time.0.get()))
    }

    fn order_to_rest(
        &self,
        end: &Falling<Filtered>,
        begun: &Falling<Filtered>,
    ) -> Result<Ordering, Infallible> {
        let [end, begun] = [end, begun].map(|time| Dyadic::from_f64(time.0.get()));
        let rest = end.sub(&begun);
        Ok(match self.algebraic() {
            Some(time) => time.order_to(&rest),
            None => Dyadic::from_f64(self.lo).compare(&rest),
        })
    }

    #[inline]
    fn bounds(&self) -> Interval {
        Interval::new(self.lo, self.hi)
    }

    fn value(&self) -> Falling<Filtered> {
        Falling::new(Filtered::new(self.nearest_after(0.0)))
    }

    fn value_after(&self, since: &Falling<Filtered>) -> Falling<Filtered> {
        Falling::new(Filtered::new(self.nearest_after(since.0.get())))
    }

    /// Rounding keeps the order: there is nothing to lift.
    fn settled(self, _: &Falling<Filtered>) -> Self {
        let exact = self.algebraic();
        let exact = exact.map(|time| Box::new(time.sharpened()));
        Self { exact, ..self }
    }
}
