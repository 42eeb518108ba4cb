//! Where the discs are, and how they move.

use super::quantity::Quantity;
use crate::arithmetic::Arithmetic;
use crate::body::Disc;
use crate::run::Outcome;
use crate::scene::Scene;
use crate::vec2::Vec2;

/// The discs of a scene at a time.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct State {
    /// The format's name and version.
    pub schema: StateFormat,
    /// The scene's name.
    pub scene: String,
    /// The time.
    pub time: Quantity,
    /// The discs, `d0` first.
    pub discs: Vec<DiscState>,
}

/// The name and version of the format of states.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "cli", schemars(inline))]
pub enum StateFormat {
    /// The first version.
    #[serde(rename = "carom/state/1")]
    State1,
}

/// A disc at a time.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub struct DiscState {
    /// The centre.
    pub position: [Quantity; 2],
    /// The velocity.
    pub velocity: [Quantity; 2],
}

impl State {
    /// The state in which a run ended, with so many digits of proven bounds.
    pub fn at_end<S: Arithmetic>(scene: &Scene, outcome: &Outcome<S>, digits: u32) -> Self {
        let discs = outcome.end.iter();
        Self {
            schema: StateFormat::State1,
            scene: scene.id().to_owned(),
            time: Quantity::new(&outcome.time, digits),
            discs: discs.map(|disc| DiscState::new(disc, digits)).collect(),
        }
    }

    /// The state as a line of JSON text.
    pub fn to_json(&self) -> String {
        let json = serde_json::to_string(self);
        json.expect("all keys are strings") + "\n"
    }

    /// Reads a state from its JSON text.
    ///
    /// # Errors
    ///
    /// The text is no state.
    pub fn from_json(text: &str) -> Result<Self, serde_json::Error> {
        serde_json::from_str(text)
    }
}

impl DiscState {
    fn new<S: Arithmetic>(disc: &Disc<S>, digits: u32) -> Self {
        let vector = |vector: &Vec2<S>| -> [Quantity; 2] {
            [&vector.x, &vector.y].map(|number| Quantity::new(number, digits))
        };
        Self {
            position: vector(&disc.position),
            velocity: vector(&disc.velocity),
        }
    }
}
