//! What acts on bodies besides impacts.
//!
//! An effect that a scene does not name is not simulated. In the timeline it is
//! chosen by type: a scene without gravity runs code in which there is no
//! gravity. The frame algorithms know [`Forces`] alone, at the start of a frame.

mod forces;

pub use forces::Forces;
