//! Impacts that are none, missed or out of order, in binary64: scenes near
//! tangency and near ties.
#![no_main]

use carom::check::Effort;
use libfuzzer_sys::fuzz_target;

const EFFORT: Effort = Effort {
    impacts: 60,
    resumptions: 0,
    frames: 3,
    passes: 3,
};

fuzz_target!(|bytes: &[u8]| carom_fuzz::check_bytes(bytes, &EFFORT));
