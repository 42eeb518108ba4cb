//! `rapier2d`, which steps: contacts are found at the start of a step, ahead of the motion.
//!
//! A time is that of the end of the step whose contacts the engine reports.

use std::collections::BTreeSet;
use std::sync::mpsc::{Receiver, channel};

use carom_adapters::{Body, Disc, Engine, Impact, Options, Plain, Restitution, serve};
use rapier2d_f64::prelude::*;

const USAGE: &str = "usage: rapier2d [OPTION VALUE]…
  --substeps N      a frame of the scene has at least so many steps (default 10)
  --max-step S      no step is longer (default 1/60, 0.01666…)
  --length-unit L   the engine's length_unit (default: the mean diameter of the scene's discs)
  --ccd-substeps N  the engine's max_ccd_substeps (default 1, as in the engine; 0: no CCD)
  --recycling B     the engine's contact_recycling (default true, as in the engine)
  --prediction D    the engine's normalized_prediction_distance (default 0.02, as in the engine)
  --report WHAT     started: collision events that start (default);
                    impulse: contacts that push and did not in the step before";

const OPTIONS: [&str; 7] = [
    "substeps",
    "max-step",
    "length-unit",
    "ccd-substeps",
    "recycling",
    "prediction",
    "report",
];

fn main() -> std::io::Result<()> {
    let options = Options::of_program(USAGE, &OPTIONS);
    serve(&mut Rapier {
        substeps: options.get("substeps").unwrap_or(10),
        longest: options.get("max-step").unwrap_or(1.0 / 60.0),
        length_unit: options.get("length-unit"),
        ccd_substeps: options.get("ccd-substeps"),
        recycling: options.get("recycling"),
        prediction: options.get("prediction"),
        report: options.get("report").unwrap_or(Report::Started),
    })
}

/// How the engine is run. What is not given is left as the engine has it, except for the
/// unit of length.
struct Rapier {
    substeps: u64,
    longest: f64,
    length_unit: Option<f64>,
    ccd_substeps: Option<usize>,
    recycling: Option<bool>,
    prediction: Option<f64>,
    report: Report,
}

/// What is taken for an impact.
#[derive(Clone, Copy, PartialEq)]
enum Report {
    /// A collision event that starts.
    Started,
    /// A contact that pushes, and did not in the step before.
    Impulse,
}

impl std::str::FromStr for Report {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        match text {
            "started" => Ok(Self::Started),
            "impulse" => Ok(Self::Impulse),
            _ => Err(()),
        }
    }
}

impl Engine for Rapier {
    fn simulate(&mut self, scene: &Plain) -> Result<Vec<Impact>, String> {
        let restitution = one_coefficient(&scene.restitution)?;
        let steps = scene.steps(self.substeps, self.longest)?;
        let mut world = self.fill(scene, restitution);
        world.integration_parameters.dt = steps.length;
        let (collector, started) = listener();
        let (mut impacts, mut pushing) = (Vec::new(), BTreeSet::new());
        for step in 1..=steps.count {
            world.step_with_events(&(), &collector);
            // The last step ends with the run, and not by rounding after it.
            let time = (step as f64 * steps.length).min(scene.until());
            let found = match self.report {
                Report::Started => begun(&world, &started),
                Report::Impulse => newly(&mut pushing, pushed(&world)),
            };
            impacts.extend(found.into_iter().map(|pair| impact(time, pair)));
        }
        Ok(impacts)
    }

    fn first_impact(&mut self, _: &Disc, _: &Body) -> Result<Option<f64>, String> {
        Err(String::from(
            "the engine has no such query of its own; its queries are those of parry2d",
        ))
    }
}

/// The engine has a coefficient for each collider, and combines two of them.
fn one_coefficient(restitution: &Restitution) -> Result<f64, String> {
    if restitution.elastic_below.is_some() {
        let reason = "the engine has no restitution that ends below a speed (elastic_below)";
        return Err(String::from(reason));
    }
    match restitution.discs == restitution.walls {
        true => Ok(restitution.discs),
        false => Err(String::from(
            "the engine's rules do not combine to restitution of walls alone",
        )),
    }
}

impl Rapier {
    fn set(&self, parameters: &mut IntegrationParameters, diameter: f64) {
        parameters.length_unit = self.length_unit.unwrap_or(diameter);
        if let Some(substeps) = self.ccd_substeps {
            parameters.max_ccd_substeps = substeps;
        }
        if let Some(recycling) = self.recycling {
            parameters.contact_recycling = recycling;
        }
        if let Some(distance) = self.prediction {
            parameters.normalized_prediction_distance = distance;
        }
    }

    fn fill(&self, scene: &Plain, restitution: f64) -> PhysicsWorld {
        let mut world = PhysicsWorld::new();
        world.gravity = scene.gravity.map_or(Vector::ZERO, vector);
        self.set(&mut world.integration_parameters, mean_diameter(scene));
        let finish = |collider: ColliderBuilder, name| {
            let elastic = collider.restitution(restitution).friction(0.0);
            let elastic = elastic.restitution_combine_rule(CoefficientCombineRule::Max);
            let events = ActiveEvents::COLLISION_EVENTS;
            elastic.active_events(events).user_data(name)
        };
        for (place, disc) in scene.discs.iter().enumerate() {
            let ball = ColliderBuilder::ball(disc.radius).mass(disc.mass.unwrap_or(1.0));
            world.insert(body(disc), finish(ball, disc_name(place)));
        }
        for (place, [from, to]) in scene.walls.iter().enumerate() {
            let segment = ColliderBuilder::segment(vector(*from), vector(*to));
            world.insert(RigidBodyBuilder::fixed(), finish(segment, wall_name(place)));
        }
        world
    }
}

/// The body of a disc; one of infinite mass moves at its velocity, undeflected.
fn body(disc: &Disc) -> RigidBodyBuilder {
    let body = match disc.mass {
        Some(_) => RigidBodyBuilder::dynamic(),
        None => RigidBodyBuilder::kinematic_velocity_based(),
    };
    body.translation(vector(disc.position))
        .linvel(vector(disc.velocity))
        .lock_rotations()
        .can_sleep(false)
        .ccd_enabled(true)
}

fn mean_diameter(scene: &Plain) -> f64 {
    let radii = scene.discs.iter().map(|disc| disc.radius);
    match scene.discs.len() {
        0 => 1.0,
        count => 2.0 * radii.sum::<f64>() / count as f64,
    }
}

fn vector([x, y]: [f64; 2]) -> Vector {
    Vector::new(x, y)
}

/// Discs have even names and walls odd ones.
fn disc_name(place: usize) -> u128 {
    2 * place as u128
}

fn wall_name(place: usize) -> u128 {
    disc_name(place) + 1
}

/// The names of two bodies, at least one of them a disc, which is first.
type Pair = (u128, u128);

fn pair(world: &PhysicsWorld, one: ColliderHandle, other: ColliderHandle) -> Pair {
    let [one, other] = [one, other].map(|handle| world.colliders[handle].user_data);
    match one % 2 == 0 {
        true => (one, other),
        false => (other, one),
    }
}

fn impact(time: f64, (disc, other): Pair) -> Impact {
    let [i, j] = [disc, other].map(|name| (name / 2) as usize);
    match other % 2 == 0 {
        true => Impact::of_discs(time, i, j),
        false => Impact::with_wall(time, i, j),
    }
}

/// The engine's own collector of events, and where collision events arrive.
fn listener() -> (ChannelEventCollector, Receiver<CollisionEvent>) {
    let (sender, receiver) = channel();
    let collector = ChannelEventCollector::new(sender, channel().0, channel().0);
    (collector, receiver)
}

/// The contacts that began in this step, in the engine's order.
fn begun(world: &PhysicsWorld, started: &Receiver<CollisionEvent>) -> Vec<Pair> {
    let events = started.try_iter().filter(|event| event.started());
    events
        .map(|event| pair(world, event.collider1(), event.collider2()))
        .collect()
}

/// The contacts with an impulse in this step.
fn pushed(world: &PhysicsWorld) -> BTreeSet<Pair> {
    let contacts = world.narrow_phase.contact_pairs();
    contacts
        .filter(|contact| contact.total_impulse_magnitude() > 0.0)
        .map(|contact| pair(world, contact.collider1, contact.collider2))
        .collect()
}

/// Those that are there now and were not before; what is there now is kept.
fn newly(before: &mut BTreeSet<Pair>, now: BTreeSet<Pair>) -> Vec<Pair> {
    let new = now.difference(before).copied().collect();
    *before = now;
    new
}
