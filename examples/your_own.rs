//! A small simulation of somebody's own, and a test that holds it against the truth.
//!
//! It needs nothing of the command line: `carom = { version = "0.1", default-features =
//! false }` among the dev-dependencies will do. `examples/your_own.py` is the same in
//! Python, by way of `carom oracle`.

use std::ops::ControlFlow::Continue;

use carom::body::{BodyId, Pair};
use carom::judge::{Logged, Reference, Verdict};
use carom::run::Options;
use carom::scene::{Disc, Scene};

/// What is tested: equal discs between walls at 0 and `side`, from one impact to the next.
struct Gas {
    side: f64,
    radius: f64,
    places: Vec<[f64; 2]>,
    velocities: Vec<[f64; 2]>,
}

impl Gas {
    /// The impacts up to a time: when, which disc, and which other one or which wall.
    fn run(mut self, until: f64) -> Vec<(f64, usize, Result<usize, usize>)> {
        let (mut impacts, mut time) = (Vec::new(), 0.0);
        while let Some((wait, disc, other)) = self.next() {
            time += wait;
            if time > until {
                break;
            }
            for (place, velocity) in self.places.iter_mut().zip(&self.velocities) {
                (0..2).for_each(|axis| place[axis] += velocity[axis] * wait);
            }
            match other {
                Ok(other) => self.collide(disc, other),
                Err(wall) => self.velocities[disc][(wall + 1) % 2] *= -1.0,
            }
            impacts.push((time, disc, other));
        }
        impacts
    }

    fn next(&self) -> Option<(f64, usize, Result<usize, usize>)> {
        let discs = 0..self.places.len();
        let all = discs.flat_map(|disc| {
            let walls = (0..4).map(move |wall| (self.to_wall(disc, wall), disc, Err(wall)));
            let others = disc + 1..self.places.len();
            walls.chain(others.map(move |other| (self.to_disc(disc, other), disc, Ok(other))))
        });
        all.filter(|next| next.0.is_finite())
            .min_by(|one, other| one.0.total_cmp(&other.0))
    }

    /// Walls in the order of carom's `walls_around`: below, right, above, left.
    fn to_wall(&self, disc: usize, wall: usize) -> f64 {
        let axis = (wall + 1) % 2;
        let (place, speed) = (self.places[disc][axis], self.velocities[disc][axis]);
        match (wall, speed) {
            (0 | 3, speed) if speed < 0.0 => (self.radius - place) / speed,
            (1 | 2, speed) if speed > 0.0 => (self.side - self.radius - place) / speed,
            _ => f64::INFINITY,
        }
    }

    fn to_disc(&self, one: usize, other: usize) -> f64 {
        let [gap, speed] = [&self.places, &self.velocities]
            .map(|all| [all[other][0] - all[one][0], all[other][1] - all[one][1]]);
        let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
        let (a, b) = (dot(speed, speed), dot(gap, speed));
        let c = dot(gap, gap) - 4.0 * self.radius * self.radius;
        let root = b * b - a * c;
        match b < 0.0 && root > 0.0 {
            true => c / (root.sqrt() - b),
            false => f64::INFINITY,
        }
    }

    /// Equal masses exchange what is along the line between them.
    fn collide(&mut self, one: usize, other: usize) {
        let normal = [0, 1].map(|axis| self.places[other][axis] - self.places[one][axis]);
        let speed = [0, 1].map(|axis| self.velocities[other][axis] - self.velocities[one][axis]);
        let part = (speed[0] * normal[0] + speed[1] * normal[1])
            / (normal[0] * normal[0] + normal[1] * normal[1]);
        for (axis, along) in normal.into_iter().enumerate() {
            self.velocities[one][axis] += part * along;
            self.velocities[other][axis] -= part * along;
        }
    }
}

/// Four discs in a box, for one or the other.
const START: [[f64; 4]; 4] = [
    [2.0, 2.0, 3.0, 1.0],
    [6.0, 3.0, -2.0, 2.5],
    [3.0, 7.0, 1.0, -4.0],
    [7.5, 7.0, -1.5, -1.0],
];

/// The check itself.
fn verdict() -> Result<Verdict, Box<dyn std::error::Error>> {
    let discs = START.map(|[x, y, vx, vy]| Disc::at([x, y], 1).velocity([vx, vy]));
    let scene = Scene::builder("gas")
        .discs(discs)
        .walls_around([0, 0], [10, 10]);
    let scene = scene.frame(10, 1).build()?;
    let log = gas().run(10.0).into_iter().map(|(time, disc, other)| {
        let [a, b] = [BodyId::Disc(disc as u32), body(other)];
        Logged {
            pair: Pair::new(a, b),
            time,
            tie: None,
        }
    });
    let truth = Reference::find(&scene, &Options::default(), &mut |_| Continue(()))?;
    Ok(truth.judge(&log.collect::<Vec<_>>()))
}

fn gas() -> Gas {
    Gas {
        side: 10.0,
        radius: 1.0,
        places: START.map(|[x, y, ..]| [x, y]).to_vec(),
        velocities: START.map(|[.., vx, vy]| [vx, vy]).to_vec(),
    }
}

fn body(other: Result<usize, usize>) -> BodyId {
    match other {
        Ok(disc) => BodyId::Disc(disc as u32),
        Err(wall) => BodyId::Wall(wall as u32),
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("{:#?}", verdict()?);
    Ok(())
}

#[test]
fn it_follows_the_truth() {
    let verdict = verdict().expect("a scene that carom simulates");
    assert!(!verdict.is_blamed(), "{verdict:#?}");
    assert!(verdict.matched > 20);
}
