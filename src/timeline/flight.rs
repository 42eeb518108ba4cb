//! Bodies in flight, each kept at the time of its own last impact.

use std::cmp::Ordering;

use prefetch_index::prefetch_index;

use crate::body::{Disc, Feature};
use crate::detect::{gap_circle, gap_segment};
use crate::impact::Place;
use crate::kernel::{Flight, Kernel, Time};
use crate::respond::ClusterContact;
use crate::scalar::{Interval, Scalar};
use crate::vec2::Vec2;
use crate::world::{Obstacle, World};

/// The bodies, and when each of them was where `world` says.
#[derive(Clone, Debug)]
pub struct Flights<S: Kernel> {
    pub(super) world: World<S>,
    pub(super) starts: Vec<Start<S>>,
    /// The names of these times: equal names are equal times, also where the arithmetic
    /// could not prove it.
    moments: Vec<u64>,
}

/// When a body was changed last.
#[derive(Clone, Debug)]
pub(super) struct Start<S> {
    /// The time at which it is where the world says.
    pub(super) since: S,
    /// The turn.
    pub(super) turn: u64,
}

impl<S> Start<S> {
    fn map<T>(&self, make: impl Fn(&S) -> T) -> Start<T> {
        Start {
            since: make(&self.since),
            turn: self.turn,
        }
    }
}

impl<S: Kernel> Flights<S> {
    pub(super) fn new(world: World<S>) -> Self {
        let count = world.discs.len();
        let start = Start {
            since: S::from_integer(0),
            turn: 0,
        };
        Self {
            world,
            starts: vec![start; count],
            moments: vec![0; count],
        }
    }

    pub(super) fn hull(&self) -> Flights<Interval> {
        Flights {
            world: self.world.hull(),
            starts: self.starts.iter().map(|start| start.map(S::hull)).collect(),
            moments: self.moments.clone(),
        }
    }

    /// Fetches all of a disc into the cache.
    #[inline]
    pub(super) fn fetch(&self, disc: usize) {
        self.fetch_motion(disc);
        prefetch_index(&self.moments, disc);
        self.world.contacts.fetch(disc);
    }

    /// Fetches how a disc moves.
    #[inline]
    pub(super) fn fetch_motion(&self, disc: usize) {
        prefetch_index(&self.world.discs, disc);
        prefetch_index(&self.starts, disc);
    }

    #[inline]
    pub(super) fn flight(&self, disc: usize) -> Flight<'_, S> {
        self.world.flight(disc, &self.starts[disc].since)
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
    pub(super) fn position_brought(&self, disc: usize, time: &S) -> Vec2<S> {
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
        self.moments[disc]
    }

    /// Puts a disc at the start of some motion of it.
    pub(super) fn set(&mut self, disc: usize, body: Disc<S>, since: S, turn: u64) {
        self.world.discs[disc] = body;
        self.start(disc, since, turn);
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
            !(is_corner && self.overlaps(disc, obstacle, &self.starts[disc].since))
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
            Feature::Disc(other) => self.starts[other as usize].turn,
            Feature::Wall(_) | Feature::Corner(_) => 0,
        }
    }

    /// Takes a disc to the time of its impact, at some turn.
    pub(super) fn bring(&mut self, disc: usize, time: &S::Time, moment: u64, turn: u64) {
        let start = &mut self.starts[disc];
        if self.moments[disc] != moment {
            self.world.advance_disc(disc, &start.since, time);
            start.since = time.value();
            self.moments[disc] = moment;
        }
        start.turn = turn;
    }

    /// Puts a disc where its impact at a time leaves it; one that no impact
    /// changes stays as it is.
    pub(super) fn land(&mut self, disc: usize, after: Disc<S>, time: &S, turn: u64) {
        if !after.is_movable() {
            return;
        }
        let before = std::mem::replace(&mut self.world.discs[disc], after);
        self.world.leave_contacts(disc, &before.velocity);
        self.start(disc, time.clone(), turn);
    }

    /// Notes that a disc is where the world says at a time that a turn gives its name.
    fn start(&mut self, disc: usize, since: S, turn: u64) {
        self.starts[disc] = Start { since, turn };
        self.moments[disc] = turn;
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
        discs.chain(self.starts.iter_mut().map(|start| &mut start.since))
    }
}

impl Flights<Interval> {
    /// Takes over a disc's motion from flights that these are the bounds of.
    pub(super) fn follow<S: Kernel>(&mut self, disc: usize, flights: &Flights<S>) {
        self.world.discs[disc] = flights.world.discs[disc].map(S::hull);
        self.starts[disc] = flights.starts[disc].map(S::hull);
        self.moments[disc] = flights.moments[disc];
    }

    /// A time before which a disc and an obstacle do not touch: of two discs
    /// the gap between them, divided by their relative speed, from where they
    /// are.
    pub(super) fn apart_until(&self, disc: usize, obstacle: Obstacle) -> f64 {
        let since = &self.starts[disc].since;
        let Obstacle::Disc(other) = obstacle else {
            return since.lo();
        };
        let start = if since.lo() < self.starts[other].since.lo() {
            self.starts[other].since
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
