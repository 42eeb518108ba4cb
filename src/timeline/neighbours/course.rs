//! One coordinate of a disc's motion, through the cells of a grid.

use super::Motion;
use super::grid::MARGIN;
use super::shape::Scale;

/// One coordinate of a disc's motion.
pub(super) struct Course {
    pub(super) cell: i64,
    /// When it leaves the cell, by half the margin.
    pub(super) leave: f64,
    start: f64,
    pub(super) speed: f64,
    /// How far off it may be at the start.
    known: f64,
    size: f64,
    /// How far off the speed may be.
    uncertain: f64,
    since: f64,
}

impl Course {
    /// One coordinate of a motion from a time on.
    #[inline(always)]
    pub(super) fn follow(motion: &Motion, axis: usize, time: f64, scale: &Scale) -> Option<Self> {
        let [position, velocity] = [motion.position[axis], motion.velocity[axis]];
        let (speed, since) = (velocity.value, motion.since.value);
        let start = position.value + speed * (time - since);
        let cell = scale.cell(start)?;
        let size = scale.size;
        // Without branches, for the direction is as good as random.
        let ahead = (start - (cell as f64 + 0.5) * size) * 1_f64.copysign(speed);
        let way = (0.5 + MARGIN / 2.0) * size - ahead;
        Some(Self {
            cell,
            // Never, for a speed of zero.
            leave: time + way / speed.abs(),
            start,
            speed,
            known: position.error + speed.abs() * motion.since.error,
            size: position.value.abs() + position.error,
            uncertain: velocity.error,
            since,
        })
    }

    /// Between what it is from its start at a time until another.
    #[inline]
    pub(super) fn between(&self, time: f64, until: f64) -> [f64; 2] {
        let end = match self.speed {
            0.0 => self.start,
            speed => self.start + speed * (until - time),
        };
        [self.start.min(end), self.start.max(end)]
    }

    /// How far off it may be at a time, with all that rounds until then.
    #[inline(always)]
    pub(super) fn error_at(&self, time: f64) -> f64 {
        let speed = self.speed.abs();
        if time == f64::INFINITY {
            // It rests, if it is certain to.
            let rests = speed == 0.0 && self.uncertain == 0.0;
            return if rests { self.known } else { f64::INFINITY };
        }
        let flown = (time - self.since).abs();
        let way = (speed + self.uncertain) * flown;
        let rounds = 8.0 * f64::EPSILON * (self.size + way + speed * time.abs());
        self.known + self.uncertain * flown + rounds
    }
}
