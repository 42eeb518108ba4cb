//! A disc and the end of a wall, which is at the origin.

use carom::scene::generate::Random;

use super::{Body, Pair, Situation, at, between, radius, ratio, rounding, trimmed, whole};

pub(super) const SITUATIONS: [Situation; 6] = [
    Situation {
        name: "aim",
        count: 600,
        draw: aim,
    },
    Situation {
        name: "axis",
        count: 150,
        draw: axis,
    },
    Situation {
        name: "foot",
        count: 250,
        draw: foot,
    },
    Situation {
        name: "graze",
        count: 300,
        draw: graze,
    },
    Situation {
        name: "touch",
        count: 150,
        draw: touch,
    },
    Situation {
        name: "overlap",
        count: 50,
        draw: overlap,
    },
];

/// From the left, at all heights at which the end may be met; the wall leads away.
fn aim(random: &mut Random) -> Pair {
    let radius = radius(random);
    let start = -&radius - between(random, 0, 9);
    let height = trimmed(&radius * between(random, -5, 5) * ratio(1, 4));
    let velocity = [between(random, 1, 9), between(random, -1, 1) * ratio(1, 8)];
    let disc = Body::moving([start, height], velocity, radius);
    let to = [random.whole(1, 9), random.whole(-5, 5)].map(whole);
    Pair::with_wall(random, to, disc)
}

/// Along the wall's own line.
fn axis(random: &mut Random) -> Pair {
    let radius = radius(random);
    let start = -&radius - between(random, 0, 9);
    let velocity = [between(random, -1, 9), whole(0)];
    let disc = Body::moving([start, whole(0)], velocity, radius);
    let to = at(random.whole(1, 9), 0);
    Pair::with_wall(random, to, disc)
}

/// Down onto the end: the foot is exactly there, or a little beside it.
fn foot(random: &mut Random) -> Pair {
    let radius = radius(random);
    let (time, fall) = (random.whole(1, 8), whole(random.whole(1, 4)));
    let drift = whole(random.whole(-2, 2));
    let height = &radius + &fall * whole(time);
    let x = -&drift * whole(time) + random.tiny(20, 70);
    let disc = Body::moving([x, height], [drift, -fall], radius);
    let to = at(random.whole(1, 9), 0);
    Pair::with_wall(random, to, disc)
}

/// Past the end, at tangency or almost.
fn graze(random: &mut Random) -> Pair {
    let reach = whole(random.whole(1, 6));
    let radius = &reach + random.tiny(20, 70);
    let start = -&reach - between(random, 1, 9);
    let velocity = [between(random, 1, 5), whole(0)];
    let disc = Body::moving([start, reach], velocity, radius);
    let to = at(random.whole(-4, 4), -random.whole(1, 6));
    Pair::with_wall(random, to, disc)
}

/// In contact with the end, or as far from it as rounding puts it.
fn touch(random: &mut Random) -> Pair {
    let radius = radius(random);
    let apart = &radius + rounding(random);
    let velocity = [random.whole(-2, 2), random.whole(-2, 2)].map(whole);
    let disc = Body::moving([-apart, whole(0)], velocity, radius);
    let to = [random.whole(0, 9), random.whole(1, 5)].map(whole);
    Pair::with_wall(random, to, disc)
}

/// Over the end; once in four the centre is on it.
fn overlap(random: &mut Random) -> Pair {
    let radius = radius(random);
    let apart = &radius * ratio(random.whole(0, 3), 4);
    let velocity = [random.whole(-2, 2), random.whole(-2, 2)].map(whole);
    let disc = Body::moving([-apart, whole(0)], velocity, radius);
    let to = [random.whole(0, 9), random.whole(1, 5)].map(whole);
    Pair::with_wall(random, to, disc)
}
