//! Decisions in floating point with an error bound.
//!
//! Each operation errs by at most a unit u times its result. The bounds below
//! count these (to first order, and then some to spare), in terms of the
//! magnitudes that enter: S, the sum of those of which the relative position is
//! the difference, and V, the sum of those of the relative velocity's
//! coordinates. So d·v and d × v, of which one may cancel, err by at most
//! 10 u S V, however small they come out; the discriminant
//! D = (v·v) R² - (d × v)² by 12 u (v·v) R² + 2 |d × v| E + E² + 3 u (d × v)²,
//! where E is that bound; the gap d·d - R² by 14 u (S² + R²). What cannot be told
//! with these bounds is left open, and so is everything beyond 2^±200, where
//! products may overflow or vanish.

use super::course::{Course, Line, Ray};
use super::float::{Float, LIMIT, Twofold, UNDERFLOW, is_moderate};
use crate::detect::End;

/// What floating point makes out.
#[derive(Clone, Copy, Debug)]
pub(super) enum Verdict<F> {
    /// The bodies do not meet.
    Apart,
    /// They meet, apart now, after a delay from where the later of the two is.
    After(Rounded<F>),
    /// It cannot tell.
    Open,
}

/// What of a wall a verdict is about: an end point, or the interior.
pub(super) type Place = Option<End>;

/// Where a body is from another one.
struct Offset<F> {
    x: F,
    y: F,
    /// The sum of the magnitudes that it is made of.
    size: f64,
}

/// A number, and the most that it may be from the true one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rounded<F> {
    pub(super) value: F,
    pub(super) error: f64,
}

impl<F: Float> Rounded<F> {
    #[inline]
    fn is_surely_above(self, limit: f64) -> bool {
        self.value.head() - limit > self.error
    }

    #[inline]
    fn is_surely_below(self, limit: f64) -> bool {
        limit - self.value.head() > self.error
    }

    /// The quotient of two positive numbers, the second known to a quarter.
    #[inline]
    fn divided_by(self, divisor: Self) -> Self {
        let value = self.value / divisor.value;
        let size = value.head();
        let error = 1.5 * (self.error + size * divisor.error) / divisor.value.head();
        Self {
            value,
            error: error + 4.0 * F::UNIT * size,
        }
    }

    /// The number, later by a time.
    #[inline]
    pub(super) fn after(self, start: f64) -> Self {
        let size = start.abs() + self.value.head().abs();
        Self {
            value: F::new(start) + self.value,
            error: self.error + 4.0 * F::UNIT * size,
        }
    }
}

impl Rounded<Twofold> {
    /// A delay from a start, as counted from another time.
    #[inline]
    pub(super) fn since(self, start: f64, other: f64) -> Self {
        let waited = Twofold::difference(start, other);
        let size = waited.head().abs() + self.value.head().abs();
        Self {
            value: waited + self.value,
            error: self.error + 2.0 * Twofold::UNIT * size,
        }
    }
}

impl Rounded<f64> {
    /// Binary64 bounds.
    #[inline]
    pub(super) fn bounds(self) -> [f64; 2] {
        [self.value - self.error, self.value + self.error]
    }
}

/// When a course that is known to lead to a meeting does so, as a delay.
pub(super) fn delay<F: Float>(course: &Course) -> Option<Rounded<F>> {
    let verdict = match course {
        Course::Known => return None,
        Course::Discs(pair) => discs(pair),
        Course::Point(disc, place) => point(disc, *place),
        Course::Wall(disc, line) => return Way::new(disc, line).delay(),
    };
    match verdict {
        Verdict::After(delay) => Some(delay),
        Verdict::Apart | Verdict::Open => None,
    }
}

/// Whether two discs that stand still are surely apart: each side of d·d > R² is
/// computed to 4 u of itself, unless it vanishes or overflows.
#[inline]
pub(super) fn are_apart([one, other]: [Ray; 2]) -> bool {
    let [x, y] = [0, 1].map(|place| other.position[place] - one.position[place]);
    let reach = one.radius + other.radius;
    let (distance, limit) = (x * x + y * y, reach * reach);
    let is_safe = distance.is_finite() && limit > UNDERFLOW;
    is_safe && distance > limit * (1.0 + 8.0 * f64::EPSILON)
}

/// Whether and when two discs meet, of which the second one is known since the
/// later time.
#[inline(always)]
pub(super) fn discs<F: Float>([early, late]: &[Ray; 2]) -> Verdict<F> {
    let flown = F::difference(late.since, early.since);
    let [ex, ey] = early.velocity.map(|speed| F::new(speed) * flown);
    let [sx, sy] = differences::<F>(late.position, early.position);
    let size = |a: F, b: F| a.head().abs() + b.head().abs();
    let offset = Offset {
        x: sx - ex,
        y: sy - ey,
        size: size(sx, ex) + size(sy, ey),
    };
    let velocity = differences(late.velocity, early.velocity);
    let reach = F::new(early.radius) + F::new(late.radius);
    circle(&offset, velocity, reach)
}

#[inline]
fn differences<F: Float>(one: [f64; 2], other: [f64; 2]) -> [F; 2] {
    [0, 1].map(|place| F::difference(one[place], other[place]))
}

/// Whether and when a disc meets a point.
#[inline]
fn point<F: Float>(disc: &Ray, point: [f64; 2]) -> Verdict<F> {
    let [x, y] = differences::<F>(disc.position, point);
    let offset = Offset {
        x,
        y,
        size: x.head().abs() + y.head().abs(),
    };
    circle(&offset, disc.velocity.map(F::new), F::new(disc.radius))
}

/// Whether and when a point enters a circle about the origin.
#[inline(always)]
fn circle<F: Float>(offset: &Offset<F>, [vx, vy]: [F; 2], reach: F) -> Verdict<F> {
    let Offset { x, y, size } = *offset;
    let speed = vx.head().abs() + vy.head().abs();
    if speed == 0.0 {
        return Verdict::Apart;
    }
    let approach = x * vx + y * vy;
    let error = 10.0 * F::UNIT * size * speed + UNDERFLOW;
    let is_safe = size < LIMIT && is_moderate(speed);
    if approach.head() > error && is_safe {
        return Verdict::Apart;
    }
    let span = reach.head();
    if !(approach.head() < -error && is_safe && is_moderate(span)) {
        return Verdict::Open;
    }
    let moment = x * vy - y * vx;
    let strength = (vx * vx + vy * vy) * reach * reach;
    let arm = moment.head().abs();
    let discriminant = Rounded {
        value: strength - moment * moment,
        error: F::UNIT * (12.0 * strength.head() + 3.0 * arm * arm) + (2.0 * arm + error) * error,
    };
    if discriminant.is_surely_below(0.0) {
        return Verdict::Apart;
    }
    let gap = Rounded {
        value: x * x + y * y - reach * reach,
        error: 14.0 * F::UNIT * (size * size + span * span),
    };
    let is_sharp = discriminant.is_surely_above(discriminant.value.head() / 2.0);
    if !(is_sharp && gap.is_surely_above(0.0)) {
        return Verdict::Open;
    }
    let root = discriminant.value.sqrt();
    let value = root - approach;
    let divisor = Rounded {
        value,
        error: discriminant.error / root.head() + error + 3.0 * F::UNIT * value.head(),
    };
    delay_of(gap, divisor).map_or(Verdict::Open, Verdict::After)
}

/// A delay, unless it is as good as unknown.
#[inline]
fn delay_of<F: Float>(gap: Rounded<F>, divisor: Rounded<F>) -> Option<Rounded<F>> {
    if !divisor.is_surely_above(0.75 * divisor.value.head()) {
        return None;
    }
    let delay = gap.divided_by(divisor);
    (delay.value.head() < LIMIT).then_some(delay)
}

/// A disc's way towards the line of a wall.
struct Way<F> {
    offset: [F; 2],
    along: [F; 2],
    velocity: [F; 2],
    /// The sums of the magnitudes of these.
    sizes: [f64; 3],
    /// The distance from the line less the radius, and how fast it falls, both
    /// times the wall's length.
    gap: Rounded<F>,
    closing: Rounded<F>,
    squared: F,
    /// Whether the side that it is on is certain, and nothing overflows.
    is_safe: bool,
}

impl<F: Float> Way<F> {
    #[inline]
    fn new(disc: &Ray, line: &Line) -> Self {
        let offset = differences::<F>(disc.position, line.from);
        let along = differences::<F>(line.to, line.from);
        let velocity = disc.velocity.map(F::new);
        let size = |[x, y]: [F; 2]| x.head().abs() + y.head().abs();
        let sizes @ [far, length, speed] = [offset, along, velocity].map(size);
        let (side, drift) = (cross(offset, along), cross(velocity, along));
        let is_left = side.head() < 0.0;
        let (distance, closing) = if is_left {
            (-side, drift)
        } else {
            (side, -drift)
        };
        let squared = dot(along, along);
        let reach = F::new(disc.radius) * squared.sqrt();
        let known = distance.head().abs() + reach.head();
        let [error, drift_error] = [far, speed].map(|size| 6.0 * F::UNIT * size * length);
        let is_aside = distance.head() > error;
        Self {
            offset,
            along,
            velocity,
            sizes,
            gap: Rounded {
                value: distance - reach,
                error: error + 7.0 * F::UNIT * known,
            },
            closing: Rounded {
                value: closing,
                error: drift_error,
            },
            squared,
            is_safe: is_aside && [far, length, speed, disc.radius].map(is_moderate) == [true; 4],
        }
    }

    /// The time until the disc touches the line.
    #[inline]
    fn delay(&self) -> Option<Rounded<F>> {
        let is_apart = self.is_safe && self.gap.is_surely_above(0.0);
        if !(is_apart && self.closing.is_surely_above(0.0)) {
            return None;
        }
        delay_of(self.gap, self.closing)
    }

    /// Whether it surely does not get closer to the line, from outside.
    #[inline]
    fn keeps_away(&self) -> bool {
        let recedes = self.closing.is_surely_below(0.0) || is_along(self.velocity, self.along);
        self.is_safe && self.gap.is_surely_above(0.0) && recedes
    }

    /// What of the wall is opposite the disc after a delay.
    #[inline]
    fn nearest_after(&self, delay: Rounded<F>) -> Option<Place> {
        let [far, length, speed] = self.sizes;
        let slope = dot(self.velocity, self.along);
        let (time, squared) = (delay.value.head(), self.squared.head());
        let foot = Rounded {
            value: dot(self.offset, self.along) + slope * delay.value,
            error: F::UNIT * (10.0 * length * (far + speed * time) + 8.0 * squared)
                + 1.5 * slope.head().abs() * delay.error,
        };
        if foot.is_surely_below(0.0) {
            Some(Some(End::From))
        } else if foot.is_surely_above(squared) {
            Some(Some(End::To))
        } else if foot.is_surely_above(0.0) && foot.is_surely_below(squared) {
            Some(None)
        } else {
            None
        }
    }
}

/// Whether and when a disc meets a wall, and where, but for the end points that
/// are `barred`.
#[inline]
pub(super) fn wall<F: Float>(
    disc: &Ray,
    line: &Line,
    barred: impl Fn(End) -> bool,
) -> (Verdict<F>, Place) {
    let way = Way::new(disc, line);
    if disc.velocity == [0.0; 2] || way.keeps_away() {
        return (Verdict::Apart, None);
    }
    let Some(delay) = way.delay() else {
        return (Verdict::Open, None);
    };
    match way.nearest_after(delay) {
        None => (Verdict::Open, None),
        Some(None) => (Verdict::After(delay), None),
        Some(Some(end)) if barred(end) => (Verdict::Apart, None),
        Some(Some(end)) => (point(disc, line.end(end)), Some(end)),
    }
}

/// Whether a velocity is surely parallel to a wall along an axis.
#[inline]
fn is_along<F: Float>(velocity: [F; 2], along: [F; 2]) -> bool {
    let is_zero = |number: F| number.head() == 0.0;
    let [vx, vy] = velocity.map(is_zero);
    let [ux, uy] = along.map(is_zero);
    (vx || uy) && (vy || ux)
}

#[inline]
fn dot<F: Float>(a: [F; 2], b: [F; 2]) -> F {
    a[0] * b[0] + a[1] * b[1]
}

#[inline]
fn cross<F: Float>(a: [F; 2], b: [F; 2]) -> F {
    a[0] * b[1] - a[1] * b[0]
}
