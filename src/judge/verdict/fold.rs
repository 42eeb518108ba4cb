//! Reports of contacts, made collisions.

use std::collections::HashMap;

use crate::body::{BodyId, Pair};
use crate::judge::Logged;
use crate::scene::Scene;

/// A log without the lines that name a pair again of which neither body has met anything
/// else since, and how many these are: where bodies move in straight lines, no two
/// collide again before one of them has met a third. Elsewhere all lines stand.
pub(super) fn fold(scene: &Scene, log: &[Logged]) -> (Vec<Logged>, usize) {
    let effects = scene.effects();
    if effects.gravity.is_some() || scene.periodic().is_some() {
        return (log.to_vec(), 0);
    }
    let mut latest: HashMap<BodyId, Pair> = HashMap::new();
    let mut folded = log.to_vec();
    folded.retain(|impact| {
        let discs = [impact.pair.a, impact.pair.b].into_iter();
        let discs = discs.filter(|body| matches!(body, BodyId::Disc(_)));
        let met = discs.map(|disc| latest.insert(disc, impact.pair));
        // Each disc is to be noted.
        let met: Vec<_> = met.collect();
        met.contains(&None) || met.iter().any(|met| *met != Some(impact.pair))
    });
    let repeats = log.len() - folded.len();
    (folded, repeats)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Disc;

    fn logged(a: u32, b: BodyId) -> Logged {
        Logged {
            pair: Pair::new(BodyId::Disc(a), b),
            time: 0.0,
            tie: None,
        }
    }

    /// d0 and d1, twice told; then d1 has met a wall, and d0 not: they may collide again.
    #[test]
    fn contacts_are_told_once() {
        let discs = [0, 3].map(|x| Disc::at([x, 0], 1));
        let scene = Scene::builder("two").discs(discs).build().unwrap();
        let pair = logged(0, BodyId::Disc(1));
        let wall = logged(1, BodyId::Wall(0));
        let (folded, repeats) = fold(&scene, &[pair, pair, wall, wall, pair]);
        assert_eq!((folded, repeats), (vec![pair, wall, pair], 2));
    }
}
