//! What a check can find.

use std::fmt;

use crate::body::Pair;

/// A difference from the truth that rounding does not explain.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What is wrong.
    pub kind: Kind,
    /// In which run.
    pub run: Run,
    /// The name of the arithmetic.
    pub arithmetic: &'static str,
    /// The number of the impact at which it shows: in a frame, of the frame's.
    pub impact: usize,
    /// The bodies that it is about.
    pub pair: Option<Pair>,
    /// When it shows.
    pub time: f64,
    /// How many times the margin it is off.
    pub beyond: f64,
}

/// What is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// Bodies collide that do not touch, or do not approach.
    Spurious,
    /// Bodies collide, but not at that time.
    Mistimed,
    /// Bodies get into each other, and do not collide.
    Missed,
    /// Bodies get into each other, and collide only after what comes later.
    Misordered,
    /// Bodies overlap more than their impacts' roundings add up to.
    Overlap,
    /// A frame moves bodies that overlap by more than it takes.
    Displaced,
    /// An impact gains energy, or an elastic one loses some.
    Energy,
    /// A second run differs.
    Nondeterminism,
    /// A number has become infinite, or none.
    NotFinite,
    /// The program has panicked, with this message.
    Panic(String),
}

impl Kind {
    /// Whether two findings are of the same kind, whatever the message.
    pub fn is_like(&self, other: &Self) -> bool {
        std::mem::discriminant(self) == std::mem::discriminant(other)
    }
}

/// A run that is checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Run {
    /// The timeline of the scene.
    Timeline,
    /// The same stopped at an impact, and resumed from the state there.
    Resumed {
        /// The number of the impact.
        after: usize,
    },
    /// The multiple collision algorithm in a frame.
    Frame {
        /// The number of the frame, from zero on.
        frame: u64,
        /// The number of the pass, from one on.
        pass: u32,
    },
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.run, self.kind)?;
        if let Some(pair) = self.pair {
            write!(f, ": {pair}")?;
        }
        write!(f, ", impact {} at {}", self.impact, self.time)?;
        if self.beyond.is_finite() && self.beyond > 0.0 {
            write!(f, ", {:.3} times the margin", self.beyond)?;
        }
        write!(f, " ({})", self.arithmetic)
    }
}

impl std::error::Error for Finding {}

impl fmt::Display for Run {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Timeline => f.write_str("timeline"),
            Self::Resumed { after } => write!(f, "timeline resumed after impact {after}"),
            Self::Frame { frame, pass } => write!(f, "multiple, frame {frame}, pass {pass}"),
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Spurious => "spurious impact",
            Self::Mistimed => "impact at the wrong time",
            Self::Missed => "missed impact",
            Self::Misordered => "misordered impact",
            Self::Overlap => "overlap beyond rounding",
            Self::Displaced => "moved apart by more than the overlap",
            Self::Energy => "energy not kept",
            Self::Nondeterminism => "a second run differs",
            Self::NotFinite => "a number is not finite",
            Self::Panic(message) => return write!(f, "panic: {message}"),
        })
    }
}
