//! `carom validate`: what is wrong with scenes.

use std::path::PathBuf;

use carom::scene::Scene;

use super::error;
use super::exit::Exit;

/// Say what is wrong with scenes, or nothing.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  carom validate scenes/*.json")]
pub(super) struct Arguments {
    /// The scenes; - is standard input.
    #[arg(value_name = "SCENE", required = true)]
    scenes: Vec<PathBuf>,
}

pub(super) fn execute(arguments: &Arguments) -> Exit {
    let mut exit = Exit::Success;
    for path in &arguments.scenes {
        if let Err(fault) = Scene::read(path) {
            error::report(&fault);
            exit = Exit::BadInput;
        }
    }
    exit
}
