//! How close a run comes to another one: its passes, one flight after the other.
//!
//! From the last change of either's velocity two bodies move straight on, up to the next
//! one. Unless they part from the start on, they come nearest on the way, or at its end;
//! or they meet there, and how deep the hit is tells how far they are from a miss.

use carom::body::{BodyId, Pair};
use carom::impact::Impact;
use carom::run::Outcome;
use carom::scalar::{Exact, Scalar};
use carom::scene::Scene;
use carom::vec2::Vec2;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::plane::{Vector, Way, minus, vector};
use super::question::{apart, margin_of_pass};
use super::scenes::time;

/// Numbers are taken to so many bits after the point.
const BITS: u32 = 160;

/// Margins below this, 2^-90, are as good as none: so well are the numbers known.
const SMALLEST: f64 = 1.0 / (1_u128 << 90) as f64;

/// The least of all margins of a run, from 0 to 1.
pub(super) fn margin(scene: &Scene, outcome: &Outcome<Exact>) -> f64 {
    let mut run = Run::new(scene);
    for impact in &outcome.impacts {
        run.meet(impact);
    }
    run.end(&scene.frame().total());
    let least = run.least.min(closest_times(&outcome.impacts));
    if least < SMALLEST { 0.0 } else { least }
}

/// How far apart the times of impacts are that follow each other on a disc.
fn closest_times(impacts: &[Impact<Exact>]) -> f64 {
    let later = |index: usize| {
        let shares = |next: &&Impact<Exact>| next.pair.shares_disc(&impacts[index].pair);
        let next = impacts[index + 1..].iter().find(shares)?;
        Some(apart(&time(&impacts[index]), &time(next)))
    };
    (0..impacts.len()).filter_map(later).fold(1.0, f64::min)
}

/// A run, as far as it has been followed.
struct Run<'a> {
    scene: &'a Scene,
    discs: Vec<Flying>,
    least: f64,
}

/// A disc since its last impact.
struct Flying {
    since: BigRational,
    position: Vector,
    velocity: Vector,
    radius: BigRational,
    /// What it met then.
    last: Option<Pair>,
}

impl<'a> Run<'a> {
    fn new(scene: &'a Scene) -> Self {
        let discs = scene.discs().iter().map(|disc| Flying {
            since: BigRational::default(),
            position: vector(&disc.position),
            velocity: vector(&disc.velocity),
            radius: disc.radius.to_rational(),
            last: None,
        });
        Self {
            scene,
            discs: discs.collect(),
            least: 1.0,
        }
    }

    /// Ends the flights of the bodies that meet, and starts new ones.
    fn meet(&mut self, impact: &Impact<Exact>) {
        let now = time(impact);
        for (one, other) in self.pairs() {
            let pair = Pair::new(one, other);
            if pair == impact.pair {
                self.pass(pair, None);
            } else if pair.shares_disc(&impact.pair) {
                self.pass(pair, Some(&now));
            }
        }
        let Some(contact) = &impact.contact else {
            return;
        };
        let centre = short(&contact.centre);
        if let (BodyId::Disc(other), Some(velocity)) = (impact.pair.b, &contact.other_velocity) {
            let [nx, ny] = short(&contact.normal);
            let place = [&centre[0] + nx, &centre[1] + ny];
            self.start(other, impact.pair, &now, place, short(velocity));
        }
        if let BodyId::Disc(one) = impact.pair.a {
            self.start(one, impact.pair, &now, centre, short(&contact.velocity));
        }
    }

    fn start(
        &mut self,
        disc: u32,
        pair: Pair,
        now: &BigRational,
        position: Vector,
        velocity: Vector,
    ) {
        let flying = &mut self.discs[disc as usize];
        *flying = Flying {
            since: now.clone(),
            position,
            velocity,
            radius: flying.radius.clone(),
            last: Some(pair),
        };
    }

    fn end(&mut self, until: &BigRational) {
        for (one, other) in self.pairs() {
            self.pass(Pair::new(one, other), Some(until));
        }
    }

    fn pairs(&self) -> Vec<(BodyId, BodyId)> {
        let discs = 0..self.discs.len() as u32;
        let walls = 0..self.scene.walls().len() as u32;
        let of = |one: u32| {
            let others = (one + 1..discs.end).map(BodyId::Disc);
            let others = others.chain(walls.clone().map(BodyId::Wall));
            others.map(move |other| (BodyId::Disc(one), other))
        };
        discs.clone().flat_map(of).collect()
    }

    /// The flight of two bodies, up to some time or on and on.
    fn pass(&mut self, pair: Pair, until: Option<&BigRational>) {
        let (BodyId::Disc(one), other) = (pair.a, pair.b) else {
            return;
        };
        let one = &self.discs[one as usize];
        let since = match other {
            BodyId::Disc(other) => one
                .since
                .clone()
                .max(self.discs[other as usize].since.clone()),
            BodyId::Wall(_) => one.since.clone(),
        };
        let has_met = one.last == Some(pair) && one.since == since;
        if has_met {
            return;
        }
        let way = self.way(one, other, &since);
        let margin = match until {
            Some(until) => margin_until(way, until - since),
            None => margin_of_pass(&way),
        };
        self.least = margin.map_or(self.least, |margin| margin.min(self.least));
    }

    fn way(&self, one: &Flying, other: BodyId, since: &BigRational) -> Way {
        let position = one.at(since);
        match other {
            BodyId::Disc(other) => {
                let other = &self.discs[other as usize];
                Way {
                    position: minus(&position, &other.at(since)),
                    velocity: minus(&one.velocity, &other.velocity),
                    reach: &one.radius + &other.radius,
                    along: None,
                }
            }
            BodyId::Wall(wall) => {
                let wall = &self.scene.walls()[wall as usize];
                let from = vector(&wall.from);
                Way {
                    position: minus(&position, &from),
                    velocity: one.velocity.clone(),
                    reach: one.radius.clone(),
                    along: Some(minus(&vector(&wall.to), &from)),
                }
            }
        }
    }
}

impl Flying {
    fn at(&self, time: &BigRational) -> Vector {
        let since = time - &self.since;
        [0, 1].map(|axis: usize| &self.position[axis] + &self.velocity[axis] * &since)
    }
}

/// The margin of a pass that ends: that of its end, if bodies still approach there.
fn margin_until(mut way: Way, duration: BigRational) -> Option<f64> {
    let start = way.start();
    let whole = way.least();
    for axis in 0..2 {
        way.position[axis] += &way.velocity[axis] * &duration;
    }
    let end = way.start();
    let least = if way.least() < end { end } else { whole };
    (least < start).then(|| way.margin(&least))
}

/// A vector, to so many bits after the point.
fn short(vector: &Vec2<Exact>) -> Vector {
    [&vector.x, &vector.y].map(|part| {
        let (lo, _) = part.enclosure().expect("all of a complete run is bounded");
        let unit = BigInt::one() << BITS;
        BigRational::new((lo * &unit).to_integer(), unit)
    })
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use carom::run::{Options, run};
    use carom::scene::{Disc, SceneBuilder};
    use carom::simulation::Algorithm;

    use super::*;

    fn margin_of(scene: SceneBuilder) -> f64 {
        let scene = scene.build().expect("a scene");
        let options = Options {
            contacts: true,
            ..Options::default()
        };
        let go_on = &mut |_| ControlFlow::Continue(());
        let outcome = run(&scene, Algorithm::Timeline, &options, go_on);
        margin(&scene, &outcome.expect("a supported scene"))
    }

    /// It passes at a distance of 3 where 2 is the reach, and again on its way back.
    #[test]
    fn a_pass_has_a_margin() {
        let other = || Disc::at([10, 0], 1);
        let scene = Scene::builder("pass").disc(Disc::at([0, 3], 1).velocity([1, 0]));
        let passing = scene.disc(other()).wall([20, -9], [20, 9]).frame(1, 30);
        assert_eq!(margin_of(passing), 0.5);
        // At the end it is 4 away in x and 3 in y: 5, and (5 - 2) / 2 is more than 1.
        let scene = Scene::builder("before").disc(Disc::at([0, 3], 1).velocity([1, 0]));
        assert_eq!(margin_of(scene.disc(other()).frame(1, 6)), 1.0);
    }

    /// At a height of 15/8 the centres would come as near as that: 1/16 of the reach.
    #[test]
    fn a_hit_is_as_deep_as_it_would_be() {
        let scene = Scene::builder("hit").disc(Disc::at(["-9", "15/8"], 1).velocity([1, 0]));
        assert_eq!(
            margin_of(scene.disc(Disc::at([0, 0], 1)).frame(1, 20)),
            0.0625
        );
    }

    /// Between walls that leave 8 to go: impacts at 4 and 12.
    #[test]
    fn times_of_a_disc_are_apart() {
        let scene = Scene::builder("box").disc(Disc::at([5, 0], 1).velocity([1, 0]));
        let walls = scene.wall([0, -9], [0, 9]).wall([10, -9], [10, 9]);
        assert_eq!(margin_of(walls.frame(1, 15)), 2.0 / 3.0);
    }

    /// Two walls at once.
    #[test]
    fn a_tie_of_a_disc_has_no_margin() {
        let scene = Scene::builder("corner").disc(Disc::at([5, 5], 1).velocity([-1, -1]));
        let walls = scene.wall([0, 0], [0, 9]).wall([0, 0], [9, 0]);
        assert_eq!(margin_of(walls.frame(1, 9)), 0.0);
    }
}
