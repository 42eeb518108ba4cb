//! Infinitely many impacts before a finite time: inelastic collapse.
//!
//! Where impacts lose energy, bodies may collide for ever in ever shorter
//! intervals (Bernu and Mazighi 1990; McNamara and Young 1992; Zhou and
//! Kadanoff 1996). So may a disc that a moving body of infinite mass presses
//! against something, whether energy is lost or not. The run cannot get past
//! that time, the limit.
//!
//! Where discs fall, it is found of [bounces](bounce) on a wall. Elsewhere it is
//! found in three ways. Of three bodies on a line, [`trio`] proves it and
//! knows the limit in closed form. Of three discs in the plane, [`planar`]
//! proves it and bounds the limit, as soon as the bounds are close. [`alone`]
//! proves that nothing else interferes before. Otherwise [`repetition`] recognises a word of pairs
//! that repeats while its intervals shrink; its limit is extrapolated, and
//! nothing is proven. Three bodies on a line that do not collapse are never
//! recognised.
//!
//! Scenes in which nothing can accumulate are not watched ([`can_accumulate`]), but for
//! a disc that is stuck from the start ([`jam`]).
//! With the paper's restitution only repetition is looked for: its impacts
//! slow whole velocities, which no relative motion describes.

mod alone;
mod bounce;
mod jam;
mod planar;
mod repetition;
mod trio;

use std::cmp::Ordering::{Equal, Greater, Less};

use super::{Timed, Timeline};
use crate::body::{BodyId, Pair};
use crate::impact::Impact;
use crate::kernel::Kernel;
use crate::respond::Restitution;
use crate::world::World;
pub(super) use jam::Jams;
use repetition::Repetition;
use trio::Fate;

/// Infinitely many impacts before a finite time.
#[derive(Clone, Debug)]
pub struct Accumulation<S> {
    /// Bounds of the time that they approach, equal if it is known.
    pub limit: [S; 2],
    /// Whether that is proven, of each decision and of the limit.
    pub proven: bool,
    /// The pairs that collide in turn, for ever.
    pub word: Vec<Pair>,
}

impl<S> Accumulation<S> {
    /// The same in other numbers.
    pub(crate) fn map<T>(&self, make: impl Fn(&S) -> T) -> Accumulation<T> {
        Accumulation {
            limit: self.limit.each_ref().map(make),
            proven: self.proven,
            word: self.word.clone(),
        }
    }
}

/// How often a disc's partners must alternate before a proof is tried.
const ALTERNATIONS: u32 = 2;

/// Looks for an accumulation in the impacts of a timeline.
#[derive(Clone, Debug)]
pub(super) struct Watch<S> {
    /// Whether bodies overlapped at the start, so that an impact need not be
    /// a contact.
    overlaps: bool,
    partners: Vec<Partners>,
    repetition: Repetition<S>,
    /// What goes on from the latest impact, if nothing else happens.
    found: Option<Accumulation<S>>,
    /// Whether the run has come to it.
    is_over: bool,
}

/// The bodies that a disc collided with, the latest first; none for the end of
/// a wall, which no proof considers.
#[derive(Clone, Copy, Debug, Default)]
struct Partners {
    latest: Option<BodyId>,
    previous: Option<BodyId>,
    alternations: u32,
}

impl Partners {
    fn note(&mut self, partner: Option<BodyId>) {
        self.alternations = match self.previous == partner {
            true => self.alternations + 1,
            false => 0,
        };
        self.previous = std::mem::replace(&mut self.latest, partner);
    }

    /// Between which two bodies the disc goes back and forth.
    fn pair(&self) -> Option<[BodyId; 2]> {
        let (latest, previous) = (self.latest?, self.previous?);
        (self.alternations >= ALTERNATIONS && latest != previous).then_some([latest, previous])
    }
}

impl<S: Kernel> Watch<S> {
    /// A watch over a world's run, if it takes one.
    pub(super) fn over(world: &World<S>, until: &S) -> Option<Self> {
        can_accumulate(world).then(|| Self {
            overlaps: !matches!(world.count_overlaps(), Ok(0)),
            partners: vec![Partners::default(); world.discs.len()],
            repetition: Repetition::within(until),
            found: None,
            is_over: false,
        })
    }

    /// The end of a run that stops at once.
    pub(super) fn ended(found: Accumulation<S>) -> Self {
        Self {
            overlaps: false,
            partners: Vec::new(),
            repetition: Repetition::within(&found.limit[0]),
            found: Some(found),
            is_over: true,
        }
    }

    /// The discs of a pair that go back and forth between two bodies.
    fn trios(&self, pair: Pair) -> impl Iterator<Item = (usize, [BodyId; 2])> {
        [pair.a, pair.b].into_iter().filter_map(|body| match body {
            BodyId::Disc(disc) => {
                let sides = self.partners[disc as usize].pair()?;
                Some((disc as usize, sides))
            }
            BodyId::Wall(_) => None,
        })
    }

    fn note(&mut self, impact: &Impact<S>) {
        let Pair { a, b } = impact.pair;
        for (body, partner) in [(a, b), (b, a)] {
            if let BodyId::Disc(disc) = body {
                let is_whole = impact.end.is_none();
                self.partners[disc as usize].note(is_whole.then_some(partner));
            }
        }
        self.repetition.note(impact);
    }
}

/// Whether infinitely many impacts can precede a finite time.
///
/// Elastic discs of finite mass and fixed bodies collide finitely often in
/// finite time (Vaserstein 1979; Burago, Ferleger and Kononenko 1998). So they
/// do if slow impacts are elastic: each other impact takes at least some fixed
/// part of the energy. Neither holds where a body of infinite mass moves, for
/// that gives energy without end.
fn can_accumulate<S: Kernel>(world: &World<S>) -> bool {
    let loses = |kept: &S| !matches!(kept.compare(&S::from_integer(1)), Ok(Equal | Greater));
    let lossy = match &world.restitution {
        Restitution::Elastic => false,
        Restitution::Newton {
            discs,
            walls,
            elastic_below,
        } => elastic_below.is_none() && (loses(discs) || loses(walls)),
        Restitution::Paper { kept } => loses(kept),
    };
    lossy
        || world.discs.iter().any(|disc| {
            let speed = disc.velocity.norm_squared();
            !disc.is_movable() && !matches!(speed.sign(), Ok(Equal))
        })
}

impl<S: Timed> Timeline<S> {
    /// The accumulation before which the run ended, if it did.
    pub fn accumulation(&self) -> Option<&Accumulation<S>> {
        let watch = self.watch.as_ref()?;
        watch.found.as_ref().filter(|_| watch.is_over)
    }

    /// Whether infinitely many impacts are still to come before `limit`.
    pub(super) fn accumulates(&mut self, limit: &S) -> bool {
        let Some(watch) = &mut self.watch else {
            return false;
        };
        let found = watch.found.as_ref();
        watch.is_over |=
            found.is_some_and(|found| matches!(found.limit[1].compare(limit), Ok(Less | Equal)));
        watch.is_over
    }

    /// Takes note of an impact, after which all is as the timeline says.
    pub(super) fn observe(&mut self, impact: &Impact<S>) {
        if let Some(stuck) = self.jam(impact) {
            self.watch = Some(Watch::ended(stuck));
            return;
        }
        let Some(mut watch) = self.watch.take() else {
            return;
        };
        watch.note(impact);
        watch.found = self.find_accumulation(&watch, impact.pair);
        self.watch = Some(watch);
    }

    fn find_accumulation(&self, watch: &Watch<S>, pair: Pair) -> Option<Accumulation<S>> {
        if !S::IS_STRAIGHT {
            let repeated = || watch.repetition.accumulation();
            let several = |found: &Accumulation<S>| found.word.iter().any(|one| *one != pair);
            return self.bounces(pair).or_else(|| repeated().filter(several));
        }
        let proves = !S::ROUNDS && !watch.overlaps;
        let (mut parts, mut approaches) = (false, false);
        for (middle, sides) in watch.trios(pair) {
            match trio::fate(&self.flights, &self.now, middle, sides) {
                Fate::Collapses(trio) if self.is_alone(&trio) => {
                    return Some(trio.accumulation(proves));
                }
                Fate::Collapses(_) => {}
                Fate::Parts => parts = true,
                Fate::Unknown if proves => match self.cascade(middle, sides) {
                    Some(cascade) if self.is_tight(&cascade) => {
                        let found = self.settle(&cascade);
                        if found.is_some() {
                            return found;
                        }
                    }
                    cascade => approaches |= cascade.is_some(),
                },
                Fate::Unknown => {}
            }
        }
        if approaches {
            return None;
        }
        // Two pairs are three bodies, of which the end is known.
        let repeated = watch.repetition.accumulation();
        repeated.filter(|found| found.word.len() > 2 || !parts)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Exact, Number, Scalar};
    use crate::scene::{Disc, Restitution, Scene, SceneBuilder};

    fn is_watched(scene: SceneBuilder) -> bool {
        let world = World::<Exact>::new(&scene.build().unwrap(), 128);
        Watch::over(&world, &Exact::from_integer(1)).is_some()
    }

    fn scene() -> SceneBuilder {
        Scene::builder("test")
            .disc(Disc::at([0, 0], 1).velocity([1, 0]))
            .disc(Disc::at([9, 0], 1).infinite_mass())
            .wall([0, 5], [9, 5])
    }

    fn newton(discs: &str, walls: &str, elastic_below: Option<i32>) -> Restitution {
        Restitution::Newton {
            coefficient: discs.parse().unwrap(),
            walls: Some(walls.parse().unwrap()),
            elastic_below: elastic_below.map(Number::from),
        }
    }

    #[test]
    fn what_cannot_accumulate_is_not_watched() {
        assert!(!is_watched(scene()));
        assert!(!is_watched(scene().restitution(newton("1", "1", None))));
        assert!(!is_watched(scene().restitution(newton("0", "0", Some(1)))));
        let lossless = Restitution::paper(Number::from(0));
        assert!(!is_watched(scene().restitution(lossless)));
    }

    #[test]
    fn what_loses_energy_is_watched() {
        assert!(is_watched(scene().restitution(newton("1/2", "1", None))));
        assert!(is_watched(scene().restitution(newton("1", "1/2", None))));
        let lossy = Restitution::paper("1/10".parse::<Number>().unwrap());
        assert!(is_watched(scene().restitution(lossy)));
    }

    #[test]
    fn a_moving_body_of_infinite_mass_is_watched() {
        let piston = || Disc::at([-9, 0], 1).velocity([1, 0]).infinite_mass();
        assert!(is_watched(scene().disc(piston())));
        let slow = newton("1/2", "1/2", Some(1));
        assert!(is_watched(scene().disc(piston()).restitution(slow)));
    }
}
