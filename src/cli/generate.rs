//! `carom generate`: scenes that are made rather than written.

use std::path::PathBuf;

use carom::scalar::{Number, NumberError};
use carom::scene::generate::{
    Family, MAX_POWER, MAX_ROWS, Rack, break_shot, corner, cradle, galperin, gas, mirror,
    periodic_gas, ring, scene_of, table1, transformed,
};
use carom::scene::{Scene, SceneError};
use clap::Subcommand;

use super::error::Error;
use super::exit::Exit;
use super::output::Output;

/// Generate a scene.
///
/// The same parameters and seed give the same scene, on every platform.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  carom generate gas --count 500 --seed 7 --output gas.json\n  \
                  carom generate ring --count 8 --rotate 3/5,4/5 --shift 10/3"
)]
pub(super) struct Arguments {
    #[command(subcommand)]
    kind: Kind,
    /// Where the scene goes; - is standard output.
    #[arg(long, global = true, value_name = "FILE", default_value = "-")]
    output: PathBuf,
    /// A rational point of the unit circle, such as 3/5,4/5: turns the scene
    /// about the origin by its angle, exactly.
    #[arg(
        long,
        global = true,
        value_name = "X,Y",
        value_parser = point,
        allow_hyphen_values = true
    )]
    rotate: Option<Point>,
    /// Shifts the scene by exact numbers, after --rotate; Y is 0 if absent.
    #[arg(
        long,
        global = true,
        value_name = "X[,Y]",
        value_parser = shift,
        allow_hyphen_values = true
    )]
    shift: Option<Point>,
}

impl Arguments {
    fn scene(&self) -> Result<Scene, SceneError> {
        let scene = self.kind.scene()?;
        if self.rotate.is_none() && self.shift.is_none() {
            return Ok(scene);
        }
        let or =
            |point: &Option<Point>, [x, y]: [i32; 2]| point.clone().unwrap_or([x.into(), y.into()]);
        transformed(&scene, &or(&self.rotate, [1, 0]), &or(&self.shift, [0, 0]))
    }
}

/// Two exact numbers, as `X,Y`.
type Point = [Number; 2];

fn point(text: &str) -> Result<Point, String> {
    let (x, y) = text
        .split_once(',')
        .ok_or("expected two numbers with a comma between them")?;
    Ok([number(x)?, number(y)?])
}

fn shift(text: &str) -> Result<Point, String> {
    match text.contains(',') {
        true => point(text),
        false => Ok([number(text)?, Number::from(0)]),
    }
}

fn number(text: &str) -> Result<Number, String> {
    text.parse().map_err(|error: NumberError| error.to_string())
}

#[derive(Debug, Subcommand)]
enum Kind {
    /// The experiment behind the paper's Table 1: 150 discs in a box.
    #[command(after_help = "Example:\n  carom generate table1 --scale 0.33")]
    Table1 {
        /// The seed of the random velocities.
        #[arg(long, default_value_t = 42)]
        seed: u64,
        /// The size of the discs, an exact number: their radius is 15 times
        /// that.
        #[arg(long, default_value = "1")]
        scale: Number,
    },
    /// A gas of equal discs in a square box, or in a square that repeats.
    #[command(
        after_help = "Examples:\n  carom generate gas --count 500 --packing 0.5\n  \
                            carom generate gas --periodic"
    )]
    Gas {
        /// The seed of the random positions and velocities.
        #[arg(long, default_value_t = 42)]
        seed: u64,
        /// The number of discs.
        #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u32).range(..=1_000_000))]
        count: u32,
        /// The part of the box that the discs cover.
        #[arg(long, default_value_t = 0.3)]
        packing: f64,
        /// Instead of walls, let the square repeat.
        #[arg(long)]
        periodic: bool,
    },
    /// Two discs and a wall, whose impacts count the digits of π.
    #[command(after_help = "Example:\n  carom generate galperin --power 3")]
    Galperin {
        #[arg(
            long,
            default_value_t = 2,
            help = format!("The heavier disc has 100^POWER times the mass; at most {MAX_POWER}")
        )]
        power: u32,
    },
    /// Newton's cradle, laid flat.
    #[command(after_help = "Example:\n  carom generate cradle --count 5 --moving 2 --gap 1/1000")]
    Cradle {
        /// The number of discs.
        #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u32).range(..=1_000_000))]
        count: u32,
        /// How many of them come in.
        #[arg(long, default_value_t = 1)]
        moving: u32,
        /// The distance between neighbours, an exact number.
        #[arg(long, default_value = "0")]
        gap: Number,
    },
    /// A cue disc into a triangle of discs: its own mirror image.
    #[command(after_help = "Example:\n  carom generate break --rows 5 --gap 0")]
    Break {
        #[arg(long, default_value_t = 5, help = format!("The number of rows; at most {MAX_ROWS}"))]
        rows: u32,
        /// The distance between neighbours in a row, an exact number; those of
        /// different rows are a little farther apart.
        #[arg(long, default_value = "1/10")]
        gap: Number,
        /// Let neighbours of different rows touch, at the angle of the
        /// triangle 3-4-5; those in a row are 2/5 apart.
        #[arg(long, conflicts_with = "gap")]
        touching: bool,
    },
    /// Discs on a ring that all move to its centre, with the symmetries of
    /// the square.
    #[command(after_help = "Example:\n  carom generate ring --count 16 --shift 10/3")]
    Ring {
        /// The number of discs, a multiple of 4.
        #[arg(long, default_value_t = 8, value_parser = clap::value_parser!(u32).range(..=1_000_000))]
        count: u32,
    },
    /// A gas and its mirror image, in one box.
    #[command(after_help = "Example:\n  carom generate mirror --count 20 --seed 7")]
    Mirror {
        /// The seed of the random positions and velocities.
        #[arg(long, default_value_t = 42)]
        seed: u64,
        /// The number of discs on each side.
        #[arg(long, default_value_t = 50, value_parser = clap::value_parser!(u32).range(..=1_000_000))]
        count: u32,
        /// The part of the box that the discs cover.
        #[arg(long, default_value_t = 0.3)]
        packing: f64,
    },
    /// A disc into a corner between two walls, which it touches at once.
    #[command(after_help = "Example:\n  carom generate corner --wedge 3/5,4/5")]
    Corner {
        /// Where the second wall goes: a rational point of the unit circle,
        /// above the x axis, along which the first one goes.
        #[arg(
            long,
            value_name = "X,Y",
            value_parser = point,
            allow_hyphen_values = true,
            default_value = "0,1"
        )]
        wedge: Point,
    },
    /// A small scene of one kind of difficulty.
    #[command(after_help = "Example:\n  carom generate family near-graze --index 3")]
    Family {
        #[arg(help = format!("One of {}", Family::ALL.map(Family::name).join(", ")))]
        name: Family,
        /// The seed of all scenes.
        #[arg(long, default_value_t = 42)]
        seed: u64,
        /// The number of the scene, from 0 on.
        #[arg(long, default_value_t = 0)]
        index: u64,
    },
}

impl Kind {
    fn scene(&self) -> Result<Scene, SceneError> {
        match self {
            Self::Table1 { seed, scale } => table1(*seed, scale),
            Self::Gas {
                seed,
                count,
                packing,
                periodic,
            } => {
                let generate = if *periodic { periodic_gas } else { gas };
                generate(*seed, *count, *packing)
            }
            Self::Galperin { power } => galperin(*power),
            Self::Cradle { count, moving, gap } => cradle(*count, *moving, gap),
            Self::Break { rows, touching, .. } if *touching => break_shot(*rows, &Rack::Touching),
            Self::Break { rows, gap, .. } => break_shot(*rows, &Rack::Gap(gap.clone())),
            Self::Ring { count } => ring(*count),
            Self::Mirror {
                seed,
                count,
                packing,
            } => mirror(*seed, *count, *packing),
            Self::Corner { wedge } => corner(wedge),
            Self::Family { name, seed, index } => scene_of(*name, *seed, *index),
        }
    }
}

pub(super) fn execute(arguments: &Arguments) -> Result<Exit, Error> {
    let scene = arguments.scene()?;
    Output::open(&arguments.output)?.write_text(&scene.to_json())?;
    Ok(Exit::Success)
}
