//! What must hold of the frame algorithms, weaknesses and all: of each frame,
//! and of scenes in which their weaknesses do not matter.

#[path = "frame_laws/agreement.rs"]
mod agreement;
#[path = "frame_laws/frames.rs"]
mod frames;

use carom::frame::Passes;
use carom::simulation::Algorithm;

/// Every algorithm that goes frame by frame.
const ALL: [Algorithm; 7] = [
    Algorithm::Retroactive { substeps: 1 },
    Algorithm::Retroactive { substeps: 7 },
    Algorithm::Single,
    Algorithm::Multiple(Passes::Count(2)),
    Algorithm::Multiple(Passes::Count(5)),
    Algorithm::Synchronised(Passes::Count(2)),
    Algorithm::Synchronised(Passes::Count(5)),
];
