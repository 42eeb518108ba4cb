//! Scenes with a finding, made as small as they get, in files.

use std::cell::RefCell;
use std::path::Path;

use carom::check::minimise_by;
use carom::scalar::Filtered;
use carom::scene::Scene;
use carom::world::World;

use super::outcome::{Class, Examiner, Outcome};
use crate::cli::error::Error;
use crate::cli::interrupt;
use crate::cli::output::{Output, make_directory};

/// Writes a smaller scene that shows the same, with the command that replays it.
pub(super) fn save(
    scene: &Scene,
    outcome: &Outcome,
    examiner: &mut Examiner<'_>,
    command: &str,
    directory: &Path,
) -> Result<(), Error> {
    make_directory(directory)?;
    let class = outcome.class;
    let path = directory.join(format!("{}-{}.json", scene.id(), class.name()));
    let (small, shown) = smaller(scene, outcome, examiner);
    let notes = format!(
        "{}: {}. To replay it: carom campaign --impl {} --scene {}",
        class.name(),
        shown.detail.as_deref().unwrap_or("no detail"),
        shell_words::quote(command),
        shell_words::quote(&path.display().to_string()),
    );
    let small = small.to_builder().notes(notes).build()?;
    Output::open(&path)?.write_text(&small.to_json())
}

/// The smaller scene, and what comes of it.
fn smaller(scene: &Scene, outcome: &Outcome, examiner: &mut Examiner<'_>) -> (Scene, Outcome) {
    // Each trial of what does not answer would take as long again.
    if outcome.class == Class::Timeout {
        return (scene.clone(), outcome.clone());
    }
    let examiner = RefCell::new(examiner);
    let latest = RefCell::new(outcome.clone());
    let overlapping = overlaps(scene);
    let small = minimise_by(scene, |smaller| {
        // A scene that starts otherwise would show something else.
        if interrupt::is_interrupted() || overlaps(smaller) > overlapping {
            return false;
        }
        let found = examiner.borrow_mut().examine(smaller);
        let is_same = found.class == outcome.class;
        if is_same {
            latest.replace(found);
        }
        is_same
    });
    (small, latest.into_inner())
}

/// How many pairs overlap at the start, in the numbers of an engine that computes in
/// binary64.
fn overlaps(scene: &Scene) -> u64 {
    let world = World::<Filtered>::new(scene, ());
    let Ok(count) = world.count_overlaps();
    count
}
