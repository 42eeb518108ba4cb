//! `carom campaign`: another program, held against the truth of many scenes.

mod foreign;
mod known;
mod outcome;
mod shard;
mod shrink;
mod store;
mod summary;

use std::collections::HashMap;
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use carom::run::Options;
use carom::scene::Scene;
use carom::scene::generate::Family;

use super::error::{self, Error};
use super::exit::Exit;
use super::interrupt;
use super::output::{Output, is_standard, make_directory, standard};
use super::progress;
use foreign::Foreign;
use known::Known;
use outcome::{Examiner, Outcome};
use shard::{Task, go_through};
use store::{Format, Header, Store};
use summary::{Report, Summary};

/// So many findings are told; the files have all.
const TOLD: usize = 20;

/// Hold another program against the truth of many generated scenes.
///
/// The program answers on standard output what it is asked on standard input, a line of
/// JSON each: {"id": 1, "request": "simulate", "max_events": N, "scene": SCENE} by {"id": 1,
/// "events": [{"time": 0.25, "a": "d0", "b": "w1"}, ...]}, or by {"id": 1, "error": ...}
/// where it does not simulate such a scene. What it misses, invents or gets wrong is a
/// finding, and so is no answer in time, the program's end, and an answer that makes no sense.
///
/// A scene depends on its family, the seed and its number alone: --start and --count cut
/// the work in any way, and the outcomes are the same. With --output, scenes with findings
/// are made as small as they get, and the same command goes on where it was left.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  carom campaign --impl 'carom oracle --arithmetic f64' --count 1000
  carom campaign --impl 'python3 engine.py' --family bullets,corners --output findings
  carom campaign --impl 'python3 engine.py' --scene findings/scenes/corners-1-7-missed.json")]
pub(super) struct Arguments {
    /// The program, with its arguments, as a shell has them.
    #[arg(long = "impl", value_name = "COMMAND")]
    command: String,
    /// The families of scenes.
    #[arg(long, value_name = "FAMILY", value_delimiter = ',', value_parser = family,
        default_values_t = Family::ALL)]
    family: Vec<Family>,
    /// The seed of all scenes.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The number of the first scene of each family.
    #[arg(long, value_name = "N", default_value_t = 0)]
    start: u64,
    /// How many scenes of each family.
    #[arg(long, value_name = "N", default_value_t = 100)]
    count: u64,
    /// The seconds that an answer may take.
    #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = seconds)]
    timeout: Duration,
    /// The largest error of a time that is no finding; without it only the order counts.
    #[arg(long, value_name = "T", value_parser = tolerance)]
    time_tolerance: Option<f64>,
    /// How many programs run at once [default: one a processor].
    #[arg(long, value_name = "N")]
    threads: Option<NonZero<usize>>,
    /// A directory for the outcomes and the smallest scenes with findings.
    #[arg(long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// How many findings of a kind and family are made small.
    #[arg(long, value_name = "N", default_value_t = 1, requires = "output")]
    shrink: usize,
    /// Findings that are expected, a list of {"scene" or "family": NAME, "finding": KIND,
    /// "reason": TEXT}; one that does not come is a difference, too.
    #[arg(long, value_name = "FILE")]
    known: Option<PathBuf>,
    /// Where the summary goes as JSON; - is standard output, in place of the table.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Scenes of files, instead of generated ones.
    #[arg(long, value_name = "FILE", num_args = 1..,
        conflicts_with_all = ["output", "known", "json", "start", "count", "seed", "family"])]
    scene: Vec<PathBuf>,
}

fn family(name: &str) -> Result<Family, String> {
    name.parse().map_err(|error| format!("{error}"))
}

fn seconds(text: &str) -> Result<Duration, &'static str> {
    let expected = "expected a positive number of seconds";
    let number: f64 = text.parse().map_err(|_| expected)?;
    let duration = Duration::try_from_secs_f64(number).map_err(|_| expected)?;
    (!duration.is_zero()).then_some(duration).ok_or(expected)
}

fn tolerance(text: &str) -> Result<f64, &'static str> {
    let number = text.parse().ok().filter(|number: &f64| *number >= 0.0);
    number.ok_or("expected a number that is not negative")
}

pub(super) fn execute(arguments: &Arguments) -> Result<Exit, Error> {
    let command = arguments.words()?;
    let options = outcome::options();
    interrupt::listen();
    let campaign = Campaign {
        arguments,
        command: &command,
        options: &options,
    };
    match arguments.scene.is_empty() {
        true => campaign.run(),
        false => campaign.replay(),
    }
}

impl Arguments {
    /// The program and its arguments.
    fn words(&self) -> Result<Vec<String>, Error> {
        let fault = |reason: String| Error::Usage(format!("--impl: {reason}"));
        let words = shell_words::split(&self.command).map_err(|error| fault(error.to_string()))?;
        match words.is_empty() {
            true => Err(fault(String::from("expected a command"))),
            false => Ok(words),
        }
    }

    fn header(&self) -> Header {
        Header {
            schema: Format::Campaign1,
            carom: env!("CARGO_PKG_VERSION").to_owned(),
            command: self.command.clone(),
            seed: self.seed,
            timeout: self.timeout.as_secs_f64(),
            time_tolerance: self.time_tolerance,
        }
    }

    /// All scenes, number by number.
    fn tasks(&self) -> Vec<Task> {
        let numbers = self.start..self.start.saturating_add(self.count);
        let families = Family::ALL.into_iter();
        let families: Vec<_> = families
            .filter(|known| self.family.contains(known))
            .collect();
        let tasks = numbers.flat_map(|index| {
            let families = families.iter();
            families.map(move |&family| Task { family, index })
        });
        tasks.collect()
    }

    fn store(&self, header: &Header) -> Result<Store, Error> {
        let Some(directory) = &self.output else {
            return Ok(Store::in_memory());
        };
        make_directory(directory)?;
        Store::open(&directory.join("outcomes.jsonl"), header)
    }
}

/// A campaign with all that it needs.
struct Campaign<'a> {
    arguments: &'a Arguments,
    command: &'a [String],
    options: &'a Options,
}

impl<'a> Campaign<'a> {
    fn examiner(&self) -> Examiner<'a> {
        let foreign = Foreign::new(self.command, self.arguments.timeout);
        Examiner::new(foreign, self.options, self.arguments.time_tolerance)
    }

    fn run(&self) -> Result<Exit, Error> {
        let known = self.arguments.known.as_deref().map(known::read);
        let known: Vec<Known> = known.transpose()?.unwrap_or_default();
        let header = self.arguments.header();
        let tasks = self.arguments.tasks();
        let mut store = self.arguments.store(&header)?;
        self.go_on(&tasks, &mut store)?;
        let outcomes = tasks.iter().filter_map(|task| {
            let outcome = store.outcomes.get(task)?;
            Some((*task, outcome.clone()))
        });
        let summary = Summary::new(&header, outcomes.collect(), &known);
        if let Some(directory) = &self.arguments.output {
            self.shrink(&summary, &directory.join("scenes"))?;
        }
        self.tell(&summary)?;
        Ok(exit(&summary))
    }

    /// Examines what has not been yet.
    fn go_on(&self, tasks: &[Task], store: &mut Store) -> Result<(), Error> {
        let left = tasks.iter().filter(|task| !store.has(**task));
        let left: Vec<_> = left.copied().collect();
        if left.len() < tasks.len() {
            let done = tasks.len() - left.len();
            error::report(&format_args!("{done} of {} scenes were done", tasks.len()));
        }
        let threads = self.arguments.threads.map_or_else(processors, NonZero::get);
        let examiners = (0..threads).map(|_| self.examiner()).collect();
        let bar = progress::stages(tasks.len() as u64);
        bar.set_position((tasks.len() - left.len()) as u64);
        let gone = go_through(&left, self.arguments.seed, examiners, |task, outcome| {
            bar.inc(1);
            store.add(task, outcome)
        });
        bar.finish_and_clear();
        gone
    }

    /// Makes the first scenes of each kind of finding small.
    fn shrink(&self, summary: &Summary<'_>, directory: &Path) -> Result<(), Error> {
        let mut seen: HashMap<_, usize> = HashMap::new();
        let mut examiner = self.examiner();
        for (task, outcome) in summary.surprises() {
            let count = seen.entry((task.family, outcome.class)).or_default();
            *count += 1;
            if *count <= self.arguments.shrink && !interrupt::is_interrupted() {
                let scene = task.scene(self.arguments.seed)?;
                let command = &self.arguments.command;
                shrink::save(&scene, outcome, &mut examiner, command, directory)?;
            }
        }
        Ok(())
    }

    fn tell(&self, summary: &Summary<'_>) -> Result<(), Error> {
        let json = self.arguments.json.as_deref();
        if !json.is_some_and(is_standard) {
            Output::open(&standard())?.write_text(&format!("{}\n", summary.table()))?;
        }
        if let Some(path) = json {
            Output::open(path)?.write(|writer| {
                serde_json::to_writer_pretty(&mut *writer, &summary.report())?;
                writer.write_all(b"\n")
            })?;
        }
        let seed = self.arguments.seed;
        let mut more = 0;
        for (number, (task, outcome)) in summary.surprises().enumerate() {
            match number < TOLD {
                true => error::report(&told(&task.name(seed), outcome)),
                false => more += 1,
            }
        }
        if more > 0 {
            error::report(&format_args!("and {more} more"));
        }
        for entry in summary.passing() {
            error::report(&format_args!("expected, and does not come: {entry}"));
        }
        Ok(())
    }

    /// Examines scenes of files.
    fn replay(&self) -> Result<Exit, Error> {
        let mut exit = Exit::Success;
        let mut examiner = self.examiner();
        for path in &self.arguments.scene {
            let scene = Scene::read(path)?;
            let outcome = examiner.examine(&scene);
            let text = format!("{}\n", told(scene.id(), &outcome));
            Output::open(&standard())?.write_text(&text)?;
            if outcome.class.is_finding() {
                exit = Exit::Difference;
            }
        }
        Ok(exit)
    }
}

/// The JSON Schema of `carom/campaign/1`, as text.
pub(super) fn schema() -> String {
    let schema = schemars::schema_for!(Report<'static>);
    format!("{:#}\n", schema.as_value())
}

fn told(name: &str, outcome: &Outcome) -> String {
    let detail = outcome.detail.iter();
    let detail: String = detail.map(|detail| format!(": {detail}")).collect();
    format!("{name}: {}{detail}", outcome.class.name())
}

fn exit(summary: &Summary<'_>) -> Exit {
    if interrupt::is_interrupted() {
        return Exit::Interrupted;
    }
    match summary.surprises().next().is_none() && summary.passing().is_empty() {
        true => Exit::Success,
        false => Exit::Difference,
    }
}

fn processors() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}
