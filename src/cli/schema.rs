//! `carom schema`: the formats of the files.

use carom::log::{events_schema, state_schema, verdict_schema};
use carom::scene::scene_schema;
use clap::ValueEnum;

use super::campaign;
use super::error::Error;
use super::exit::Exit;
use super::output::{Output, standard};
use super::vectors;

/// Print the JSON Schema of a format.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  carom schema scene > scene.schema.json")]
pub(super) struct Arguments {
    /// The format.
    format: Format,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    /// Scenes, carom/scene/1.
    Scene,
    /// A line of an event log, carom/events/1.
    Events,
    /// States, carom/state/1.
    State,
    /// Judgements, carom/verdict/1.
    Verdict,
    /// Summaries of campaigns, carom/campaign/1.
    Campaign,
    /// Files of test vectors, carom/vectors/1.
    Vectors,
}

pub(super) fn execute(arguments: &Arguments) -> Result<Exit, Error> {
    let schema = match arguments.format {
        Format::Scene => scene_schema(),
        Format::Events => events_schema(),
        Format::State => state_schema(),
        Format::Verdict => verdict_schema(),
        Format::Campaign => campaign::schema(),
        Format::Vectors => vectors::schema(),
    };
    Output::open(&standard())?.write_text(&schema)?;
    Ok(Exit::Success)
}
