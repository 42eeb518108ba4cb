//! A binary64 run's bodies, as it stores them: what never changes, and what
//! impacts change.

use crate::body::Mass;
use crate::kernel::Kernel;
use crate::scalar::Scalar;
use crate::world::{Obstacle, World};

/// What never changes.
#[derive(Clone, Debug)]
pub(super) struct Bodies {
    pub(super) radii: Vec<f64>,
    /// None for a disc that collisions never deflect.
    pub(super) masses: Vec<Option<f64>>,
    pub(super) walls: Vec<[[f64; 2]; 2]>,
}

impl Bodies {
    pub(super) fn of<S: Kernel>(world: &World<S>) -> Self {
        let mass = |mass: &Mass<S>| match mass {
            Mass::Finite(mass) => Some(mass.to_f64()),
            Mass::Infinite => None,
        };
        let discs = &world.discs;
        let wall = |segment: &crate::detect::Segment<S>| {
            [&segment.from, &segment.to].map(|end| end.map(S::to_f64).into())
        };
        Self {
            radii: discs.iter().map(|disc| disc.radius.to_f64()).collect(),
            masses: discs.iter().map(|disc| mass(&disc.mass)).collect(),
            walls: world
                .walls
                .iter()
                .map(|wall_| wall(&wall_.segment))
                .collect(),
        }
    }

    /// Every pair that can collide: each disc with each disc after it and with
    /// each wall, but for what cannot be deflected.
    pub(super) fn pairs(&self) -> impl Iterator<Item = (usize, Obstacle)> + use<'_> {
        let (discs, walls) = (self.radii.len(), self.walls.len());
        let of = move |disc| {
            let others = (disc + 1..discs).map(Obstacle::Disc);
            others.chain((0..walls).map(Obstacle::Wall))
        };
        let pairs = (0..discs).flat_map(move |disc| of(disc).map(move |other| (disc, other)));
        pairs.filter(|&pair| self.movable(pair).next().is_some())
    }

    /// The discs of a pair that collisions deflect.
    pub(super) fn movable(&self, pair: (usize, Obstacle)) -> impl Iterator<Item = usize> + use<'_> {
        discs(pair).filter(|&disc| self.masses[disc].is_some())
    }
}

/// The discs of a pair.
pub(super) fn discs((disc, obstacle): (usize, Obstacle)) -> impl Iterator<Item = usize> {
    let other = match obstacle {
        Obstacle::Disc(other) => Some(other),
        Obstacle::Wall(_) => None,
    };
    [disc].into_iter().chain(other)
}

/// What impacts change of a disc.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion {
    /// Where it is at the time `since`.
    pub(super) position: [f64; 2],
    pub(super) velocity: [f64; 2],
    pub(super) since: f64,
    /// The greatest of the speeds that its velocity was computed from.
    pub(super) pace: f64,
    /// The margins of all impacts that it has had.
    pub(super) blur: f64,
}

impl Motion {
    pub(super) fn of<S: Scalar>(disc: &crate::body::Disc<S>, since: &S) -> Self {
        let velocity: [f64; 2] = disc.velocity.map(S::to_f64).into();
        Self {
            position: disc.position.map(S::to_f64).into(),
            velocity,
            since: since.to_f64(),
            pace: length(velocity),
            blur: 0.0,
        }
    }

    /// About where the disc is at a time.
    pub(super) fn place(&self, time: f64) -> [f64; 2] {
        let flown = time - self.since;
        [0, 1].map(|axis| self.position[axis] + self.velocity[axis] * flown)
    }

    /// From where the disc is stored to where another one is.
    pub(super) fn to(&self, other: &Self) -> [f64; 2] {
        [0, 1].map(|axis| other.position[axis] - self.position[axis])
    }

    pub(super) fn speed(&self) -> f64 {
        length(self.velocity)
    }

    /// All of it that is stored, to the last bit.
    pub(super) fn bits(&self) -> [u64; 5] {
        let ([x, y], [vx, vy]) = (self.position, self.velocity);
        [x, y, vx, vy, self.since].map(f64::to_bits)
    }

    pub(super) fn is_finite(&self) -> bool {
        let ([x, y], [vx, vy]) = (self.position, self.velocity);
        [x, y, vx, vy, self.since]
            .iter()
            .all(|number| number.is_finite())
    }
}

pub(super) fn length([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}
