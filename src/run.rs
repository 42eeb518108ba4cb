//! A whole run of a scene: its impacts, its end, and whether it got there.
//!
//! Exact arithmetic leaves a decision open where its enclosures are too wide.
//! The run then starts again with more bits, as many as the attempt's progress
//! lets expect, until all is decided or the budget is spent.

use std::ops::ControlFlow;

use num_rational::BigRational;

use crate::arithmetic::{Arithmetic, Budget};
use crate::body::Disc;
use crate::impact::{Impact, number_ties};
use crate::scalar::{Doubt, Number, Scalar, Undecided};
use crate::scene::Scene;
use crate::simulation::{Algorithm, FrameClock, Simulation};
use crate::support::{Unsupported, check_support};
use crate::timeline::Timeline;
use crate::world::World;

/// What a run may cost, and where it ends.
#[derive(Clone, Debug)]
pub struct Options {
    /// The end, unless it is that of the scene's last frame.
    pub until: Option<Number>,
    /// The number of impacts after which the run is ended.
    pub max_events: u64,
    /// The precision of exact arithmetic.
    pub budget: Budget,
    /// The decimal digits of the times that exact arithmetic must prove.
    pub digits: u32,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            until: None,
            max_events: 10_000_000,
            budget: Budget::default(),
            digits: 20,
        }
    }
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Status {
    /// It got to its end.
    Complete,
    /// A decision was still open when the budget was spent.
    Undecided(Undecided),
    /// There were as many impacts as allowed.
    EventLimit,
    /// It was stopped from outside.
    Interrupted,
}

/// How far a run has got.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// The simulated time.
    pub time: f64,
    /// The simulated time at the end.
    pub until: f64,
    /// The impacts so far.
    pub impacts: u64,
}

/// What a run gives.
#[derive(Clone, Debug)]
pub struct Outcome<S: Scalar> {
    /// How it ended.
    pub status: Status,
    /// Its impacts, in order.
    pub impacts: Vec<Impact<S>>,
    /// How many tangent passes there were.
    pub grazes: u64,
    /// How many pairs overlapped at the start.
    pub overlaps: u64,
    /// The discs at the start.
    pub start: Vec<Disc<S>>,
    /// The discs at the end.
    pub end: Vec<Disc<S>>,
    /// The time of the end.
    pub time: S,
    /// What the arithmetic computed with.
    pub precision: S::Precision,
}

/// Runs a scene. `watch` is told of the progress now and then, and may stop
/// the run.
///
/// # Errors
///
/// The scene asks for something that cannot be simulated.
pub fn run<S: Arithmetic>(
    scene: &Scene,
    algorithm: Algorithm,
    options: &Options,
    watch: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Outcome<S>, Unsupported> {
    check_support::<S>(scene)?;
    let mut precision = S::first_precision(&options.budget);
    loop {
        let mut attempt = Attempt::<S>::new(scene, options, precision, &mut *watch);
        let outcome = attempt.run(scene, algorithm);
        let Status::Undecided(_) = outcome.status else {
            return Ok(outcome);
        };
        let progress = attempt.progress(&outcome.time).fraction();
        match S::next_precision(&options.budget, precision, progress) {
            Some(next) => precision = next,
            None => return Ok(outcome),
        }
    }
}

impl Progress {
    /// The part of the run that is done.
    pub fn fraction(&self) -> f64 {
        (self.time / self.until).clamp(0.0, 1.0)
    }
}

/// One attempt at a run, at one precision.
struct Attempt<'a, S: Scalar> {
    options: &'a Options,
    watch: &'a mut dyn FnMut(Progress) -> ControlFlow<()>,
    precision: S::Precision,
    clock: FrameClock,
    end: BigRational,
    until: f64,
    impacts: Vec<Impact<S>>,
}

impl<'a, S: Arithmetic> Attempt<'a, S> {
    fn new(
        scene: &Scene,
        options: &'a Options,
        precision: S::Precision,
        watch: &'a mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Self {
        let end = match &options.until {
            Some(until) => until.to_rational(),
            None => scene.frame().total(),
        };
        Self {
            options,
            watch,
            precision,
            clock: FrameClock::new(scene.frame()),
            until: f64::from_rational(end.clone(), ()),
            end,
            impacts: Vec::new(),
        }
    }

    fn run(&mut self, scene: &Scene, algorithm: Algorithm) -> Outcome<S> {
        let world = World::<S>::new(scene, self.precision);
        let start = world.discs.clone();
        let overlaps = world.count_overlaps();
        let ran = match algorithm {
            Algorithm::Timeline => self.follow(world),
            _ => self.step(scene, algorithm),
        };
        let mut impacts = std::mem::take(&mut self.impacts);
        number_ties(&mut impacts);
        let mut outcome = Outcome {
            status: ran.status,
            impacts,
            grazes: ran.grazes,
            overlaps: 0,
            start,
            end: ran.discs,
            time: ran.time,
            precision: self.precision,
        };
        match overlaps {
            Ok(overlaps) => outcome.overlaps = overlaps,
            Err(doubt) => outcome.demand(doubt.into_undecided()),
        }
        outcome.check_digits(self.options.digits);
        outcome
    }

    /// Follows the timeline to the end.
    fn follow(&mut self, world: World<S>) -> Ran<S> {
        let end = S::from_rational(self.end.clone(), self.precision);
        let start = world.discs.clone();
        let mut timeline = match Timeline::new(world, &end) {
            Ok(timeline) => timeline,
            Err(doubt) => return Ran::stuck(doubt, start),
        };
        let status = self.follow_impacts(&mut timeline, &end);
        let time = match status {
            Status::Complete => end,
            _ => timeline.now().clone(),
        };
        Ran {
            discs: timeline.discs_at(&time),
            grazes: timeline.grazes(),
            status,
            time,
        }
    }

    fn follow_impacts(&mut self, timeline: &mut Timeline<S>, end: &S) -> Status {
        loop {
            match timeline.next_impact(end) {
                Err(doubt) => return Status::Undecided(doubt.into_undecided()),
                Ok(None) => return Status::Complete,
                Ok(Some(impact)) => self.impacts.push(impact),
            }
            if let ControlFlow::Break(status) = self.pause(timeline.now()) {
                return status;
            }
        }
    }

    /// Steps through the frames up to the end.
    fn step(&mut self, scene: &Scene, algorithm: Algorithm) -> Ran<S> {
        let start = World::<S>::new(scene, self.precision).discs;
        let mut simulation = match Simulation::new(scene, algorithm, self.precision) {
            Ok(simulation) => simulation,
            Err(doubt) => return Ran::stuck(doubt, start),
        };
        let frames = self.clock.frames_until(&self.end);
        let mut status = Status::Complete;
        let mut done = 0;
        while done < frames && status == Status::Complete {
            status = self.step_frame(&mut simulation, done + 1);
            done += 1;
        }
        Ran {
            status,
            grazes: 0,
            discs: simulation.discs(),
            time: self.clock.start_of(done, self.precision),
        }
    }

    fn step_frame(&mut self, simulation: &mut Simulation<S>, done: u64) -> Status {
        match simulation.next_frame() {
            Ok(impacts) => self.impacts.extend(impacts),
            Err(doubt) => return Status::Undecided(doubt.into_undecided()),
        }
        match self.pause(&self.clock.start_of(done, self.precision)) {
            ControlFlow::Continue(()) => Status::Complete,
            ControlFlow::Break(status) => status,
        }
    }

    /// Tells of the progress, and whether to go on.
    fn pause(&mut self, time: &S) -> ControlFlow<Status> {
        let progress = self.progress(time);
        if (self.watch)(progress).is_break() {
            return ControlFlow::Break(Status::Interrupted);
        }
        if progress.impacts >= self.options.max_events {
            return ControlFlow::Break(Status::EventLimit);
        }
        ControlFlow::Continue(())
    }

    fn progress(&self, time: &S) -> Progress {
        Progress {
            time: time.to_f64(),
            until: self.until,
            impacts: self.impacts.len() as u64,
        }
    }
}

/// How an attempt went.
struct Ran<S> {
    status: Status,
    grazes: u64,
    discs: Vec<Disc<S>>,
    time: S,
}

impl<S: Scalar> Ran<S> {
    /// An attempt that did not get anywhere.
    fn stuck(doubt: S::Doubt, discs: Vec<Disc<S>>) -> Self {
        Self {
            status: Status::Undecided(doubt.into_undecided()),
            grazes: 0,
            discs,
            time: S::from_integer(0),
        }
    }
}

impl<S: Arithmetic> Outcome<S> {
    /// A run that otherwise went well lacks a decision.
    fn demand(&mut self, open: Undecided) {
        if !matches!(self.status, Status::Undecided(_)) {
            self.status = Status::Undecided(open);
        }
    }

    /// Each time in the log must be known to so many digits.
    fn check_digits(&mut self, digits: u32) {
        let vague = self
            .impacts
            .iter()
            .find(|impact| !impact.time.has_digits(digits));
        if let Some(impact) = vague {
            let question = format!("{digits} digits of the time at which {} meet", impact.pair);
            let bits = S::bits(self.precision).unwrap_or_default();
            self.demand(Undecided { bits, question });
        }
    }
}
