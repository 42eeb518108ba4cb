//! The exact timeline against a run that shares nothing with it: fixed-point
//! numbers instead of enclosures, the textbook's root instead of the
//! cancellation-free one, every pair looked at after every impact.
//!
//! A fixed-point number has an error that grows along the run. How much is
//! found out by a second run with fewer digits: where both agree to far more
//! digits than are compared, the first one is right to these.

#![cfg(feature = "cli")]

use std::ops::ControlFlow;

use carom::arithmetic::Budget;
use carom::run::{Options, Outcome, run};
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::generate::gas;
use carom::scene::{Disc, Mass, Scene};
use carom::simulation::Algorithm;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// Whole numbers of 2^-bits.
#[derive(Clone, Copy)]
struct Grid {
    bits: u64,
}

impl Grid {
    fn of(self, number: &Number) -> BigInt {
        let ratio = number.to_rational();
        (ratio.numer() << self.bits) / ratio.denom()
    }

    fn times(self, a: &BigInt, b: &BigInt) -> BigInt {
        (a * b) >> self.bits
    }

    fn over(self, a: &BigInt, b: &BigInt) -> BigInt {
        (a << self.bits) / b
    }

    fn root(self, a: &BigInt) -> BigInt {
        (a << self.bits).sqrt()
    }

    fn dot(self, a: &[BigInt; 2], b: &[BigInt; 2]) -> BigInt {
        self.times(&a[0], &b[0]) + self.times(&a[1], &b[1])
    }
}

struct Ball {
    place: [BigInt; 2],
    speed: [BigInt; 2],
    radius: BigInt,
    /// None for an infinite mass.
    mass: Option<BigInt>,
}

/// Discs in a rectangle about which walls 0 to 3 run counterclockwise from the
/// bottom.
struct Box2 {
    grid: Grid,
    balls: Vec<Ball>,
    corner: [BigInt; 2],
    /// The last two bodies that collided: they part.
    last: Option<(usize, usize)>,
    time: BigInt,
}

impl Box2 {
    fn new(scene: &Scene, bits: u64) -> Self {
        let grid = Grid { bits };
        let pair = |numbers: &[Number; 2]| numbers.each_ref().map(|number| grid.of(number));
        let ball = |disc: &carom::scene::Disc| Ball {
            place: pair(&disc.position),
            speed: pair(&disc.velocity),
            radius: grid.of(&disc.radius),
            mass: match &disc.mass {
                Mass::Finite(mass) => Some(grid.of(mass)),
                Mass::Infinite => None,
            },
        };
        Self {
            balls: scene.discs().iter().map(ball).collect(),
            corner: pair(&scene.walls()[1].to),
            grid,
            last: None,
            time: BigInt::zero(),
        }
    }

    fn apart(&self, i: usize, j: usize) -> [[BigInt; 2]; 2] {
        let (a, b) = (&self.balls[i], &self.balls[j]);
        let minus = |x: &[BigInt; 2], y: &[BigInt; 2]| [&x[0] - &y[0], &x[1] - &y[1]];
        [minus(&b.place, &a.place), minus(&b.speed, &a.speed)]
    }

    /// (-b - √(b² - a c)) / a of a t² + 2 b t + c.
    fn until_discs(&self, i: usize, j: usize) -> Option<BigInt> {
        let grid = self.grid;
        let [d, v] = self.apart(i, j);
        let reach = &self.balls[i].radius + &self.balls[j].radius;
        let [a, b] = [grid.dot(&v, &v), grid.dot(&d, &v)];
        let c = grid.dot(&d, &d) - grid.times(&reach, &reach);
        let discriminant = grid.times(&b, &b) - grid.times(&a, &c);
        if !b.is_negative() || discriminant.is_negative() {
            return None;
        }
        Some(grid.over(&(-b - grid.root(&discriminant)), &a))
    }

    fn until_wall(&self, i: usize, wall: usize) -> Option<BigInt> {
        let ball = &self.balls[i];
        ball.mass.as_ref()?;
        let (axis, far) = [(1, false), (0, true), (1, true), (0, false)][wall];
        let speed = &ball.speed[axis];
        let target = if far {
            &self.corner[axis] - &ball.radius
        } else {
            ball.radius.clone()
        };
        let towards = if far {
            speed.is_positive()
        } else {
            speed.is_negative()
        };
        towards.then(|| self.grid.over(&(target - &ball.place[axis]), speed))
    }

    /// The next impact: bodies from the number of discs on are walls.
    fn next(&mut self) -> (usize, usize) {
        let count = self.balls.len();
        let mut first: Option<(BigInt, usize, usize)> = None;
        for i in 0..count {
            for j in i + 1..count + 4 {
                let until = match j.checked_sub(count) {
                    Some(wall) => self.until_wall(i, wall),
                    None => self.until_discs(i, j),
                };
                let until = until.filter(|_| self.last != Some((i, j)));
                if let Some(until) = until
                    && first.as_ref().is_none_or(|(time, ..)| until < *time)
                {
                    first = Some((until, i, j));
                }
            }
        }
        let (until, i, j) = first.expect("in a box something always happens");
        for ball in &mut self.balls {
            for axis in 0..2 {
                ball.place[axis] += (&ball.speed[axis] * &until) >> self.grid.bits;
            }
        }
        self.time += until;
        self.last = Some((i, j));
        (i, j)
    }

    fn collide(&mut self, i: usize, j: usize) {
        let grid = self.grid;
        if let Some(wall) = j.checked_sub(self.balls.len()) {
            let axis = [1, 0, 1, 0][wall];
            self.balls[i].speed[axis] *= -1;
            return;
        }
        let [n, v] = self.apart(i, j);
        let push = grid.over(&(grid.dot(&n, &v) * 2), &grid.dot(&n, &n));
        let masses = [i, j].map(|ball| self.balls[ball].mass.clone());
        let shares = match &masses {
            [Some(a), Some(b)] => [b, a].map(|other| grid.over(other, &(a + b))),
            [Some(_), None] => [BigInt::from(1) << grid.bits, BigInt::zero()],
            _ => [BigInt::zero(), BigInt::from(1) << grid.bits],
        };
        for (ball, share, sign) in [(i, &shares[0], 1), (j, &shares[1], -1)] {
            let change = grid.times(&push, share) * sign;
            for (speed, n) in self.balls[ball].speed.iter_mut().zip(&n) {
                *speed += grid.times(&change, n);
            }
        }
    }

    fn time(&self) -> BigRational {
        BigRational::new(self.time.clone(), BigInt::from(1) << self.grid.bits)
    }
}

fn exactly(scene: &Scene, impacts: u64, first_bits: u32) -> Outcome<Exact> {
    let options = Options {
        until: Some(Number::from(1_000_000)),
        max_events: impacts,
        budget: Budget {
            first_bits,
            ..Budget::default()
        },
        digits: 50,
        ..Options::default()
    };
    let go_on = &mut |_| ControlFlow::Continue(());
    run(scene, Algorithm::Timeline, &options, go_on).unwrap()
}

/// Follows a scene with fixed-point numbers of so many bits, and of a few less,
/// beside the exact run.
fn check(scene: &Scene, impacts: u64, bits: u64, first_bits: u32) {
    let outcome = exactly(scene, impacts, first_bits);
    assert_eq!(outcome.impacts.len() as u64, impacts);
    let [mut fine, mut coarse] = [bits, bits - 200].map(|bits| Box2::new(scene, bits));
    let close = BigRational::new(1.into(), BigInt::from(1) << 180);
    let count = scene.discs().len();
    for (number, impact) in outcome.impacts.iter().enumerate() {
        let (i, j) = fine.next();
        assert_eq!(
            coarse.next(),
            (i, j),
            "more bits are needed from {number} on"
        );
        assert!((fine.time() - coarse.time()).abs() < close, "{number}");
        let other = j
            .checked_sub(count)
            .map_or(format!("d{j}"), |wall| format!("w{wall}"));
        assert_eq!(
            impact.pair.to_string(),
            format!("d{i} and {other}"),
            "{number}"
        );
        let (lo, hi) = impact.time.enclosure().unwrap();
        assert!(
            lo - &close < fine.time() && fine.time() < hi + &close,
            "{number}"
        );
        fine.collide(i, j);
        coarse.collide(i, j);
    }
}

/// By the plain enclosures, and by those of impacts as one step.
#[test]
fn three_discs() {
    for seed in 1..=3 {
        let scene = gas(seed, 3, 0.3).unwrap();
        check(&scene, 1000, 2600, 128);
    }
    check(&gas(4, 3, 0.3).unwrap(), 400, 1600, 1024);
}

#[test]
fn ten_discs() {
    check(&gas(5, 10, 0.4).unwrap(), 600, 1600, 128);
}

/// Masses and radii of their own, and one disc that nothing deflects.
#[test]
fn unequal_discs() {
    let scene = Scene::builder("unequal")
        .disc(Disc::at([2, 2], 1).velocity(["13/7", "-3/5"]).mass("1/3"))
        .disc(Disc::at([6, 5], "3/2").velocity(["-1/9", "1"]).mass(7))
        .disc(
            Disc::at([9, 1], "1/4")
                .velocity(["-2", "5/3"])
                .mass("1/100"),
        )
        .disc(Disc::at([8, 8], "4/5").infinite_mass())
        .walls_around([0, 0], [10, 10])
        .build()
        .unwrap();
    check(&scene, 500, 3000, 128);
}
