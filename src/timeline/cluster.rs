//! Impacts that are resolved at once: the `reflect` rule.
//!
//! The cluster of an impact is all that touches at its time, from disc to disc:
//! what else is hit at that time, and what only touches. Its discs are brought
//! to that time, [`reflect_cluster`] gives their velocities after, and no two of
//! its bodies meet again before one of them has changed. A cluster that jams,
//! discs without any play between walls, is left to the `sequential` rule.

use std::cmp::Ordering::Equal;

use super::arbiter::{Arbiter, Foreseen, Timed};
use super::forecast::Effort;
use super::{Simultaneous, Timeline};
use crate::body::Feature;
use crate::impact::{Contact, Impact};
use crate::kernel::Time;
use crate::respond::{Reflection, reflect_cluster};
use crate::scalar::Doubt;
use crate::world::Obstacle;

/// What touches at the time of an impact.
struct Cluster<S> {
    trigger: Foreseen,
    time: S,
    contacts: Vec<(usize, Feature)>,
    /// Those where bodies overlap: the one that tells the time may, and walls
    /// that end at one that is a corner.
    overlaps: Vec<(usize, Feature)>,
    /// The discs that may be deflected.
    discs: Vec<usize>,
}

impl<S: Timed> Cluster<S> {
    /// Whether it has a contact of a disc with an obstacle.
    fn holds(&self, timeline: &Timeline<S>, disc: usize, obstacle: Obstacle) -> bool {
        let world = &timeline.flights.world;
        self.contacts.iter().any(|&(first, feature)| {
            let is_it = first == disc && world.is_part_of(feature, obstacle);
            let disc = Obstacle::Disc(disc);
            is_it || obstacle == Obstacle::Disc(first) && world.is_part_of(feature, disc)
        })
    }
}

impl<S: Timed> Timeline<S> {
    /// Resolves the impact that a disc is forecast to have, at once with all
    /// that touches then, if the rule asks for that and anything else does.
    pub(super) fn resolve_at_once(&mut self, disc: usize) -> Result<bool, S::Doubt> {
        if self.rule == Simultaneous::Sequential {
            return Ok(false);
        }
        self.compute(disc)?;
        let next = self.forecasts[disc].as_ref();
        let moment = next.and_then(|next| next.foreseen(disc).moment);
        if moment.is_some_and(|moment| self.jammed.contains(&moment)) {
            return Ok(false);
        }
        let Some(cluster) = self.cluster(disc)? else {
            return Ok(false);
        };
        self.turn += 1;
        let moment = cluster.trigger.moment.filter(|_| !S::ROUNDS);
        let moment = moment.unwrap_or(self.turn);
        self.reflect(&cluster, moment)?;
        Ok(true)
    }

    /// What touches at the time of an impact, if that is more than its bodies.
    fn cluster(&mut self, disc: usize) -> Result<Option<Cluster<S>>, S::Doubt> {
        let next = self.forecasts[disc].as_ref();
        let Some(forecast) = next.filter(|next| !next.is_graze()) else {
            return Ok(None);
        };
        let Some(meeting) = forecast.meeting() else {
            return Ok(None);
        };
        let trigger = forecast.foreseen(disc);
        let is_inside = forecast.is_inside() && self.tells_overlaps(trigger.disc);
        let time = meeting.time.value().not_before(&self.now);
        let mut cluster = Cluster {
            contacts: vec![(trigger.disc, trigger.feature)],
            discs: self.movable(trigger.disc, trigger.feature).collect(),
            overlaps: Vec::new(),
            trigger,
            time,
        };
        let mut place = 0;
        while place < cluster.discs.len() {
            let disc = cluster.discs[place];
            self.add_neighbours(&mut cluster, disc)?;
            place += 1;
        }
        cluster
            .contacts
            .sort_by_key(|&(disc, feature)| self.flights.world.names(disc, feature));
        let overlaps = cluster.contacts.iter().copied().filter(|&(disc, feature)| {
            let is_trigger = (disc, feature) == (trigger.disc, trigger.feature);
            is_trigger && is_inside || self.overlaps_beside(disc, feature, &cluster.time)
        });
        cluster.overlaps = overlaps.collect();
        Ok((cluster.contacts.len() > 1).then_some(cluster))
    }

    /// Adds what a disc of a cluster touches.
    fn add_neighbours(&mut self, cluster: &mut Cluster<S>, disc: usize) -> Result<(), S::Doubt> {
        let world = &self.flights.world;
        let others = (0..world.discs.len()).filter(|&other| other != disc);
        let walls = (0..world.walls.len()).map(Obstacle::Wall);
        let others = others.map(Obstacle::Disc).chain(walls);
        let others: Vec<_> = others.collect();
        for obstacle in others {
            // Of walls that end at one point, the first has brought it in.
            if cluster.holds(self, disc, obstacle) {
                continue;
            }
            let Some(feature) = self.touched(cluster, disc, obstacle)? else {
                continue;
            };
            let met = Foreseen::new(disc, feature, None);
            cluster.contacts.push((met.disc, met.feature));
            for body in self.movable(disc, feature) {
                if !cluster.discs.contains(&body) {
                    cluster.discs.push(body);
                }
            }
        }
        Ok(())
    }

    /// What of an obstacle a disc touches at the time of a cluster.
    fn touched(
        &mut self,
        cluster: &Cluster<S>,
        disc: usize,
        obstacle: Obstacle,
    ) -> Result<Option<Feature>, S::Doubt> {
        let is_brought = cluster.trigger.moment == Some(self.flights.moment_of(disc));
        let contact = self.flights.world.contact(disc, obstacle);
        if let Some(feature) = contact.filter(|_| is_brought) {
            return Ok(Some(feature));
        }
        if self.forecaster.are_apart(disc, obstacle, &cluster.time) {
            return Ok(None);
        }
        let gap = self.flights.gap(disc, obstacle, &cluster.time);
        let gap = gap.or_else(|doubt| {
            let doubt = doubt.asking(|| obstacle.ask(disc, "touch"));
            let (flights, trigger) = (&self.flights, &cluster.trigger);
            self.arbiter.gap(flights, trigger, disc, obstacle, doubt)
        });
        gap.map(|(gap, feature)| (gap == Equal).then_some(feature))
    }

    /// Brings a cluster to its time and resolves it; if it jams, what touches
    /// then is left to the sequential rule.
    fn reflect(&mut self, cluster: &Cluster<S>, moment: u64) -> Result<(), S::Doubt> {
        let Cluster {
            time,
            contacts,
            discs,
            ..
        } = cluster;
        for &disc in discs {
            let time = S::Time::at(time.clone());
            self.flights.bring(disc, &time, moment, self.turn);
        }
        let touching = contacts
            .iter()
            .filter(|contact| !cluster.overlaps.contains(contact));
        for &(disc, feature) in touching {
            self.flights.world.join(disc, feature);
        }
        let touching = contacts.iter().map(|&(disc, feature)| {
            let overlap = cluster.overlaps.contains(&(disc, feature));
            self.flights.cluster_contact(disc, feature, time, overlap)
        });
        let touching = touching.collect::<Result<Vec<_>, _>>()?;
        let world = &mut self.flights.world;
        let reflection = reflect_cluster(&mut world.discs, &touching, &world.restitution);
        let reflection =
            reflection.map_err(|doubt| doubt.asking(|| self.ask_who_parts(contacts)))?;
        let parted = match reflection {
            Reflection::Parted(struck) => Some(struck),
            Reflection::Jammed => {
                self.jammed.insert(moment);
                None
            }
        };
        if let Some(struck) = &parted {
            self.arbiter
                .note_cluster(&cluster.trigger, contacts, discs, moment);
            for &place in struck {
                let (disc, feature) = contacts[place];
                let normal = touching[place].normal.direction.clone();
                self.log(disc, feature, normal, (time, moment));
                if cluster.overlaps.contains(&(disc, feature)) {
                    self.flights.world.forget(disc, feature);
                }
            }
            self.part(cluster);
            self.now = time.clone();
        }
        for &disc in discs {
            self.forecaster.update(&self.flights, disc);
        }
        for &disc in discs {
            self.forecast(disc, Effort::Bounds)?;
        }
        Ok(())
    }

    fn ask_who_parts(&self, contacts: &[(usize, Feature)]) -> String {
        let (disc, feature) = contacts[0];
        let pair = self.flights.world.names(disc, feature).0;
        let others = contacts.len() - 1;
        format!("how {pair} and {others} other pairs part that touch at that time")
    }

    /// Puts one impact of a cluster aside, to be told in its turn.
    fn log(
        &mut self,
        disc: usize,
        feature: Feature,
        normal: crate::vec2::Vec2<S>,
        (time, moment): (&S, u64),
    ) {
        let place = self.flights.place(disc, feature, time, false);
        let world = &mut self.flights.world;
        world.remember(disc, feature);
        let names = world.names(disc, feature);
        let contact = Contact {
            normal,
            centre: place.centre,
            velocity: world.discs[disc].velocity.clone(),
            other_velocity: match feature {
                Feature::Disc(other) => Some(world.discs[other as usize].velocity.clone()),
                Feature::Wall(_) | Feature::Corner(_) => None,
            },
        };
        self.pending.push_back(Impact {
            moment: Some(moment),
            ..Impact::new(time.clone(), names, contact)
        });
        self.part_nested(disc, feature, time);
    }

    /// Remembers that the bodies of a cluster do not meet again as they move
    /// now: none of its contacts approaches.
    fn part(&mut self, cluster: &Cluster<S>) {
        for &disc in &cluster.discs {
            self.grazed.clear(disc);
            self.parted.clear(disc);
        }
        let lasts = |&(disc, feature): &(usize, Feature)| {
            matches!(feature, Feature::Disc(_)) || !cluster.overlaps.contains(&(disc, feature))
        };
        for &(disc, feature) in cluster.contacts.iter().filter(|contact| lasts(contact)) {
            let turn = self.flights.turn_of(feature);
            self.parted.add(disc, feature, turn);
            if let Feature::Disc(other) = feature {
                let turn = self.flights.starts[disc].turn;
                self.parted
                    .add(other as usize, Feature::Disc(disc as u32), turn);
            }
        }
    }
}
