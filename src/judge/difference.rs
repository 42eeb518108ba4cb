//! Where a run leaves the true course of events.

use std::collections::HashMap;
use std::fmt;

use super::tally::Logged;
use crate::body::{BodyId, Pair};

/// The first impact of a disc that is not the true one.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// When the two courses part.
    pub time: f64,
    /// How many impacts of the truth came before.
    pub followed: usize,
    /// The disc whose impacts differ.
    pub disc: BodyId,
    /// What it truly meets next, if anything, and when.
    pub truth: Option<(Pair, f64)>,
    /// What it meets instead, if anything, and when.
    pub candidate: Option<(Pair, f64)>,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.followed;
        write!(
            f,
            "follows the truth for {count} impacts, up to t = {}; then ",
            self.time
        )?;
        match (&self.truth, &self.candidate) {
            (Some((pair, time)), Some((other, when))) => {
                write!(f, "{pair} meet at {time}, but it has {other} at {when}")
            }
            (Some((pair, time)), None) => write!(f, "{pair} meet at {time}, which it misses"),
            (None, Some((pair, time))) => write!(f, "it has {pair} at {time}, which do not meet"),
            (None, None) => Ok(()),
        }
    }
}

/// The earliest impact at which the course of some disc differs. Impacts that
/// share no disc may stand in any order.
pub fn first_difference(truth: &[Logged], candidate: &[Logged]) -> Option<Difference> {
    let (true_courses, courses) = (by_disc(truth), by_disc(candidate));
    let none = Vec::new();
    let mut discs: Vec<_> = true_courses.keys().chain(courses.keys()).copied().collect();
    discs.sort();
    discs.dedup();
    let differences = discs.into_iter().filter_map(|disc| {
        let own = true_courses.get(&disc).unwrap_or(&none);
        let other = courses.get(&disc).unwrap_or(&none);
        difference_of(disc, own, other)
    });
    let mut first = differences.min_by(|one, other| one.time.total_cmp(&other.time))?;
    first.followed = truth
        .iter()
        .filter(|impact| impact.time < first.time)
        .count();
    Some(first)
}

/// The impacts of each disc in their order.
fn by_disc(impacts: &[Logged]) -> HashMap<BodyId, Vec<Logged>> {
    let mut courses: HashMap<BodyId, Vec<Logged>> = HashMap::new();
    for impact in impacts {
        let bodies = [impact.pair.a, impact.pair.b].into_iter();
        for disc in bodies.filter(|body| matches!(body, BodyId::Disc(_))) {
            courses.entry(disc).or_default().push(*impact);
        }
    }
    courses
}

fn difference_of(disc: BodyId, truth: &[Logged], candidate: &[Logged]) -> Option<Difference> {
    let shared = truth.iter().zip(candidate);
    let same = shared
        .take_while(|(one, other)| one.pair == other.pair)
        .count();
    let [truth, candidate] = [truth, candidate].map(|course| course.get(same));
    let times = [truth, candidate]
        .into_iter()
        .flatten()
        .map(|next| next.time);
    Some(Difference {
        time: times.min_by(f64::total_cmp)?,
        followed: 0,
        disc,
        truth: truth.map(|next| (next.pair, next.time)),
        candidate: candidate.map(|next| (next.pair, next.time)),
    })
}
