//! What acts on bodies besides impacts.
//!
//! An effect that a scene does not name is not simulated. In the timeline it is
//! chosen by type: a scene without gravity runs code in which there is no
//! gravity. The frame algorithms know [`Forces`] alone, at the start of a frame.

mod course;
mod drag;
mod falling;
mod forces;

pub(crate) use course::is_air;
pub use course::{Course, Fall, Sink, course};
pub use drag::Dragged;
pub use falling::{Air, Drag, Falling, Holding, Instant, Marker, Medium, Rate, Vacuum, Weight};
pub(crate) use falling::{fall, sink};
pub use forces::Forces;
