//! When and where discs in flight meet what.

use std::cmp::Ordering;

use super::arbiter::{Arbiter, Foreseen, Timed};
use super::flight::Flights;
use crate::body::{End, Feature, Wall};
use crate::kernel::{Approach, Glance, Kernel, Met, Pull, Time};
use crate::scalar::Interval;
use crate::world::Obstacle;

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
            if !self.skims(disc, feature) && self.approaches(disc, feature)? {
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

    /// Whether a disc moves towards a feature that it touches where it is.
    fn approaches(&self, disc: usize, feature: Feature) -> Result<bool, S::Doubt> {
        let place = self.place(disc, feature, &self.starts[disc].since, true);
        self.world.approaches(disc, feature, &place.other)
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
            Obstacle::Wall(wall) => self
                .world
                .glance_at_wall(disc, &self.starts[disc].since, wall),
        }
    }

    /// Two discs, the one that changed later last.
    #[inline]
    fn in_order(&self, disc: usize, other: usize) -> (usize, usize) {
        if self.starts[disc].turn < self.starts[other].turn {
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
            // Where results round, a wait of zero comes to the same.
            together: !S::ROUNDS && self.moment_of(early) == self.moment_of(late),
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
        let met = self.world.meet_wall(disc, &self.starts[disc].since, wall)?;
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
        self.meeting(disc, Met::at_once(&self.starts[disc].since), feature)
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
            moment: met.overlap.then(|| self.moment_of(late)),
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
        first.time.order(&second.time).or_else(|doubt| {
            let [one, other] = [one, other].map(|(disc, meeting)| Foreseen::meeting(disc, meeting));
            arbiter.order(self, &one, &other, doubt)
        })
    }
}

/// The later turn is the later time, unless the two discs changed in impacts so
/// close that none had to be proven the first. Then they must be apart, by more
/// than they move in between.
#[inline]
pub(super) fn check_order<S: Kernel>(approach: &Approach<'_, S>) -> Result<(), S::Doubt> {
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
