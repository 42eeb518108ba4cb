//! How fast the timeline of a scene runs in numbers that round, and how much memory it
//! takes.
//!
//! ```text
//! cargo run --release --example speed -- [SCENE] [DISCS] [PACKING] [IMPACTS] [ARITHMETIC]
//! ```
//!
//! Scenes: `alike` discs in a box; discs of `mixed` radii, 1 to 64, each size with
//! about the same area; some `huge` ones, 40 times as large as the others; discs
//! alike among as many `pegs`, which are short walls; discs alike in a `round` of
//! as many short walls. PACKING is that of the first. The ARITHMETIC is `f64` or
//! `filtered`.

use std::convert::Infallible;
use std::f64::consts::TAU;
use std::time::Instant;

use carom::arithmetic::Arithmetic;
use carom::scalar::Filtered;
use carom::scene::generate::gas;
use carom::scene::{Disc, DiscBuilder, Scene, SceneBuilder};
use carom::timeline::Timeline;
use carom::world::World;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The radius of a disc in a cell of size 1: packing 0.5.
const RADIUS: f64 = 0.4;

/// Radii differ by powers of two, up to this.
const SIZES: u32 = 6;

fn main() {
    let argument = |place| std::env::args().nth(place);
    let number = |place, default: f64| {
        argument(place).map_or(default, |text| text.parse().expect("a number"))
    };
    let kind = argument(1).unwrap_or("alike".into());
    let (discs, packing) = (number(2, 1000.0) as u32, number(3, 0.5));
    let impacts = number(4, 1e6) as u64;
    let scene = match kind.as_str() {
        "alike" => gas(42, discs, packing),
        "mixed" => mixed(discs).build(),
        "huge" => huge(discs).build(),
        "pegs" => pegs(discs).build(),
        "round" => round(discs).build(),
        _ => panic!("no such scene: {kind}"),
    };
    let scene = scene.expect("a valid scene");
    let title = format!("{kind} {packing}");
    match argument(5).as_deref() {
        None | Some("f64") => measure(&title, scene, &f64::MAX, impacts),
        Some("filtered") => measure(&title, scene, &Filtered::new(1e9), impacts),
        Some(other) => panic!("no such arithmetic: {other}"),
    }
}

/// Runs so many impacts of a scene, up to an end that has to be later than these.
fn measure<S>(title: &str, scene: Scene, end: &S, impacts: u64)
where
    S: Arithmetic<Precision = (), Doubt = Infallible>,
{
    let world = World::<S>::new(&scene, ());
    let (discs, walls) = (world.discs.len(), world.walls.len());
    // Kept, so that its memory is not used again.
    std::mem::forget(scene);
    let before = resident();
    let begun = Instant::now();
    let Ok(mut timeline) = Timeline::new(world.clone(), end);
    let started = begun.elapsed().as_secs_f64();
    let begun = Instant::now();
    for _ in 0..impacts {
        let Ok(impact) = timeline.next_impact(end);
        assert!(impact.is_some(), "no more impacts");
    }
    println!(
        "{title}: {discs} discs, {walls} walls: {:.0} impacts/s, begun in {started:.2} s, {:.0} bytes a disc",
        impacts as f64 / begun.elapsed().as_secs_f64(),
        (resident() - before) / discs as f64,
    );
}

/// The memory that is in use, where the system tells.
fn resident() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
    1024.0 * kilobytes.unwrap_or(f64::NAN)
}

/// Makes discs of equal density and energy on the average.
struct Maker {
    random: ChaCha8Rng,
    discs: Vec<DiscBuilder>,
}

impl Maker {
    fn new() -> Self {
        Self {
            random: ChaCha8Rng::seed_from_u64(42),
            discs: Vec::new(),
        }
    }

    /// Adds a disc in the middle of a square cell.
    fn add(&mut self, [x, y]: [f64; 2], size: f64) {
        let mut speed = || self.random.random_range(-1.0..1.0) / size;
        let disc = Disc::at([x + size / 2.0, y + size / 2.0], RADIUS * size)
            .velocity([speed(), speed()])
            .mass(size * size);
        self.discs.push(disc);
    }

    /// Fills a cell with discs of all sizes: one in a quarter of it, and so on in
    /// the others.
    fn fill(&mut self, [x, y]: [f64; 2], size: f64) {
        let half = size / 2.0;
        let quarters = [[x, y], [x + half, y], [x, y + half], [x + half, y + half]];
        for (place, quarter) in quarters.into_iter().enumerate() {
            if half <= 1.0 || place == 0 {
                self.add(quarter, half);
            } else {
                self.fill(quarter, half);
            }
        }
    }
}

/// The corners of so many cells of a size, in a square.
fn cells(count: f64, size: f64) -> (f64, impl Iterator<Item = [f64; 2]>) {
    let rows = count.sqrt().ceil().max(1.0) as u32;
    let corners = (0..rows).flat_map(move |row| (0..rows).map(move |column| [column, row]));
    let corners = corners.map(move |cell| cell.map(|index| f64::from(index) * size));
    (f64::from(rows) * size, corners)
}

fn boxed(side: f64, discs: Vec<DiscBuilder>) -> SceneBuilder {
    let scene = Scene::builder("speed").frame(1, 1).discs(discs);
    scene.walls_around([0.0, 0.0], [side, side])
}

fn mixed(discs: u32) -> SceneBuilder {
    let size = f64::from(1 << (SIZES + 1));
    // So many discs fill a cell of that size.
    let in_cell = (3_f64.powi(SIZES as i32 + 1) - 1.0) / 2.0 + 3_f64.powi(SIZES as i32 + 1);
    let (side, corners) = cells(f64::from(discs) / in_cell, size);
    let mut maker = Maker::new();
    corners.for_each(|corner| maker.fill(corner, size));
    boxed(side, maker.discs)
}

fn huge(discs: u32) -> SceneBuilder {
    const SIZE: f64 = 40.0;
    let (side, corners) = cells(f64::from(discs) / (SIZE * SIZE), SIZE);
    let mut maker = Maker::new();
    for (place, [x, y]) in corners.enumerate() {
        if place % 4 == 0 {
            maker.add([x, y], SIZE);
        } else {
            for [dx, dy] in cells(SIZE * SIZE, 1.0).1 {
                maker.add([x + dx, y + dy], 1.0);
            }
        }
    }
    boxed(side, maker.discs)
}

fn pegs(discs: u32) -> SceneBuilder {
    let (side, corners) = cells(f64::from(discs), 1.0);
    let mut maker = Maker::new();
    let corners: Vec<_> = corners.collect();
    corners.iter().for_each(|corner| maker.add(*corner, 1.0));
    let scene = boxed(side, maker.discs);
    // Halfway between four discs.
    corners.into_iter().fold(scene, |scene, [x, y]| {
        scene.wall([x + 0.95, y + 0.99], [x + 1.05, y + 1.01])
    })
}

fn round(discs: u32) -> SceneBuilder {
    let (side, corners) = cells(f64::from(discs), 1.0);
    let mut maker = Maker::new();
    corners.for_each(|corner| maker.add(corner, 1.0));
    let (middle, radius) = (side / 2.0, side * 0.72);
    let corner = |index: u32| {
        let (sine, cosine) = (TAU * f64::from(index % discs) / f64::from(discs)).sin_cos();
        [middle + radius * cosine, middle + radius * sine]
    };
    let scene = Scene::builder("speed").frame(1, 1).discs(maker.discs);
    (0..discs).fold(scene, |scene, index| {
        scene.wall(corner(index), corner(index + 1))
    })
}
