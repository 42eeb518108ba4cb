//! `carom vectors`: questions with answers, for tests of other programs.

mod draw;
mod flag;
mod passes;
mod plane;
mod question;
mod response;
mod scenes;
mod text;

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;

use super::error::Error;
use super::exit::Exit;
use super::output::{Output, make_directory};
use draw::Kind;
use question::Question;
use response::{Response, responses};
use scenes::{SceneVector, scenes};

/// Write test vectors for collision code: first impacts, responses, and scenes with
/// their proven logs.
///
/// The files are the same on every platform. Their README.md and check.py are in
/// vectors/ of the source.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  carom vectors vectors")]
pub(super) struct Arguments {
    /// Where they go; made if it is not there.
    #[arg(value_name = "DIR")]
    directory: PathBuf,
}

/// A file of test vectors, an item a line.
#[derive(JsonSchema)]
#[schemars(rename = "Vectors", tag = "kind", rename_all = "kebab-case")]
#[expect(dead_code, reason = "files are written line by line")]
enum Content {
    /// Two discs in free motion.
    DiscDisc {
        schema: Format,
        vectors: Vec<Question>,
    },
    /// A disc and a wall, mostly its inside.
    DiscWall {
        schema: Format,
        vectors: Vec<Question>,
    },
    /// A disc and the end of a wall, mostly.
    DiscEnd {
        schema: Format,
        vectors: Vec<Question>,
    },
    /// Velocities after an impact.
    Response {
        schema: Format,
        vectors: Vec<Response>,
    },
    /// Scenes and their logs.
    Scenes {
        schema: Format,
        vectors: Vec<SceneVector>,
    },
}

/// The name and version of the format.
#[derive(JsonSchema)]
#[schemars(inline)]
enum Format {
    #[schemars(rename = "carom/vectors/1")]
    #[expect(dead_code, reason = "files are written line by line")]
    Vectors1,
}

/// The JSON Schema of the files, as text.
pub(super) fn schema() -> String {
    format!("{:#}\n", schemars::schema_for!(Content).as_value())
}

pub(super) fn execute(arguments: &Arguments) -> Result<Exit, Error> {
    let directory = &arguments.directory;
    make_directory(directory)?;
    for (name, text) in files()? {
        Output::open(&directory.join(format!("{name}.json")))?.write_text(&text)?;
    }
    Ok(Exit::Success)
}

/// The name and the text of each file.
fn files() -> Result<Vec<(&'static str, String)>, Error> {
    let mut files = Vec::new();
    for kind in Kind::ALL {
        let questions = kind.scenes().map(|scene| Ok(Question::of(&scene?)));
        files.push((kind.name(), text(kind.name(), questions)?));
    }
    files.push(("response", text("response", responses().map(Ok))?));
    files.push(("scenes", text("scenes", scenes())?));
    Ok(files)
}

/// A file of some kind, an item a line.
fn text<T: Serialize>(
    kind: &str,
    items: impl Iterator<Item = Result<T, Error>>,
) -> Result<String, Error> {
    let lines = items.map(|item| Ok(serde_json::to_string(&item?).expect("keys are strings")));
    let lines = lines.collect::<Result<Vec<_>, Error>>()?.join(",\n");
    let schema = "\"schema\": \"carom/vectors/1\"";
    Ok(format!(
        "{{{schema}, \"kind\": \"{kind}\", \"vectors\": [\n{lines}\n]}}\n"
    ))
}
