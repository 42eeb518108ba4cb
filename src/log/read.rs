//! Reading event logs, carom's own and those of other programs.

use std::io::{self, BufRead};

use serde::de::DeserializeOwned;
use serde_json::Value;

use super::event::{Event, Header, Summary};

/// An event log, as read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Log {
    /// The first line, which another program's log may lack.
    pub header: Option<Header>,
    /// The impacts, in the log's order.
    pub events: Vec<Event>,
    /// The last line, which another program's log may lack.
    pub summary: Option<Summary>,
}

/// Why a log cannot be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LogError {
    /// The source cannot be read.
    #[error("cannot be read: {0}")]
    Unreadable(#[from] io::Error),
    /// A line is not one of a log.
    #[error("line {line}: {reason}")]
    Line {
        /// The line, counted from 1.
        line: usize,
        /// What is wrong with it.
        reason: String,
    },
}

impl Log {
    /// Reads a log. Empty lines and unknown keys are passed over.
    ///
    /// # Errors
    ///
    /// The source cannot be read, or a line is neither a header nor an impact
    /// nor a summary, or stands in the wrong place.
    pub fn read(source: impl BufRead) -> Result<Self, LogError> {
        let mut log = Self::default();
        for (number, line) in (1..).zip(source.lines()) {
            let line = line?;
            if !line.trim().is_empty() {
                log.add(&line).map_err(|reason| LogError::Line {
                    line: number,
                    reason,
                })?;
            }
        }
        Ok(log)
    }

    fn add(&mut self, line: &str) -> Result<(), String> {
        let value: Value = serde_json::from_str(line).map_err(|error| error.to_string())?;
        if self.summary.is_some() {
            return Err(String::from("expected nothing after the summary"));
        }
        if value.get("schema").is_some() {
            return self.add_header(value);
        }
        match value.get("summary") {
            Some(summary) => self.summary = Some(parse("summary.", summary.clone())?),
            None => self.events.push(parse("", value)?),
        }
        Ok(())
    }

    fn add_header(&mut self, value: Value) -> Result<(), String> {
        if self.header.is_some() || !self.events.is_empty() {
            return Err(String::from("expected the header in the first line only"));
        }
        self.header = Some(parse("", value)?);
        Ok(())
    }
}

/// A value's typed form, or what is wrong with it, and at which key.
fn parse<T: DeserializeOwned>(place: &str, value: Value) -> Result<T, String> {
    serde_path_to_error::deserialize(value).map_err(|error| {
        let key = error.path().to_string();
        match key.as_str() {
            "." => error.inner().to_string(),
            _ => format!("{place}{key}: {}", error.inner()),
        }
    })
}
