//! A smaller scene with a finding of the same kind.
//!
//! Greedy: whatever can be left out or rounded is, one at a time, as long as the
//! finding remains, until nothing more can.

use super::check;
use super::finding::Finding;
use crate::scalar::Number;
use crate::scene::{Cell, Disc, Effects, Mass, Restitution, Scene, Wall};

/// The most scenes that are tried.
const TRIALS: usize = 4000;

/// A scene that has a finding of the same kind, with fewer bodies and frames
/// and rounder numbers.
///
/// # Examples
///
/// ```
/// use carom::check::{check, minimise};
/// use carom::scene::{Disc, Scene};
///
/// let scene = Scene::builder("example").disc(Disc::at([0, 0], 1)).build()?;
/// if let Err(finding) = check(&scene) {
///     let smaller = minimise(&scene, &finding);
///     println!("{finding}, already with {} discs", smaller.discs().len());
/// }
/// # Ok::<(), carom::scene::SceneError>(())
/// ```
pub fn minimise(scene: &Scene, finding: &Finding) -> Scene {
    let shows = |scene: &Scene| check(scene).is_err_and(|found| found.kind.is_like(&finding.kind));
    minimise_by(scene, shows)
}

/// A smaller scene that shows something, as the scene itself does: with fewer bodies,
/// frames and effects, and rounder numbers.
///
/// # Examples
///
/// ```
/// use carom::check::minimise_by;
/// use carom::scene::{Disc, Scene};
///
/// let discs = [1, 2, 3].map(|radius| Disc::at([10 * radius, 0], radius));
/// let scene = Scene::builder("example").discs(discs).build()?;
/// let two = minimise_by(&scene, |scene| scene.discs().len() >= 2);
/// assert_eq!(two.discs().len(), 2);
/// # Ok::<(), carom::scene::SceneError>(())
/// ```
pub fn minimise_by(scene: &Scene, shows: impl Fn(&Scene) -> bool) -> Scene {
    let mut draft = Draft::from(scene);
    let mut trials = TRIALS;
    while let Some(next) = draft.smaller(scene, &shows, &mut trials) {
        draft = next;
    }
    draft.scene(scene).unwrap_or_else(|| scene.clone())
}

/// What of a scene may be left out or rounded.
#[derive(Clone)]
struct Draft {
    discs: Vec<Disc>,
    walls: Vec<Wall>,
    duration: Number,
    frames: u64,
    effects: Effects,
}

impl From<&Scene> for Draft {
    fn from(scene: &Scene) -> Self {
        Self {
            discs: scene.discs().to_vec(),
            walls: scene.walls().to_vec(),
            duration: scene.frame().duration.clone(),
            frames: scene.frame().count,
            effects: scene.effects().clone(),
        }
    }
}

impl Draft {
    /// The scene, under the name of the original; none if it is not valid.
    fn scene(&self, original: &Scene) -> Option<Scene> {
        let Effects {
            restitution,
            gravity,
            drag,
        } = self.effects.clone();
        let mut scene = Scene::builder(original.id())
            .discs(self.discs.iter().cloned())
            .frame(&self.duration, self.frames)
            .restitution(restitution);
        for Wall { from, to } in &self.walls {
            scene = scene.wall([&from[0], &from[1]], [&to[0], &to[1]]);
        }
        if let Some([x, y]) = &gravity {
            scene = scene.gravity([x, y]);
        }
        if let Some(rate) = &drag {
            scene = scene.linear_drag(rate);
        }
        if let Some(Cell { from, to }) = original.periodic() {
            scene = scene.periodic([&from[0], &from[1]], [&to[0], &to[1]]);
        }
        scene.build().ok()
    }

    /// The first smaller draft that still shows it, while trials are left.
    fn smaller(
        &self,
        original: &Scene,
        shows: &impl Fn(&Scene) -> bool,
        trials: &mut usize,
    ) -> Option<Self> {
        let without = self.without_discs().chain(self.without_walls());
        let mut drafts = without.chain(self.simpler_frames()).chain(self.rounder());
        drafts.find(|draft| {
            let scene = draft.scene(original).filter(|_| *trials > 0);
            *trials = trials.saturating_sub(1);
            scene.is_some_and(|scene| shows(&scene))
        })
    }

    fn without_discs(&self) -> impl Iterator<Item = Self> {
        (0..self.discs.len()).map(|index| {
            let mut draft = self.clone();
            draft.discs.remove(index);
            draft
        })
    }

    fn without_walls(&self) -> impl Iterator<Item = Self> {
        (0..self.walls.len()).map(|index| {
            let mut draft = self.clone();
            draft.walls.remove(index);
            draft
        })
    }

    fn simpler_frames(&self) -> impl Iterator<Item = Self> {
        let frames = [1, self.frames / 2, self.frames - 1].into_iter();
        let frames = frames.filter(|&frames| 0 < frames && frames < self.frames);
        let fewer = frames.map(|frames| Self {
            frames,
            ..self.clone()
        });
        fewer.chain(self.fewer_effects())
    }

    fn fewer_effects(&self) -> impl Iterator<Item = Self> {
        let without = |leave_out: fn(&mut Effects)| {
            let mut draft = self.clone();
            leave_out(&mut draft.effects);
            (draft.effects != self.effects).then_some(draft)
        };
        let elastic = without(|effects| effects.restitution = Restitution::Elastic);
        let weightless = without(|effects| effects.gravity = None);
        let free = without(|effects| effects.drag = None);
        elastic.into_iter().chain(weightless).chain(free)
    }

    /// The drafts in which one number is rounder.
    fn rounder(&self) -> impl Iterator<Item = Self> {
        let mut numbers = self.clone();
        let values: Vec<_> = numbers.numbers().map(|number| number.to_f64()).collect();
        let choices = values.into_iter().enumerate();
        let choices = choices.flat_map(|(place, value)| rounder(value).map(move |to| (place, to)));
        choices.filter_map(|(place, value)| {
            let mut draft = self.clone();
            *draft.numbers().nth(place)? = Number::try_from(value).ok()?;
            Some(draft)
        })
    }

    fn numbers(&mut self) -> impl Iterator<Item = &mut Number> {
        let discs = self.discs.iter_mut().flat_map(|disc| {
            let mass = match &mut disc.mass {
                Mass::Finite(mass) => Some(mass),
                Mass::Infinite => None,
            };
            let vectors = disc.position.iter_mut().chain(&mut disc.velocity);
            vectors.chain([&mut disc.radius]).chain(mass)
        });
        let walls = self.walls.iter_mut();
        let walls = walls.flat_map(|wall| wall.from.iter_mut().chain(&mut wall.to));
        discs.chain(walls).chain([&mut self.duration])
    }
}

/// Rounder numbers than a given one, the roundest first: zero or one, a whole
/// one, one of few bits.
fn rounder(value: f64) -> impl Iterator<Item = f64> {
    let bits = [1, 2, 4, 8, 16, 32].map(|bits| leading(value, bits));
    let choices = [0.0, 1.0, value.round()].into_iter().chain(bits);
    choices.filter(move |&choice| weight(choice) < weight(value))
}

/// How much there is to a number: its bits from the first to the last one, and
/// those before or after the point.
fn weight(value: f64) -> u32 {
    if value == 0.0 {
        return 0;
    }
    let mantissa = value.to_bits() << 12;
    let bits = 65 - mantissa.trailing_zeros();
    let exponent = (value.to_bits() >> 52 & 0x7ff) as i32 - 1023;
    64 * bits + exponent.unsigned_abs() + 1
}

/// The leading bits of a number, the rest cut off.
fn leading(value: f64, bits: u32) -> f64 {
    f64::from_bits(value.to_bits() & (u64::MAX << (53 - bits)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_get_rounder() {
        let choices = |value: f64| rounder(value).collect::<Vec<_>>();
        assert!(choices(0.0).is_empty());
        assert_eq!(choices(1.0), [0.0]);
        assert_eq!(choices(3.25), [0.0, 1.0, 3.0, 2.0, 3.0]);
        assert!(choices(0.1).contains(&0.0625));
    }

    /// What it takes to show is one disc of a radius above 2 and any wall.
    #[test]
    fn what_is_not_needed_goes() {
        let scene = Scene::builder("large")
            .discs([1.3, 2.7, 5.1].map(|x| Disc::at([x, x], x).velocity([0.3, x])))
            .walls_around([0.1, 0.1], [77.7, 77.7])
            .frame("1/60", 9)
            .build()
            .unwrap();
        let is_large = |disc: &Disc| disc.radius.to_f64() > 2.0;
        let shows = |scene: &Scene| scene.discs().iter().any(is_large) && !scene.walls().is_empty();
        let small = minimise_by(&scene, shows);
        assert_eq!((small.discs().len(), small.walls().len()), (1, 1));
        assert_eq!((small.frame().count, small.id()), (1, "large"));
        assert_eq!(
            small.discs()[0].position.each_ref().map(Number::to_f64),
            [0.0, 0.0]
        );
        assert!(weight(small.discs()[0].radius.to_f64()) < weight(5.1));
    }
}
