//! Bodies in flight, each kept at the time of its own last impact.

use std::cmp::Ordering;

use super::arbiter::{Arbiter, Foreseen, Timed};
use crate::body::{Disc, Feature};
use crate::detect::{Encounter, gap_circle, gap_segment};
use crate::impact::Place;
use crate::respond::ClusterContact;
use crate::scalar::{Interval, Scalar};
use crate::vec2::Vec2;
use crate::world::{Obstacle, World};

/// The bodies, the times at which they are where `world` says, and the turn
/// at which each was changed last.
///
/// A `moment` names such a time: equal names are equal times, also where the
/// arithmetic could not prove it.
#[derive(Clone, Debug)]
pub struct Flights<S> {
    pub(super) world: World<S>,
    pub(super) since: Vec<S>,
    pub(super) turn: Vec<u64>,
    moment: Vec<u64>,
}

/// What a disc meets next of one body, and when.
#[derive(Clone, Debug)]
pub struct Meeting<S> {
    pub(super) time: S,
    pub(super) feature: Feature,
    pub(super) graze: bool,
    pub(super) overlap: bool,
    /// The name of the time, if the meeting follows without any delay.
    pub(super) moment: Option<u64>,
}

impl<S: Scalar> Meeting<S> {
    /// How far apart two times are, relative to the later one.
    pub(super) fn apart(&self, other: &Self) -> f64 {
        let apart = (self.time.clone() - &other.time).to_f64().abs();
        apart / self.time.to_f64().max(other.time.to_f64())
    }
}

impl<S: Scalar> Flights<S> {
    pub(super) fn new(world: World<S>) -> Self {
        let count = world.discs.len();
        Self {
            world,
            since: vec![S::from_integer(0); count],
            turn: vec![0; count],
            moment: vec![0; count],
        }
    }

    pub(super) fn hull(&self) -> Flights<Interval> {
        Flights {
            world: self.world.hull(),
            since: self.since.iter().map(S::hull).collect(),
            turn: self.turn.clone(),
            moment: self.moment.clone(),
        }
    }

    /// When and where a disc meets an obstacle.
    #[inline]
    pub(super) fn meet(
        &self,
        disc: usize,
        obstacle: Obstacle,
    ) -> Result<Option<Meeting<S>>, S::Doubt> {
        if let Some(feature) = self.world.contact(disc, obstacle) {
            let place = self.place(disc, feature, &self.since[disc], true);
            let approaches = self.world.approaches(disc, feature, &place.other)?;
            return Ok(approaches.then(|| self.touching(disc, feature)));
        }
        match obstacle {
            Obstacle::Disc(other) => self.meet_disc(disc, other),
            Obstacle::Wall(wall) => self.meet_wall(disc, wall),
        }
    }

    #[inline]
    fn meet_disc(&self, disc: usize, other: usize) -> Result<Option<Meeting<S>>, S::Doubt> {
        let (early, late) = if self.turn[disc] < self.turn[other] {
            (disc, other)
        } else {
            (other, disc)
        };
        let start = &self.since[late];
        let [first, second] = [early, late].map(|index| &self.world.discs[index]);
        let offset = second.position.minus(&self.position_at(early, start));
        let velocity = second.velocity.minus(&first.velocity);
        self.check_order(early, late, &offset)?;
        let met = self.world.meet_discs((early, late), &offset, &velocity)?;
        let feature = Feature::Disc(other as u32);
        Ok(met.map(|encounter| self.meeting(late, encounter, feature)))
    }

    /// The later turn is the later time, unless the two changed in impacts so
    /// close that none had to be proven the first. Then the discs must be
    /// apart, by more than they move in between.
    #[inline]
    fn check_order(&self, early: usize, late: usize, offset: &Vec2<S>) -> Result<(), S::Doubt> {
        if S::ROUNDS || self.moment[early] == self.moment[late] {
            return Ok(());
        }
        let Err(doubt) = self.since[early].compare(&self.since[late]) else {
            return Ok(());
        };
        let [first, second] = [early, late].map(|index| &self.world.discs[index]);
        let reach = first.radius.clone() + &second.radius;
        match S::power(&offset.x, &offset.y, &reach).sign()? {
            Ordering::Greater => Ok(()),
            _ => Err(doubt),
        }
    }

    fn meet_wall(&self, disc: usize, wall: usize) -> Result<Option<Meeting<S>>, S::Doubt> {
        let met = self.world.meet_wall(disc, wall)?;
        Ok(met.map(|encounter| {
            let feature = self.world.feature(wall, encounter.end);
            self.meeting(disc, encounter, feature)
        }))
    }

    /// The meeting of a disc with a feature that it touches and approaches.
    pub(super) fn touching(&self, disc: usize, feature: Feature) -> Meeting<S> {
        self.meeting(disc, Encounter::now(), feature)
    }

    /// The meeting that an encounter leads to, seen from where a disc is.
    #[inline]
    fn meeting(&self, start: usize, encounter: Encounter<S>, feature: Feature) -> Meeting<S> {
        Meeting {
            time: self.since[start].clone() + encounter.delay,
            feature,
            graze: encounter.graze,
            overlap: encounter.overlap,
            moment: encounter.overlap.then_some(self.moment[start]),
        }
    }

    /// The order of two meetings in time, where numbers leave that open by
    /// proof.
    pub(super) fn order(
        &self,
        one: (usize, &Meeting<S>),
        other: (usize, &Meeting<S>),
        arbiter: &mut S::Arbiter,
    ) -> Result<Ordering, S::Doubt>
    where
        S: Timed,
    {
        let [first, second] = [one.1, other.1];
        if first.moment.is_some() && first.moment == second.moment && !S::ROUNDS {
            return Ok(Ordering::Equal);
        }
        first.time.compare(&second.time).or_else(|doubt| {
            let [one, other] = [one, other].map(|(disc, meeting)| Foreseen::meeting(disc, meeting));
            arbiter.order(self, &one, &other, doubt)
        })
    }

    /// Where a disc is at a time, if nothing changes its motion.
    #[inline]
    pub(super) fn position_at(&self, disc: usize, time: &S) -> Vec2<S> {
        let body = &self.world.discs[disc];
        let flown = time.clone() - &self.since[disc];
        body.position.moved(&body.velocity, &flown)
    }

    /// A disc as it is at a time.
    pub(super) fn disc_at(&self, disc: usize, time: &S) -> Disc<S> {
        Disc {
            position: self.position_at(disc, time),
            ..self.world.discs[disc].clone()
        }
    }

    /// Where a disc is that has been brought to a time, or moves on unchanged.
    fn position_brought(&self, disc: usize, time: &S) -> Vec2<S> {
        let body = &self.world.discs[disc];
        if body.is_movable() {
            body.position.clone()
        } else {
            self.position_at(disc, time)
        }
    }

    /// Where a disc and a feature are that have been brought to a time.
    pub(super) fn place(&self, disc: usize, feature: Feature, time: &S, overlap: bool) -> Place<S> {
        let centre = self.position_brought(disc, time);
        let other = match feature {
            Feature::Disc(other) => self.position_brought(other as usize, time),
            Feature::Wall(_) | Feature::Corner(_) => Vec2::zero(),
        };
        Place {
            centre,
            other,
            overlap,
        }
    }

    /// The name of the time at which a disc is where the world says.
    pub(super) fn moment_of(&self, disc: usize) -> u64 {
        self.moment[disc]
    }

    /// Puts a disc at the start of some motion of it.
    pub(super) fn set(&mut self, disc: usize, body: Disc<S>, since: S, turn: u64) {
        self.world.discs[disc] = body;
        self.since[disc] = since;
        self.moment[disc] = turn;
        self.turn[disc] = turn;
    }

    /// Whether a disc and an obstacle are apart, touch or overlap at a time, and
    /// the feature that is nearest.
    pub(super) fn gap(
        &self,
        disc: usize,
        obstacle: Obstacle,
        time: &S,
    ) -> Result<(Ordering, Feature), S::Doubt> {
        let centre = self.position_at(disc, time);
        let radius = &self.world.discs[disc].radius;
        match obstacle {
            Obstacle::Disc(other) => {
                let offset = self.position_at(other, time).minus(&centre);
                let reach = radius.clone() + &self.world.discs[other].radius;
                Ok((gap_circle(&offset, &reach)?, Feature::Disc(other as u32)))
            }
            Obstacle::Wall(wall) => {
                let segment = &self.world.walls[wall].segment;
                let (gap, end) = gap_segment(&centre, radius, segment)?;
                Ok((gap, self.world.feature(wall, end)))
            }
        }
    }

    /// The contact of a disc and a feature that have been brought to a time.
    pub(super) fn cluster_contact(
        &self,
        disc: usize,
        feature: Feature,
        time: &S,
    ) -> Result<ClusterContact<S>, S::Doubt> {
        let place = self.place(disc, feature, time, false);
        let normal = self.world.normal(disc, feature, &place);
        let second = match feature {
            Feature::Disc(other) => Some(other as usize),
            Feature::Wall(_) | Feature::Corner(_) => None,
        };
        let is_behind = match feature {
            Feature::Wall(wall) => {
                let segment = &self.world.walls[wall as usize].segment;
                let side = place.centre.minus(&segment.from).cross(&segment.along);
                side.sign()?.is_lt()
            }
            Feature::Disc(_) | Feature::Corner(_) => false,
        };
        Ok(ClusterContact {
            first: disc,
            second,
            normal: if is_behind { normal.reversed() } else { normal },
        })
    }

    /// The turn at which a feature changed last: walls never do.
    #[inline]
    pub(super) fn turn_of(&self, feature: Feature) -> u64 {
        match feature {
            Feature::Disc(other) => self.turn[other as usize],
            Feature::Wall(_) | Feature::Corner(_) => 0,
        }
    }

    /// Takes a disc to the time of its impact, at some turn.
    pub(super) fn bring(&mut self, disc: usize, time: &S, moment: u64, turn: u64) {
        if self.moment[disc] != moment {
            let flown = time.clone() - &self.since[disc];
            self.world.advance_disc(disc, &flown);
            self.since[disc] = time.clone();
            self.moment[disc] = moment;
        }
        self.turn[disc] = turn;
    }

    /// Puts a disc where its impact at a time leaves it; one that no impact
    /// changes stays as it is.
    pub(super) fn land(&mut self, disc: usize, after: Disc<S>, time: &S, turn: u64) {
        if !after.is_movable() {
            return;
        }
        let before = std::mem::replace(&mut self.world.discs[disc], after);
        self.world.leave_contacts(disc, &before.velocity);
        self.since[disc] = time.clone();
        self.moment[disc] = turn;
        self.turn[disc] = turn;
    }

    /// All numbers that impacts change.
    pub(super) fn numbers(&mut self) -> impl Iterator<Item = &mut S> {
        let discs = self.world.discs.iter_mut().flat_map(|disc| {
            let Disc {
                position, velocity, ..
            } = disc;
            [
                &mut position.x,
                &mut position.y,
                &mut velocity.x,
                &mut velocity.y,
            ]
        });
        discs.chain(&mut self.since)
    }
}

impl Flights<Interval> {
    /// A time before which a disc and an obstacle do not touch: of two discs
    /// the gap between them, divided by their relative speed, from where they
    /// are.
    pub(super) fn apart_until(&self, disc: usize, obstacle: Obstacle) -> f64 {
        let since = &self.since[disc];
        let Obstacle::Disc(other) = obstacle else {
            return since.lo();
        };
        let start = if since.lo() < self.since[other].lo() {
            self.since[other]
        } else {
            *since
        };
        let [one, two] = [disc, other].map(|index| &self.world.discs[index]);
        let offset = self
            .position_at(other, &start)
            .minus(&self.position_at(disc, &start));
        let gap = offset.norm_squared().sqrt() - one.radius - two.radius;
        let speed = two.velocity.minus(&one.velocity).norm_squared().sqrt();
        let [least_gap, most_speed] = [gap.lo(), speed.hi()].map(|end| Interval::new(end, end));
        if least_gap.lo() > 0.0 && most_speed.lo() > 0.0 {
            (start + least_gap / most_speed).lo()
        } else {
            start.lo()
        }
    }
}
