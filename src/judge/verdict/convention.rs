//! What depends on how simultaneous impacts are resolved.

use std::collections::HashSet;

use crate::body::{BodyId, Pair};
use crate::judge::{Difference, Logged};

/// Whether a disc that differs may do so by another rule for simultaneous impacts: it is
/// one of those that share a disc with another impact of the same time, or has met such
/// a disc since, directly or not.
pub(super) fn depends_on_rule(truth: &[Logged], difference: &Difference) -> bool {
    let mut touched = HashSet::new();
    let until = truth.partition_point(|impact| impact.time <= difference.time);
    let groups = truth[..until].chunk_by(|one, other| one.tie.is_some() && one.tie == other.tie);
    for group in groups {
        if is_linked(group) || group.iter().any(|impact| meets(&touched, impact.pair)) {
            touched.extend(group.iter().flat_map(|impact| discs(impact.pair)));
        }
    }
    let pairs = [difference.truth, difference.candidate]
        .into_iter()
        .flatten();
    let own = pairs.flat_map(|(pair, _)| discs(pair));
    own.chain([difference.disc])
        .any(|disc| touched.contains(&disc))
}

/// Whether simultaneous impacts share a disc.
fn is_linked(group: &[Logged]) -> bool {
    let pairs = group.iter().enumerate();
    pairs.into_iter().any(|(place, one)| {
        let others = &group[place + 1..];
        others.iter().any(|other| one.pair.shares_disc(&other.pair))
    })
}

fn meets(touched: &HashSet<BodyId>, pair: Pair) -> bool {
    discs(pair).any(|disc| touched.contains(&disc))
}

fn discs(pair: Pair) -> impl Iterator<Item = BodyId> {
    let bodies = [pair.a, pair.b].into_iter();
    bodies.filter(|body| matches!(body, BodyId::Disc(_)))
}
