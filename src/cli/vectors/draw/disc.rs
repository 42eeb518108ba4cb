//! A disc and another one, which is at rest at the origin.

use carom::scene::generate::Random;
use num_rational::BigRational;

use super::{Body, Other, Pair, Situation, at, between, radius, ratio, rounding, trimmed, whole};

pub(super) const SITUATIONS: [Situation; 6] = [
    Situation {
        name: "aim",
        count: 900,
        draw: aim,
    },
    Situation {
        name: "lattice",
        count: 350,
        draw: lattice,
    },
    Situation {
        name: "graze",
        count: 350,
        draw: graze,
    },
    Situation {
        name: "touch",
        count: 250,
        draw: touch,
    },
    Situation {
        name: "overlap",
        count: 100,
        draw: overlap,
    },
    Situation {
        name: "rest",
        count: 50,
        draw: rest,
    },
];

fn radii(random: &mut Random) -> [BigRational; 2] {
    [0, 1].map(|_| radius(random))
}

fn pair(disc: Body, radius: BigRational) -> Pair {
    Pair {
        disc,
        other: Other::Disc(Body::resting(radius)),
    }
}

/// Towards the other one, or by it: hits of all depths, and misses.
fn aim(random: &mut Random) -> Pair {
    let [radius, other] = radii(random);
    let reach = &radius + &other;
    let start = -&reach - between(random, 0, 9);
    let height = trimmed(reach * between(random, -5, 5) * ratio(1, 4));
    let velocity = [between(random, 1, 9), between(random, -1, 1) * ratio(1, 8)];
    pair(Body::moving([start, height], velocity, radius), other)
}

/// Small whole numbers.
fn lattice(random: &mut Random) -> Pair {
    let mut point = |bound: i64| [0, 1].map(|_| whole(random.whole(-bound, bound)));
    let (position, velocity) = (point(6), point(3));
    let [radius, other] = [0, 1].map(|_| whole(random.whole(1, 3)));
    pair(Body::moving(position, velocity, radius), other)
}

/// Past it, at tangency or almost.
fn graze(random: &mut Random) -> Pair {
    let reach = whole(random.whole(2, 6));
    let other = random.one_of(&[ratio(1, 2), whole(1), &reach - ratio(1, 4)]);
    let radius = &reach - &other + random.tiny(20, 70);
    let start = -&reach - between(random, 1, 9);
    let velocity = [between(random, 1, 5), whole(0)];
    pair(Body::moving([start, reach], velocity, radius), other)
}

/// In contact, or as far from it as rounding puts it, in any motion.
fn touch(random: &mut Random) -> Pair {
    let [radius, other] = radii(random);
    let apart = &radius + &other + rounding(random);
    let velocity = [random.whole(-2, 2), random.whole(-2, 2)].map(whole);
    pair(Body::moving([-apart, whole(0)], velocity, radius), other)
}

/// In each other, once in six with the same centre.
fn overlap(random: &mut Random) -> Pair {
    let [radius, other] = radii(random);
    let apart = (&radius + &other) * ratio(random.whole(0, 5), 6);
    let velocity = [random.whole(-2, 2), random.whole(-2, 2)].map(whole);
    pair(Body::moving([apart, whole(0)], velocity, radius), other)
}

/// Without any motion of one against the other.
fn rest(random: &mut Random) -> Pair {
    let [radius, other] = radii(random);
    let place = [between(random, -4, 4), between(random, -4, 4)];
    pair(Body::moving(place, at(0, 0), radius), other)
}
