//! Where walls end, and where they meet.

use carom::scene::{Disc, SceneBuilder};
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::heading::{HEADINGS, Heading, nudges, power, whole};
use super::verdict::{Case, lasting};

/// The exponents of nudges that binary64 resolves in every heading, and some
/// that round away.
const EXPONENTS: [i32; 7] = [1, 10, 20, 40, 60, 100, 300];

/// Whether binary64 stores a nudge of 2^-k.
fn is_stored(k: i32) -> bool {
    k <= 40
}

/// Two walls along the axis that share the end point (0, 0), and a disc that
/// comes onto it: it touches at (e, 1), after 2, with velocity (1, -1). There
/// is one impact, on what of the two is below the centre. For e > 0 the end
/// point would be touched too, later by some e²/2: once that is below 2^-53,
/// plain binary64 takes it for a tie, which the end of the lower wall wins.
fn onto_seam(heading: Heading, e: &BigRational) -> SceneBuilder {
    let start = heading.point(&(e - whole(2)), &whole(3));
    lasting(6)
        .disc(Disc::at(start, heading.units(1)).velocity(heading.at(1, -1)))
        .wall(heading.at(-10, 0), heading.at(0, 0))
        .wall(heading.at(0, 0), heading.at(10, 0))
}

#[test]
fn seams_are_no_bump() {
    for heading in HEADINGS {
        let at_seam = "d0 w0 to";
        let case = |e: &BigRational, truth: &str| {
            Case::new(onto_seam(heading, e), truth)
                .times([whole(2)])
                .leaving(heading, [[whole(1), whole(1)]])
        };
        case(&BigRational::zero(), at_seam).check(&format!("{heading:?}"));
        for (k, e) in nudges(EXPONENTS.into_iter()) {
            let truth = if e.is_negative() { "d0 w0" } else { "d0 w1" };
            let case = match k {
                _ if !is_stored(k) => case(&e, truth).stored(at_seam),
                21.. if e.is_positive() => case(&e, truth).plain(at_seam),
                _ => case(&e, truth),
            };
            case.check(&format!("{heading:?} {k} {e}"));
        }
    }
}

/// A disc that slides along the two walls in contact passes the seam without
/// an impact; so it does 2^-k above.
#[test]
fn seams_are_slid_over() {
    for heading in HEADINGS {
        for gap in EXPONENTS
            .map(|k| power(2, -k))
            .into_iter()
            .chain([whole(0)])
        {
            let start = heading.point(&whole(-5), &(whole(1) + &gap));
            let scene = lasting(12)
                .disc(Disc::at(start, heading.units(1)).velocity(heading.at(1, 0)))
                .wall(heading.at(-10, 0), heading.at(0, 0))
                .wall(heading.at(0, 0), heading.at(10, 0));
            Case::new(scene, "").check(&format!("{heading:?} {gap}"));
        }
    }
}

/// A wall that lies in the path is hit head-on at its end, at the radius from
/// it; and nearly so, if it lies to a side by e: the disc turns by little.
#[test]
fn ends_head_on() {
    for heading in HEADINGS {
        let scene = |e: &BigRational| {
            let [from, to] = [8, 20].map(|x| heading.point(&whole(x), &(whole(4) + e)));
            lasting(12)
                .disc(Disc::at(heading.at(0, 4), heading.units(1)).velocity(heading.at(1, 0)))
                .wall(from, to)
        };
        Case::new(scene(&BigRational::zero()), "d0 w0 from")
            .times([whole(7)])
            .leaving(heading, [[whole(-1), whole(0)]])
            .check(&format!("{heading:?}"));
        for (k, e) in nudges(EXPONENTS.into_iter()) {
            Case::new(scene(&e), "d0 w0 from").check(&format!("{heading:?} {k}"));
        }
    }
}

/// The foot of the perpendicular is exactly the wall's end, or beside it by e:
/// within the wall the interior is hit, beyond it still the end. The velocity
/// is reversed (beyond, nearly).
#[test]
fn feet_at_the_end() {
    for heading in HEADINGS {
        let scene = |e: &BigRational| {
            let start = heading.point(&(whole(4) + e), &whole(4));
            lasting(6)
                .disc(Disc::at(start, heading.units(1)).velocity(heading.at(0, -1)))
                .wall(heading.at(4, 0), heading.at(14, 0))
        };
        Case::new(scene(&BigRational::zero()), "d0 w0 from")
            .times([whole(3)])
            .leaving(heading, [[whole(0), whole(1)]])
            .check(&format!("{heading:?}"));
        for (k, e) in nudges(EXPONENTS.into_iter()) {
            let truth = if e.is_negative() {
                "d0 w0 from"
            } else {
                "d0 w0"
            };
            let case = Case::new(scene(&e), truth);
            let case = if is_stored(k) {
                case
            } else {
                case.stored("d0 w0 from")
            };
            case.check(&format!("{heading:?} {k} {e}"));
        }
    }
}

/// The end at which a disc comes along the diagonal of the triangle 3-4-5: it
/// touches when it is (4, 3)/5 of its radius 5 short of it, so after 4, with
/// n = (4, 3)/5 and (1, 0) - 2 (4/5) n = (-7, -24)/25.
#[test]
fn ends_obliquely() {
    for heading in HEADINGS {
        for (from, to, end) in [((8, 3), (8, 30), "from"), ((20, 12), (8, 3), "to")] {
            let [from, to] = [from, to].map(|(x, y)| heading.at(x, y));
            let scene = lasting(8)
                .disc(Disc::at(heading.at(0, 0), heading.units(5)).velocity(heading.at(1, 0)))
                .wall(from, to);
            let turned = [-7, -24].map(|n| BigRational::new(n.into(), 25.into()));
            Case::new(scene, &format!("d0 w0 {end}"))
                .times([whole(4)])
                .leaving(heading, [turned])
                .check(&format!("{heading:?}"));
        }
    }
}

/// Convex: two walls that form a tip turned towards the disc are one point,
/// under the name of the first, whatever the angle between them.
#[test]
fn tips() {
    for heading in HEADINGS {
        for (x, y) in [(12, 5), (4, 3), (1, 1), (3, 4), (1, 30)] {
            let tip = || heading.at(8, 0);
            let scene = lasting(12)
                .disc(Disc::at(heading.at(0, 0), heading.units(1)).velocity(heading.at(1, 0)))
                .wall(heading.at(8 + x, y), tip())
                .wall(tip(), heading.at(8 + x, -y));
            Case::new(scene, "d0 w0 to")
                .times([whole(7)])
                .leaving(heading, [[whole(-1), whole(0)]])
                .check(&format!("{heading:?} {x} {y}"));
        }
    }
}

/// Concave, at a right angle: along the diagonal both walls are hit at once;
/// nearer to one by e, that one first. The velocity is reversed in any case.
#[test]
fn right_angles() {
    for heading in HEADINGS {
        let scene = |e: &BigRational| {
            let start = heading.point(&(whole(4) + e), &whole(4));
            lasting(6)
                .disc(Disc::at(start, heading.units(1)).velocity(heading.at(-1, -1)))
                .wall(heading.at(0, 0), heading.at(30, 0))
                .wall(heading.at(0, 0), heading.at(0, 30))
        };
        let [lower, other] = ["d0 w0, d0 w1", "d0 w1, d0 w0"];
        let back = || [[whole(1), whole(1)]];
        Case::new(scene(&BigRational::zero()), lower)
            .times([whole(3), whole(3)])
            .leaving(heading, back())
            .check(&format!("{heading:?}"));
        for (k, e) in nudges(EXPONENTS.into_iter()) {
            let truth = if e.is_negative() { other } else { lower };
            let case = Case::new(scene(&e), truth).leaving(heading, back());
            let case = if is_stored(k) {
                case
            } else {
                case.stored(lower)
            };
            case.check(&format!("{heading:?} {k} {e}"));
        }
    }
}

/// Concave, at the angle φ of a Pythagorean triple: a disc comes along one
/// wall, 1 above it, and bounces its way out. The centre moves in a wedge of the
/// same angle; unfolded, its path is a straight line that crosses the rays k φ
/// below π, and the walls take turns. Of π/φ are 3.39, 4.88, 6.41, 7.96 and
/// 11.07. The last crossing, 1/sin(kφ) away from the tip, is at most at 51.
#[test]
fn wedges() {
    let triples = [(3, 4, 3), (4, 3, 4), (15, 8, 6), (12, 5, 7), (24, 7, 11)];
    for heading in HEADINGS {
        for (x, y, count) in triples {
            // The tip of the centre's wedge is at 1 above the wall, and where
            // the distance from the other wall is 1 too: at cot(φ/2) = (c + x)/y.
            let length = f64::from(x * x + y * y).sqrt() as i64;
            let tip = BigRational::new((length + i64::from(x)).into(), y.into());
            let start = heading.point(&(tip + whole(100)), &whole(2));
            let far = |n: i32| 10 * i64::from(n);
            let scene = lasting(200)
                .disc(Disc::at(start, heading.units(1)).velocity(heading.at(-1, 0)))
                .wall(heading.at(0, 0), heading.at(1000, 0))
                .wall(heading.at(0, 0), heading.at(far(x), far(y)));
            let names = ["d0 w1", "d0 w0"].repeat(6);
            Case::new(scene, &names[..count].join(", ")).check(&format!("{heading:?} {x} {y}"));
        }
    }
}
