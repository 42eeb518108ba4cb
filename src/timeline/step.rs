//! From the states of two bodies to their impact and past it, as one
//! [`Step`]: the numbers alone, once it is decided that they meet.
//!
//! The physics is that of `detect` and `respond`. What is computed at one
//! place of [`Flights`] and [`World::collide`] in steps of their own is here in
//! one piece, so that an arithmetic can tell how the numbers after an impact
//! depend on those before.
//!
//! [`World::collide`]: crate::world::World

use super::flight::Flights;
use crate::body::{Disc, Feature};
use crate::detect::{Encounter, Segment, meet_circle, meet_segment};
use crate::kernel::Kernel;
use crate::respond::{Normal, Restitution, collide_discs, collide_wall};
use crate::scalar::{Scalar, Step};
use crate::vec2::Vec2;

/// The flight of a disc to its impact, and the impact.
enum Leap {}

/// What collides.
struct Bodies<T> {
    disc: Body<T>,
    obstacle: Target<T>,
    restitution: Restitution<T>,
}

/// A disc, and the time at which it is there.
struct Body<T> {
    disc: Disc<T>,
    since: T,
}

/// What a disc collides with.
enum Target<T> {
    /// A disc that has changed later.
    Disc(Body<T>),
    Wall(Segment<T>),
    Corner(Vec2<T>),
}

/// When bodies collide, and what becomes of them.
struct Collided<T> {
    time: T,
    disc: Disc<T>,
    other: Option<Disc<T>>,
}

impl<T> Body<T> {
    fn map<U>(&self, make: impl Fn(&T) -> U) -> Body<U> {
        Body {
            disc: self.disc.map(&make),
            since: make(&self.since),
        }
    }
}

impl<T: Scalar> Body<T> {
    fn at(&self, time: &T) -> Disc<T> {
        let mut disc = self.disc.clone();
        disc.advance(&(time.clone() - &self.since));
        disc
    }
}

impl Step for Leap {
    type Input<T> = Bodies<T>;
    type Output<T> = Collided<T>;

    fn apply<T: Scalar>(input: &Bodies<T>) -> Result<Option<Collided<T>>, T::Doubt> {
        match &input.obstacle {
            Target::Disc(other) => meet_disc(&input.disc, other, &input.restitution),
            Target::Wall(wall) => meet_wall(&input.disc, wall, &input.restitution),
            Target::Corner(corner) => meet_corner(&input.disc, corner, &input.restitution),
        }
    }

    fn map_input<T, U>(input: &Bodies<T>, make: impl Fn(&T) -> U) -> Bodies<U> {
        Bodies {
            disc: input.disc.map(&make),
            obstacle: match &input.obstacle {
                Target::Disc(body) => Target::Disc(body.map(&make)),
                Target::Wall(segment) => Target::Wall(segment.map(&make)),
                Target::Corner(corner) => Target::Corner(corner.map(&make)),
            },
            restitution: input.restitution.map(&make),
        }
    }

    fn map_output<T, U>(output: &Collided<T>, make: impl Fn(&T) -> U) -> Collided<U> {
        Collided {
            time: make(&output.time),
            disc: output.disc.map(&make),
            other: output.other.as_ref().map(|other| other.map(&make)),
        }
    }
}

/// The time until an impact; none where there is no impact, or no delay.
fn delay<T>(met: Option<Encounter<T>>) -> Option<T> {
    let met = met.filter(|met| !met.graze && !met.overlap)?;
    Some(met.delay)
}

fn meet_disc<T: Scalar>(
    early: &Body<T>,
    late: &Body<T>,
    restitution: &Restitution<T>,
) -> Result<Option<Collided<T>>, T::Doubt> {
    let start = early.at(&late.since);
    let offset = late.disc.position.minus(&start.position);
    let velocity = late.disc.velocity.minus(&start.velocity);
    let reach = early.disc.radius.clone() + &late.disc.radius;
    let Some(delay) = delay(meet_circle(&offset, &velocity, &reach)?) else {
        return Ok(None);
    };
    let time = late.since.clone() + delay;
    let [mut disc, mut other] = [early, late].map(|body| body.at(&time));
    let normal = Normal::at_contact(other.position.minus(&disc.position), &reach);
    collide_discs(&mut disc, &mut other, &normal, restitution)?;
    let other = Some(other);
    Ok(Some(Collided { time, disc, other }))
}

fn meet_wall<T: Scalar>(
    body: &Body<T>,
    wall: &Segment<T>,
    restitution: &Restitution<T>,
) -> Result<Option<Collided<T>>, T::Doubt> {
    let Disc {
        position,
        velocity,
        radius,
        ..
    } = &body.disc;
    let Some(delay) = delay(meet_segment(position, velocity, radius, wall, |_| true)?) else {
        return Ok(None);
    };
    let normal = Normal {
        direction: wall.along.perpendicular(),
        squared: wall.length_squared.clone(),
    };
    reflect(body, delay, |_| normal, restitution).map(Some)
}

fn meet_corner<T: Scalar>(
    body: &Body<T>,
    corner: &Vec2<T>,
    restitution: &Restitution<T>,
) -> Result<Option<Collided<T>>, T::Doubt> {
    let Disc {
        position,
        velocity,
        radius,
        ..
    } = &body.disc;
    let Some(delay) = delay(meet_circle(&position.minus(corner), velocity, radius)?) else {
        return Ok(None);
    };
    let normal = |disc: &Disc<T>| Normal::at_contact(corner.minus(&disc.position), radius);
    reflect(body, delay, normal, restitution).map(Some)
}

fn reflect<T: Scalar>(
    body: &Body<T>,
    delay: T,
    normal: impl FnOnce(&Disc<T>) -> Normal<T>,
    restitution: &Restitution<T>,
) -> Result<Collided<T>, T::Doubt> {
    let mut disc = body.disc.clone();
    disc.advance(&delay);
    let normal = normal(&disc);
    collide_wall(&mut disc, &normal, restitution)?;
    Ok(Collided {
        time: body.since.clone() + delay,
        disc,
        other: None,
    })
}

impl<S: Kernel> Flights<S> {
    /// Takes a disc and what it meets after a delay to their impact and past
    /// it, at some turn, in one step. Gives the time.
    pub(super) fn leap(&mut self, disc: usize, feature: Feature, turn: u64) -> Option<S> {
        let [early, late] = match feature {
            Feature::Disc(other) if self.starts[other as usize].turn <= self.starts[disc].turn => {
                [other as usize, disc]
            }
            Feature::Disc(other) => [disc, other as usize],
            Feature::Wall(_) | Feature::Corner(_) => [disc, disc],
        };
        let collided = S::step::<Leap>(|| Bodies {
            disc: self.body(early),
            obstacle: match feature {
                Feature::Disc(_) => Target::Disc(self.body(late)),
                Feature::Wall(wall) => {
                    Target::Wall(self.world.walls[wall as usize].segment.clone())
                }
                Feature::Corner(corner) => {
                    Target::Corner(self.world.corner_position(corner).clone())
                }
            },
            restitution: self.world.restitution.clone(),
        })?;
        self.land(early, collided.disc, &collided.time, turn);
        if let Some(other) = collided.other {
            self.land(late, other, &collided.time, turn);
        }
        Some(collided.time)
    }

    fn body(&self, disc: usize) -> Body<S> {
        Body {
            disc: self.world.discs[disc].clone(),
            since: self.starts[disc].since.clone(),
        }
    }
}
