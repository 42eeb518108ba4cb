//! Families of hard cases: scenes over a range of some parameter, mostly a
//! power of two or of ten, up to far beyond what binary64 tells apart.
//!
//! The verdict expected of each member is derived by hand, and the comment
//! says how. All arithmetics are held to it, and where binary64 cannot be
//! right the test says what it says instead, and from where on.

#[path = "families/contacts.rs"]
mod contacts;
#[path = "families/corners.rs"]
mod corners;
#[path = "families/grazes.rs"]
mod grazes;
#[path = "families/heading.rs"]
mod heading;
#[path = "families/masses.rs"]
mod masses;
#[path = "families/scales.rs"]
mod scales;
#[path = "families/ties.rs"]
mod ties;
#[path = "families/verdict.rs"]
mod verdict;
