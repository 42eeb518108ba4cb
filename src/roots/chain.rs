//! Enclosures of all positive zeros of a polynomial.
//!
//! Where the derivative is not zero the polynomial is monotone: the signs at both
//! ends of such a piece tell whether there is a zero, and that it is simple.
//! What remains of the line are the [`Span`]s in which the derivative may be
//! zero. A polynomial that is of one sign all over such a span has no zero there,
//! and it does not matter what the derivative does. Otherwise the span is left
//! open, and widened until the signs beside it are certain.
//!
//! For a polynomial without multiple zeros, any enclosures of its coefficients
//! that are narrow enough leave nothing open. By induction along the chain: what
//! is open of the derivative shrinks to its zeros; where f is not zero at one of
//! them, it is of one sign in what is near enough; where it is, the zero is a
//! multiple one.

use std::cmp::Ordering::{self, Equal, Greater};

use super::Polynomial;
use super::enclosure::{Enclosure, Place};
use super::function::Function;
use super::span::{Kind, Span};
use crate::scalar::Undecided;

/// The bits that places are first enclosed with, where more can be had.
pub(super) const FIRST_BITS: u32 = 128;

type Spans<E> = Vec<Span<<E as Enclosure>::Place>>;

/// The first descent of a polynomial, if it is to a simple zero: what is not may
/// be one.
pub(super) fn first_crossing<E: Enclosure>(
    f: &Polynomial<E>,
) -> Result<Option<Span<E::Place>>, Undecided> {
    for span in spans(f)? {
        match span.kind {
            Kind::Simple if span.before == Greater => return Ok(Some(span)),
            Kind::Open => return Err(doubt(f.bits())),
            _ => {}
        }
    }
    Ok(None)
}

/// All parts of the positive numbers in which a polynomial has a zero, or may have
/// some, in order.
pub(super) fn spans<E: Enclosure>(f: &Polynomial<E>) -> Result<Spans<E>, Undecided> {
    let f = f.without_zero();
    if is_of_one_sign(&f) {
        return Ok(Vec::new());
    }
    let slope = f.derivative();
    let mut stops = vec![start(&f)?];
    for span in spans(&slope)? {
        stops.push(stop(&f, &slope, span));
    }
    stops.push(end(&f)?);
    Ok(zeros_of(settled(&f, stops)))
}

/// Encloses a simple zero as narrowly as the coefficients allow, or to as many
/// bits as they carry: by a few bits of them first, then by more.
pub(super) fn sharpen<E: Enclosure>(span: &mut Span<E::Place>, f: &impl Function<E>) {
    let (mut some, all) = (FIRST_BITS, f.bits());
    while some < all {
        // A step doubles what is known: from there on it would need more bits.
        sharpen_to(span, &f.rough(some), some * 3 / 4);
        some *= 2;
    }
    sharpen_to(span, f, all);
}

fn sharpen_to<E: Enclosure>(span: &mut Span<E::Place>, f: &impl Function<E>, bits: u32) {
    let slope = f.derivative();
    while !P::<E>::is_narrow([&span.low, &span.high], bits) && span.narrow(f, &slope) {}
}

type P<E> = <E as Enclosure>::Place;

/// That zeros are left open, with so many bits.
pub(super) fn doubt(bits: u32) -> Undecided {
    Undecided::new(bits, "where a gap closes")
}

/// By the signs of the coefficients, none of which is against another.
fn is_of_one_sign<E: Enclosure>(f: &Polynomial<E>) -> bool {
    let mut signs = f.0.iter().map(E::sign).filter(|sign| *sign != Ok(Equal));
    match signs.next() {
        Some(first) => first.is_ok() && signs.all(|sign| sign == first),
        None => true,
    }
}

/// The least exponent of each term, and the power of t that it goes with, but for
/// one.
fn other_ceilings<E: Enclosure>(
    f: &Polynomial<E>,
    power: usize,
) -> Result<Vec<(i64, i64)>, Undecided> {
    let others = (0..5).filter(|&other| other != power && !f.0[other].is_surely_zero());
    others
        .map(|other| {
            let ceiling = f.0[other].ceiling().ok_or_else(|| doubt(f.bits()))?;
            Ok((ceiling, (other as i64 - power as i64).abs()))
        })
        .collect()
}

/// The exponent of a power of two that is above all zeros of a polynomial, by
/// Fujiwara's bound, for the highest coefficient; or, for the lowest one, above
/// all inverses of them.
fn bound<E: Enclosure>(f: &Polynomial<E>, power: usize) -> Result<Option<i64>, Undecided> {
    let Some(floor) = f.0[power].floor() else {
        return Ok(None);
    };
    let ceilings = other_ceilings(f, power)?;
    let roots = ceilings
        .iter()
        .map(|(ceiling, distance)| (ceiling - floor).div_euclid(*distance));
    Ok(roots.max().map(|root| root + 3))
}

/// From 0 to where a polynomial is of the sign that it has just after 0; or to
/// where another term counts as much as a lowest one that may be zero.
fn start<E: Enclosure>(f: &Polynomial<E>) -> Result<Span<P<E>>, Undecided> {
    let sign = f.0[0].sign();
    if let (Some(exponent), Ok(sign)) = (bound(f, 0)?, sign) {
        return Ok(Span::clear(
            P::<E>::zero(),
            Place::power_of_two(-exponent),
            sign,
        ));
    }
    let ceiling = f.0[0].ceiling().ok_or_else(|| doubt(f.bits()))?;
    let ceilings = other_ceilings(f, 0)?;
    let roots = ceilings
        .iter()
        .map(|(other, distance)| (ceiling - other).div_euclid(*distance));
    let exponent = roots.min().unwrap_or_default();
    Ok(Span::open(P::<E>::zero(), Place::power_of_two(exponent)))
}

/// A place beyond all zeros.
fn end<E: Enclosure>(f: &Polynomial<E>) -> Result<Span<P<E>>, Undecided> {
    let highest = f.powers().map_or(0, |(_, highest)| highest);
    let exponent = bound(f, highest)?.ok_or_else(|| doubt(f.bits()))?;
    let place = P::<E>::power_of_two(exponent);
    Ok(Span::clear(place.clone(), place, f.0[highest].sign()?))
}

/// What a polynomial is where its slope may be zero.
fn stop<E: Enclosure>(
    f: &Polynomial<E>,
    slope: &Polynomial<E>,
    mut span: Span<P<E>>,
) -> Span<P<E>> {
    let (curvature, bits) = (slope.derivative(), f.bits());
    loop {
        if let Some(sign) = sign_over(f, slope, &span) {
            return Span::clear(span.low, span.high, sign);
        }
        let done = span.kind == Kind::Open || P::<E>::is_narrow([&span.low, &span.high], bits);
        if done || !span.narrow(slope, &curvature) {
            return Span::open(span.low, span.high);
        }
    }
}

/// The sign that a function has all over a span: plainly, or by the mean value
/// form.
pub(super) fn sign_over<E: Enclosure, F: Function<E>>(
    f: &F,
    slope: &F,
    span: &Span<P<E>>,
) -> Option<Ordering> {
    let certain = |value: E| value.sign().ok().filter(|sign| sign.is_ne());
    let all = E::between(&span.low, &span.high);
    certain(f.at(&all)).or_else(|| certain(value_over(f, slope, span)))
}

/// What a function is in a narrow span, in mean value form.
pub(super) fn value_over<E: Enclosure, F: Function<E>>(f: &F, slope: &F, span: &Span<P<E>>) -> E {
    let all = E::between(&span.low, &span.high);
    let middle = E::at(&P::<E>::middle(&span.low, &span.high));
    f.at(&middle) + slope.at(&all) * (all - middle)
}

/// The stops with certain signs on both sides: what is open grows, in monotone
/// pieces, until it has them, or takes in what is next.
fn settled<E: Enclosure>(f: &Polynomial<E>, stops: Spans<E>) -> Spans<E> {
    let mut settled: Spans<E> = Vec::new();
    for mut stop in stops {
        if let Some(last) = settled.pop() {
            let (last, joined) = grown(f, last, stop);
            settled.extend(last);
            stop = joined;
        }
        settled.push(stop);
    }
    settled
}

/// Two neighbours, of which each has grown towards the other if it was open;
/// they become one if nothing is certain between them.
fn grown<E: Enclosure>(
    f: &Polynomial<E>,
    mut left: Span<P<E>>,
    mut right: Span<P<E>>,
) -> (Option<Span<P<E>>>, Span<P<E>>) {
    if left.kind == Kind::Open {
        match certain_beyond(f, [&left.low, &left.high], &right.low) {
            Some((place, sign)) => (left.high, left.after) = (place, sign),
            None if right.kind == Kind::Open => {
                (right.low, right.before) = (left.low, left.before);
                return (None, right);
            }
            None => (left.high, left.after) = (right.low.clone(), right.before),
        }
    }
    if right.kind == Kind::Open {
        let limit = certain_beyond(f, [&right.high, &right.low], &left.high);
        (right.low, right.before) = limit.unwrap_or_else(|| (left.high.clone(), left.after));
    }
    (Some(left), right)
}

/// The first place found where a sign is certain, from one end of a span on, as
/// seen from the other, and before a limit.
fn certain_beyond<E: Enclosure>(
    f: &Polynomial<E>,
    [from, end]: [&P<E>; 2],
    limit: &P<E>,
) -> Option<(P<E>, Ordering)> {
    let direction = limit.order(end);
    let mut place = end.clone();
    loop {
        place = place.beyond(from, direction == Greater);
        if limit.order(&place) != direction || direction == Equal {
            return None;
        }
        if let Some(sign) = f.at(&E::at(&place)).sign().ok().filter(|sign| sign.is_ne()) {
            return Some((place, sign));
        }
    }
}

/// What is open, and the zeros between stops.
fn zeros_of<P: Place>(stops: Vec<Span<P>>) -> Vec<Span<P>> {
    let mut zeros = Vec::new();
    let mut stops = stops.into_iter().peekable();
    while let Some(stop) = stops.next() {
        let simple = stops.peek().and_then(|next| Span::between(&stop, next));
        zeros.extend((stop.kind == Kind::Open).then_some(stop));
        zeros.extend(simple);
    }
    zeros
}
