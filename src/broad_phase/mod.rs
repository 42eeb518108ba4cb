//! Which bodies are near to each other: their areas overlap.
//!
//! What a body may touch within some time lies within an *area*, a box with sides
//! along the axes. Bodies whose areas have no point in common do not meet. An
//! `Index` finds, for each body, those whose areas overlap its own: precisely
//! those, whichever way it divides the plane. For a point of two areas is in some
//! part of the plane, in which both are entered.
//!
//! It knows nothing of discs and walls: whose areas these are, and that they
//! are large enough, is up to those who enter them.

mod area;
mod bsp;
mod grid;
mod index;
mod lists;
#[cfg(test)]
mod tests;

pub(crate) use area::Area;
pub(crate) use grid::cell;
pub(crate) use index::Index;

/// How bodies that are near to each other are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BroadPhase {
    /// Every pair is looked at.
    AllPairs,
    /// In the cells of a grid.
    #[default]
    Grid,
    /// In the parts of a binary space partition (P6.2).
    Bsp,
}
