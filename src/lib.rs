//! What truly happens when discs and walls collide: every impact, in its
//! proven order.
//!
//! A [`Scene`](scene::Scene) is run by one [`Algorithm`](simulation::Algorithm)
//! in one [`Arithmetic`](arithmetic::Arithmetic): [`run::run`] gives the
//! impacts and the end. The algorithms are those of a paper, which step
//! through frames and get some impacts wrong, and the [`timeline`], which takes
//! every impact in order. All of them are the same generic code for binary64
//! and for [`Exact`](scalar::Exact) numbers; [`judge`] tells how far a run is
//! from the truth, which is the exact timeline.
//!
//! Where to start reading: [`detect`] and [`respond`] for the physics,
//! [`frame`] for the paper's algorithms, [`paper`] for its claims one by one.

pub mod algebra;
pub mod arithmetic;
pub mod body;
pub mod broad_phase;
pub mod check;
mod conserved;
pub mod contacts;
pub mod detect;
pub mod effects;
pub mod filtered;
pub mod first_impact;
pub mod frame;
pub mod impact;
pub mod judge;
pub mod kernel;
#[cfg(feature = "json")]
pub mod log;
pub mod paper;
pub mod playback;
pub mod respond;
pub mod roots;
pub mod run;
pub mod scalar;
pub mod scene;
pub mod simulation;
pub mod support;
pub mod symmetry;
pub mod timeline;
pub mod vec2;
pub mod world;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
