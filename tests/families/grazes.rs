//! Passing by at the distance of contact, but for a relative 2^-k.
//!
//! In the frame of a heading a disc comes along the axis, from (0, 0) with
//! velocity (1, 0), and passes what it may touch at x = 8. Two discs of radius
//! 1 whose centres are to pass at the distance 2 + e meet if e < 0, graze if
//! e = 0, and pass if e > 0.
//!
//! The numbers of the scene stand in binary64 up to some 48 bits, less those
//! of the heading: from 2^-44 upwards plain binary64 must be right, as it
//! forms the discriminant from few products with little error. From 2^-56
//! downwards all the numbers round to those of e = 0, a graze.

use carom::scene::{Disc, DiscBuilder, SceneBuilder};
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::heading::{HEADINGS, Heading, nudges, power, whole};
use super::verdict::{Case, lasting};

/// The exponents that binary64 resolves, whatever the heading.
const RESOLVED: i32 = 44;

/// Those from which on it stores the scene of e = 0.
const ROUNDED: i32 = 56;

/// All exponents that are tried.
fn exponents() -> impl Iterator<Item = i32> {
    (1..64).chain((64..=300).step_by(59))
}

/// Checks a family of scenes with a distance 2^-k too large or too small:
/// what is met if it is too small, if it is right, and if it is too large.
fn check_family(
    scene: impl Fn(Heading, &BigRational) -> SceneBuilder,
    [closer, at, beyond]: [&str; 3],
) {
    for heading in HEADINGS {
        let exact = Case::new(scene(heading, &BigRational::zero()), at);
        exact.check(&format!("{heading:?}"));
        for (k, e) in nudges(exponents()) {
            let truth = if e.is_negative() { closer } else { beyond };
            let case = Case::new(scene(heading, &e), truth);
            let case = match k {
                ..=RESOLVED => case,
                ROUNDED.. => case.stored(at),
                _ => case.plain_is_open(),
            };
            case.check(&format!("{heading:?} {e}"));
        }
    }
}

fn projectile(heading: Heading) -> DiscBuilder {
    Disc::at(heading.at(0, 0), heading.units(1)).velocity(heading.at(1, 0))
}

#[test]
fn of_discs() {
    let scene = |heading: Heading, e: &BigRational| {
        let place = heading.point(&whole(8), &(whole(2) + e));
        lasting(16)
            .disc(projectile(heading))
            .disc(Disc::at(place, heading.units(1)))
    };
    check_family(scene, ["d0 d1", "grazes: 1", ""]);
}

/// The same, but what is too small or too large is the radius of the other.
#[test]
fn of_discs_by_the_radius() {
    let scene = |heading: Heading, e: &BigRational| {
        lasting(16)
            .disc(projectile(heading))
            .disc(Disc::at(heading.at(8, 2), heading.length(&(whole(1) - e))))
    };
    check_family(scene, ["d0 d1", "grazes: 1", ""]);
}

/// A wall across the path that ends at the distance 1 + e from it.
#[test]
fn of_a_wall_end() {
    let scene = |heading: Heading, e: &BigRational| {
        let end = heading.point(&whole(8), &(whole(1) + e));
        lasting(16)
            .disc(projectile(heading))
            .wall(end, heading.at(8, 9))
    };
    check_family(scene, ["d0 w0 from", "grazes: 1", ""]);
}

/// A wall along the path at the distance 1 + e. The disc slides onto it if
/// e = 0, which is no impact; closer it meets the end.
#[test]
fn of_a_wall_alongside_that_begins_ahead() {
    let scene = |heading: Heading, e: &BigRational| {
        let [from, to] = [4, 40].map(|x| heading.point(&whole(x), &(whole(1) + e)));
        lasting(16).disc(projectile(heading)).wall(from, to)
    };
    check_family(scene, ["d0 w0 from", "", ""]);
}

/// Beside the wall from the start, and along it: never an impact, but an
/// overlap if it is too close.
#[test]
fn of_a_wall_alongside_from_the_start() {
    let scene = |heading: Heading, e: &BigRational| {
        let [from, to] = [-40, 40].map(|x| heading.point(&whole(x), &(whole(1) + e)));
        lasting(16).disc(projectile(heading)).wall(from, to)
    };
    check_family(scene, ["overlaps: 1", "", ""]);
}

/// A wall whose line comes closer by s = 2^-k a unit and is at the height 1 at
/// x = 8: its distance is 1 where 1 + s (8 - x) = √(1 + s²), a bit before, and
/// the wall goes on to 12. From s = 2^-27 downwards the wall is for binary64
/// no longer than its extent in x, and is met all the same.
#[test]
fn of_a_wall_that_is_nearly_parallel() {
    for heading in HEADINGS {
        for k in (1..40).chain([60, 100, 300]) {
            let slope = power(2, -k);
            let height = |x: i64| whole(1) + &slope * whole(8 - x);
            let [from, to] = [-4, 12].map(|x| heading.point(&whole(x), &height(x)));
            let scene = lasting(11).disc(projectile(heading)).wall(from, to);
            let case = Case::new(scene, "d0 w0");
            let case = if k < 40 { case } else { case.stored("") };
            case.check(&format!("{heading:?} {k}"));
        }
    }
}

/// A gap between two posts that is as wide as the disc, or wider by twice
/// 2^-k: it grazes both at once, or passes through.
#[test]
fn of_two_posts() {
    let scene = |heading: Heading, e: &BigRational| {
        let post = |side: i64| {
            let place = heading.point(&whole(8), &(whole(side) * (whole(2) + e)));
            Disc::at(place, heading.units(1)).infinite_mass()
        };
        let scene = lasting(16).disc(projectile(heading));
        scene.disc(post(1)).disc(post(-1))
    };
    for heading in HEADINGS {
        let case = Case::new(scene(heading, &BigRational::zero()), "grazes: 2");
        case.check(&format!("{heading:?}"));
        for k in [1, 20, RESOLVED, ROUNDED, 300] {
            let case = Case::new(scene(heading, &power(2, -k)), "");
            let case = match k {
                ROUNDED.. => case.stored("grazes: 2"),
                _ => case,
            };
            case.check(&format!("{heading:?} {k}"));
        }
    }
}
