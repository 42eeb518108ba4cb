//! First impacts: two bodies, and how they meet.

use carom::body::End;
use carom::first_impact::{Class, FirstImpact, of_disc_and_wall, of_discs};
use carom::scene::{Disc, Scene};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use schemars::JsonSchema;
use serde::Serialize;

use super::flag::Flag;
use super::plane::{Way, cross, dot, nearest, vector};
use super::text::{BodyText, DiscText, WallText};
use crate::cli::time::Time;

/// Within so much of its reach a pass counts as grazing: 2^-19.
const GRAZING: f64 = 1.0 / (1 << 19) as f64;

/// Overlaps below so much of the reach are of a kind that rounding makes: 2^-40.
const ROUNDING: f64 = 1.0 / (1_u64 << 40) as f64;

/// Two bodies in free motion, and how they first meet.
#[derive(Serialize, JsonSchema)]
pub(super) struct Question {
    id: String,
    a: DiscText,
    b: BodyText,
    class: Class,
    /// When they meet: of a hit or a graze, and 0 where they touch or overlap, and
    /// approach.
    time: Option<Time>,
    /// The end of the wall that is touched, unless its inside is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "End")]
    end: Option<End>,
    flags: Vec<Flag>,
    /// The lesser of |distance at the start - reach| / reach and |least distance - reach|
    /// / reach.
    margin: f64,
}

impl Question {
    /// What comes of the bodies of a scene, which are two discs, or a disc and a wall.
    pub(super) fn of(scene: &Scene) -> Self {
        let [one, others @ ..] = scene.discs() else {
            unreachable!("a scene of two bodies")
        };
        let (b, met, way) = match (others, scene.walls()) {
            ([other, ..], _) => (
                BodyText::Disc(DiscText::from(other)),
                of_discs(one, other),
                Way::of_discs(one, other),
            ),
            ([], [wall, ..]) => (
                BodyText::Wall(WallText::from(wall)),
                of_disc_and_wall(one, wall),
                Way::to_wall(one, wall),
            ),
            ([], []) => unreachable!("a scene of two bodies"),
        };
        let margins = Margins::of(&way);
        Self {
            id: scene.id().to_owned(),
            a: DiscText::from(one),
            b,
            flags: flags(scene, &met, &way, &margins),
            class: met.class,
            time: met.time.as_ref().map(Time::from),
            end: met.end,
            margin: margins.start.min(margins.least),
        }
    }
}

/// How far two bodies are from touching, as parts of their reach.
pub(super) struct Margins {
    start: f64,
    least: f64,
}

impl Margins {
    pub(super) fn of(way: &Way) -> Self {
        Self {
            start: way.margin(&way.start()),
            least: way.margin(&way.least()),
        }
    }

    /// Whether they come close to tangency, later than at the start.
    pub(super) fn is_grazing(&self) -> bool {
        self.least <= GRAZING && self.start > GRAZING
    }
}

fn flags(scene: &Scene, met: &FirstImpact, way: &Way, margins: &Margins) -> Vec<Flag> {
    let overlaps = met.class == Class::Overlap;
    let table = [
        (Flag::Grazing, margins.is_grazing()),
        (Flag::InitialOverlap, overlaps),
        (
            Flag::OverlapByRounding,
            overlaps && margins.start < ROUNDING,
        ),
        (Flag::EndPoint, met.end.is_some()),
        (Flag::LargeOffset, is_far(scene)),
        (
            Flag::SpuriousCandidate,
            met.class == Class::Miss && is_candidate(way),
        ),
        (
            Flag::Bullet,
            scene
                .discs()
                .iter()
                .any(|disc| is_bullet(disc, &sixtieth())),
        ),
    ];
    let given = table.into_iter().filter(|(_, is)| *is);
    given.map(|(flag, _)| flag).collect()
}

fn sixtieth() -> BigRational {
    BigRational::new(1.into(), 60.into())
}

/// Whether a frame takes a disc so many times its diameter.
pub(super) fn is_bullet(disc: &Disc, frame: &BigRational) -> bool {
    let velocity = vector(&disc.velocity);
    let size = disc.radius.to_rational() * BigRational::from_integer(16.into());
    dot(&velocity, &velocity) * frame * frame >= &size * &size
}

/// Whether coordinates are large, compared to how large and how far apart bodies are.
pub(super) fn is_far(scene: &Scene) -> bool {
    let discs = scene.discs().iter().map(|disc| &disc.position);
    let walls = scene.walls().iter().flat_map(|wall| [&wall.from, &wall.to]);
    let points: Vec<_> = discs.chain(walls).map(vector).collect();
    let radii = scene.discs().iter().map(|disc| disc.radius.to_rational());
    let axis = |axis: usize| {
        let parts = points.iter().map(|point| &point[axis]);
        let (low, high) = (parts.clone().min(), parts.max());
        let (low, high) = (
            low.cloned().unwrap_or_default(),
            high.cloned().unwrap_or_default(),
        );
        [&high - &low, high.abs().max(low.abs())]
    };
    let [[width, far], [height, high]] = [0, 1].map(axis);
    let size = width.max(height) + radii.max().unwrap_or_default();
    far.max(high) >= size * BigRational::from_integer(500.into())
}

/// Whether a quick test of bodies that miss has them meet: boxes about two discs, or the
/// line that a wall is a part of.
fn is_candidate(way: &Way) -> bool {
    let Some(along) = &way.along else {
        let towards = dot(&way.position, &way.velocity).is_negative();
        let reach = &way.reach * &way.reach * BigRational::from_integer(2.into());
        return towards && way.least() <= reach;
    };
    let [side, drift] = [&way.position, &way.velocity].map(|part| cross(part, along));
    (side * drift).is_negative()
}

/// The margin of a pass, unless its bodies are nearest at its start.
pub(super) fn margin_of_pass(way: &Way) -> Option<f64> {
    let least = way.least();
    (least < way.start()).then(|| way.margin(&least))
}

/// By what part of the second of two times they differ.
pub(super) fn apart(first: &BigRational, second: &BigRational) -> f64 {
    match second.is_zero() {
        true => 0.0,
        false => nearest((second - first).abs() / second),
    }
}

#[cfg(test)]
mod tests {
    use carom::scene::{DiscBuilder, SceneBuilder};

    use super::*;

    fn moving(position: [i32; 2], velocity: [i32; 2]) -> DiscBuilder {
        Disc::at(position, 1).velocity(velocity)
    }

    fn flags_of(scene: SceneBuilder) -> Vec<Flag> {
        Question::of(&scene.build().expect("a scene")).flags
    }

    fn two(one: DiscBuilder, other: DiscBuilder) -> Vec<Flag> {
        flags_of(Scene::builder("two").discs([one, other]))
    }

    #[test]
    fn discs_have_the_flags_that_they_are_named_for() {
        let still = || moving([0, 0], [0, 0]);
        assert_eq!(two(moving([-9, 0], [1, 0]), still()), []);
        assert_eq!(two(moving([-9, 2], [1, 0]), still()), [Flag::Grazing]);
        assert_eq!(
            two(moving([-1, 0], [1, 0]), still()),
            [Flag::InitialOverlap]
        );
        // √2 times the reach is 2.83.
        let near = Disc::at(["-9", "2.8"], 1).velocity([1, 0]);
        assert_eq!(two(near, still()), [Flag::SpuriousCandidate]);
        let far = Disc::at(["-9", "2.9"], 1).velocity([1, 0]);
        assert_eq!(two(far, still()), []);
        // A sixtieth of 960 is eight times 2.
        assert_eq!(two(moving([-9, 0], [960, 0]), still()), [Flag::Bullet]);
        assert_eq!(two(moving([-9, 0], [959, 0]), still()), []);
        // Nine apart and a radius of 1, 5000 away.
        let away = || moving([5000, 0], [0, 0]);
        assert_eq!(two(moving([4991, 0], [1, 0]), away()), [Flag::LargeOffset]);
        let less = || moving([4999, 0], [0, 0]);
        assert_eq!(two(moving([4990, 0], [1, 0]), less()), []);
        let touching = Disc::at(["-0x1.ffffffffffffp0", "0"], 1).velocity([1, 0]);
        let rounded = [Flag::InitialOverlap, Flag::OverlapByRounding];
        assert_eq!(two(touching, still()), rounded);
    }

    #[test]
    fn walls_have_ends_and_lines() {
        let wall = |disc| flags_of(Scene::builder("wall").disc(disc).wall([0, 0], [6, 0]));
        assert_eq!(wall(moving([3, 5], [0, -1])), []);
        assert_eq!(wall(moving([6, 5], [0, -1])), [Flag::EndPoint]);
        assert_eq!(wall(moving([8, 5], [0, -1])), [Flag::SpuriousCandidate]);
        assert_eq!(wall(moving([8, 5], [0, 1])), []);
    }
}
