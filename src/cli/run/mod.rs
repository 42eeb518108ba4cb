//! `carom run`: one scene, one algorithm, one arithmetic.

mod pictures;

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use carom::arithmetic::Arithmetic;
use carom::log::{MIN_DIGITS, Recorder, State, end_scene, proven_digits};
use carom::run::{Options, Outcome, Status, run};
use carom::scalar::{Exact, Filtered, Number};
use carom::scene::Scene;
use carom::simulation::Algorithm;
use carom::support::{Unsupported, check_support};

use super::choice::{self, AlgorithmArguments, ArithmeticName, BudgetArguments, Phase, Rule};
use super::error::{self, Error};
use super::exit::Exit;
use super::interrupt;
use super::output::{Output, check_distinct, is_standard, standard};
use super::progress::RunBar;
use super::trace::Trace;

/// Run a scene and log its impacts.
///
/// Numbers in a scene: a bare one, 0.1, is the nearest binary64; a string,
/// "0.1", is exact.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  carom run scenes/figure-7.json
  carom run scenes/table1-full.json --arithmetic exact --events log.jsonl --state end.json
  carom run scene.json --algorithm multiple --passes 3 --until 1/2")]
pub(super) struct Arguments {
    /// The scene; - is standard input.
    scene: PathBuf,
    #[command(flatten)]
    algorithm: AlgorithmArguments,
    /// The numbers that it is computed with: f64, filtered (whose decisions are
    /// exact for its numbers) or exact.
    #[arg(long, value_name = "N", default_value = "f64")]
    arithmetic: ArithmeticName,
    /// Where the event log goes; - is standard output, as is the default
    /// unless the state alone is asked for.
    #[arg(long, value_name = "FILE")]
    events: Option<PathBuf>,
    /// Where the state at the end goes; - is standard output.
    #[arg(long, value_name = "FILE")]
    state: Option<PathBuf>,
    /// Where the end goes as a scene, to go on from; - is standard output.
    /// Its numbers are rounded to binary64, or with --digits those of exact
    /// arithmetic to that many.
    #[arg(long, value_name = "FILE")]
    final_scene: Option<PathBuf>,
    /// Where a picture of the motion goes, as SVG; - is standard output.
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// The frame that is drawn, from 0 on, instead of all of the run.
    #[arg(long, value_name = "K", requires = "svg")]
    svg_frame: Option<u64>,
    /// Where a replay of the run goes, a page of its own; beside it plays the exact
    /// timeline, unless the run is that. - is standard output.
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Where the run goes as a Chrome trace, which opens in Perfetto: a second of it is a
    /// second of simulated time; - is standard output.
    #[arg(long, value_name = "FILE")]
    trace: Option<PathBuf>,
    /// The time at which the run ends, an exact number such as 1/3, instead
    /// of that of the scene. Frame algorithms finish the frame.
    #[arg(long, value_name = "T", value_parser = choice::duration, allow_negative_numbers = true)]
    until: Option<Number>,
    /// The number of impacts after which the run ends.
    #[arg(
        long,
        value_name = "N",
        default_value_t = Options::default().max_events,
        value_parser = clap::value_parser!(u64).range(1..)
    )]
    max_events: u64,
    /// How many decimal digits exact arithmetic proves of each time; 20 at
    /// the least, which is the default.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(20..=10_000))]
    digits: Option<u32>,
    #[command(flatten)]
    budget: BudgetArguments,
    /// How the timeline resolves simultaneous impacts that share a disc: one
    /// pair at a time, or all at once [default: sequential].
    #[arg(long, value_name = "RULE", value_enum)]
    simultaneous: Option<Rule>,
    /// How pairs are found that may meet; the log is the same.
    #[arg(long, value_name = "PHASE", value_enum, default_value = "grid")]
    broad_phase: Phase,
    /// Log the contact point, the normal and the velocities after.
    #[arg(long)]
    contact: bool,
}

/// What is written where.
struct Outputs {
    events: Option<Output>,
    state: Option<Output>,
    final_scene: Option<Output>,
    svg: Option<Output>,
    html: Option<Output>,
    trace: Option<Output>,
}

pub(super) fn execute(arguments: &Arguments) -> Result<Exit, Error> {
    let algorithm = arguments.algorithm.algorithm()?;
    arguments.check_outputs()?;
    arguments.check_rule(algorithm)?;
    arguments.check_phase(algorithm)?;
    let scene = Scene::read(&arguments.scene)?;
    match arguments.arithmetic {
        ArithmeticName::Binary64 => arguments.run::<f64>(&scene, algorithm),
        ArithmeticName::Filtered => arguments.run::<Filtered>(&scene, algorithm),
        ArithmeticName::Exact => arguments.run::<Exact>(&scene, algorithm),
    }
}

impl Arguments {
    fn run<S: Arithmetic>(&self, scene: &Scene, algorithm: Algorithm) -> Result<Exit, Error> {
        let unsupported = |reason| self.unsupported(reason);
        check_support::<S>(scene, algorithm).map_err(unsupported)?;
        self.check_until::<S>()?;
        self.check_pictures(scene)?;
        interrupt::listen();
        let outputs = self.open_outputs()?;
        let options = self.options();
        let outcome = watched::<S>(scene, algorithm, &options).map_err(unsupported)?;
        self.write(outputs, scene, algorithm, &options, &outcome)?;
        tell(&self.scene, &outcome.status);
        Ok(Exit::from(&outcome.status))
    }

    /// The end is a number like those of the scene.
    fn check_until<S: Arithmetic>(&self) -> Result<(), Error> {
        match (&self.until, S::RANGE) {
            (Some(until), Some(range)) if !until.is_within(range) => Err(Error::Usage(format!(
                "--until: expected at most 2^{range} for {}, found {until}",
                S::NAME
            ))),
            _ => Ok(()),
        }
    }

    fn options(&self) -> Options {
        Options {
            until: self.until.clone(),
            max_events: self.max_events,
            budget: self.budget.budget(),
            digits: proven_digits(self.shown_digits()),
            contacts: self.contact || self.has_pictures(),
            simultaneous: self
                .simultaneous
                .map(Rule::simultaneous)
                .unwrap_or_default(),
            broad_phase: self.broad_phase.of_timeline().unwrap_or_default(),
            frame_broad_phase: self.broad_phase.of_frames(),
        }
    }

    fn shown_digits(&self) -> u32 {
        self.digits.unwrap_or(MIN_DIGITS)
    }

    /// Where the event log goes, if anywhere.
    fn events(&self) -> Option<PathBuf> {
        let others = [&self.final_scene, &self.svg, &self.html, &self.trace];
        let mut others = others.into_iter().flatten();
        let takes_output = others.any(|path| is_standard(path));
        match &self.events {
            None if self.state.is_none() && !takes_output => Some(standard()),
            events => events.clone(),
        }
    }

    /// The rule belongs to the timeline alone.
    fn check_rule(&self, algorithm: Algorithm) -> Result<(), Error> {
        match self.simultaneous {
            Some(_) if algorithm != Algorithm::Timeline => Err(Error::Usage(format!(
                "--simultaneous: not an option of the algorithm {algorithm}"
            ))),
            _ => Ok(()),
        }
    }

    /// The timeline does not have every broad phase.
    fn check_phase(&self, algorithm: Algorithm) -> Result<(), Error> {
        match self.broad_phase.of_timeline() {
            None if algorithm == Algorithm::Timeline => Err(Error::Usage(String::from(
                "--broad-phase bsp: expected all-pairs or grid for the algorithm timeline",
            ))),
            _ => Ok(()),
        }
    }

    fn check_outputs(&self) -> Result<(), Error> {
        check_distinct(&[
            ("--events", &self.events),
            ("--state", &self.state),
            ("--final-scene", &self.final_scene),
            ("--svg", &self.svg),
            ("--html", &self.html),
            ("--trace", &self.trace),
        ])
    }

    /// Opens all files before the run, for it may take long.
    fn open_outputs(&self) -> Result<Outputs, Error> {
        let open = |path: Option<&Path>| path.map(Output::open).transpose();
        Ok(Outputs {
            events: open(self.events().as_deref())?,
            state: open(self.state.as_deref())?,
            final_scene: open(self.final_scene.as_deref())?,
            svg: open(self.svg.as_deref())?,
            html: open(self.html.as_deref())?,
            trace: open(self.trace.as_deref())?,
        })
    }

    fn write<S: Arithmetic>(
        &self,
        outputs: Outputs,
        scene: &Scene,
        algorithm: Algorithm,
        options: &Options,
        outcome: &Outcome<S>,
    ) -> Result<(), Error> {
        if let Some(output) = outputs.state {
            let state = State::at_end(scene, outcome, self.shown_digits());
            output.write_text(&state.to_json())?;
        }
        if let Some(output) = outputs.final_scene {
            let end = end_scene(scene, outcome, self.digits)?;
            output.write_text(&end.to_json())?;
        }
        if let Some(output) = outputs.svg {
            output.write_text(&self.picture(scene, algorithm, outcome)?)?;
        }
        if let Some(output) = outputs.html {
            output.write_text(&self.replay(scene, algorithm, options, outcome)?)?;
        }
        if let Some(output) = outputs.trace {
            let trace = Trace::of(outcome, scene.walls().len());
            output.write(|writer| serde_json::to_writer(writer, &trace).map_err(Into::into))?;
        }
        if let Some(output) = outputs.events {
            let logged = Options {
                contacts: self.contact,
                ..options.clone()
            };
            let recorder = Recorder::new(scene, algorithm, &logged, outcome);
            let recorder = recorder.digits(self.shown_digits());
            output.write(|writer| recorder.write(writer))?;
        }
        Ok(())
    }

    fn unsupported(&self, reason: Unsupported) -> Error {
        Error::Unsupported {
            file: self.scene.display().to_string(),
            reason,
        }
    }
}

/// A run that shows its progress and heeds Ctrl-C.
fn watched<S: Arithmetic>(
    scene: &Scene,
    algorithm: Algorithm,
    options: &Options,
) -> Result<Outcome<S>, Unsupported> {
    let mut bar = RunBar::new();
    run(scene, algorithm, options, &mut |progress| {
        bar.show(progress);
        match interrupt::is_interrupted() {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    })
}

/// Says why a run did not come to its end.
fn tell(scene: &Path, status: &Status) {
    let scene = scene.display();
    match status {
        Status::Complete => {}
        Status::Undecided(open) => error::report(&format_args!("{scene}: undecided: {open}")),
        Status::Accumulation(found) => {
            error::report(&format_args!("{scene}: accumulation: {found}"));
        }
        Status::EventLimit => {
            error::report(&format_args!("{scene}: ended by the limit of --max-events"));
        }
        Status::Interrupted => error::report(&format_args!("{scene}: interrupted")),
    }
}
