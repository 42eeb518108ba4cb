//! When two bodies in free motion first meet, in closed form.
//!
//! Of rational positions, velocities and radii the time is p + q √d with rationals p, q
//! and d, a [`Quadratic`]; what kind of meeting it is, their signs tell. So nothing rounds
//! and nothing is enclosed. This shares no code with [`detect`](crate::detect), which
//! computes with numbers of any type: each is a check of the other.
//!
//! Two discs meet like a point and a circle of both radii together; a disc meets a
//! wall like a point and all that is no further than its radius from the wall, a stadium:
//! its sides if the foot is on the wall then, else the circle about an end.
//!
//! ```
//! use carom::first_impact::{Class, of_discs};
//! use carom::scene::{Disc, Scene};
//!
//! // 1/2 - √15/40, as in the paper's figure 2.
//! let discs = [Disc::at([0, 0], 1).velocity([10, 0]), Disc::at([5, 1], 1)];
//! let scene = Scene::builder("figure 2").discs(discs).build()?;
//! let [one, other] = scene.discs() else { unreachable!() };
//! let met = of_discs(one, other);
//! assert_eq!(met.class, Class::Hit);
//! let time = met.time.expect("a hit has a time");
//! assert_eq!(time.p.to_string(), "1/2");
//! # Ok::<(), carom::scene::SceneError>(())
//! ```

mod circle;
mod plane;
mod quadratic;
mod stadium;

use crate::body::End;
use crate::scene::{Disc, Wall};
use circle::Passage;
use plane::{Motion, point};
pub use quadratic::Quadratic;
use stadium::Stadium;

/// What comes of two bodies, if nothing else happens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "json",
    derive(serde::Serialize),
    serde(rename_all = "kebab-case")
)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
pub enum Class {
    /// They do not meet.
    Miss,
    /// They meet.
    Hit,
    /// They only pass in tangency.
    Graze,
    /// They touch at the start, and collide at once.
    TouchingApproaching,
    /// They touch at the start, and part or move along each other.
    TouchingSeparating,
    /// They overlap at the start.
    Overlap,
}

/// The first meeting of two bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct FirstImpact {
    /// What comes of them.
    pub class: Class,
    /// When they meet: of a hit or a graze, and zero where they touch or overlap, and
    /// approach.
    pub time: Option<Quadratic>,
    /// The wall's end point that is touched, unless its interior is.
    pub end: Option<End>,
}

/// When two discs first meet. Masses are of no account.
pub fn of_discs(one: &Disc, other: &Disc) -> FirstImpact {
    let [one, other] = [one, other].map(Motion::of);
    let reach = &one.radius + &other.radius;
    Passage::new(&one.seen_from(&other), &reach).first_impact(None)
}

/// When a disc and a wall first meet.
pub fn of_disc_and_wall(disc: &Disc, wall: &Wall) -> FirstImpact {
    let [from, to] = [&wall.from, &wall.to].map(point);
    Stadium::new(Motion::of(disc), from, &to).first_impact()
}

impl FirstImpact {
    fn miss() -> Self {
        Self {
            class: Class::Miss,
            time: None,
            end: None,
        }
    }

    /// Bodies that touch at the start, and may collide at once.
    fn touching(approach: bool, end: Option<End>) -> Self {
        Self {
            class: match approach {
                true => Class::TouchingApproaching,
                false => Class::TouchingSeparating,
            },
            time: approach.then(Quadratic::zero),
            end,
        }
    }

    fn overlap(approach: bool, end: Option<End>) -> Self {
        Self {
            class: Class::Overlap,
            ..Self::touching(approach, end)
        }
    }
}
