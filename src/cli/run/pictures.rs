//! What is to be looked at of a run.

use carom::arithmetic::Arithmetic;
use carom::judge::judge;
use carom::run::{Options, Outcome};
use carom::scalar::Exact;
use carom::scene::Scene;
use carom::simulation::Algorithm;
use carom::timeline::Simultaneous;

use super::{Arguments, watched};
use crate::cli::draw::{Panel, Story, picture};
use crate::cli::error::Error;
use crate::cli::motion::Motion;
use crate::cli::replay::{Pane, Replay};

/// The scene, with only as many frames as it takes to get to a time.
fn up_to(scene: &Scene, time: f64) -> Scene {
    let duration = &scene.frame().duration;
    let count = (time / duration.to_f64()).ceil().max(1.0) as u64;
    let shorter = scene.to_builder().frame(duration.clone(), count).build();
    shorter.unwrap_or_else(|_| scene.clone())
}

impl Arguments {
    /// Whether any picture is wanted, for which the circumstances of impacts are kept.
    pub(super) fn has_pictures(&self) -> bool {
        self.svg.is_some() || self.html.is_some()
    }

    /// Pictures show no copies of discs, and no frames that differ each time.
    pub(super) fn check_pictures(&self, scene: &Scene) -> Result<(), Error> {
        if !self.has_pictures() {
            return Ok(());
        }
        let expected = match scene.periodic() {
            Some(_) => "a scene that is not periodic",
            None if self.algorithm.has_frame_budget() => "--passes instead of --frame-budget",
            None => return Ok(()),
        };
        Err(Error::Usage(format!("--svg, --html: expected {expected}")))
    }

    /// The picture of the run, or of one of its frames.
    pub(super) fn picture<S: Arithmetic>(
        &self,
        scene: &Scene,
        algorithm: Algorithm,
        outcome: &Outcome<S>,
    ) -> Result<String, Error> {
        let motion = Motion::new(scene, algorithm, outcome);
        let span = match self.svg_frame {
            None => [0.0, motion.until],
            Some(frame) => self.span(scene, frame, motion.until)?,
        };
        Ok(picture(&[Panel {
            title: format!("{}: {algorithm}, {}", scene.id(), S::NAME),
            story: Story::of(scene, &motion, span),
            swept: false,
        }]))
    }

    /// The time of a frame, which must begin before the run ends.
    fn span(&self, scene: &Scene, frame: u64, until: f64) -> Result<[f64; 2], Error> {
        let duration = scene.frame().duration.to_f64();
        let span = [frame as f64, (frame + 1) as f64].map(|count| count * duration);
        if span[0] < until {
            return Ok([span[0], span[1].min(until)]);
        }
        let frames = (until / duration).ceil();
        Err(Error::Usage(format!(
            "--svg-frame {frame}: expected less than {frames}"
        )))
    }

    /// The replay of the run, beside the truth.
    pub(super) fn replay<S: Arithmetic>(
        &self,
        scene: &Scene,
        algorithm: Algorithm,
        options: &Options,
        outcome: &Outcome<S>,
    ) -> Result<String, Error> {
        let pane = Pane::new(scene, algorithm, outcome);
        if algorithm == Algorithm::Timeline && S::NAME == Exact::NAME {
            return Ok(Replay::of(pane).page(scene));
        }
        let unsupported = |reason| self.unsupported(reason);
        let truth = watched::<Exact>(scene, Algorithm::Timeline, options).map_err(unsupported)?;
        let truth = Pane::new(scene, Algorithm::Timeline, &truth);
        // Frames are judged by the usual rule.
        if options.simultaneous != Simultaneous::default() {
            return Ok(Replay::beside(pane, truth).page(scene));
        }
        let part = up_to(scene, outcome.time.to_f64());
        let judged = judge::<S>(&part, algorithm, options.frame_broad_phase, &options.budget);
        let judged = judged.map_err(unsupported)?;
        let pane = pane.with_faults(&judged.faults, [judged.frames, judged.undecided]);
        Ok(Replay::beside(pane, truth).page(scene))
    }
}
