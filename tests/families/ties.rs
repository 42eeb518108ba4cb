//! Which of two is hit first, where the times differ by as little as 1e-300
//! of them: the order decides the outcome.

use carom::scene::{Disc, SceneBuilder};
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::heading::{HEADINGS, Heading, nudges, power, ten_to, whole};
use super::verdict::{Case, lasting};

fn quotient(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

/// On the axis d0 comes from the left and d2 from the right towards d1, which
/// is at rest and lighter than d2. d0 touches it at 8, d2 at 8 (1 + e).
fn from_both_sides(heading: Heading, e: &BigRational) -> SceneBuilder {
    let right = whole(2) + whole(8) * (whole(1) + e);
    let unit = || heading.units(1);
    lasting(12)
        .disc(Disc::at(heading.at(-10, 0), unit()).velocity(heading.at(1, 0)))
        .disc(Disc::at(heading.at(0, 0), unit()))
        .disc(
            Disc::at(heading.point(&right, &whole(0)), unit())
                .velocity(heading.at(-1, 0))
                .mass(3),
        )
}

/// Of (1, 0, -1) with the masses 1, 1, 3: d0 and d1 change places, (0, 1, -1);
/// d1 and d2, which close in at 2: 1 - 2 · 3/4 · 2 = -2 and -1 + 2 · 1/4 · 2 = 0;
/// d0 and d1 change places again: (-2, 0, 0). Momentum -2, twice the energy 4.
fn left_first(case: SceneBuilder, heading: Heading) -> Case {
    let ends = [-2, 0, 0].map(|speed| [whole(speed), whole(0)]);
    Case::new(case, "d0 d1, d1 d2, d0 d1").leaving(heading, ends)
}

/// d1 and d2, which close in at 1: -3/2 and -1/2; d0 and d1 change places,
/// (-3/2, 1, -1/2); d1 and d2 close in at 3/2: 1 - 2 · 3/4 · 3/2 = -5/4 and
/// -1/2 + 2 · 1/4 · 3/2 = 1/4. Momentum -3/2 - 5/4 + 3/4 = -2, twice the energy
/// 9/4 + 25/16 + 3/16 = 4.
fn right_first(case: SceneBuilder, heading: Heading) -> Case {
    let ends = [quotient(-3, 2), quotient(-5, 4), quotient(1, 4)].map(|speed| [speed, whole(0)]);
    Case::new(case, "d1 d2, d0 d1, d1 d2").leaving(heading, ends)
}

/// At a tie, and where binary64 stores one, the lower names go first. It
/// stores d2 at 10 + 8 e: from e = 2^-54 downwards that is 10, as 10 has
/// neighbours at 2^-49. (Times a coordinate of the heading, up to 15, less.)
#[test]
fn on_a_line() {
    for heading in HEADINGS {
        let tied = left_first(from_both_sides(heading, &BigRational::zero()), heading);
        tied.check(&format!("{heading:?}"));
        for (k, e) in nudges((4..64).chain([100, 300])) {
            let scene = from_both_sides(heading, &e);
            let case = match e.is_negative() {
                false => left_first(scene, heading),
                true => right_first(scene, heading),
            };
            let case = match k {
                ..=44 => case,
                56.. => case.stored("d0 d1, d1 d2, d0 d1"),
                _ => case.plain_is_open(),
            };
            case.check(&format!("{heading:?} 2^-{k} {e}"));
        }
    }
}

/// The same, down to 1e-300.
#[test]
fn on_a_line_by_a_power_of_ten() {
    for exponent in [20, 50, 100, 200, 300] {
        let e = whole(1) / ten_to(exponent);
        for heading in HEADINGS {
            let scene = from_both_sides(heading, &e);
            left_first(scene, heading).check(&format!("{heading:?} 1e-{exponent}"));
            let scene = from_both_sides(heading, &-&e);
            let case = right_first(scene, heading).stored("d0 d1, d1 d2, d0 d1");
            case.check(&format!("{heading:?} -1e-{exponent}"));
        }
    }
}

/// What differs is the speed at which d2 comes: 1 - e, so that it is there at
/// 8/(1 - e).
#[test]
fn on_a_line_by_the_speed() {
    for heading in HEADINGS {
        for (k, e) in nudges([10, 20, 40, 60, 300].into_iter()) {
            let unit = || heading.units(1);
            let speed = -(whole(1) - &e);
            let last = Disc::at(heading.at(10, 0), unit()).mass(3);
            let scene = lasting(12)
                .disc(Disc::at(heading.at(-10, 0), unit()).velocity(heading.at(1, 0)))
                .disc(Disc::at(heading.at(0, 0), unit()))
                .disc(last.velocity(heading.point(&speed, &whole(0))));
            let [first, second] = ["d0 d1, d1 d2, d0 d1", "d1 d2, d0 d1, d1 d2"];
            let truth = if e.is_negative() { second } else { first };
            let case = Case::new(scene, truth);
            let case = if k < 50 { case } else { case.stored(first) };
            case.check(&format!("{heading:?} {k} {e}"));
        }
    }
}

/// A cue disc of radius 3 comes along the axis between two discs of radius 2.
/// It touches d1, at (4, 3), when it is at 0: the triangle 3-4-5. d2 at
/// (4 + e, -3) it touches at e, or would.
fn cue(heading: Heading, e: &BigRational) -> SceneBuilder {
    let target = |x: BigRational, y: i64| Disc::at(heading.point(&x, &whole(y)), heading.units(2));
    lasting(12)
        .disc(Disc::at(heading.at(-8, 0), heading.units(3)).velocity(heading.at(1, 0)))
        .disc(target(whole(4), 3))
        .disc(target(whole(4) + e, -3))
}

/// Of (1, 0) the part along n = (4, 3)/5 goes over to the disc that is hit:
/// 4/5 n = (16, 12)/25, and (9, -12)/25 is left. It approaches the other one,
/// for along n' = (4, -3)/5 it is 72/125: that goes over too, (288, -216)/625.
/// What is left is (-63, -84)/625, and parts from both. (For another e the
/// second normal is turned by about as much.)
fn cue_first_hits(name: usize, scene: SceneBuilder, heading: Heading) -> Case {
    let side = if name == 1 { 1 } else { -1 };
    let pair = |x: i64, y: i64, unit: i64| [quotient(x, unit), quotient(side * y, unit)];
    let rest = pair(-63, -84, 625);
    let mut hit = [pair(16, 12, 25), pair(288, -216, 625)];
    if name == 2 {
        hit.reverse();
    }
    let [first, second] = hit;
    let order = ["d0 d1, d0 d2", "d0 d2, d0 d1"][name - 1];
    Case::new(scene, order).leaving(heading, [rest, first, second])
}

/// Binary64 stores 4 + e to 2^-50, or to less by the heading, and computes the
/// times near 8 to a few units of 2^-49.
#[test]
fn of_a_cue_and_two_discs() {
    for heading in HEADINGS {
        let tied = cue_first_hits(1, cue(heading, &BigRational::zero()), heading);
        tied.check(&format!("{heading:?}"));
        for (k, e) in nudges((42..60).chain([100, 300])) {
            let name = if e.is_negative() { 2 } else { 1 };
            let case = cue_first_hits(name, cue(heading, &e), heading);
            let case = match k {
                ..=44 => case,
                57.. => case.stored("d0 d1, d0 d2"),
                _ => case.plain_is_open(),
            };
            case.check(&format!("{heading:?} {k} {e}"));
        }
    }
    // Far from a tie only the order is known from above.
    for heading in HEADINGS {
        for (k, e) in nudges(4..42) {
            let truth = ["d0 d1, d0 d2", "d0 d2, d0 d1"][usize::from(e.is_negative())];
            Case::new(cue(heading, &e), truth).check(&format!("{heading:?} {k}"));
        }
    }
}

/// Two bodies that share no disc meet at times that differ by 2^-k: their
/// order in the log is that of the times, as far as they are told apart.
#[test]
fn of_two_pairs() {
    for heading in HEADINGS {
        for (k, e) in nudges([20, 40, 60, 300].into_iter()) {
            let pair = |y: i64, gap: BigRational| {
                let first = Disc::at(heading.at(0, y), heading.units(1));
                let second = Disc::at(
                    heading.point(&(whole(2) + gap), &whole(y)),
                    heading.units(1),
                );
                [first.velocity(heading.at(1, 0)), second]
            };
            let scene = lasting(10).discs(pair(0, whole(8)));
            let scene = scene.discs(pair(9, whole(8) + &e));
            let [lower, upper] = ["d0 d1, d2 d3", "d2 d3, d0 d1"];
            let case = Case::new(scene, if e.is_negative() { upper } else { lower });
            let case = if k < 50 { case } else { case.stored(lower) };
            case.check(&format!("{heading:?} {k} {e}"));
        }
    }
}

/// Between two discs at rest, of which one is 2^-k nearer: it is touched at
/// 10 - 2^-k - √3 by a disc that would touch the other at 10 - √3. With
/// n = (√3, -1)/2 that leaves (1/4, √3/4), which approaches the other one, and
/// then (-1/8, √3/8).
#[test]
fn of_irrational_times() {
    for heading in HEADINGS {
        for k in [20, 40, 60, 100, 300, 1000] {
            let target =
                |x: BigRational, y: i64| Disc::at(heading.point(&x, &whole(y)), heading.units(1));
            let scene = lasting(12)
                .disc(Disc::at(heading.at(0, 0), heading.units(1)).velocity(heading.at(1, 0)))
                .disc(target(whole(10), 1))
                .disc(target(whole(10) - power(2, -k), -1));
            let case = Case::new(scene, "d0 d2, d0 d1");
            let case = if k < 50 {
                case
            } else {
                case.stored("d0 d1, d0 d2")
            };
            case.check(&format!("{heading:?} {k}"));
        }
    }
}
