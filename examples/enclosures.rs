//! How many bits exact arithmetic loses an impact, how many the dynamics
//! themselves lose, and what that costs.
//!
//! ```text
//! cargo run --release --example enclosures [DISCS…]
//! ```
//!
//! For gases of 3, 10 and 30 discs, or of as many as the arguments say: a run
//! with fewer bits than a step as a whole takes, runs with more, and how far
//! two runs part whose starts differ by 2^-1024 in one coordinate. What an
//! enclosure loses is what the state at the end lacks of the bits it was
//! computed with.

mod dynamics;

use std::time::Instant;

use carom::scalar::Exact;
use carom::scene::generate;
use dynamics::{Failure, divergence, follow};

/// The impacts of a run.
const IMPACTS: u32 = 600;

/// The bits of a run: too few for steps, just enough, and more.
const BITS: [u32; 4] = [Exact::STEP_BITS - 1, Exact::STEP_BITS, 2048, 4096];

/// The exponent of the difference between two starts.
const NUDGE: u32 = 1024;

fn main() -> Result<(), Failure> {
    let counts: Result<Vec<u32>, _> = std::env::args().skip(1).map(|text| text.parse()).collect();
    let counts = match counts? {
        none if none.is_empty() => vec![3, 10, 30],
        counts => counts,
    };
    println!("discs   bits  impacts  us an impact  bits lost an impact");
    for discs in counts {
        let scene = generate::gas(42, discs, 0.3)?;
        for bits in BITS {
            let began = Instant::now();
            let outcome = follow::<Exact>(&scene, bits, IMPACTS)?;
            let micros = began.elapsed().as_secs_f64() * 1e6;
            let impacts = outcome.impacts.len() as f64;
            let lost = bits - outcome.certain_bits().unwrap_or(bits);
            let (cost, rate) = (micros / impacts, f64::from(lost) / impacts);
            println!("{discs:5} {bits:6} {impacts:8} {cost:13.1} {rate:20.3}");
        }
        let fine = follow(&scene, 2 * NUDGE, IMPACTS)?;
        let parting = divergence(&scene, &fine, NUDGE)?;
        println!("{discs:5} the dynamics {parting:38.3}");
    }
    Ok(())
}
