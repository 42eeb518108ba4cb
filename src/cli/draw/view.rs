//! From the plane to a picture: all that is drawn, in so many pixels, y upwards.

use super::story::Story;
use crate::cli::motion::Point;

/// The width of a picture in pixels, or its height if that is larger.
const SIZE: f64 = 480.0;

/// Room at each side.
const MARGIN: f64 = 24.0;

/// What is seen.
pub(super) struct View {
    low: Point,
    high: Point,
    scale: f64,
}

impl View {
    /// All of some stories: discs wherever they start, collide and end, and walls.
    pub(super) fn of<'a>(stories: impl Iterator<Item = &'a Story>) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        let mut take = |point: &Point, radius: f64| {
            for axis in [0, 1] {
                low[axis] = low[axis].min(point[axis] - radius);
                high[axis] = high[axis].max(point[axis] + radius);
            }
        };
        for story in stories {
            for way in &story.ways {
                way.points.iter().for_each(|point| take(point, way.radius));
            }
            story.walls.iter().flatten().for_each(|end| take(end, 0.0));
        }
        let side = (high[0] - low[0]).max(high[1] - low[1]);
        Self {
            low,
            high,
            scale: SIZE / side,
        }
    }

    /// The width and the height.
    pub(super) fn size(&self) -> Point {
        [0, 1].map(|axis| self.length(self.high[axis] - self.low[axis]) + 2.0 * MARGIN)
    }

    pub(super) fn point(&self, [x, y]: Point) -> Point {
        [
            self.length(x - self.low[0]) + MARGIN,
            self.length(self.high[1] - y) + MARGIN,
        ]
    }

    pub(super) fn length(&self, length: f64) -> f64 {
        length * self.scale
    }
}
