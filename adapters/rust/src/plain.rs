//! Scenes in binary64.

use carom::scalar::Number;
use carom::scene::{Mass, Scene};

/// A run of more steps is refused.
const MOST_STEPS: f64 = 1e6;

/// A scene with every number rounded to binary64, or left out where no engine here has it.
#[derive(Clone, Debug)]
pub struct Plain {
    /// The discs.
    pub discs: Vec<Disc>,
    /// The walls.
    pub walls: Vec<Wall>,
    /// The duration of a frame.
    pub frame: f64,
    /// How many frames there are.
    pub count: u64,
    /// What impacts leave.
    pub restitution: Restitution,
    /// The acceleration of all discs of finite mass, if there is one.
    pub gravity: Option<[f64; 2]>,
}

/// A disc at the start.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    /// The centre.
    pub position: [f64; 2],
    /// The velocity.
    pub velocity: [f64; 2],
    /// The radius.
    pub radius: f64,
    /// The mass; none if infinite.
    pub mass: Option<f64>,
}

/// A segment, by its ends.
pub type Wall = [[f64; 2]; 2];

/// Newton's law of restitution.
#[derive(Clone, Copy, Debug)]
pub struct Restitution {
    /// The coefficient between discs.
    pub discs: f64,
    /// That with walls.
    pub walls: f64,
    /// Below this normal relative speed impacts are elastic.
    pub elastic_below: Option<f64>,
}

/// The steps of a run.
#[derive(Clone, Copy, Debug)]
pub struct Steps {
    /// How long one lasts.
    pub length: f64,
    /// How many there are.
    pub count: u64,
}

impl Plain {
    /// The scene in binary64, or why it has none.
    pub fn new(scene: &Scene) -> Result<Self, String> {
        if scene.periodic().is_some() {
            return Err(String::from("the engine has no periodic scenes"));
        }
        if scene.effects().drag.is_some() {
            return Err(String::from("the engine has no linear drag"));
        }
        let scene = Self {
            discs: scene.discs().iter().map(disc).collect::<Result<_, _>>()?,
            walls: scene.walls().iter().map(wall).collect::<Result<_, _>>()?,
            frame: positive(&scene.frame().duration)?,
            count: scene.frame().count,
            restitution: restitution(&scene.effects().restitution)?,
            gravity: scene.effects().gravity.as_ref().map(point).transpose()?,
        };
        match scene.until().is_finite() {
            true => Ok(scene),
            false => Err(String::from("the end of the run is beyond binary64")),
        }
    }

    /// When the run ends.
    pub fn until(&self) -> f64 {
        self.frame * self.count as f64
    }

    /// Steps such that a frame has at least so many, and none is longer than that.
    pub fn steps(&self, substeps: u64, longest: f64) -> Result<Steps, String> {
        let a_frame = (self.frame / longest).max(substeps as f64).ceil();
        if a_frame * self.count as f64 <= MOST_STEPS {
            return Ok(Steps {
                length: self.frame / a_frame,
                count: a_frame as u64 * self.count,
            });
        }
        Err(format!("more than {MOST_STEPS} steps"))
    }
}

fn disc(disc: &carom::scene::Disc) -> Result<Disc, String> {
    Ok(Disc {
        position: point(&disc.position)?,
        velocity: point(&disc.velocity)?,
        radius: positive(&disc.radius)?,
        mass: match &disc.mass {
            Mass::Finite(mass) => Some(positive(mass)?),
            Mass::Infinite => None,
        },
    })
}

fn wall(wall: &carom::scene::Wall) -> Result<Wall, String> {
    let ends = [point(&wall.from)?, point(&wall.to)?];
    match ends[0] == ends[1] {
        true => Err(String::from("the ends of a wall are one point in binary64")),
        false => Ok(ends),
    }
}

fn restitution(restitution: &carom::scene::Restitution) -> Result<Restitution, String> {
    match restitution {
        carom::scene::Restitution::Elastic => Ok(Restitution {
            discs: 1.0,
            walls: 1.0,
            elastic_below: None,
        }),
        carom::scene::Restitution::Newton {
            coefficient,
            walls,
            elastic_below,
        } => Ok(Restitution {
            discs: finite(coefficient)?,
            walls: finite(walls.as_ref().unwrap_or(coefficient))?,
            elastic_below: elastic_below.as_ref().map(finite).transpose()?,
        }),
        carom::scene::Restitution::Paper { .. } => Err(String::from(
            "the engine has no restitution in the paper's convention",
        )),
    }
}

fn point([x, y]: &[Number; 2]) -> Result<[f64; 2], String> {
    Ok([finite(x)?, finite(y)?])
}

/// A number that is positive in binary64, too.
fn positive(number: &Number) -> Result<f64, String> {
    match finite(number)? {
        value if value > 0.0 => Ok(value),
        _ => Err(format!("zero in binary64: {number}")),
    }
}

fn finite(number: &Number) -> Result<f64, String> {
    let value = number.to_f64();
    match value.is_finite() {
        true => Ok(value),
        false => Err(String::from("a number beyond binary64")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frames(duration: &str, count: u64) -> Plain {
        let scene = Scene::builder("frames").frame(duration, count);
        Plain::new(&scene.build().expect("a scene")).expect("numbers")
    }

    /// A quarter by at most an eighth has 2 steps, but 4 are asked for; by at most 1/32, 8.
    #[test]
    fn steps_divide_frames() {
        let scene = frames("1/4", 3);
        for (longest, length, count) in [(0.125, 0.0625, 12), (0.03125, 0.03125, 24)] {
            let steps = scene.steps(4, longest).expect("few steps");
            assert_eq!((steps.length, steps.count), (length, count));
        }
        assert!(scene.steps(400_000, 1.0).is_err());
        assert!(scene.steps(4, 0.0).is_err());
    }

    #[test]
    fn numbers_beyond_binary64_are_refused() {
        let disc = |radius: &str| {
            let disc = carom::scene::Disc::at([0, 0], radius);
            Plain::new(&Scene::builder("disc").disc(disc).build().expect("a scene"))
        };
        assert_eq!(disc("1/3").expect("a number").discs[0].radius, 1.0 / 3.0);
        assert!(disc("1e999").is_err());
        assert!(disc("1e-999").is_err());
        let endless = Scene::builder("endless").frame("1e308", 2);
        assert!(Plain::new(&endless.build().expect("a scene")).is_err());
    }
}
