//! Contacts of one instant that share discs, resolved at once: generalised
//! reflections (B. Smith, D. Kaufman, E. Vouga, R. Tamstorf, E. Grinspun:
//! Reflections on Simultaneous Impact, ACM Transactions on Graphics 31(4),
//! article 106, 2012).
//!
//! As long as contacts approach, the impulses are found that, at these
//! contacts, take as much energy as they can ([`project`](super::project)),
//! and are applied twice: once takes the velocities v to p, the nearest ones
//! in the metric of the masses of which none of these contacts approaches;
//! twice takes them to v' = 2p - v.
//!
//! - **Energy** is kept, since p and p - v are orthogonal, and so is momentum.
//! - **Symmetry** is kept, since p is unique: no contact comes before another.
//! - **Each of these contacts separates**: it closed (n·v < 0), it does not in
//!   p (n·p ≥ 0), so n·v' > 0. Its sign is known and not computed again before
//!   another impulse reaches one of its discs.
//! - **It ends** after finitely many rounds if the contacts can part all at
//!   once, that is, if velocities z exist for which all of them open. Round by
//!   round |v - z|² falls by at least 4 λ·(n·z): the sum of all impulses is
//!   bounded, and v tends to some v*. Contacts that approach again and again
//!   have n·v* = 0 in the limit, so that the reflections at them keep the
//!   distance from v*. It tends to zero, and so it is zero. Discs alone can
//!   always part: let them go in proportion to their positions. Between walls
//!   or bodies of infinite mass, discs without any play cannot. Some that can
//!   take long: a light disc between a wall and a heavy one that touch it
//!   takes as many rounds as Galperin's count of digits of π. Rounds are
//!   therefore counted, up to [`MAX_ROUNDS`]. (On the end of such methods in
//!   general: E. Vouga and others: All's Well That Ends Well, ACM Transactions
//!   on Graphics 36(4), article 151, 2017.)
//!
//! **Losses.** To damp each round would not end: in a row of touching discs,
//! ever smaller impulses would run to and fro. So the two extremes are blended:
//! with p₀ the nearest velocities of which *no* contact of the cluster
//! approaches, and v' the end of the elastic rounds, the end is
//! p₀ + e (v' - p₀). It is symmetric, keeps momentum, does not gain energy, and
//! no contact approaches, since all of this holds for p₀ and for v'. The
//! coefficient e is the least that applies to any contact that approached in
//! some round, at the speed that it had then: so a cluster is elastic only if
//! all its impacts are. For a single contact this is Newton's law. The paper's
//! restitution ([`Restitution::Paper`]) damps each disc of a contact that
//! approached once, after the elastic rounds.
//!
//! Without rounding all of this is exact, and without square roots. In
//! enclosures, contacts of which it is not certain whether they approach are
//! a doubt. In binary64 the conservation laws hold up to rounding; a closing
//! speed that is nothing but rounding is reflected like any other, which
//! changes nothing that is larger, and the count of rounds sees to the end.

use std::cmp::Ordering::{Greater, Less};

use super::project::System;
use super::{Against, Normal, Restitution, collide_discs, collide_wall};
use crate::body::{Disc, Mass};
use crate::scalar::Scalar;
use crate::vec2::Vec2;

/// The rounds of reflections after which a cluster counts as jammed.
pub const MAX_ROUNDS: usize = 1 << 10;

/// A contact in a cluster of simultaneous ones.
#[derive(Clone, Debug)]
pub struct ClusterContact<S> {
    /// A disc, by its place among the discs.
    pub first: usize,
    /// The other disc, or none for a wall or a corner. At most one of the two
    /// has infinite mass.
    pub second: Option<usize>,
    /// From the first disc's centre towards the other disc, wall or corner;
    /// of any length, but in that direction: for a wall this has to be seen
    /// to.
    pub normal: Normal<S>,
}

/// What became of a cluster.
#[derive(Clone, Debug, PartialEq, Eq)]
#[must_use]
pub enum Reflection {
    /// No contact approaches any more. These contacts did, in some round:
    /// each once, in their order.
    Parted(Vec<usize>),
    /// Contacts still approach after [`MAX_ROUNDS`] rounds: discs without
    /// play between walls or bodies of infinite mass. All velocities are as
    /// they were.
    Jammed,
}

/// Resolves simultaneous contacts at once. Two contacts are of different
/// pairs of bodies.
///
/// For a single contact the result is that of [`collide_discs`] or
/// [`collide_wall`], if it approaches.
///
/// # Errors
///
/// It cannot be decided whether a contact approaches, whether an impulse
/// pushes, or whether an impact is slow enough to be elastic.
pub fn reflect_cluster<S: Scalar>(
    discs: &mut [Disc<S>],
    contacts: &[ClusterContact<S>],
    restitution: &Restitution<S>,
) -> Result<Reflection, S::Doubt> {
    if let [contact] = contacts {
        return reflect_single(discs, contact, restitution);
    }
    let before = velocities(discs, contacts);
    let Some(rounds) = elastic_rounds(discs, contacts, restitution)? else {
        restore(discs, contacts, &before);
        return Ok(Reflection::Jammed);
    };
    if let Some(strength) = &rounds.strength {
        let elastic = velocities(discs, contacts);
        restore(discs, contacts, &before);
        push_all(discs, contacts, &(0..contacts.len()).collect::<Vec<_>>(), 1)?;
        blend(discs, contacts, &elastic, strength);
    }
    let struck = marked(&rounds.struck);
    for disc in involved(contacts, &struck) {
        restitution.damp(&mut discs[disc]);
    }
    Ok(Reflection::Parted(struck))
}

fn reflect_single<S: Scalar>(
    discs: &mut [Disc<S>],
    contact: &ClusterContact<S>,
    restitution: &Restitution<S>,
) -> Result<Reflection, S::Doubt> {
    if contact.closing(discs).sign()? != Greater {
        return Ok(Reflection::Parted(Vec::new()));
    }
    contact.collide(discs, restitution)?;
    Ok(Reflection::Parted(vec![0]))
}

/// What the elastic rounds tell.
struct Rounds<S> {
    /// Which contacts approached in some round.
    struck: Vec<bool>,
    /// The least 1 + e that applied, if it is less than 2.
    strength: Option<S>,
}

impl<S: Scalar> Rounds<S> {
    fn note(&mut self, contact: usize, strength: S) -> Result<(), S::Doubt> {
        self.struck[contact] = true;
        let least = match &self.strength {
            Some(least) => strength.compare(least)? == Less,
            None => strength.compare(&S::from_integer(2))? == Less,
        };
        if least {
            self.strength = Some(strength);
        }
        Ok(())
    }
}

/// Reflects until nothing approaches, unless that takes too many rounds.
fn elastic_rounds<S: Scalar>(
    discs: &mut [Disc<S>],
    contacts: &[ClusterContact<S>],
    restitution: &Restitution<S>,
) -> Result<Option<Rounds<S>>, S::Doubt> {
    let mut rounds = Rounds {
        struck: vec![false; contacts.len()],
        strength: None,
    };
    let mut open: Vec<usize> = (0..contacts.len()).collect();
    for _ in 0..MAX_ROUNDS {
        let approaching = approaching(discs, contacts, &open)?;
        if approaching.is_empty() {
            return Ok(Some(rounds));
        }
        for &index in &approaching {
            let strength = contacts[index].strength(discs, restitution)?;
            rounds.note(index, strength)?;
        }
        push_all(discs, contacts, &approaching, 2)?;
        open = reached(discs, contacts, &approaching);
    }
    Ok(None)
}

/// Those of the contacts that approach.
fn approaching<S: Scalar>(
    discs: &[Disc<S>],
    contacts: &[ClusterContact<S>],
    among: &[usize],
) -> Result<Vec<usize>, S::Doubt> {
    let mut found = Vec::new();
    for &index in among {
        if contacts[index].closing(discs).sign()? == Greater {
            found.push(index);
        }
    }
    Ok(found)
}

/// The contacts of which it is open whether they approach after others have
/// been reflected: they share a disc with one of those that was deflected.
fn reached<S: Scalar>(
    discs: &[Disc<S>],
    contacts: &[ClusterContact<S>],
    reflected: &[usize],
) -> Vec<usize> {
    let moved = involved(contacts, reflected);
    let is_moved = |disc: usize| discs[disc].is_movable() && moved.binary_search(&disc).is_ok();
    (0..contacts.len())
        .filter(|index| reflected.binary_search(index).is_err())
        .filter(|&index| contacts[index].discs().any(is_moved))
        .collect()
}

/// Applies the impulses that take the most energy at some contacts, so many
/// times.
fn push_all<S: Scalar>(
    discs: &mut [Disc<S>],
    contacts: &[ClusterContact<S>],
    pushing: &[usize],
    times: i32,
) -> Result<(), S::Doubt> {
    if let ([index], 2) = (pushing, times) {
        return contacts[*index].collide(discs, &Restitution::Elastic);
    }
    let impulses = system(discs, contacts, pushing).project()?;
    for (&index, impulse) in pushing.iter().zip(impulses) {
        contacts[index].push(discs, &(S::from_integer(times) * impulse));
    }
    Ok(())
}

fn system<S: Scalar>(
    discs: &[Disc<S>],
    contacts: &[ClusterContact<S>],
    pushing: &[usize],
) -> System<S> {
    let row = |&one: &usize| {
        let entry = |&other: &usize| match one == other {
            true => contacts[one].own_response(discs),
            false => contacts[one].response_to(&contacts[other], discs),
        };
        pushing.iter().map(entry).collect()
    };
    System {
        response: pushing.iter().map(row).collect(),
        closing: pushing
            .iter()
            .map(|&index| contacts[index].closing(discs))
            .collect(),
    }
}

impl<S: Scalar> ClusterContact<S> {
    fn discs(&self) -> impl Iterator<Item = usize> {
        [self.first].into_iter().chain(self.second)
    }

    /// How fast the bodies approach, in units of the normal's length.
    fn closing(&self, discs: &[Disc<S>]) -> S {
        let velocity = &discs[self.first].velocity;
        match self.second {
            Some(second) => velocity
                .minus(&discs[second].velocity)
                .dot(&self.normal.direction),
            None => velocity.dot(&self.normal.direction),
        }
    }

    /// How much a unit impulse slows the closing.
    fn own_response(&self, discs: &[Disc<S>]) -> S {
        let lightness = self.discs().map(|disc| lightness(&discs[disc]));
        let lightness = lightness.flatten();
        let sum = lightness.reduce(|sum, lightness| sum + lightness);
        sum.map_or(S::from_integer(0), |sum| sum * &self.normal.squared)
    }

    /// How much a unit impulse at another contact slows the closing: through
    /// each disc that the two share.
    fn response_to(&self, other: &Self, discs: &[Disc<S>]) -> S {
        let alignment = self.normal.direction.dot(&other.normal.direction);
        self.discs()
            .filter_map(|disc| {
                let sign = self.side_of(disc)? * other.side_of(disc)?;
                Some(lightness(&discs[disc])? * S::from_integer(sign))
            })
            .fold(S::from_integer(0), |sum, part| sum + part * &alignment)
    }

    /// On which side of the contact a disc is: 1 where the normal comes from,
    /// -1 where it goes to.
    fn side_of(&self, disc: usize) -> Option<i32> {
        if disc == self.first {
            Some(1)
        } else {
            (self.second == Some(disc)).then_some(-1)
        }
    }

    /// Pushes the bodies apart.
    fn push(&self, discs: &mut [Disc<S>], impulse: &S) {
        for (disc, sign) in [(Some(self.first), -1), (self.second, 1)] {
            let Some(disc) = disc.map(|disc| &mut discs[disc]) else {
                continue;
            };
            if let Some(lightness) = lightness(disc) {
                let change = lightness * S::from_integer(sign) * impulse;
                disc.velocity = disc.velocity.moved(&self.normal.direction, &change);
            }
        }
    }

    /// 1 + e for the contact as it approaches now.
    fn strength(&self, discs: &[Disc<S>], restitution: &Restitution<S>) -> Result<S, S::Doubt> {
        let against = match self.second {
            Some(_) => Against::Disc,
            None => Against::Wall,
        };
        restitution.strength(against, &self.closing(discs), &self.normal.squared)
    }

    /// Resolves the contact as if it were alone.
    fn collide(&self, discs: &mut [Disc<S>], restitution: &Restitution<S>) -> Result<(), S::Doubt> {
        let Some(second) = self.second else {
            return collide_wall(&mut discs[self.first], &self.normal, restitution);
        };
        let [first, second] = discs
            .get_disjoint_mut([self.first, second])
            .expect("a disc does not touch itself");
        collide_discs(first, second, &self.normal, restitution)
    }
}

/// The inverse of the mass; none where that is infinite.
fn lightness<S: Scalar>(disc: &Disc<S>) -> Option<S> {
    match &disc.mass {
        Mass::Finite(mass) => Some(S::from_integer(1) / mass),
        Mass::Infinite => None,
    }
}

fn marked(marks: &[bool]) -> Vec<usize> {
    (0..marks.len()).filter(|&index| marks[index]).collect()
}

/// The discs of some contacts, each once, in order.
fn involved<S: Scalar>(contacts: &[ClusterContact<S>], of: &[usize]) -> Vec<usize> {
    let mut discs: Vec<usize> = of
        .iter()
        .flat_map(|&index| contacts[index].discs())
        .collect();
    discs.sort_unstable();
    discs.dedup();
    discs
}

/// The velocities of all discs of the cluster, in their order.
fn velocities<S: Scalar>(discs: &[Disc<S>], contacts: &[ClusterContact<S>]) -> Vec<Vec2<S>> {
    members(contacts)
        .map(|disc| discs[disc].velocity.clone())
        .collect()
}

fn restore<S: Scalar>(
    discs: &mut [Disc<S>],
    contacts: &[ClusterContact<S>],
    velocities: &[Vec2<S>],
) {
    for (disc, velocity) in members(contacts).zip(velocities) {
        discs[disc].velocity = velocity.clone();
    }
}

/// Goes from the velocities p that the discs have to p + e (v - p).
fn blend<S: Scalar>(
    discs: &mut [Disc<S>],
    contacts: &[ClusterContact<S>],
    elastic: &[Vec2<S>],
    strength: &S,
) {
    let coefficient = strength.clone() - S::from_integer(1);
    for (disc, elastic) in members(contacts).zip(elastic) {
        let velocity = &mut discs[disc].velocity;
        *velocity = velocity.moved(&elastic.minus(velocity), &coefficient);
    }
}

fn members<S: Scalar>(contacts: &[ClusterContact<S>]) -> impl Iterator<Item = usize> {
    let all: Vec<usize> = (0..contacts.len()).collect();
    involved(contacts, &all).into_iter()
}

#[cfg(test)]
mod tests;
