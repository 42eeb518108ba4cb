//! The JSON Schema of scenes, made from the types that read them.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

use super::json::Parts;
use super::{Mass, Restitution};
use crate::scalar::Number;

/// What an exact number looks like: an integer, a fraction, a decimal, a
/// decimal with an exponent, or a hex float.
const EXACT: &str = concat!(
    r"^[+-]?(",
    r"[0-9]+/[0-9]+",
    r"|([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?",
    r"|0[xX]([0-9a-fA-F]+(\.[0-9a-fA-F]*)?|\.[0-9a-fA-F]+)([pP][+-]?[0-9]+)?",
    r")$"
);

/// The JSON Schema of `carom/scene/1`, as text.
pub fn scene_schema() -> String {
    let schema = schemars::schema_for!(Parts);
    format!("{:#}\n", schema.as_value())
}

impl JsonSchema for Number {
    fn schema_name() -> Cow<'static, str> {
        "Number".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A bare number is the binary64 nearest to its text; a string is \
                exact: \"3\", \"-1/3\", \"0.1\", \"1e-30\" or \"0x1.8p+1\".",
            "oneOf": [
                { "type": "number" },
                { "type": "string", "pattern": EXACT },
            ],
        })
    }
}

impl JsonSchema for Mass {
    fn schema_name() -> Cow<'static, str> {
        "Mass".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A positive number, or \"infinite\": collisions never deflect the \
                disc, though it may move.",
            "oneOf": [
                generator.subschema_for::<Number>(),
                { "const": "infinite" },
            ],
        })
    }
}

impl JsonSchema for Restitution {
    fn schema_name() -> Cow<'static, str> {
        "Restitution".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "What impacts leave of the motion.",
            "oneOf": [
                generator.subschema_for::<Newton>(),
                generator.subschema_for::<Paper>(),
            ],
        })
    }
}

/// Newton's law: the normal relative speed after an impact is so many times
/// that before.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Newton {
    /// From 0, perfectly inelastic, to 1, elastic.
    #[schemars(rename = "newton")]
    _newton: Number,
    /// The coefficient of impacts with walls, where it differs.
    #[schemars(
        rename = "walls",
        default,
        skip_serializing_if = "Option::is_none",
        with = "Number"
    )]
    _walls: Option<Number>,
    /// Impacts slower than this positive number lose nothing.
    #[schemars(
        rename = "elastic_below",
        default,
        skip_serializing_if = "Option::is_none",
        with = "Number"
    )]
    _elastic_below: Option<Number>,
}

/// The paper's convention: after the elastic response, the whole velocity is
/// multiplied by 1 - C.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Paper {
    /// C, from 0, elastic, to 1, all energy lost.
    #[schemars(rename = "paper")]
    _paper: Number,
}
