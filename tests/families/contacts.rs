//! Bodies that touch at the start, or overlap, or are apart, by next to
//! nothing; and what moves along them.

use carom::scene::{Disc, SceneBuilder};
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::heading::{HEADINGS, Heading, nudges, power, whole};
use super::verdict::{Case, lasting};

/// The exponents that are tried.
fn exponents() -> impl Iterator<Item = i32> {
    [1, 10, 20, 30, 40, 44, 60, 100, 300].into_iter()
}

/// Whether binary64 stores 2 - 2^-k in every heading; otherwise it stores 2.
fn is_stored(k: i32) -> bool {
    k <= 44
}

/// Two discs of radius 1 on the axis, 2 + gap apart, with velocities along and
/// across it.
fn pair(heading: Heading, gap: &BigRational, velocities: [[i64; 2]; 2]) -> SceneBuilder {
    let [first, second] = velocities.map(|[along, across]| heading.at(along, across));
    let place = heading.point(&(whole(2) + gap), &whole(0));
    lasting(4)
        .disc(Disc::at(heading.at(0, 0), heading.units(1)).velocity(first))
        .disc(Disc::at(place, heading.units(1)).velocity(second))
}

/// Velocities of two discs that part, move across, rest and move together.
const HARMLESS: [[[i64; 2]; 2]; 5] = [
    [[-1, 0], [1, 0]],
    [[0, 1], [0, -1]],
    [[0, 0], [0, 0]],
    [[1, 1], [1, 1]],
    [[-1, 2], [0, -3]],
];

/// An overlap of 2^-k is an impact at the start if it grows, and none
/// otherwise. What is less than binary64 stores, it takes for a contact.
#[test]
fn overlaps_of_discs() {
    for heading in HEADINGS {
        for k in exponents() {
            let overlap = -power(2, -k);
            let approaching = pair(heading, &overlap, [[1, 0], [-1, 0]]);
            let case = Case::new(approaching, "d0 d1, overlaps: 1").times([whole(0)]);
            let case = if is_stored(k) {
                case
            } else {
                case.stored("d0 d1")
            };
            case.check(&format!("{heading:?} {k}"));
            for velocities in HARMLESS {
                let case = Case::new(pair(heading, &overlap, velocities), "overlaps: 1");
                let case = if is_stored(k) { case } else { case.stored("") };
                case.check(&format!("{heading:?} {k} {velocities:?}"));
            }
        }
    }
}

/// The same of one unit in the last place of binary64 along the axis: there is
/// no smaller overlap of discs of radius 1.
#[test]
fn overlaps_of_one_ulp() {
    let heading = HEADINGS[0];
    let overlap = -power(2, -52);
    let approaching = pair(heading, &overlap, [[1, 0], [-1, 0]]);
    Case::new(approaching, "d0 d1, overlaps: 1").check("approaching");
    for velocities in HARMLESS {
        Case::new(pair(heading, &overlap, velocities), "overlaps: 1").check("harmless");
    }
}

/// Over a gap of 2^-k two discs that close in at 2 meet after 2^-k / 2; those
/// that touch meet at once. Others do not.
#[test]
fn gaps_of_discs() {
    for heading in HEADINGS {
        let gaps = exponents().map(|k| power(2, -k));
        for gap in gaps.chain([BigRational::zero()]) {
            let place = format!("{heading:?} {gap}");
            let approaching = pair(heading, &gap, [[1, 0], [-1, 0]]);
            Case::new(approaching, "d0 d1")
                .times([&gap / whole(2)])
                .leaving(heading, [-1, 1].map(|speed| [whole(speed), whole(0)]))
                .check(&place);
            for velocities in HARMLESS {
                Case::new(pair(heading, &gap, velocities), "").check(&place);
            }
        }
    }
}

/// Discs with the same centre have no direction to part in, whatever they do.
#[test]
fn concentric_discs() {
    for heading in HEADINGS {
        for velocities in [[[1, 0], [-1, 0]], [[0, 0], [0, 0]], [[1, 2], [1, 2]]] {
            let scene = pair(heading, &whole(-2), velocities);
            Case::new(scene, "overlaps: 1").check(&format!("{heading:?}"));
        }
    }
}

/// A disc over a wall along the axis, its lower edge so high above.
fn over_wall(heading: Heading, gap: &BigRational, [along, across]: [i64; 2]) -> SceneBuilder {
    let start = heading.point(&whole(0), &(whole(1) + gap));
    lasting(4)
        .disc(Disc::at(start, heading.units(1)).velocity(heading.at(along, across)))
        .wall(heading.at(-30, 0), heading.at(30, 0))
}

/// Resting on a wall, sliding along it, leaving it and landing on it, with gaps
/// and overlaps of 2^-k.
#[test]
fn walls() {
    for heading in HEADINGS {
        for (k, gap) in nudges(exponents()) {
            let place = format!("{heading:?} {k} {gap}");
            let overlaps = gap.is_negative();
            for velocity in [[0, 0], [3, 0], [-3, 0], [0, 1], [2, 1]] {
                let truth = if overlaps { "overlaps: 1" } else { "" };
                let case = Case::new(over_wall(heading, &gap, velocity), truth);
                let case = if is_stored(k) { case } else { case.stored("") };
                case.check(&place);
            }
            let truth = ["d0 w0", "d0 w0, overlaps: 1"][usize::from(overlaps)];
            let case = Case::new(over_wall(heading, &gap, [1, -1]), truth)
                .leaving(heading, [[whole(1), whole(1)]])
                .times([gap.max(whole(0))]);
            let case = if is_stored(k) {
                case
            } else {
                case.stored("d0 w0")
            };
            case.check(&place);
        }
        for velocity in [[0, 0], [3, 0], [-3, 0], [0, 1], [2, 1]] {
            let scene = over_wall(heading, &whole(0), velocity);
            Case::new(scene, "").check(&format!("{heading:?} {velocity:?}"));
        }
    }
}

/// On a wall along (3, 4) a disc of radius 1 rests at (-4/5, 3/5) from it, and
/// slides along. Binary64 stores (-0.8, 0.6) outwards of that: 0.8 is larger
/// than 4/5 by 2^-54.3, 0.6 smaller by 2^-55.3, so 4 · 0.8 + 3 · 0.6 > 5.
#[test]
fn sliding_where_numbers_round() {
    for velocity in [[0, 0], [3, 4], [-6, -8], [-4, 3]] {
        let scene = lasting(4)
            .disc(Disc::at(["-4/5", "3/5"], 1).velocity(velocity))
            .wall([-30, -40], [30, 40]);
        Case::new(scene, "").check(&format!("{velocity:?}"));
    }
}

/// Newton's cradle with gaps of 2^-k or none: the impulse goes from disc to
/// disc, and at last the last one leaves. The impacts are at 8 + i 2^-k. (Near
/// 2^-50, where coordinates of one disc are rounded up and of another down,
/// plain binary64 lets some overlap, and adds impacts.)
#[test]
fn cradles() {
    for heading in HEADINGS {
        let gaps = [10, 20, 30, 40, 50, 60, 100, 300].map(|k| power(2, -k));
        for gap in gaps.into_iter().chain([BigRational::zero()]) {
            let disc = |x: &BigRational| Disc::at(heading.point(x, &whole(0)), heading.units(1));
            let row = (0..5).map(|index| disc(&((whole(2) + &gap) * whole(index))));
            let scene = lasting(12)
                .disc(disc(&whole(-10)).velocity(heading.at(1, 0)))
                .discs(row);
            let names = ["d0 d1", "d1 d2", "d2 d3", "d3 d4", "d4 d5"].join(", ");
            let speeds = [0, 0, 0, 0, 0, 1].map(|speed| [whole(speed), whole(0)]);
            let case = Case::new(scene, &names)
                .times((0..5).map(|index| whole(8) + &gap * whole(index)))
                .leaving(heading, speeds);
            let is_borderline = gap == power(2, -50);
            let case = if is_borderline {
                case.plain_is_open()
            } else {
                case
            };
            case.check(&format!("{heading:?} {gap}"));
        }
    }
}

/// A channel as wide as the disc or by e wider on each side, in which it moves
/// from the start: there is nothing to hit, but overlaps if it is narrower.
#[test]
fn channels() {
    for heading in HEADINGS {
        let channel = |e: &BigRational| {
            let wall = |side: i64| {
                let height = whole(side) * (whole(1) + e);
                [-30, 30].map(|x| heading.point(&whole(x), &height))
            };
            let ([a, b], [c, d]) = (wall(1), wall(-1));
            let disc = Disc::at(heading.at(0, 0), heading.units(1));
            lasting(4)
                .disc(disc.velocity(heading.at(1, 0)))
                .wall(a, b)
                .wall(c, d)
        };
        Case::new(channel(&BigRational::zero()), "").check(&format!("{heading:?}"));
        for (k, e) in nudges(exponents()) {
            let truth = if e.is_negative() { "overlaps: 2" } else { "" };
            let case = Case::new(channel(&e), truth);
            let case = if is_stored(k) { case } else { case.stored("") };
            case.check(&format!("{heading:?} {k} {e}"));
        }
    }
}

/// A disc that comes to a channel as wide as itself, or wider, slides in.
#[test]
fn channels_that_begin_ahead() {
    for heading in HEADINGS {
        for gap in exponents().map(|k| power(2, -k)).chain([whole(0)]) {
            Case::new(mouth(heading, &(whole(1) + &gap)), "").check(&format!("{heading:?} {gap}"));
        }
    }
}

/// A disc that comes along the axis to a channel which begins at 8, with its
/// walls at this distance from the axis.
fn mouth(heading: Heading, height: &BigRational) -> SceneBuilder {
    let wall = |side: i64| [8, 30].map(|x| heading.point(&whole(x), &(whole(side) * height)));
    let ([a, b], [c, d]) = (wall(1), wall(-1));
    let disc = Disc::at(heading.at(0, 0), heading.units(1));
    lasting(12)
        .disc(disc.velocity(heading.at(1, 0)))
        .wall(a, b)
        .wall(c, d)
}

/// Into a channel that is too narrow it does not get: at the height cos θ it
/// touches both ends at once. The first response turns it by 2 θ towards the
/// other one, and so on: the angle from the tangent is θ, 3 θ, 5 θ, …, an impact
/// for each below π. For the Pythagorean cosines π/θ is 3.39, 4.88, 6.41, 7.96
/// and 11.07: there are 2, 2, 3, 4 and 6. For cos θ = 1/2 it is 3 exactly: after
/// one impact the disc moves along the tangent of the other end. (Heights that
/// are rounded may make the other end the first, for plain binary64; and rounded
/// velocities leave the tangent, to either side.)
#[test]
fn channels_that_are_too_narrow() {
    let cosines = [
        (3, 5, 2),
        (4, 5, 2),
        (15, 17, 3),
        (12, 13, 4),
        (24, 25, 6),
        (1, 2, 1),
    ];
    for heading in HEADINGS {
        for (x, length, count) in cosines {
            let height = BigRational::new(x.into(), length.into());
            let names = ["d0 w0 from", "d0 w1 from"].repeat(3);
            let case = Case::new(mouth(heading, &height), &names[..count].join(", "));
            let is_dyadic = length == 2;
            let case = if is_dyadic {
                case.filtered_is_open()
            } else {
                case.plain_is_open()
            };
            case.check(&format!("{heading:?} {x}/{length}"));
        }
    }
}
