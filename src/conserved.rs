//! Energy and momentum, of the discs of finite mass.

use crate::body::{Disc, Mass};
use crate::scalar::Scalar;
#[cfg(feature = "json")]
use crate::vec2::Vec2;

/// The kinetic energy, Σ m v² / 2.
pub(crate) fn energy<S: Scalar>(discs: &[Disc<S>]) -> S {
    let twice = movable(discs)
        .map(|(disc, mass)| disc.velocity.norm_squared() * mass)
        .fold(S::from_integer(0), |sum, next| sum + next);
    twice / S::from_integer(2)
}

/// The momentum, Σ m v.
#[cfg(feature = "json")]
pub(crate) fn momentum<S: Scalar>(discs: &[Disc<S>]) -> Vec2<S> {
    movable(discs)
        .map(|(disc, mass)| disc.velocity.scaled(mass))
        .fold(Vec2::zero(), |sum, next| sum.plus(&next))
}

fn movable<S>(discs: &[Disc<S>]) -> impl Iterator<Item = (&Disc<S>, &S)> {
    discs.iter().filter_map(|disc| match &disc.mass {
        Mass::Finite(mass) => Some((disc, mass)),
        Mass::Infinite => None,
    })
}
