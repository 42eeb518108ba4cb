//! Impacts that it took a proof to know as simultaneous.
//!
//! Numbers that are only enclosed do not show it: not the equal times, nor that
//! after the first of the impacts the bodies of the others still touch. So
//! before any of them is resolved, all their bodies are brought to the time
//! that they have in common, and what touches then is remembered.

use super::Timeline;
use super::arbiter::Timed;
use super::forecast::{Effort, Forecast};
use super::meeting::Meeting;

impl<S: Timed> Timeline<S> {
    /// Brings all bodies whose impacts are simultaneous with the first one to
    /// their contact. Where some have been brought to that time before, the
    /// others join them, and those stay.
    pub(super) fn gather(&mut self, first: usize) -> Result<(), S::Doubt> {
        let mut tied = std::mem::take(&mut self.tied);
        tied.push(first);
        let met: Vec<_> = tied
            .iter()
            .filter_map(|&disc| Some((disc, self.meeting_of(disc)?)))
            .collect();
        let named = met.iter().find(|(_, meeting)| meeting.moment.is_some());
        let Some((_, Meeting { time, moment, .. })) = named.or(met.last()) else {
            return Ok(());
        };
        self.turn += 1;
        let moment = moment.unwrap_or(self.turn);
        let mut changed: Vec<_> = met
            .iter()
            .flat_map(|(disc, meeting)| self.movable(*disc, meeting.feature))
            .collect();
        changed.sort_unstable();
        changed.dedup();
        for &disc in &changed {
            self.flights.bring(disc, time, moment, self.turn);
            self.forecaster.update(&self.flights, disc);
        }
        for (disc, meeting) in &met {
            self.flights.world.join(*disc, meeting.feature);
        }
        for disc in changed {
            self.forecast(disc, Effort::Bounds)?;
        }
        Ok(())
    }

    /// What a disc meets, and when.
    fn meeting_of(&self, disc: usize) -> Option<Meeting<S>> {
        let meeting = self.forecasts[disc].as_ref().and_then(Forecast::meeting);
        meeting.cloned()
    }
}
