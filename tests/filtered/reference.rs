//! Filtered arithmetic as it is defined, by fractions and brute force: every
//! pair is looked at before every impact, with the textbook's quadratic, and
//! nothing is remembered between impacts but the stored numbers.

use carom::scene::{Mass, Restitution, Scene};
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::fraction::{Surd, ratio, rounded, rounded_towards};

pub(crate) type Vector = [BigRational; 2];

/// A disc as it is stored.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) place: [f64; 2],
    pub(crate) speed: [f64; 2],
    pub(crate) radius: f64,
    /// None for an infinite mass.
    pub(crate) mass: Option<f64>,
    pub(crate) since: f64,
}

/// What a disc hits.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Target {
    Disc(usize),
    Wall(usize),
    /// An end point, the first or the second one.
    End(usize, usize),
}

/// An impact: its time and its name.
#[derive(Clone, Debug)]
pub(crate) struct Hit {
    pub(crate) time: f64,
    pub(crate) name: String,
}

pub(crate) struct Reference {
    pub(crate) bodies: Vec<Body>,
    pub(crate) walls: Vec<[[f64; 2]; 2]>,
    restitution: Restitution,
    pub(crate) end: f64,
}

impl Target {
    /// The name of the impact of a disc on it.
    pub(crate) fn name(self, disc: usize) -> String {
        match self {
            Self::Disc(other) => format!("d{disc} d{other}"),
            Self::Wall(wall) => format!("d{disc} w{wall}"),
            Self::End(wall, 0) => format!("d{disc} w{wall} from"),
            Self::End(wall, _) => format!("d{disc} w{wall} to"),
        }
    }
}

impl Reference {
    pub(crate) fn new(scene: &Scene) -> Self {
        let pair = |numbers: &[carom::scalar::Number; 2]| numbers.each_ref().map(|n| n.to_f64());
        let bodies = scene.discs().iter().map(|disc| Body {
            place: pair(&disc.position),
            speed: pair(&disc.velocity),
            radius: disc.radius.to_f64(),
            mass: match &disc.mass {
                Mass::Finite(mass) => Some(mass.to_f64()),
                Mass::Infinite => None,
            },
            since: 0.0,
        });
        let walls = scene.walls().iter();
        Self {
            bodies: bodies.collect(),
            walls: walls
                .map(|wall| [pair(&wall.from), pair(&wall.to)])
                .collect(),
            restitution: scene.effects().restitution.clone(),
            end: rounded(&scene.frame().total()),
        }
    }

    /// The next impact, applied.
    pub(crate) fn next(&mut self) -> Option<Hit> {
        let (time, disc, target) = self.first()?;
        let stored = time.rounded();
        if stored > self.end {
            return None;
        }
        self.bring(disc, &time);
        if let Target::Disc(other) = target {
            self.bring(other, &time);
        }
        self.strike(disc, target);
        Some(Hit {
            time: stored,
            name: target.name(disc),
        })
    }

    fn first(&self) -> Option<(Surd, usize, Target)> {
        let mut first: Option<(Surd, usize, Target)> = None;
        for disc in 0..self.bodies.len() {
            let others = (disc + 1..self.bodies.len()).map(Target::Disc);
            let walls = (0..self.walls.len()).flat_map(|wall| {
                [
                    Target::Wall(wall),
                    Target::End(wall, 0),
                    Target::End(wall, 1),
                ]
            });
            for target in others.chain(walls) {
                let Some(time) = self.meet(disc, target) else {
                    continue;
                };
                let is_first = first
                    .as_ref()
                    .is_none_or(|(earliest, ..)| time.compare(earliest).is_lt());
                if is_first {
                    first = Some((time, disc, target));
                }
            }
        }
        first
    }

    fn meet(&self, disc: usize, target: Target) -> Option<Surd> {
        let body = &self.bodies[disc];
        let since = ratio(body.since);
        match target {
            Target::Disc(other) => {
                let other = &self.bodies[other];
                if body.mass.is_none() && other.mass.is_none() {
                    return None;
                }
                let start = since.max(ratio(other.since));
                let offset = minus(&other.at(&start), &body.at(&start));
                let velocity = minus(&exact(other.speed), &exact(body.speed));
                let reach = ratio(body.radius) + ratio(other.radius);
                Some(approach(&offset, &velocity, &reach)?.mapped(&one(), &start))
            }
            _ if body.mass.is_none() => None,
            Target::End(wall, end) => {
                let offset = minus(&exact(body.place), &exact(self.walls[wall][end]));
                let delay = approach(&offset, &exact(body.speed), &ratio(body.radius))?;
                // Beyond the interior, of which the end is a part.
                let is_beyond = match end {
                    0 => self.foot(body, wall, &delay).0.is_le(),
                    _ => self.foot(body, wall, &delay).1.is_ge(),
                };
                is_beyond.then(|| delay.mapped(&one(), &since))
            }
            Target::Wall(wall) => {
                let [from, to] = self.walls[wall].map(exact);
                let along = minus(&to, &from);
                let across = [-along[1].clone(), along[0].clone()];
                let side = dot(&minus(&exact(body.place), &from), &across);
                let drift = dot(&exact(body.speed), &across);
                if side.is_zero() || !(&side * &drift).is_negative() {
                    return None;
                }
                let radius = ratio(body.radius);
                let reach_squared = &radius * &radius * dot(&along, &along);
                let delay = if &side * &side <= reach_squared {
                    Surd::from(BigRational::zero())
                } else {
                    Surd {
                        p: side.abs() / drift.abs(),
                        q: -drift.abs().recip(),
                        d: reach_squared,
                    }
                };
                let (from_start, from_end) = self.foot(body, wall, &delay);
                let is_opposite = from_start.is_gt() && from_end.is_lt();
                is_opposite.then(|| delay.mapped(&one(), &since))
            }
        }
    }

    /// How the foot of the perpendicular on a wall compares with its two ends.
    fn foot(
        &self,
        body: &Body,
        wall: usize,
        delay: &Surd,
    ) -> (std::cmp::Ordering, std::cmp::Ordering) {
        let [from, to] = self.walls[wall].map(exact);
        let along = minus(&to, &from);
        let start = dot(&minus(&exact(body.place), &from), &along);
        let foot = delay.mapped(&dot(&exact(body.speed), &along), &start);
        let length = Surd::from(dot(&along, &along));
        (
            foot.compare(&Surd::from(BigRational::zero())),
            foot.compare(&length),
        )
    }

    fn bring(&mut self, disc: usize, time: &Surd) {
        let body = &mut self.bodies[disc];
        if body.mass.is_none() {
            return;
        }
        let flown = time.mapped(&one(), &-ratio(body.since));
        for axis in [0, 1] {
            let place = flown.mapped(&ratio(body.speed[axis]), &ratio(body.place[axis]));
            body.place[axis] = place.rounded();
        }
        body.since = time.rounded();
    }

    /// Lets a disc that is brought to it collide with a target.
    pub(crate) fn strike(&mut self, disc: usize, target: Target) {
        let body = &self.bodies[disc];
        let [zero, whole] = [BigRational::zero(), one()];
        let (normal, speed, shares) = match target {
            Target::Disc(other) => {
                let other = &self.bodies[other];
                let shares = match [body.mass, other.mass].map(|mass| mass.map(ratio)) {
                    [Some(a), Some(b)] => [&b / (&a + &b), &a / (&a + &b)],
                    [None, _] => [zero, whole],
                    [_, None] => [whole, zero],
                };
                let normal = minus(&exact(other.place), &exact(body.place));
                (normal, exact(other.speed), shares)
            }
            Target::End(wall, end) => {
                let normal = minus(&exact(self.walls[wall][end]), &exact(body.place));
                (normal, [zero.clone(), zero.clone()], [whole, zero])
            }
            Target::Wall(wall) => {
                let [from, to] = self.walls[wall].map(exact);
                let along = minus(&to, &from);
                let normal = [-along[1].clone(), along[0].clone()];
                let normal = match dot(&exact(body.speed), &normal).is_negative() {
                    true => normal.map(|x| -x),
                    false => normal,
                };
                (normal, [zero.clone(), zero.clone()], [whole, zero])
            }
        };
        let own = exact(body.speed);
        let closing = dot(&minus(&own, &speed), &normal);
        if !closing.is_positive() {
            return;
        }
        let squared = dot(&normal, &normal);
        let strength = self.strength(matches!(target, Target::Disc(_)), &closing, &squared);
        let kept = match &self.restitution {
            Restitution::Paper { loss } => ratio(1.0 - loss.to_f64()),
            _ => one(),
        };
        let push = strength * closing / squared;
        let changed = |speed: &Vector, share: BigRational| {
            [0, 1].map(|axis| (&speed[axis] + &share * &push * &normal[axis]) * &kept)
        };
        let exactly = [
            changed(&own, -shares[0].clone()),
            changed(&speed, shares[1].clone()),
        ];
        let mut after = exactly
            .each_ref()
            .map(|speed| speed.each_ref().map(rounded));
        let [first, second] = after.map(exact);
        if dot(&minus(&first, &second), &normal).is_positive() {
            let back = normal.each_ref().map(|x| -x.clone());
            after = [(&exactly[0], &back), (&exactly[1], &normal)]
                .map(|(speed, side)| [0, 1].map(|axis| rounded_towards(&speed[axis], &side[axis])));
        }
        self.bodies[disc].speed = after[0];
        if let Target::Disc(other) = target {
            self.bodies[other].speed = after[1];
        }
    }
}

impl Reference {
    /// 1 + e.
    fn strength(&self, is_disc: bool, closing: &BigRational, squared: &BigRational) -> BigRational {
        let elastic = one() + one();
        let Restitution::Newton {
            coefficient,
            walls,
            elastic_below,
        } = &self.restitution
        else {
            return elastic;
        };
        let is_slow = elastic_below.as_ref().is_some_and(|speed| {
            let speed = ratio(speed.to_f64());
            closing * closing < &speed * &speed * squared
        });
        let walls = walls.as_ref().unwrap_or(coefficient);
        let coefficient = if is_disc { coefficient } else { walls };
        match is_slow {
            true => elastic,
            false => one() + ratio(coefficient.to_f64()),
        }
    }
}

impl Body {
    fn at(&self, time: &BigRational) -> Vector {
        let flown = time - ratio(self.since);
        let (place, speed) = (exact(self.place), exact(self.speed));
        [0, 1].map(|axis| &place[axis] + &speed[axis] * &flown)
    }
}

/// When a point that approaches a circle about the origin enters it: at
/// (-b - √(b² - a c)) / a, or now.
pub(crate) fn approach(offset: &Vector, velocity: &Vector, reach: &BigRational) -> Option<Surd> {
    let [a, b] = [dot(velocity, velocity), dot(offset, velocity)];
    let c = dot(offset, offset) - reach * reach;
    if !b.is_negative() {
        return None;
    }
    if !c.is_positive() {
        return Some(Surd::from(BigRational::zero()));
    }
    let d = &b * &b - &a * c;
    d.is_positive().then(|| Surd {
        p: -b / &a,
        q: -a.recip(),
        d,
    })
}

pub(crate) fn one() -> BigRational {
    BigRational::from_integer(1.into())
}

pub(crate) fn exact(vector: [f64; 2]) -> Vector {
    vector.map(ratio)
}

pub(crate) fn minus(a: &Vector, b: &Vector) -> Vector {
    [&a[0] - &b[0], &a[1] - &b[1]]
}

pub(crate) fn dot(a: &Vector, b: &Vector) -> BigRational {
    &a[0] * &b[0] + &a[1] * &b[1]
}
