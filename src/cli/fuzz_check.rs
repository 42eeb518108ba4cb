//! `carom fuzz-check`: scenes that a fuzzer has found, once more.

use std::path::{Path, PathBuf};

use carom::check::{Finding, check, check_support, minimise};
use carom::scene::Scene;

use super::error::{self, Error};
use super::exit::Exit;
use super::output::{Output, standard};

/// Check the binary64 runs of scenes against the truth.
///
/// Every decision of a run is verified exactly, from the run's own state; what
/// rounding explains is no finding. A scene with one is made as small as it
/// gets and written to standard output.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  carom fuzz-check scenes/regressions/*.json > smaller.json")]
pub(super) struct Arguments {
    /// The scenes; - is standard input.
    #[arg(value_name = "SCENE", required = true)]
    scenes: Vec<PathBuf>,
    /// Only name the findings.
    #[arg(long)]
    no_minimise: bool,
}

pub(super) fn execute(arguments: &Arguments) -> Result<Exit, Error> {
    let mut exit = Exit::Success;
    for path in &arguments.scenes {
        let scene = Scene::read(path)?;
        check_support(&scene).map_err(|reason| Error::Unsupported {
            file: path.display().to_string(),
            reason,
        })?;
        if let Err(finding) = check(&scene) {
            exit = Exit::Difference;
            tell(path, &finding);
            if !arguments.no_minimise {
                write_smaller(&scene, &finding)?;
            }
        }
    }
    Ok(exit)
}

fn tell(path: &Path, finding: &Finding) {
    let path = path.display();
    error::report(&format_args!("{path}: {finding}"));
    error::report(&format_args!("to replay it: carom fuzz-check {path}"));
}

fn write_smaller(scene: &Scene, finding: &Finding) -> Result<(), Error> {
    let smaller = minimise(scene, finding).to_builder();
    let smaller = smaller.notes(finding.to_string()).build()?;
    Output::open(&standard())?.write_text(&smaller.to_json())
}
