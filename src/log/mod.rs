//! What a run leaves behind: its event log and its state, as JSON.
//!
//! An event log, `carom/events/1`, is a header, a line for each impact and a
//! summary. A [`Recorder`] writes it, [`Log`] reads it back. A [`State`],
//! `carom/state/1`, is where the discs are and how they move; [`end_scene`]
//! makes a scene of it, to go on from.
//!
//! Exact arithmetic says between which bounds each number is proven to lie:
//! decimals, rounded outwards. The binary64 number beside them is the one
//! nearest to the truth.
//!
//! ```
//! use std::ops::ControlFlow;
//!
//! use carom::log::{Log, Recorder};
//! use carom::run::{Options, run};
//! use carom::scalar::Exact;
//! use carom::scene::{Disc, Scene};
//! use carom::simulation::Algorithm;
//!
//! let scene = Scene::builder("head-on")
//!     .disc(Disc::at([0, 0], 1).velocity([2, 0]))
//!     .disc(Disc::at([3, 0], 1))
//!     .build()?;
//! let options = Options::default();
//! let go_on = &mut |_| ControlFlow::Continue(());
//! let outcome = run::<Exact>(&scene, Algorithm::Timeline, &options, go_on)?;
//!
//! let mut text = Vec::new();
//! Recorder::new(&scene, Algorithm::Timeline, &options, &outcome).write(&mut text)?;
//! let log = Log::read(text.as_slice())?;
//! assert_eq!(log.events[0].time, 0.5);
//! assert_eq!(log.events[0].lo.as_deref(), Some("0.5"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod contact;
mod decimal;
mod event;
mod names;
mod quantity;
mod read;
mod record;
mod resume;
#[cfg(feature = "cli")]
mod schema;
mod state;
mod verdict;

pub use contact::Contact;
pub use event::{Ending, Event, EventsFormat, Header, Summary};
pub use quantity::{Bounds, Quantity};
pub use read::{Log, LogError};
pub use record::Recorder;
pub use resume::end_scene;
#[cfg(feature = "cli")]
pub use schema::{events_schema, state_schema, verdict_schema};
pub use state::{DiscState, State, StateFormat};
pub use verdict::{FirstDifference, Judgement, LoggedImpact, TrueImpact, VerdictFormat};

/// The significant decimal digits of proven bounds, unless more are asked
/// for.
pub const MIN_DIGITS: u32 = 20;

/// The digits that a run must prove so that so many can be shown: bounds that are a
/// little apart may straddle the last one, and one more makes them close enough.
pub fn proven_digits(shown: u32) -> u32 {
    shown + 1
}
