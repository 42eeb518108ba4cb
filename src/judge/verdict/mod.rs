//! The log of another program, held against what truly happens.
//!
//! Only the order counts, disc by disc: impacts that share no disc commute. The log is
//! judged up to the first impact that is not the true one, for what comes after that is
//! the course of another scene. A difference is not blamed where
//!
//! - it depends on a convention: how simultaneous impacts that share a disc are
//!   resolved ([`convention`]), or whether a tangent pass is an impact;
//! - binary64 cannot carry the order so far ([`carry`]), or what decides it is closer
//!   than binary64 resolves there ([`margin`]).
//!
//! A program that reports contacts, step by step, is not taken to claim as many
//! collisions ([`fold`]).

mod carry;
mod convention;
mod fold;
mod margin;

use std::ops::ControlFlow;

use super::difference::{Difference, first_difference};
use super::matching::compare_frame;
use super::tally::Logged;
use crate::impact::Impact;
use crate::run::{Options, Outcome, Progress, Status, run};
use crate::scalar::{Exact, Number, Scalar};
use crate::scene::Scene;
use crate::simulation::Algorithm;
use crate::support::Unsupported;
use carry::Carry;

pub use margin::{Decision, Margin};

/// How a log stands to the truth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "json",
    derive(serde::Serialize),
    serde(rename_all = "kebab-case")
)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub enum Standing {
    /// It follows the truth to the end.
    Follows,
    /// It differs from where on a rule for simultaneous impacts counts.
    Simultaneous,
    /// It differs by a tangent pass, which touches and does not collide.
    Tangent,
    /// It differs where binary64 no longer carries the order.
    Beyond,
    /// It differs by what is closer than binary64 resolves.
    Close,
    /// It differs, and nothing excuses that.
    Differs,
}

/// What the judgement of a log comes to.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// How it stands to the truth.
    pub standing: Standing,
    /// The first impact of a disc that is not the true one.
    pub difference: Option<Difference>,
    /// Which of the true impacts it should have been, by its place.
    pub missed: Option<usize>,
    /// How close the decision was in which the two differ, where that is known and of
    /// account.
    pub margin: Option<Margin>,
    /// How many of the true impacts before the difference it has.
    pub matched: u64,
    /// The largest error of their times.
    pub time_error: f64,
    /// The same in ulps of the true time.
    pub time_error_ulps: f64,
    /// How many lines only tell again of a contact.
    pub repeats: usize,
}

/// What truly happens in a scene, to hold logs against.
#[derive(Debug)]
pub struct Reference<'a> {
    scene: &'a Scene,
    outcome: Outcome<Exact>,
    impacts: Vec<Logged>,
    carry: Carry,
    end: Number,
}

impl<'a> Reference<'a> {
    /// Finds the truth, and how far binary64 follows it. The options are those of the
    /// run; `watch` is told of its progress.
    ///
    /// # Errors
    ///
    /// The scene asks for something that cannot be simulated.
    pub fn find(
        scene: &'a Scene,
        options: &Options,
        watch: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, Unsupported> {
        let outcome = run::<Exact>(scene, Algorithm::Timeline, options, watch)?;
        let impacts: Vec<_> = outcome.impacts.iter().map(Logged::from).collect();
        let carry = Carry::find(scene, options, &impacts);
        Ok(Self {
            scene,
            outcome,
            impacts,
            carry,
            end: Number::try_from(options.end_of(scene)).expect("times are of the size of numbers"),
        })
    }

    /// The true impacts, in order.
    pub fn impacts(&self) -> &[Impact<Exact>] {
        &self.outcome.impacts
    }

    /// The exact run.
    pub fn outcome(&self) -> &Outcome<Exact> {
        &self.outcome
    }

    /// How the exact run ended; only up to there is anything known.
    pub fn status(&self) -> &Status {
        &self.outcome.status
    }

    /// The time up to which the truth is known.
    pub fn reached(&self) -> f64 {
        match self.outcome.status {
            Status::Complete => f64::INFINITY,
            _ => self.outcome.time.to_f64(),
        }
    }

    /// Judges a log, in its order, as far as the truth is known.
    pub fn judge(&self, log: &[Logged]) -> Verdict {
        let (mut log, repeats) = fold::fold(self.scene, log);
        log.retain(|impact| impact.time < self.reached());
        let difference = first_difference(&self.impacts, &log);
        let tally = compare_frame(self.followed(difference.as_ref()), &log);
        let margin = difference.as_ref().and_then(|next| {
            let bits = self.outcome.precision;
            margin::Question::new(self.scene, &self.end, bits, next).margin(&self.carry)
        });
        let standing = self.standing(difference.as_ref(), margin.as_ref());
        let decides = !matches!(standing, Standing::Simultaneous | Standing::Beyond);
        let margin = margin.filter(|_| decides);
        Verdict {
            standing,
            missed: difference.as_ref().and_then(|next| self.missed(next)),
            margin,
            matched: tally.matched,
            time_error: tally.time_error,
            time_error_ulps: tally.time_error_ulps,
            repeats,
            difference,
        }
    }

    fn standing(&self, difference: Option<&Difference>, margin: Option<&Margin>) -> Standing {
        let Some(difference) = difference else {
            return Standing::Follows;
        };
        if convention::depends_on_rule(&self.impacts, difference) {
            return Standing::Simultaneous;
        }
        match margin {
            Some(margin) if margin.is_tangent() => Standing::Tangent,
            _ if difference.time >= self.carry.horizon => Standing::Beyond,
            Some(margin) if margin.is_close() => Standing::Close,
            _ => Standing::Differs,
        }
    }

    /// The true impacts before a difference.
    fn followed(&self, difference: Option<&Difference>) -> &[Logged] {
        let Some(difference) = difference else {
            return &self.impacts;
        };
        let end = difference.truth.map_or(difference.time, |(_, time)| time);
        let followed = self.impacts.partition_point(|impact| impact.time < end);
        &self.impacts[..followed]
    }

    /// The place of the true impact that a log has not, where it differs.
    fn missed(&self, difference: &Difference) -> Option<usize> {
        let (pair, time) = difference.truth?;
        let is_it = |impact: &Logged| impact.pair == pair && impact.time == time;
        self.impacts.iter().position(is_it)
    }
}

impl Verdict {
    /// Whether a difference is the log's own fault.
    pub fn is_blamed(&self) -> bool {
        self.standing == Standing::Differs
    }
}
