//! Runs in binary64 held against the truth of their own state.
//!
//! [`check`] runs a scene and verifies every decision of the run, exactly: that
//! what collides touches and approaches, that nothing else has got into
//! anything before, that energy is kept, that a second run is the same, that a
//! run goes on in the same way after a stop. What rounding explains is not held
//! against it, and no more than that: the margins are derived.
//!
//! Nothing here shares code with detection or response. A state's numbers are
//! binary64, so all that is asked of them are signs of polynomials in whole
//! numbers times powers of two: there is always an answer.

mod bodies;
pub mod construct;
mod course;
mod energy;
mod finding;
mod flight;
mod margin;
mod minimise;
mod passes;
mod real;
mod record;
#[cfg(feature = "json")]
mod resume;
mod verify;
mod window;

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::arithmetic::Arithmetic;
use crate::scalar::Filtered;
use crate::scene::Scene;
use crate::simulation::Algorithm;
use crate::support::{self, Unsupported};
use flight::Trial;
use record::Record;

pub use finding::{Finding, Kind, Run};
pub use minimise::{minimise, minimise_by};

/// How much of a scene's runs is checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// The impacts of the timeline.
    pub impacts: usize,
    /// At how many of these it is stopped and resumed.
    pub resumptions: usize,
    /// The frames of the multiple collision algorithm.
    pub frames: u64,
    /// The passes of each.
    pub passes: u32,
}

impl Default for Effort {
    fn default() -> Self {
        Self {
            impacts: 200,
            resumptions: 200,
            frames: 8,
            passes: 3,
        }
    }
}

/// Checks the runs of a scene. A scene that cannot be simulated has none.
///
/// # Errors
///
/// The first difference from the truth that rounding does not explain.
///
/// # Examples
///
/// ```
/// use carom::check::check;
/// use carom::scene::{Disc, Scene};
///
/// let moving = Disc::at([0, 0], 1).velocity([2, 0]);
/// let scene = Scene::builder("example").disc(moving).disc(Disc::at([3, 0], 1)).build()?;
/// assert_eq!(check(&scene), Ok(()));
/// # Ok::<(), carom::scene::SceneError>(())
/// ```
pub fn check(scene: &Scene) -> Result<(), Finding> {
    check_with(scene, &Effort::default())
}

/// The same with more or less effort.
///
/// # Errors
///
/// The first finding.
pub fn check_with(scene: &Scene, effort: &Effort) -> Result<(), Finding> {
    checked::<f64>(scene, effort)?;
    checked::<Filtered>(scene, effort)
}

/// Whether the runs of a scene can be checked: bodies have to move straight in
/// one plane.
///
/// # Errors
///
/// What stands in the way.
pub fn check_support(scene: &Scene) -> Result<(), Unsupported> {
    let effects = scene.effects();
    let bent = [
        (effects.gravity.is_some(), "effects.gravity"),
        (effects.drag.is_some(), "effects.drag"),
        (scene.periodic().is_some(), "periodic"),
    ];
    if let Some((_, place)) = bent.into_iter().find(|(asked, _)| *asked) {
        let circumstance = String::from("where runs are checked");
        return Err(Unsupported::Combination {
            place,
            circumstance,
        });
    }
    support::check_support::<f64>(scene, Algorithm::Timeline)
}

fn checked<S: Arithmetic>(scene: &Scene, effort: &Effort) -> Result<(), Finding> {
    guarded(trial::<S>(Run::Timeline), || examine::<S>(scene, effort))
}

/// What panics is found, too.
fn guarded(trial: Trial, work: impl FnOnce() -> Result<(), Finding>) -> Result<(), Finding> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|panic| {
        let fault = (Kind::Panic(message(&*panic)), 0.0);
        Err(trial.finding(fault, 0, None, 0.0))
    })
}

fn message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned())
        .unwrap_or_default()
}

fn trial<S: Arithmetic>(run: Run) -> Trial {
    let arithmetic = S::NAME;
    Trial { run, arithmetic }
}

fn examine<S: Arithmetic>(scene: &Scene, effort: &Effort) -> Result<(), Finding> {
    if check_support(scene).is_err()
        || support::check_support::<S>(scene, Algorithm::Timeline).is_err()
    {
        return Ok(());
    }
    examine_timeline::<S>(scene, effort)?;
    passes::judge::<S>(scene, effort)
}

fn examine_timeline<S: Arithmetic>(scene: &Scene, effort: &Effort) -> Result<(), Finding> {
    let trial = trial::<S>(Run::Timeline);
    let runs = [(); 2].map(|()| Record::of::<S>(scene, effort.impacts));
    let [Some(record), Some(again)] = runs else {
        return Ok(());
    };
    if !record.is_identical(&again) {
        let fault = (Kind::Nondeterminism, 0.0);
        return Err(trial.finding(fault, record.claims.len(), None, 0.0));
    }
    flight::judge(&record, scene.effects().restitution.is_elastic(), trial)?;
    #[cfg(feature = "json")]
    resume::judge::<S>(scene, &record, effort)?;
    Ok(())
}

#[cfg(test)]
mod tests;
