//! Rigid motions of a scene, and of its run.

use carom::body;
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::{Disc, Scene};
use carom::vec2::Vec2;

use crate::common::agree::rational;

/// A point goes to a multiple of itself by a matrix, then some way, and from
/// there along at a constant velocity.
pub(crate) struct Change {
    pub(crate) matrix: [[&'static str; 2]; 2],
    pub(crate) shift: [&'static str; 2],
    pub(crate) drift: [&'static str; 2],
}

impl Change {
    /// The change that changes nothing.
    pub(crate) const NONE: Self = Self {
        matrix: [["1", "0"], ["0", "1"]],
        shift: ["0", "0"],
        drift: ["0", "0"],
    };

    /// A scene as it is after the change: with restitution, but without other
    /// effects.
    pub(crate) fn of(&self, scene: &Scene) -> Scene {
        let start = Exact::from_integer(0);
        let place = |at: &[Number; 2]| written(&self.place(&vector(at), &start));
        let discs = scene.discs().iter().map(|disc| Disc {
            position: place(&disc.position),
            velocity: written(&self.velocity(&vector(&disc.velocity))),
            ..disc.clone()
        });
        let frame = scene.frame();
        let changed = Scene::builder(scene.id())
            .frame(&frame.duration, frame.count)
            .restitution(scene.effects().restitution.clone())
            .discs(discs);
        let walls = scene.walls().iter();
        let changed = walls.fold(changed, |changed, wall| {
            changed.wall(place(&wall.from), place(&wall.to))
        });
        changed.build().expect("a valid scene")
    }

    /// Where a point is after the change, at a time.
    fn place(&self, point: &Vec2<Exact>, time: &Exact) -> Vec2<Exact> {
        let shifted = self.turned(point).plus(&constant(self.shift));
        shifted.moved(&constant(self.drift), time)
    }

    fn velocity(&self, velocity: &Vec2<Exact>) -> Vec2<Exact> {
        self.turned(velocity).plus(&constant(self.drift))
    }

    /// Position and velocity that a disc has after the change, at a time.
    pub(crate) fn of_disc(&self, disc: &body::Disc<Exact>, time: &Exact) -> [Exact; 4] {
        let position = self.place(&disc.position, time);
        let velocity = self.velocity(&disc.velocity);
        [position.x, position.y, velocity.x, velocity.y]
    }

    fn turned(&self, vector: &Vec2<Exact>) -> Vec2<Exact> {
        let [x, y] = self.matrix.map(|row| constant(row).dot(vector));
        Vec2::new(x, y)
    }
}

fn constant(texts: [&str; 2]) -> Vec2<Exact> {
    vector(&texts.map(|text| text.parse().expect("a number")))
}

fn vector([x, y]: &[Number; 2]) -> Vec2<Exact> {
    let [x, y] = [x, y].map(|number| Exact::from_number(number, 0));
    Vec2::new(x, y)
}

fn written(vector: &Vec2<Exact>) -> [Number; 2] {
    [&vector.x, &vector.y].map(|value| rational(value).try_into().expect("a small number"))
}
