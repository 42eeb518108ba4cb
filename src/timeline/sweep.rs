//! Which discs are too far apart to meet soon: plain binary64 arithmetic with
//! a bound of all its errors, cheaper by far than interval arithmetic.
//!
//! Until something changes its motion, a disc's centre keeps within `slack` of
//! the *track* a + v t in each coordinate, at all times t up to the horizon H.
//! Let x, v and s be about the middles of the bounds of position, velocity and
//! the time since when it moves so, x', v' and s' how far the bounds are from
//! these, |t|, |s| ≤ H, and u the unit roundoff. The slack is at least
//!
//! ```text
//! x' + (|v| + v') s' + 2 H v' + 8 u (|x| + 2 |v| H)
//! ```
//!
//! of which the last term is for what rounds: a = x - v s, and the distance
//! of two tracks at a time.

use super::flight::Flights;
use crate::scalar::Interval;

/// The tracks of all discs.
#[derive(Clone, Debug)]
pub(super) struct Sweep {
    x: Tracks,
    y: Tracks,
    /// The radius and the slack, rounded upwards.
    reach: Vec<f64>,
    horizon: f64,
}

/// One coordinate of all tracks.
#[derive(Clone, Debug)]
struct Tracks {
    start: Vec<f64>,
    speed: Vec<f64>,
}

/// One coordinate of one track.
#[derive(Clone, Copy, Debug)]
struct Track {
    start: f64,
    speed: f64,
}

/// Eight times the unit roundoff of binary64.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// More than the rounding of the bounds themselves.
const MARGIN: f64 = 1.0 + 1e-9;

impl Sweep {
    /// The tracks of discs in flight, up to a horizon.
    pub(super) fn new(flights: &Flights<Interval>, horizon: f64) -> Self {
        let count = flights.world.discs.len();
        let mut sweep = Self {
            x: Tracks::new(count),
            y: Tracks::new(count),
            reach: vec![0.0; count],
            horizon,
        };
        for disc in 0..count {
            sweep.update(flights, disc);
        }
        sweep
    }

    /// Takes note of a disc whose motion has changed.
    pub(super) fn update(&mut self, flights: &Flights<Interval>, disc: usize) {
        let body = &flights.world.discs[disc];
        let since = &flights.starts[disc].since;
        let (x, x_slack) = track(&body.position.x, &body.velocity.x, since, self.horizon);
        let (y, y_slack) = track(&body.position.y, &body.velocity.y, since, self.horizon);
        self.x.set(disc, x);
        self.y.set(disc, y);
        self.reach[disc] = (body.radius.hi() + x_slack.max(y_slack)) * MARGIN;
    }

    /// Whether two discs cannot touch between two times within the horizon.
    /// What is not a number proves nothing.
    #[inline]
    pub(super) fn are_apart(&self, one: usize, other: usize, from: f64, to: f64) -> bool {
        let reach = self.reach[one] + self.reach[other];
        let gap = |tracks: &Tracks| {
            let speed = tracks.speed[other] - tracks.speed[one];
            let distance = tracks.start[other] - tracks.start[one] + speed * from;
            let closing = (-speed * distance.signum()).max(0.0);
            distance.abs() - closing * (to - from) * MARGIN
        };
        gap(&self.x) > reach || gap(&self.y) > reach
    }
}

impl Tracks {
    fn new(count: usize) -> Self {
        Self {
            start: vec![0.0; count],
            speed: vec![0.0; count],
        }
    }

    fn set(&mut self, disc: usize, track: Track) {
        self.start[disc] = track.start;
        self.speed[disc] = track.speed;
    }
}

/// One coordinate of a track, and how far from it the truth can be.
fn track(position: &Interval, velocity: &Interval, since: &Interval, horizon: f64) -> (Track, f64) {
    let [x, v, s] = [position, velocity, since].map(Interval::middle);
    let [x_error, v_error, s_error] = [position, velocity, since].map(Interval::radius);
    let speed = v.abs() + v_error;
    let known = x_error + speed * s_error + 2.0 * horizon * v_error;
    let rounding = ROUNDING * (x.abs() + 2.0 * speed * horizon);
    let start = x - v * s;
    let slack = (known + rounding) * MARGIN + f64::MIN_POSITIVE;
    (Track { start, speed: v }, slack)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::scalar::Scalar;
    use crate::scene::{Disc, Scene};
    use crate::world::World;

    const HORIZON: f64 = 8.0;

    fn flights(discs: &[[f64; 4]]) -> Flights<Interval> {
        let mut scene = Scene::builder("test").frame(1, 8);
        for &[x, y, vx, vy] in discs {
            scene = scene.disc(Disc::at([x, y], 0.5).velocity([vx, vy]));
        }
        Flights::new(World::<f64>::new(&scene.build().unwrap(), ()).hull())
    }

    #[test]
    fn what_moves_apart_stays_apart() {
        let sweep = Sweep::new(
            &flights(&[[0.0, 0.0, 0.0, 0.0], [3.0, 0.0, -1.0, 0.0]]),
            HORIZON,
        );
        assert!(sweep.are_apart(0, 1, 0.0, 1.999));
        assert!(!sweep.are_apart(0, 1, 0.0, 2.0), "they touch");
        assert!(sweep.are_apart(1, 0, 4.001, 8.0));
        assert!(!sweep.are_apart(0, 1, 0.0, f64::INFINITY));
    }

    proptest! {
        /// Discs that interval arithmetic proves to meet are never said to be
        /// apart until then; with coordinates far out, where slack matters.
        #[test]
        fn discs_that_meet_are_not_apart(
            numbers in prop::array::uniform8(-3..=3_i32),
            offset in prop::sample::select(vec![0.0, 0.1, 1e8, 1e15]),
            scale in prop::sample::select(vec![1.0, 0.7, 1e-3]),
        ) {
            let [x, y, vx, vy, a, b, wx, wy] = numbers.map(|n| f64::from(n) * scale);
            let discs = [[x + offset, y, vx, vy], [a + offset, b, wx, wy]];
            let flights = flights(&discs);
            let sweep = Sweep::new(&flights, HORIZON);
            let met = flights.meet(0, crate::world::Obstacle::Disc(1));
            if let Ok(Some(meeting)) = met && meeting.time.hi() <= HORIZON {
                prop_assert!(!sweep.are_apart(0, 1, 0.0, meeting.time.hull().hi()));
            }
        }
    }
}
