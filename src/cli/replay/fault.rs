//! Where the wrong impacts of a run are.

use carom::body::BodyId;
use carom::judge::{Fault, Logged};
use serde::Serialize;

use crate::cli::motion::{Mark, Motion, Place};

/// A wrong impact: what is wrong, when, and where its discs are then in the run.
#[derive(Debug, Serialize)]
pub(super) struct Misplaced {
    time: f64,
    pub(super) kind: Fault,
    /// Discs and their places.
    places: Vec<Place>,
}

/// The wrong impacts of a run, with their places in its motion, in the order of time.
pub(super) fn placed(motion: &Motion, faults: &[(Fault, Logged)]) -> Vec<Misplaced> {
    let within = faults
        .iter()
        .filter(|(_, impact)| impact.time <= motion.until);
    let mut placed: Vec<_> = within
        .map(|(kind, impact)| Misplaced {
            time: impact.time,
            kind: *kind,
            places: places(motion, impact),
        })
        .collect();
    placed.sort_by(|one, other| one.time.total_cmp(&other.time));
    placed
}

/// Of an impact of the run where its discs are on their own clocks, of one that it misses
/// where they are at that time.
fn places(motion: &Motion, impact: &Logged) -> Vec<Place> {
    let begin = motion
        .impacts
        .partition_point(|mark| mark.time < impact.time);
    let mut now = motion.impacts[begin..]
        .iter()
        .take_while(|mark| mark.time == impact.time);
    if let Some(mark) = now.find(|mark| is_of(mark, impact)) {
        return mark.bodies.iter().map(|body| Place::from(*body)).collect();
    }
    let discs = [impact.pair.a, impact.pair.b].into_iter();
    let discs = discs.filter_map(|body| match body {
        BodyId::Disc(disc) => Some(disc as usize),
        BodyId::Wall(_) => None,
    });
    let place = |disc: usize| {
        let [x, y] = motion.discs[disc].at(impact.time);
        (disc, x, y)
    };
    discs.map(place).collect()
}

fn is_of(mark: &Mark, impact: &Logged) -> bool {
    mark.a == impact.pair.a.to_string() && mark.b == impact.pair.b.to_string()
}
