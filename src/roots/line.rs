//! Zeros of the gap to a line: a linear function c + b s + a r of what falls through
//! air.
//!
//! Its slope b e^(-k t) + a (1 - e^(-k t)) goes from b to a. If their signs differ it
//! is zero once, at the *turn*, where 1 - e^(-k t) = b / (b - a). So the signs of c, b
//! and a, and in two of the cases that of the gap at the turn, tell whether it comes
//! down to zero, and between which times it does so once:
//!
//! | c | b | a | |
//! |---|---|---|---|
//! | + | any | - | at any time |
//! | + | - | + | before the turn, if it is below zero there |
//! | - | + | - | after the turn, if it is above zero there |
//!
//! Where it is zero at first and rises, it counts as positive. The sign of b is asked
//! only where it makes a difference: a speed that is exactly nothing may be enclosed,
//! and have no sign.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::chain::doubt;
use super::enclosure::Place;
use super::fading::{Fades, Fading};
use super::function::Function;
use super::span::Span;
use crate::scalar::{Dyadic, Exact, Interval, Scalar, Undecided};

/// Two times between which something happens: the first one, unless it is 0, and the
/// last one, unless there is none.
type Stretch<S> = [Option<S>; 2];

impl<S: Fades> Fading<S> {
    /// Whether it is the gap to a line, towards or away from which something pulls.
    pub(super) fn is_linear(&self) -> bool {
        let [_, _, last, squares @ ..] = &self.terms;
        !last.is_surely_zero() && squares.iter().all(S::is_surely_zero)
    }

    /// When the gap to a line comes down to zero, once, if it does at all. So many
    /// derivatives are known to be zero at 0.
    pub(super) fn fall(&self, zeros: usize) -> Result<Option<Stretch<S>>, S::Doubt> {
        let [one, first, last, ..] = &self.terms;
        let is_above = zeros > 0 || one.sign()? == Greater;
        Ok(match (is_above, last.sign()?) {
            (true, Less) => Some([None, None]),
            (true, Greater) if matches!(first.sign(), Ok(Equal | Greater)) => None,
            (true, Greater) if self.stays_above() => None,
            (true, Greater) if first.sign()? == Less => {
                self.turning(Less)?.map(|turn| [None, Some(turn)])
            }
            (false, Less) if first.sign()? == Greater => {
                self.turning(Greater)?.map(|turn| [Some(turn), None])
            }
            _ => None,
        })
    }

    /// Whether bounds tell that a gap which grows in the end never gets to zero, though
    /// it may not grow at first: since s < 1 / k.
    fn stays_above(&self) -> bool {
        let [one, first, ..] = &self.terms;
        let least = one.hull() + first.hull() / self.rate.hull();
        least.lo() > 0.0
    }

    /// When the slope is zero, if the gap is of some sign there.
    fn turning(&self, sign: Ordering) -> Result<Option<S>, S::Doubt> {
        let [_, first, last, ..] = &self.terms;
        let part = first.clone() / (first.clone() - last);
        let turn = part.undecay() / &self.rate;
        let is_so = self.value(&turn).sign()? == sign;
        Ok(is_so.then_some(turn))
    }

    fn value(&self, time: &S) -> S {
        let x = time.clone() * &self.rate;
        self.of(&x.decay_and_lag().map(|part| part / &self.rate))
    }
}

impl Fading<f64> {
    /// Where the gap to a line comes down to zero, once, in a stretch: by Newton's
    /// method, as long as its steps get shorter, and by halves.
    pub(super) fn landing(&self, stretch: Stretch<f64>) -> f64 {
        let [mut low, mut high] = [
            stretch[0].unwrap_or(0.0),
            stretch[1].unwrap_or(self.end).min(f64::MAX),
        ];
        let guess = self.parabola();
        let is_within = low < guess && guess < high;
        let mut place = if is_within {
            guess
        } else {
            f64::middle(&low, &high)
        };
        let mut step = high - low;
        while low < place && place < high {
            let [value, slope] = self.value_and_slope(place);
            if value > 0.0 {
                low = place;
            } else {
                high = place;
            }
            let next = place - value / slope;
            let width = (next - place).abs();
            if width <= f64::EPSILON * place {
                return next;
            }
            let is_astray = !(low < next && next < high && width <= step / 2.0);
            (place, step) = if is_astray {
                (f64::middle(&low, &high), high - low)
            } else {
                (next, width)
            };
        }
        place
    }

    /// Where the parabola comes down to zero that is as it is at first, if anywhere.
    fn parabola(&self) -> f64 {
        let [one, first, last, ..] = self.terms;
        let bend = self.rate * (last - first);
        let root = (first * first - 2.0 * bend * one).sqrt();
        if first > 0.0 {
            (root + first) / -bend
        } else {
            2.0 * one / (root - first)
        }
    }

    fn value_and_slope(&self, time: f64) -> [f64; 2] {
        let [_, first, last, ..] = self.terms;
        let [fast, slow] = (time * self.rate).decay_and_lag();
        let value = self.of(&[fast, slow].map(|part| part / self.rate));
        [value, first + (last - first) * fast]
    }
}

/// The powers of two, relative to a time in binary64, within which its zero is looked
/// for.
const NEAR: [i32; 3] = [-44, -30, -16];

impl Fading<Exact> {
    /// An enclosure of where the gap to a line comes down to zero, once, in a stretch:
    /// about where it does in binary64, if bounds prove it.
    pub(super) fn enclosed_landing(
        &self,
        stretch: Stretch<Exact>,
    ) -> Result<Span<Dyadic>, Undecided> {
        let rounded = self.map(Exact::to_f64);
        let guess = rounded.landing(
            stretch
                .each_ref()
                .map(|end| end.as_ref().map(Exact::to_f64)),
        );
        let mut span = self.bounds(&stretch)?;
        let bounds = self.map(Exact::hull);
        for place in NEAR.iter().flat_map(|&power| around(guess, power)) {
            let sign = bounds.at(&Interval::point(place)).sign();
            span.learn(&Dyadic::from_f64(place), sign.ok());
        }
        Ok(span)
    }

    fn bounds(&self, [low, high]: &Stretch<Exact>) -> Result<Span<Dyadic>, Undecided> {
        let ends = |time: &Exact| time.ends().ok_or_else(|| doubt(time.precision()));
        let low = match low {
            Some(turn) => ends(turn)?[0].clone(),
            None => Dyadic::zero(),
        };
        let high = match high {
            Some(turn) => ends(turn)?[1].clone(),
            None => Dyadic::from_f64(self.end),
        };
        Ok(Span::falling(low, high))
    }
}

fn around(guess: f64, power: i32) -> [f64; 2] {
    let width = guess * f64::from(power).exp2();
    [guess - width, guess + width]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::chain::sharpen;
    use super::super::search::{Open, first_descent};
    use super::*;

    /// An end that all zeros of these functions are before: |a| t > |c| + (|a| + |b|) / k.
    const END: f64 = 4096.0;

    fn gap<S: Scalar>([c, b, a]: [i32; 3], halvings: i32, zeros: usize) -> Fading<S> {
        let two = S::from_integer(1 << halvings);
        let [c, b, a] = [if zeros > 0 { 0 } else { c }, b, a].map(S::from_integer);
        let [ss, sr, rr] = [(); 3].map(|()| S::from_integer(0));
        Fading {
            terms: [c, b, a, ss, sr, rr],
            rate: S::from_integer(1) / two,
            end: END,
        }
    }

    proptest! {
        /// By cutting the time into parts, which knows nothing of turns.
        #[test]
        fn lines_are_met_where_a_search_finds_them(
            c in -9..9_i32, b in -9..9_i32, a in -9..9_i32, halvings in 0..6, zeros in 0..2_usize,
        ) {
            prop_assume!(a != 0 && if zeros > 0 { b > 0 } else { c != 0 });
            let terms = [c, b, a];
            let f = gap::<Interval>(terms, halvings, zeros);
            let Ok(found) = first_descent(f.clone(), zeros, END, Open::Doubt) else {
                return Ok(());
            };
            let Ok(rounded) = f64::descent(&gap(terms, halvings, zeros), zeros);
            let exact = Exact::descent(&gap(terms, halvings, zeros), zeros).unwrap();
            prop_assert_eq!([rounded.is_some(), exact.is_some()], [found.is_some(); 2]);
            let (Some(mut span), Some(rounded), Some(exact)) = (found, rounded, exact) else {
                return Ok(());
            };
            sharpen(&mut span, &f);
            let bounds = exact.time.hull();
            prop_assert!(bounds.lo() <= span.high && span.low <= bounds.hi());
            prop_assert!((rounded.time - bounds.lo()).abs() < 1e-9 * bounds.lo());
        }
    }
}
