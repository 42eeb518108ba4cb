//! What is to be simulated: discs, walls, frames and effects, as written.
//!
//! A [`Scene`] keeps every number exactly as it was written, and is valid by
//! construction: whatever is wrong with an input is found once, by
//! [`SceneBuilder::build`], in exact comparisons. What runs a scene need not
//! check it again.
//!
//! ```
//! use carom::scene::{Disc, Scene};
//!
//! let scene = Scene::builder("head-on")
//!     .disc(Disc::at([0, 0], 1).velocity([1, 0]))
//!     .disc(Disc::at(["31/3", "0"], 1).mass("0.1"))
//!     .wall([20, -5], [20, 5])
//!     .frame("1/60", 600)
//!     .build()?;
//! assert_eq!(scene.discs().len(), 2);
//! # Ok::<(), carom::scene::SceneError>(())
//! ```

mod builder;
mod disc;
mod effects;
mod error;
mod frame;
#[cfg(feature = "cli")]
pub mod generate;
mod glam;
mod input;
#[cfg(feature = "json")]
mod json;
#[cfg(feature = "cli")]
mod schema;
mod validate;
mod wall;

pub use self::glam::to_dvec2;
pub use builder::SceneBuilder;
pub use disc::{Disc, DiscBuilder, Mass};
pub use effects::{Effects, Restitution};
pub use error::{SceneError, SceneErrorKind};
pub use frame::Frame;
pub use input::{IntoNumber, IntoPoint};
#[cfg(feature = "cli")]
pub use schema::scene_schema;
pub use wall::{Cell, Wall};

/// A valid scene.
///
/// With the feature `json`, scenes are read by `from_json` and `read`, and
/// written by `to_json`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "json",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "json::Parts", into = "json::Parts")
)]
pub struct Scene {
    id: String,
    notes: Option<String>,
    discs: Vec<Disc>,
    walls: Vec<Wall>,
    periodic: Option<Cell>,
    frame: Frame,
    effects: Effects,
}

impl Scene {
    /// An empty scene of that name, to be filled.
    pub fn builder(id: impl Into<String>) -> SceneBuilder {
        SceneBuilder::new(id.into())
    }

    /// A builder that holds all of this scene, for a scene that differs a
    /// little.
    pub fn to_builder(&self) -> SceneBuilder {
        SceneBuilder::from(self.clone())
    }

    /// The scene's name.
    pub fn id(&self) -> &str {
        &self.id
    }

    /// What the author has to say about the scene.
    pub fn notes(&self) -> Option<&str> {
        self.notes.as_deref()
    }

    /// The discs, `d0` first.
    pub fn discs(&self) -> &[Disc] {
        &self.discs
    }

    /// The walls, `w0` first.
    pub fn walls(&self) -> &[Wall] {
        &self.walls
    }

    /// The cell that repeats, if the scene is periodic; it then has no walls.
    pub fn periodic(&self) -> Option<&Cell> {
        self.periodic.as_ref()
    }

    /// The frames that are simulated.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// What acts on the discs besides free motion.
    pub fn effects(&self) -> &Effects {
        &self.effects
    }
}
