//! What truly happens when discs and walls collide: every impact, in its
//! proven order.

pub mod arithmetic;
pub mod body;
pub mod contacts;
pub mod detect;
pub mod frame;
pub mod impact;
pub mod judge;
#[cfg(feature = "json")]
pub mod log;
pub mod respond;
pub mod run;
pub mod scalar;
pub mod scene;
pub mod simulation;
pub mod support;
pub mod timeline;
pub mod vec2;
pub mod world;
