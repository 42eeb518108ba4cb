//! A candidate judged frame by frame.

use std::time::{Duration, Instant};

use super::tally::{Logged, Tally, compare_frame};
use super::truth::{Truth, true_frame};
use crate::arithmetic::{Arithmetic, Budget, Shortfall};
use crate::body::Disc;
use crate::contacts::Contacts;
use crate::frame::BroadPhase;
use crate::scalar::{Doubt, Exact, Scalar, Undecided};
use crate::scene::Scene;
use crate::simulation::{Algorithm, FrameClock, Simulation};
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
    /// Why the candidate itself could not be run to its end.
    pub failure: Option<Undecided>,
    /// Whether it ended in infinitely many impacts instead. That frame is not
    /// judged.
    pub accumulates: bool,
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
    check_support::<S>(scene, algorithm)?;
    check_support::<Exact>(scene, Algorithm::Timeline)?;
    let mut precision = S::first_precision(budget);
    loop {
        let mut trial = Trial::<S>::new(scene, budget, precision);
        let failure = trial.run(algorithm, phase).err();
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
    budget: &'a Budget,
    precision: S::Precision,
    clock: FrameClock,
    judged: Judged,
}

impl<'a, S: Arithmetic> Trial<'a, S> {
    fn new(scene: &'a Scene, budget: &'a Budget, precision: S::Precision) -> Self {
        let judged = Judged {
            tally: Tally::default(),
            frames: 0,
            undecided: 0,
            cost: Duration::ZERO,
            log: Vec::new(),
            failure: None,
            accumulates: false,
        };
        Self {
            scene,
            budget,
            precision,
            clock: FrameClock::new(scene.frame()),
            judged,
        }
    }

    fn run(&mut self, algorithm: Algorithm, phase: BroadPhase) -> Result<(), Undecided> {
        let begun = Instant::now();
        let simulation = Simulation::<S>::new(self.scene, algorithm, self.precision);
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
        let impacts: Vec<_> = impacts.iter().map(Logged::from).collect();
        match self.truth(&discs, &contacts)? {
            Some(truth) => self.tally(&truth, &impacts, &simulation.discs()),
            None => self.judged.undecided += 1,
        }
        self.judged.frames += 1;
        self.judged.log.extend(impacts);
        Ok(())
    }

    /// What truly happens from a state of the candidate; none if that is
    /// infinitely many impacts, or the budget does not suffice. Where the state itself is only enclosed, more bits
    /// have to come from the candidate.
    fn truth(&self, discs: &[Disc<S>], contacts: &Contacts) -> Result<Option<Truth>, Undecided> {
        let mut bits = self.budget.first_bits;
        loop {
            let failure = match self.attempt_truth(discs, contacts, bits) {
                Ok(truth) => return Ok(truth),
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

    fn attempt_truth(
        &self,
        discs: &[Disc<S>],
        contacts: &Contacts,
        bits: u32,
    ) -> Result<Option<Truth>, Undecided> {
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
        let start = self.clock.start_of(self.judged.frames, bits);
        let duration = self.clock.start_of(1, bits);
        true_frame(world, self.scene.effects(), bits, &start, &duration)
    }

    fn tally(&mut self, truth: &Truth, impacts: &[Logged], end: &[Disc<S>]) {
        let mut tally = compare_frame(&truth.impacts, impacts);
        for (truth, disc) in truth.end.iter().zip(end) {
            let distance = distance(truth, &disc.position.map(S::to_f64));
            tally.position_error = tally.position_error.max(distance);
        }
        self.judged.tally += tally;
    }
}

fn distance(one: &Vec2<f64>, other: &Vec2<f64>) -> f64 {
    let apart = one.minus(other);
    apart.x.hypot(apart.y)
}
