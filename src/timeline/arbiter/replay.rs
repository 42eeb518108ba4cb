//! Legs computed again in expressions, each when it is asked for.

use std::cmp::Ordering;
use std::collections::HashMap;

use super::history::{Cause, Cluster, History, Leg, Origin, Partner, Side};
use crate::algebra::{Expression, Limits};
use crate::body::{Disc, Feature};
use crate::respond::{Reflection, reflect_cluster};
use crate::scalar::{Exact, Scalar, Undecided};
use crate::timeline::flight::Flights;
use crate::timeline::meeting::Meeting;
use crate::world::{Obstacle, World};

/// The most legs that one question may lead to, for each bit of the
/// enclosures that have left it open, and altogether.
const LEGS_PER_BIT: f64 = 1.0 / 16.0;
const MOST_LEGS: f64 = 32.0;

/// The bodies of a scene on those of their legs that have been asked for.
#[derive(Clone, Debug)]
pub(super) struct Replay {
    /// Where bodies are put to meet; between questions, anywhere.
    stage: Flights<Expression>,
    legs: HashMap<Leg, Body>,
    most_legs: usize,
}

/// A disc at the start of one of its legs.
#[derive(Clone, Debug)]
struct Body {
    index: usize,
    disc: Disc<Expression>,
    since: Expression,
}

impl Replay {
    /// The start of a world, if all its numbers are known as rationals.
    pub(super) fn new(world: &World<Exact>) -> Option<Self> {
        let bits = world.numbers().map(Exact::precision).max()?;
        let limits = Limits::after(bits);
        let known = |number: &Exact| Expression::from_exact(number, limits);
        if world.numbers().any(|number| known(number).is_none()) {
            return None;
        }
        let number = |number: &Exact| known(number).expect("all of them are known");
        let stage = Flights::new(world.rebuilt(number));
        let starts = stage.world.discs.iter().enumerate();
        let legs = starts.map(|(index, disc)| {
            let body = Body {
                index,
                disc: disc.clone(),
                since: Expression::from_integer(0),
            };
            (Leg::first_of(index as u32), body)
        });
        Some(Self {
            legs: legs.collect(),
            most_legs: (f64::from(bits) * LEGS_PER_BIT).min(MOST_LEGS) as usize,
            stage,
        })
    }

    /// When and where the bodies of a cause meet, moving freely.
    pub(super) fn meet(
        &mut self,
        history: &History,
        cause: Cause,
    ) -> Result<Option<Meeting<Expression>>, Undecided> {
        self.compute(history, cause)?;
        self.set(cause);
        let disc = self.legs[&cause.leg].index;
        match self.feature(cause.partner) {
            Feature::Disc(other) => self.stage.meet(disc, Obstacle::Disc(other as usize)),
            Feature::Wall(wall) => self.stage.meet(disc, Obstacle::Wall(wall as usize)),
            Feature::Corner(corner) => self.meet_corner(disc, corner),
        }
    }

    /// When a disc meets a corner, as the end of one of the walls that end
    /// there: it may overlap another and move away from that.
    fn meet_corner(
        &self,
        disc: usize,
        corner: u32,
    ) -> Result<Option<Meeting<Expression>>, Undecided> {
        let walls = self.stage.world.walls.iter().enumerate();
        let walls = walls.filter(|(_, wall)| wall.corners.contains(&corner));
        for (wall, _) in walls {
            let met = self.stage.meet(disc, Obstacle::Wall(wall))?;
            let met = met.filter(|meeting| meeting.feature == Feature::Corner(corner));
            if met.is_some() {
                return Ok(met);
            }
        }
        Ok(None)
    }

    /// The time of an impact.
    pub(super) fn time(
        &mut self,
        history: &History,
        cause: Cause,
    ) -> Result<Expression, Undecided> {
        if cause.at_once {
            self.compute(history, cause)?;
            return Ok(self.legs[&cause.later()].since.clone());
        }
        let met = self.meet(history, cause)?;
        let feature = self.feature(cause.partner);
        let met = met.filter(|meeting| meeting.feature == feature);
        met.map(|meeting| meeting.time)
            .ok_or_else(|| open("an impact that was taken for another"))
    }

    /// Whether bodies that touch at the start of the later one's leg approach.
    pub(super) fn approach(&mut self, history: &History, cause: Cause) -> Result<bool, Undecided> {
        self.compute(history, cause)?;
        self.set(cause);
        let time = self.legs[&cause.later()].since.clone();
        self.bring(cause, &time);
        let (disc, feature) = (self.legs[&cause.leg].index, self.feature(cause.partner));
        let place = self.stage.place(disc, feature, &time, true);
        self.stage.world.approaches(disc, feature, &place.other)
    }

    /// Computes the legs of a cause, and all that lead to them.
    fn compute(&mut self, history: &History, cause: Cause) -> Result<(), Undecided> {
        let mut pending: Vec<Leg> = cause.legs().collect();
        let mut count = 0;
        while let Some(&leg) = pending.last() {
            let missing = self.missing(history, leg);
            match missing {
                Some(Missing::Causes(legs)) => pending.extend(legs),
                Some(Missing::Impact(cause)) => {
                    self.impact(history, leg, cause)?;
                    count += 1;
                    pending.pop();
                }
                Some(Missing::Cluster(place)) => {
                    self.cluster(history, history.cluster(place))?;
                    count += 1;
                    pending.pop();
                }
                None => {
                    pending.pop();
                }
            }
            if count.max(pending.len()) > self.most_legs {
                return Err(open("a number that too many impacts lead to"));
            }
        }
        Ok(())
    }

    /// What is to be computed before a leg is known, or to make it known.
    fn missing(&self, history: &History, leg: Leg) -> Option<Missing> {
        if self.legs.contains_key(&leg) {
            return None;
        }
        let unknown = |leg: &Leg| !self.legs.contains_key(leg);
        let (legs, itself): (Vec<_>, _) = match history.origin(leg) {
            // The first legs are known.
            Origin::Start(_) => return None,
            Origin::Impact(cause, _) => (
                cause.legs().filter(unknown).collect(),
                Missing::Impact(cause),
            ),
            Origin::Cluster(place) => {
                let contacts = history.cluster(place).contacts.iter();
                let legs = contacts.flat_map(|contact| contact.legs());
                (legs.filter(unknown).collect(), Missing::Cluster(place))
            }
        };
        Some(if legs.is_empty() {
            itself
        } else {
            Missing::Causes(legs)
        })
    }

    /// Computes the legs that impacts begin which are resolved at once.
    fn cluster(&mut self, history: &History, cluster: &Cluster) -> Result<(), Undecided> {
        let time = self.time(history, cluster.trigger)?;
        for &contact in &cluster.contacts {
            self.set(contact);
        }
        for &contact in &cluster.contacts {
            self.bring(contact, &time);
        }
        let trigger = cluster.trigger;
        let contacts = cluster.contacts.iter().map(|contact| {
            let disc = self.legs[&contact.leg].index;
            let feature = self.feature(contact.partner);
            let is_trigger = (contact.leg, contact.partner) == (trigger.leg, trigger.partner);
            let overlap = trigger.at_once && is_trigger;
            self.stage.cluster_contact(disc, feature, &time, overlap)
        });
        let contacts = contacts.collect::<Result<Vec<_>, _>>()?;
        let World {
            discs, restitution, ..
        } = &mut self.stage.world;
        match reflect_cluster(discs, &contacts, restitution)? {
            Reflection::Parted(_) => {}
            Reflection::Jammed => return Err(open("discs without any play")),
        }
        for &(before, after) in &cluster.legs {
            self.keep(after, self.legs[&before].index, &time);
        }
        Ok(())
    }

    /// Whether two bodies are apart, touch or overlap at the time of an
    /// impact, and the feature of the second one that is nearest.
    pub(super) fn gap(
        &mut self,
        history: &History,
        trigger: Cause,
        cause: Cause,
    ) -> Result<(Ordering, Feature), Undecided> {
        let time = self.time(history, trigger)?;
        self.compute(history, cause)?;
        self.set(cause);
        let disc = self.legs[&cause.leg].index;
        let obstacle = match cause.partner {
            Partner::Disc(leg) => Obstacle::Disc(self.legs[&leg].index),
            Partner::Wall(wall) | Partner::Corner(wall) => Obstacle::Wall(wall as usize),
        };
        self.stage.gap(disc, obstacle, &time)
    }

    /// Computes the legs that an impact begins.
    fn impact(&mut self, history: &History, leg: Leg, cause: Cause) -> Result<(), Undecided> {
        let time = self.time(history, cause)?;
        self.set(cause);
        self.bring(cause, &time);
        let (disc, feature) = (self.legs[&cause.leg].index, self.feature(cause.partner));
        let place = self.stage.place(disc, feature, &time, cause.at_once);
        self.stage.world.collide(disc, feature, place)?;
        if cause.at_once {
            self.stage.world.forget(disc, feature);
        }
        let first = match history.origin(leg) {
            Origin::Impact(_, Side::Second) => leg.before(),
            _ => leg,
        };
        self.keep(first, disc, &time);
        if let Feature::Disc(other) = feature {
            self.keep(first.beside(), other as usize, &time);
        }
        Ok(())
    }

    /// Keeps a disc as an impact has left it on the stage.
    fn keep(&mut self, leg: Leg, index: usize, time: &Expression) {
        let body = Body {
            index,
            disc: self.stage.world.discs[index].clone(),
            since: time.clone(),
        };
        self.legs.insert(leg, body);
    }

    /// Puts the bodies of a cause on the stage, each at the start of its leg.
    fn set(&mut self, cause: Cause) {
        for leg in cause.legs() {
            let body = &self.legs[&leg];
            let turn = leg.index() as u64;
            self.stage
                .set(body.index, body.disc.clone(), body.since.clone(), turn);
        }
    }

    /// Takes the bodies of a cause to a time.
    fn bring(&mut self, cause: Cause, time: &Expression) {
        for leg in cause.legs() {
            let index = self.legs[&leg].index;
            if self.stage.world.discs[index].is_movable() {
                self.stage.bring(index, time, u64::MAX, u64::MAX);
            }
        }
    }

    fn feature(&self, partner: Partner) -> Feature {
        match partner {
            Partner::Disc(leg) => Feature::Disc(self.legs[&leg].index as u32),
            Partner::Wall(wall) => Feature::Wall(wall),
            Partner::Corner(corner) => Feature::Corner(corner),
        }
    }
}

enum Missing {
    Causes(Vec<Leg>),
    Impact(Cause),
    Cluster(usize),
}

fn open(question: &str) -> Undecided {
    Undecided::new(0, question)
}
