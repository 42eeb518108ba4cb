//! `carom figures`: the paper's figures, from real runs.

use std::ops::ControlFlow;
use std::path::PathBuf;

use carom::frame::Passes;
use carom::run::{Options, run};
use carom::scalar::Exact;
use carom::scene::{Restitution, Scene};
use carom::simulation::Algorithm;
use maud::html;

use super::draw::{Panel, Story, picture};
use super::error::Error;
use super::exit::Exit;
use super::html;
use super::motion::Motion;
use super::output::{Output, make_directory};

/// Draw the paper's figures 2 to 8 and its two timelines.
///
/// Each is made by the algorithm that the paper draws, in exact arithmetic, and stands
/// beside the exact timeline where the two differ. An index.html shows them all.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  carom figures pictures")]
pub(super) struct Arguments {
    /// Where they go; made if it is not there.
    #[arg(value_name = "DIR")]
    directory: PathBuf,
}

/// A figure of the paper.
struct Figure {
    name: &'static str,
    caption: &'static str,
    scenes: &'static [&'static str],
    algorithm: Algorithm,
    look: Look,
}

/// What is special about a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Look {
    Plain,
    /// What discs sweep is drawn.
    Swept,
    /// The scene stands beside the same one without losses.
    BesideElastic,
}

macro_rules! scene {
    ($name:literal) => {
        include_str!(concat!("../../scenes/", $name, ".json"))
    };
}

const STYLE: &str = "
body { max-width: 72rem; margin: auto; padding: 1rem; font-family: sans-serif; }
figure { margin: 0 0 2rem; }
img { max-width: 100%; height: auto; background: #fff; }
";

const TWICE: Algorithm = Algorithm::Multiple(Passes::Count(2));

const FIGURES: [Figure; 9] = [
    Figure {
        name: "figure-2",
        caption: "Detection after the fact lets a disc tunnel through another one.",
        scenes: &[scene!("figure-2")],
        algorithm: Algorithm::Retroactive { substeps: 1 },
        look: Look::Plain,
    },
    Figure {
        name: "figure-3",
        caption: "What discs sweep overlaps: they may collide.",
        scenes: &[scene!("figure-6-moving-moving")],
        algorithm: Algorithm::Single,
        look: Look::Swept,
    },
    Figure {
        name: "figure-4",
        caption: "Impacts that lose energy, in the paper's sense.",
        scenes: &[scene!("figure-4")],
        algorithm: TWICE,
        look: Look::BesideElastic,
    },
    Figure {
        name: "figure-5",
        caption: "Two impacts of a disc in one frame.",
        scenes: &[scene!("figure-5")],
        algorithm: TWICE,
        look: Look::Plain,
    },
    Figure {
        name: "figure-6",
        caption: "Two discs that move, one of two, and none.",
        scenes: &[
            scene!("figure-6-moving-moving"),
            scene!("figure-6-moving-still"),
            scene!("figure-6-still-still"),
        ],
        algorithm: Algorithm::Single,
        look: Look::Plain,
    },
    Figure {
        name: "figure-7",
        caption: "With one impact a frame a disc loses what is left of the frame.",
        scenes: &[scene!("figure-7")],
        algorithm: Algorithm::Single,
        look: Look::Plain,
    },
    Figure {
        name: "figure-8",
        caption: "A second pass lets it go on.",
        scenes: &[scene!("figure-8")],
        algorithm: TWICE,
        look: Look::Plain,
    },
    Figure {
        name: "timeline-1",
        caption: "The first timeline: two walls in one frame.",
        scenes: &[scene!("timeline-1")],
        algorithm: TWICE,
        look: Look::Plain,
    },
    Figure {
        name: "timeline-2",
        caption: "The second timeline: four discs, four impacts.",
        scenes: &[scene!("timeline-2")],
        algorithm: TWICE,
        look: Look::Plain,
    },
];

pub(super) fn execute(arguments: &Arguments) -> Result<Exit, Error> {
    let directory = &arguments.directory;
    make_directory(directory)?;
    for figure in &FIGURES {
        let path = directory.join(format!("{}.svg", figure.name));
        Output::open(&path)?.write_text(&picture(&figure.panels()))?;
    }
    Output::open(&directory.join("index.html"))?.write_text(&index())?;
    Ok(Exit::Success)
}

impl Figure {
    fn scenes(&self) -> Vec<Scene> {
        let scenes = self.scenes.iter().map(|scene| Scene::from_json(scene));
        let mut scenes: Vec<_> = scenes
            .collect::<Result<_, _>>()
            .expect("scenes of the repository");
        if self.look == Look::BesideElastic {
            scenes.insert(0, elastic(&scenes[0]));
        }
        scenes
    }

    /// A panel for each scene, and one more for the truth where that differs.
    fn panels(&self) -> Vec<Panel> {
        let mut panels = Vec::new();
        for scene in self.scenes() {
            let [drawn, truth] = [self.algorithm, Algorithm::Timeline].map(|algorithm| Panel {
                title: format!("{}: {algorithm}", scene.id()),
                story: story(&scene, algorithm),
                swept: self.look == Look::Swept,
            });
            let differs = differ(&drawn.story, &truth.story);
            panels.push(drawn);
            panels.extend(differs.then_some(truth));
        }
        panels
    }
}

/// The same scene without losses.
fn elastic(scene: &Scene) -> Scene {
    let elastic = scene.to_builder().restitution(Restitution::default());
    let elastic = elastic.id(format!("{}, elastic", scene.id())).build();
    elastic.expect("a scene goes without losses")
}

fn story(scene: &Scene, algorithm: Algorithm) -> Story {
    let options = Options {
        contacts: true,
        ..Options::default()
    };
    let go_on = &mut |_| ControlFlow::Continue(());
    let outcome = run::<Exact>(scene, algorithm, &options, go_on);
    let outcome = outcome.expect("these scenes need nothing special");
    let motion = Motion::new(scene, algorithm, &outcome);
    Story::of(scene, &motion, [0.0, motion.until])
}

/// Whether impacts or ends are elsewhere.
fn differ(one: &Story, other: &Story) -> bool {
    let [one, other] = [one, other].map(Story::places);
    let apart = |(one, other): (&[f64; 2], &[f64; 2])| {
        let [x, y] = [0, 1].map(|axis| one[axis] - other[axis]);
        x.hypot(y) > 1e-9
    };
    one.len() != other.len() || one.iter().zip(&other).any(apart)
}

fn index() -> String {
    let body = html! {
        h1 { "The paper's figures, from real runs" }
        p {
            "Bodies in colour where they start, blue arrows for how they move; orange "
            "circles where they collide, by their numbers, and orange arrows for how they "
            "go on; in grey the rest of the way."
        }
        @for figure in &FIGURES {
            figure {
                img src=(format!("{}.svg", figure.name)) alt=(figure.caption);
                figcaption { (figure.name) ": " (figure.caption) }
            }
        }
    };
    html::page("carom: the paper's figures", STYLE, &body)
}
