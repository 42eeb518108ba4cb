//! Velocities after an impact, as fractions of whole numbers that are rounded
//! once.

use std::cmp::Ordering::{Equal, Greater, Less};

use crate::body::{Disc, Mass};
use crate::filtered::plane::Point;
use crate::respond::Restitution;
use crate::scalar::{Dyadic, Filtered, Rounding};
use crate::vec2::Vec2;

/// A vector of fractions.
struct Fractions {
    numerators: Point,
    /// Positive.
    divisor: Dyadic,
}

impl Fractions {
    fn nearest(&self) -> Vec2<Filtered> {
        self.rounded([Rounding::Nearest; 2])
    }

    /// Each coordinate rounded in the direction in which a vector points.
    fn towards(&self, direction: &Point) -> Vec2<Filtered> {
        let side = |coordinate: &Dyadic| match coordinate.sign() {
            Less => Rounding::Down,
            Equal => Rounding::Nearest,
            Greater => Rounding::Up,
        };
        self.rounded([side(&direction.x), side(&direction.y)])
    }

    fn rounded(&self, [x, y]: [Rounding; 2]) -> Vec2<Filtered> {
        let Point { x: p, y: q } = &self.numerators;
        let divided =
            |number: &Dyadic, rounding| Filtered::new(number.divided_by(&self.divisor, rounding));
        Vec2::new(divided(p, x), divided(q, y))
    }
}

/// A body that an impact deflects.
struct Struck<'a> {
    disc: &'a mut Disc<Filtered>,
    velocity: Point,
    /// The part of the relative change of velocity that it takes, as a fraction.
    share: [Dyadic; 2],
    /// Away from the other body.
    away: Point,
}

/// How hard two bodies strike each other.
struct Strike {
    /// The square of the normal.
    squared: Dyadic,
    /// 1 + e, times the closing speed and the normal's length.
    push: Dyadic,
    /// What is left of the velocities altogether.
    kept: Dyadic,
}

impl Strike {
    /// None if the bodies do not approach.
    fn new(
        velocity: &Point,
        normal: &Point,
        coefficient: Option<&Filtered>,
        restitution: &Restitution<Filtered>,
    ) -> Option<Self> {
        let (approach, squared) = (velocity.dot(normal), normal.squared());
        if approach.sign() != Greater {
            return None;
        }
        let one = Dyadic::from(1);
        let strength = match coefficient {
            Some(coefficient) if !is_slow(&approach, &squared, restitution) => {
                one.clone().add(&exactly(coefficient))
            }
            _ => Dyadic::from(2),
        };
        let kept = match restitution {
            Restitution::Paper { kept } => exactly(kept),
            Restitution::Elastic | Restitution::Newton { .. } => one,
        };
        Some(Self {
            push: strength.mul(&approach),
            squared,
            kept,
        })
    }

    fn after(&self, body: &Struck<'_>) -> Fractions {
        let [part, whole] = &body.share;
        let divisor = self.squared.mul(whole);
        let change = body.away.scaled(&self.push.mul(part));
        let numerators = body.velocity.scaled(&divisor).plus(&change);
        Fractions {
            numerators: numerators.scaled(&self.kept),
            divisor,
        }
    }
}

/// Whether an impact is so slow that it is elastic.
fn is_slow(approach: &Dyadic, squared: &Dyadic, restitution: &Restitution<Filtered>) -> bool {
    let Restitution::Newton {
        elastic_below: Some(speed),
        ..
    } = restitution
    else {
        return false;
    };
    let limit = exactly(speed);
    let limit = limit.mul(&limit).mul(squared);
    approach.mul(approach).compare(&limit) == Less
}

/// Resolves the impact of two discs whose centres are at these places.
pub(super) fn collide_discs(
    discs: [&mut Disc<Filtered>; 2],
    centres: [&Vec2<Filtered>; 2],
    restitution: &Restitution<Filtered>,
) {
    let [from, to] = centres.map(Point::of);
    let normal = to.minus(&from);
    let velocities = discs.each_ref().map(|disc| Point::of(&disc.velocity));
    let velocity = velocities[0].minus(&velocities[1]);
    let coefficient = match restitution {
        Restitution::Newton { discs, .. } => Some(discs),
        Restitution::Elastic | Restitution::Paper { .. } => None,
    };
    let Some(strike) = Strike::new(&velocity, &normal, coefficient, restitution) else {
        return;
    };
    let [first, second] = discs;
    let [own, other] = velocities;
    let [share, other_share] = shares(&first.mass, &second.mass);
    let struck = [
        Struck {
            disc: first,
            velocity: own,
            share,
            away: normal.reversed(),
        },
        Struck {
            disc: second,
            velocity: other,
            share: other_share,
            away: normal,
        },
    ];
    deflect(struck, &strike);
}

/// Resolves the impact of a disc on something fixed, in the direction of the
/// normal or, if that does not matter, against it.
pub(super) fn collide_fixed(
    disc: &mut Disc<Filtered>,
    normal: Point,
    restitution: &Restitution<Filtered>,
) {
    let velocity = Point::of(&disc.velocity);
    let coefficient = match restitution {
        Restitution::Newton { walls, .. } => Some(walls),
        Restitution::Elastic | Restitution::Paper { .. } => None,
    };
    let Some(strike) = Strike::new(&velocity, &normal, coefficient, restitution) else {
        return;
    };
    let struck = Struck {
        disc,
        velocity,
        share: [Dyadic::from(1), Dyadic::from(1)],
        away: normal.reversed(),
    };
    deflect([struck], &strike);
}

/// The parts that two bodies take: in inverse proportion to their masses, of
/// which at most one is infinite.
fn shares(first: &Mass<Filtered>, second: &Mass<Filtered>) -> [[Dyadic; 2]; 2] {
    let [nothing, whole] = [0, 1].map(Dyadic::from);
    match (first, second) {
        (Mass::Finite(first), Mass::Finite(second)) => {
            let [first, second] = [first, second].map(exactly);
            let total = first.clone().add(&second);
            [[second, total.clone()], [first, total]]
        }
        (Mass::Finite(_), Mass::Infinite) => [[whole.clone(), whole.clone()], [nothing, whole]],
        (Mass::Infinite, _) => [[nothing, whole.clone()], [whole.clone(), whole]],
    }
}

/// Gives bodies their velocities after an impact, rounded so that they do not
/// approach.
fn deflect<const N: usize>(bodies: [Struck<'_>; N], strike: &Strike) {
    let after = bodies.each_ref().map(|body| strike.after(body));
    let nearest = after.each_ref().map(Fractions::nearest);
    let closing =
        |(body, velocity): (&Struck<'_>, &Vec2<Filtered>)| -body.away.dot(&Point::of(velocity));
    let closing = bodies.iter().zip(&nearest).map(closing);
    let closing = closing.fold(Dyadic::zero(), |sum, part| sum.add(&part));
    let still_approach = closing.sign() == Greater;
    for ((body, exact), nearest) in bodies.into_iter().zip(after).zip(nearest) {
        body.disc.velocity = if still_approach {
            exact.towards(&body.away)
        } else {
            nearest
        };
    }
}

fn exactly(number: &Filtered) -> Dyadic {
    Dyadic::from_f64(number.get())
}
