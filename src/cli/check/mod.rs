//! `carom check`: another program's log, held against the truth.

mod junit;
mod message;

pub(super) use message::told;

use std::fs::File;
use std::io::{self, BufReader};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use carom::judge::{Logged, Reference, Verdict};
use carom::log::{Event, Judgement, Log, MIN_DIGITS, proven_digits};
use carom::run::Options;
use carom::scalar::{Exact, Number};
use carom::scene::Scene;
use carom::simulation::Algorithm;
use carom::support::check_support;

use super::choice::{self, BudgetArguments, Rule};
use super::error::Error;
use super::exit::Exit;
use super::output::{Output, check_distinct, is_standard, standard};
use super::progress::RunBar;
use super::replay::{Pane, Replay};

/// Judge another program's event log.
///
/// A line of the log needs the time and the two bodies: {"time": 0.25, "a": "d0",
/// "b": "w1"}. Its order is judged, disc by disc, up to the first impact that is not the
/// true one. The status is 1 if nothing excuses that: neither a convention (tangent
/// passes, simultaneous impacts) nor what binary64 can carry.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  carom check scene.json --events theirs.jsonl
  their-program < scene.json | carom check scene.json --events - --junit verdict.xml")]
pub(super) struct Arguments {
    /// The scene.
    scene: PathBuf,
    /// The log; - is standard input.
    #[arg(long, value_name = "FILE")]
    events: PathBuf,
    /// Where the verdict goes as JSON; - is standard output, in place of the text.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Where the verdict goes as a JUnit report, for continuous integration.
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Where a replay of the truth goes, a page of its own with marks at the first
    /// difference; - is standard output, in place of the text.
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// The time at which the truth ends, instead of that of the scene.
    #[arg(long, value_name = "T", value_parser = choice::duration, allow_negative_numbers = true)]
    until: Option<Number>,
    /// The number of true impacts after which nothing more is judged.
    #[arg(long, value_name = "N", default_value_t = 1_000_000,
        value_parser = clap::value_parser!(u64).range(1..))]
    max_events: u64,
    /// How the truth resolves simultaneous impacts that share a disc.
    #[arg(long, value_name = "RULE", value_enum, default_value = "sequential")]
    simultaneous: Rule,
    #[command(flatten)]
    budget: BudgetArguments,
}

pub(super) fn execute(arguments: &Arguments) -> Result<Exit, Error> {
    arguments.check_paths()?;
    let scene = Scene::read(&arguments.scene)?;
    let unsupported = |reason| Error::Unsupported {
        file: arguments.scene.display().to_string(),
        reason,
    };
    check_support::<Exact>(&scene, Algorithm::Timeline).map_err(unsupported)?;
    arguments.check_replay(&scene)?;
    let log = read(&arguments.events)?;
    let log = logged(&scene, &log.events).map_err(|reason| Error::Log {
        file: arguments.events.display().to_string(),
        reason,
    })?;
    let mut bar = RunBar::new();
    let reference = Reference::find(&scene, &arguments.options(), &mut |progress| {
        bar.show(progress);
        ControlFlow::Continue(())
    });
    let reference = reference.map_err(unsupported)?;
    let verdict = reference.judge(&log);
    let judgement = Judgement::new(&scene, &reference, &verdict, MIN_DIGITS);
    arguments.write(&judgement)?;
    arguments.write_replay(&scene, &reference, &verdict)?;
    Ok(exit(&reference, &verdict))
}

impl Arguments {
    /// Standard input is read once, and written to once.
    fn check_paths(&self) -> Result<(), Error> {
        if is_standard(&self.scene) && is_standard(&self.events) {
            let problem = "-: expected only one of the scene and --events";
            return Err(Error::Usage(String::from(problem)));
        }
        check_distinct(&[
            ("--json", &self.json),
            ("--junit", &self.junit),
            ("--html", &self.html),
        ])
    }

    fn options(&self) -> Options {
        Options {
            until: self.until.clone(),
            max_events: self.max_events,
            budget: self.budget.budget(),
            digits: proven_digits(MIN_DIGITS),
            simultaneous: self.simultaneous.simultaneous(),
            contacts: self.html.is_some(),
            ..Options::default()
        }
    }

    fn write(&self, judgement: &Judgement) -> Result<(), Error> {
        let mut results = [&self.json, &self.junit, &self.html].into_iter().flatten();
        if !results.any(|path| is_standard(path)) {
            Output::open(&standard())?.write_text(&message::text(judgement))?;
        }
        if let Some(path) = &self.json {
            Output::open(path)?.write(|writer| {
                serde_json::to_writer_pretty(&mut *writer, judgement)?;
                writer.write_all(b"\n")
            })?;
        }
        match &self.junit {
            Some(path) => Output::open(path)?.write_text(&junit::report(judgement)),
            None => Ok(()),
        }
    }
}

impl Arguments {
    /// A replay shows no copies of discs.
    fn check_replay(&self, scene: &Scene) -> Result<(), Error> {
        match (&self.html, scene.periodic()) {
            (Some(_), Some(_)) => Err(Error::Usage(String::from(
                "--html: expected a scene that is not periodic",
            ))),
            _ => Ok(()),
        }
    }

    fn write_replay(
        &self,
        scene: &Scene,
        reference: &Reference<'_>,
        verdict: &Verdict,
    ) -> Result<(), Error> {
        let Some(path) = &self.html else {
            return Ok(());
        };
        let truth = Pane::new(scene, Algorithm::Timeline, reference.outcome());
        let replay = Replay::of_log(truth, verdict.difference.as_ref());
        Output::open(path)?.write_text(&replay.page(scene))
    }
}

fn read(path: &Path) -> Result<Log, Error> {
    let log = match is_standard(path) {
        true => Log::read(io::stdin().lock()),
        false => File::open(path)
            .map_err(Into::into)
            .and_then(|file| Log::read(BufReader::new(file))),
    };
    log.map_err(|reason| Error::Log {
        file: path.display().to_string(),
        reason: reason.to_string(),
    })
}

/// The impacts of a log, all of which must be of the scene's bodies.
pub(super) fn logged(scene: &Scene, events: &[Event]) -> Result<Vec<Logged>, String> {
    let events = events.iter().enumerate();
    let logged = events.map(|(place, event)| {
        let impact = Logged::from(event);
        match impact.is_of(scene) {
            true => Ok(impact),
            false => Err(format!(
                "impact {place}: expected a disc of the scene and another body of it, found {}",
                impact.pair
            )),
        }
    });
    logged.collect()
}

/// A difference that nothing excuses; else a truth that is not known to the end.
fn exit(reference: &Reference<'_>, verdict: &Verdict) -> Exit {
    match verdict.is_blamed() {
        true => Exit::Difference,
        false => Exit::from(reference.status()),
    }
}
