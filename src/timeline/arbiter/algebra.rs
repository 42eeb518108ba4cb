//! The arbiter of exact numbers: symmetry, then algebra.

use std::cmp::Ordering::{self, Equal};

use super::history::{Cause, History};
use super::images::Images;
use super::replay::Replay;
use super::{Arbiter, Foreseen};
use crate::algebra::{Expression, Limits};
use crate::body::Feature;
use crate::scalar::{Exact, Interval, Scalar, Undecided};
use crate::symmetry::Symmetry;
use crate::timeline::flight::Flights;
use crate::timeline::meeting::Meeting;
use crate::vec2::Vec2;
use crate::world::{Obstacle, World};

/// Decides by symmetry and by algebra.
#[derive(Clone, Debug)]
pub struct Algebra {
    history: History,
    images: Images,
    /// None if some number of the world is only enclosed, or if the questions
    /// turned out to be none for algebra.
    replay: Option<Replay>,
    /// How many questions were.
    vain: u32,
    /// The names of the times at which the discs' legs begin.
    moments: Vec<u64>,
    /// The speed of the fastest disc at the start.
    fastest: f64,
}

impl Arbiter<Exact> for Algebra {
    fn new(world: &World<Exact>, symmetries: &[Symmetry]) -> Self {
        let discs = world.discs.len();
        let speeds = world.discs.iter().map(|disc| size(&disc.velocity));
        Self {
            fastest: speeds.fold(0.0, f64::max),
            history: History::new(discs),
            images: Images::new(symmetries.to_vec()),
            replay: Replay::new(world),
            vain: 0,
            moments: vec![0; discs],
        }
    }

    fn note(&mut self, met: &Foreseen, changed: [Option<usize>; 2], moment: u64) {
        let cause = self.cause(met);
        let leg = self.history.note(cause, changed);
        self.images.note(cause, leg);
        for disc in changed.into_iter().flatten() {
            self.moments[disc] = moment;
        }
    }

    fn note_cluster(
        &mut self,
        trigger: &Foreseen,
        contacts: &[(usize, Feature)],
        changed: &[usize],
        moment: u64,
    ) {
        let trigger = self.cause(trigger);
        let cause = |&(disc, feature): &(usize, Feature)| self.history.cause(disc, feature, false);
        let contacts = contacts.iter().map(cause).collect();
        let cluster = self.history.note_cluster(trigger, contacts, changed);
        self.images.note_cluster(cluster);
        for &disc in changed {
            self.moments[disc] = moment;
        }
    }

    fn gap(
        &mut self,
        flights: &Flights<Exact>,
        met: &Foreseen,
        disc: usize,
        obstacle: Obstacle,
        doubt: Undecided,
    ) -> Result<(Ordering, Feature), Undecided> {
        let trigger = self.cause(met);
        let feature = obstacle.whole();
        let cause = self.history.cause(disc, feature, false);
        let replay = self.replay.as_mut();
        let Some(replay) = replay.filter(|_| is_sharp(flights, self.fastest, disc, feature)) else {
            return Err(doubt);
        };
        let gap = replay.gap(&self.history, trigger, cause);
        self.weigh(matches!(gap, Ok((Equal, _))));
        gap.map_err(|open| doubt.after(open))
    }

    fn order(
        &mut self,
        flights: &Flights<Exact>,
        one: &Foreseen,
        other: &Foreseen,
        doubt: Undecided,
    ) -> Result<Ordering, Undecided> {
        let causes = [self.cause(one), self.cause(other)];
        if self.images.are_simultaneous(causes[0], causes[1]) {
            return Ok(Equal);
        }
        let are_sharp = [one, other]
            .iter()
            .all(|met| is_sharp(flights, self.fastest, met.disc, met.feature));
        let replay = self.replay.as_mut().filter(|_| are_sharp);
        let Some(replay) = replay else {
            return Err(doubt);
        };
        let mut time = |cause| replay.time(&self.history, cause);
        let order = time(causes[0]).and_then(|first| first.compare(&time(causes[1])?));
        self.weigh(order == Ok(Equal));
        order.map_err(|open| doubt.after(open))
    }

    fn order_to(
        &mut self,
        flights: &Flights<Exact>,
        one: &Foreseen,
        time: &Exact,
        doubt: Undecided,
    ) -> Result<Ordering, Undecided> {
        let cause = self.cause(one);
        let limit = Expression::from_exact(time, Limits::default());
        let is_sharp = is_sharp(flights, self.fastest, one.disc, one.feature);
        let replay = self.replay.as_mut().filter(|_| is_sharp);
        let (Some(replay), Some(limit)) = (replay, limit) else {
            return Err(doubt);
        };
        let order = replay.time(&self.history, cause);
        let order = order.and_then(|time| time.compare(&limit));
        self.weigh(order == Ok(Equal));
        order.map_err(|open| doubt.after(open))
    }

    fn meet(
        &mut self,
        flights: &Flights<Exact>,
        disc: usize,
        obstacle: Obstacle,
        doubt: Undecided,
    ) -> Result<Option<Meeting<Exact>>, Undecided> {
        let feature = obstacle.whole();
        let replay = self.replay.as_mut();
        let Some(replay) = replay.filter(|_| is_sharp(flights, self.fastest, disc, feature)) else {
            return Err(doubt);
        };
        let cause = self.history.cause(disc, feature, false);
        let met = replay.meet(&self.history, cause);
        // A disc that was brought to a time may be found to touch then.
        let is_brought = |disc: usize| flights.moment_of(disc) != self.moments[disc];
        let touches = is_brought(disc)
            || matches!(feature, Feature::Disc(other) if is_brought(other as usize));
        self.weigh(match &met {
            Ok(Some(meeting)) => meeting.graze || meeting.overlap || touches,
            Ok(None) => true,
            Err(_) => false,
        });
        let met = met.map_err(|open| doubt.after(open))?;
        let moment = flights.moment_of(self.later(disc, feature));
        Ok(met.map(|meeting| adopt(meeting, moment)))
    }

    /// Only where the later of the two has touched since its leg began.
    fn approaches(
        &mut self,
        flights: &Flights<Exact>,
        disc: usize,
        feature: Feature,
        doubt: Undecided,
    ) -> Result<bool, Undecided> {
        let cause = self.history.cause(disc, feature, true);
        let later = self.later(disc, feature);
        let is_here = flights.moment_of(disc) == self.moments[later];
        let replay = self.replay.as_mut();
        match replay.filter(|_| is_here && is_sharp(flights, self.fastest, disc, feature)) {
            Some(replay) => replay
                .approach(&self.history, cause)
                .map_err(|open| doubt.after(open)),
            None => Err(doubt),
        }
    }
}

impl Algebra {
    /// Takes note whether a question was one for algebra: whether something was
    /// zero. Where it is not, more bits decide at less expense; after a few
    /// such questions algebra leaves the next ones to those.
    fn weigh(&mut self, was_tie: bool) {
        self.vain += u32::from(!was_tie);
        if self.vain >= MOST_VAIN {
            self.replay = None;
        }
    }

    /// What collides, and whether it touches already where the later leg
    /// begins.
    fn cause(&self, met: &Foreseen) -> Cause {
        let later = self.later(met.disc, met.feature);
        let at_once = met.moment == Some(self.moments[later]);
        self.history.cause(met.disc, met.feature, at_once)
    }

    /// The body of the two whose leg began later.
    fn later(&self, disc: usize, feature: Feature) -> usize {
        match feature {
            Feature::Disc(other) => {
                let other = other as usize;
                [disc, other][usize::from(self.history.leg(other) > self.history.leg(disc))]
            }
            Feature::Wall(_) | Feature::Corner(_) => disc,
        }
    }
}

/// The questions that algebra may take up in vain.
const MOST_VAIN: u32 = 3;

/// A meeting found by algebra, in enclosures again.
fn adopt(meeting: Meeting<Expression>, moment: u64) -> Meeting<Exact> {
    Meeting {
        time: meeting.time.to_exact(),
        feature: meeting.feature,
        graze: meeting.graze,
        overlap: meeting.overlap,
        inside: meeting.inside,
        rest: meeting.rest,
        moment: meeting.overlap.then_some(moment),
    }
}

/// Whether enclosures of the bodies' motions are so narrow that what they
/// leave open is worth an effort. Where they are not, it is for more bits to
/// decide.
fn is_sharp(flights: &Flights<Exact>, fastest: f64, disc: usize, feature: Feature) -> bool {
    let discs = &flights.world.discs;
    let is_sharp = |disc: usize| {
        let body = &discs[disc];
        is_narrow(&body.position, body.radius.hull().lo()) && is_narrow(&body.velocity, fastest)
    };
    is_sharp(disc) && !matches!(feature, Feature::Disc(other) if !is_sharp(other as usize))
}

/// Whether the bounds of a vector are close together, measured by its length or
/// by another: it may be zero.
fn is_narrow(vector: &Vec2<Exact>, length: f64) -> bool {
    let widths = bounds(vector).map(|bounds| bounds.hi() - bounds.lo());
    widths[0].max(widths[1]) <= size(vector).max(length) * NARROW
}

/// At least the greater of a vector's two coordinates.
fn size(vector: &Vec2<Exact>) -> f64 {
    let sizes = bounds(vector).map(|bounds| bounds.hi().abs().max(bounds.lo().abs()));
    sizes[0].max(sizes[1])
}

fn bounds(vector: &Vec2<Exact>) -> [Interval; 2] {
    [&vector.x, &vector.y].map(Exact::hull)
}

/// A few times the precision of binary64, in which bounds are looked at.
const NARROW: f64 = 16.0 * f64::EPSILON;
