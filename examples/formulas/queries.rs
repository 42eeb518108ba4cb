//! Queries of several kinds: generic ones, and those made to be difficult.

use std::ops::Range;

use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::exact::Query;
use crate::whole::Truth;

/// A kind of query.
pub(crate) struct Kind {
    /// What it is called.
    pub(crate) name: &'static str,
    /// Whether it is made to be difficult.
    pub(crate) is_near: bool,
    /// Makes one.
    pub(crate) make: fn(&mut ChaCha8Rng) -> Query,
}

/// All kinds.
pub(crate) const KINDS: [Kind; 6] = [
    Kind {
        name: "generic",
        is_near: false,
        make: |random| aimed(random, 100.0),
    },
    Kind {
        name: "1e4 radii away",
        is_near: false,
        make: |random| aimed(random, 1e4),
    },
    Kind {
        name: "1e8 radii away",
        is_near: false,
        make: |random| aimed(random, 1e8),
    },
    Kind {
        name: "near contact",
        is_near: true,
        make: near_contact,
    },
    Kind {
        name: "near tangent, nudged",
        is_near: true,
        make: nudged,
    },
    Kind {
        name: "near tangent, convergent",
        is_near: true,
        make: convergent,
    },
];

/// A vector of a length within a range, in any direction.
fn vector(random: &mut ChaCha8Rng, lengths: Range<f64>) -> [f64; 2] {
    let length = random.random_range(lengths);
    let angle = random.random_range(0.0..std::f64::consts::TAU);
    [length * angle.cos(), length * angle.sin()]
}

/// About `distance` radii away, with a path that passes the centre at up to two
/// radii.
fn aimed(random: &mut ChaCha8Rng, distance: f64) -> Query {
    let reach = random.random_range(0.5..2.0);
    let offset = vector(random, 0.5 * distance * reach..2.0 * distance * reach);
    let beside = vector(random, 0.0..2.0 * reach);
    let slowness = random.random_range(0.1..10.0) * distance;
    let velocity = [0, 1].map(|axis| (beside[axis] - offset[axis]) / slowness);
    Query {
        offset,
        velocity,
        reach,
    }
}

/// Outside by a few ulps, or by more up to 2^-20 of the radius, and approaching.
fn near_contact(random: &mut ChaCha8Rng) -> Query {
    let offset = vector(random, 0.5..2.0);
    let velocity = vector(random, 0.5..2.0);
    let approach = offset[0] * velocity[0] + offset[1] * velocity[1];
    let part = random.random_range(-60.0_f64..-20.0).exp2();
    let mut query = Query {
        offset,
        velocity: velocity.map(|speed| -speed * approach.signum()),
        reach: offset[0].hypot(offset[1]) * (1.0 - part),
    };
    while Truth::of(&query).gap() < 0.0 {
        query.reach = query.reach.next_down();
    }
    query
}

/// With a radius that is up to four ulps from making it a tangent pass.
fn nudged(random: &mut ChaCha8Rng) -> Query {
    let query = aimed(random, 10.0);
    let ([x, y], [u, v]) = (query.offset, query.velocity);
    let mut reach = (x * v - y * u).abs() / u.hypot(v);
    for _ in 0..random.random_range(0..=4) {
        reach = reach.next_up();
    }
    for _ in 0..random.random_range(0..=4) {
        reach = reach.next_down();
    }
    Query { reach, ..query }
}

/// Tangent but for some 2^-100: with whole v = (p, q) and a convergent h/k of
/// |v| = √(p² + q²), the moment h at the radius k. An offset (x, y) with
/// x q - y p = h is found by Euclid's algorithm.
fn convergent(random: &mut ChaCha8Rng) -> Query {
    loop {
        let [p, q] = [0, 1].map(|_| random.random_range(1_i64 << 20..1 << 23));
        let (gcd, [r, s]) = bezout(p, q);
        let norm = p * p + q * q;
        let root = norm.isqrt();
        if gcd != 1 || root * root == norm {
            continue;
        }
        let [h, k] = last_convergent(norm, root, 1 << 24);
        // r p + s q = 1, so that (h s, -h r) is one solution: all others differ by
        // multiples of (p, q). It is to approach from some lengths of v away.
        let [x, y] = [
            i128::from(h) * i128::from(s),
            -i128::from(h) * i128::from(r),
        ];
        let [p, q] = [p, q].map(i128::from);
        let along = (x * p + y * q).div_euclid(p * p + q * q);
        let away = along + i128::from(k) / i128::from(root) + 2 + random.random_range(0..100);
        return Query {
            offset: [(x - away * p) as f64, (y - away * q) as f64],
            velocity: [p as f64, q as f64],
            reach: k as f64,
        };
    }
}

/// The greatest common divisor of two numbers, and how it is made of them.
fn bezout(a: i64, b: i64) -> (i64, [i64; 2]) {
    let (mut old, mut new) = ((a, [1, 0]), (b, [0, 1]));
    while new.0 != 0 {
        let times = old.0 / new.0;
        let rest = [0, 1].map(|index| old.1[index] - times * new.1[index]);
        (old, new) = (new, (old.0 - times * new.0, rest));
    }
    old
}

/// The last convergent h/k of √norm with k below a limit.
fn last_convergent(norm: i64, root: i64, limit: i64) -> [i64; 2] {
    let (mut before, mut latest) = ([1, 0], [root, 1]);
    let (mut shift, mut divisor, mut digit) = (0, 1, root);
    loop {
        shift = digit * divisor - shift;
        divisor = (norm - shift * shift) / divisor;
        digit = (root + shift) / divisor;
        let next = [0, 1].map(|index| digit * latest[index] + before[index]);
        if next[1] >= limit {
            return latest;
        }
        (before, latest) = (latest, next);
    }
}
