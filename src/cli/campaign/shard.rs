//! Which scenes a campaign has, and the threads that go through them.

use std::sync::Mutex;
use std::sync::mpsc;
use std::thread;

use carom::scene::generate::{Family, scene_of};
use carom::scene::{Scene, SceneError};

use super::outcome::{Examiner, Outcome};
use crate::cli::error::Error;
use crate::cli::interrupt;

/// A scene, by what it is made from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Task {
    pub(super) family: Family,
    pub(super) index: u64,
}

impl Task {
    /// The name of its scene.
    pub(super) fn name(self, seed: u64) -> String {
        format!("{}-{seed}-{}", self.family, self.index)
    }

    pub(super) fn scene(self, seed: u64) -> Result<Scene, SceneError> {
        scene_of(self.family, seed, self.index)
    }
}

/// Goes through tasks with several examiners, each on a thread of its own. `done` is told
/// what comes of each, in no order; the end is at its first error, or at Ctrl-C.
pub(super) fn go_through<'a>(
    tasks: &[Task],
    seed: u64,
    examiners: Vec<Examiner<'a>>,
    mut done: impl FnMut(Task, Outcome) -> Result<(), Error>,
) -> Result<(), Error> {
    let waiting = Mutex::new(tasks.iter());
    let next = || {
        let mut waiting = waiting
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner());
        waiting.next().filter(|_| !interrupt::is_interrupted())
    };
    thread::scope(|scope| {
        let (sender, outcomes) = mpsc::channel();
        for mut examiner in examiners {
            let (sender, next) = (sender.clone(), &next);
            scope.spawn(move || {
                while let Some(task) = next() {
                    let outcome = task.scene(seed).map(|scene| examiner.examine(&scene));
                    if sender.send((*task, outcome)).is_err() {
                        return;
                    }
                }
            });
        }
        drop(sender);
        for (task, outcome) in outcomes {
            // Ctrl-C ends the programs, too: that is no crash of theirs.
            if !interrupt::is_interrupted() {
                done(task, outcome?)?;
            }
        }
        Ok(())
    })
}
