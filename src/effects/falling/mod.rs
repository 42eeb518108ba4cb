//! Uniform gravity, in the timeline: discs of finite mass fall, through a
//! [`Medium`].
//!
//! In a [`Vacuum`] they move on parabolas. Two that fall move straight in relation
//! to each other, so they meet as they do without gravity. A wall's line is met at
//! a root of a quadratic; an end point, and a body of infinite mass, at one of a
//! quartic ([`Roots`](crate::roots)). Through [`Air`] the same gaps are linear and
//! quadratic functions of exponential ones ([`Fading`](crate::roots::Fading)).
//!
//! What has collided and parts may come back. Then it is known by construction
//! that the two touch where they start from: a zero at the start is left out.

mod air;
mod arc;
mod circle;
mod course;
mod filtered;
mod gap;
mod kernel;
mod medium;
mod number;
mod segment;
mod trajectory;
mod weight;

pub use air::{Air, Rate};
pub(crate) use course::{fall, sink};
pub use filtered::Instant;
pub use medium::{Drag, Marker, Medium, Vacuum};
pub use number::Falling;
pub use weight::{Holding, Weight};
