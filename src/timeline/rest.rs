//! Discs that are pressed against something: resting contact.
//!
//! A disc that touches a wall, does not approach it, and is pulled towards it,
//! is held by it: from then on it rests or slides, on a parabola as well, until
//! it collides, or gets to the end of the wall. So is one that an impact without
//! any restitution leaves there; then all this holds by construction.
//!
//! How a disc goes on that is pressed against another disc, or falls around the
//! end of a wall, has no closed form: there the run ends, as if infinitely many
//! impacts followed at once.

use std::cmp::Ordering::Equal;

use super::accumulation::Accumulation;
use super::arbiter::Timed;
use super::forecast::Effort;
use super::{Timeline, Watch};
use crate::body::Feature;
use crate::kernel::{Pull, Time};
use crate::respond::Restitution;
use crate::world::Obstacle;

impl<S: Timed> Timeline<S> {
    /// Follows a disc that comes to rest on what it is forecast to meet, or gets
    /// to the end of what holds it, if it does.
    pub(super) fn rest(&mut self, disc: usize) -> Result<bool, S::Doubt> {
        let Some(forecast) = self.forecasts[disc].take_if(|next| next.is_rest()) else {
            return Ok(false);
        };
        let (Some(meeting), Some(feature)) = (forecast.meeting(), forecast.feature()) else {
            return Ok(false);
        };
        let time = meeting.time.clone().settled(&self.now);
        self.turn += 1;
        let moment = meeting.moment.filter(|_| !S::ROUNDS).unwrap_or(self.turn);
        for changed in self.movable(disc, feature) {
            self.flights.bring(changed, &time, moment, self.turn);
        }
        self.now = time.value();
        if self.has_settled(disc, feature)? {
            self.renew_forecast(disc)?;
        } else {
            self.stop(disc, feature);
        }
        Ok(true)
    }

    /// Whether it is known how a disc goes on that is pressed against a feature.
    fn has_settled(&mut self, disc: usize, feature: Feature) -> Result<bool, S::Doubt> {
        match feature {
            Feature::Wall(wall) => {
                let known = self
                    .flights
                    .world
                    .contact(disc, Obstacle::Wall(wall as usize));
                self.rests += u64::from(known.is_none());
                self.hold(disc, wall as usize).map(|()| true)
            }
            Feature::Corner(corner) if self.flights.world.pulls[disc].is_held() => {
                self.slide_off(disc, corner)
            }
            Feature::Corner(_) | Feature::Disc(_) => Ok(false),
        }
    }

    fn hold(&mut self, disc: usize, wall: usize) -> Result<(), S::Doubt> {
        let world = &mut self.flights.world;
        world.pulls[disc].rest_on(&mut world.discs[disc], wall, &world.walls)?;
        world.join(disc, Feature::Wall(wall as u32));
        Ok(())
    }

    fn slide_off(&mut self, disc: usize, corner: u32) -> Result<bool, S::Doubt> {
        let world = &mut self.flights.world;
        let point = world.corner_position(corner).clone();
        let flies = world.pulls[disc].slide_off(&world.discs[disc], &point)?;
        world.discs[disc].last = Some(Feature::Corner(corner));
        world.contacts.leave(disc, |_| false);
        Ok(flies)
    }

    fn renew_forecast(&mut self, disc: usize) -> Result<(), S::Doubt> {
        self.grazed.clear(disc);
        self.parted.clear(disc);
        self.forecaster.update(&self.flights, disc);
        self.forecast(disc, Effort::Bounds)
    }

    /// Ends the run at this time.
    fn stop(&mut self, disc: usize, feature: Feature) {
        let (pair, _) = self.flights.world.names(disc, feature);
        let found = Accumulation {
            limit: [self.now.clone(), self.now.clone()],
            proven: !S::ROUNDS,
            word: vec![pair],
        };
        self.watch = Some(Watch::ended(found));
    }

    /// After the impact of a disc on a feature nothing holds the discs any more
    /// that it has changed, unless it has taken all of their speed.
    pub(super) fn let_go(
        &mut self,
        changed: [Option<usize>; 2],
        disc: usize,
        feature: Feature,
    ) -> Result<(), S::Doubt> {
        if let Feature::Wall(wall) = feature
            && self.is_dead()
        {
            self.hold(disc, wall as usize)?;
            self.rests += u64::from(self.flights.world.pulls[disc].is_held_by(wall as usize));
            return Ok(());
        }
        for disc in changed.into_iter().flatten() {
            self.flights.world.pulls[disc].let_go();
        }
        Ok(())
    }

    /// Whether impacts on walls take all of the normal speed.
    fn is_dead(&self) -> bool {
        match &self.flights.world.restitution {
            Restitution::Newton {
                walls,
                elastic_below: None,
                ..
            } => matches!(walls.sign(), Ok(Equal)),
            _ => false,
        }
    }
}
