//! One algorithm in one arithmetic: frame by frame, or from start to end.

use std::fmt;

use num_rational::BigRational;

use crate::arithmetic::Arithmetic;
use crate::body::Disc;
use crate::contacts::Contacts;
use crate::effects::{Course, Forces, course};
use crate::frame::{self, BroadPhase, Candidates, Frame, Passes};
use crate::impact::Impact;
use crate::scene::{self, Scene};
use crate::timeline::{Accumulation, Setup, Timed};
use crate::world::World;

/// How a scene is simulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Algorithm {
    /// Step, test for overlap, resolve, so many times a frame.
    Retroactive {
        /// The number of steps a frame.
        substeps: u32,
    },
    /// The paper's single collision algorithm.
    Single,
    /// The paper's multiple collision algorithm.
    Multiple(Passes),
    /// The same with the clocks of a pair brought together.
    Synchronised(Passes),
    /// Event-driven: always the next impact of all.
    Timeline,
}

impl fmt::Display for Algorithm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Retroactive { .. } => "retroactive",
            Self::Single => "single",
            Self::Multiple(_) => "multiple",
            Self::Synchronised(_) => "synchronised",
            Self::Timeline => "timeline",
        })
    }
}

/// A scene that is being simulated frame by frame.
#[derive(Clone, Debug)]
pub struct Simulation<S: Timed> {
    machine: Machine<S>,
    clock: FrameClock,
    precision: S::Precision,
    frame: u64,
}

#[derive(Clone, Debug)]
enum Machine<S: Timed> {
    Frames(Box<Frames<S>>),
    Timeline(Box<dyn Course<S>>),
}

/// A frame algorithm at work.
#[derive(Clone, Debug)]
struct Frames<S: Timed> {
    world: World<S>,
    algorithm: Algorithm,
    forces: Option<Forces<S>>,
    candidates: Candidates,
}

impl<S: Arithmetic> Simulation<S> {
    /// The start of a scene.
    ///
    /// # Errors
    ///
    /// The timeline cannot decide what the discs meet first.
    pub fn new(
        scene: &Scene,
        algorithm: Algorithm,
        precision: S::Precision,
    ) -> Result<Self, S::Doubt> {
        let world = World::new(scene, precision);
        let clock = FrameClock::new(scene.frame());
        let machine = match algorithm {
            Algorithm::Timeline => {
                let end = clock.start_of(scene.frame().count, precision);
                let effects = scene.effects();
                let setup = Setup::default();
                Machine::Timeline(course(world, effects, &end, &setup, precision)?)
            }
            _ => Machine::Frames(Box::new(Frames {
                world,
                algorithm,
                forces: Forces::of(scene.effects(), precision),
                candidates: Candidates::default(),
            })),
        };
        Ok(Self {
            machine,
            clock,
            precision,
            frame: 0,
        })
    }

    /// The same, but a frame algorithm finds the pairs that it tests like this.
    #[must_use]
    pub fn with_broad_phase(mut self, phase: BroadPhase) -> Self {
        if let Machine::Frames(frames) = &mut self.machine {
            frames.candidates = Candidates::new(phase);
        }
        self
    }

    /// Simulates the next frame and returns its impacts: of infinitely many
    /// some of the first ([`accumulation`](Self::accumulation)).
    ///
    /// # Errors
    ///
    /// The arithmetic leaves a decision open.
    pub fn next_frame(&mut self) -> Result<Vec<Impact<S>>, S::Doubt> {
        let number = self.frame;
        self.frame += 1;
        match &mut self.machine {
            Machine::Frames(frames) => frames.step(&self.clock.frame(number, self.precision)),
            Machine::Timeline(timeline) => {
                let end = self.clock.start_of(self.frame, self.precision);
                std::iter::from_fn(|| timeline.next_impact(&end).transpose()).collect()
            }
        }
    }

    /// Infinitely many impacts that a frame has had, beyond which nothing is
    /// known.
    pub fn accumulation(&self) -> Option<Accumulation<S>> {
        match &self.machine {
            Machine::Frames(..) => None,
            Machine::Timeline(timeline) => timeline.accumulation(),
        }
    }

    /// The discs as they are at the end of the latest frame.
    pub fn discs(&self) -> Vec<Disc<S>> {
        match &self.machine {
            Machine::Frames(frames) => frames.world.discs.clone(),
            Machine::Timeline(timeline) => {
                timeline.discs_at(&self.clock.start_of(self.frame, self.precision))
            }
        }
    }

    /// What touches by construction at the end of the latest frame.
    pub fn contacts(&self) -> Contacts {
        match &self.machine {
            Machine::Frames(frames) => frames.world.contacts.clone(),
            Machine::Timeline(timeline) => Contacts::none(timeline.disc_count()),
        }
    }
}

impl<S: Timed> Frames<S> {
    /// Simulates a frame with one of the paper's algorithms.
    fn step(&mut self, frame: &Frame<S>) -> Result<Vec<Impact<S>>, S::Doubt> {
        let Self {
            world, candidates, ..
        } = self;
        if let Some(forces) = &self.forces {
            forces.act(world, &frame.duration);
        }
        match self.algorithm {
            Algorithm::Retroactive { substeps } => {
                frame::retroactive(world, frame, substeps, candidates)
            }
            Algorithm::Single => frame::single(world, frame, candidates),
            Algorithm::Multiple(passes) => frame::multiple(world, frame, passes, candidates),
            Algorithm::Synchronised(passes) => {
                frame::synchronised(world, frame, passes, candidates)
            }
            Algorithm::Timeline => unreachable!("the timeline is no frame algorithm"),
        }
    }
}

/// A frame's impacts, and the discs at its end.
type Stepped<S> = (Vec<Impact<S>>, Vec<Disc<S>>);

/// A single frame of a frame algorithm, from any state of a world.
///
/// # Errors
///
/// The arithmetic leaves a decision open.
pub(crate) fn lone_frame<S: Arithmetic>(
    world: World<S>,
    algorithm: Algorithm,
    effects: &scene::Effects,
    frame: &Frame<S>,
    precision: S::Precision,
) -> Result<Stepped<S>, S::Doubt> {
    let mut frames = Frames {
        world,
        algorithm,
        forces: Forces::of(effects, precision),
        candidates: Candidates::default(),
    };
    let impacts = frames.step(frame)?;
    Ok((impacts, frames.world.discs))
}

/// The exact times at which frames start.
#[derive(Clone, Debug)]
pub struct FrameClock {
    duration: BigRational,
}

impl FrameClock {
    /// The clock of a scene's frames.
    pub fn new(frame: &scene::Frame) -> Self {
        Self {
            duration: frame.duration.to_rational(),
        }
    }

    /// When a frame starts, rounded at most once.
    pub fn start_of<S: Arithmetic>(&self, frame: u64, precision: S::Precision) -> S {
        let start = &self.duration * BigRational::from_integer(frame.into());
        S::from_rational(start, precision)
    }

    /// How many frames it takes to get to a time.
    pub fn frames_until(&self, end: &BigRational) -> u64 {
        let frames = (end / &self.duration).ceil().to_integer();
        u64::try_from(frames).unwrap_or(u64::MAX)
    }

    /// A frame.
    pub fn frame<S: Arithmetic>(&self, number: u64, precision: S::Precision) -> Frame<S> {
        Frame {
            number,
            start: self.start_of(number, precision),
            duration: S::from_rational(self.duration.clone(), precision),
        }
    }
}
