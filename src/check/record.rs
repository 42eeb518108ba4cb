//! What a timeline did: its state before and after each of its impacts.

use super::bodies::{Bodies, Motion, discs};
use super::window::Window;
use crate::arithmetic::Arithmetic;
use crate::body::{BodyId, Disc, End, Pair};
use crate::impact::Impact;
use crate::scene::Scene;
use crate::simulation::FrameClock;
use crate::timeline::Timeline;
use crate::world::{Obstacle, World};

/// An impact that a run says there is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Claim {
    pub(super) pair: (usize, Obstacle),
    pub(super) end: Option<End>,
    pub(super) time: f64,
}

/// The start of a run.
#[derive(Clone, Debug)]
pub(super) struct Record {
    pub(super) bodies: Bodies,
    pub(super) claims: Vec<Claim>,
    /// The state before each claim, and that after the last one.
    pub(super) states: Vec<Vec<Motion>>,
    /// The time of the end, if the run got there.
    pub(super) until: Option<f64>,
}

impl Record {
    /// Runs a scene up to so many impacts; none if the arithmetic leaves it
    /// open what comes first. A later decision left open ends the record.
    pub(super) fn of<S: Arithmetic>(scene: &Scene, most: usize) -> Option<Self> {
        let precision = S::first_precision(&Default::default());
        let end: S = FrameClock::new(scene.frame()).start_of(scene.frame().count, precision);
        let world = World::<S>::new(scene, precision);
        let bodies = Bodies::of(&world);
        let mut timeline = Timeline::new(world, &end).ok()?;
        let mut record = Self {
            bodies,
            claims: Vec::new(),
            states: vec![state(&timeline)],
            until: None,
        };
        while record.claims.len() < most {
            match timeline.next_impact(&end) {
                Ok(Some(impact)) => record.note(Claim::of(&impact), state(&timeline)),
                Ok(None) if timeline.accumulation().is_none() => {
                    record.until = Some(end.to_f64());
                    break;
                }
                Ok(None) | Err(_) => break,
            }
        }
        Some(record)
    }

    fn note(&mut self, claim: Claim, mut state: Vec<Motion>) {
        let before = &self.states[self.claims.len()];
        for (now, then) in state.iter_mut().zip(before) {
            (now.pace, now.blur) = (then.pace, then.blur);
        }
        let speeds = discs(claim.pair).flat_map(|disc| [before[disc].speed(), state[disc].speed()]);
        let pace = speeds.fold(0.0, f64::max);
        let margin = Window::new(&self.bodies, before, claim.time).margin(claim.pair);
        for disc in self.bodies.movable(claim.pair) {
            state[disc].pace = pace;
            state[disc].blur += margin;
        }
        self.claims.push(claim);
        self.states.push(state);
    }

    /// All that is recorded, to the last bit.
    pub(super) fn is_identical(&self, other: &Self) -> bool {
        let claims = |record: &Self| -> Vec<_> {
            let claims = record.claims.iter();
            claims
                .map(|claim| (claim.pair, claim.end, claim.time.to_bits()))
                .collect()
        };
        let states = |record: &Self| -> Vec<_> {
            record.states.iter().flatten().map(Motion::bits).collect()
        };
        claims(self) == claims(other) && states(self) == states(other)
    }
}

impl Claim {
    pub(super) fn of<S: Arithmetic>(impact: &Impact<S>) -> Self {
        Self {
            pair: bodies(&impact.pair),
            end: impact.end,
            time: impact.time.to_f64(),
        }
    }
}

/// A pair by the places of its bodies.
fn bodies(pair: &Pair) -> (usize, Obstacle) {
    let index = |body| match body {
        BodyId::Disc(index) | BodyId::Wall(index) => index as usize,
    };
    let obstacle = match pair.b {
        BodyId::Disc(other) => Obstacle::Disc(other as usize),
        BodyId::Wall(wall) => Obstacle::Wall(wall as usize),
    };
    (index(pair.a), obstacle)
}

/// A pair by its names.
pub(super) fn names((disc, obstacle): (usize, Obstacle)) -> Pair {
    let other = match obstacle {
        Obstacle::Disc(other) => BodyId::Disc(other as u32),
        Obstacle::Wall(wall) => BodyId::Wall(wall as u32),
    };
    Pair::new(BodyId::Disc(disc as u32), other)
}

fn state<S: Arithmetic>(timeline: &Timeline<S>) -> Vec<Motion> {
    let motion = |(disc, since): (&Disc<S>, &S)| Motion::of(disc, since);
    timeline.bodies().map(motion).collect()
}
