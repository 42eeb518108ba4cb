//! Far away, very large, very small, very slow and very fast.

use carom::scalar::Number;
use carom::scene::{Disc, SceneBuilder};
use num_rational::BigRational;

use super::heading::{HEADINGS, nudges, number, power, ten_to, whole};
use super::verdict::{Case, lasting};

/// A point of a heading's frame, shifted by as much in both directions.
fn shifted(point: [Number; 2], offset: &BigRational) -> [Number; 2] {
    point.map(|n| number(n.to_rational() + offset))
}

/// Two discs of radius 2^-j whose centres pass at 3 radii, with all positions
/// shifted by 10^p: a miss. Binary64 has positions there to u = 2^-52 of the
/// power of two below; while that is at most the radius, it stores them
/// exactly. Once the radius is below u/8, it stores both at the same height,
/// and they hit.
#[test]
fn positions_far_from_the_origin() {
    for p in 0..=15 {
        let offset = ten_to(p);
        let unit = 10_f64.powi(p as i32);
        let spacing = (unit.next_up() - unit).log2() as i32;
        for j in 0..=60 {
            let radius = power(2, -j);
            let disc = |x: i64, y: &BigRational| {
                let point = [number(whole(x)), number(y.clone())];
                Disc::at(shifted(point, &offset), number(radius.clone()))
            };
            let scene = lasting(16)
                .disc(disc(0, &whole(0)).velocity([1, 0]))
                .disc(disc(8, &(whole(3) * &radius)));
            let case = Case::new(scene, "");
            let case = match -j - spacing {
                0.. => case,
                ..=-4 => case.stored("d0 d1"),
                _ => continue,
            };
            case.check(&format!("10^{p} 2^-{j}"));
        }
    }
}

/// A scene may stand anywhere, as long as its numbers are stored exactly: with
/// coordinates that are multiples of 1/8 up to 10^15. d0 touches d1 at 6 and
/// d1, of the same mass, goes on with its speed to the wall: 2 · 4 later.
#[test]
fn all_positions_shifted() {
    for heading in HEADINGS {
        for p in 0..=14 {
            let at = |x: i64, y: i64| shifted(heading.at(x, y), &ten_to(p));
            let scene = lasting(16)
                .disc(Disc::at(at(0, 0), heading.units(1)).velocity(heading.at(1, 0)))
                .disc(Disc::at(at(8, 0), heading.units(1)))
                .wall(at(13, -9), at(13, 9));
            Case::new(scene, "d0 d1, d1 w0, d0 d1")
                .times([whole(6), whole(10), whole(14)])
                .check(&format!("{heading:?} 10^{p}"));
        }
    }
}

/// Towards a disc 10^p away, at the distance 1 from its centre, with the sum of
/// the radii 1 + 2^-k: a hit for + and a miss for -. The centre's coordinates
/// are whole numbers below 2^53, and the moment of the path is formed without
/// cancellation. (b² - a c has lost it from some 10^8 on.)
#[test]
fn a_target_far_away() {
    for heading in HEADINGS {
        for p in 2..=14 {
            let reach = 10_i64.pow(p);
            for (k, e) in nudges([1, 10, 20, 30, 44].into_iter()) {
                let half = (whole(1) + &e) / whole(2);
                let scene = lasting(reach + 2)
                    .disc(
                        Disc::at(heading.at(0, 0), heading.length(&half))
                            .velocity(heading.at(1, 0)),
                    )
                    .disc(Disc::at(heading.at(reach, 1), heading.length(&half)));
                let truth = if half > power(2, -1) { "d0 d1" } else { "" };
                let case = Case::new(scene, truth);
                case.check(&format!("{heading:?} 10^{p} 2^-{k}"));
            }
        }
    }
}

/// d0 touches the wall at 3, the triangle 3-4-5 put over (0, 0), (6, 8): of
/// (-5, 0) it becomes (7, -24)/5 at (5/4, 0), and meets d1 head-on one unit of
/// time and 5 of length later, at a distance of 2 from its centre.
fn scaled(size: &BigRational, speed: &BigRational) -> SceneBuilder {
    let point = |x: BigRational, y: BigRational| [number(x * size), number(y * size)];
    let rational = |n: i64, d: i64| BigRational::new(n.into(), d.into());
    let target = point(rational(5, 4) + rational(49, 25), rational(-168, 25));
    let radius = || number(size.clone());
    let duration = number(whole(2) * size / speed);
    lasting(1)
        .disc(
            Disc::at(point(whole(5), whole(0)), radius())
                .velocity([number(whole(-5) * speed), Number::from(0)]),
        )
        .disc(Disc::at(target, radius()))
        .wall(point(whole(0), whole(0)), point(whole(6), whole(8)))
        .frame(duration, 1)
}

/// Scaling by a power of two changes nothing, neither of all lengths nor of
/// all speeds. Plain binary64 takes numbers from 2^-200 to 2^200, where no
/// product of four leaves its range, and refuses others. Here they are, but for
/// the scales, 1 to 8, and the duration is twice the ratio of the scales.
#[test]
fn sizes_and_speeds() {
    let exponents = [-400, -203, -196, -100, 0, 100, 196, 201, 400];
    for size in exponents {
        for speed in exponents {
            let scene = scaled(&power(2, size), &power(2, speed));
            let times = [3, 7].map(|n| BigRational::new(n.into(), 4.into()));
            let scale = power(2, size - speed);
            let case = Case::new(scene, "d0 w0, d0 d1");
            let duration = size - speed + 1;
            let fits = size.abs().max(speed.abs()) < 198 && (-200..=200).contains(&duration);
            let case = match fits {
                true => case.times(times.map(|time| time * scale.clone())),
                false => case.plain("refused"),
            };
            case.check(&format!("2^{size} 2^{speed}"));
        }
    }
}

/// A large disc of radius 2 and one of radius 2^-k that passes it at the
/// height 2 + 2^-k times 2 or 1/2: a miss or a hit. From 2^-56 downwards that is
/// stored as 2, which makes both a hit; and plain binary64, for which the sum
/// of the radii is 2 too, has a graze of both.
#[test]
fn of_sizes_far_apart() {
    for heading in HEADINGS {
        for k in [1, 10, 20, 40, 60, 100, 190] {
            let small = power(2, -k);
            for (part, truth) in [(whole(2), ""), (power(2, -1), "d0 d1")] {
                let height = whole(2) + part * &small;
                let start = heading.point(&whole(8), &height);
                let scene = lasting(16)
                    .disc(Disc::at(heading.at(0, 0), heading.units(2)))
                    .disc(Disc::at(start, heading.length(&small)).velocity(heading.at(-1, 0)));
                let case = Case::new(scene, truth);
                let case = match k {
                    ..56 => case,
                    _ => case.stored("d0 d1").plain("grazes: 1"),
                };
                case.check(&format!("{heading:?} {k}"));
            }
        }
    }
}

/// A small disc that falls onto the top of a large one takes as long as for
/// the gap, whatever its size.
#[test]
fn small_onto_large() {
    for heading in HEADINGS {
        for k in [1, 10, 20, 40] {
            let small = power(2, -k);
            let top = whole(4) + &small;
            let scene = lasting(3)
                .disc(Disc::at(heading.at(0, 0), heading.units(2)))
                .disc(
                    Disc::at(heading.point(&whole(0), &top), heading.length(&small))
                        .velocity(heading.at(0, -1)),
                );
            Case::new(scene, "d0 d1")
                .times([whole(2)])
                .check(&format!("{heading:?} {k}"));
        }
    }
}

/// At 2^k times the speed towards a target 2^k away: the gap of 2^k - 2 takes
/// 1 - 2/2^k.
#[test]
fn fast_and_far() {
    for heading in HEADINGS {
        for k in [10, 50, 100, 150] {
            let far = power(2, k);
            let scene = lasting(2)
                .disc(
                    Disc::at(heading.at(0, 0), heading.units(1))
                        .velocity(heading.point(&far, &whole(0))),
                )
                .disc(Disc::at(heading.point(&far, &whole(0)), heading.units(1)));
            let time = whole(1) - whole(2) / &far;
            Case::new(scene, "d0 d1")
                .times([time])
                .check(&format!("{heading:?} {k}"));
        }
    }
}
