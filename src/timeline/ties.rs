//! Impacts that it took a proof to know as simultaneous.
//!
//! Numbers that are only enclosed do not show it: not the equal times, nor that
//! after the first of the impacts the bodies of the others still touch. So
//! before any of them is resolved, all their bodies are brought to the time
//! that they have in common, and what touches then is remembered.

use super::Timeline;
use super::arbiter::Timed;
use super::forecast::{Effort, Forecast};
use crate::body::Feature;

impl<S: Timed> Timeline<S> {
    /// Brings all bodies whose impacts are simultaneous with the first one to
    /// their contact.
    pub(super) fn gather(&mut self, first: usize) -> Result<(), S::Doubt> {
        let mut tied = std::mem::take(&mut self.tied);
        tied.push(first);
        let Some(time) = self.meeting_of(first).map(|(time, _)| time) else {
            return Ok(());
        };
        self.turn += 1;
        let met: Vec<_> = tied
            .iter()
            .filter_map(|&disc| Some((disc, self.meeting_of(disc)?.1)))
            .collect();
        let mut changed: Vec<_> = met
            .iter()
            .flat_map(|&(disc, feature)| self.movable(disc, feature))
            .collect();
        changed.sort_unstable();
        changed.dedup();
        for &disc in &changed {
            self.flights.bring(disc, &time, self.turn, self.turn);
            self.forecaster.update(&self.flights, disc);
        }
        for (disc, feature) in met {
            self.flights.world.contacts.join(disc, feature);
        }
        for disc in changed {
            self.forecast(disc, Effort::Bounds)?;
        }
        Ok(())
    }

    /// When a disc meets what.
    fn meeting_of(&self, disc: usize) -> Option<(S::Time, Feature)> {
        let meeting = self.forecasts[disc].as_ref().and_then(Forecast::meeting)?;
        Some((meeting.time.clone(), meeting.feature))
    }
}
