//! The multiple collision algorithm held against what it says it does, pass by
//! pass.
//!
//! Every pass is judged from its own start: where each disc then is, and how
//! much of its frame is left. A collision is right if the two touch and approach
//! after the time that each of them takes, and if no other pair with one of
//! them, on its own clocks, gets into each other before. A pair that gets into
//! each other within the frame, without a collision, must have lost against
//! another one. All of that is exact, up to the same margins as elsewhere: a
//! frame moves bodies that overlap by rounding apart, which is a second one.

use super::bodies::{Bodies, Motion, discs};
use super::finding::{Finding, Kind, Run};
use super::flight::Trial;
use super::record::Claim;
use super::window::Window;
use super::{Effort, trial};
use crate::arithmetic::Arithmetic;
use crate::frame::{Candidates, Frame, Passes, multiple};
use crate::impact::Impact;
use crate::kernel::Kernel;
use crate::scene::Scene;
use crate::simulation::FrameClock;
use crate::world::{Obstacle, World};

type Pair = (usize, Obstacle);

/// The times that a search halves an interval: what is left is short enough for
/// no collision to come in between by chance.
const HALVINGS: u32 = 32;

/// Judges the first frames of a scene.
///
/// # Errors
///
/// The first finding.
pub(super) fn judge<S: Arithmetic>(scene: &Scene, effort: &Effort) -> Result<(), Finding> {
    let precision = S::first_precision(&Default::default());
    let clock = FrameClock::new(scene.frame());
    let mut world = World::<S>::new(scene, precision);
    for number in 0..scene.frame().count.min(effort.frames) {
        let frame = Frame {
            start: S::from_integer(0),
            ..clock.frame(number, precision)
        };
        let Some(passes) = passes(&world, &frame, effort.passes) else {
            return Ok(());
        };
        judge_frame(&world, &frame, &passes)?;
        let Some(last) = passes.into_iter().next_back() else {
            return Ok(());
        };
        world = last.end;
    }
    Ok(())
}

/// A pass: its collisions, and the frame's end if it is the last one.
struct Pass<S: Kernel> {
    collisions: Vec<Impact<S>>,
    end: World<S>,
}

/// The passes of a frame, each by a run that ends with it; none if the
/// arithmetic leaves a decision open.
fn passes<S: Arithmetic>(world: &World<S>, frame: &Frame<S>, most: u32) -> Option<Vec<Pass<S>>> {
    let mut passes: Vec<Pass<S>> = Vec::new();
    for count in 1..=most {
        let mut end = world.clone();
        let candidates = &mut Candidates::default();
        let passed = multiple(&mut end, frame, Passes::Count(count), candidates);
        let mut collisions = passed.ok()?;
        let known: usize = passes.iter().map(|pass| pass.collisions.len()).sum();
        collisions.drain(..known);
        let is_last = collisions.is_empty();
        passes.push(Pass { collisions, end });
        if is_last {
            break;
        }
    }
    Some(passes)
}

fn judge_frame<S: Arithmetic>(
    world: &World<S>,
    frame: &Frame<S>,
    passes: &[Pass<S>],
) -> Result<(), Finding> {
    let mut objects = Objects::new(world, frame);
    if objects.overlap() {
        return Ok(());
    }
    for (pass, number) in passes.iter().zip(1..) {
        let run = Run::Frame {
            frame: frame.number,
            pass: number,
        };
        let claims: Vec<_> = pass.collisions.iter().map(Claim::of).collect();
        objects.judge(&pass.collisions, &claims, trial::<S>(run))?;
        objects.collide(&pass.collisions, &claims, &pass.end);
    }
    Ok(())
}

/// Where the objects are within the frame.
struct Objects<S: Kernel> {
    bodies: Bodies,
    world: World<S>,
    motions: Vec<Motion>,
    /// The paper's `timepassed`.
    clocks: Vec<f64>,
    modified: Vec<bool>,
    duration: f64,
    is_first: bool,
}

impl<S: Arithmetic> Objects<S> {
    fn new(world: &World<S>, frame: &Frame<S>) -> Self {
        let count = world.discs.len();
        let zero = S::from_integer(0);
        let discs = world.discs.iter();
        Self {
            bodies: Bodies::of(world),
            world: world.clone(),
            motions: discs.map(|disc| Motion::of(disc, &zero)).collect(),
            clocks: vec![0.0; count],
            modified: vec![false; count],
            duration: frame.duration.to_f64(),
            is_first: true,
        }
    }

    /// The flight of a pair for a time, both from where they are.
    fn window(&self, time: f64) -> Window<'_> {
        Window {
            clock: self.duration,
            slack: 2.0,
            ..Window::new(&self.bodies, &self.motions, time)
        }
    }

    /// Whether anything overlaps by more than rounding.
    fn overlap(&self) -> bool {
        let window = self.window(0.0);
        let mut pairs = self.bodies.pairs();
        pairs.any(|pair| window.overlap(pair, f64::INFINITY) > 1.0)
    }

    fn left(&self, pair: Pair) -> f64 {
        let left = discs(pair).map(|disc| self.duration - self.clocks[disc]);
        left.fold(f64::INFINITY, f64::min)
    }

    fn tested(&self) -> impl Iterator<Item = Pair> {
        let is_tested = |pair: &Pair| {
            let modified = discs(*pair).any(|disc| self.modified[disc]);
            (self.is_first || modified) && !self.world.is_barred(pair.0, pair.1)
        };
        self.bodies.pairs().filter(is_tested)
    }

    /// The tested pairs that have a disc in common with a pair, one that a
    /// collision moves.
    fn rivals(&self, pair: Pair) -> impl Iterator<Item = Pair> {
        let shares = move |rival: &Pair| {
            *rival != pair
                && self
                    .bodies
                    .movable(*rival)
                    .any(|disc| discs(pair).any(|other| other == disc))
        };
        self.tested().filter(shares)
    }

    fn judge(&self, found: &[Impact<S>], claims: &[Claim], trial: Trial) -> Result<(), Finding> {
        for (index, (impact, claim)) in found.iter().zip(claims).enumerate() {
            let delay = impact.time.to_f64() - self.clocks[claim.pair.0];
            let fault = self.judge_collision(claim, delay);
            fault.map_err(|(fault, pair)| trial.finding(fault, index, Some(pair), claim.time))?;
        }
        for pair in self.tested() {
            if claims.iter().all(|claim| claim.pair != pair)
                && let Some(beyond) = self.is_missed(pair)
            {
                let fault = (Kind::Missed, beyond);
                return Err(trial.finding(fault, claims.len(), Some(pair), self.duration));
            }
        }
        Ok(())
    }

    /// A collision must be one, and the first of each of its discs.
    fn judge_collision(&self, claim: &Claim, delay: f64) -> Result<(), ((Kind, f64), Pair)> {
        let window = self.window(delay);
        window.verify(claim).map_err(|fault| (fault, claim.pair))?;
        if let Some(beyond) = window.depth(claim.pair) {
            return Err(((Kind::Mistimed, beyond), claim.pair));
        }
        for rival in self.rivals(claim.pair) {
            let window = self.window(delay.min(self.left(rival)));
            if let Some(beyond) = window.depth(rival) {
                return Err(((Kind::Misordered, beyond), rival));
            }
        }
        Ok(())
    }

    /// By how many margins a pair without a collision gets into each other, if
    /// none that shares a disc may come before.
    fn is_missed(&self, pair: Pair) -> Option<f64> {
        let left = self.left(pair);
        let beyond = self.window(left).depth(pair)?;
        let deep = self.deep_from(pair, left);
        let may_precede = |rival| self.window(deep.min(self.left(rival))).may_meet(rival);
        let precedes = self.rivals(pair).any(may_precede);
        (!precedes).then_some(beyond)
    }

    /// A time, no later than `left`, by which a pair has got into each other.
    fn deep_from(&self, pair: Pair, left: f64) -> f64 {
        let (mut apart, mut deep) = (0.0, left);
        for _ in 0..HALVINGS {
            let middle = (apart + deep) / 2.0;
            if self.window(middle).depth(pair).is_some() {
                deep = middle;
            } else {
                apart = middle;
            }
        }
        deep
    }

    /// Takes over what the collisions of a pass have done: whoever collides
    /// stays there until the next pass.
    fn collide(&mut self, found: &[Impact<S>], claims: &[Claim], end: &World<S>) {
        self.is_first = false;
        let zero = S::from_integer(0);
        for (impact, claim) in found.iter().zip(claims) {
            let other_time = impact.other_time.as_ref().unwrap_or(&impact.time);
            let times = [&impact.time, other_time].map(S::to_f64);
            let pace = discs(claim.pair).map(|disc| self.motions[disc].pace).sum();
            for (disc, time) in discs(claim.pair).zip(times) {
                if self.bodies.masses[disc].is_none() {
                    continue;
                }
                let motion = Motion::of(&end.discs[disc], &zero);
                self.motions[disc] = Motion {
                    pace: motion.pace.max(pace),
                    ..motion
                };
                self.world.discs[disc] = end.discs[disc].clone();
                self.clocks[disc] = time;
                self.modified[disc] = true;
            }
        }
    }
}
