//! Discs that fall, by the definition: in fractions, with zeros by Sturm's
//! theorem.

use carom::body::BodyId;
use carom::scene::Scene;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use proptest::prelude::*;

use super::fraction::{ratio, rounded};
use super::reference::{Reference, Target, Vector, dot, exact, minus};
use super::run;
use super::sturm::{descent, value};
use crate::common::name;
use crate::common::strategy::{Masses, boxed, cases, lossy};

/// Enough to tell times apart, and how they round.
const ROUGH: usize = 24;
const SHARP: usize = 140;

/// Bounds of a time.
type Bounds = [BigRational; 2];

struct Falling {
    state: Reference,
    gravity: [f64; 2],
    /// What each disc has collided with last.
    last: Vec<Option<Target>>,
}

/// d + v t + h t², by powers.
type Arc = [Vector; 3];

impl Falling {
    fn new(scene: &Scene, gravity: [f64; 2]) -> Self {
        let state = Reference::new(scene);
        let last = vec![None; state.bodies.len()];
        Self {
            state,
            gravity,
            last,
        }
    }

    fn next(&mut self) -> Option<(String, f64)> {
        let (disc, target) = self.first()?;
        let time = self.meet(disc, target, SHARP)?;
        let stored = rounds_to(&time);
        if stored > self.state.end {
            return None;
        }
        self.bring(disc, &time, stored);
        self.last[disc] = Some(target);
        if let Target::Disc(other) = target {
            self.bring(other, &time, stored);
            self.last[other] = Some(Target::Disc(disc));
        }
        self.state.strike(disc, target);
        Some((target.name(disc), stored))
    }

    fn first(&self) -> Option<(usize, Target)> {
        let count = self.state.bodies.len();
        let mut first: Option<(Bounds, usize, Target)> = None;
        for disc in 0..count {
            let walls = (0..self.state.walls.len()).flat_map(|wall| {
                [
                    Target::Wall(wall),
                    Target::End(wall, 0),
                    Target::End(wall, 1),
                ]
            });
            for target in (disc + 1..count).map(Target::Disc).chain(walls) {
                let Some(time) = self.meet(disc, target, ROUGH) else {
                    continue;
                };
                if first.as_ref().is_none_or(|(least, ..)| time[0] < least[0]) {
                    first = Some((time, disc, target));
                }
            }
        }
        first.map(|(_, disc, target)| (disc, target))
    }

    fn arc(&self, disc: usize) -> Arc {
        let body = &self.state.bodies[disc];
        let half = match body.mass {
            Some(_) => exact(self.gravity).map(|g| g / ratio(2.0)),
            None => exact([0.0; 2]),
        };
        [exact(body.place), exact(body.speed), half]
    }

    fn since(&self, disc: usize) -> BigRational {
        ratio(self.state.bodies[disc].since)
    }

    fn meet(&self, disc: usize, target: Target, bits: usize) -> Option<Bounds> {
        let mut since = self.since(disc);
        let delay = match target {
            Target::Disc(other) => {
                let bodies = [&self.state.bodies[disc], &self.state.bodies[other]];
                if bodies.iter().all(|body| body.mass.is_none()) {
                    return None;
                }
                since = since.max(self.since(other));
                let [one, two] =
                    [disc, other].map(|disc| later(&self.arc(disc), &(&since - self.since(disc))));
                let arc = [0, 1, 2].map(|power| minus(&two[power], &one[power]));
                let has = |disc: usize, other| {
                    self.state.bodies[disc].mass.is_none()
                        || matches!(self.last[disc], Some(Target::Disc(last)) if last == other)
                };
                let parted = has(disc, other) && has(other, disc);
                let reach = ratio(bodies[0].radius) + ratio(bodies[1].radius);
                enter(gap(&arc, &reach), parted, bits)
            }
            _ if self.state.bodies[disc].mass.is_none() => None,
            Target::End(wall, end) => self.meet_end(disc, wall, end, bits),
            Target::Wall(wall) => self.meet_wall(disc, wall, bits),
        }?;
        Some(delay.map(|delay| delay + &since))
    }

    fn meet_end(&self, disc: usize, wall: usize, end: usize, bits: usize) -> Option<Bounds> {
        let point = self.state.walls[wall][end];
        let radius = ratio(self.state.bodies[disc].radius);
        let gap = gap(&seen(&self.arc(disc), &exact(point)), &radius);
        let touched = matches!(self.last[disc], Some(Target::End(wall, end)) if self.state.walls[wall][end] == point);
        let [_, foot, length] = self.along(disc, wall);
        let is_beyond = match end {
            0 => !foot[0].is_positive() && !foot[0].is_zero(),
            _ => foot[0] > length[0],
        };
        if !touched && !gap[0].is_positive() && !is_beyond {
            return None;
        }
        enter(gap, touched, bits)
    }

    /// The side and the foot, by powers of the time, and the square of the length.
    fn along(&self, disc: usize, wall: usize) -> [Vec<BigRational>; 3] {
        let [from, to] = self.state.walls[wall].map(exact);
        let along = minus(&to, &from);
        let across = [-along[1].clone(), along[0].clone()];
        let arc = seen(&self.arc(disc), &from);
        let [side, foot] =
            [across, along.clone()].map(|axis| arc.iter().map(|power| dot(power, &axis)).collect());
        [side, foot, vec![dot(&along, &along)]]
    }

    fn meet_wall(&self, disc: usize, wall: usize, bits: usize) -> Option<Bounds> {
        let [side, foot, length] = self.along(disc, wall);
        let is_opposite = |time: &Bounds| {
            time.iter().all(|time| {
                let foot = value(&foot, time);
                foot.is_positive() && foot < length[0]
            })
        };
        let radius = ratio(self.state.bodies[disc].radius);
        let reach_squared = &radius * &radius * &length[0];
        let touched = matches!(self.last[disc], Some(Target::Wall(last)) if last == wall);
        let zero = || [BigRational::zero(), BigRational::zero()];
        let own = side[0].is_positive();
        let signed = |power: usize| {
            if own {
                side[power].clone()
            } else {
                -side[power].clone()
            }
        };
        let back = || descent(&[signed(1), signed(2)], bits).map(|(time, _)| time);
        let overlaps = &side[0] * &side[0] <= reach_squared && is_opposite(&zero());
        let mut times: Vec<Bounds> = entries(&side, &reach_squared, bits)
            .into_iter()
            .filter(|time| !(touched && value(&side, &time[0]).is_positive() == own))
            .collect();
        if !touched && overlaps && signed(1).is_negative() {
            return Some(zero());
        }
        let comes_back = |time: &Bounds| value(&side, &time[0]).is_positive() == own;
        if touched || overlaps && !times.iter().any(comes_back) {
            times.extend(back());
        }
        times.retain(is_opposite);
        times.into_iter().min()
    }

    fn bring(&mut self, disc: usize, time: &Bounds, stored: f64) {
        let (arc, since) = (self.arc(disc), self.since(disc));
        let body = &mut self.state.bodies[disc];
        if body.mass.is_none() {
            return;
        }
        let flown = time.each_ref().map(|time| time - &since);
        for axis in [0, 1] {
            let [d, v, h] = [0, 1, 2].map(|power: usize| arc[power][axis].clone());
            let gain = &h + &h;
            let at = |f: &[BigRational]| rounds_to(&flown.each_ref().map(|time| value(f, time)));
            body.place[axis] = at(&[d, v.clone(), h]);
            body.speed[axis] = at(&[v, gain]);
        }
        body.since = stored;
    }
}

/// When the disc comes to a line, from either side.
fn entries(side: &[BigRational], reach_squared: &BigRational, bits: usize) -> Vec<Bounds> {
    let mut f = vec![BigRational::zero(); 5];
    for (i, a) in side.iter().enumerate() {
        for (j, b) in side.iter().enumerate() {
            f[i + j] += a * b;
        }
    }
    f[0] -= reach_squared;
    let Some((first, _)) = descent(&f, bits) else {
        return Vec::new();
    };
    // Beyond the first, which may not be quite left behind.
    let from = &first[1]
        + BigRational::new(1.into(), 1_i64.into())
            / BigRational::from_integer(num_bigint::BigInt::from(1) << (bits / 2));
    let second = descent(&shifted(&f, &from), bits);
    let second = second.map(|(time, _)| time.map(|time| time + &from));
    [Some(first), second].into_iter().flatten().collect()
}

fn shifted(f: &[BigRational], by: &BigRational) -> Vec<BigRational> {
    let mut f = f.to_vec();
    for round in 0..f.len() {
        for power in (round..f.len() - 1).rev() {
            let carried = &f[power + 1] * by;
            f[power] += carried;
        }
    }
    f
}

fn later([d, v, h]: &Arc, time: &BigRational) -> Arc {
    let moved = [0, 1].map(|axis| &d[axis] + &v[axis] * time + &h[axis] * time * time);
    let faster = [0, 1].map(|axis| &v[axis] + ratio(2.0) * &h[axis] * time);
    [moved, faster, h.clone()]
}

fn seen([d, v, h]: &Arc, point: &Vector) -> Arc {
    [minus(d, point), v.clone(), h.clone()]
}

fn gap([d, v, h]: &Arc, reach: &BigRational) -> Vec<BigRational> {
    let two = ratio(2.0);
    vec![
        dot(d, d) - reach * reach,
        &two * dot(d, v),
        dot(v, v) + &two * dot(d, h),
        &two * dot(v, h),
        dot(h, h),
    ]
}

/// When a gap closes, of bodies that may have parted.
fn enter(gap: Vec<BigRational>, parted: bool, bits: usize) -> Option<Bounds> {
    let is_apart = gap[0].is_positive() && !parted;
    if is_apart {
        return descent(&gap, bits).map(|(time, _)| time);
    }
    if !parted && gap[1].is_negative() {
        return Some([BigRational::zero(), BigRational::zero()]);
    }
    assert!(gap[1].is_positive(), "no more than parts");
    descent(&gap[1..], bits).map(|(time, _)| time)
}

/// What both bounds round to.
fn rounds_to(bounds: &Bounds) -> f64 {
    let [low, high] = bounds.each_ref().map(rounded);
    assert_eq!(low, high, "no tie");
    low
}

fn assert_as_defined(scene: &Scene, gravity: [f64; 2], impacts: u64) {
    let number = |number: f64| carom::scalar::Number::try_from(number).unwrap();
    let scene = scene.to_builder().gravity(gravity.map(number));
    let scene = scene.build().unwrap();
    let outcome = run(&scene, impacts);
    let mut reference = Falling::new(&scene, gravity);
    for (count, impact) in outcome.impacts.iter().enumerate() {
        let expected = reference.next().expect("as many impacts");
        assert_eq!(
            (name(impact), impact.time.get()),
            expected,
            "impact {count}"
        );
        let velocity = impact.contact.as_ref().unwrap().velocity;
        let BodyId::Disc(disc) = impact.pair.a else {
            panic!("a disc comes first");
        };
        let stored = reference.state.bodies[disc as usize].speed;
        assert_eq!(
            [velocity.x.get(), velocity.y.get()],
            stored,
            "impact {count}"
        );
    }
    if (outcome.impacts.len() as u64) < impacts {
        assert!(reference.next().is_none(), "no more impacts");
    }
}

fn gravity() -> impl Strategy<Value = [f64; 2]> {
    prop_oneof![Just([0.0, -2.0]), [-3.0..3.0, -9.0..-1.0_f64]]
}

proptest! {
    #![proptest_config(cases(2))]

    /// Discs and oblique walls in a box, some of infinite mass.
    #[test]
    fn boxes_fall(scene in boxed(Masses::Any), gravity in gravity()) {
        assert_as_defined(&scene, gravity, 6);
    }

    #[test]
    fn losses_fall(scene in lossy(), gravity in gravity()) {
        assert_as_defined(&scene, gravity, 6);
    }
}
