//! Mass ratios up to 10^40, and those for which the number of impacts is a
//! borderline case.

use carom::scene::{Disc, SceneBuilder};
use num_rational::BigRational;

use super::heading::{HEADINGS, Heading, number, ten_to, whole};
use super::verdict::{Case, lasting};

/// A disc of mass 1 and speed 1 meets one of mass M at rest, or the other way
/// round, at 6: u = (m - M)/(m + M) and w = 2m/(m + M).
#[test]
fn of_two_discs() {
    for heading in HEADINGS {
        for exponent in (0..=40).step_by(5) {
            for heavy_first in [false, true] {
                let (light, heavy) = (whole(1), ten_to(exponent));
                let [first, second] = if heavy_first {
                    [heavy, light]
                } else {
                    [light, heavy]
                };
                let disc = |x: i64, mass: &BigRational| {
                    Disc::at(heading.at(x, 0), heading.units(1)).mass(number(mass.clone()))
                };
                let scene = lasting(9)
                    .disc(disc(0, &first).velocity(heading.at(1, 0)))
                    .disc(disc(8, &second));
                let sum = &first + &second;
                let ends = [(&first - &second) / &sum, whole(2) * &first / &sum];
                Case::new(scene, "d0 d1")
                    .times([whole(6)])
                    .leaving(heading, ends.map(|speed| [speed, whole(0)]))
                    .check(&format!("{heading:?} 10^{exponent} {heavy_first}"));
            }
        }
    }
}

/// A light disc between a wall and one of 10^(2p) times its mass, which is at
/// rest: the light one comes from 3/4 with speed 1, the heavy one waits at 1
/// (as gaps from the wall, without the diameters).
fn squeezed(heading: Heading, p: u32) -> SceneBuilder {
    let light = BigRational::new(3.into(), 4.into()) + whole(1);
    let disc = |x: &BigRational| Disc::at(heading.point(x, &whole(0)), heading.units(1));
    lasting(10)
        .disc(disc(&light).velocity(heading.at(1, 0)))
        .disc(disc(&whole(4)).mass(number(ten_to(2 * p))))
        .wall(heading.at(0, -1), heading.at(0, 1))
}

/// With the gaps q₁ and q₂, (q₂ √M, q₁ √m) moves in a wedge of the angle
/// α = arctan √(m/M), and unfolded on a straight line at right angles to the
/// wall's ray, which crosses the ray at k α at the height √M tan kα: after
/// t_k = √(M/m) tan(kα) - 3/4. Odd k are impacts of the discs, even ones of the
/// wall. tan α = 10^-p is rational, and so are all the times. As tan kα is
/// little more than k tan α, and less than 1/4 more for p ≥ 2 and k ≤ 10, those
/// until 10 are just the first ten: t_10 < 9.5, t_11 > 10.
#[test]
fn of_a_disc_between_a_wall_and_a_heavy_one() {
    let names = ["d0 d1", "d0 w0"].repeat(5).join(", ");
    for heading in HEADINGS {
        for p in [2, 3, 5, 10, 15, 20] {
            let tangent = whole(1) / ten_to(p);
            let next = |t: &BigRational| {
                let sum = t + &tangent;
                Some(sum / (whole(1) - t * &tangent))
            };
            let tangents = std::iter::successors(Some(tangent.clone()), next).take(10);
            let times = tangents.map(|t| t * ten_to(p) - BigRational::new(3.into(), 4.into()));
            Case::new(squeezed(heading, p), &names)
                .times(times)
                .check(&format!("{heading:?} 10^{}", 2 * p));
        }
    }
}

/// A heavy disc comes towards a light one at rest and a wall behind it. In the
/// coordinates above the wedge has the angle α = arctan √(m/M) and the path is
/// parallel to the wall's ray: it crosses the rays k α < π. For α = π/n these
/// are n - 1, and the path ends parallel to a ray: two bodies that have the
/// same speed, or one at rest, which must not be taken for another impact.
/// cot²(π/n) is rational for n = 3, 4, 6.
#[test]
fn of_angles_that_divide_the_half_turn() {
    for heading in HEADINGS {
        for (mass, count) in [("1/3", 2), ("1", 3), ("3", 5)] {
            let disc = |x: i64| Disc::at(heading.at(x, 0), heading.units(1));
            let scene = lasting(1000)
                .disc(disc(2))
                .disc(disc(5).velocity(heading.at(-1, 0)).mass(mass))
                .wall(heading.at(0, -1), heading.at(0, 1));
            let all = ["d0 d1", "d0 w0"].repeat(3);
            Case::new(scene, &all[..count].join(", ")).check(&format!("{heading:?} {mass}"));
        }
    }
}

/// In a row of masses 1, 1, M the speeds 1, 0, 0 become 0, 1, 0, then 0, u, w
/// with u = (1 - M)/(1 + M) and w = 2/(1 + M), and u, 0, w.
#[test]
fn of_three_discs() {
    for heading in HEADINGS {
        for exponent in (5..=40).step_by(5) {
            let heavy = ten_to(exponent);
            let sum = &heavy + whole(1);
            let [u, w] = [(whole(1) - &heavy) / &sum, whole(2) / &sum];
            let disc = |x: i64| Disc::at(heading.at(x, 0), heading.units(1));
            let scene = lasting(16)
                .disc(disc(0).velocity(heading.at(1, 0)))
                .disc(disc(4))
                .disc(disc(8).mass(number(heavy)));
            Case::new(scene, "d0 d1, d1 d2, d0 d1")
                .leaving(heading, [u, whole(0), w].map(|speed| [speed, whole(0)]))
                .check(&format!("{heading:?} 10^{exponent}"));
        }
    }
}
