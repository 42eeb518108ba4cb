//! Writing the event log of a run.

use std::io::{self, Write};

use num_rational::BigRational;
use serde::Serialize;

use super::MIN_DIGITS;
use super::contact::Contact;
use super::event::{Ending, Event, EventsFormat, Header, Summary};
use super::quantity::{Bounds, Quantity, nearest};
use crate::arithmetic::Arithmetic;
use crate::body::Disc;
use crate::conserved::{energy, momentum};
use crate::frame::Passes;
use crate::impact::Impact;
use crate::run::{Options, Outcome, Status};
use crate::scene::Scene;
use crate::simulation::Algorithm;
use crate::world::World;

/// A run, to be written as an event log.
#[derive(Debug)]
pub struct Recorder<'a, S: Arithmetic> {
    scene: &'a Scene,
    algorithm: Algorithm,
    options: &'a Options,
    outcome: &'a Outcome<S>,
    digits: u32,
    /// The bodies, where the circumstances of impacts are logged.
    world: Option<World<S>>,
}

#[derive(Serialize)]
struct LastLine {
    summary: Summary,
}

impl<'a, S: Arithmetic> Recorder<'a, S> {
    /// A run of a scene. The circumstances of its impacts are logged if it has
    /// kept them.
    pub fn new(
        scene: &'a Scene,
        algorithm: Algorithm,
        options: &'a Options,
        outcome: &'a Outcome<S>,
    ) -> Self {
        Self {
            scene,
            algorithm,
            options,
            outcome,
            digits: MIN_DIGITS,
            world: options
                .contacts
                .then(|| World::new(scene, outcome.precision)),
        }
    }

    /// Sets how many digits of proven bounds are correct.
    #[must_use]
    pub fn digits(self, digits: u32) -> Self {
        Self { digits, ..self }
    }

    /// Writes the log.
    ///
    /// # Errors
    ///
    /// The writer's.
    pub fn write(&self, mut writer: impl Write) -> io::Result<()> {
        write_line(&mut writer, &self.header())?;
        for event in self.events() {
            write_line(&mut writer, &event)?;
        }
        let summary = self.summary();
        write_line(&mut writer, &LastLine { summary })?;
        writer.flush()
    }

    /// The first line.
    pub fn header(&self) -> Header {
        let passes = match self.algorithm {
            Algorithm::Multiple(passes) | Algorithm::Synchronised(passes) => Some(passes),
            _ => None,
        };
        let overlaps = self.outcome.overlaps;
        let bits = S::bits(self.outcome.precision);
        Header {
            schema: EventsFormat::Events1,
            scene: self.scene.id().to_owned(),
            algorithm: self.algorithm.to_string(),
            arithmetic: S::NAME.to_owned(),
            carom: env!("CARGO_PKG_VERSION").to_owned(),
            bits,
            restarts: bits.map(|_| self.outcome.restarts),
            bits_lost: bits.map(|bits| {
                bits - self
                    .outcome
                    .certain_bits()
                    .map_or(bits, |left| left.min(bits))
            }),
            closest_bits: bits.and(self.outcome.closest_call).map(common_bits),
            passes: passes.and_then(count),
            frame_budget: passes.and_then(budget),
            substeps: match self.algorithm {
                Algorithm::Retroactive { substeps } => Some(substeps),
                _ => None,
            },
            simultaneous: (self.algorithm == Algorithm::Timeline)
                .then(|| self.options.simultaneous.to_string()),
            overlaps: (overlaps > 0).then_some(overlaps),
        }
    }

    /// The lines of the impacts.
    pub fn events(&self) -> impl Iterator<Item = Event> {
        let numbered = (0..).zip(&self.outcome.impacts);
        numbered.map(|(n, impact)| self.event(n, impact))
    }

    fn event(&self, n: u64, impact: &Impact<S>) -> Event {
        let (lo, hi) = Bounds::new(&impact.time, self.digits)
            .map(|bounds| (bounds.lo, bounds.hi))
            .unzip();
        let contact = self.world.as_ref().zip(impact.contact.as_ref());
        Event {
            n: Some(n),
            time: nearest(&impact.time),
            lo,
            hi,
            time_b: impact.other_time.as_ref().map(nearest),
            frame: impact.step.map(|step| step.frame),
            pass: impact.step.map(|step| step.pass),
            a: impact.pair.a,
            b: impact.pair.b,
            end: impact.end,
            image: impact.image.as_deref().copied(),
            tie: impact.tie,
            contact: contact
                .map(|(world, contact)| Contact::new(world, impact, contact, self.digits)),
        }
    }

    /// The last line.
    pub fn summary(&self) -> Summary {
        let outcome = self.outcome;
        let until = nearest_to(self.options.end_of(self.scene));
        let reached = nearest(&outcome.time);
        let states = [&outcome.start, &outcome.end];
        let (question, found) = match &outcome.status {
            Status::Undecided(open) => (Some(open.question.clone()), None),
            Status::Accumulation(found) => (None, Some(found)),
            _ => (None, None),
        };
        Summary {
            events: outcome.impacts.len() as u64,
            grazes: outcome.grazes,
            resting: outcome.rests,
            until,
            reached: (reached != until).then_some(reached),
            status: Ending::from(&outcome.status),
            bits: question.as_ref().and(S::bits(outcome.precision)),
            question,
            limit: found.map(|found| Quantity::of_limit(found, self.digits)),
            proven: found.map(|found| found.proven),
            word: found.map(|found| found.word.iter().map(|pair| [pair.a, pair.b]).collect()),
            energy: states.map(|discs| nearest(&energy(discs))),
            momentum: states.map(|discs| nearest_momentum(discs)),
        }
    }
}

impl From<&Status> for Ending {
    fn from(status: &Status) -> Self {
        match status {
            Status::Complete => Self::Complete,
            Status::Undecided(_) => Self::Undecided,
            Status::Accumulation(_) => Self::Accumulation,
            Status::EventLimit => Self::EventLimit,
            Status::Interrupted => Self::Interrupted,
        }
    }
}

/// The leading bits that two numbers have in common which differ by so much,
/// relative to the larger one.
fn common_bits(difference: f64) -> u32 {
    -difference.log2().min(0.0) as u32
}

fn nearest_to(value: BigRational) -> f64 {
    f64::from_rational(value, ()).min(f64::MAX)
}

fn nearest_momentum<S: Arithmetic>(discs: &[Disc<S>]) -> [f64; 2] {
    let momentum = momentum(discs);
    [nearest(&momentum.x), nearest(&momentum.y)]
}

fn count(passes: Passes) -> Option<u32> {
    match passes {
        Passes::Count(count) => Some(count),
        Passes::Budget(_) => None,
    }
}

fn budget(passes: Passes) -> Option<f64> {
    match passes {
        Passes::Count(_) => None,
        Passes::Budget(budget) => Some(budget.as_secs_f64() * 1e3),
    }
}

fn write_line(writer: &mut impl Write, line: &impl Serialize) -> io::Result<()> {
    serde_json::to_writer(&mut *writer, line)?;
    writer.write_all(b"\n")
}
