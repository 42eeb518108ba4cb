//! Impacts, and what the log says of one.

use std::cmp::Ordering;

use crate::arithmetic::Arithmetic;
use crate::body::{Disc, End, Feature, Pair};
use crate::kernel::Kernel;
use crate::respond::Normal;
use crate::scalar::Scalar;
use crate::vec2::Vec2;
use crate::world::{Corner, World};

/// An impact, as it is logged (P3.4).
#[derive(Clone, Debug)]
pub struct Impact<S> {
    /// When it happens: for a frame algorithm on the clock of the pair's
    /// first body.
    pub time: S,
    /// The name of the time: impacts with the same name are simultaneous.
    pub moment: Option<u64>,
    /// The time on the other body's clock, where that differs.
    pub other_time: Option<S>,
    /// The two bodies.
    pub pair: Pair,
    /// The wall's end point that is hit, if it is one.
    pub end: Option<End>,
    /// In a periodic scene, which copy of the second body the first one meets: so many
    /// cells further on.
    pub image: Option<Box<[i64; 2]>>,
    /// The number of the group of impacts proven to be simultaneous.
    pub tie: Option<u32>,
    /// The frame and the pass in which a frame algorithm found it.
    pub step: Option<Step>,
    /// The circumstances, unless they are of no interest.
    pub contact: Option<Contact<S>>,
}

impl<S> Impact<S> {
    /// An impact of two bodies, of which no more is told.
    pub(crate) fn new(time: S, (pair, end): (Pair, Option<End>), contact: Contact<S>) -> Self {
        Self {
            time,
            moment: None,
            other_time: None,
            pair,
            end,
            image: None,
            tie: None,
            step: None,
            contact: Some(contact),
        }
    }
}

/// Where in its run a frame algorithm found an impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Step {
    /// The frame, from zero on.
    pub frame: u64,
    /// The pass (or the sub-step) within the frame, from one on.
    pub pass: u32,
}

/// How two bodies touch, and what becomes of them.
#[derive(Clone, Debug)]
pub struct Contact<S> {
    /// Along the line on which they touch: of two discs from the first centre
    /// to the second one.
    pub normal: Vec2<S>,
    /// The first body's centre.
    pub centre: Vec2<S>,
    /// The first body's velocity after the impact.
    pub velocity: Vec2<S>,
    /// The other body's velocity after the impact, unless it is a wall.
    pub other_velocity: Option<Vec2<S>>,
}

impl<S: Arithmetic> Impact<S> {
    /// The impact in as little memory as so many digits of its numbers take.
    pub(crate) fn shortened(self, digits: u32) -> Self {
        let shortened = |number: &S| number.clone().shortened(digits);
        let contact = self.contact.map(|contact| contact.map(shortened));
        Self {
            time: self.time.shortened(digits),
            other_time: self.other_time.map(|time| time.shortened(digits)),
            contact,
            ..self
        }
    }
}

impl<S> Impact<S> {
    /// The same impact with numbers made from its own.
    pub(crate) fn map<T>(&self, make: impl Fn(&S) -> T) -> Impact<T> {
        let contact = self.contact.as_ref();
        Impact {
            time: make(&self.time),
            moment: self.moment,
            other_time: self.other_time.as_ref().map(&make),
            pair: self.pair,
            end: self.end,
            image: self.image.clone(),
            tie: self.tie,
            step: self.step,
            contact: contact.map(|contact| contact.map(&make)),
        }
    }
}

impl<S> Contact<S> {
    /// The same contact with numbers made from its own.
    pub(crate) fn map<T>(&self, make: impl Fn(&S) -> T) -> Contact<T> {
        Contact {
            normal: self.normal.map(&make),
            centre: self.centre.map(&make),
            velocity: self.velocity.map(&make),
            other_velocity: self.other_velocity.as_ref().map(|other| other.map(&make)),
        }
    }
}

/// Where two bodies are when they collide. A body of infinite mass that moves
/// is elsewhere in the world, for an impact does not stop it there.
pub(crate) struct Place<S> {
    /// The first disc's centre.
    pub(crate) centre: Vec2<S>,
    /// The other disc's centre; of no account for a wall.
    pub(crate) other: Vec2<S>,
    /// Whether they may overlap, so that their distance is not known by
    /// construction.
    pub(crate) overlap: bool,
}

impl<S: Kernel> World<S> {
    /// Applies the response to the impact of a disc on a feature, and
    /// remembers that they part.
    pub(crate) fn collide(
        &mut self,
        disc: usize,
        feature: Feature,
        place: Place<S>,
    ) -> Result<Contact<S>, S::Doubt> {
        let normal = self.normal(disc, feature, &place);
        let restitution = &self.restitution;
        match feature {
            Feature::Disc(other) => {
                let discs = two(&mut self.discs, disc, other as usize);
                let centres = [&place.centre, &place.other];
                S::collide_discs(discs, centres, &normal, restitution)?;
            }
            Feature::Wall(wall) => {
                let wall = &self.walls[wall as usize].segment;
                S::collide_wall(&mut self.discs[disc], wall, &normal, restitution)?;
            }
            Feature::Corner(corner) => {
                let Corner { wall, end } = self.corners[corner as usize];
                let corner = self.walls[wall as usize].segment.end(end);
                let places = [&place.centre, corner];
                S::collide_point(&mut self.discs[disc], places, &normal, restitution)?;
            }
        }
        Ok(self.part(disc, feature, place.centre, normal.direction))
    }

    /// Notes that a disc and a feature have collided, and part from now on.
    fn part(
        &mut self,
        disc: usize,
        feature: Feature,
        centre: Vec2<S>,
        normal: Vec2<S>,
    ) -> Contact<S> {
        self.remember(disc, feature);
        let other_velocity = match feature {
            Feature::Disc(other) => Some(self.discs[other as usize].velocity.clone()),
            Feature::Wall(_) | Feature::Corner(_) => None,
        };
        Contact {
            normal,
            centre,
            velocity: self.discs[disc].velocity.clone(),
            other_velocity,
        }
    }

    /// The contact of a disc and a feature whose velocities after their
    /// impact are known already.
    pub(crate) fn collided(
        &mut self,
        disc: usize,
        feature: Feature,
        place: Place<S>,
    ) -> Contact<S> {
        let normal = self.normal(disc, feature, &place).direction;
        self.part(disc, feature, place.centre, normal)
    }
}

impl<S: Kernel> World<S> {
    /// The same, where the two are now.
    pub(crate) fn collide_here(
        &mut self,
        disc: usize,
        feature: Feature,
    ) -> Result<Contact<S>, S::Doubt> {
        let other = match feature {
            Feature::Disc(other) => self.discs[other as usize].position.clone(),
            Feature::Wall(_) | Feature::Corner(_) => Vec2::zero(),
        };
        let place = Place {
            centre: self.discs[disc].position.clone(),
            other,
            overlap: true,
        };
        self.collide(disc, feature, place)
    }

    /// The line on which a disc touches a feature.
    pub(crate) fn normal(&self, disc: usize, feature: Feature, place: &Place<S>) -> Normal<S> {
        let radius = &self.discs[disc].radius;
        let (target, reach) = match feature {
            Feature::Wall(wall) => {
                let segment = &self.walls[wall as usize].segment;
                let squared = segment.length_squared.clone();
                let direction = segment.along.perpendicular();
                return Normal { direction, squared };
            }
            Feature::Corner(corner) => (self.corner_position(corner), radius.clone()),
            Feature::Disc(other) => {
                let other = &self.discs[other as usize];
                (&place.other, radius.clone() + &other.radius)
            }
        };
        let direction = target.minus(&place.centre);
        if place.overlap {
            Normal::at_overlap(direction)
        } else {
            Normal::at_contact(direction, &reach)
        }
    }

    /// Forgets that a disc parts from a wall or a corner that it overlaps: it
    /// may still come upon other walls that end there.
    pub(crate) fn forget(&mut self, disc: usize, feature: Feature) {
        if !matches!(feature, Feature::Disc(_)) {
            self.discs[disc].last = None;
        }
    }

    /// Remembers that a disc and a feature part from each other.
    pub(crate) fn remember(&mut self, disc: usize, feature: Feature) {
        self.discs[disc].last = Some(feature);
        if let Feature::Disc(other) = feature {
            self.discs[other as usize].last = Some(Feature::Disc(disc as u32));
        }
    }
}

/// Two different discs.
pub(crate) fn two<S>(discs: &mut [Disc<S>], first: usize, second: usize) -> [&mut Disc<S>; 2] {
    discs
        .get_disjoint_mut([first, second])
        .expect("a disc does not collide with itself")
}

/// Gives each group of consecutive impacts that are proven to be simultaneous
/// a number. Computed times that round prove nothing.
pub fn number_ties<S: Scalar>(impacts: &mut [Impact<S>]) {
    if S::ROUNDS {
        return;
    }
    let mut next = 0;
    for later in 1..impacts.len() {
        let [before, after] = [later - 1, later].map(|index| &impacts[index]);
        let is_named = before.moment.is_some() && before.moment == after.moment;
        if is_named || before.time.compare(&after.time).is_ok_and(Ordering::is_eq) {
            let tie = *impacts[later - 1].tie.get_or_insert_with(|| {
                next += 1;
                next - 1
            });
            impacts[later].tie = Some(tie);
        }
    }
}
