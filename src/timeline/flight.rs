//! Bodies in flight, each kept at the time of its own last impact.

use std::cmp::Ordering;

use super::arbiter::{Arbiter, Foreseen, Timed};
use crate::body::{Disc, End, Feature, Wall};
use crate::detect::{gap_circle, gap_segment};
use crate::impact::Place;
use crate::kernel::{Approach, Flight, Glance, Kernel, Met, Pull, Time};
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
pub struct Flights<S: Kernel> {
    pub(super) world: World<S>,
    pub(super) since: Vec<S>,
    pub(super) turn: Vec<u64>,
    moment: Vec<u64>,
}

/// What a disc meets next of one body, and when.
#[derive(Clone, Debug)]
pub struct Meeting<S: Kernel> {
    pub(super) time: S::Time,
    pub(super) feature: Feature,
    pub(super) graze: bool,
    pub(super) overlap: bool,
    /// Whether they overlap, and do not only touch.
    pub(super) inside: bool,
    /// Whether nothing collides then, but the two are pressed together, or part
    /// that were.
    pub(super) rest: bool,
    /// The name of the time, if the meeting follows without any delay.
    pub(super) moment: Option<u64>,
}

impl<S: Kernel> Meeting<S> {
    /// How far apart two times are, relative to the later one.
    pub(super) fn apart(&self, other: &Self) -> f64 {
        let [one, two] = [self, other].map(|meeting| meeting.time.value());
        let apart = (one.clone() - &two).to_f64().abs();
        apart / one.to_f64().max(two.to_f64())
    }
}

impl<S: Kernel> Flights<S> {
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
        if let Some(met) = self.leave_wall(disc, obstacle) {
            return met;
        }
        if let Some(feature) = self.contact(disc, obstacle) {
            if self.skims(disc, feature) {
                return self.meet_again(disc, obstacle, feature);
            }
            let place = self.place(disc, feature, &self.since[disc], true);
            if self.world.approaches(disc, feature, &place.other)? {
                return Ok(Some(self.touching(disc, feature)));
            }
            return self.meet_again(disc, obstacle, feature);
        }
        if let Some(feature) = self.world.parted_from(disc, obstacle) {
            return self.meet_again(disc, obstacle, feature);
        }
        match obstacle {
            Obstacle::Disc(other) => self.meet_disc(disc, other),
            Obstacle::Wall(wall) => self.meet_wall(disc, wall),
        }
    }

    /// When a disc gets to the end of an obstacle that holds it, if that does. What
    /// goes on from there in the same line it does not meet before.
    #[inline]
    fn leave_wall(
        &self,
        disc: usize,
        obstacle: Obstacle,
    ) -> Option<Result<Option<Meeting<S>>, S::Doubt>> {
        match obstacle {
            Obstacle::Wall(wall) if !S::Pull::of(&self.world.pulls, disc).is_held_by(wall) => {
                self.world.slides_along(disc, wall).then_some(Ok(None))
            }
            Obstacle::Wall(wall) => {
                let segment = &self.world.walls[wall].segment;
                let met = S::leave_wall(self.flight(disc), segment);
                Some(met.map(|met| self.meeting_at_wall(disc, wall, met)))
            }
            Obstacle::Disc(_) => None,
        }
    }

    /// When a disc comes back to a feature that it touches, and parts from.
    fn meet_again(
        &self,
        disc: usize,
        obstacle: Obstacle,
        feature: Feature,
    ) -> Result<Option<Meeting<S>>, S::Doubt> {
        let skims = self.skims(disc, feature);
        match obstacle {
            Obstacle::Disc(other) => {
                let (early, late) = self.in_order(disc, other);
                let approach = self.approach(early, late);
                let met = S::meet_disc_again(&approach, skims)?;
                Ok(met.map(|met| self.meeting(late, met, feature)))
            }
            Obstacle::Wall(wall) => {
                let Wall { segment, corners } = &self.world.walls[wall];
                let is_touched = |end: &End| feature == Feature::Corner(corners[*end as usize]);
                let touched = [End::From, End::To].into_iter().find(is_touched);
                let met = S::meet_wall_again(self.flight(disc), segment, touched, skims)?;
                Ok(self.meeting_at_wall(disc, wall, met))
            }
        }
    }

    /// Whether a disc has parted from a feature by construction at a right angle
    /// to the normal.
    #[inline]
    fn skims(&self, disc: usize, feature: Feature) -> bool {
        let skims = |disc: usize, feature| {
            let body = &self.world.discs[disc];
            !body.is_movable()
                || S::Pull::of(&self.world.pulls, disc).skims() && body.last == Some(feature)
        };
        let other = match feature {
            Feature::Disc(other) => skims(other as usize, Feature::Disc(disc as u32)),
            Feature::Wall(_) | Feature::Corner(_) => true,
        };
        !S::IS_STRAIGHT && other && skims(disc, feature)
    }

    /// What can quickly be told of that.
    #[inline]
    pub(super) fn glance(&self, disc: usize, obstacle: Obstacle) -> Glance {
        if self.contact(disc, obstacle).is_some() {
            return Glance::Open;
        }
        match obstacle {
            Obstacle::Disc(other) => {
                let (early, late) = self.in_order(disc, other);
                S::glance_at_discs(&self.approach(early, late))
            }
            Obstacle::Wall(wall) => self.world.glance_at_wall(disc, &self.since[disc], wall),
        }
    }

    /// Two discs, the one that changed later last.
    #[inline]
    fn in_order(&self, disc: usize, other: usize) -> (usize, usize) {
        if self.turn[disc] < self.turn[other] {
            (disc, other)
        } else {
            (other, disc)
        }
    }

    #[inline]
    fn approach(&self, early: usize, late: usize) -> Approach<'_, S> {
        Approach {
            early: self.flight(early),
            late: self.flight(late),
            together: self.moment[early] == self.moment[late],
        }
    }

    #[inline]
    fn meet_disc(&self, disc: usize, other: usize) -> Result<Option<Meeting<S>>, S::Doubt> {
        let (early, late) = self.in_order(disc, other);
        let approach = self.approach(early, late);
        check_order(&approach)?;
        let met = S::meet_discs(&approach)?;
        let feature = Feature::Disc(other as u32);
        Ok(met.map(|met| self.meeting(late, met, feature)))
    }

    fn meet_wall(&self, disc: usize, wall: usize) -> Result<Option<Meeting<S>>, S::Doubt> {
        let met = self.world.meet_wall(disc, &self.since[disc], wall)?;
        Ok(self.meeting_at_wall(disc, wall, met))
    }

    #[inline]
    fn meeting_at_wall(
        &self,
        disc: usize,
        wall: usize,
        met: Option<Met<S::Time>>,
    ) -> Option<Meeting<S>> {
        met.map(|met| {
            let feature = self.world.feature(wall, met.end);
            self.meeting(disc, met, feature)
        })
    }

    /// The meeting of a disc with a feature that it touches and approaches.
    pub(super) fn touching(&self, disc: usize, feature: Feature) -> Meeting<S> {
        self.meeting(disc, Met::at_once(&self.since[disc]), feature)
    }

    /// The impact on a feature that is ahead within these bounds of the time, where
    /// they tell it.
    pub(super) fn ahead(&self, bounds: Interval, feature: Feature) -> Option<Meeting<S>> {
        Some(Meeting {
            time: S::time_within(bounds)?,
            feature,
            graze: false,
            overlap: false,
            inside: false,
            rest: false,
            moment: None,
        })
    }

    /// The meeting with a feature, of which a disc is the one that is known
    /// since the later time.
    #[inline]
    fn meeting(&self, late: usize, met: Met<S::Time>, feature: Feature) -> Meeting<S> {
        Meeting {
            time: met.time,
            feature,
            graze: met.graze,
            overlap: met.overlap,
            inside: met.inside,
            rest: met.rest,
            moment: met.overlap.then_some(self.moment[late]),
        }
    }

    #[inline]
    fn flight(&self, disc: usize) -> Flight<'_, S> {
        self.world.flight(disc, &self.since[disc])
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
        first.time.order(&second.time).or_else(|doubt| {
            let [one, other] = [one, other].map(|(disc, meeting)| Foreseen::meeting(disc, meeting));
            arbiter.order(self, &one, &other, doubt)
        })
    }

    /// Where a disc is at a time, if nothing changes its motion.
    #[inline]
    pub(super) fn position_at(&self, disc: usize, time: &S) -> Vec2<S> {
        S::position_at(self.flight(disc), &S::Time::at(time.clone()))
    }

    /// A disc as it is at a time.
    pub(super) fn disc_at(&self, disc: usize, time: &S) -> Disc<S> {
        let flight = self.flight(disc);
        let time = S::Time::at(time.clone());
        Disc {
            position: S::position_at(flight, &time),
            velocity: S::velocity_at(flight, &time),
            ..flight.disc.clone()
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

    /// What of an obstacle a disc touches by construction. A wall that it
    /// overlaps it may touch besides at an end, which another wall shares.
    #[inline]
    pub(super) fn contact(&self, disc: usize, obstacle: Obstacle) -> Option<Feature> {
        let contact = self.world.contact(disc, obstacle);
        contact.filter(|feature| {
            let is_corner = !S::ROUNDS && matches!(feature, Feature::Corner(_));
            !(is_corner && self.overlaps(disc, obstacle, &self.since[disc]))
        })
    }

    /// Whether a disc and an obstacle are proven to overlap at a time.
    pub(super) fn overlaps(&self, disc: usize, obstacle: Obstacle, time: &S) -> bool {
        matches!(self.gap(disc, obstacle, time), Ok((Ordering::Less, _)))
    }

    /// The contact of a disc and a feature that have been brought to a time,
    /// and that may overlap.
    pub(super) fn cluster_contact(
        &self,
        disc: usize,
        feature: Feature,
        time: &S,
        overlap: bool,
    ) -> Result<ClusterContact<S>, S::Doubt> {
        let place = self.place(disc, feature, time, overlap);
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
    pub(super) fn bring(&mut self, disc: usize, time: &S::Time, moment: u64, turn: u64) {
        if self.moment[disc] != moment {
            self.world.advance_disc(disc, &self.since[disc], time);
            self.since[disc] = time.value();
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

/// The later turn is the later time, unless the two discs changed in impacts so
/// close that none had to be proven the first. Then they must be apart, by more
/// than they move in between.
#[inline]
fn check_order<S: Kernel>(approach: &Approach<'_, S>) -> Result<(), S::Doubt> {
    if S::ROUNDS || approach.together {
        return Ok(());
    }
    let Err(doubt) = approach.early.since.compare(approach.late.since) else {
        return Ok(());
    };
    let (offset, reach) = (approach.offset(), approach.reach());
    match S::power(&offset.x, &offset.y, &reach).sign()? {
        Ordering::Greater => Ok(()),
        _ => Err(doubt),
    }
}

impl Flights<Interval> {
    /// Takes over a disc's motion from flights that these are the bounds of.
    pub(super) fn follow<S: Kernel>(&mut self, disc: usize, flights: &Flights<S>) {
        self.world.discs[disc] = flights.world.discs[disc].map(S::hull);
        self.since[disc] = flights.since[disc].hull();
        self.moment[disc] = flights.moment[disc];
        self.turn[disc] = flights.turn[disc];
    }

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
