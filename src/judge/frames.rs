//! A candidate judged frame by frame.

use std::time::{Duration, Instant};

use super::matching::{Fault, FrameComparison, compare_frame};
use super::overlaps::{Overlaps, overlaps};
use super::tally::{Logged, Tally};
use super::truth::{Truth, true_frame};
use crate::arithmetic::{Arithmetic, Budget, Shortfall};
use crate::body::Disc;
use crate::conserved::energy;
use crate::contacts::Contacts;
use crate::frame::BroadPhase;
use crate::scalar::{Doubt, Exact, Scalar, Undecided};
use crate::scene::Scene;
use crate::simulation::{Algorithm, FrameClock, Simulation, lone_frame};
use crate::support::{Unsupported, check_support};
use crate::vec2::Vec2;
use crate::world::World;

/// What the judgement of a candidate comes to.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The impacts of all frames, and the largest errors.
    pub tally: Tally,
    /// The frames judged.
    pub frames: u64,
    /// The frames of which the truth could not be decided, or is infinitely
    /// many impacts.
    pub undecided: u64,
    /// The time that the candidate took for its frames: of exact arithmetic,
    /// of the attempt that succeeded.
    pub cost: Duration,
    /// The candidate's log.
    pub log: Vec<Logged>,
    /// What is wrong in it, frame by frame.
    pub faults: Vec<(Fault, Logged)>,
    /// Why the candidate itself could not be run to its end.
    pub failure: Option<Undecided>,
    /// Whether it ended in infinitely many impacts instead. That frame is not
    /// judged.
    pub accumulates: bool,
    /// The parts of the errors, if they were asked for, of a frame algorithm in
    /// an arithmetic that rounds.
    pub split: Option<Split>,
}

/// The errors of a frame algorithm, told apart frame by frame: from the
/// candidate's own state at the start of a frame the same algorithm takes that
/// frame in exact arithmetic, too.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Split {
    /// The algorithm in exact arithmetic, against the truth.
    pub algorithm: Tally,
    /// The candidate, against the algorithm in exact arithmetic.
    pub rounding: Tally,
    /// The frames that are in neither part, for in them exact arithmetic leaves a
    /// decision of the algorithm open, such as a tie.
    pub undecided: u64,
}

/// Runs a candidate and judges each frame from the candidate's own state at
/// its start, taken exactly. The broad phase, that of a frame algorithm, changes
/// only what it costs.
///
/// # Errors
///
/// The scene asks for something that cannot be simulated.
pub fn judge<S: Arithmetic>(
    scene: &Scene,
    algorithm: Algorithm,
    phase: BroadPhase,
    budget: &Budget,
) -> Result<Judged, Unsupported> {
    judge_as(Trial::<S>::new, scene, algorithm, phase, budget)
}

/// The same, and tells which part of the errors is the algorithm's.
///
/// # Errors
///
/// The scene asks for something that cannot be simulated.
pub fn judge_and_split<S: Arithmetic>(
    scene: &Scene,
    algorithm: Algorithm,
    phase: BroadPhase,
    budget: &Budget,
) -> Result<Judged, Unsupported> {
    let is_split = S::ROUNDS && algorithm != Algorithm::Timeline;
    let begin = |scene, algorithm, budget, precision| {
        let mut trial = Trial::<S>::new(scene, algorithm, budget, precision);
        trial.judged.split = is_split.then(Split::default);
        trial
    };
    judge_as(begin, scene, algorithm, phase, budget)
}

fn judge_as<'a, S: Arithmetic>(
    begin: impl Fn(&'a Scene, Algorithm, &'a Budget, S::Precision) -> Trial<'a, S>,
    scene: &'a Scene,
    algorithm: Algorithm,
    phase: BroadPhase,
    budget: &'a Budget,
) -> Result<Judged, Unsupported> {
    check_support::<S>(scene, algorithm)?;
    check_support::<Exact>(scene, Algorithm::Timeline)?;
    let mut precision = S::first_precision(budget);
    loop {
        let mut trial = begin(scene, algorithm, budget, precision);
        let failure = trial.run(phase).err();
        let Some(failure) = failure else {
            return Ok(trial.judged);
        };
        let progress = trial.judged.frames as f64 / scene.frame().count as f64;
        let short = Shortfall { progress, left: 0 };
        match S::next_precision(budget, precision, short) {
            Some(next) => precision = next,
            None => {
                trial.judged.failure = Some(failure);
                return Ok(trial.judged);
            }
        }
    }
}

/// One attempt at the judgement of a candidate.
struct Trial<'a, S: Scalar> {
    scene: &'a Scene,
    algorithm: Algorithm,
    budget: &'a Budget,
    precision: S::Precision,
    clock: FrameClock,
    judged: Judged,
}

impl<'a, S: Arithmetic> Trial<'a, S> {
    fn new(
        scene: &'a Scene,
        algorithm: Algorithm,
        budget: &'a Budget,
        precision: S::Precision,
    ) -> Self {
        let judged = Judged {
            tally: Tally::default(),
            frames: 0,
            undecided: 0,
            cost: Duration::ZERO,
            log: Vec::new(),
            faults: Vec::new(),
            failure: None,
            accumulates: false,
            split: None,
        };
        Self {
            scene,
            algorithm,
            budget,
            precision,
            clock: FrameClock::new(scene.frame()),
            judged,
        }
    }

    fn run(&mut self, phase: BroadPhase) -> Result<(), Undecided> {
        let begun = Instant::now();
        let simulation = Simulation::<S>::new(self.scene, self.algorithm, self.precision);
        let simulation = simulation.map_err(Doubt::into_undecided)?;
        let mut simulation = simulation.with_broad_phase(phase);
        self.judged.cost += begun.elapsed();
        while self.judged.frames < self.scene.frame().count && !self.judged.accumulates {
            self.judge_frame(&mut simulation)?;
        }
        Ok(())
    }

    fn judge_frame(&mut self, simulation: &mut Simulation<S>) -> Result<(), Undecided> {
        let (discs, contacts) = (simulation.discs(), simulation.contacts());
        let begun = Instant::now();
        let impacts = simulation.next_frame().map_err(Doubt::into_undecided)?;
        self.judged.cost += begun.elapsed();
        self.judged.accumulates = simulation.accumulation().is_some();
        if self.judged.accumulates {
            return Ok(());
        }
        let start = (&discs[..], &contacts);
        let found = Found {
            impacts: impacts.iter().map(Logged::from).collect(),
            end: self.ending(simulation)?,
        };
        match self.decide(|bits| self.truth(start, bits))?.flatten() {
            Some(truth) => {
                let compared = FrameComparison::new(&truth.impacts, &found.impacts);
                self.judged.faults.extend(compared.faults());
                self.judged.tally += found.tally(&truth, compared.tally());
                self.split(start, &truth, &found)?;
            }
            None => self.judged.undecided += 1,
        }
        self.judged.frames += 1;
        self.judged.log.extend(found.impacts);
        Ok(())
    }

    /// What is decided with as many bits as it takes; none if the budget does
    /// not suffice. Where the state itself is only enclosed, more bits have to
    /// come from the candidate.
    fn decide<T>(
        &self,
        attempt: impl Fn(u32) -> Result<T, Undecided>,
    ) -> Result<Option<T>, Undecided> {
        let mut bits = self.budget.first_bits;
        loop {
            let failure = match attempt(bits) {
                Ok(decided) => return Ok(Some(decided)),
                Err(failure) => failure,
            };
            if S::IS_DEAR {
                return Err(failure);
            }
            let short = Shortfall {
                progress: 1.0,
                left: bits,
            };
            match self.budget.next_bits(bits, short) {
                Some(next) => bits = next,
                None => return Ok(None),
            }
        }
    }

    /// What truly happens from a state of the candidate; none if that is
    /// infinitely many impacts.
    fn truth(&self, start: State<'_, S>, bits: u32) -> Result<Option<Truth>, Undecided> {
        let frame = self.clock.frame(self.judged.frames, bits);
        let (world, effects) = (self.world(start, bits), self.scene.effects());
        true_frame(world, effects, bits, &frame.start, &frame.duration)
    }

    /// The candidate's state, taken exactly.
    fn world(&self, (discs, contacts): State<'_, S>, bits: u32) -> World<Exact> {
        let mut world = World::<Exact>::new(self.scene, bits);
        let states = discs.iter().zip(&world.discs);
        let states = states.map(|(state, written)| Disc {
            position: state.position.map(|number| number.exactly(bits)),
            velocity: state.velocity.map(|number| number.exactly(bits)),
            last: state.last,
            ..written.clone()
        });
        world.discs = states.collect();
        world.contacts = contacts.clone();
        world
    }

    /// Where the candidate's frame ends.
    fn ending(&self, simulation: &Simulation<S>) -> Result<End, Undecided> {
        let (discs, contacts) = (simulation.discs(), simulation.contacts());
        let mut world = self.world((&discs, &contacts), self.budget.first_bits);
        if S::ROUNDS {
            forget_contacts(&mut world);
        }
        Ok(End {
            places: discs
                .iter()
                .map(|disc| disc.position.map(S::to_f64))
                .collect(),
            energy: energy(&world.discs).to_f64(),
            overlaps: overlaps(&world)?,
        })
    }

    /// Tells the algorithm's part of a frame's errors from that of rounding.
    fn split(
        &mut self,
        start: State<'_, S>,
        truth: &Truth,
        found: &Found,
    ) -> Result<(), Undecided> {
        if self.judged.split.is_none() {
            return Ok(());
        }
        let exact = self.decide(|bits| self.exact_frame(start, bits))?;
        match (exact, &mut self.judged.split) {
            (Some(exact), Some(split)) => {
                split.rounding += found.judged(&exact);
                split.algorithm += Found::from(exact).judged(truth);
            }
            (None, Some(split)) => split.undecided += 1,
            (_, None) => {}
        }
        Ok(())
    }

    /// What the algorithm makes of a state in exact arithmetic.
    fn exact_frame(&self, start: State<'_, S>, bits: u32) -> Result<Truth, Undecided> {
        let frame = self.clock.frame(self.judged.frames, bits);
        let (world, effects) = (self.world(start, bits), self.scene.effects());
        let (impacts, end) = lone_frame(world, self.algorithm, effects, &frame, bits)?;
        Ok(Truth::new(&impacts, &end))
    }
}

/// The discs, and what touches by construction.
type State<'a, S> = (&'a [Disc<S>], &'a Contacts);

/// Lets numbers speak for themselves: what has touched by construction, and was
/// rounded, may overlap.
fn forget_contacts(world: &mut World<Exact>) {
    world.contacts = Contacts::none(world.discs.len());
    for disc in &mut world.discs {
        disc.last = None;
    }
}

/// A frame as the candidate has it.
struct Found {
    impacts: Vec<Logged>,
    end: End,
}

struct End {
    places: Vec<Vec2<f64>>,
    energy: f64,
    overlaps: Overlaps,
}

impl From<Truth> for Found {
    fn from(truth: Truth) -> Self {
        let end = End {
            places: truth.end,
            energy: truth.energy,
            overlaps: Overlaps::default(),
        };
        Self {
            impacts: truth.impacts,
            end,
        }
    }
}

impl Found {
    fn judged(&self, truth: &Truth) -> Tally {
        self.tally(truth, compare_frame(&truth.impacts, &self.impacts))
    }

    /// What is counted of the impacts, with the errors at the end.
    fn tally(&self, truth: &Truth, impacts: Tally) -> Tally {
        let places = self.end.places.iter().zip(&truth.end);
        let distances = places.map(|(place, truth)| distance(place, truth));
        Tally {
            position_error: distances.fold(0.0, f64::max),
            energy_error: relative_error(self.end.energy, truth.energy),
            overlaps: self.end.overlaps.count,
            overlap_depth: self.end.overlaps.depth,
            ..impacts
        }
    }
}

fn distance(one: &Vec2<f64>, other: &Vec2<f64>) -> f64 {
    let apart = one.minus(other);
    apart.x.hypot(apart.y)
}

/// An error relative to the true value; of what is truly zero, either none or
/// infinite.
fn relative_error(value: f64, truth: f64) -> f64 {
    match value == truth {
        true => 0.0,
        false => ((value - truth) / truth).abs(),
    }
}
