//! Overlaps that rounding makes at impacts, and runs that are stopped there and
//! resumed.
#![no_main]

use carom::check::Effort;
use libfuzzer_sys::fuzz_target;

const EFFORT: Effort = Effort {
    impacts: 40,
    resumptions: 40,
    frames: 0,
    passes: 0,
};

fuzz_target!(|bytes: &[u8]| carom_fuzz::check_bytes(bytes, &EFFORT));
