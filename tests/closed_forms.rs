//! Scenes whose impacts can be derived by hand: each test says how, and the
//! exact timeline must give just that.

#[path = "closed_forms/chains.rs"]
mod chains;
#[path = "closed_forms/clusters.rs"]
mod clusters;
#[path = "closed_forms/discs.rs"]
mod discs;
#[path = "closed_forms/drag.rs"]
mod drag;
#[cfg(feature = "json")]
#[path = "closed_forms/figures.rs"]
mod figures;
#[path = "closed_forms/gravity.rs"]
mod gravity;
#[path = "closed_forms/grazes.rs"]
mod grazes;
#[path = "closed_forms/jams.rs"]
mod jams;
#[path = "closed_forms/losses.rs"]
mod losses;
#[path = "closed_forms/starts.rs"]
mod starts;
#[path = "closed_forms/walls.rs"]
mod walls;

#[path = "closed_forms/accumulations.rs"]
mod accumulations;
mod air;
