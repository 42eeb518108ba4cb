//! Every tolerance of the tests, with its reason. What is rational is held to
//! equality and has none.

/// How far a computed binary64 time or coordinate may be from the true one in
/// a short run of a small generic scene: each impact of the chain may multiply
/// the rounding errors of some 1e-15 by about ten, and there are about five in
/// a row.
pub(crate) const SHORT_RUN: f64 = 1e-9;

/// How far binary64 may be from momentum and energy conserved, relative to
/// their size: some ten roundings an impact, a hundred impacts.
pub(crate) const CONSERVATION: f64 = 1e-13;

/// How wide an enclosure may be that is asked to agree with another: a run is
/// only decided once it has 20 digits of each time. One fewer leaves room for
/// what is computed from the times.
pub(crate) const ENCLOSURE: f64 = 1e-19;

/// How far from its start a run may return, whose turning point was rounded
/// to [`TURNING_BITS`]: that rounding, some 1e-60, and ten more for each
/// impact of the way back.
pub(crate) const RETURN: f64 = 1e-30;

/// The bits after the binary point that are kept of a turning point: few
/// enough that the way back is computed quickly.
pub(crate) const TURNING_BITS: u32 = 200;

/// How far a binary64 time or velocity may be from the true one after a few
/// impacts of discs of moderate size, relative to it or to 1.
pub(crate) const FEW_IMPACTS: f64 = 1e-12;
