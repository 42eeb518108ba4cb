//! Findings that are expected, each with its reason.

use std::fs;
use std::path::Path;

use carom::scene::generate::Family;
use serde::Deserialize;

use super::outcome::Class;
use super::shard::Task;
use crate::cli::error::Error;

/// A finding that is expected: in a scene, or in a family as often as it comes.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Known {
    scene: Option<String>,
    family: Option<String>,
    finding: Class,
    reason: String,
}

/// The expected findings of a file, a list in JSON.
pub(super) fn read(path: &Path) -> Result<Vec<Known>, Error> {
    let fault = |reason: String| Error::Log {
        file: path.display().to_string(),
        reason,
    };
    let text = fs::read_to_string(path).map_err(|reason| fault(reason.to_string()))?;
    let known: Vec<Known> =
        serde_json::from_str(&text).map_err(|error| fault(error.to_string()))?;
    for (place, entry) in known.iter().enumerate() {
        entry
            .check()
            .map_err(|reason| fault(format!("[{place}]{reason}")))?;
    }
    Ok(known)
}

impl Known {
    fn check(&self) -> Result<(), String> {
        if !self.finding.is_finding() {
            let found = self.finding.name();
            return Err(format!(
                ".finding: expected one that is wrong, found {found}"
            ));
        }
        if self.reason.trim().is_empty() {
            return Err(String::from(".reason: expected a reason"));
        }
        match (&self.scene, &self.family) {
            (Some(_), None) => Ok(()),
            (None, Some(family)) => family
                .parse::<Family>()
                .map(|_| ())
                .map_err(|error| format!(".{error}")),
            _ => Err(String::from(": expected either a scene or a family")),
        }
    }

    /// Whether it is about a scene.
    fn names(&self, task: Task, seed: u64) -> bool {
        let is_scene = |name: &String| *name == task.name(seed);
        let is_family = |name: &String| name == task.family.name();
        self.scene.as_ref().is_some_and(is_scene) || self.family.as_ref().is_some_and(is_family)
    }

    /// Whether it expects what comes of a scene.
    pub(super) fn expects(&self, task: Task, seed: u64, class: Class) -> bool {
        self.finding == class && self.names(task, seed)
    }

    /// Whether, of all that it is about, nothing shows the finding any more.
    pub(super) fn is_passing(&self, all: &[(Task, Class)], seed: u64) -> bool {
        let mut named = all
            .iter()
            .filter(|(task, _)| self.names(*task, seed))
            .peekable();
        named.peek().is_some() && named.all(|(_, class)| *class != self.finding)
    }

    /// What is expected, and why.
    pub(super) fn told(&self) -> String {
        let name = self.scene.as_ref().or(self.family.as_ref());
        let name = name.map_or("", String::as_str);
        format!("{name}: {} ({})", self.finding.name(), self.reason)
    }
}
