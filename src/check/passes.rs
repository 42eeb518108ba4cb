//! The multiple collision algorithm held against what it says it does, pass by
//! pass.
//!
//! A frame starts with moving apart what overlaps. That is judged first: nothing
//! may be moved by more than it has to. It also settles which pairs have parted and
//! are not tested, and how far apart those are that are; so it is the start of what
//! follows. A disc that overlaps several others may be moved by more than a margin of
//! a pair that none of these is in.
//!
//! Every pass is judged from its own start: where each disc then is, and how
//! much of its frame is left. A collision is right if the two touch and approach
//! after the time that each of them takes, and if no other pair with one of
//! them, on its own clocks, gets into each other before. A pair that gets into
//! each other within the frame, without a collision, must have lost against
//! another one. All of that is exact, up to the same margins as elsewhere.

use super::bodies::{Bodies, Motion, discs, length};
use super::finding::{Finding, Kind, Run};
use super::flight::Trial;
use super::record::Claim;
use super::window::Window;
use super::{Effort, trial};
use crate::arithmetic::Arithmetic;
use crate::body::Disc;
use crate::frame::{Candidates, Frame, Passes, multiple, resolve_overlaps};
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
    let mut paces = vec![0.0; world.discs.len()];
    for number in 0..scene.frame().count.min(effort.frames) {
        let frame = Frame {
            start: S::from_integer(0),
            ..clock.frame(number, precision)
        };
        let Some(passes) = passes(&world, &frame, effort.passes) else {
            return Ok(());
        };
        paces = judge_frame(Objects::new(&world, &frame, &paces), &frame, &passes)?;
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

/// Judges a frame from where its objects are at its start. What is returned are the
/// speeds that the velocities at its end were computed from.
fn judge_frame<S: Arithmetic>(
    mut objects: Objects<S>,
    frame: &Frame<S>,
    passes: &[Pass<S>],
) -> Result<Vec<f64>, Finding> {
    let mut apart = objects.world.clone();
    if objects.overlap() || resolve_overlaps(&mut apart).is_err() {
        return Ok(objects.paces());
    }
    let trial = |pass| {
        let frame = frame.number;
        trial::<S>(Run::Frame { frame, pass })
    };
    objects.separate(&apart, trial(1))?;
    for (pass, number) in passes.iter().zip(1..) {
        let claims: Vec<_> = pass.collisions.iter().map(Claim::of).collect();
        objects.judge(&pass.collisions, &claims, trial(number))?;
        objects.collide(&pass.collisions, &claims, &pass.end);
    }
    Ok(objects.paces())
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
    /// The objects at the start of a frame. The velocities that they come with were
    /// computed from others, at these paces: whoever has not collided since is as far
    /// off as it was then.
    fn new(world: &World<S>, frame: &Frame<S>, paces: &[f64]) -> Self {
        let count = world.discs.len();
        let discs = world.discs.iter().zip(paces);
        Self {
            bodies: Bodies::of(world),
            world: world.clone(),
            motions: discs.map(|(disc, &pace)| paced(disc, pace)).collect(),
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
            ..Window::new(&self.bodies, &self.motions, time)
        }
    }

    /// Whether anything overlaps by more than rounding.
    fn overlap(&self) -> bool {
        let window = self.window(0.0);
        let mut pairs = self.bodies.pairs();
        pairs.any(|pair| window.overlap(pair, f64::INFINITY) > 1.0)
    }

    /// Takes over where the objects are when what overlaps has been moved apart. What
    /// has parted only by that goes on to be tested: it must not meet.
    fn separate(&mut self, apart: &World<S>, trial: Trial) -> Result<(), Finding> {
        let due = self.due_moves();
        for (disc, body) in apart.discs.iter().enumerate() {
            let motion = paced(body, self.motions[disc].pace);
            let moved = length(self.motions[disc].to(&motion));
            if moved > due[disc] {
                let fault = (Kind::Displaced, moved / due[disc]);
                return Err(trial.finding(fault, 0, None, 0.0));
            }
            let parted = self.world.discs[disc].last;
            self.motions[disc] = motion;
            self.world.discs[disc] = Disc {
                last: parted.filter(|_| parted == body.last),
                ..body.clone()
            };
        }
        Ok(())
    }

    /// By how much each disc may be moved out of what it overlaps. A pair is moved by
    /// no more than it overlaps, which is what it did at first, and what pairs before
    /// it have moved either of the two.
    fn due_moves(&self) -> Vec<f64> {
        let mut due = vec![0.0; self.motions.len()];
        let window = Window {
            clock: 0.0,
            ..self.window(0.0)
        };
        for pair in self.bodies.pairs() {
            let apart = window.course(pair).distances()[0] - window.reach(pair).to_f64();
            let moved: f64 = discs(pair).map(|disc| due[disc]).sum();
            let overlap = (moved - apart + window.margin(pair)).max(0.0);
            for disc in self.bodies.movable(pair) {
                due[disc] += overlap;
            }
        }
        due
    }

    /// For each disc the greatest of the speeds that its velocity was computed from.
    fn paces(&self) -> Vec<f64> {
        self.motions.iter().map(|motion| motion.pace).collect()
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
        for (impact, claim) in found.iter().zip(claims) {
            let other_time = impact.other_time.as_ref().unwrap_or(&impact.time);
            let times = [&impact.time, other_time].map(S::to_f64);
            let speeds = discs(claim.pair).map(|disc| self.motions[disc].speed());
            let pace = speeds.sum();
            for (disc, time) in discs(claim.pair).zip(times) {
                if self.bodies.masses[disc].is_none() {
                    continue;
                }
                self.motions[disc] = paced(&end.discs[disc], pace);
                self.world.discs[disc] = end.discs[disc].clone();
                self.clocks[disc] = time;
                self.modified[disc] = true;
            }
        }
    }
}

/// A disc where its clock stands, with a velocity computed from speeds up to a pace.
fn paced<S: Arithmetic>(disc: &Disc<S>, pace: f64) -> Motion {
    let motion = Motion::of(disc, &S::from_integer(0));
    Motion {
        pace: motion.pace.max(pace),
        ..motion
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Disc;

    /// Two discs of equal mass that overlap by 1, and may be moved by that at most.
    #[test]
    fn moved_too_far() {
        let scene = Scene::builder("overlap").frame(4, 1);
        let scene = scene.discs([Disc::at([0, 0], 1), Disc::at([1, 0], 1)]);
        let world = World::<f64>::new(&scene.build().unwrap(), ());
        let frame = Frame {
            number: 0,
            start: 0.0,
            duration: 4.0,
        };
        let run = Run::Frame { frame: 0, pass: 1 };
        let kind = |place| {
            let mut apart = world.clone();
            resolve_overlaps(&mut apart).unwrap();
            assert_eq!(apart.discs[0].position.x, -0.5);
            apart.discs[0].position.x = place;
            let separated =
                Objects::new(&world, &frame, &[0.0; 2]).separate(&apart, trial::<f64>(run));
            separated.err().map(|finding| finding.kind)
        };
        assert_eq!(kind(-0.5), None);
        assert_eq!(kind(-1.0), None);
        assert_eq!(kind(-1.0 - 2_f64.powi(-40)), Some(Kind::Displaced));
    }
}
