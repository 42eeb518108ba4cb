//! Scenes as plain numbers, made at random by a generator of its own.

use carom::scalar::Number;
use carom::scene::{Disc, Restitution, Scene};

use crate::common::lasting;

pub(crate) type Point = [f64; 2];

pub(crate) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(crate) fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

/// a + b t.
pub(crate) fn plus(a: Point, b: Point, t: f64) -> Point {
    [a[0] + b[0] * t, a[1] + b[1] * t]
}

pub(crate) fn length(a: Point) -> f64 {
    a[0].hypot(a[1])
}

/// A disc; its mass may be infinite.
#[derive(Clone, Debug)]
pub(crate) struct Ball {
    pub(crate) place: Point,
    pub(crate) velocity: Point,
    pub(crate) radius: f64,
    pub(crate) mass: f64,
}

/// A scene under gravity, and perhaps drag.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) gravity: Point,
    /// The rate of the drag, or zero.
    pub(crate) drag: f64,
    pub(crate) balls: Vec<Ball>,
    pub(crate) walls: Vec<[Point; 2]>,
    /// Newton's coefficient.
    pub(crate) kept: f64,
    pub(crate) elastic_below: Option<f64>,
    pub(crate) duration: f64,
}

impl Case {
    pub(crate) fn scene(&self) -> Scene {
        let number = |value: f64| Number::try_from(value).unwrap();
        let discs = self.balls.iter().map(|ball| {
            let disc = Disc::at(ball.place, ball.radius).velocity(ball.velocity);
            match ball.mass {
                f64::INFINITY => disc.infinite_mass(),
                mass => disc.mass(mass),
            }
        });
        let scene = lasting(&self.duration.to_string())
            .gravity(self.gravity)
            .linear_drag(self.drag)
            .discs(discs.collect::<Vec<_>>())
            .restitution(Restitution::Newton {
                coefficient: number(self.kept),
                walls: None,
                elastic_below: self.elastic_below.map(number),
            });
        let scene = self
            .walls
            .iter()
            .fold(scene, |scene, [from, to]| scene.wall(*from, *to));
        scene.build().unwrap()
    }

    /// Whether energy stays what it is.
    pub(crate) fn is_conservative(&self) -> bool {
        self.kept == 1.0 && self.drag == 0.0 && !self.has_pistons()
    }

    fn has_pistons(&self) -> bool {
        self.balls
            .iter()
            .any(|ball| ball.mass.is_infinite() && ball.velocity != [0.0; 2])
    }
}

/// The generator `SplitMix64`.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(crate) fn below(&mut self, count: u64) -> u64 {
        self.next() % count
    }

    pub(crate) fn one_in(&mut self, count: u64) -> bool {
        self.below(count) == 0
    }

    /// A multiple of 1 / `grain` between the two.
    pub(crate) fn within(&mut self, low: f64, high: f64, grain: f64) -> f64 {
        let steps = ((high - low) * grain) as u64 + 1;
        low + self.below(steps) as f64 / grain
    }

    fn point(&mut self, low: f64, high: f64, grain: f64) -> Point {
        [self.within(low, high, grain), self.within(low, high, grain)]
    }

    fn pick<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len() as u64) as usize]
    }
}

/// What a family of scenes is like.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Family {
    /// Coordinates are multiples of 1 / `grain`.
    pub(crate) grain: f64,
    pub(crate) discs: u64,
    pub(crate) boxed: bool,
    pub(crate) walls: u64,
    pub(crate) pegs: u64,
    pub(crate) pistons: bool,
    pub(crate) drag: f64,
    pub(crate) kept: f64,
    pub(crate) elastic_below: Option<f64>,
    /// Whether discs start on walls, or on each other.
    pub(crate) touching: bool,
    pub(crate) duration: f64,
}

const SIDE: f64 = 12.0;

impl Family {
    pub(crate) fn case(&self, seed: u64) -> Case {
        let mut random = Random(seed.wrapping_mul(0x1234_5678_9abc_def1));
        let random = &mut random;
        let pulls: [Point; 8] = [
            [0.0, -1.0],
            [0.0, -2.0],
            [0.0, -10.0],
            [1.0, 0.0],
            [0.0, 2.0],
            [0.75, -1.0],
            [-1.0, -1.0],
            [1.25, 3.0],
        ];
        let gravity = random.pick(&pulls);
        let mut case = Case {
            gravity,
            drag: self.drag,
            balls: Vec::new(),
            walls: self.walls(random),
            kept: self.kept,
            elastic_below: self.elastic_below,
            duration: self.duration,
        };
        let count = 1 + random.below(self.discs);
        let pegs = random.below(self.pegs + 1);
        for index in 0..count + pegs {
            for _ in 0..60 {
                let ball = self.ball(random, index >= count, &case);
                if is_free(&ball, &case) {
                    case.balls.push(ball);
                    break;
                }
            }
        }
        case
    }

    fn walls(&self, random: &mut Random) -> Vec<[Point; 2]> {
        let mut walls = Vec::new();
        if self.boxed {
            let corners = [[0.0, 0.0], [SIDE, 0.0], [SIDE, SIDE], [0.0, SIDE]];
            walls.extend((0..4).map(|i| [corners[i], corners[(i + 1) % 4]]));
        }
        for _ in 0..random.below(self.walls + 1) {
            let from = random.point(1.0, SIDE - 1.0, self.grain);
            let mut to = random.point(1.0, SIDE - 1.0, self.grain);
            match random.below(4) {
                0 => to[1] = from[1],
                1 => to[0] = from[0],
                2 if !walls.is_empty() => to = random.pick(&walls)[1],
                _ => {}
            }
            if from != to {
                walls.push([from, to]);
            }
        }
        walls
    }

    fn ball(&self, random: &mut Random, is_peg: bool, case: &Case) -> Ball {
        let radius = random.pick(&[0.25, 0.5, 0.5, 1.0, 1.25]);
        let speed = random.pick(&[0.0, 2.0, 4.0]);
        let mut ball = Ball {
            place: random.point(0.0, SIDE, self.grain),
            velocity: random.point(-speed, speed, self.grain),
            radius,
            mass: random.pick(&[1.0, 1.0, 2.0, 3.0]),
        };
        if is_peg {
            ball.mass = f64::INFINITY;
            ball.velocity = match self.pistons {
                true => random.point(-1.0, 1.0, self.grain),
                false => [0.0; 2],
            };
        } else if self.touching && !random.one_in(3) {
            self.settle(&mut ball, random, case);
        }
        ball
    }

    /// Moves a ball until it touches something, exactly.
    fn settle(&self, ball: &mut Ball, random: &mut Random, case: &Case) {
        if !case.balls.is_empty() && random.one_in(3) {
            let other = &case.balls[random.below(case.balls.len() as u64) as usize];
            let reach = ball.radius + other.radius;
            let way = random.pick(&[[0.0, 1.0], [1.0, 0.0], [0.0, -1.0], [-1.0, 0.0]]);
            ball.place = plus(other.place, way, reach);
        } else if !case.walls.is_empty() {
            let [from, to] = random.pick(&case.walls);
            let place = random.pick(&[0.0, 0.25, 0.5, 0.75, 1.0]);
            let foot = plus(from, minus(to, from), place);
            let side = random.pick(&[1.0, -1.0]);
            if from[1] == to[1] {
                ball.place = [foot[0], foot[1] + side * ball.radius];
            } else if from[0] == to[0] {
                ball.place = [foot[0] + side * ball.radius, foot[1]];
            }
        }
        match random.below(4) {
            0 | 1 => ball.velocity = [0.0; 2],
            2 => ball.velocity[1] = 0.0,
            _ => ball.velocity[0] = 0.0,
        }
    }
}

/// Whether a ball overlaps nothing.
fn is_free(ball: &Ball, case: &Case) -> bool {
    let walls = case.walls.iter().all(|wall| {
        let (distance, _) = nearest(ball.place, *wall);
        distance >= ball.radius
    });
    walls
        && case
            .balls
            .iter()
            .all(|other| length(minus(ball.place, other.place)) >= ball.radius + other.radius)
}

/// The distance to a wall, and how far along it is nearest, from 0 to 1.
pub(crate) fn nearest(point: Point, [from, to]: [Point; 2]) -> (f64, f64) {
    let along = minus(to, from);
    let offset = minus(point, from);
    let part = (dot(offset, along) / dot(along, along)).clamp(0.0, 1.0);
    (length(minus(offset, plus([0.0; 2], along, part))), part)
}
