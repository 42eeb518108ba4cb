//! What may be asked.

use carom::log::Event;
use carom::scalar::Number;
use serde::Deserialize;
use serde_json::value::RawValue;

/// A question.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Request<'a> {
    /// Repeated in the answer.
    #[serde(borrow, default)]
    pub(super) id: Option<&'a RawValue>,
    pub(super) request: Kind,
    /// The scene that is simulated, or that a log is of.
    #[serde(borrow, default)]
    pub(super) scene: Option<&'a RawValue>,
    /// The log that is judged.
    #[serde(default)]
    pub(super) events: Option<Vec<Event>>,
    /// The disc of a first impact.
    #[serde(borrow, default)]
    pub(super) a: Option<&'a RawValue>,
    /// The disc or the wall that it meets.
    #[serde(borrow, default)]
    pub(super) b: Option<&'a RawValue>,
    #[serde(default)]
    pub(super) until: Option<Number>,
    #[serde(default)]
    pub(super) max_events: Option<u64>,
    #[serde(default)]
    pub(super) digits: Option<u32>,
    #[serde(default)]
    pub(super) contact: bool,
}

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Kind {
    FirstImpact,
    Simulate,
    Judge,
}

/// The name alone, of a line that is no request otherwise.
#[derive(Deserialize)]
struct Named<'a> {
    #[serde(borrow, default)]
    id: Option<&'a RawValue>,
}

impl<'a> Request<'a> {
    /// Reads a line: its name, and the request or what is wrong with it.
    pub(super) fn read(line: &'a [u8]) -> (Option<&'a RawValue>, Result<Self, String>) {
        match serde_json::from_slice::<Self>(line) {
            Ok(request) => (request.id, Ok(request)),
            Err(error) => {
                let named = serde_json::from_slice::<Named<'_>>(line);
                (
                    named.ok().and_then(|named| named.id),
                    Err(error.to_string()),
                )
            }
        }
    }
}
