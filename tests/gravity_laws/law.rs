//! The laws, checked on a log: it is walked through with formulas of its own,
//! in binary64.

use carom::body::BodyId;
use carom::impact::Impact;
use carom::run::{Outcome, Status};
use carom::scalar::Scalar;

use super::case::{Ball, Case, Point, dot, length, minus, nearest, plus};

/// How far bodies may overlap, or a law be off, for it all is rounded.
const TOLERANCE: f64 = 1e-7;

/// Slower than this is at rest.
const STILL: f64 = 1e-9;

/// A disc in flight, since some time.
#[derive(Clone, Debug)]
struct Flight {
    place: Point,
    velocity: Point,
    since: f64,
    holds: Vec<usize>,
}

pub(crate) struct Walk<'a> {
    case: &'a Case,
    flights: Vec<Flight>,
}

fn vector<S: Scalar>(vector: &carom::vec2::Vec2<S>) -> Point {
    [vector.x.to_f64(), vector.y.to_f64()]
}

/// Walks through a log. Says what is wrong.
pub(crate) fn check<S: Scalar>(case: &Case, outcome: &Outcome<S>) -> Result<(), String> {
    let flight = |ball: &Ball| Flight {
        place: ball.place,
        velocity: ball.velocity,
        since: 0.0,
        holds: Vec::new(),
    };
    let mut walk = Walk {
        case,
        flights: case.balls.iter().map(flight).collect(),
    };
    let energy = walk.energy(0.0);
    let mut now = 0.0;
    let count = outcome.impacts.len();
    for (n, impact) in outcome.impacts.iter().enumerate() {
        let time = impact.time.to_f64();
        if time < now - 1e-12 {
            return Err(format!("#{n}: {time} is before {now}"));
        }
        if time > now {
            walk.cross(now, time)
                .map_err(|text| format!("#{n}: before: {text}"))?;
        }
        walk.collide(time, impact)
            .map_err(|text| format!("#{n} at {time}: {text}"))?;
        if case.is_conservative() {
            let found = walk.energy(time);
            if (found - energy).abs() > 1e-7 * (1.0 + energy.abs()) {
                return Err(format!("#{n}: energy {found} instead of {energy}"));
            }
        }
        now = time;
    }
    let end = outcome.time.to_f64();
    let whole = outcome.status == Status::Complete;
    walk.cross(now, end.max(now))
        .map_err(|text| format!("#{count}: to the end: {text}"))?;
    for (index, disc) in outcome.end.iter().enumerate() {
        let (place, velocity) = walk.at(index, end);
        let off = length(minus(place, vector(&disc.position)));
        let slip = length(minus(velocity, vector(&disc.velocity)));
        if whole && off.max(slip) > 1e-6 {
            return Err(format!(
                "d{index} ends {off} and {slip} off: {place:?} {velocity:?}"
            ));
        }
    }
    Ok(())
}

/// Through air, by v' = g - k v: towards the velocity g / k.
fn faded(flight: &Flight, gravity: Point, k: f64, t: f64) -> (Point, Point) {
    let [ahead, left] = [-(-k * t).exp_m1() / k, (-k * t).exp()];
    let last = plus([0.0; 2], gravity, 1.0 / k);
    let excess = minus(flight.velocity, last);
    let place = plus(plus(flight.place, last, t), excess, ahead);
    (place, plus(last, excess, left))
}

/// What a disc touches: how far it is, and where it is nearest.
fn touch(case: &Case, place: Point, body: BodyId) -> (f64, Point) {
    match body {
        BodyId::Wall(wall) => {
            let wall = case.walls[wall as usize];
            let (distance, part) = nearest(place, wall);
            (distance, plus(wall[0], minus(wall[1], wall[0]), part))
        }
        BodyId::Disc(_) => unreachable!(),
    }
}

impl Walk<'_> {
    fn pull(&self, disc: usize) -> Point {
        match self.case.balls[disc].mass.is_finite() {
            true => self.held(disc, self.case.gravity),
            false => [0.0; 2],
        }
    }

    /// What walls leave of a vector.
    fn held(&self, disc: usize, vector: Point) -> Point {
        let holds = &self.flights[disc].holds;
        let project = |wall: usize, vector: Point| {
            let [from, to] = self.case.walls[wall];
            let along = minus(to, from);
            plus([0.0; 2], along, dot(vector, along) / dot(along, along))
        };
        match holds[..] {
            [] => vector,
            [wall] => project(wall, vector),
            _ => [0.0; 2],
        }
    }

    fn at(&self, disc: usize, time: f64) -> (Point, Point) {
        let flight = &self.flights[disc];
        let pull = self.pull(disc);
        let t = time - flight.since;
        match self.case.drag {
            k if k > 0.0 && self.case.balls[disc].mass.is_finite() => faded(flight, pull, k, t),
            _ => {
                let place = plus(plus(flight.place, flight.velocity, t), pull, t * t / 2.0);
                (place, plus(flight.velocity, pull, t))
            }
        }
    }

    fn energy(&self, time: f64) -> f64 {
        let parts = self.case.balls.iter().enumerate().map(|(disc, ball)| {
            let (place, velocity) = self.at(disc, time);
            match ball.mass.is_finite() {
                true => ball.mass * (dot(velocity, velocity) / 2.0 - dot(place, self.case.gravity)),
                false => 0.0,
            }
        });
        parts.sum()
    }

    /// Which walls hold a disc that is at a place at a time.
    fn settle(&mut self, disc: usize, time: f64) {
        let (place, velocity) = self.at(disc, time);
        self.flights[disc] = Flight {
            place,
            velocity,
            since: time,
            holds: Vec::new(),
        };
        if self.case.balls[disc].mass.is_infinite() {
            return;
        }
        let radius = self.case.balls[disc].radius;
        let mut holds: Vec<usize> = Vec::new();
        for (index, wall) in self.case.walls.iter().enumerate() {
            let along = minus(wall[1], wall[0]);
            let part = dot(minus(place, wall[0]), along) / dot(along, along);
            let (distance, _) = nearest(place, *wall);
            if (distance - radius).abs() > 1e-8 || !(-1e-9..=1.0 + 1e-9).contains(&part) {
                continue;
            }
            let foot = plus(wall[0], along, part);
            let normal = plus([0.0; 2], minus(foot, place), 1.0 / radius);
            let leaves = part < 1e-9 && dot(velocity, along) < -STILL
                || part > 1.0 - 1e-9 && dot(velocity, along) > STILL;
            if dot(velocity, normal).abs() < STILL
                && dot(self.case.gravity, normal) > STILL
                && !leaves
            {
                holds.push(index);
            }
        }
        // Walls on one line hold as one.
        holds.dedup_by(|b, a| {
            let [one, two] =
                [*a, *b].map(|wall| minus(self.case.walls[wall][1], self.case.walls[wall][0]));
            (one[0] * two[1] - one[1] * two[0]).abs() < 1e-9
        });
        if holds.len() > 1 && length(velocity) > STILL {
            holds.retain(|&wall| {
                let along = minus(self.case.walls[wall][1], self.case.walls[wall][0]);
                (along[0] * velocity[1] - along[1] * velocity[0]).abs() < STILL
            });
        }
        self.flights[disc].holds = holds;
        self.flights[disc].velocity = self.held(disc, velocity);
    }

    /// When a held disc gets to an end of its wall, through air: by halves, from
    /// the first of many times at which it is beyond.
    fn fades_until(&self, disc: usize, wall: usize) -> Option<f64> {
        let [from, to] = self.case.walls[wall];
        let along = minus(to, from);
        let since = self.flights[disc].since;
        let part = |t: f64| {
            let (place, _) = self.at(disc, since + t);
            dot(minus(place, from), along) / dot(along, along)
        };
        let is_beyond = |t: f64| !(-1e-12..=1.0 + 1e-12).contains(&part(t));
        let step = 1e-3;
        let steps = (self.case.duration / step) as u32;
        let first = (1..=steps).find(|&count| is_beyond(step * f64::from(count)))?;
        let [mut low, mut high] = [first - 1, first].map(|count| step * f64::from(count));
        for _ in 0..60 {
            let middle = (low + high) / 2.0;
            if is_beyond(middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
        Some(since + high)
    }

    /// When a held disc gets to an end of its wall.
    fn slides_until(&self, disc: usize) -> Option<f64> {
        let flight = &self.flights[disc];
        let [wall] = flight.holds[..] else {
            return None;
        };
        if self.case.drag > 0.0 {
            return self.fades_until(disc, wall);
        }
        let [from, to] = self.case.walls[wall];
        let along = minus(to, from);
        let square = dot(along, along);
        let place = dot(minus(flight.place, from), along) / square;
        let speed = dot(flight.velocity, along) / square;
        let pull = dot(self.pull(disc), along) / square / 2.0;
        let mut found = None::<f64>;
        for end in [0.0, 1.0] {
            let c = place - end;
            let roots = if pull.abs() < 1e-14 {
                vec![-c / speed]
            } else {
                let root = (speed * speed - 4.0 * pull * c).sqrt();
                vec![
                    (-speed + root) / (2.0 * pull),
                    (-speed - root) / (2.0 * pull),
                ]
            };
            for root in roots {
                let heading = speed + 2.0 * pull * root;
                let outward = if end == 0.0 {
                    heading < 0.0
                } else {
                    heading > 0.0
                };
                if root > -1e-12 && outward && found.is_none_or(|best| root < best) {
                    found = Some(root.max(0.0));
                }
            }
        }
        found.map(|root| flight.since + root)
    }

    /// From one time to another nothing must collide.
    fn cross(&mut self, from: f64, to: f64) -> Result<(), String> {
        for disc in 0..self.flights.len() {
            if self.flights[disc].holds.is_empty() && self.flights[disc].since == from {
                self.settle(disc, from);
            }
        }
        let mut now = from;
        for _ in 0..50 {
            let slides = (0..self.flights.len())
                .filter_map(|disc| Some((self.slides_until(disc)?, disc)))
                .filter(|(time, _)| *time < to - 1e-12)
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let until = slides.map_or(to, |(time, _)| time.max(now));
            self.sample(now, until)?;
            now = until;
            let Some((_, disc)) = slides else {
                return Ok(());
            };
            self.settle(disc, now);
        }
        Err("slides for ever".into())
    }

    fn sample(&self, from: f64, to: f64) -> Result<(), String> {
        let count = (((to - from) * 200.0) as usize).clamp(20, 2000);
        for step in 0..=count {
            let time = from + (to - from) * step as f64 / count as f64;
            self.check_apart(time)?;
        }
        Ok(())
    }

    fn check_apart(&self, time: f64) -> Result<(), String> {
        let places: Vec<Point> = (0..self.flights.len())
            .map(|disc| self.at(disc, time).0)
            .collect();
        for (i, ball) in self.case.balls.iter().enumerate() {
            for (j, other) in self.case.balls.iter().enumerate().skip(i + 1) {
                let gap = length(minus(places[i], places[j])) - ball.radius - other.radius;
                let fixed = ball.mass.is_infinite() && other.mass.is_infinite();
                if gap < -TOLERANCE && !fixed {
                    return Err(format!("d{i} and d{j} overlap by {} at {time}", -gap));
                }
            }
            if ball.mass.is_infinite() {
                continue;
            }
            for (w, wall) in self.case.walls.iter().enumerate() {
                let gap = nearest(places[i], *wall).0 - ball.radius;
                if gap < -TOLERANCE {
                    return Err(format!("d{i} and w{w} overlap by {} at {time}", -gap));
                }
            }
        }
        Ok(())
    }

    fn collide<S: Scalar>(&mut self, time: f64, impact: &Impact<S>) -> Result<(), String> {
        let (a, b) = (impact.pair.a, impact.pair.b);
        let contact = impact.contact.as_ref().ok_or("no contact")?;
        let BodyId::Disc(first) = a else {
            return Err("no disc".into());
        };
        let first = first as usize;
        let name = format!("{a} {b}");
        let (place, velocity) = self.at(first, time);
        let off = length(minus(place, vector(&contact.centre)));
        if off > TOLERANCE {
            return Err(format!("{name}: centre off by {off}"));
        }
        let ball = &self.case.balls[first];
        let (target, reach, other) = match b {
            BodyId::Disc(second) => {
                let (place, velocity) = self.at(second as usize, time);
                let reach = ball.radius + self.case.balls[second as usize].radius;
                (place, reach, Some((second as usize, velocity)))
            }
            BodyId::Wall(_) => (touch(self.case, place, b).1, ball.radius, None),
        };
        let gap = length(minus(target, place)) - reach;
        if gap.abs() > TOLERANCE {
            return Err(format!("{name}: a gap of {gap}"));
        }
        let normal = plus([0.0; 2], minus(target, place), 1.0 / reach);
        let [one, two] = [
            1.0 / ball.mass,
            other.map_or(0.0, |(other, _)| 1.0 / self.case.balls[other].mass),
        ];
        let closing = dot(minus(velocity, other.map_or([0.0; 2], |(_, v)| v)), normal);
        if closing <= -TOLERANCE {
            return Err(format!("{name}: they do not approach: {closing}"));
        }
        let after = vector(&contact.velocity);
        let kept = match self.case.elastic_below {
            // What rounding decides is taken as it is.
            Some(limit) if (closing - limit).abs() < STILL => {
                let parting = -dot(minus(after, velocity), normal);
                parting * (one + two) / (one * closing) - 1.0
            }
            Some(limit) if closing < limit => 1.0,
            _ => self.case.kept,
        };
        let push = (1.0 + kept) * closing / (one + two);
        let expected = plus(velocity, normal, -push * one);
        if length(minus(expected, after)) > 1e-6 {
            return Err(format!("{name}: {after:?} instead of {expected:?}"));
        }
        self.set(first, place, after, time);
        if let Some((second, velocity)) = other {
            let expected = plus(velocity, normal, push * two);
            let after = contact
                .other_velocity
                .as_ref()
                .map(vector)
                .ok_or("no velocity")?;
            if length(minus(expected, after)) > 1e-6 {
                return Err(format!("{name}: {after:?} instead of {expected:?} for {b}"));
            }
            self.set(second, target, after, time);
        }
        Ok(())
    }

    fn set(&mut self, disc: usize, place: Point, velocity: Point, since: f64) {
        if self.case.balls[disc].mass.is_finite() {
            self.flights[disc] = Flight {
                place,
                velocity,
                since,
                holds: Vec::new(),
            };
        }
    }
}
