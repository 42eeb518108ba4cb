//! The command line as a process: what it writes where, and how it ends.
#![cfg(feature = "cli")]

use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use carom::body::BodyId;
use carom::log::{Log, Quantity, State};
use serde_json::Value;
use tempfile::TempDir;

fn carom(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    command.args(arguments);
    command
}

/// What a call that goes well writes; it has nothing else to say.
fn results(arguments: &[&str]) -> String {
    let done = carom(arguments).assert().success().stderr("");
    String::from_utf8(done.get_output().stdout.clone()).expect("text")
}

/// How a call ends, and what it says.
fn ending(arguments: &[&str]) -> (i32, String) {
    let output = carom(arguments).output().expect("a process");
    let message = String::from_utf8(output.stderr).expect("text");
    (output.status.code().expect("an exit status"), message)
}

fn scene(name: &str) -> String {
    let path = repository().join("scenes").join(name);
    path.display().to_string()
}

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A file in a directory of its own.
struct Scratch {
    directory: TempDir,
}

impl Scratch {
    fn new() -> Self {
        let directory = tempfile::tempdir().expect("a directory");
        Self { directory }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.directory.path().join(name)
    }

    fn name(&self, name: &str) -> String {
        self.path(name).display().to_string()
    }

    fn write(&self, name: &str, content: impl AsRef<[u8]>) -> String {
        fs::write(self.path(name), content).expect("a file");
        self.name(name)
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).expect("a file")
    }
}

fn log(text: &str) -> Log {
    Log::read(text.as_bytes()).expect("a log")
}

/// The log of a run that goes well.
fn run(arguments: &[&str]) -> Log {
    log(&results(&[&["run"], arguments].concat()))
}

/// Who meets whom when, in the log's order.
fn meetings(log: &Log) -> Vec<(f64, String)> {
    let events = log.events.iter();
    events
        .map(|event| (event.time, format!("{} {}", event.a, event.b)))
        .collect()
}

fn bounds(event: &carom::log::Event) -> [&str; 2] {
    [&event.lo, &event.hi].map(|bound| bound.as_deref().expect("a bound"))
}

fn numbers(vector: &[Quantity; 2]) -> [f64; 2] {
    [vector[0].to_f64(), vector[1].to_f64()]
}

/// A scene of a disc of radius 1 with these keys, and what follows the discs.
fn one_disc(keys: &str, rest: &str) -> String {
    format!(
        r#"{{"schema": "carom/scene/1", "discs": [{{"radius": 1, {keys}}}], {rest} "notes": ""}}"#
    )
}

#[path = "cli/running.rs"]
mod running;

#[path = "cli/proving.rs"]
mod proving;

#[path = "cli/outputs.rs"]
mod outputs;

#[path = "cli/budget.rs"]
mod budget;

#[path = "cli/refusing.rs"]
mod refusing;

#[path = "cli/comparing.rs"]
mod comparing;

#[path = "cli/paging.rs"]
mod paging;

#[path = "cli/making.rs"]
mod making;

#[path = "cli/checking.rs"]
mod checking;

#[path = "cli/drawing.rs"]
mod drawing;

#[path = "cli/judging.rs"]
mod judging;

#[path = "cli/vectors.rs"]
mod vectors;

#[cfg(unix)]
#[path = "cli/campaigning.rs"]
mod campaigning;

#[cfg(unix)]
#[path = "cli/interrupting.rs"]
mod interrupting;
