//! A disc and the inside of a wall, which goes from the origin along the x axis.

use carom::scene::generate::Random;
use num_rational::BigRational;

use super::{Body, Pair, Situation, between, radius, ratio, rounding, trimmed, whole};

pub(super) const SITUATIONS: [Situation; 5] = [
    Situation {
        name: "aim",
        count: 750,
        draw: aim,
    },
    Situation {
        name: "lattice",
        count: 300,
        draw: lattice,
    },
    Situation {
        name: "along",
        count: 150,
        draw: along,
    },
    Situation {
        name: "touch",
        count: 200,
        draw: touch,
    },
    Situation {
        name: "overlap",
        count: 100,
        draw: overlap,
    },
];

/// A disc and a wall of some length.
fn pair(random: &mut Random, length: BigRational, disc: Body) -> Pair {
    Pair::with_wall(random, [length, whole(0)], disc)
}

/// Onto the wall, or beside it, from either side.
fn aim(random: &mut Random) -> Pair {
    let (radius, length) = (radius(random), whole(random.whole(1, 12)));
    let height = &radius + between(random, 0, 9);
    let fall = between(random, 1, 9);
    let drift = between(random, -2, 2);
    // Where it is when it is down, mostly on the wall.
    let foot = &length * (between(random, 0, 2) * ratio(5, 8) - ratio(1, 8));
    let x = trimmed(foot - &drift * (&height - &radius) / &fall);
    let side = whole(random.one_of(&[-1, 1]));
    let disc = Body::moving([x, height * &side], [drift, -fall * side], radius);
    pair(random, length, disc)
}

/// Small whole numbers.
fn lattice(random: &mut Random) -> Pair {
    let position = [random.whole(-2, 8), random.whole(-4, 4)].map(whole);
    let velocity = [random.whole(-3, 3), random.whole(-3, 3)].map(whole);
    let disc = Body::moving(position, velocity, whole(random.whole(1, 3)));
    let length = whole(random.whole(1, 8));
    pair(random, length, disc)
}

/// Beside the wall, in parallel or almost.
fn along(random: &mut Random) -> Pair {
    let radius = radius(random);
    let height = &radius + random.tiny(2, 60);
    let drop = random.tiny(10, 40);
    let velocity = [between(random, 1, 5), -drop];
    let start = between(random, -9, 3);
    let disc = Body::moving([start, height], velocity, radius);
    pair(random, whole(6), disc)
}

/// In contact with the inside, or as far from it as rounding puts it.
fn touch(random: &mut Random) -> Pair {
    let radius = radius(random);
    let height = &radius + rounding(random);
    let velocity = [random.whole(-2, 2), random.whole(-2, 2)].map(whole);
    let place = ratio(random.whole(1, 31), 4);
    let disc = Body::moving([place, height], velocity, radius);
    pair(random, whole(8), disc)
}

/// Through the wall; once in four the centre is on it.
fn overlap(random: &mut Random) -> Pair {
    let radius = radius(random);
    let height = &radius * ratio(random.whole(0, 3), 4);
    let velocity = [random.whole(-2, 2), random.whole(-2, 2)].map(whole);
    let place = ratio(random.whole(1, 31), 4);
    let disc = Body::moving([place, height], velocity, radius);
    pair(random, whole(8), disc)
}
