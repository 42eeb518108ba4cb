//! What runs of a scene say, in each arithmetic, against what they should.

use carom::arithmetic::Arithmetic;
use carom::run::Outcome;
use carom::scalar::{Exact, Filtered, Number};
use carom::scene::{Disc, Mass, Scene, SceneBuilder};
use carom::simulation::Algorithm;
use carom::support::check_support;
use num_rational::BigRational;

use super::heading::{Heading, number};
use crate::common::{complete, names, tolerance};

/// What an arithmetic says of a scene, and which of a case's verdicts it is
/// held to.
struct Judge {
    name: &'static str,
    says: fn(&Scene) -> Said,
    expected: fn(&Case) -> Option<&String>,
}

/// The arithmetics with a verdict of their own. Filtered decides exactly, but for the numbers as binary64
/// stores them: see [`Case::check`].
const JUDGES: [Judge; 2] = [
    Judge {
        name: f64::NAME,
        says: judge::<f64>,
        expected: |case| case.plain.as_ref(),
    },
    Judge {
        name: Exact::NAME,
        says: judge::<Exact>,
        expected: |case| Some(&case.truth),
    },
];

/// A scene with the verdicts expected: of the scene as written, of the scene
/// as binary64 stores it, and of plain binary64 arithmetic.
pub(crate) struct Case {
    scene: Scene,
    truth: String,
    stored: Option<String>,
    plain: Option<String>,
    filtered_is_open: bool,
    times: Option<Vec<BigRational>>,
    leaving: Option<(Heading, Vec<[BigRational; 2]>)>,
}

/// What an arithmetic says of a scene.
struct Said {
    verdict: String,
    times: Vec<f64>,
    velocities: Vec<[f64; 2]>,
}

impl Case {
    /// A case in which all arithmetics are right.
    pub(crate) fn new(scene: SceneBuilder, truth: &str) -> Self {
        Self {
            scene: scene.build().expect("a valid scene"),
            truth: truth.to_owned(),
            stored: None,
            plain: Some(truth.to_owned()),
            filtered_is_open: false,
            times: None,
            leaving: None,
        }
    }

    /// The impacts are at these times.
    pub(crate) fn times(self, times: impl IntoIterator<Item = BigRational>) -> Self {
        let times = Some(times.into_iter().collect());
        Self { times, ..self }
    }

    /// The discs end with these velocities, seen along a heading.
    pub(crate) fn leaving(
        self,
        heading: Heading,
        velocities: impl IntoIterator<Item = [BigRational; 2]>,
    ) -> Self {
        let leaving = Some((heading, velocities.into_iter().collect()));
        Self { leaving, ..self }
    }

    /// Rounding the numbers of the scene to binary64 makes it another one,
    /// with this verdict.
    pub(crate) fn stored(self, verdict: &str) -> Self {
        let verdict = Some(verdict.to_owned());
        Self {
            stored: verdict.clone(),
            plain: verdict,
            ..self
        }
    }

    /// Plain binary64 arithmetic comes to another verdict.
    pub(crate) fn plain(self, verdict: &str) -> Self {
        let plain = Some(verdict.to_owned());
        Self { plain, ..self }
    }

    /// So close to the resolution of binary64 that it is of no interest how
    /// its roundings turn out.
    pub(crate) fn plain_is_open(self) -> Self {
        Self {
            plain: None,
            ..self
        }
    }

    /// It takes an exact impact to get to the last one: a rounded one may lead to
    /// another or to none.
    pub(crate) fn filtered_is_open(self) -> Self {
        Self {
            filtered_is_open: true,
            ..self
        }
    }

    /// Holds each arithmetic to what is expected of it; filtered arithmetic to
    /// what exact arithmetic says of the scene as stored.
    #[track_caller]
    pub(crate) fn check(&self, place: &str) {
        for judge in &JUDGES {
            if let Some(expected) = (judge.expected)(self) {
                let said = (judge.says)(&self.scene);
                let place = format!("{} {place}", judge.name);
                assert_eq!(said.verdict, *expected, "{place}");
                if *expected == self.truth {
                    self.check_course(&said, &place);
                }
            }
        }
        let stored = judge::<Exact>(&rounded(&self.scene)).verdict;
        if let Some(expected) = &self.stored {
            assert_eq!(stored, *expected, "stored {place}");
        }
        if !self.filtered_is_open {
            let filtered = judge::<Filtered>(&self.scene).verdict;
            assert_eq!(filtered, stored, "filtered {place}");
        }
    }

    /// Compares the numbers that are given.
    #[track_caller]
    fn check_course(&self, said: &Said, place: &str) {
        for (found, expected) in said.times.iter().zip(self.times.iter().flatten()) {
            assert_near(*found, expected, place);
        }
        let Some((heading, velocities)) = &self.leaving else {
            return;
        };
        for (found, expected) in said.velocities.iter().zip(velocities) {
            let seen = heading.seen(*found);
            assert_near(seen[0], &expected[0], place);
            assert_near(seen[1], &expected[1], place);
        }
    }
}

#[track_caller]
fn assert_near(found: f64, expected: &BigRational, place: &str) {
    let expected = number(expected.clone()).to_f64();
    let slack = tolerance::FEW_IMPACTS * expected.abs().max(1.0);
    assert!(
        (found - expected).abs() <= slack,
        "{place}: {found}, not {expected}"
    );
}

/// What an arithmetic says of a scene, unless it refuses it.
fn judge<S: Arithmetic>(scene: &Scene) -> Said {
    if check_support::<S>(scene, Algorithm::Timeline).is_err() {
        return Said {
            verdict: String::from("refused"),
            times: Vec::new(),
            velocities: Vec::new(),
        };
    }
    let outcome = complete::<S>(scene, Algorithm::Timeline);
    let times = outcome.impacts.iter().map(|impact| impact.time.to_f64());
    let velocities = outcome.end.iter().map(|disc| &disc.velocity);
    Said {
        verdict: told(&outcome),
        times: times.collect(),
        velocities: velocities
            .map(|velocity| [velocity.x.to_f64(), velocity.y.to_f64()])
            .collect(),
    }
}

/// The impacts in their order, then how many tangent passes and overlaps there
/// are, if any.
fn told<S: Arithmetic>(outcome: &Outcome<S>) -> String {
    let impacts = names(&outcome.impacts).into_iter();
    let (grazes, overlaps) = (outcome.grazes, outcome.overlaps);
    let grazes = (grazes > 0).then(|| format!("grazes: {grazes}"));
    let overlaps = (overlaps > 0).then(|| format!("overlaps: {overlaps}"));
    let all: Vec<_> = impacts.chain(grazes).chain(overlaps).collect();
    all.join(", ")
}

/// The scene as binary64 stores it.
fn rounded(scene: &Scene) -> Scene {
    let near = |number: &Number| number.to_f64();
    let pair = |[x, y]: &[Number; 2]| [near(x), near(y)];
    let mut builder = Scene::builder("rounded")
        .frame(near(&scene.frame().duration), scene.frame().count)
        .restitution(scene.effects().restitution.clone());
    for disc in scene.discs() {
        let made = Disc::at(pair(&disc.position), near(&disc.radius));
        let made = made.velocity(pair(&disc.velocity));
        builder = builder.disc(match &disc.mass {
            Mass::Finite(mass) => made.mass(near(mass)),
            Mass::Infinite => made.infinite_mass(),
        });
    }
    for wall in scene.walls() {
        builder = builder.wall(pair(&wall.from), pair(&wall.to));
    }
    builder.build().expect("a valid scene")
}

/// An empty scene of one frame that lasts so long.
pub(crate) fn lasting(duration: i64) -> SceneBuilder {
    Scene::builder("family").frame(duration, 1)
}
