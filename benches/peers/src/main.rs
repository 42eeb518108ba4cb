//! carom's timeline beside other programs, on the same scenes and in one run.
//!
//! ```text
//! cargo run --release --manifest-path benches/peers/Cargo.toml -- [gases|frames]
//! ```
//!
//! First the event-driven ones: impacts a second in gases of equal discs in a box.
//! Then the frames of the paper's Table 1: milliseconds a frame. All are run in turn,
//! several rounds, so that what else the machine does hits all alike; each number is
//! the median, and behind it stands how it relates to carom's timeline in binary64.

mod with_carom;
mod with_collider;
mod with_rapier;

use carom::scene::Scene;
use carom::scene::generate::{gas, table1};

const ROUNDS: usize = 5;

/// The seed of all scenes.
const SEED: u64 = 42;

/// The gases: how many discs, what part of the box they cover, and how many impacts
/// the slow ones are given.
const GASES: [(u32, f64, u64); 8] = [
    (150, 0.2, 100_000),
    (150, 0.5, 100_000),
    (1_000, 0.2, 100_000),
    (1_000, 0.5, 100_000),
    (10_000, 0.2, 100_000),
    (10_000, 0.5, 100_000),
    (100_000, 0.2, 100_000),
    (100_000, 0.5, 100_000),
];

/// So many more impacts are given to what is fast.
const FAST: u64 = 10;

/// A program: its name, and what it makes of a scene.
type Program<'a> = (&'static str, Box<dyn Fn(&Scene) -> f64 + 'a>);

fn main() {
    match std::env::args().nth(1).as_deref() {
        None => {
            gases();
            frames();
        }
        Some("gases") => gases(),
        Some("frames") => frames(),
        Some(other) => panic!("neither gases nor frames: {other}"),
    }
}

fn gases() {
    println!("impacts a second; gas of equal discs in a box");
    for (count, packing, impacts) in GASES {
        let scene = gas(SEED, count, packing).expect("a valid scene");
        let programs: [Program; 3] = [
            (
                "carom f64",
                Box::new(|scene| with_carom::pace(scene, FAST * impacts)),
            ),
            (
                "carom filtered",
                Box::new(|scene| with_carom::filtered_pace(scene, FAST * impacts)),
            ),
            (
                "collider 0.3.1",
                Box::new(|scene| with_collider::pace(scene, impacts)),
            ),
        ];
        show(
            &format!("{count} discs, packing {packing}"),
            &scene,
            &programs,
        );
    }
}

fn frames() {
    println!("milliseconds a frame; Table 1");
    for scale in ["1", "1/3"] {
        let radius = scale.parse().expect("a number");
        let scene = table1(SEED, &radius).expect("a valid scene");
        let programs: [Program; 5] = [
            (
                "carom timeline f64",
                Box::new(with_carom::frame_of_timeline),
            ),
            (
                "carom timeline filtered",
                Box::new(with_carom::frame_of_filtered),
            ),
            (
                "carom single f64, all pairs",
                Box::new(with_carom::frame_of_single),
            ),
            (
                "rapier2d-f64 0.36",
                Box::new(|scene| with_rapier::frame(scene, false)),
            ),
            (
                "rapier2d-f64 0.36 with CCD",
                Box::new(|scene| with_rapier::frame(scene, true)),
            ),
        ];
        show(&format!("radius times {scale}"), &scene, &programs);
    }
}

/// Runs all programs in turn, and shows their medians.
fn show(title: &str, scene: &Scene, programs: &[Program]) {
    let mut results = vec![Vec::new(); programs.len()];
    for _ in 0..ROUNDS {
        for ((_, run), results) in programs.iter().zip(&mut results) {
            results.push(run(scene));
        }
    }
    let medians: Vec<f64> = results.into_iter().map(median).collect();
    println!("{title}");
    for ((name, _), median) in programs.iter().zip(&medians) {
        println!(
            "    {name:28} {:>12}   {:8.3}",
            rounded(*median),
            median / medians[0]
        );
    }
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

/// Four digits.
fn rounded(number: f64) -> String {
    let digits = (3.0 - number.abs().log10().floor()).max(0.0);
    format!("{number:.0$}", digits as usize)
}
