//! Zeros in binary64: always an answer, by the signs that are computed.
//!
//! Values are computed by Horner's rule with the rounding errors carried along
//! (Graillat, Langlois, Louvet: Compensated Horner scheme, 2005), as if in twice
//! the digits, with coefficients scaled by powers of two so that nothing
//! overflows, and nothing vanishes that matters. With u = 2^-53 the sign is wrong
//! only where |f(t)| is below some 100 u² Σ |aᵢ| tⁱ: call f *faint* there.
//!
//! The result is the last bit of a change of sign: within one ulp of it, f is
//! zero or faint. A dip below zero is missed, and one that is none is seen, only
//! where f is faint at its deepest; a graze is one where f is computed as exactly
//! zero. So a zero is as close to the true one as faintness allows, for simple
//! ones usually within an ulp. No tolerance decides anything.
//!
//! A zero that is too small or too large for a normal number is taken for about
//! the least or the greatest one.

use std::cmp::Ordering::{self, Equal};
use std::convert::Infallible;

use super::{Descent, Polynomial, Roots, Zero, first_descent};

impl Roots for f64 {
    fn descent(f: &Polynomial<Self>) -> Result<Option<Descent<Self>>, Infallible> {
        Ok(first_descent(zeros(f)))
    }
}

/// All zeros above 0, in order.
fn zeros(f: &Polynomial<f64>) -> Vec<Zero<f64>> {
    match f.powers() {
        Some((lowest, highest)) if lowest < highest => {
            let slopes = zeros(&f.derivative());
            let signs = [lowest, highest].map(|power| order(f.0[power]));
            between(&Scaled::new(f), signs, &slopes)
        }
        _ => Vec::new(),
    }
}

/// The zeros of a polynomial, given those of its derivative.
fn between(f: &Scaled, [first, last]: [Ordering; 2], slopes: &[Zero<f64>]) -> Vec<Zero<f64>> {
    let stop = |slope: &Zero<f64>| (slope.place, f.sign(slope.place));
    let [start, end] = f.bounds();
    let (mut start, mut before) = (start, first);
    let (mut zeros, mut touched) = (Vec::new(), None);
    for (stop, after) in slopes.iter().map(stop).chain([(end, last)]) {
        if after == Equal {
            touched = touched.or(Some(stop));
            continue;
        }
        let crossed = (after != before).then(|| f.crossing([start, stop], before));
        if let Some(place) = touched.take().or(crossed) {
            zeros.push(Zero {
                place,
                before,
                after,
            });
        }
        (start, before) = (stop, after);
    }
    zeros
}

fn order(number: f64) -> Ordering {
    number.partial_cmp(&0.0).unwrap_or(Equal)
}

/// A polynomial whose coefficients are numbers around 1 times powers of two.
struct Scaled {
    mantissas: [f64; 5],
    exponents: [i32; 5],
}

/// A polynomial of `t = place / 2^exponent`, but for a power of two.
struct View {
    coefficients: [f64; 5],
    exponent: i32,
}

/// The value of a polynomial, in two words, and its slope.
struct Value {
    head: f64,
    tail: f64,
    slope: f64,
}

/// Terms that are smaller than the largest one by this power of two, or more,
/// make no difference.
const NEGLIGIBLE: i32 = -900;

/// So many powers of two around its own a view serves for.
const REACH: i32 = 40;

impl Scaled {
    fn new(f: &Polynomial<f64>) -> Self {
        let parts = f.0.map(split);
        Self {
            mantissas: parts.map(|(mantissa, _)| mantissa),
            exponents: parts.map(|(_, exponent)| exponent),
        }
    }

    /// The powers whose coefficients are not zero.
    fn powers(&self) -> impl DoubleEndedIterator<Item = usize> {
        (0..5).filter(|&power| self.mantissas[power] != 0.0)
    }

    /// Normal numbers between which there are all zeros that are such, by
    /// Fujiwara's bound.
    fn bounds(&self) -> [f64; 2] {
        let exponent = |own: usize| {
            let others = self.powers().filter(|&other| other != own);
            let root = |other: usize| {
                let size = self.exponents[other] + 1 - self.exponents[own];
                size.div_euclid(other.abs_diff(own) as i32) + 3
            };
            others.map(root).max().unwrap_or_default()
        };
        let ends = [self.powers().next(), self.powers().next_back()];
        let [low, high] = ends.map(|power| power.map_or(0, exponent));
        [-low, high].map(|exponent| power_of_two(exponent.clamp(-1022, 1023)))
    }

    /// The polynomial around a place, scaled such that its largest term there is
    /// around 1.
    fn view(&self, place: f64) -> View {
        // The inverse of the power of two has to be a normal number too.
        let exponent = split(place).1.min(1022);
        let sizes: [i32; 5] =
            std::array::from_fn(|power| self.exponents[power] + power as i32 * exponent);
        let largest = self.powers().map(|power| sizes[power]).max().unwrap_or(0);
        let coefficients = std::array::from_fn(|power| match sizes[power] - largest {
            // Where the mantissa is zero the size means nothing.
            size @ NEGLIGIBLE..=0 => self.mantissas[power] * power_of_two(size),
            _ => 0.0,
        });
        View {
            coefficients,
            exponent,
        }
    }

    fn sign(&self, place: f64) -> Ordering {
        self.view(place).at(place).sign()
    }

    /// Where the sign changes, once, between two places, at the first of which it
    /// is `before`: by Newton's method as long as its steps shrink, and by halves.
    fn crossing(&self, [mut low, mut high]: [f64; 2], before: Ordering) -> f64 {
        let mut place = middle(low, high);
        let (mut view, mut step) = (self.view(place), high - low);
        loop {
            if !view.serves(place) {
                view = self.view(place);
            }
            let value = view.at(place);
            match value.sign() {
                Equal => return place,
                sign if sign == before => low = place,
                _ => high = place,
            }
            if low.next_up() >= high {
                break;
            }
            let next = advised(view.newton(place, &value), [low, high]);
            let shorter = (next - place).abs() <= step / 2.0;
            step = if shorter {
                (next - place).abs()
            } else {
                high - low
            };
            place = if shorter { next } else { middle(low, high) };
        }
        self.view(low).nearer(low, high)
    }
}

impl View {
    fn serves(&self, place: f64) -> bool {
        (split(place).1 - self.exponent).abs() < REACH
    }

    fn t(&self, place: f64) -> f64 {
        place * power_of_two(-self.exponent)
    }

    fn at(&self, place: f64) -> Value {
        let (t, zero) = (self.t(place), Value::ZERO);
        let terms = self.coefficients.iter().rev();
        terms.fold(zero, |value, a| value.times_plus(t, *a))
    }

    /// Where the tangent is zero.
    fn newton(&self, place: f64, value: &Value) -> f64 {
        (self.t(place) - value.sum() / value.slope) * power_of_two(self.exponent)
    }

    /// That of two neighbours where the value is smaller.
    fn nearer(&self, low: f64, high: f64) -> f64 {
        let [below, above] = [low, high].map(|place| self.at(place).sum().abs());
        if below <= above { low } else { high }
    }
}

impl Value {
    const ZERO: Self = Self {
        head: 0.0,
        tail: 0.0,
        slope: 0.0,
    };

    /// A step of Horner's rule, for the value and for the slope.
    #[inline]
    fn times_plus(self, t: f64, a: f64) -> Self {
        let product = self.head * t;
        let lost = self.head.mul_add(t, -product);
        let head = product + a;
        let of_a = head - product;
        let rest = (product - (head - of_a)) + (a - of_a);
        Self {
            head,
            tail: self.tail * t + (lost + rest),
            slope: self.slope * t + self.head,
        }
    }

    fn sum(&self) -> f64 {
        self.head + self.tail
    }

    fn sign(&self) -> Ordering {
        order(self.sum())
    }
}

/// Where to look next: where Newton's method says; beside an end that it stays at;
/// and half way if it leads astray.
fn advised(next: f64, [low, high]: [f64; 2]) -> f64 {
    let is_at = |end: f64| (next - end).abs() <= 4.0 * f64::EPSILON * end;
    if low < next && next < high {
        next
    } else if is_at(low) {
        low.next_up()
    } else if is_at(high) {
        high.next_down()
    } else {
        middle(low, high)
    }
}

/// Half way between two positive numbers, in the order of binary64 numbers:
/// first by their exponents, then by their mantissas.
fn middle(low: f64, high: f64) -> f64 {
    f64::from_bits(low.to_bits().midpoint(high.to_bits()))
}

/// A number from 1 to 2, with its sign, and an exponent; or zero.
fn split(number: f64) -> (f64, i32) {
    if number == 0.0 {
        return (0.0, 0);
    }
    let biased = (number.to_bits() >> 52 & 0x7ff) as i32;
    if biased == 0 {
        let (mantissa, exponent) = split(number * power_of_two(100));
        return (mantissa, exponent - 100);
    }
    let fraction = number.to_bits() & !(0x7ff << 52);
    (f64::from_bits(fraction | 1023 << 52), biased - 1023)
}

/// 2^`exponent`, a normal number.
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}
