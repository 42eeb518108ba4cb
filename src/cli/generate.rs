//! `carom generate`: scenes that are made rather than written.

use std::path::PathBuf;

use carom::scalar::Number;
use carom::scene::generate::{MAX_POWER, cradle, galperin, gas, table1};
use carom::scene::{Scene, SceneError};
use clap::Subcommand;

use super::error::Error;
use super::exit::Exit;
use super::output::Output;

/// Generate a scene.
///
/// The same parameters and seed give the same scene, on every platform.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  carom generate gas --count 500 --seed 7 --output gas.json")]
pub(super) struct Arguments {
    #[command(subcommand)]
    kind: Kind,
    /// Where the scene goes; - is standard output.
    #[arg(long, global = true, value_name = "FILE", default_value = "-")]
    output: PathBuf,
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
    /// A gas of equal discs in a square box.
    #[command(after_help = "Example:\n  carom generate gas --count 500 --packing 0.5")]
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
}

impl Kind {
    fn scene(&self) -> Result<Scene, SceneError> {
        match self {
            Self::Table1 { seed, scale } => table1(*seed, scale),
            Self::Gas {
                seed,
                count,
                packing,
            } => gas(*seed, *count, *packing),
            Self::Galperin { power } => galperin(*power),
            Self::Cradle { count, moving, gap } => cradle(*count, *moving, gap),
        }
    }
}

pub(super) fn execute(arguments: &Arguments) -> Result<Exit, Error> {
    let scene = arguments.kind.scene()?;
    Output::open(&arguments.output)?.write_text(&scene.to_json())?;
    Ok(Exit::Success)
}
