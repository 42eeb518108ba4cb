//! What depends on how simultaneous impacts are resolved.

use std::collections::HashMap;

use crate::body::{BodyId, Pair};
use crate::judge::{Difference, Logged};

/// So many true impacts of a disc after simultaneous ones confirm that a log goes by the
/// same rule.
const CONFIRMED: u32 = 2;

/// The discs that may be on another course by another rule, and how many of their impacts
/// since are nevertheless the true ones.
#[derive(Default)]
struct Touched(HashMap<BodyId, u32>);

/// Whether a disc that differs may do so by another rule for simultaneous impacts: it is
/// one of those that share a disc with another impact of the same time, or has met such
/// a disc since, directly or not, before what followed confirmed the rule.
pub(super) fn depends_on_rule(truth: &[Logged], difference: &Difference) -> bool {
    let mut touched = Touched::default();
    let until = truth.partition_point(|impact| impact.time <= difference.time);
    let groups = truth[..until].chunk_by(|one, other| one.tie.is_some() && one.tie == other.tie);
    for group in groups {
        if is_linked(group) {
            let all = group.iter().flat_map(|impact| discs(impact.pair));
            touched.0.extend(all.map(|disc| (disc, 0)));
        } else if group.iter().all(|impact| impact.time < difference.time) {
            group.iter().for_each(|impact| touched.follow(impact.pair));
        }
    }
    let pairs = [difference.truth, difference.candidate].into_iter();
    let own = pairs.flatten().flat_map(|(pair, _)| discs(pair));
    own.chain([difference.disc])
        .any(|disc| touched.0.contains_key(&disc))
}

impl Touched {
    /// Takes an impact into account that a log has, too.
    fn follow(&mut self, pair: Pair) {
        let counts = discs(pair).filter_map(|disc| self.0.get(&disc).copied());
        let Some(least) = counts.min() else {
            return;
        };
        for disc in discs(pair) {
            let count = self.0.get(&disc).copied().unwrap_or(least) + 1;
            match count < CONFIRMED {
                true => self.0.insert(disc, count),
                false => self.0.remove(&disc),
            };
        }
    }
}

/// Whether simultaneous impacts share a disc.
fn is_linked(group: &[Logged]) -> bool {
    group.iter().enumerate().any(|(place, one)| {
        let others = &group[place + 1..];
        others.iter().any(|other| one.pair.shares_disc(&other.pair))
    })
}

fn discs(pair: Pair) -> impl Iterator<Item = BodyId> {
    let bodies = [pair.a, pair.b].into_iter();
    bodies.filter(|body| matches!(body, BodyId::Disc(_)))
}
