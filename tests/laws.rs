//! Laws of mechanics that need no oracle: what is done to a scene must be done
//! to its run.

#[path = "laws/apart.rs"]
mod apart;
#[path = "laws/change.rs"]
mod change;
#[path = "laws/conservation.rs"]
mod conservation;
#[path = "laws/parts.rs"]
mod parts;
#[path = "laws/periodic.rs"]
mod periodic;
#[cfg(feature = "json")]
#[path = "laws/pile.rs"]
mod pile;
#[path = "laws/playback.rs"]
mod playback;
#[path = "laws/reversal.rs"]
mod reversal;
#[path = "laws/scaling.rs"]
mod scaling;
#[path = "laws/symmetry.rs"]
mod symmetry;
