//! A row of discs on a line, in fractions: neighbours meet when the gap
//! between them has closed, and nobody else does.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::common::strategy::{Bead, Chain};

/// How a chain fares.
pub(crate) struct Run {
    pub(crate) impacts: Vec<(BigRational, String)>,
    pub(crate) discs: Vec<Bead>,
}

/// Two neighbours: the left wall and the first disc, two discs, or the last
/// disc and the right wall.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Meeting {
    Discs(usize),
    Wall(usize, usize),
}

/// Runs a chain to a time that belongs to the run.
pub(crate) fn run(chain: &Chain, until: &BigRational) -> Run {
    let mut discs = chain.discs.clone();
    let mut impacts = Vec::new();
    let mut now = BigRational::zero();
    while let Some((delay, meeting)) = next(&discs, &chain.walls)
        && &now + &delay <= *until
    {
        advance(&mut discs, &delay);
        now += delay;
        collide(&mut discs, meeting);
        impacts.push((now.clone(), meeting.name()));
    }
    advance(&mut discs, &(until - now));
    Run { impacts, discs }
}

/// The first meeting; of those at one time, the one that is named first.
fn next(discs: &[Bead], walls: &[BigRational; 2]) -> Option<(BigRational, Meeting)> {
    let last = discs.len() - 1;
    let meetings = (0..last)
        .map(Meeting::Discs)
        .chain([Meeting::Wall(0, 0), Meeting::Wall(last, 1)]);
    let delays = meetings.filter_map(|meeting| {
        let (gap, closing) = approach(discs, walls, meeting);
        closing.is_positive().then(|| (gap / closing, meeting))
    });
    delays.min_by(|(one, first), (other, second)| {
        one.cmp(other).then(first.order().cmp(&second.order()))
    })
}

/// How far apart two neighbours are, and how fast that shrinks.
fn approach(
    discs: &[Bead],
    walls: &[BigRational; 2],
    meeting: Meeting,
) -> (BigRational, BigRational) {
    match meeting {
        Meeting::Discs(left) => {
            let [left, right] = [&discs[left], &discs[left + 1]];
            let gap = &right.position - &right.radius - &left.position - &left.radius;
            (gap, &left.velocity - &right.velocity)
        }
        Meeting::Wall(disc, 0) => {
            let disc = &discs[disc];
            (&disc.position - &disc.radius - &walls[0], -&disc.velocity)
        }
        Meeting::Wall(disc, wall) => {
            let disc = &discs[disc];
            (
                &walls[wall] - &disc.position - &disc.radius,
                disc.velocity.clone(),
            )
        }
    }
}

fn advance(discs: &mut [Bead], time: &BigRational) {
    for disc in discs {
        disc.position += &disc.velocity * time;
    }
}

/// In the frame of the centre of mass both velocities are reversed.
fn collide(discs: &mut [Bead], meeting: Meeting) {
    let Meeting::Discs(left) = meeting else {
        let Meeting::Wall(disc, _) = meeting else {
            unreachable!("the other kind");
        };
        discs[disc].velocity = -&discs[disc].velocity;
        return;
    };
    let pair = &mut discs[left..=left + 1];
    let momentum: BigRational = pair.iter().map(|disc| &disc.mass * &disc.velocity).sum();
    let mass: BigRational = pair.iter().map(|disc| &disc.mass).sum();
    let centre = momentum / mass;
    for disc in pair {
        disc.velocity = &centre + &centre - &disc.velocity;
    }
}

impl Meeting {
    /// Which of simultaneous meetings is first: by the first disc, and of one
    /// disc, with discs before walls.
    fn order(self) -> (usize, usize, usize) {
        match self {
            Self::Discs(left) => (left, 0, left + 1),
            Self::Wall(disc, wall) => (disc, 1, wall),
        }
    }

    fn name(self) -> String {
        match self {
            Self::Discs(left) => format!("d{left} d{}", left + 1),
            Self::Wall(disc, wall) => format!("d{disc} w{wall}"),
        }
    }
}
