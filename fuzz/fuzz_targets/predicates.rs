//! Single decisions of filtered arithmetic against whole numbers: whether two
//! discs meet, when to the last bit, and which of two meetings comes first.
//! They must never differ.
#![no_main]

use std::cmp::Ordering;

use arbitrary::{Arbitrary, Unstructured};
use carom::body::{Disc, Mass};
use carom::filtered::Moment;
use carom::kernel::{Approach, Flight, Kernel, Met, Time};
use carom::scalar::Filtered;
use carom::vec2::Vec2;
use libfuzzer_sys::fuzz_target;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

fuzz_target!(|bytes: &[u8]| {
    let mut input = Unstructured::new(bytes);
    // An error is the end of the input.
    let _ = run(&mut input);
});

fn run(input: &mut Unstructured) -> arbitrary::Result<()> {
    let one = Query::new(input)?;
    let two = if bool::arbitrary(input)? {
        one.varied(input)?
    } else {
        Query::new(input)?
    };
    let met = [&one, &two].map(Query::check);
    if let [Some((a, exact_a)), Some((b, exact_b))] = met {
        let Ok(order) = a.time.order(&b.time);
        check_order(order, &exact_a, &exact_b);
    }
    Ok(())
}

/// Two discs in flight.
#[derive(Clone, Debug)]
struct Query {
    places: [[f64; 2]; 2],
    speeds: [[f64; 2]; 2],
    radii: [f64; 2],
    since: [f64; 2],
}

/// `a t² + 2 b t + c` of the time t since a start, which begins positive and
/// falls.
#[derive(Debug)]
struct Quadratic {
    a: BigRational,
    b: BigRational,
    c: BigRational,
    start: BigRational,
}

impl Query {
    /// Any two discs, or two that nearly touch or nearly miss each other.
    fn new(input: &mut Unstructured) -> arbitrary::Result<Self> {
        let mut query = Self {
            places: [pair(input)?, pair(input)?],
            speeds: [pair(input)?, pair(input)?],
            radii: [coordinate(input)?.abs(), coordinate(input)?.abs()],
            since: [0.0, coordinate(input)?.abs()],
        };
        let [x, y] = difference(query.places);
        let [vx, vy] = difference(query.speeds);
        let reach = match input.int_in_range(0..=3)? {
            0 => (x * vy - y * vx).abs() / vx.hypot(vy),
            1 => x.hypot(y),
            _ => return Ok(query.positive()),
        };
        query.since = [0.0; 2];
        query.radii = [nudged(reach / 2.0, input)?, nudged(reach / 2.0, input)?];
        Ok(query.positive())
    }

    /// Radii that a scene may have.
    fn positive(mut self) -> Self {
        let valid = |radius: f64| radius.is_finite() && radius > 1e-300;
        self.radii = self
            .radii
            .map(|radius| if valid(radius) { radius } else { 1.0 });
        self
    }

    /// Nearly the same.
    fn varied(&self, input: &mut Unstructured) -> arbitrary::Result<Self> {
        let mut other = self.clone();
        let disc = usize::from(bool::arbitrary(input)?);
        let number = match input.int_in_range(0..=2)? {
            0 => &mut other.places[disc][0],
            1 => &mut other.speeds[disc][1],
            _ => &mut other.radii[disc],
        };
        *number = nudged(*number, input)?;
        Ok(other.positive())
    }

    /// What is decided, which must be right, with the exact course.
    fn check(&self) -> Option<(Met<Moment>, Quadratic)> {
        let met = self.decide();
        let exact = self.quadratic();
        let approaches = exact.b.is_negative();
        let discriminant = &exact.b * &exact.b - &exact.a * &exact.c;
        let meets = approaches && !(exact.c.is_positive() && discriminant.is_negative());
        assert_eq!(met.is_some(), meets, "{self:?}");
        let met = met?;
        let is_now = !exact.c.is_positive();
        assert_eq!(met.overlap, is_now, "{self:?}");
        assert_eq!(met.graze, !is_now && discriminant.is_zero(), "{self:?}");
        if is_now {
            return None;
        }
        exact.check_nearest(met.time.value().get(), self);
        Some((met, exact))
    }

    fn decide(&self) -> Option<Met<Moment>> {
        let disc = |index: usize| Disc {
            position: Vec2::from(self.places[index].map(Filtered::new)),
            velocity: Vec2::from(self.speeds[index].map(Filtered::new)),
            radius: Filtered::new(self.radii[index]),
            mass: Mass::Finite(Filtered::new(1.0)),
            last: None,
        };
        let discs = [disc(0), disc(1)];
        let since = self.since.map(Filtered::new);
        let flight = |index: usize| Flight {
            disc: &discs[index],
            since: &since[index],
            pull: &(),
        };
        let Ok(met) = Filtered::meet_discs(&Approach {
            early: flight(0),
            late: flight(1),
            together: self.since[0] == self.since[1],
        });
        met
    }

    fn quadratic(&self) -> Quadratic {
        let [from, to] = self.places.map(|place| place.map(exact));
        let [early, late] = self.speeds.map(|speed| speed.map(exact));
        let wait = exact(self.since[1]) - exact(self.since[0]);
        let offset = [0, 1].map(|axis| &to[axis] - (&from[axis] + &early[axis] * &wait));
        let speed = [0, 1].map(|axis| &late[axis] - &early[axis]);
        let reach = exact(self.radii[0]) + exact(self.radii[1]);
        Quadratic {
            a: dot(&speed, &speed),
            b: dot(&offset, &speed),
            c: dot(&offset, &offset) - &reach * &reach,
            start: exact(self.since[1]),
        }
    }
}

impl Quadratic {
    /// Whether the smaller root is no earlier than a time.
    fn is_from(&self, time: &BigRational) -> bool {
        let t = time - &self.start;
        let value = &self.a * &t * &t + &self.b * &t * BigInt::from(2) + &self.c;
        let is_before_middle = &self.a * &t <= -&self.b;
        is_before_middle && !value.is_negative()
    }

    fn is_at(&self, time: &BigRational) -> bool {
        let t = time - &self.start;
        let value = &self.a * &t * &t + &self.b * &t * BigInt::from(2) + &self.c;
        &self.a * &t <= -&self.b && value.is_zero()
    }

    /// The root lies between the two numbers half way to the neighbours.
    fn check_nearest(&self, time: f64, query: &Query) {
        let middle = |other: f64| (exact(time) + exact(other)) / BigInt::from(2);
        if time.abs() == f64::MAX {
            return;
        }
        let (low, high) = (middle(time.next_down()), middle(time.next_up()));
        assert!(self.is_from(&low), "{query:?}: {time} is late");
        assert!(
            !self.is_from(&high) || self.is_at(&high),
            "{query:?}: {time} is early"
        );
    }

    /// Bounds of the smaller root.
    fn bounds(&self, bits: u32) -> [BigRational; 2] {
        let discriminant = &self.b * &self.b - &self.a * &self.c;
        let unit = BigInt::one() << bits;
        let scaled = (discriminant.numer() * &unit * &unit) / discriminant.denom();
        let root = scaled.sqrt();
        [&root + BigInt::one(), root].map(|root| {
            let root = BigRational::new(root, unit.clone());
            &self.start + (-&self.b - root) / &self.a
        })
    }
}

/// The order found must be that of bounds, if these tell one.
fn check_order(found: Ordering, one: &Quadratic, two: &Quadratic) {
    let ([a, b], [c, d]) = (one.bounds(1200), two.bounds(1200));
    if b < c {
        assert_eq!(found, Ordering::Less, "{one:?} {two:?}");
    } else if a > d {
        assert_eq!(found, Ordering::Greater, "{one:?} {two:?}");
    }
}

fn pair(input: &mut Unstructured) -> arbitrary::Result<[f64; 2]> {
    Ok([coordinate(input)?, coordinate(input)?])
}

/// A small whole number, or any of moderate size, times a power of two.
fn coordinate(input: &mut Unstructured) -> arbitrary::Result<f64> {
    let number = match input.int_in_range(0..=3)? {
        0 => f64::from(i8::arbitrary(input)?),
        1 => f64::from(i32::arbitrary(input)?),
        _ => i64::arbitrary(input)? as f64 / 2f64.powi(60),
    };
    let power = match input.int_in_range(0..=7)? {
        0 => input.int_in_range(-320..=320)?,
        1 => input.int_in_range(-40..=40)?,
        _ => 0,
    };
    Ok(number * 2f64.powi(power))
}

fn nudged(number: f64, input: &mut Unstructured) -> arbitrary::Result<f64> {
    let ulps = input.int_in_range(-3..=3)?;
    let step = if ulps < 0 {
        f64::next_down
    } else {
        f64::next_up
    };
    Ok((0..i32::abs(ulps)).fold(number, |number, _| step(number)))
}

fn difference([from, to]: [[f64; 2]; 2]) -> [f64; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

fn exact(number: f64) -> BigRational {
    BigRational::from_float(number).expect("a finite number")
}

fn dot(a: &[BigRational; 2], b: &[BigRational; 2]) -> BigRational {
    &a[0] * &b[0] + &a[1] * &b[1]
}
