//! The crate `collider`: event-driven detection, to which the response is added here.
//! Walls are squares beside the box.

use std::time::Instant;

use carom::scene::Scene;
use collider::geom::{Shape, Vec2, v2};
use collider::{Collider, HbEvent, HbId, HbProfile, HbVel};

/// Walls have names from here on.
const FIRST_WALL: HbId = 1 << 32;

#[derive(Clone, Copy, Debug)]
struct Body(HbId);

impl HbProfile for Body {
    fn id(&self) -> HbId {
        self.0
    }

    fn can_interact(&self, other: &Self) -> bool {
        !(self.is_wall() && other.is_wall())
    }

    fn cell_width() -> f64 {
        2.0
    }

    fn padding() -> f64 {
        1e-6
    }
}

impl Body {
    fn is_wall(self) -> bool {
        self.0 >= FIRST_WALL
    }
}

/// Impacts a second.
pub fn pace(scene: &Scene, impacts: u64) -> f64 {
    let mut collider = fill(scene);
    let begun = Instant::now();
    let mut count = 0;
    while count < impacts {
        collider.set_time(collider.next_time());
        while let Some((event, one, other)) = collider.next() {
            if event == HbEvent::Collide {
                respond(&mut collider, one, other);
                count += 1;
            }
        }
    }
    impacts as f64 / begun.elapsed().as_secs_f64()
}

fn fill(scene: &Scene) -> Collider<Body> {
    let mut collider = Collider::new();
    for (index, disc) in scene.discs().iter().enumerate() {
        let (place, velocity) = (disc.position_f64(), disc.velocity_f64());
        let shape = Shape::circle(2.0 * disc.radius.to_f64());
        let hitbox = shape
            .place(v2(place.x, place.y))
            .moving(v2(velocity.x, velocity.y));
        collider.add_hitbox(Body(index as HbId), hitbox);
    }
    let ends = scene.walls().iter().flat_map(|wall| [&wall.from, &wall.to]);
    let side = ends
        .map(|[x, y]| x.to_f64().max(y.to_f64()))
        .fold(0.0, f64::max);
    let around = [(-0.5, 0.5), (1.5, 0.5), (0.5, -0.5), (0.5, 1.5)];
    for (number, (x, y)) in around.into_iter().enumerate() {
        let wall = Shape::square(side).place(v2(x * side, y * side)).still();
        collider.add_hitbox(Body(FIRST_WALL + number as HbId), wall);
    }
    collider
}

/// Discs of one mass, and walls, without loss. Of two bodies in increasing order the
/// wall is the second.
fn respond(collider: &mut Collider<Body>, one: Body, other: Body) {
    let [first, second] = [one, other].map(|body| collider.get_hitbox(body.0));
    let normal = second.value.normal_from(&first.value).dir();
    let relative = second.vel.value - first.vel.value;
    let approach = relative.x * normal.x + relative.y * normal.y;
    let part = if other.is_wall() { 2.0 } else { 1.0 };
    let change = part * approach;
    turn(collider, one, first.vel.value, normal, change);
    if !other.is_wall() {
        turn(collider, other, second.vel.value, normal, -change);
    }
}

fn turn(collider: &mut Collider<Body>, body: Body, velocity: Vec2, normal: Vec2, change: f64) {
    let velocity = v2(
        velocity.x + change * normal.x,
        velocity.y + change * normal.y,
    );
    collider.set_hitbox_vel(body.0, HbVel::moving(velocity));
}
