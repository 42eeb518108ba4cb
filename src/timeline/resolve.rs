//! An impact that comes true.

use super::Timeline;
use super::arbiter::{Arbiter, Foreseen, Timed};
use super::forecast::{Effort, Forecast};
use crate::body::Feature;
use crate::impact::{Contact, Impact};
use crate::kernel::Time;
use crate::world::Obstacle;

impl<S: Timed> Timeline<S> {
    /// Resolves an impact, and forecasts what comes of it.
    pub(super) fn resolve(
        &mut self,
        disc: usize,
        forecast: Forecast<S>,
    ) -> Result<Impact<S>, S::Doubt> {
        self.turn += 1;
        let met = forecast.foreseen(disc);
        let (first, feature) = (met.disc, met.feature);
        // A rounded time may have been lifted: it is none that has a name.
        let named = met.moment.filter(|_| !S::ROUNDS);
        let moment = named.unwrap_or(self.turn);
        let changed = self.changed(first, feature);
        let tells_overlaps = self.tells_overlaps(first);
        self.arbiter.note(&met, changed, moment);
        let is_inside = forecast.is_inside();
        let (time, contact) = match self.leap(&met) {
            Some(leapt) => leapt,
            None => self.walk(disc, forecast, &met, moment)?,
        };
        let inside = tells_overlaps && is_inside || self.overlaps_beside(first, feature, &time);
        let world = &mut self.flights.world;
        if inside {
            world.forget(first, feature);
        } else {
            world.join(first, feature);
        }
        let names = world.names(first, feature);
        self.part_nested(first, feature, &time);
        if !S::IS_STRAIGHT {
            self.let_go(changed, first, feature)?;
        }
        for disc in changed.into_iter().flatten() {
            self.grazed.clear(disc);
            self.parted.clear(disc);
            self.forecaster.update(&self.flights, disc);
        }
        for disc in changed.into_iter().flatten() {
            self.forecast(disc, Effort::Bounds)?;
        }
        self.now = time.clone();
        Ok(Impact {
            moment: Some(moment),
            ..Impact::new(time, names, contact)
        })
    }

    /// Whether an overlap of a disc is none by rounding: it is where the scene
    /// puts it, or nothing rounds.
    pub(super) fn tells_overlaps(&self, disc: usize) -> bool {
        !S::ROUNDS || self.flights.starts[disc].turn == 0
    }

    /// Whether a disc that is at a corner at some time overlaps a wall that ends
    /// there: then it need not part from that. Rounding makes overlaps anywhere.
    pub(super) fn overlaps_beside(&self, disc: usize, feature: Feature, time: &S) -> bool {
        let world = &self.flights.world;
        let mut walls = (0..world.walls.len()).map(Obstacle::Wall);
        !S::ROUNDS
            && matches!(feature, Feature::Corner(_))
            && walls.any(|wall| {
                world.is_part_of(feature, wall) && self.flights.overlaps(disc, wall, time)
            })
    }

    /// Notes that a disc has collided with a feature: where the two do not
    /// overlap, they have parted if they were nested.
    pub(super) fn part_nested(&mut self, disc: usize, feature: Feature, time: &S) {
        let flights = &self.flights;
        let overlaps = |wall| flights.overlaps(disc, Obstacle::Wall(wall), time);
        self.nested.part(&flights.world, disc, feature, overlaps);
    }

    /// Takes the bodies of an impact that is forecast for a disc to its time,
    /// and lets them collide.
    fn walk(
        &mut self,
        disc: usize,
        forecast: Forecast<S>,
        met: &Foreseen,
        moment: u64,
    ) -> Result<(S, Contact<S>), S::Doubt> {
        let meeting = forecast.come_true(&self.flights, disc, &mut self.arbiter)?;
        let (time, overlap) = (meeting.time.settled(&self.now), meeting.overlap);
        let (first, feature) = (met.disc, met.feature);
        for changed in self.movable(first, feature) {
            self.flights.bring(changed, &time, moment, self.turn);
        }
        if !S::IS_STRAIGHT && !overlap {
            self.flights.world.touch_wall(first, feature);
        }
        let time = time.value();
        let place = self.flights.place(first, feature, &time, overlap);
        let contact = self.flights.world.collide(first, feature, place)?;
        Ok((time, contact))
    }

    /// The same in one step, where the arithmetic knows one that is better.
    fn leap(&mut self, met: &Foreseen) -> Option<(S, Contact<S>)> {
        if met.moment.is_some() {
            return None;
        }
        let time = self.flights.leap(met.disc, met.feature, self.turn)?;
        S::rebase(self.flights.numbers());
        let place = self.flights.place(met.disc, met.feature, &time, false);
        let contact = self.flights.world.collided(met.disc, met.feature, place);
        Some((time.bare(), contact.map(S::bare)))
    }
}
