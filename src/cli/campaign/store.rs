//! The outcomes of a campaign in a file, so that it can go on where it was left.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::outcome::Outcome;
use super::shard::Task;
use crate::cli::error::Error;

/// What all outcomes of a file have in common: its first line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(super) struct Header {
    pub(super) schema: Format,
    /// The version of carom.
    pub(super) carom: String,
    /// The program, with its arguments.
    #[serde(rename = "impl")]
    pub(super) command: String,
    /// The seed of all scenes.
    pub(super) seed: u64,
    /// The seconds that an answer may take.
    pub(super) timeout: f64,
    /// The largest error of a time that is no finding.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "f64")]
    pub(super) time_tolerance: Option<f64>,
}

/// The name and version of the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline)]
pub(super) enum Format {
    /// The first version.
    #[serde(rename = "carom/campaign/1")]
    Campaign1,
}

/// The line of an outcome.
#[derive(Serialize, Deserialize)]
struct Line {
    family: String,
    index: u64,
    #[serde(flatten)]
    outcome: Outcome,
}

/// All outcomes, by family and number.
pub(super) type Outcomes = BTreeMap<Task, Outcome>;

/// A file of outcomes, or none.
pub(super) struct Store {
    file: Option<(PathBuf, BufWriter<File>)>,
    pub(super) outcomes: Outcomes,
}

impl Store {
    /// Outcomes that are not kept.
    pub(super) fn in_memory() -> Self {
        Self {
            file: None,
            outcomes: Outcomes::new(),
        }
    }

    /// A file that is written on, if it is of the same campaign; another one is left as it
    /// is. A last line that was cut off is left out.
    pub(super) fn open(path: &Path, header: &Header) -> Result<Self, Error> {
        let unwritable = |reason| Error::Unwritable {
            file: path.display().to_string(),
            reason,
        };
        let mut options = OpenOptions::new();
        options.read(true).append(true).create(true);
        let mut file = options.open(path).map_err(unwritable)?;
        let text = io::read_to_string(&mut file).map_err(unwritable)?;
        let whole = whole_lines(&text, header);
        let outcomes = read(path, whole, header)?;
        file.set_len(whole.len() as u64).map_err(unwritable)?;
        let mut store = Self {
            outcomes,
            file: Some((path.to_owned(), BufWriter::new(file))),
        };
        if whole.is_empty() {
            store.write(header)?;
        }
        Ok(store)
    }

    pub(super) fn has(&self, task: Task) -> bool {
        self.outcomes.contains_key(&task)
    }

    /// Keeps an outcome.
    pub(super) fn add(&mut self, task: Task, outcome: Outcome) -> Result<(), Error> {
        self.write(&Line {
            family: task.family.name().to_owned(),
            index: task.index,
            outcome: outcome.clone(),
        })?;
        self.outcomes.insert(task, outcome);
        Ok(())
    }

    /// A line at once, so that it is there whatever happens next.
    fn write(&mut self, line: &impl Serialize) -> Result<(), Error> {
        let Some((path, writer)) = &mut self.file else {
            return Ok(());
        };
        let text = json(line) + "\n";
        let written = writer
            .write_all(text.as_bytes())
            .and_then(|()| writer.flush());
        written.map_err(|reason| Error::Unwritable {
            file: path.display().to_string(),
            reason,
        })
    }
}

/// The text without a last line that was cut off; of a first one only if it began as the
/// header does.
fn whole_lines<'a>(text: &'a str, header: &Header) -> &'a str {
    match text.rfind('\n') {
        Some(end) => &text[..=end],
        None if json(header).starts_with(text) => "",
        None => text,
    }
}

fn json(line: &impl Serialize) -> String {
    serde_json::to_string(line).expect("all keys are strings")
}

fn read(path: &Path, text: &str, header: &Header) -> Result<Outcomes, Error> {
    let fault = |line: usize, reason: String| Error::Log {
        file: format!("{}: line {line}", path.display()),
        reason,
    };
    let mut lines = (1..).zip(text.lines());
    let mut outcomes = Outcomes::new();
    if let Some((number, line)) = lines.next() {
        let found: Header =
            serde_json::from_str(line).map_err(|error| fault(number, error.to_string()))?;
        if found != *header {
            let expected = json(header);
            let reason = format!("of another campaign: expected {expected}, found {line}");
            return Err(fault(number, reason));
        }
    }
    for (number, line) in lines {
        let line: Line =
            serde_json::from_str(line).map_err(|error| fault(number, error.to_string()))?;
        let task = Task {
            family: line.family.parse()?,
            index: line.index,
        };
        outcomes.insert(task, line.outcome);
    }
    Ok(outcomes)
}
