//! Scenes as JSON, `carom/scene/1`.
//!
//! A bare JSON number is the binary64 nearest to its text, a JSON string an
//! exact number: `0.1` and `"0.1"` are different numbers. Writing and reading
//! back gives the same scene, to the last bit.

mod fault;
mod file;
mod layout;
pub(super) mod linear;
mod number;
pub(super) mod object;
pub(super) mod restitution;

use serde::de::{Deserialize, Deserializer};

use super::{Cell, Disc, Effects, Frame, Scene, SceneError, Wall, validate};

/// The name of a scene that has none.
const NAMELESS: &str = "scene";

/// Discs and walls in the plane, and how they move.
///
/// A bare JSON number is the binary64 nearest to its text, a JSON string is
/// exact.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "cli", schemars(rename = "Scene"))]
pub(super) struct Parts {
    /// The format's name and version.
    schema: Format,
    /// The scene's name; that of the file if absent.
    #[serde(
        default,
        deserialize_with = "present",
        skip_serializing_if = "Option::is_none"
    )]
    #[cfg_attr(feature = "cli", schemars(with = "String"))]
    id: Option<String>,
    /// What there is to know about the scene.
    #[serde(
        default,
        deserialize_with = "present",
        skip_serializing_if = "Option::is_none"
    )]
    #[cfg_attr(feature = "cli", schemars(with = "String"))]
    notes: Option<String>,
    /// The discs, `d0` first.
    #[serde(deserialize_with = "object::many")]
    discs: Vec<Disc>,
    /// The walls, `w0` first; none if absent.
    #[serde(
        default,
        deserialize_with = "object::many",
        skip_serializing_if = "Vec::is_empty"
    )]
    walls: Vec<Wall>,
    /// The cell that repeats, instead of walls.
    #[serde(
        default,
        deserialize_with = "object::optional",
        skip_serializing_if = "Option::is_none"
    )]
    #[cfg_attr(feature = "cli", schemars(with = "Cell"))]
    periodic: Option<Cell>,
    /// The frames that are simulated; one of duration 1 if absent.
    #[serde(default, deserialize_with = "object::one")]
    frame: Frame,
    /// What acts on the discs besides free motion; nothing if absent.
    #[serde(
        default,
        deserialize_with = "object::one",
        skip_serializing_if = "is_default"
    )]
    effects: Effects,
}

#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "cli", schemars(inline))]
enum Format {
    #[serde(rename = "carom/scene/1")]
    Scene1,
}

impl Scene {
    /// Reads a scene from its JSON text.
    ///
    /// ```
    /// use carom::scene::Scene;
    ///
    /// let text = r#"{
    ///   "schema": "carom/scene/1",
    ///   "discs": [{"position": [0, "1/3"], "radius": 0}]
    /// }"#;
    /// let error = Scene::from_json(text).unwrap_err();
    /// assert_eq!(
    ///     error.to_string(),
    ///     "discs[0].radius: expected a positive number, found 0"
    /// );
    /// ```
    pub fn from_json(text: &str) -> Result<Self, SceneError> {
        Parts::parse(text)?.try_into()
    }

    /// The scene as JSON text, a disc or a wall a line.
    ///
    /// ```
    /// use carom::scene::{Disc, Scene};
    ///
    /// let scene = Scene::builder("one").disc(Disc::at([0, 1], 1)).build()?;
    /// assert_eq!(Scene::from_json(&scene.to_json())?, scene);
    /// # Ok::<(), carom::scene::SceneError>(())
    /// ```
    pub fn to_json(&self) -> String {
        layout::line_an_item(&Parts::from(self.clone()))
    }
}

impl Parts {
    fn parse(text: &str) -> Result<Self, SceneError> {
        if text.trim().is_empty() {
            return Err(fault::empty());
        }
        let mut json = serde_json::Deserializer::from_str(text);
        let mut track = serde_path_to_error::Track::new();
        let tracked = serde_path_to_error::Deserializer::new(&mut json, &mut track);
        let parts = match object::one(tracked) {
            Ok(parts) => parts,
            Err(error) => return Err(fault::at_path(&track.path(), &error)),
        };
        json.end().map_err(|error| fault::syntax(&error))?;
        Ok(parts)
    }
}

impl TryFrom<Parts> for Scene {
    type Error = SceneError;

    fn try_from(parts: Parts) -> Result<Self, SceneError> {
        validate::validated(Self {
            id: parts.id.unwrap_or_else(|| NAMELESS.to_owned()),
            notes: parts.notes,
            discs: parts.discs,
            walls: parts.walls,
            periodic: parts.periodic,
            frame: parts.frame,
            effects: parts.effects,
        })
    }
}

impl From<Scene> for Parts {
    fn from(scene: Scene) -> Self {
        Self {
            schema: Format::Scene1,
            id: Some(scene.id),
            notes: scene.notes,
            discs: scene.discs,
            walls: scene.walls,
            periodic: scene.periodic,
            frame: scene.frame,
            effects: scene.effects,
        }
    }
}

/// Reads the value of an optional key. A `null` is not the absence of a key.
pub(super) fn present<'de, T, D>(deserializer: D) -> Result<Option<T>, D::Error>
where
    T: Deserialize<'de>,
    D: Deserializer<'de>,
{
    T::deserialize(deserializer).map(Some)
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}
