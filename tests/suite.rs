//! All tests of the library from outside, in one program: it is compiled once,
//! with the simulation in all arithmetics.

mod common;

mod algebra;
mod broad_phase;
mod brute_force;
mod check;
mod closed_forms;
mod enclosures;
mod error_bounds;
mod families;
mod filtered;
mod first_impact;
mod frame_laws;
mod gravity_laws;
mod hard_cases;
mod independent;
mod laws;
mod paper;
mod regressions;
mod scene;
mod shadowing;
mod symmetric;
mod verdict;
