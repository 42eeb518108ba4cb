//! What happens in some frames of a run, as numbers to draw.

use std::ops::Range;

use carom::arithmetic::Arithmetic;
use carom::body::{BodyId, Disc};
use carom::impact::Impact;
use carom::scalar::{Doubt, Number, Scalar, Undecided};
use carom::scene::Scene;
use carom::simulation::{Algorithm, Simulation};
use carom::vec2::Vec2;

/// A point of the plane, or a vector.
pub(super) type Vector = [f64; 2];

/// What happens in some frames.
#[derive(Clone, Debug)]
pub(in crate::cli) struct Story {
    pub(super) ways: Vec<Way>,
    pub(super) walls: Vec<[Vector; 2]>,
    /// The places of discs when they collide, impact by impact.
    pub(super) impacts: Vec<Vec<Struck>>,
    /// The simulated time.
    pub(super) duration: f64,
}

/// The way of a disc.
#[derive(Clone, Debug)]
pub(super) struct Way {
    pub(super) radius: f64,
    /// How fast it moves at first.
    pub(super) velocity: Vector,
    /// Where it starts, where it turns and where it ends.
    pub(super) points: Vec<Vector>,
    /// The point of its last impact.
    pub(super) last: Option<usize>,
    /// The point at which the latest frame ends.
    end: Option<usize>,
    /// Whether it has met nothing in that frame.
    quiet: bool,
}

/// A disc that collides.
#[derive(Clone, Debug)]
pub(super) struct Struck {
    pub(super) centre: Vector,
    pub(super) radius: f64,
    /// How fast it moves from then on.
    pub(super) velocity: Vector,
}

/// How discs move between impacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Course {
    /// In straight lines.
    Straight,
    /// Likewise, but for frames in which they collide.
    Stepwise,
    /// In curves, which are drawn from one frame's end to the next.
    Bent,
}

impl Course {
    fn of(scene: &Scene, algorithm: Algorithm) -> Self {
        if scene.effects().gravity.is_some() {
            Self::Bent
        } else if algorithm == Algorithm::Timeline {
            Self::Straight
        } else {
            Self::Stepwise
        }
    }
}

impl Story {
    /// The story of some frames of a run.
    ///
    /// # Errors
    ///
    /// The precision leaves a decision open.
    pub(in crate::cli) fn of<S: Arithmetic>(
        scene: &Scene,
        algorithm: Algorithm,
        precision: S::Precision,
        frames: Range<u64>,
    ) -> Result<Self, Undecided> {
        let undecided = <S::Doubt as Doubt>::into_undecided;
        let simulation = Simulation::<S>::new(scene, algorithm, precision);
        let mut simulation = simulation.map_err(undecided)?;
        for _ in 0..frames.start {
            simulation.next_frame().map_err(undecided)?;
        }
        let mut story = Self::begun(scene, &simulation.discs());
        let course = Course::of(scene, algorithm);
        for _ in frames.clone() {
            let impacts = simulation.next_frame().map_err(undecided)?;
            impacts.iter().for_each(|impact| story.add(impact));
            story.close(&simulation.discs(), course);
        }
        let length = (frames.end - frames.start) as f64;
        story.duration = scene.frame().duration.to_f64() * length;
        Ok(story)
    }

    fn begun<S: Scalar>(scene: &Scene, discs: &[Disc<S>]) -> Self {
        let walls = scene.walls().iter();
        let point = |point: &[Number; 2]| point.each_ref().map(Number::to_f64);
        Self {
            ways: discs.iter().map(Way::begun).collect(),
            walls: walls
                .map(|wall| [point(&wall.from), point(&wall.to)])
                .collect(),
            impacts: Vec::new(),
            duration: 0.0,
        }
    }

    /// Adds an impact, with the places of its discs.
    fn add<S: Scalar>(&mut self, impact: &Impact<S>) {
        let Some(contact) = &impact.contact else {
            return;
        };
        let [centre, normal, velocity] =
            [&contact.centre, &contact.normal, &contact.velocity].map(numbers);
        let mut struck = Vec::new();
        if let BodyId::Disc(disc) = impact.pair.a {
            struck.push(self.strike(disc as usize, centre, velocity));
        }
        if let (BodyId::Disc(other), Some(velocity)) = (impact.pair.b, &contact.other_velocity) {
            let other = other as usize;
            let reach = self.ways[other].radius + struck.first().map_or(0.0, |first| first.radius);
            let length = normal[0].hypot(normal[1]);
            let place = [0, 1].map(|axis| centre[axis] + normal[axis] * reach / length);
            struck.push(self.strike(other, place, numbers(velocity)));
        }
        self.impacts.push(struck);
    }

    fn strike(&mut self, disc: usize, centre: Vector, velocity: Vector) -> Struck {
        let way = &mut self.ways[disc];
        way.last = Some(way.points.len());
        way.points.push(centre);
        Struck {
            centre,
            radius: way.radius,
            velocity,
        }
    }

    /// Notes where discs are at the end of a frame.
    fn close<S: Scalar>(&mut self, discs: &[Disc<S>], course: Course) {
        for (way, body) in self.ways.iter_mut().zip(discs) {
            way.close(numbers(&body.position), course);
        }
    }

    /// Where discs collide and where they end, as a list to compare.
    pub(in crate::cli) fn places(&self) -> Vec<Vector> {
        let struck = self.impacts.iter().flatten().map(|struck| struck.centre);
        let ends = self
            .ways
            .iter()
            .filter_map(|way| way.points.last().copied());
        struck.chain(ends).collect()
    }
}

impl Way {
    /// Notes where it is at the end of a frame, in place of the end of a frame before, if
    /// it has moved on in a straight line since.
    fn close(&mut self, place: Vector, course: Course) {
        let is_quiet = self.last <= self.end;
        let goes_on = match course {
            Course::Bent => false,
            Course::Stepwise => is_quiet && self.quiet,
            Course::Straight => is_quiet,
        };
        if goes_on && self.end.is_some() {
            self.points.pop();
        }
        self.end = Some(self.points.len());
        self.quiet = is_quiet;
        self.points.push(place);
    }

    fn begun<S: Scalar>(disc: &Disc<S>) -> Self {
        Self {
            radius: disc.radius.to_f64(),
            velocity: numbers(&disc.velocity),
            points: vec![numbers(&disc.position)],
            last: None,
            end: None,
            quiet: true,
        }
    }
}

fn numbers<S: Scalar>(vector: &Vec2<S>) -> Vector {
    [vector.x.to_f64(), vector.y.to_f64()]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn story(name: &str, algorithm: Algorithm, frames: Range<u64>) -> Story {
        let path = format!("{}/scenes/{name}.json", env!("CARGO_MANIFEST_DIR"));
        let scene = Scene::read(path).expect("a scene");
        Story::of::<f64>(&scene, algorithm, (), frames).expect("binary64 decides all")
    }

    /// A disc that starts at 0 with speed 4 meets one at 4, both of radius 1: at 2, after
    /// half a frame. It goes back, or stays for the rest of the frame.
    #[test]
    fn figure_7_has_its_points() {
        let single = story("figure-7", Algorithm::Single, 0..3);
        assert_eq!(
            single.ways[0].points,
            [[0.0, 0.0], [2.0, 0.0], [2.0, 0.0], [-6.0, 0.0]]
        );
        let timeline = story("figure-7", Algorithm::Timeline, 0..3);
        assert_eq!(
            timeline.ways[0].points,
            [[0.0, 0.0], [2.0, 0.0], [-8.0, 0.0]]
        );
        assert_eq!(timeline.ways[0].last, Some(1));
        assert_eq!(timeline.duration, 3.0);
        let [struck, fixed] = &timeline.impacts[0][..] else {
            panic!("two discs: {:?}", timeline.impacts);
        };
        assert_eq!((struck.centre, struck.velocity), ([2.0, 0.0], [-4.0, 0.0]));
        assert_eq!((fixed.centre, fixed.velocity), ([4.0, 0.0], [0.0, 0.0]));
    }

    /// The second frame alone begins at 0, on the way back.
    #[test]
    fn a_frame_alone() {
        let second = story("figure-7", Algorithm::Timeline, 1..2);
        assert_eq!(second.ways[0].points, [[0.0, 0.0], [-4.0, 0.0]]);
        assert_eq!(second.ways[0].velocity, [-4.0, 0.0]);
        assert!(second.impacts.is_empty() && second.ways[0].last.is_none());
    }
}
