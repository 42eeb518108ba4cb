//! How far a run is from the truth, and what it costs (P1.4).
//!
//! Two questions are told apart. *Frame by frame*: starting each frame from
//! the candidate's own state, taken exactly, what does the exact timeline say
//! of that frame? One early error thus does not condemn all that follows.
//! *Globally*: where does the candidate leave the true course of events for
//! the first time?
//!
//! The error of a frame algorithm that rounds has two parts ([`Split`]): what it
//! would get wrong in exact arithmetic, too, and what only rounding does.

mod difference;
mod frames;
mod matching;
mod overlaps;
mod tally;
mod truth;
mod verdict;

pub use difference::{Difference, first_difference};
pub use frames::{Judged, Split, judge, judge_and_split};
pub use matching::{Fault, FrameComparison, compare_frame};
pub use tally::{Logged, Tally};
pub use truth::{Truth, true_frame};
pub use verdict::{Decision, Margin, Reference, Standing, Verdict};
