//! What adapters of engines have in common: carom's questions as lines of JSON, scenes in
//! binary64, and options.
//!
//! An engine is an [`Engine`]; its program calls [`serve`] with it.

mod options;
mod plain;
mod protocol;

pub use options::Options;
pub use plain::{Disc, Plain, Restitution, Steps, Wall};
pub use protocol::{Body, Engine, Impact, serve};
