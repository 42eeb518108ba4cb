//! Short scenes, with their proven logs.

use std::ops::ControlFlow;

use carom::body::BodyId;
use carom::impact::Impact;
use carom::log::{Ending, Event, MIN_DIGITS, Recorder, proven_digits};
use carom::run::{Options, Outcome, Status, run};
use carom::scalar::{Exact, Scalar};
use carom::scene::generate::{Family, scene_of};
use carom::scene::{Effects, Mass, Scene};
use carom::simulation::Algorithm;
use num_rational::BigRational;
use schemars::JsonSchema;
use serde::Serialize;

use super::flag::Flag;
use super::passes::margin;
use super::plane::Way;
use super::question::{Margins, apart, is_bullet, is_far};
use super::text::{DiscText, Text, WallText};
use crate::cli::error::Error;

const SEED: u64 = 1;

/// How many of each family there are.
const COUNTS: [(Family, u64); 9] = [
    (Family::Random, 70),
    (Family::NearGraze, 80),
    (Family::NearTie, 80),
    (Family::Bullets, 60),
    (Family::Cradles, 50),
    (Family::Corners, 60),
    (Family::Offsets, 40),
    (Family::MassRatios, 40),
    (Family::Galperin, 20),
];

/// Times that follow each other within so much of the later one are nearly tied: 2^-19.
const NEAR: f64 = 1.0 / (1 << 19) as f64;

/// A scene and its proven log.
#[derive(Serialize, JsonSchema)]
pub(super) struct SceneVector {
    id: String,
    scene: SceneText,
    events: Vec<Event>,
    /// How many tangent passes there are, which are no impacts.
    grazes: u64,
    flags: Vec<Flag>,
    /// The least of what decides the order of events: how far passes are from tangency,
    /// and how far apart the times of impacts are that share a disc.
    margin: f64,
}

/// A scene as carom/scene/1 has it.
#[derive(Serialize, JsonSchema)]
struct SceneText {
    schema: &'static str,
    id: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    notes: Option<String>,
    discs: Vec<DiscText>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    walls: Vec<WallText>,
    frame: FrameText,
    #[serde(default, skip_serializing_if = "is_idle")]
    effects: Effects,
}

#[derive(Serialize, JsonSchema)]
struct FrameText {
    duration: Text,
    count: u64,
}

fn is_idle(effects: &Effects) -> bool {
    *effects == Effects::default()
}

/// All scenes. All of them are decided.
pub(super) fn scenes() -> impl Iterator<Item = Result<SceneVector, Error>> {
    COUNTS.into_iter().flat_map(|(family, count)| {
        (0..count).map(move |index| SceneVector::of(&scene_of(family, SEED, index)?))
    })
}

impl SceneVector {
    fn of(scene: &Scene) -> Result<Self, Error> {
        let options = Options {
            digits: proven_digits(MIN_DIGITS),
            contacts: true,
            ..Options::default()
        };
        let go_on = &mut |_| ControlFlow::Continue(());
        let outcome = run::<Exact>(scene, Algorithm::Timeline, &options, go_on);
        let outcome = outcome.map_err(|reason| Error::Unsupported {
            file: scene.id().to_owned(),
            reason,
        })?;
        if outcome.status != Status::Complete {
            let ending = Ending::from(&outcome.status);
            return Err(Error::Usage(format!("{}: ends as {ending:?}", scene.id())));
        }
        let told = Options {
            contacts: false,
            ..options
        };
        let recorder = Recorder::new(scene, Algorithm::Timeline, &told, &outcome);
        Ok(Self {
            id: scene.id().to_owned(),
            scene: SceneText::from(scene),
            events: recorder.events().collect(),
            grazes: outcome.grazes,
            flags: flags(scene, &outcome),
            margin: margin(scene, &outcome),
        })
    }
}

impl From<&Scene> for SceneText {
    fn from(scene: &Scene) -> Self {
        Self {
            schema: "carom/scene/1",
            id: scene.id().to_owned(),
            notes: scene.notes().map(str::to_owned),
            discs: scene.discs().iter().map(DiscText::from).collect(),
            walls: scene.walls().iter().map(WallText::from).collect(),
            frame: FrameText {
                duration: Text::from(&scene.frame().duration),
                count: scene.frame().count,
            },
            effects: scene.effects().clone(),
        }
    }
}

fn flags(scene: &Scene, outcome: &Outcome<Exact>) -> Vec<Flag> {
    let impacts = &outcome.impacts;
    let frame = scene.frame().duration.to_rational();
    let table = [
        (Flag::Grazing, outcome.grazes > 0 || grazes_at_first(scene)),
        (
            Flag::Simultaneous,
            impacts.iter().any(|impact| impact.tie.is_some()),
        ),
        (Flag::InitialOverlap, outcome.overlaps > 0),
        (Flag::CornerHit, any_two(impacts, is_corner)),
        (
            Flag::EndPoint,
            impacts.iter().any(|impact| impact.end.is_some()),
        ),
        (Flag::MassRatio, has_mass_ratio(scene)),
        (Flag::NearTie, any_two(impacts, is_near_tie)),
        (Flag::LargeOffset, is_far(scene)),
        (
            Flag::Bullet,
            scene.discs().iter().any(|disc| is_bullet(disc, &frame)),
        ),
    ];
    let given = table.into_iter().filter(|(_, is)| *is);
    given.map(|(flag, _)| flag).collect()
}

/// Whether a pair would graze, were it alone.
fn grazes_at_first(scene: &Scene) -> bool {
    ways(scene).any(|way| Margins::of(&way).is_grazing())
}

fn ways(scene: &Scene) -> impl Iterator<Item = Way> {
    let discs = scene.discs();
    discs.iter().enumerate().flat_map(move |(index, disc)| {
        let others = discs[index + 1..].iter();
        let others = others.map(move |other| Way::of_discs(disc, other));
        others.chain(
            scene
                .walls()
                .iter()
                .map(move |wall| Way::to_wall(disc, wall)),
        )
    })
}

fn any_two(impacts: &[Impact<Exact>], is: fn(&Impact<Exact>, &Impact<Exact>) -> bool) -> bool {
    impacts.windows(2).any(|two| is(&two[0], &two[1]))
}

/// Whether a disc meets two walls at once.
fn is_corner(first: &Impact<Exact>, second: &Impact<Exact>) -> bool {
    let walls = [first, second].map(|impact| matches!(impact.pair.b, BodyId::Wall(_)));
    walls == [true; 2] && first.pair.a == second.pair.a && is_tie(first, second)
}

fn is_tie(first: &Impact<Exact>, second: &Impact<Exact>) -> bool {
    first.tie.is_some() && first.tie == second.tie
}

fn is_near_tie(first: &Impact<Exact>, second: &Impact<Exact>) -> bool {
    !is_tie(first, second) && apart(&time(first), &time(second)) <= NEAR
}

/// The time, or a bound of it to many digits.
pub(super) fn time(impact: &Impact<Exact>) -> BigRational {
    impact
        .time
        .enclosure()
        .map(|(lo, _)| lo)
        .unwrap_or_default()
}

fn has_mass_ratio(scene: &Scene) -> bool {
    let masses = scene.discs().iter().map(|disc| match &disc.mass {
        Mass::Finite(mass) => mass.to_f64(),
        Mass::Infinite => f64::INFINITY,
    });
    let (least, most) = masses.fold((f64::INFINITY, 0.0_f64), |(least, most), mass| {
        (least.min(mass), most.max(mass))
    });
    most >= 1000.0 * least
}
