//! What acts on bodies besides impacts.
//!
//! An effect that a scene does not name is not simulated. In the timeline it is
//! chosen by type: a scene without gravity runs code in which there is no
//! gravity. The frame algorithms know [`Forces`] alone, at the start of a frame.

mod course;
mod drag;
mod falling;
mod forces;

pub use course::{Course, Fall, course};
pub(crate) use drag::{BINARY64, EXACT, FILTERED};
pub use drag::{Dragged, Warp};
pub(crate) use falling::fall;
pub use falling::{Drag, Falling, Holding, Instant, Marker, Medium, Vacuum, Weight};
pub use forces::Forces;
