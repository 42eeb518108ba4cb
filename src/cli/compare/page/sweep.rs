//! What happens to error and cost when one thing about a scene or an algorithm
//! changes.
//!
//! Everything is in binary64, of a scene's first frames: so many that the exact
//! timeline, which judges each of them, has a bounded number of impacts. That
//! bound is a count, so the same frames are judged on every machine.

use std::collections::BTreeMap;
use std::time::Duration;

use carom::arithmetic::Budget;
use carom::frame::{BroadPhase, Passes};
use carom::judge::{Judged, Tally};
use carom::scalar::Number;
use carom::scene::{DiscBuilder, Restitution, Scene};
use carom::simulation::Algorithm;
use num_rational::BigRational;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use crate::cli::choice::{AlgorithmName, ArithmeticName};
use crate::cli::compare::candidate::Candidate;
use crate::cli::compare::cost::{Cost, Effort, in_turn};
use crate::cli::compare::truth::Truth;

/// About so many true impacts are judged in each point of a sweep.
const IMPACTS: f64 = 2000.0;

/// So many times that a disc takes a frame are.
const DISC_FRAMES: f64 = 40_000.0;

/// What goes into the costs of the points of a sweep.
const EFFORT: Effort = Effort {
    share: Duration::from_millis(100),
    rounds: 9,
};

/// What is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Passes,
    Substeps,
    FrameLength,
    Density,
    Restitution,
}

impl Kind {
    pub(super) const ALL: [Self; 5] = [
        Self::Passes,
        Self::Substeps,
        Self::FrameLength,
        Self::Density,
        Self::Restitution,
    ];

    /// The values that are tried.
    fn values(self) -> &'static [&'static str] {
        match self {
            Self::Passes => &["1", "2", "3", "4", "5", "6"],
            Self::Substeps => &["1", "2", "4", "8", "16", "32", "64", "128", "256"],
            Self::FrameLength => &["1/8", "1/4", "1/2", "1", "2", "4"],
            Self::Density => &["1/3", "1/2", "2/3", "5/6", "1"],
            Self::Restitution => &["0.5", "0.6", "0.7", "0.8", "0.9", "1"],
        }
    }

    /// The algorithms that it is a matter of, with a value of it.
    fn algorithm(self, name: AlgorithmName, value: &BigRational) -> Option<Algorithm> {
        let whole = || u32::try_from(value.to_integer()).unwrap_or(u32::MAX);
        let (passes, substeps) = match (self, name) {
            (Self::Passes, AlgorithmName::Multiple | AlgorithmName::Synchronised) => (whole(), 1),
            (Self::Substeps, AlgorithmName::Retroactive) => (2, whole()),
            (Self::Passes | Self::Substeps, _) => return None,
            _ => (2, 1),
        };
        Some(name.with(Passes::Count(passes), substeps))
    }

    /// A scene with a value of it; none where that makes no sense.
    fn scene(self, scene: &Scene, value: &BigRational) -> Option<Scene> {
        match self {
            Self::Passes | Self::Substeps => Some(scene.clone()),
            Self::FrameLength => with_frames(scene, value),
            Self::Density => with_radii(scene, value),
            Self::Restitution => with_restitution(scene, value),
        }
    }
}

/// The same time in frames that are so many times as long.
fn with_frames(scene: &Scene, factor: &BigRational) -> Option<Scene> {
    let frame = scene.frame();
    let duration = Number::try_from(frame.duration.to_rational() * factor).ok()?;
    let count = BigRational::from_integer(frame.count.into()) / factor;
    let count = u64::try_from(count.to_integer()).ok()?;
    (count > 0).then(|| scene.to_builder().frame(duration, count).build().ok())?
}

/// The same discs with radii that are so many times as large.
fn with_radii(scene: &Scene, factor: &BigRational) -> Option<Scene> {
    let discs = scene.discs().iter().map(|disc| {
        let radius = Number::try_from(disc.radius.to_rational() * factor).ok()?;
        let mut smaller = disc.clone();
        smaller.radius = radius;
        Some(DiscBuilder::from(smaller))
    });
    let discs: Vec<_> = discs.collect::<Option<_>>()?;
    scene.to_builder().without_discs().discs(discs).build().ok()
}

/// The same scene where impacts between discs leave so much.
fn with_restitution(scene: &Scene, coefficient: &BigRational) -> Option<Scene> {
    let coefficient = Number::try_from(coefficient.clone()).ok()?;
    let restitution = match scene.effects().restitution.clone() {
        Restitution::Elastic => Restitution::newton(coefficient),
        Restitution::Newton {
            walls,
            elastic_below,
            ..
        } => Restitution::Newton {
            coefficient,
            walls,
            elastic_below,
        },
        Restitution::Paper { .. } => return None,
    };
    scene.to_builder().restitution(restitution).build().ok()
}

/// A scene's first frames, as many as sweeps can afford.
pub(super) fn shortened(scene: &Scene, truth: &Truth) -> Option<Scene> {
    let frames = scene.frame().count as f64;
    let effects = scene.effects();
    let effort = match (&effects.gravity, &effects.drag) {
        (None, None) => 1.0,
        (Some(_), Some(_)) => 40.0,
        _ => 8.0,
    };
    let impacts = IMPACTS / effort / truth.impacts.len().max(1) as f64;
    let discs = DISC_FRAMES / scene.discs().len().max(1) as f64 / frames;
    let count = (frames * impacts.min(discs).min(1.0)).floor().max(1.0) as u64;
    let duration = scene.frame().duration.clone();
    scene.to_builder().frame(duration, count).build().ok()
}

/// What came of one value.
#[derive(Clone, Debug)]
pub(super) struct Point {
    pub(super) value: f64,
    pub(super) tally: Tally,
    /// The frames of which the truth is not known.
    pub(super) unknown: u64,
    /// The seconds that the time of a frame of the scene itself takes: the median.
    pub(super) seconds: f64,
}

impl Point {
    /// The wrong impacts among a hundred true ones.
    pub(super) fn wrong_percent(&self) -> Option<f64> {
        let truly = self.tally.matched + self.tally.missed;
        (truly > 0).then(|| 100.0 * self.tally.wrong() as f64 / truly as f64)
    }
}

/// One algorithm under all values.
pub(super) type Line = (AlgorithmName, Vec<Point>);

/// What came of all values.
#[derive(Clone, Debug)]
pub(super) struct Sweep {
    pub(super) kind: Kind,
    pub(super) lines: Vec<Line>,
}

/// One value for one algorithm.
struct Job {
    name: AlgorithmName,
    value: f64,
    scene: Scene,
    candidate: Candidate,
}

impl Sweep {
    /// Tries all values of one thing; none if there is nothing to try.
    pub(super) fn run(
        kind: Kind,
        scene: &Scene,
        names: &[AlgorithmName],
        phase: BroadPhase,
        budget: &Budget,
    ) -> Option<Self> {
        let jobs = jobs(kind, scene, names, phase);
        let runners = jobs.iter();
        let mut runners: Vec<_> = runners
            .map(|job| job.candidate.runner(&job.scene, budget))
            .collect();
        let costs = in_turn(runners.len(), EFFORT, |index| runners[index].time());
        let judged = jobs
            .par_iter()
            .map(|job| job.candidate.judge(&job.scene, budget));
        let judged: Vec<_> = judged.collect();
        let mut lines: BTreeMap<usize, Line> = BTreeMap::new();
        for ((job, cost), judged) in jobs.iter().zip(costs).zip(judged) {
            let place = names.iter().position(|name| *name == job.name)?;
            let line = lines.entry(place).or_insert((job.name, Vec::new()));
            line.1.push(job.point(scene, &cost, &judged.ok()?));
        }
        let lines: Vec<_> = lines.into_values().collect();
        (!lines.is_empty()).then_some(Self { kind, lines })
    }
}

fn jobs(kind: Kind, scene: &Scene, names: &[AlgorithmName], phase: BroadPhase) -> Vec<Job> {
    let values = kind.values().iter();
    let values = values.filter_map(|text| text.parse::<Number>().ok());
    let jobs = values.flat_map(|value| {
        let changed = kind.scene(scene, &value.to_rational());
        let jobs = names.iter().filter_map(move |&name| {
            let candidate = Candidate {
                algorithm: kind.algorithm(name, &value.to_rational())?,
                arithmetic: ArithmeticName::Binary64,
                broad_phase: phase,
            };
            let scene = changed.clone()?;
            candidate.check(&scene).ok()?;
            Some(Job {
                name,
                value: value.to_f64(),
                scene,
                candidate,
            })
        });
        jobs.collect::<Vec<_>>()
    });
    jobs.collect()
}

impl Job {
    fn point(&self, scene: &Scene, cost: &Cost, judged: &Judged) -> Point {
        let frames = self.scene.frame().count;
        let seconds = cost.median().unwrap_or(judged.cost).as_secs_f64();
        Point {
            value: self.value,
            tally: judged.tally,
            unknown: frames - judged.frames + judged.undecided,
            seconds: seconds / scene.frame().count.max(1) as f64,
        }
    }
}
