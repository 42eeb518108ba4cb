//! Discs that are pressed against something: resting contact.
//!
//! A disc that touches a wall, does not approach it, and is pulled towards it,
//! is held by it: from then on it rests or slides, on a parabola as well, until
//! it collides, or gets to the end of the wall; where another wall goes on in the
//! same line, it slides on. So is one that an impact without
//! any restitution leaves there; then all this holds by construction.
//!
//! How a disc goes on that is pressed against another disc, or falls around the
//! end of a wall, has no closed form: there the run ends, as if infinitely many
//! impacts followed at once.

use std::cmp::Ordering::{self, Equal};

use super::accumulation::Accumulation;
use super::arbiter::Timed;
use super::forecast::{Effort, Forecast};
use super::{Timeline, Watch};
use crate::body::{End, Feature, Wall};
use crate::kernel::{Pull, Time};
use crate::respond::Restitution;
use crate::world::Obstacle;

/// How often each disc may rest or graze at one time: more is taken for no end.
const PAUSES: usize = 16;

impl<S: Timed> Timeline<S> {
    /// Follows a disc that comes to rest on what it is forecast to meet, or gets
    /// to the end of what holds it, if it does.
    pub(super) fn rest(&mut self, disc: usize) -> Result<bool, S::Doubt> {
        let Some(forecast) = self.forecasts[disc].take_if(|next| next.is_rest()) else {
            return Ok(false);
        };
        let Some(feature) = self.arrive(disc, &forecast) else {
            return Ok(false);
        };
        if self.has_settled(disc, feature)? {
            self.renew_forecast(disc)?;
        } else {
            self.stop(disc, feature, !S::ROUNDS);
        }
        Ok(true)
    }

    /// Follows bodies that pass in tangency, up to where they touch: they may come
    /// back to each other.
    pub(super) fn skim(&mut self, disc: usize, forecast: &Forecast<S>) -> Result<(), S::Doubt> {
        let Some(feature) = self.arrive(disc, forecast) else {
            return Ok(());
        };
        self.flights.world.remember(disc, feature);
        for changed in self.movable(disc, feature) {
            self.flights.world.pulls[changed].skim();
        }
        for changed in self.movable(disc, feature) {
            self.renew_forecast(changed)?;
        }
        Ok(())
    }

    /// Takes bodies to where they are forecast to touch. Tells what the disc
    /// touches there. If that goes on and on at one time, the run ends.
    fn arrive(&mut self, disc: usize, forecast: &Forecast<S>) -> Option<Feature> {
        let (meeting, feature) = (forecast.meeting()?, forecast.feature()?);
        let time = meeting.time.clone().settled(&self.now);
        self.turn += 1;
        let moment = meeting.moment.filter(|_| !S::ROUNDS).unwrap_or(self.turn);
        for changed in self.movable(disc, feature) {
            self.flights.bring(changed, &time, moment, self.turn);
        }
        if !meeting.overlap {
            self.flights.world.touch_wall(disc, feature);
        }
        let before = std::mem::replace(&mut self.now, time.value());
        let stays = self.now.compare(&before).is_ok_and(Ordering::is_eq);
        self.pauses = if stays { self.pauses + 1 } else { 0 };
        if self.pauses > PAUSES * self.disc_count() {
            self.stop(disc, feature, false);
        }
        Some(feature)
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

    /// Notes that a wall holds a disc, if it is pulled there.
    fn hold(&mut self, disc: usize, wall: usize) -> Result<(), S::Doubt> {
        let world = &mut self.flights.world;
        world.pulls[disc].rest_on(&mut world.discs[disc], wall, &world.walls)?;
        world.join(disc, Feature::Wall(wall as u32));
        Ok(())
    }

    fn slide_off(&mut self, disc: usize, corner: u32) -> Result<bool, S::Doubt> {
        if let Some(wall) = self.next_wall(disc, corner)? {
            self.flights.world.contacts.leave(disc, |_| false);
            self.flights.world.discs[disc].last = Some(Feature::Wall(wall as u32));
            return self.hold(disc, wall).map(|()| true);
        }
        let world = &mut self.flights.world;
        let point = world.corner_position(corner).clone();
        let flies = world.pulls[disc].slide_off(&world.discs[disc], &point)?;
        world.discs[disc].last = Some(Feature::Corner(corner));
        world.contacts.leave(disc, |_| false);
        Ok(flies)
    }

    /// The wall that goes on in the same line where a disc leaves another one.
    fn next_wall(&self, disc: usize, corner: u32) -> Result<Option<usize>, S::Doubt> {
        let world = &self.flights.world;
        let [Some(holder), _] = world.pulls[disc].holders() else {
            return Ok(None);
        };
        let Wall { segment, corners } = &world.walls[holder];
        let end = if corners[0] == corner {
            End::From
        } else {
            End::To
        };
        for (index, wall) in world.walls.iter().enumerate() {
            if index != holder && segment.goes_on_in(&wall.segment, end)? {
                return Ok(Some(index));
            }
        }
        Ok(None)
    }

    fn renew_forecast(&mut self, disc: usize) -> Result<(), S::Doubt> {
        self.grazed.clear(disc);
        self.parted.clear(disc);
        self.forecaster.update(&self.flights, disc);
        self.forecast(disc, Effort::Bounds)
    }

    /// Ends the run at this time, for a reason that may be proven.
    fn stop(&mut self, disc: usize, feature: Feature, proven: bool) {
        let (pair, _) = self.flights.world.names(disc, feature);
        let found = Accumulation {
            limit: [self.now.clone(), self.now.clone()],
            proven,
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
            && self.is_dead(feature)
        {
            self.hold(disc, wall as usize)?;
        } else {
            self.release(changed);
        }
        if self.is_dead(feature) {
            self.slow(changed, feature);
        }
        Ok(())
    }

    fn release(&mut self, changed: [Option<usize>; 2]) {
        for disc in changed.into_iter().flatten() {
            self.flights.world.pulls[disc].let_go();
        }
    }

    /// Notes of discs that an impact has changed, which took all of the normal
    /// speed, that the feature holds them, or that they move along it.
    fn slow(&mut self, changed: [Option<usize>; 2], feature: Feature) {
        for disc in changed.into_iter().flatten() {
            let pull = &mut self.flights.world.pulls[disc];
            match feature {
                Feature::Wall(wall) if pull.is_held_by(wall as usize) => self.rests += 1,
                _ => pull.skim(),
            }
        }
    }

    /// Whether impacts on a feature take all of the normal speed.
    fn is_dead(&self, feature: Feature) -> bool {
        let kept = match &self.flights.world.restitution {
            Restitution::Newton {
                discs,
                walls,
                elastic_below: None,
            } => match feature {
                Feature::Disc(_) => discs,
                Feature::Wall(_) | Feature::Corner(_) => walls,
            },
            _ => return false,
        };
        matches!(kept.sign(), Ok(Equal))
    }
}
