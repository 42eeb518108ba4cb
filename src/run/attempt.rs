//! One attempt at a run, at one precision.

use std::ops::ControlFlow;

use num_rational::BigRational;

use super::{Options, Outcome, Progress, Status};
use crate::arithmetic::Arithmetic;
use crate::body::Disc;
use crate::effects::{Course, course};
use crate::impact::{Impact, number_ties};
use crate::scalar::{Doubt, Scalar, Undecided};
use crate::scene::{Effects, Scene};
use crate::simulation::{Algorithm, FrameClock, Simulation};
use crate::symmetry::Symmetry;
use crate::timeline::{Setup, count_overlaps};
use crate::world::World;

/// What an attempt has and has got so far.
pub(super) struct Attempt<'a, S: Scalar> {
    options: &'a Options,
    symmetries: &'a [Symmetry],
    watch: &'a mut dyn FnMut(Progress) -> ControlFlow<()>,
    precision: S::Precision,
    clock: FrameClock,
    end: BigRational,
    until: f64,
    impacts: Vec<Impact<S>>,
}

impl<'a, S: Arithmetic> Attempt<'a, S> {
    pub(super) fn new(
        scene: &Scene,
        options: &'a Options,
        symmetries: &'a [Symmetry],
        precision: S::Precision,
        watch: &'a mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Self {
        let end = options.end_of(scene);
        Self {
            options,
            symmetries,
            watch,
            precision,
            clock: FrameClock::new(scene.frame()),
            until: f64::from_rational(end.clone(), ()),
            end,
            impacts: Vec::new(),
        }
    }

    pub(super) fn run(&mut self, scene: &Scene, algorithm: Algorithm) -> Outcome<S> {
        let world = World::<S>::new(scene, self.precision);
        let start = world.discs.clone();
        let overlaps = match &world.period {
            Some(period) => count_overlaps(&world, period),
            None => world.count_overlaps(),
        };
        let ran = match algorithm {
            Algorithm::Timeline => self.follow(world, scene.effects()),
            _ => self.step(scene, algorithm),
        };
        let mut impacts = std::mem::take(&mut self.impacts);
        number_ties(&mut impacts);
        let mut outcome = Outcome {
            status: ran.status,
            impacts,
            grazes: ran.grazes,
            rests: ran.rests,
            closest_call: ran.closest_call,
            restarts: 0,
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

    fn setup(&self) -> Setup<'a> {
        Setup {
            simultaneous: self.options.simultaneous,
            broad_phase: self.options.broad_phase,
            symmetries: self.symmetries,
        }
    }

    /// Follows the timeline to the end.
    fn follow(&mut self, world: World<S>, effects: &Effects) -> Ran<S> {
        let end = S::from_rational(self.end.clone(), self.precision);
        let start = world.discs.clone();
        let course = course(world, effects, &end, &self.setup(), self.precision);
        let mut timeline = match course {
            Ok(timeline) => timeline,
            Err(doubt) => return Ran::stuck(doubt, start),
        };
        let status = self.follow_impacts(&mut *timeline, &end);
        let time = match status {
            Status::Complete => end,
            _ => timeline.now(),
        };
        Ran {
            discs: timeline.discs_at(&time),
            grazes: timeline.grazes(),
            rests: timeline.rests(),
            closest_call: timeline.closest_call(),
            status,
            time,
        }
    }

    fn follow_impacts(&mut self, timeline: &mut dyn Course<S>, end: &S) -> Status {
        loop {
            match timeline.next_impact(end) {
                Err(doubt) => return Status::Undecided(doubt.into_undecided()),
                Ok(None) => return self.ending(timeline),
                Ok(Some(impact)) => self.note(impact),
            }
            if let ControlFlow::Break(status) = self.pause(&timeline.now()) {
                return status;
            }
        }
    }

    /// How a timeline without further impacts ended.
    fn ending(&self, timeline: &dyn Course<S>) -> Status {
        let Some(found) = timeline.accumulation() else {
            return Status::Complete;
        };
        let digits = self.options.digits;
        let mut bounds = found.limit.iter();
        if found.proven && !bounds.all(|bound| bound.has_digits(digits)) {
            let bits = S::bits(self.precision).unwrap_or_default();
            let question = format!("{digits} digits of the time at which impacts accumulate");
            return Status::Undecided(Undecided::new(bits, question));
        }
        Status::Accumulation((&found).into())
    }

    /// Steps through the frames up to the end.
    fn step(&mut self, scene: &Scene, algorithm: Algorithm) -> Ran<S> {
        let start = World::<S>::new(scene, self.precision).discs;
        let mut simulation = match Simulation::new(scene, algorithm, self.precision) {
            Ok(simulation) => simulation.with_broad_phase(self.options.frame_broad_phase),
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
            rests: 0,
            closest_call: None,
            discs: simulation.discs(),
            time: self.clock.start_of(done, self.precision),
        }
    }

    fn step_frame(&mut self, simulation: &mut Simulation<S>, done: u64) -> Status {
        match simulation.next_frame() {
            Ok(impacts) => impacts.into_iter().for_each(|impact| self.note(impact)),
            Err(doubt) => return Status::Undecided(doubt.into_undecided()),
        }
        match self.pause(&self.clock.start_of(done, self.precision)) {
            ControlFlow::Continue(()) => Status::Complete,
            ControlFlow::Break(status) => status,
        }
    }

    /// Keeps of an impact what was asked for.
    fn note(&mut self, mut impact: Impact<S>) {
        if !self.options.contacts {
            impact.contact = None;
        }
        self.impacts.push(impact.shortened(self.options.digits));
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

    pub(super) fn progress(&self, time: &S) -> Progress {
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
    rests: u64,
    closest_call: Option<f64>,
    discs: Vec<Disc<S>>,
    time: S,
}

impl<S: Scalar> Ran<S> {
    /// An attempt that did not get anywhere.
    fn stuck(doubt: S::Doubt, discs: Vec<Disc<S>>) -> Self {
        Self {
            status: Status::Undecided(doubt.into_undecided()),
            grazes: 0,
            rests: 0,
            closest_call: None,
            discs,
            time: S::from_integer(0),
        }
    }
}
