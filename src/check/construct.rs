//! Scenes at the edge of what binary64 tells apart, made from bytes.
//!
//! Any bytes make a scene, and every scene is one that is worth a run: discs
//! that pass in tangency but for 2⁻ᵏ, impacts that are simultaneous but for
//! 2⁻ᵏ, contacts, corners, rows of discs between walls; far from the origin,
//! with masses of very different size, turned so that nothing is exact. Nothing
//! is drawn and rejected. Missing bytes count as zero.

use crate::scalar::Number;
use crate::scene::{Disc, DiscBuilder, Restitution, Scene, SceneBuilder};

/// The scene that bytes stand for.
pub fn scene(bytes: &[u8]) -> Scene {
    let mut bytes = Bytes(bytes);
    let place = Placement::from(&mut bytes);
    let mut parts = Parts::default();
    for cell in 0..=bytes.below(3) {
        parts.add(cell, &mut bytes);
    }
    if bytes.below(4) == 0 {
        parts.enclose();
    }
    let built = parts.scene(&place, &mut bytes).build();
    built.expect("what is constructed is valid")
}

/// Bytes that are read as choices.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn next(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else {
            return 0;
        };
        self.0 = rest;
        first
    }

    fn below(&mut self, count: u8) -> u8 {
        self.next() % count
    }

    /// A multiple of 1/8 from -4 to 4.
    fn eighths(&mut self) -> f64 {
        f64::from(i16::from(self.below(65)) - 32) / 8.0
    }

    /// A positive multiple of 1/8, at most 2.
    fn size(&mut self) -> f64 {
        f64::from(self.below(16) + 1) / 8.0
    }

    /// Mostly 1; else a power of two, up to 2²⁰.
    fn far(&mut self) -> f64 {
        match self.below(3) {
            0 => f64::from(self.below(21)).exp2(),
            _ => 1.0,
        }
    }

    /// Nothing, or 2⁻ᵏ with either sign, down to 2⁻⁶⁰.
    fn hair(&mut self) -> f64 {
        let choice = self.next();
        let hair = f64::from(-i32::from(choice >> 1) % 61).exp2();
        match choice {
            0..=9 => 0.0,
            _ if choice & 1 == 0 => hair,
            _ => -hair,
        }
    }
}

/// How a scene lies in the plane.
struct Placement {
    shift: [f64; 2],
    /// A vector of the length 1 or nearly so, that the x axis is turned to.
    axis: [f64; 2],
    /// A power of two.
    scale: f64,
}

impl Placement {
    fn from(bytes: &mut Bytes) -> Self {
        let axes = [
            [1.0, 0.0],
            [0.6, 0.8],
            [-5.0 / 13.0, 12.0 / 13.0],
            [0.0, -1.0],
        ];
        let axis = axes[usize::from(bytes.below(4))];
        let shift = [(); 2].map(|()| match bytes.below(4) {
            0 | 1 => 0.0,
            2 => f64::from(bytes.next()).exp2().min(2_f64.powi(40)),
            _ => bytes.eighths() * 1000.1,
        });
        let scale = match bytes.below(4) {
            0 => f64::from(i16::from(bytes.below(101)) - 50).exp2(),
            _ => 1.0,
        };
        Self { shift, axis, scale }
    }

    fn turned(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [cos, sin] = self.axis;
        [x * cos - y * sin, x * sin + y * cos].map(|coordinate| coordinate * self.scale)
    }

    fn placed(&self, point: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.turned(point);
        [
            x + self.shift[0] * self.scale,
            y + self.shift[1] * self.scale,
        ]
    }
}

/// A disc before it is placed.
struct Body {
    position: [f64; 2],
    velocity: [f64; 2],
    radius: f64,
}

#[derive(Default)]
struct Parts {
    bodies: Vec<Body>,
    walls: Vec<[[f64; 2]; 2]>,
}

/// Where the parts of a scene are: 16 apart.
const CELL: f64 = 16.0;

impl Parts {
    fn add(&mut self, cell: u8, bytes: &mut Bytes) {
        let origin = [f64::from(cell) * CELL, 0.0];
        match bytes.below(7) {
            0 => self.graze(origin, bytes),
            1 => self.tie(origin, bytes),
            2 => self.touch(origin, bytes),
            3 => self.corner(origin, bytes),
            4 => self.row(origin, bytes),
            5 => self.wedge(origin, bytes),
            _ => self.crowd(origin, bytes),
        }
    }

    fn disc(&mut self, position: [f64; 2], velocity: [f64; 2], radius: f64) {
        self.bodies.push(Body {
            position,
            velocity,
            radius,
        });
    }

    /// A disc that passes another one at a distance of the radii, nearly.
    fn graze(&mut self, [x, y]: [f64; 2], bytes: &mut Bytes) {
        let radii = [bytes.size(), bytes.size()];
        let beside = radii[0] + radii[1] + bytes.hair();
        let (speed, drift) = (bytes.size(), [bytes.eighths(), bytes.eighths()]);
        self.disc([x, y], drift, radii[0]);
        let far = bytes.far();
        let velocity = [drift[0] + speed * far, drift[1]];
        let start = x - (4.0 + bytes.size()) * far;
        self.disc([start, y + beside], velocity, radii[1]);
    }

    /// Two discs that meet a third one, or each another one, at nearly the same
    /// time.
    fn tie(&mut self, [x, y]: [f64; 2], bytes: &mut Bytes) {
        let (radius, speed, gap) = (bytes.size(), bytes.size(), bytes.size());
        let slant = if bytes.below(2) == 0 {
            0.0
        } else {
            bytes.eighths()
        };
        let far = 2.0 * radius + gap;
        self.disc([x, y], [0.0; 2], radius);
        self.disc([x - far - bytes.hair(), y], [speed, 0.0], radius);
        self.disc([x + far + bytes.hair(), y], [-speed, slant], radius);
        if bytes.below(2) == 1 {
            self.disc(
                [x + bytes.hair(), y - far + bytes.hair()],
                [0.0, speed],
                radius,
            );
        }
    }

    /// Discs that touch at the start, or overlap by a hair.
    fn touch(&mut self, [x, y]: [f64; 2], bytes: &mut Bytes) {
        let radii = [bytes.size(), bytes.size()];
        let apart = radii[0] + radii[1] + bytes.hair();
        let slope = [[1.0, 0.0], [0.6, 0.8], [0.8, -0.6]][usize::from(bytes.below(3))];
        let second = [x + slope[0] * apart, y + slope[1] * apart];
        self.disc([x, y], [bytes.eighths(), bytes.eighths()], radii[0]);
        self.disc(second, [bytes.eighths(), bytes.eighths()], radii[1]);
        if bytes.below(2) == 1 {
            let below = y - radii[0] + bytes.hair();
            self.walls.push([[x - 3.0, below], [x + 3.0, below]]);
        }
    }

    /// A disc that comes to the end of a wall: past it, upon it, beside it.
    fn corner(&mut self, [x, y]: [f64; 2], bytes: &mut Bytes) {
        let radius = bytes.size();
        self.walls.push([[x, y], [x + 4.0, y]]);
        let (along, far) = (bytes.hair(), bytes.far());
        let (height, speed) = (4.0 * far, bytes.size() * far);
        match bytes.below(3) {
            0 => self.disc([x + along, y + height], [0.0, -speed], radius),
            1 => self.disc([x - radius + along, y + height], [0.0, -speed], radius),
            _ => self.disc(
                [x - height, y + radius + along],
                [speed, bytes.hair()],
                radius,
            ),
        }
        if bytes.below(2) == 1 {
            self.walls.push([[x, y], [x + bytes.eighths(), y - 4.0]]);
        }
    }

    /// A row of discs between walls, where few move.
    fn row(&mut self, [x, y]: [f64; 2], bytes: &mut Bytes) {
        let count = 2 + bytes.below(4);
        let mut end = x + bytes.size() / 4.0;
        for _ in 0..count {
            let radius = 1.5 + bytes.hair();
            let speed = if bytes.below(2) == 0 {
                0.0
            } else {
                bytes.eighths()
            };
            self.disc([end + radius, y + bytes.hair()], [speed, 0.0], radius);
            end += 2.0 * radius + bytes.hair().abs();
        }
        end += bytes.size() / 4.0;
        self.walls.push([[x, y - 2.0], [x, y + 2.0]]);
        self.walls.push([[end, y - 2.0], [end, y + 2.0]]);
    }

    /// A disc between two walls that enclose an angle.
    fn wedge(&mut self, [x, y]: [f64; 2], bytes: &mut Bytes) {
        let radius = bytes.size() / 2.0;
        let slope = bytes.eighths().abs() + 0.5;
        self.walls.push([[x, y], [x + 8.0, y]]);
        self.walls.push([[x, y], [x + 8.0, y + 8.0 * slope]]);
        let height = radius + bytes.size() / 8.0 + bytes.hair();
        let away = x + 2.0 * height / slope.min(1.0) + 2.0;
        self.disc([away, y + height], [-bytes.size(), bytes.hair()], radius);
    }

    /// Discs in a grid that move to and fro.
    fn crowd(&mut self, [x, y]: [f64; 2], bytes: &mut Bytes) {
        for index in 0..2 + bytes.below(4) {
            let corner = [f64::from(index % 2), f64::from(index / 2)];
            let jitter = [bytes.eighths() / 16.0, bytes.eighths() / 16.0];
            let position = [
                x + 3.0 * corner[0] + jitter[0],
                y + 3.0 * corner[1] + jitter[1],
            ];
            self.disc(
                position,
                [bytes.eighths(), bytes.eighths()],
                0.5 + bytes.size() / 3.0,
            );
        }
    }

    /// Walls around all of it, near enough to be met.
    fn enclose(&mut self) {
        let [left, low, right, high] = [-10.0, -10.0, 48.0, 12.0];
        let corners = [[left, low], [right, low], [right, high], [left, high]];
        for side in 0..4 {
            self.walls.push([corners[side], corners[(side + 1) % 4]]);
        }
    }

    fn scene(self, place: &Placement, bytes: &mut Bytes) -> SceneBuilder {
        let durations = [16.0, 4.0, 1.0, 0.1];
        let duration = durations[usize::from(bytes.below(4))];
        let frames = 1 + u64::from(bytes.below(8));
        let scene = Scene::builder("constructed").frame(duration, frames);
        let scene = restitution(bytes)
            .into_iter()
            .fold(scene, SceneBuilder::restitution);
        let discs: Vec<_> = self
            .bodies
            .iter()
            .map(|body| body.placed(place, bytes))
            .collect();
        let walls = self
            .walls
            .iter()
            .map(|wall| wall.map(|end| place.placed(end)));
        let walls = walls.filter(|[from, to]| from != to);
        walls.fold(scene.discs(discs), |scene, [from, to]| scene.wall(from, to))
    }
}

impl Body {
    fn placed(&self, place: &Placement, bytes: &mut Bytes) -> DiscBuilder {
        let disc = Disc::at(place.placed(self.position), self.radius * place.scale);
        let disc = disc.velocity(place.turned(self.velocity));
        match bytes.below(8) {
            0..=3 => disc,
            4 => disc.infinite_mass(),
            5 => disc.mass(bytes.size()),
            _ => disc.mass(f64::from(i16::from(bytes.below(121)) - 60).exp2()),
        }
    }
}

fn restitution(bytes: &mut Bytes) -> Option<Restitution> {
    let quarters = |bytes: &mut Bytes| Number::try_from(f64::from(bytes.below(5)) / 4.0).ok();
    match bytes.below(4) {
        0 | 1 => None,
        2 => Some(Restitution::newton(quarters(bytes)?)),
        _ => Some(Restitution::Newton {
            coefficient: quarters(bytes)?,
            walls: quarters(bytes),
            elastic_below: Number::try_from(bytes.size()).ok(),
        }),
    }
}
