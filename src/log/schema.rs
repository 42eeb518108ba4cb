//! The JSON Schemas of event logs and states, made from the types that are
//! written.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

use super::{Event, Header, Judgement, State, Summary};
use crate::body::{BodyId, End};

/// The JSON Schema of a line of `carom/events/1`, as text.
pub fn events_schema() -> String {
    text(&schemars::schema_for!(Line))
}

/// The JSON Schema of `carom/state/1`, as text.
pub fn state_schema() -> String {
    text(&schemars::schema_for!(State))
}

/// The JSON Schema of `carom/verdict/1`, as text.
pub fn verdict_schema() -> String {
    text(&schemars::schema_for!(Judgement))
}

fn text(schema: &Schema) -> String {
    format!("{:#}\n", schema.as_value())
}

/// A line of an event log: first a header, then a line for each impact, then
/// a summary.
#[derive(JsonSchema)]
#[schemars(untagged, rename = "EventLogLine")]
#[expect(dead_code, reason = "lines are written as what they are")]
enum Line {
    Header(Header),
    Event(Box<Event>),
    Summary { summary: Summary },
}

impl JsonSchema for BodyId {
    fn schema_name() -> Cow<'static, str> {
        "Body".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "`d<i>`, the i-th disc, or `w<j>`, the j-th wall.",
            "type": "string",
            "pattern": "^[dw][0-9]+$",
        })
    }
}

impl JsonSchema for End {
    fn schema_name() -> Cow<'static, str> {
        "End".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "An end point of a wall.",
            "enum": ["from", "to"],
        })
    }
}
