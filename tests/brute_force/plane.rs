//! Discs and walls in the plane, in binary64: the whole world moves from each
//! impact to the next one.

use carom::scalar::Number;
use carom::scene::{Mass, Restitution, Scene};

use super::gaps::{Point, Target, closes, dot, minus, moved};

/// More than any scene of these tests has.
const MOST_IMPACTS: usize = 1000;

/// An impact.
pub(crate) struct Event {
    pub(crate) time: f64,
    pub(crate) name: String,
}

/// How a scene fares.
pub(crate) struct Run {
    pub(crate) impacts: Vec<Event>,
    pub(crate) positions: Vec<Point>,
}

struct Disc {
    position: Point,
    velocity: Point,
    radius: f64,
    /// None if nothing deflects it.
    mass: Option<f64>,
}

struct Table {
    discs: Vec<Disc>,
    walls: Vec<[Point; 2]>,
    /// The coefficients between discs and with walls.
    restitution: [f64; 2],
    until: f64,
}

#[derive(Clone, Copy)]
enum Meeting {
    Discs(usize, usize),
    Wall(usize, usize),
}

/// Runs a scene to its end.
pub(crate) fn run(scene: &Scene) -> Run {
    let mut table = Table::new(scene);
    let (mut now, mut impacts) = (0.0, Vec::new());
    while let Some((delay, meeting)) = table.next(table.until - now) {
        now += delay;
        table.advance(delay);
        let name = table.name(meeting);
        impacts.push(Event { time: now, name });
        assert!(impacts.len() < MOST_IMPACTS, "{:?}", scene.id());
        table.collide(meeting);
    }
    table.advance(table.until - now);
    let positions = table.discs.iter().map(|disc| disc.position).collect();
    Run { impacts, positions }
}

fn point(written: &[Number; 2]) -> Point {
    [written[0].to_f64(), written[1].to_f64()]
}

impl Table {
    fn new(scene: &Scene) -> Self {
        let discs = scene.discs().iter().map(|disc| Disc {
            position: point(&disc.position),
            velocity: point(&disc.velocity),
            radius: disc.radius.to_f64(),
            mass: match &disc.mass {
                Mass::Finite(mass) => Some(mass.to_f64()),
                Mass::Infinite => None,
            },
        });
        let walls = scene.walls().iter();
        Self {
            discs: discs.collect(),
            walls: walls
                .map(|wall| [point(&wall.from), point(&wall.to)])
                .collect(),
            restitution: coefficients(&scene.effects().restitution),
            until: scene.frame().duration.to_f64() * scene.frame().count as f64,
        }
    }

    /// The next impact of all, if it is within some time.
    fn next(&self, within: f64) -> Option<(f64, Meeting)> {
        let count = self.discs.len();
        let discs = (0..count).flat_map(|i| (i + 1..count).map(move |j| Meeting::Discs(i, j)));
        let walls = self.walls.len();
        let walls = (0..count).flat_map(|i| (0..walls).map(move |j| Meeting::Wall(i, j)));
        discs
            .chain(walls)
            .filter_map(|meeting| Some((self.time_of(meeting, within)?, meeting)))
            .min_by(|(one, _), (other, _)| one.total_cmp(other))
    }

    fn time_of(&self, meeting: Meeting, within: f64) -> Option<f64> {
        match meeting {
            Meeting::Discs(i, j) => {
                let [a, b] = [&self.discs[i], &self.discs[j]];
                a.mass.or(b.mass)?;
                // As seen from the second disc.
                let velocity = minus(a.velocity, b.velocity);
                let target = Target::Point(b.position);
                closes(target, a.position, velocity, a.radius + b.radius, within)
            }
            Meeting::Wall(i, j) => {
                let disc = &self.discs[i];
                disc.mass?;
                closes(
                    self.wall(j),
                    disc.position,
                    disc.velocity,
                    disc.radius,
                    within,
                )
            }
        }
    }

    fn wall(&self, index: usize) -> Target {
        let [from, to] = self.walls[index];
        Target::Segment(from, to)
    }

    fn advance(&mut self, time: f64) {
        for disc in &mut self.discs {
            disc.position = moved(disc.position, disc.velocity, time);
        }
    }

    fn collide(&mut self, meeting: Meeting) {
        match meeting {
            Meeting::Discs(i, j) => {
                let (low, high) = self.discs.split_at_mut(j);
                let (a, b) = (&mut low[i], &mut high[0]);
                let axis = direction(a.position, b.position);
                let speeds = [dot(a.velocity, axis), dot(b.velocity, axis)];
                let after = exchange(speeds, [a.mass, b.mass], self.restitution[0]);
                a.velocity = moved(a.velocity, axis, after[0] - speeds[0]);
                b.velocity = moved(b.velocity, axis, after[1] - speeds[1]);
            }
            Meeting::Wall(i, j) => {
                let target = self.wall(j);
                let disc = &mut self.discs[i];
                let axis = direction(disc.position, target.nearest(disc.position));
                let speed = dot(disc.velocity, axis);
                let [after, _] = exchange([speed, 0.0], [disc.mass, None], self.restitution[1]);
                disc.velocity = moved(disc.velocity, axis, after - speed);
            }
        }
    }

    /// What the log says: an end point has the name of the lowest wall that
    /// ends there.
    fn name(&self, meeting: Meeting) -> String {
        let (disc, wall) = match meeting {
            Meeting::Discs(i, j) => return format!("d{i} d{j}"),
            Meeting::Wall(disc, wall) => (disc, wall),
        };
        let part = self.wall(wall).part(self.discs[disc].position);
        let end = match part {
            0.0 => 0,
            1.0 => 1,
            _ => return format!("d{disc} w{wall}"),
        };
        let corner = self.walls[wall][end];
        let lowest = self.walls.iter().enumerate().find_map(|(index, ends)| {
            let end = ends.iter().position(|&point| point == corner)?;
            Some((index, ["from", "to"][end]))
        });
        let (wall, end) = lowest.expect("the wall itself ends there");
        format!("d{disc} w{wall} {end}")
    }
}

/// The unit vector from one point to another.
fn direction(from: Point, to: Point) -> Point {
    let [x, y] = minus(to, from);
    let length = x.hypot(y);
    [x / length, y / length]
}

/// The speeds along one axis after an impact: in the frame of the centre of
/// mass each is reversed, and `e` times as large. The frame of a body that
/// nothing deflects is its own.
fn exchange(speeds: [f64; 2], masses: [Option<f64>; 2], e: f64) -> [f64; 2] {
    let centre = match masses {
        [Some(m), Some(n)] => (m * speeds[0] + n * speeds[1]) / (m + n),
        [None, _] => speeds[0],
        [_, None] => speeds[1],
    };
    speeds.map(|speed| centre - e * (speed - centre))
}

fn coefficients(restitution: &Restitution) -> [f64; 2] {
    match restitution {
        Restitution::Elastic => [1.0, 1.0],
        Restitution::Newton {
            coefficient, walls, ..
        } => [coefficient, walls.as_ref().unwrap_or(coefficient)].map(Number::to_f64),
        Restitution::Paper { .. } => unreachable!("no scene of these tests has it"),
    }
}
