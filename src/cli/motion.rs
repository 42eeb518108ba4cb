//! The motion of a run, for pictures: of each disc the legs between its impacts.
//!
//! On the timeline a leg is what the effects make of a position and a velocity, in
//! closed form. Within a frame of a frame algorithm all motion is straight, on the
//! disc's own clock: a leg goes from one known state to the next, so that a disc which
//! waits at its last impact for the frame to end is seen to wait.
//!
//! All numbers are rounded to binary64: this is to be looked at, not to be judged.

use carom::arithmetic::Arithmetic;
use carom::body::BodyId;
use carom::impact::{Contact, Impact};
use carom::run::Outcome;
use carom::scene::{Mass, Scene};
use carom::simulation::{Algorithm, FrameClock, Simulation};
use carom::vec2::Vec2;
use serde::Serialize;

/// A point or a vector.
pub(super) type Point = [f64; 2];

/// A turn that cannot be seen, as a part of the speed.
const INVISIBLE: f64 = 1e-9;

/// A run, as it is seen.
#[derive(Debug, Serialize)]
pub(super) struct Motion {
    pub(super) until: f64,
    pub(super) discs: Vec<Track>,
    pub(super) impacts: Vec<Mark>,
}

/// The way of a disc.
#[derive(Debug, Serialize)]
pub(super) struct Track {
    pub(super) radius: f64,
    pub(super) fixed: bool,
    pub(super) pull: Pull,
    pub(super) legs: Vec<Leg>,
}

/// What acts on a disc on its legs: v' = gravity - drag v.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub(super) struct Pull {
    pub(super) gravity: Point,
    pub(super) drag: f64,
}

/// Motion from a time on, up to the next leg's.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(into = "[f64; 5]")]
pub(super) struct Leg {
    pub(super) time: f64,
    pub(super) position: Point,
    pub(super) velocity: Point,
}

impl From<Leg> for [f64; 5] {
    fn from(leg: Leg) -> Self {
        let ([x, y], [vx, vy]) = (leg.position, leg.velocity);
        [leg.time, x, y, vx, vy]
    }
}

/// An impact: who, when, where, and the velocities after.
#[derive(Debug, Serialize)]
pub(super) struct Mark {
    pub(super) time: f64,
    pub(super) a: String,
    pub(super) b: String,
    pub(super) bodies: Vec<Struck>,
}

/// A disc at an impact, on its own clock.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(into = "Place")]
pub(super) struct Struck {
    pub(super) disc: usize,
    pub(super) leg: Leg,
}

/// A disc, and where it is.
pub(super) type Place = (usize, f64, f64);

impl From<Struck> for Place {
    fn from(struck: Struck) -> Self {
        let [x, y] = struck.leg.position;
        (struck.disc, x, y)
    }
}

impl Motion {
    /// The motion of a run that has kept the circumstances of its impacts.
    pub(super) fn new<S: Arithmetic>(
        scene: &Scene,
        algorithm: Algorithm,
        outcome: &Outcome<S>,
    ) -> Self {
        let mut motion = match algorithm {
            Algorithm::Timeline => Self::of_timeline(scene, outcome),
            _ => Self::of_frames(scene, algorithm, outcome),
        };
        // A frame's impacts stand in the order of passes and pairs.
        motion
            .impacts
            .sort_by(|one, other| one.time.total_cmp(&other.time));
        motion
    }

    fn start<S: Arithmetic>(scene: &Scene, outcome: &Outcome<S>, pull: Pull) -> Self {
        let bodies = scene.discs().iter().zip(&outcome.start);
        let track = |(body, start): (&carom::scene::Disc, &carom::body::Disc<S>)| {
            let fixed = body.mass == Mass::Infinite;
            Track {
                radius: start.radius.to_f64(),
                fixed,
                pull: if fixed { Pull::default() } else { pull },
                legs: vec![leg(0.0, &start.position, &start.velocity)],
            }
        };
        Self {
            until: outcome.time.to_f64(),
            discs: bodies.map(track).collect(),
            impacts: Vec::new(),
        }
    }

    fn of_timeline<S: Arithmetic>(scene: &Scene, outcome: &Outcome<S>) -> Self {
        let mut motion = Self::start(scene, outcome, Pull::of(scene));
        for impact in &outcome.impacts {
            motion.strike(impact);
        }
        motion
    }

    /// The log does not tell where discs are when a frame ends: the frames are
    /// simulated once more.
    fn of_frames<S: Arithmetic>(scene: &Scene, algorithm: Algorithm, outcome: &Outcome<S>) -> Self {
        let mut motion = Self::start(scene, outcome, Pull::default());
        let clock = FrameClock::new(scene.frame());
        let Ok(mut simulation) = Simulation::<S>::new(scene, algorithm, outcome.precision) else {
            return motion;
        };
        for frame in 1.. {
            let end = clock.start_of::<S>(frame, outcome.precision).to_f64();
            if end > motion.until {
                break;
            }
            let Ok(impacts) = simulation.next_frame() else {
                break;
            };
            impacts.iter().for_each(|impact| motion.strike(impact));
            for (track, disc) in motion.discs.iter_mut().zip(simulation.discs()) {
                track.legs.push(leg(end, &disc.position, &disc.velocity));
            }
        }
        motion.discs.iter_mut().for_each(Track::straighten);
        motion
    }

    /// Starts the legs after an impact.
    fn strike<S: Arithmetic>(&mut self, impact: &Impact<S>) {
        let Some(contact) = &impact.contact else {
            return;
        };
        let bodies = struck(impact, contact);
        for Struck { disc, leg } in &bodies {
            let track = &mut self.discs[*disc];
            if !track.fixed {
                track.legs.push(*leg);
            }
        }
        self.impacts.push(Mark {
            time: impact.time.to_f64(),
            a: impact.pair.a.to_string(),
            b: impact.pair.b.to_string(),
            bodies,
        });
    }
}

/// The discs at an impact.
fn struck<S: Arithmetic>(impact: &Impact<S>, contact: &Contact<S>) -> Vec<Struck> {
    let time = impact.time.to_f64();
    let centre = &contact.centre;
    let other_centre = centre.plus(&contact.normal);
    let other = contact.other_velocity.as_ref().map(|velocity| {
        let time = impact.other_time.as_ref().map_or(time, S::to_f64);
        (impact.pair.b, leg(time, &other_centre, velocity))
    });
    let first = (impact.pair.a, leg(time, centre, &contact.velocity));
    let both = std::iter::once(first).chain(other);
    both.filter_map(|(body, leg)| match body {
        BodyId::Disc(disc) => Some(Struck {
            disc: disc as usize,
            leg,
        }),
        BodyId::Wall(_) => None,
    })
    .collect()
}

impl Pull {
    fn of(scene: &Scene) -> Self {
        let effects = scene.effects();
        let gravity = effects.gravity.as_ref();
        Self {
            gravity: gravity.map_or([0.0; 2], |g| [g[0].to_f64(), g[1].to_f64()]),
            drag: effects.drag.as_ref().map_or(0.0, |rate| rate.to_f64()),
        }
    }
}

impl Leg {
    /// Whether another leg only goes on with this one, as far as can be seen.
    fn leads_to(&self, next: &Self) -> bool {
        let time = next.time - self.time;
        let apart = [0, 1].map(|axis| {
            let turn = next.velocity[axis] - self.velocity[axis];
            let jump = self.position[axis] + self.velocity[axis] * time - next.position[axis];
            turn.abs() + jump.abs()
        });
        let size = self.velocity[0].abs() + self.velocity[1].abs();
        apart[0] + apart[1] <= INVISIBLE * size
    }
}

impl Pull {
    /// Where a leg leads: p + v t + g t²/2, and under drag k, with the final velocity
    /// u = g / k, p + u t + (v - u) (1 - exp(-k t)) / k.
    fn after(self, leg: &Leg, time: f64) -> Point {
        [0, 1].map(|axis| {
            let (from, speed, pull) = (leg.position[axis], leg.velocity[axis], self.gravity[axis]);
            if self.drag == 0.0 {
                return from + speed * time + pull * time * time / 2.0;
            }
            let last = pull / self.drag;
            from + last * time - (speed - last) * (-self.drag * time).exp_m1() / self.drag
        })
    }

    /// The velocity then: v + g t, and under drag u + (v - u) exp(-k t).
    fn velocity_after(self, leg: &Leg, time: f64) -> Point {
        [0, 1].map(|axis| {
            let (speed, pull) = (leg.velocity[axis], self.gravity[axis]);
            if self.drag == 0.0 {
                return speed + pull * time;
            }
            let last = pull / self.drag;
            last + (speed - last) * (-self.drag * time).exp()
        })
    }

    /// Whether legs are straight.
    pub(super) fn is_straight(self) -> bool {
        self.gravity == [0.0; 2]
    }
}

impl Track {
    /// Where the disc is at a time.
    pub(super) fn at(&self, time: f64) -> Point {
        let leg = self.leg_at(time);
        self.pull.after(leg, time - leg.time)
    }

    /// How fast it moves then; after what happens at that time.
    pub(super) fn velocity_at(&self, time: f64) -> Point {
        let leg = self.leg_at(time);
        self.pull.velocity_after(leg, time - leg.time)
    }

    /// The leg that has begun last: there is one from the start on.
    fn leg_at(&self, time: f64) -> &Leg {
        let next = self.legs.partition_point(|leg| leg.time <= time);
        &self.legs[next.saturating_sub(1)]
    }

    /// Puts the legs in the order of their times, and makes each of them the straight way to the next one's start.
    fn straighten(&mut self) {
        self.legs
            .sort_by(|one, other| one.time.total_cmp(&other.time));
        for next in 1..self.legs.len() {
            let [from, to] = [self.legs[next - 1], self.legs[next]];
            let time = to.time - from.time;
            let along = |axis: usize| match time > 0.0 {
                true => (to.position[axis] - from.position[axis]) / time,
                false => 0.0,
            };
            self.legs[next - 1].velocity = [along(0), along(1)];
        }
        self.legs.dedup_by(|next, leg| leg.leads_to(next));
    }
}

fn leg<S: Arithmetic>(time: f64, position: &Vec2<S>, velocity: &Vec2<S>) -> Leg {
    let point = |vector: &Vec2<S>| [vector.x.to_f64(), vector.y.to_f64()];
    Leg {
        time,
        position: point(position),
        velocity: point(velocity),
    }
}
