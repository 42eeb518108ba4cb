//! How much of a disc's first meeting is known.

use super::first::meet;
use crate::body::Feature;
use crate::kernel::{Kernel, Time};
use crate::scalar::Interval;
use crate::timeline::arbiter::{Foreseen, Timed};
use crate::timeline::flight::Flights;
use crate::timeline::meeting::Meeting;
use crate::world::Obstacle;

/// The first meeting of a disc.
#[derive(Clone, Debug)]
pub(in crate::timeline) struct Forecast<S: Kernel> {
    /// Binary64 bounds of the time.
    pub(in crate::timeline) bounds: Interval,
    pub(in crate::timeline) outlook: Outlook<S>,
    /// Why another meeting of the same disc could not be proven to be later.
    pub(in crate::timeline) contested: Option<S::Doubt>,
}

/// How much of a disc's first meeting is known.
#[derive(Clone, Debug)]
pub(in crate::timeline) enum Outlook<S: Kernel> {
    /// Only that there is none before the lower bound of the time: it is left
    /// for later to tell the candidates apart.
    Open,
    /// It is the impact on this, after a delay, of which the bounds of the
    /// time have sufficed so far.
    Bounded(Obstacle, Foresight),
    /// Only that there is none before it leaves its neighbours.
    Leaving,
    /// All. Boxed, for most forecasts are made anew before they come true.
    Computed(Box<Meeting<S>>, Foresight),
}

/// What is met, and the partner's turn that this supposes.
#[derive(Clone, Copy, Debug)]
pub(in crate::timeline) struct Foresight {
    pub(in crate::timeline) feature: Feature,
    partner_turn: u64,
}

impl Foresight {
    fn new<S: Kernel>(feature: Feature, flights: &Flights<S>) -> Self {
        Self {
            feature,
            partner_turn: flights.turn_of(feature),
        }
    }
}

impl<S: Kernel> Forecast<S> {
    pub(super) fn open(earliest: f64, horizon: f64) -> Self {
        Self {
            bounds: Interval::new(earliest, horizon),
            outlook: Outlook::Open,
            contested: None,
        }
    }

    pub(super) fn leaving(time: f64) -> Self {
        Self {
            bounds: Interval::new(time, time),
            outlook: Outlook::Leaving,
            contested: None,
        }
    }

    /// Whether it is left for later to tell the candidates apart.
    pub(in crate::timeline) fn is_open(&self) -> bool {
        matches!(self.outlook, Outlook::Open)
    }

    /// Whether it looks no further than to where the disc gets new neighbours.
    pub(in crate::timeline) fn is_leaving(&self) -> bool {
        matches!(self.outlook, Outlook::Leaving)
    }

    pub(super) fn bounded(
        obstacle: Obstacle,
        bounds: Interval,
        feature: Feature,
        flights: &Flights<S>,
    ) -> Self {
        Self {
            bounds,
            outlook: Outlook::Bounded(obstacle, Foresight::new(feature, flights)),
            contested: None,
        }
    }

    pub(super) fn computed(meeting: Meeting<S>, flights: &Flights<S>) -> Self {
        let foresight = Foresight::new(meeting.feature, flights);
        Self {
            bounds: meeting.time.bounds(),
            outlook: Outlook::Computed(Box::new(meeting), foresight),
            contested: None,
        }
    }

    /// What is met, unless that is open.
    #[inline]
    pub(in crate::timeline) fn feature(&self) -> Option<Feature> {
        self.foresight().map(|foresight| foresight.feature)
    }

    #[inline]
    fn foresight(&self) -> Option<Foresight> {
        match &self.outlook {
            Outlook::Open | Outlook::Leaving => None,
            Outlook::Bounded(_, foresight) | Outlook::Computed(_, foresight) => Some(*foresight),
        }
    }

    /// The meeting, if it is computed.
    #[inline]
    pub(in crate::timeline) fn meeting(&self) -> Option<&Meeting<S>> {
        match &self.outlook {
            Outlook::Computed(meeting, _) => Some(meeting),
            Outlook::Open | Outlook::Leaving | Outlook::Bounded(..) => None,
        }
    }

    /// What a disc meets, which must not be open.
    pub(in crate::timeline) fn foreseen(&self, disc: usize) -> Foreseen {
        let feature = self.feature().expect("it is not open what is met");
        let moment = self.meeting().and_then(|meeting| meeting.moment);
        Foreseen::new(disc, feature, moment)
    }

    /// Whether the partner has changed since.
    #[inline]
    pub(in crate::timeline) fn is_stale(&self, flights: &Flights<S>) -> bool {
        let changed =
            |foresight: Foresight| flights.turn_of(foresight.feature) != foresight.partner_turn;
        self.foresight().is_some_and(changed)
    }

    /// Whether the two overlap already, and do not only touch.
    pub(in crate::timeline) fn is_inside(&self) -> bool {
        self.meeting().is_some_and(|meeting| meeting.inside)
    }

    /// Whether the two come to rest on each other then, or part that were.
    #[inline]
    pub(in crate::timeline) fn is_rest(&self) -> bool {
        self.meeting().is_some_and(|meeting| meeting.rest)
    }

    /// Whether the two only pass in tangency.
    #[inline]
    pub(in crate::timeline) fn is_graze(&self) -> bool {
        self.meeting().is_some_and(|meeting| meeting.graze)
    }
}

impl<S: Timed> Forecast<S> {
    /// Computes the meeting of a disc, if bounds have sufficed so far.
    pub(in crate::timeline) fn compute(
        &mut self,
        flights: &Flights<S>,
        disc: usize,
        arbiter: &mut S::Arbiter,
    ) -> Result<(), S::Doubt> {
        if let Outlook::Bounded(obstacle, foresight) = self.outlook {
            let feature = foresight.feature;
            let meeting = impact(flights, disc, (obstacle, feature), self.bounds, arbiter)?;
            self.bounds = meeting.time.bounds();
            self.outlook = Outlook::Computed(Box::new(meeting), foresight);
        }
        Ok(())
    }

    /// The meeting of a disc, which comes true; what is met must not be open.
    pub(in crate::timeline) fn come_true(
        self,
        flights: &Flights<S>,
        disc: usize,
        arbiter: &mut S::Arbiter,
    ) -> Result<Meeting<S>, S::Doubt> {
        match self.outlook {
            Outlook::Bounded(obstacle, Foresight { feature, .. }) => {
                impact(flights, disc, (obstacle, feature), self.bounds, arbiter)
            }
            Outlook::Computed(meeting, _) => Ok(*meeting),
            Outlook::Open | Outlook::Leaving => unreachable!("it is open what is met"),
        }
    }
}

/// The impact of a disc that bounds prove.
fn impact<S: Timed>(
    flights: &Flights<S>,
    disc: usize,
    (obstacle, feature): (Obstacle, Feature),
    bounds: Interval,
    arbiter: &mut S::Arbiter,
) -> Result<Meeting<S>, S::Doubt> {
    if let Some(meeting) = flights.ahead(bounds, feature) {
        return Ok(meeting);
    }
    let met = meet(flights, disc, obstacle, arbiter)?;
    Ok(met.expect("bounds prove that the two meet"))
}
