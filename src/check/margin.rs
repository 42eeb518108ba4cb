//! How far binary64 may be from the truth of its own state.
//!
//! A decision counts as right if it is right for bodies moved by no more than
//! a margin: it is an error *backward*, in the data, so it covers grazes (the
//! least distance is within the margin of the reach), times (off by the margin
//! over the closing speed) and order (of what happens within such times) alike.
//!
//! With the unit roundoff u = 2⁻⁵³, A = |p₁| + |p₂| + R for two discs (or
//! |p| + R + |from| + |to| for a disc and a wall) and the path P = (|v₁| + |v₂|) t
//! up to the absolute time t, the roundings of a forecast move bodies by at
//! most, in units of u:
//!
//! | step | A | P |
//! |---|--:|--:|
//! | the earlier disc flown to the later one's time: p + v (s - s₀) | 1 | 3 |
//! | relative position, relative velocity over the delay | 1 | 2 |
//! | D = (w·w) R² - (d × w)²: off by 8.5 w²R², as good as R off by | 4.3 | |
//! | d·w and the sum √D - d·w: a distance off by 3 \|d\| | 3 | 3 |
//! | c / (√D - d·w) and its operands: three relative errors of the path | | 3 |
//! | the sum s + delay | | 1 |
//! | **discs** | 9.3 | 12 |
//! | walls: the vector along (2), offset (1), side (1.5), R L (3), gap (1), foot (3) | 11.5 | 8 |
//!
//! (A time t̃ = c / (√D - a) with D off by δ, or a off by η, puts the bodies off
//! their contact by δ t̃² / (2 c R) or √D η t̃² / (c R). Both are at most what the
//! table says, because the smaller root's path w t̃ is not longer than the
//! tangent, (w t̃)² ≤ c, and D ≤ w²R². Where D is nothing but its rounding, t̃ is
//! not let past the nearest point, which then is a graze within the margin.)
//!
//! A pair that has collided parts by construction, though its velocities are
//! rounded: at most twenty roundings of 2 w, twice the speeds before. Over the
//! flight that is 40 u P, where the speeds in P are those before and after the
//! impact. Hence 16 for A and 64 for P, of which 12 + 40 are accounted for.
//!
//! Where an impact leaves a disc, its place is off by the margin of the flight up to
//! there, with the speeds of that flight. A slower flight after it does not take that
//! back: what a disc overlaps after several impacts is up to the sum of the margins of
//! all these flights, each with its own P, and one more.

/// The unit roundoff of binary64.
pub(super) const ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// The roundings of places, with some to spare.
const PLACE: f64 = 16.0;

/// The roundings of paths, with some to spare.
const PATH: f64 = 64.0;

/// The energy that an impact of two bodies may gain or lose, relative to theirs.
///
/// The impulse is off by 20 u of itself and velocities by u. With the reduced
/// mass μ, m |v| δv is at most 20 u · 2 μ |w| |v| for each of the two, and
/// μ |w|² and μ |v|² are at most twice the energy: 82 u in all.
pub(super) const ENERGY: f64 = 128.0 * ROUNDOFF;

/// The margin for bodies whose places and radii add up to `place`, and their
/// paths to `path`.
pub(super) fn margin(place: f64, path: f64) -> f64 {
    (PLACE * place + PATH * path) * ROUNDOFF
}
