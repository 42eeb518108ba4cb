//! A point and a circle: generic queries, those close to tangency and those
//! close to contact.

use carom::detect::{Encounter, meet_circle};
use carom::vec2::Vec2;
use num_traits::{Signed, Zero};
use proptest::prelude::*;

use super::exact::{Query, Truth, fraction};
use super::{unit, whole};
use crate::common::strategy::cases;

/// How the radius of a circle is chosen, given the motion.
#[derive(Clone, Copy, Debug)]
enum Reach {
    /// This part of the distance.
    Part(f64),
    /// The path's distance from the centre, but for this part of it.
    Tangent(f64),
    /// The distance, but for this part of it.
    Contact(f64),
}

/// A relative difference of either sign, down to 2^-60.
fn nudge() -> impl Strategy<Value = f64> {
    let size = (-60.0..-1.0).prop_map(f64::exp2);
    (size, prop::bool::ANY).prop_map(|(size, up)| if up { size } else { -size })
}

fn reach() -> impl Strategy<Value = Reach> {
    prop_oneof![
        (0.001..1.0).prop_map(Reach::Part),
        nudge().prop_map(Reach::Tangent),
        nudge().prop_map(Reach::Contact),
    ]
}

/// A number of either sign and a magnitude from 2^-20 to 2^20.
fn number() -> impl Strategy<Value = f64> {
    (1.0..2.0, -20..20, prop::bool::ANY).prop_map(|(part, exponent, up): (f64, i32, bool)| {
        let size = part * 2_f64.powi(exponent);
        if up { size } else { -size }
    })
}

fn query() -> impl Strategy<Value = Query> {
    let vector = || [number(), number()];
    (vector(), vector(), reach()).prop_map(|(offset, velocity, reach)| {
        let ([x, y], [u, v]) = (offset, velocity);
        let distance = x.hypot(y);
        let pass = (x * v - y * u).abs() / u.hypot(v);
        let reach = match reach {
            Reach::Part(part) => distance * part,
            Reach::Tangent(nudge) => pass * (1.0 + nudge),
            Reach::Contact(nudge) => distance * (1.0 + nudge),
        };
        Query {
            offset,
            velocity,
            reach,
        }
    })
}

fn compute(query: &Query) -> Option<Encounter<f64>> {
    let [offset, velocity] = [query.offset, query.velocity].map(Vec2::from);
    let Ok(met) = meet_circle(&offset, &velocity, &query.reach);
    met
}

/// Whether the sign of d·v is certain: its two products do not cancel by more
/// than their roundings.
fn approach_is_clear(query: &Query) -> bool {
    let ([x, y], [u, v]) = (query.offset, query.velocity);
    (x * u + y * v).abs() > 2.0 * f64::EPSILON * ((x * u).abs() + (y * v).abs())
}

/// Outside the circle the verdict is right where |δ| > 8u, and the error of the
/// time is at most 10u/δ + 9u²/g of it where δ ≥ 64u.
fn check_outside(query: &Query, truth: &Truth) -> Result<(), TestCaseError> {
    let met = compute(query);
    prop_assert_eq!(met.is_some(), truth.time.is_some());
    prop_assert!(met.as_ref().is_none_or(|met| !met.graze));
    let (Some(met), Some(time)) = (met, &truth.time) else {
        return Ok(());
    };
    if truth.gap.is_positive() && truth.discriminant >= whole(64) * unit() {
        let tangency = whole(10) * unit() / &truth.discriminant;
        let contact = whole(9) * unit() * unit() / &truth.gap;
        let error = (fraction(met.delay) - time).abs();
        prop_assert!(error <= (tangency + contact) * time, "{}", met.delay);
    }
    Ok(())
}

/// Inside, the verdict also takes an approach that is clear, and it is an impact
/// now where the gap is.
fn check_inside(query: &Query, truth: &Truth) -> Result<(), TestCaseError> {
    if !approach_is_clear(query) {
        return Ok(());
    }
    let met = compute(query);
    prop_assert_eq!(met.is_some(), truth.time.is_some());
    if truth.gap < -whole(9) * unit() * unit() {
        prop_assert!(met.is_none_or(|met| met.overlap && met.delay == 0.0));
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(10_000))]

    #[test]
    fn queries_are_within_their_bounds(query in query()) {
        let truth = query.solve();
        if truth.discriminant.abs() <= whole(8) * unit() {
            return Ok(());
        }
        match truth.gap.is_negative() {
            true => check_inside(&query, &truth)?,
            false => check_outside(&query, &truth)?,
        }
    }
}

/// In contact to the last bit the gap is zero, and so is the time.
#[test]
fn contact_is_now() {
    let query = Query {
        offset: [3.0, 4.0],
        velocity: [-1.0, 0.0],
        reach: 5.0,
    };
    assert!(query.solve().gap.is_zero());
    assert!(compute(&query).is_some_and(|met| met.overlap && met.delay == 0.0));
}
