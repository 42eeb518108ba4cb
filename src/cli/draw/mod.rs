//! Pictures of motion, in the manner of the paper: bodies in colour where they start,
//! orange circles where they collide, orange arrows for how they go on, and in grey the
//! rest of their way.

mod picture;
mod story;
mod view;

pub(super) use picture::{Panel, picture};
pub(super) use story::Story;
