//! Air: its drag, -k v, takes every velocity to that of gravity's pull over k.
//!
//! A disc with the velocity v at first, that *tends* to another one, u, has moved
//! by v s + u r after a time t ([`Fading`]). What tends to the same moves straight
//! in relation to each other, in s. A body of infinite mass feels nothing: it moves
//! as what already has the velocity that it tends to.

use std::cmp::Ordering::{self, Less};

use super::Falling;
use super::gap::{Gap, LineGap, Met, Quadratic};
use super::medium::{Drag, Marker, Medium};
use super::trajectory::{Trajectory, length};
use crate::body::Disc;
use crate::detect::{Encounter, meet_circle};
use crate::roots::{Fades, Fading};
use crate::scalar::{Decay, Interval, Scalar};
use crate::vec2::Vec2;

/// What slows down in proportion to its speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Air {}

impl Marker for Air {}

/// The rate of a drag: by e each 1/rate.
#[derive(Clone, Debug)]
pub struct Rate<S>(pub(super) S);

impl<S: Scalar> Default for Rate<S> {
    fn default() -> Self {
        Self(S::from_integer(1))
    }
}

impl<S: Scalar> Drag<S> for Rate<S> {
    /// Between k (u - v), which it is at first, and nothing.
    fn acceleration(&self, pull: &Vec2<S>, disc: &Disc<S>) -> Vec2<Interval> {
        let gain = pull.minus(&disc.velocity).scaled(&self.0);
        gain.map(|gain| {
            let gain = gain.hull();
            Interval::new(gain.lo().min(0.0), gain.hi().max(0.0))
        })
    }
}

/// What pulls is the velocity that a body tends to.
impl<S: Fades> Medium<S> for Air {
    type Drag = Rate<Falling<S, Self>>;
    type Way = Drift<Falling<S, Self>>;

    fn way(
        offset: Vec2<Falling<S, Self>>,
        velocity: Vec2<Falling<S, Self>>,
        pull: &Vec2<Falling<S, Self>>,
        drag: &Self::Drag,
    ) -> Self::Way {
        Drift {
            offset,
            velocity,
            tends: pull.clone(),
            rate: drag.0.clone(),
        }
    }

    fn meet_falling(
        offset: &Vec2<Falling<S, Self>>,
        velocity: &Vec2<Falling<S, Self>>,
        reach: &Falling<S, Self>,
        drag: &Self::Drag,
    ) -> Met<Falling<S, Self>> {
        in_time(meet_circle(offset, velocity, reach)?, &drag.0)
    }
}

/// An encounter after some s, told in time; none if s never gets there.
fn in_time<S: Decay>(met: Option<Encounter<S>>, rate: &S) -> Met<S> {
    let met = match met {
        Some(met) if !met.overlap => met,
        at_once => return Ok(at_once),
    };
    let part = met.delay.clone() * rate;
    if part.compare(&S::from_integer(1))? != Less {
        return Ok(None);
    }
    let delay = part.undecay() / rate;
    Ok(Some(Encounter { delay, ..met }))
}

/// A way through air.
#[derive(Clone, Debug)]
pub struct Drift<S> {
    offset: Vec2<S>,
    velocity: Vec2<S>,
    /// The velocity that it tends to.
    tends: Vec2<S>,
    rate: S,
}

impl<S: Fades> Trajectory<S> for Drift<S> {
    type Line = Fading<S>;
    type Circle = Fading<S>;

    fn offset(&self) -> &Vec2<S> {
        &self.offset
    }

    fn velocity(&self) -> &Vec2<S> {
        &self.velocity
    }

    fn seen_from(&self, point: &Vec2<S>) -> Self {
        Self {
            offset: self.offset.minus(point),
            ..self.clone()
        }
    }

    fn at(&self, time: &S) -> Vec2<S> {
        let x = time.clone() * &self.rate;
        let [fast, slow] = x.decay_and_lag().map(|part| part / &self.rate);
        let offset = self.offset.moved(&self.velocity, &fast);
        offset.moved(&self.tends, &slow)
    }

    fn velocity_at(&self, time: &S) -> Vec2<S> {
        let lost = (time.clone() * &self.rate).decay();
        self.velocity
            .moved(&self.tends.minus(&self.velocity), &lost)
    }

    fn after(&self, time: &S) -> Self {
        Self {
            offset: self.at(time),
            velocity: self.velocity_at(time),
            ..self.clone()
        }
    }

    fn component(&self, of: impl Fn(&Vec2<S>) -> S) -> Fading<S> {
        let [one, fast, slow] = [&self.offset, &self.velocity, &self.tends].map(of);
        let end = last_zero(one.hull(), [fast.hull(), slow.hull()], self.rate.hull());
        let [ss, sr, rr] = [(); 3].map(|()| S::from_integer(0));
        Fading {
            terms: [one, fast, slow, ss, sr, rr],
            rate: self.rate.clone(),
            end,
        }
    }

    fn distance(&self, gap: S) -> Fading<S> {
        let Self {
            offset,
            velocity,
            tends,
            rate,
        } = self;
        let two = || S::from_integer(2);
        let lengths = [velocity, tends].map(length);
        Fading {
            terms: [
                gap,
                two() * offset.dot(velocity),
                two() * offset.dot(tends),
                velocity.norm_squared(),
                two() * velocity.dot(tends),
                tends.norm_squared(),
            ],
            rate: rate.clone(),
            end: last_zero(length(offset) + length(offset), lengths, rate.hull()),
        }
    }

    /// |v| t + |u| r, where r is less than t and than k t²/2.
    fn range(&self, time: Interval) -> Interval {
        let [from, to] = [&self.velocity, &self.tends].map(length);
        let slow = self.rate.hull() * time.square() / Interval::point(2.0);
        let slow = Interval::new(0.0, slow.hi().min(time.hi()));
        from * time + to * slow
    }
}

/// A time after which what moves as v s + u r is surely farther away than a
/// distance d: |u| t > d + (|v| + |u|) / k, since r is t - s, and s < 1/k. At least
/// twice that.
fn last_zero(distance: Interval, [fast, slow]: [Interval; 2], rate: Interval) -> f64 {
    let size = |bounds: Interval| Interval::point(bounds.magnitude());
    let [from, to] = [fast, slow].map(size);
    let slowest = Interval::point(slow.lo().max(-slow.hi()).max(0.0));
    let end = (size(distance) + (from + to) / rate) / slowest;
    2.0 * end.hi() + f64::MIN_POSITIVE
}

impl<S: Fades> Fading<S> {
    /// The gap as a quadratic of s, where it does not depend on r.
    fn straight(&self) -> Option<Quadratic<S>> {
        let [one, s, r, ss, sr, rr] = &self.terms;
        let is_straight = [r, sr, rr].into_iter().all(S::is_surely_zero);
        is_straight.then(|| Quadratic {
            a: ss.clone(),
            b: s.clone(),
            c: one.clone(),
        })
    }
}

impl<S: Fades> Gap<S> for Fading<S> {
    fn sign(&self, derivative: usize) -> Result<Ordering, S::Doubt> {
        let mut at = self.clone().with_zeros(derivative);
        for _ in 0..derivative {
            at = at.derivative();
        }
        at.terms[0].sign()
    }

    fn descent(&self, zeros: usize) -> Met<S> {
        if let Some(quadratic) = self.straight() {
            return in_time(quadratic.descent(zeros)?, &self.rate);
        }
        let met = S::descent(&self.clone().with_zeros(zeros), zeros)?;
        Ok(met.map(|met| Encounter {
            graze: met.graze,
            ..Encounter::impact(met.time)
        }))
    }
}

/// A linear function of s and r. Its slope goes from the coefficient of s, at
/// first, to that of r.
impl<S: Fades> LineGap<S> for Fading<S> {
    fn negated(self) -> Self {
        Self {
            terms: self.terms.map(|term| -term),
            ..self
        }
    }

    fn raised(mut self, by: &S) -> Self {
        self.terms[0] = self.terms[0].clone() + by;
        self
    }

    fn only_grows(&self, zeros: usize) -> Result<bool, S::Doubt> {
        let [_, first, last, ..] = &self.terms;
        Ok((zeros > 1 || first.sign()? != Less) && last.sign()? != Less)
    }

    /// At most as long as without drag, which takes 2 v / (k u): its way up is
    /// shorter, and x / (1 - e^-x) > 1 + x/2 for x = k t.
    fn comes_back(&self) -> Option<[S; 2]> {
        let [_, first, last, ..] = &self.terms;
        let signs = [first.sign().ok()?, last.sign().ok()?];
        let falls = signs[0].is_ne() && signs[1] == signs[0].reverse();
        let most = S::from_integer(-2) * first / (last.clone() * &self.rate);
        falls.then(|| [S::from_integer(0), most])
    }
}
