//! What happens in a span of time, as numbers to draw.

use carom::scalar::Number;
use carom::scene::Scene;

use crate::cli::motion::{Motion, Point, Struck, Track};

/// A curve is drawn by so many straight pieces a leg.
const PIECES: u32 = 16;

/// What happens in a span of time.
#[derive(Debug)]
pub(in crate::cli) struct Story {
    pub(super) ways: Vec<Way>,
    pub(super) walls: Vec<[Point; 2]>,
    /// The places of discs when they collide, impact by impact.
    pub(super) impacts: Vec<Vec<Hit>>,
    pub(super) duration: f64,
}

/// The way of a disc.
#[derive(Debug)]
pub(super) struct Way {
    pub(super) radius: f64,
    /// How fast it moves at first.
    pub(super) velocity: Point,
    /// Where it starts, where it turns and where it ends.
    pub(super) points: Vec<Point>,
    /// The point of its last impact.
    pub(super) last: Option<usize>,
}

/// A disc that collides.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hit {
    pub(super) centre: Point,
    pub(super) radius: f64,
    /// How fast it moves from then on.
    pub(super) velocity: Point,
}

impl Story {
    /// What happens in a scene's motion after a time, or from zero on, up to another.
    pub(in crate::cli) fn of(scene: &Scene, motion: &Motion, [from, to]: [f64; 2]) -> Self {
        let is_in = |time: f64| (time > from || from == 0.0) && time <= to;
        let impacts = motion.impacts.iter().filter(|mark| is_in(mark.time));
        let impacts: Vec<&[Struck]> = impacts.map(|mark| &mark.bodies[..]).collect();
        let last = |disc: usize| {
            let own = impacts.iter().copied().flatten();
            let times = own.filter(|struck| struck.disc == disc);
            times.map(|struck| struck.leg.time).reduce(f64::max)
        };
        let tracks = motion.discs.iter().enumerate();
        let point = |point: &[Number; 2]| point.each_ref().map(Number::to_f64);
        let walls = scene.walls().iter();
        Self {
            ways: tracks
                .map(|(disc, track)| Way::of(track, [from, to], last(disc)))
                .collect(),
            walls: walls
                .map(|wall| [point(&wall.from), point(&wall.to)])
                .collect(),
            impacts: impacts
                .iter()
                .map(|bodies| bodies.iter().map(|body| Hit::of(motion, body)).collect())
                .collect(),
            duration: to - from,
        }
    }

    /// Where discs collide and where they end, as a list to compare.
    pub(in crate::cli) fn places(&self) -> Vec<Point> {
        let struck = self.impacts.iter().flatten().map(|struck| struck.centre);
        let ends = self
            .ways
            .iter()
            .filter_map(|way| way.points.last().copied());
        struck.chain(ends).collect()
    }
}

impl Hit {
    fn of(motion: &Motion, struck: &Struck) -> Self {
        Self {
            centre: struck.leg.position,
            radius: motion.discs[struck.disc].radius,
            velocity: struck.leg.velocity,
        }
    }
}

impl Way {
    /// The way of a disc in a span of time in which it collides last at some time.
    fn of(track: &Track, [from, to]: [f64; 2], last: Option<f64>) -> Self {
        let turns = track.legs.iter().map(|leg| leg.time);
        let turns = turns.filter(|time| *time > from && *time < to);
        let mut times: Vec<f64> = turns.chain(last).chain([from, to]).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        if !track.pull.is_straight() {
            times = refined(&times);
        }
        Self {
            radius: track.radius,
            velocity: track.velocity_at(from),
            last: last.map(|last| times.partition_point(|time| *time < last)),
            points: times.into_iter().map(|time| track.at(time)).collect(),
        }
    }
}

/// Times with others between them.
fn refined(times: &[f64]) -> Vec<f64> {
    let between = times.windows(2).flat_map(|pair| {
        let part = |piece| f64::from(piece) / f64::from(PIECES);
        (0..PIECES).map(move |piece| pair[0] + (pair[1] - pair[0]) * part(piece))
    });
    between.chain(times.last().copied()).collect()
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow::Continue;

    use carom::run::{Options, run};
    use carom::simulation::Algorithm;

    use super::*;

    fn story(name: &str, algorithm: Algorithm, span: [f64; 2]) -> Story {
        let path = format!("{}/scenes/{name}.json", env!("CARGO_MANIFEST_DIR"));
        let scene = Scene::read(path).expect("a scene");
        let options = Options {
            contacts: true,
            ..Options::default()
        };
        let outcome = run::<f64>(&scene, algorithm, &options, &mut |_| Continue(()));
        let motion = Motion::new(&scene, algorithm, &outcome.expect("a run"));
        Story::of(&scene, &motion, span)
    }

    /// A disc that starts at 0 with speed 4 meets one at 4, both of radius 1: at 2, after
    /// half a frame. It goes back, or stays for the rest of the frame.
    #[test]
    fn figure_7_has_its_points() {
        let single = story("figure-7", Algorithm::Single, [0.0, 3.0]);
        let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 0.0], [-6.0, 0.0]];
        assert_eq!(single.ways[0].points, points);
        let timeline = story("figure-7", Algorithm::Timeline, [0.0, 3.0]);
        let points = [[0.0, 0.0], [2.0, 0.0], [-8.0, 0.0]];
        assert_eq!(timeline.ways[0].points, points);
        assert_eq!(timeline.ways[0].last, Some(1));
        assert_eq!(timeline.duration, 3.0);
        let [struck, fixed] = &timeline.impacts[0][..] else {
            panic!("two discs: {:?}", timeline.impacts);
        };
        let (centre, velocity) = (struck.centre, struck.velocity);
        assert_eq!((centre, velocity), ([2.0, 0.0], [-4.0, 0.0]));
        let (centre, velocity) = (fixed.centre, fixed.velocity);
        assert_eq!((centre, velocity), ([4.0, 0.0], [0.0, 0.0]));
    }

    /// The second frame alone begins at 0, on the way back.
    #[test]
    fn a_frame_alone() {
        let second = story("figure-7", Algorithm::Timeline, [1.0, 2.0]);
        assert_eq!(second.ways[0].points, [[0.0, 0.0], [-4.0, 0.0]]);
        assert_eq!(second.ways[0].velocity, [-4.0, 0.0]);
        assert!(second.impacts.is_empty() && second.ways[0].last.is_none());
    }
}
