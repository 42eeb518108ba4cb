//! `parry2d`, which answers when two shapes in linear motion first meet.
//!
//! To `simulate`, the adapter has a loop of its own around that: it asks about every pair,
//! takes the earliest impact, gives the two bodies their velocities after it, and asks again
//! about all pairs with one of them.

use carom_adapters::{Body, Disc, Engine, Impact, Options, Plain, Restitution, Wall, serve};
use parry2d_f64::math::{Pose, Vector};
use parry2d_f64::query::{ShapeCastOptions, cast_shapes};
use parry2d_f64::shape::{Ball, Segment};

const USAGE: &str = "usage: parry2d [OPTION VALUE]…
  --max-impacts N   a run with more is refused (default 100000)";

fn main() -> std::io::Result<()> {
    let options = Options::of_program(USAGE, &["max-impacts"]);
    serve(&mut Parry {
        max_impacts: options.get("max-impacts").unwrap_or(100_000),
    })
}

struct Parry {
    max_impacts: usize,
}

impl Engine for Parry {
    fn simulate(&mut self, scene: &Plain) -> Result<Vec<Impact>, String> {
        if scene.gravity.is_some() {
            return Err(String::from("the engine's query is of linear motion only"));
        }
        let mut run = Run::new(scene)?;
        let mut impacts = Vec::new();
        while let Some((time, i, other)) = run.earliest() {
            if impacts.len() == self.max_impacts {
                return Err(format!("more than {} impacts", self.max_impacts));
            }
            if run.collide(time, i, other)? {
                impacts.push(match other {
                    Other::Disc(j) => Impact::of_discs(time, i, j),
                    Other::Wall(j) => Impact::with_wall(time, i, j),
                });
            }
        }
        Ok(impacts)
    }

    fn first_impact(&mut self, disc: &Disc, other: &Body) -> Result<Option<f64>, String> {
        let moving = Moving::new(disc);
        match other {
            Body::Disc(other) => of_discs(&moving, &Moving::new(other)),
            Body::Wall(wall) => with_wall(&moving, wall),
        }
    }
}

/// A disc at some time.
#[derive(Clone, Copy)]
struct Moving {
    time: f64,
    position: Vector,
    velocity: Vector,
    radius: f64,
    /// One divided by the mass.
    lightness: f64,
}

impl Moving {
    fn new(disc: &Disc) -> Self {
        Self {
            time: 0.0,
            position: vector(disc.position),
            velocity: vector(disc.velocity),
            radius: disc.radius,
            lightness: disc.mass.map_or(0.0, f64::recip),
        }
    }

    /// The same disc later.
    fn at(&self, time: f64) -> Self {
        Self {
            time,
            position: self.position + self.velocity * (time - self.time),
            ..*self
        }
    }
}

fn vector([x, y]: [f64; 2]) -> Vector {
    Vector::new(x, y)
}

/// The time until two discs meet, by the engine.
fn of_discs(one: &Moving, other: &Moving) -> Result<Option<f64>, String> {
    let [here, there] = [one, other].map(|disc| Pose::from_translation(disc.position));
    let [ball, target] = [one, other].map(|disc| Ball::new(disc.radius));
    let hit = cast_shapes(
        &here,
        one.velocity,
        &ball,
        &there,
        other.velocity,
        &target,
        asked(),
    );
    Ok(hit
        .map_err(|error| error.to_string())?
        .map(|hit| hit.time_of_impact))
}

/// The time until a disc meets a wall, by the engine.
fn with_wall(disc: &Moving, [from, to]: &Wall) -> Result<Option<f64>, String> {
    let here = Pose::from_translation(disc.position);
    let segment = Segment::new(vector(*from), vector(*to));
    let hit = cast_shapes(
        &here,
        disc.velocity,
        &Ball::new(disc.radius),
        &Pose::IDENTITY,
        Vector::ZERO,
        &segment,
        asked(),
    );
    Ok(hit
        .map_err(|error| error.to_string())?
        .map(|hit| hit.time_of_impact))
}

/// Bodies that touch and part are no impact; otherwise as it comes.
fn asked() -> ShapeCastOptions {
    ShapeCastOptions {
        stop_at_penetration: false,
        ..ShapeCastOptions::default()
    }
}

/// What a disc meets; discs come before walls.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Other {
    Disc(usize),
    Wall(usize),
}

/// A scene on its way.
struct Run<'a> {
    discs: Vec<Moving>,
    walls: &'a [Wall],
    restitution: Restitution,
    until: f64,
    /// When a disc meets each disc of lower index, and then each wall; never is infinite.
    forecasts: Vec<Vec<f64>>,
}

impl<'a> Run<'a> {
    fn new(scene: &'a Plain) -> Result<Self, String> {
        let (discs, walls) = (scene.discs.iter().map(Moving::new).collect(), &scene.walls);
        let never = |i| vec![f64::INFINITY; i + walls.len()];
        let mut run = Self {
            discs,
            walls,
            restitution: scene.restitution,
            until: scene.until(),
            forecasts: (0..scene.discs.len()).map(never).collect(),
        };
        for i in 0..run.discs.len() {
            run.forecast(i, 0.0, 0..i)?;
        }
        Ok(run)
    }

    /// Asks when a disc meets these others, and the walls.
    fn forecast(
        &mut self,
        i: usize,
        now: f64,
        others: impl Iterator<Item = usize>,
    ) -> Result<(), String> {
        let disc = self.discs[i].at(now);
        for j in others.filter(|j| *j != i) {
            let other = self.discs[j].at(now);
            let (low, high) = (i.min(j), i.max(j));
            self.forecasts[high][low] = match disc.lightness + other.lightness > 0.0 {
                true => later(now, of_discs(&disc, &other)?)?,
                false => f64::INFINITY,
            };
        }
        for (j, wall) in self.walls.iter().enumerate() {
            self.forecasts[i][i + j] = match disc.lightness > 0.0 {
                true => later(now, with_wall(&disc, wall)?)?,
                false => f64::INFINITY,
            };
        }
        Ok(())
    }

    /// The next impact of the run, if any; of several at one time that of the lowest bodies,
    /// discs before walls.
    fn earliest(&self) -> Option<(f64, usize, Other)> {
        let rows = self.forecasts.iter().enumerate();
        let all = rows.flat_map(|(i, row)| {
            let meetings = row.iter().enumerate();
            meetings.map(move |(place, time)| match place.checked_sub(i) {
                None => (*time, place, Other::Disc(i)),
                Some(wall) => (*time, i, Other::Wall(wall)),
            })
        });
        let within = all.filter(|(time, ..)| *time <= self.until);
        within.min_by(|(time, i, other), (least, j, lowest)| {
            time.total_cmp(least).then((i, other).cmp(&(j, lowest)))
        })
    }

    /// Gives two bodies their velocities after an impact, if they approach.
    fn collide(&mut self, time: f64, i: usize, other: Other) -> Result<bool, String> {
        let disc = self.discs[i].at(time);
        let target = match other {
            Other::Disc(j) => self.discs[j].at(time),
            Other::Wall(j) => standing(&self.walls[j], &disc),
        };
        let normal = (target.position - disc.position).normalize_or_zero();
        let approach = (disc.velocity - target.velocity).dot(normal);
        if approach <= 0.0 {
            self.forget(i, other);
            return Ok(false);
        }
        let impulse = (1.0 + self.coefficient(other, approach)) * approach
            / (disc.lightness + target.lightness);
        let turned = |disc: Moving, impulse: f64| Moving {
            velocity: disc.velocity + normal * (impulse * disc.lightness),
            ..disc
        };
        self.discs[i] = turned(disc, -impulse);
        if let Other::Disc(j) = other {
            self.discs[j] = turned(target, impulse);
            self.forecast(j, time, 0..self.discs.len())?;
        }
        self.forecast(i, time, 0..self.discs.len())?;
        Ok(true)
    }

    fn coefficient(&self, other: Other, approach: f64) -> f64 {
        let below = self.restitution.elastic_below;
        match other {
            _ if below.is_some_and(|speed| approach < speed) => 1.0,
            Other::Disc(_) => self.restitution.discs,
            Other::Wall(_) => self.restitution.walls,
        }
    }

    /// Leaves out a meeting of bodies that do not approach.
    fn forget(&mut self, i: usize, other: Other) {
        match other {
            Other::Disc(j) => self.forecasts[i.max(j)][i.min(j)] = f64::INFINITY,
            Other::Wall(j) => self.forecasts[i][i + j] = f64::INFINITY,
        }
    }
}

fn later(now: f64, wait: Option<f64>) -> Result<f64, String> {
    match wait {
        None => Ok(f64::INFINITY),
        Some(wait) if wait.is_finite() => Ok(now + wait),
        Some(_) => Err(String::from("the engine's time is not finite")),
    }
}

/// The point of a wall that is nearest to a disc, as a body that stands.
fn standing([from, to]: &Wall, disc: &Moving) -> Moving {
    let (from, to) = (vector(*from), vector(*to));
    let along = to - from;
    let part = (disc.position - from).dot(along) / along.dot(along);
    Moving {
        position: from + along * part.clamp(0.0, 1.0),
        velocity: Vector::ZERO,
        lightness: 0.0,
        ..*disc
    }
}
