//! Building scenes, by hand or from a file.

use super::input::{Given, IntoNumber, IntoPoint};
use super::{
    Cell, Disc, DiscBuilder, Effects, Frame, Restitution, Scene, SceneError, Wall, validate,
};
use crate::scalar::Number;

/// A scene in the making. Nothing is checked before [`Self::build`], which
/// tells the first thing that is wrong.
#[derive(Debug)]
#[must_use = "a scene in the making does nothing until it is built"]
pub struct SceneBuilder {
    scene: Scene,
    fault: Option<SceneError>,
}

impl SceneBuilder {
    pub(super) fn new(id: String) -> Self {
        Self::from(Scene {
            id,
            notes: None,
            discs: Vec::new(),
            walls: Vec::new(),
            periodic: None,
            frame: Frame::default(),
            effects: Effects::default(),
        })
    }

    /// Renames the scene.
    pub fn id(mut self, id: impl Into<String>) -> Self {
        self.scene.id = id.into();
        self
    }

    /// Says what there is to know about the scene.
    pub fn notes(mut self, notes: impl Into<String>) -> Self {
        self.scene.notes = Some(notes.into());
        self
    }

    /// Adds a disc.
    pub fn disc(mut self, disc: impl Into<DiscBuilder>) -> Self {
        let disc = make_disc(self.scene.discs.len(), disc.into());
        if let Some(disc) = self.accept(disc) {
            self.scene.discs.push(disc);
        }
        self
    }

    /// Adds discs.
    pub fn discs<D: Into<DiscBuilder>>(self, discs: impl IntoIterator<Item = D>) -> Self {
        discs.into_iter().fold(self, Self::disc)
    }

    /// Takes all discs out again.
    pub fn without_discs(mut self) -> Self {
        self.scene.discs.clear();
        self
    }

    /// Adds a wall between two points.
    pub fn wall(mut self, from: impl IntoPoint, to: impl IntoPoint) -> Self {
        let place = format!("walls[{}]", self.scene.walls.len());
        let ends = corners(&place, from, to);
        if let Some([from, to]) = self.accept(ends) {
            self.scene.walls.push(Wall { from, to });
        }
        self
    }

    /// Adds the four walls of a rectangle, given by its lower left and upper
    /// right corners: the lower, right, upper and left wall.
    pub fn walls_around(mut self, from: impl IntoPoint, to: impl IntoPoint) -> Self {
        let place = format!("walls[{}]", self.scene.walls.len());
        let corners = corners(&place, from, to);
        if let Some([[left, low], [right, high]]) = self.accept(corners) {
            self.scene.walls.extend(rectangle(left, low, right, high));
        }
        self
    }

    /// Repeats the rectangle between two corners, the lower left one and the
    /// upper right one, in both directions.
    pub fn periodic(mut self, from: impl IntoPoint, to: impl IntoPoint) -> Self {
        let corners = corners("periodic", from, to);
        if let Some([from, to]) = self.accept(corners) {
            self.scene.periodic = Some(Cell { from, to });
        }
        self
    }

    /// Sets how long a frame lasts and how many there are.
    pub fn frame(mut self, duration: impl IntoNumber, count: u64) -> Self {
        let duration = number("frame.duration", duration.into_number());
        if let Some(duration) = self.accept(duration) {
            self.scene.frame = Frame { duration, count };
        }
        self
    }

    /// Sets what impacts leave of the motion.
    pub fn restitution(mut self, restitution: Restitution) -> Self {
        self.scene.effects.restitution = restitution;
        self
    }

    /// Accelerates every disc of finite mass.
    pub fn gravity(mut self, acceleration: impl IntoPoint) -> Self {
        let acceleration = point("effects.gravity", acceleration.into_point());
        if let Some(acceleration) = self.accept(acceleration) {
            self.scene.effects.gravity = Some(acceleration);
        }
        self
    }

    /// Slows every disc of finite mass at a rate proportional to its speed.
    pub fn linear_drag(mut self, rate: impl IntoNumber) -> Self {
        let rate = number("effects.drag.linear", rate.into_number());
        if let Some(rate) = self.accept(rate) {
            self.scene.effects.drag = Some(rate);
        }
        self
    }

    /// The scene, unless something is wrong with it.
    pub fn build(self) -> Result<Scene, SceneError> {
        match self.fault {
            Some(fault) => Err(fault),
            None => validate::validated(self.scene),
        }
    }

    /// The value, unless it is wrong; the first fault is kept for the end.
    fn accept<T>(&mut self, value: Result<T, SceneError>) -> Option<T> {
        match value {
            Ok(value) => Some(value),
            Err(fault) => {
                self.fault.get_or_insert(fault);
                None
            }
        }
    }
}

impl From<Scene> for SceneBuilder {
    fn from(scene: Scene) -> Self {
        Self { scene, fault: None }
    }
}

fn make_disc(index: usize, disc: DiscBuilder) -> Result<Disc, SceneError> {
    let place = |key| format!("discs[{index}].{key}");
    Ok(Disc {
        position: point(&place("position"), disc.position)?,
        velocity: point(&place("velocity"), disc.velocity)?,
        radius: number(&place("radius"), disc.radius)?,
        mass: disc
            .mass
            .map_err(|error| SceneError::format(place("mass"), error))?,
    })
}

fn number(place: &str, given: Given) -> Result<Number, SceneError> {
    given.map_err(|error| SceneError::format(place, error))
}

fn point(place: &str, [x, y]: [Given; 2]) -> Result<[Number; 2], SceneError> {
    Ok([
        number(&format!("{place}[0]"), x)?,
        number(&format!("{place}[1]"), y)?,
    ])
}

/// Two points under the keys `from` and `to`.
fn corners(
    place: &str,
    from: impl IntoPoint,
    to: impl IntoPoint,
) -> Result<[[Number; 2]; 2], SceneError> {
    Ok([
        point(&format!("{place}.from"), from.into_point())?,
        point(&format!("{place}.to"), to.into_point())?,
    ])
}

fn rectangle(left: Number, low: Number, right: Number, high: Number) -> [Wall; 4] {
    let corner = |x: &Number, y: &Number| [x.clone(), y.clone()];
    let corners = [
        corner(&left, &low),
        corner(&right, &low),
        corner(&right, &high),
        corner(&left, &high),
    ];
    std::array::from_fn(|side| Wall {
        from: corners[side].clone(),
        to: corners[(side + 1) % 4].clone(),
    })
}
