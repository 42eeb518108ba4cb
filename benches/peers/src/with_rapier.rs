//! rapier2d, which steps through frames: without gravity, friction, spin and sleep, its
//! restitution 1.

use std::time::Instant;

use carom::scene::Scene;
use rapier2d_f64::prelude::*;

/// Milliseconds a frame.
pub fn frame(scene: &Scene, continuous: bool) -> f64 {
    let mut world = fill(scene, continuous);
    let frames = scene.frame().count;
    let begun = Instant::now();
    for _ in 0..frames {
        world.step();
    }
    begun.elapsed().as_secs_f64() * 1e3 / frames as f64
}

fn fill(scene: &Scene, continuous: bool) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    world.integration_parameters.dt = scene.frame().duration.to_f64();
    for disc in scene.discs() {
        let (place, velocity) = (disc.position_f64(), disc.velocity_f64());
        let body = RigidBodyBuilder::dynamic()
            .translation(Vector::new(place.x, place.y))
            .linvel(Vector::new(velocity.x, velocity.y))
            .lock_rotations()
            .can_sleep(false)
            .ccd_enabled(continuous);
        world.insert(body, elastic(ColliderBuilder::ball(disc.radius.to_f64())));
    }
    for wall in scene.walls() {
        let [from, to] = [&wall.from, &wall.to].map(|[x, y]| Vector::new(x.to_f64(), y.to_f64()));
        world.insert(
            RigidBodyBuilder::fixed(),
            elastic(ColliderBuilder::segment(from, to)),
        );
    }
    world
}

fn elastic(collider: ColliderBuilder) -> ColliderBuilder {
    collider.restitution(1.0).friction(0.0)
}
