//! Two discs that meet.

use carom::scene::Disc;

use crate::common::agree::{assert_encloses, assert_end, assert_log, assert_surd};
use crate::common::{exactly, lasting, names};

/// A gap of 3 closes at 3; equal masses exchange their velocities.
#[test]
fn head_on() {
    let scene = lasting("2")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .disc(Disc::at([5, 0], 1).velocity([-2, 0]));
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("1", "d0 d1")]);
    assert_end(&outcome, &[["-1", "0", "-2", "0"], ["4", "0", "1", "0"]]);
}

/// They touch when (4 - t)² + 1 = 2², so t = 4 - √3, along n = (√3, 1)/2.
/// Of (1, 0) the second disc gets (v·n) n = (3/4, √3/4), the first one keeps
/// (1/4, -√3/4). In the √3 that are left until 4 the first one gets from
/// (4 - √3, 0) to (4 - 3/4 √3, -3/4).
#[test]
fn oblique() {
    let scene = lasting("4")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .disc(Disc::at([4, 1], 1));
    let outcome = exactly(&scene.build().unwrap());
    assert_eq!(names(&outcome.impacts), ["d0 d1"]);
    assert_surd(&outcome.impacts[0].time, ["4", "-1"], "3");
    let [first, second] = &outcome.end[..] else {
        panic!("two discs");
    };
    assert_surd(&first.position.x, ["4", "-3/4"], "3");
    assert_encloses(&first.position.y, "-3/4");
    assert_encloses(&first.velocity.x, "1/4");
    assert_surd(&first.velocity.y, ["0", "-1/4"], "3");
    assert_encloses(&second.velocity.x, "3/4");
    assert_surd(&second.velocity.y, ["0", "1/4"], "3");
}

/// Radii of 3 and 2 make the reach 5 of the triangle 3-4-5: they touch when
/// the first disc is 3 short of 10, at (7, 0), and n = (3, 4)/5. With masses
/// 1 and 3 the impulse is 2 (3/4) (v·n) = 9/10 of n: the first disc keeps
/// (1, 0) - (27, 36)/50, the second one gets a third of (27, 36)/50.
#[test]
fn oblique_with_unequal_radii_and_masses() {
    let scene = lasting("8")
        .disc(Disc::at([0, 0], 3).velocity([1, 0]))
        .disc(Disc::at([10, 4], 2).mass(3));
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("7", "d0 d1")]);
    let first = ["373/50", "-18/25", "23/50", "-18/25"];
    let second = ["509/50", "106/25", "9/50", "6/25"];
    assert_end(&outcome, &[first, second]);
}

/// With the masses 2 and 1, a velocity of 3 becomes 3 (2 - 1)/3 = 1 and
/// 2·2·3/3 = 4.
#[test]
fn unequal_masses() {
    let scene = lasting("3")
        .disc(Disc::at([0, 0], 1).velocity([3, 0]).mass(2))
        .disc(Disc::at([8, 0], 1));
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("2", "d0 d1")]);
    assert_end(&outcome, &[["7", "0", "1", "0"], ["12", "0", "4", "0"]]);
}

/// A disc comes back from one of infinite mass as from a wall.
#[test]
fn infinite_mass_at_rest() {
    let scene = lasting("3")
        .disc(Disc::at([0, 0], 1).velocity([2, 0]))
        .disc(Disc::at([6, 0], 1).infinite_mass());
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("2", "d0 d1")]);
    assert_end(&outcome, &[["2", "0", "-2", "0"], ["6", "0", "0", "0"]]);
}

/// Seen from a piston that moves at V, a velocity v - V is reversed: it
/// becomes 2 V - v. At rest before a piston of 1: 2.
#[test]
fn advancing_piston() {
    let scene = lasting("4")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]).infinite_mass())
        .disc(Disc::at([5, 0], 1));
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("3", "d0 d1")]);
    assert_end(&outcome, &[["4", "0", "1", "0"], ["7", "0", "2", "0"]]);
}

/// 3 behind a piston of 1 becomes 2 - 3 = -1.
#[test]
fn receding_piston() {
    let scene = lasting("3")
        .disc(Disc::at([0, 0], 1).velocity([3, 0]))
        .disc(Disc::at([6, 0], 1).velocity([1, 0]).infinite_mass());
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("2", "d0 d1")]);
    assert_end(&outcome, &[["5", "0", "-1", "0"], ["9", "0", "1", "0"]]);
}

/// Nothing deflects a body of infinite mass, so two of them pass through
/// each other and through walls.
#[test]
fn infinite_masses_meet_neither_each_other_nor_walls() {
    let scene = lasting("10")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]).infinite_mass())
        .disc(Disc::at([6, 0], 1).velocity([-1, 0]).infinite_mass())
        .wall([8, -5], [8, 5]);
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[]);
    assert_end(&outcome, &[["10", "0", "1", "0"], ["-4", "0", "-1", "0"]]);
}

/// The right piston, at 5 - t, is 2 from the disc at 3t after 3/4, and turns
/// its 3 into -2 - 3. The left piston, then at -17/4, is 2 from the disc,
/// from 9/4 on at -5, when 26/4 - 6s = 2, after another 3/4: 2 + 5.
#[test]
fn between_pistons() {
    let scene = lasting("3/2")
        .disc(Disc::at([0, 0], 1).velocity([3, 0]))
        .disc(Disc::at([5, 0], 1).velocity([-1, 0]).infinite_mass())
        .disc(Disc::at([-5, 0], 1).velocity([1, 0]).infinite_mass());
    let outcome = exactly(&scene.build().unwrap());
    assert_log(&outcome, &[("3/4", "d0 d1"), ("3/2", "d0 d2")]);
    let middle = ["-3/2", "0", "7", "0"];
    assert_end(
        &outcome,
        &[middle, ["7/2", "0", "-1", "0"], ["-7/2", "0", "1", "0"]],
    );
}

/// d0 would meet d2 at 7, but meets d1 when (3 - t)² + (4 - 2t)² = 4, that is
/// 5t² - 22t + 21 = 0: at 7/5, along n = (4, 3)/5. The velocities' parts along
/// n, 4/5 and -6/5, change places: d0 gets (1, 0) - 2n, d1 (0, -2) + 2n =
/// (8, -4)/5. From (3, 6/5) that leads d1 to d2 when (6 - 8s/5)² +
/// (4s/5 - 6/5)² = 4, that is 10s² - 66s + 104.5 = 0, after s = (66 - √176)/20.
#[test]
fn an_impact_undoes_what_was_to_come() {
    let scene = lasting("10")
        .disc(Disc::at([0, 0], 1).velocity([1, 0]))
        .disc(Disc::at([3, 4], 1).velocity([0, -2]))
        .disc(Disc::at([9, 0], 1));
    let outcome = exactly(&scene.build().unwrap());
    assert_eq!(names(&outcome.impacts), ["d0 d1", "d1 d2"]);
    assert_encloses(&outcome.impacts[0].time, "7/5");
    assert_surd(&outcome.impacts[1].time, ["47/10", "-1/20"], "176");
}

/// Head-on in the direction (1, 2), at the irrational time (√20 - 2)/√5: the
/// first disc stops, and so does not meet the wall below. That its velocity is
/// zero no enclosure can tell.
#[test]
fn who_stops_meets_nothing() {
    let scene = lasting("4")
        .disc(Disc::at([0, 0], 1).velocity([1, 2]))
        .disc(Disc::at([2, 4], 1))
        .wall([-9, -9], [9, -9]);
    assert_eq!(names(&exactly(&scene.build().unwrap()).impacts), ["d0 d1"]);
}

/// From four sides: each touches both of its neighbours at 3 - √2. Whatever
/// their names, the first two impacts turn the first disc by a quarter each
/// time, the other two the one across from it, and each goes back.
#[test]
fn four_at_once() {
    let around = [[0, 1], [0, -1], [-1, 0], [1, 0]];
    let crosswise = [[0, 1], [-1, 0], [0, -1], [1, 0]];
    let pairs = [
        ["d0 d2", "d0 d3", "d1 d2", "d1 d3"],
        ["d0 d1", "d0 d3", "d1 d2", "d2 d3"],
    ];
    for (sides, pairs) in [around, crosswise].into_iter().zip(pairs) {
        let discs = sides.map(|[x, y]| Disc::at([3 * x, 3 * y], 1).velocity([-x, -y]));
        let outcome = exactly(&lasting("2").discs(discs).build().unwrap());
        assert_eq!(names(&outcome.impacts), pairs);
        for impact in &outcome.impacts {
            assert_surd(&impact.time, ["3", "-1"], "2");
        }
        for (disc, [x, y]) in outcome.end.iter().zip(sides) {
            assert_encloses(&disc.velocity.x, &x.to_string());
            assert_encloses(&disc.velocity.y, &y.to_string());
        }
    }
}
