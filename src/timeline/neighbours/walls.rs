//! Which walls a disc may meet from its cell.

use super::grid::Shape;
use crate::detect::Segment;
use crate::scalar::Interval;
use crate::world::World;

/// The walls near each bucket.
#[derive(Clone, Debug)]
pub(super) struct Walls {
    /// Where the walls of each bucket start.
    starts: Vec<u32>,
    near: Vec<u32>,
    /// Walls that are near to all.
    everywhere: Vec<u32>,
}

impl Walls {
    /// The walls that come within a reach of each cell.
    pub(super) fn new(world: &World<Interval>, shape: &Shape, reach: f64) -> Self {
        let (mut near, mut everywhere) = (Vec::new(), Vec::new());
        for (wall, index) in world.walls.iter().zip(0..) {
            match Band::about(&wall.segment, reach).buckets(shape) {
                Some(buckets) => near.extend(buckets.into_iter().map(|bucket| (bucket, index))),
                None => everywhere.push(index),
            }
        }
        near.sort_unstable();
        near.dedup();
        let mut starts = vec![0; shape.buckets() + 1];
        for (bucket, _) in &near {
            starts[*bucket as usize + 1] += 1;
        }
        for bucket in 0..shape.buckets() {
            starts[bucket + 1] += starts[bucket];
        }
        Self {
            starts,
            near: near.into_iter().map(|(_, wall)| wall).collect(),
            everywhere,
        }
    }

    /// The walls that a disc in a bucket may meet.
    #[inline]
    pub(super) fn near(&self, bucket: u32) -> impl Iterator<Item = u32> {
        let [start, end] = [0, 1].map(|more| self.starts[bucket as usize + more] as usize);
        let near = self.near[start..end].iter();
        near.chain(&self.everywhere).copied()
    }
}

/// All that is no further from a segment than a reach, and a little more.
struct Band {
    /// The end points, the lower one first.
    low: [f64; 2],
    high: [f64; 2],
    reach: f64,
}

impl Band {
    fn about(segment: &Segment<Interval>, reach: f64) -> Self {
        let middle = |point: &crate::vec2::Vec2<Interval>| [point.x.middle(), point.y.middle()];
        let [from, to] = [middle(&segment.from), middle(&segment.to)];
        let (low, high) = if from[1] <= to[1] {
            (from, to)
        } else {
            (to, from)
        };
        let size = [low, high]
            .as_flattened()
            .iter()
            .fold(0.0_f64, |size, end| size.max(end.abs()));
        let rounding = 16.0 * f64::EPSILON * size;
        Self {
            low,
            high,
            reach: reach * (1.0 + 1e-9) + rounding,
        }
    }

    /// The buckets of the cells that it covers, unless these are too many.
    fn buckets(&self, shape: &Shape) -> Option<Vec<u32>> {
        let bottom = shape.cell(self.low[1] - self.reach)?;
        let top = shape.cell(self.high[1] + self.reach)?;
        let most = 4 * shape.buckets() as i64;
        let mut buckets = Vec::new();
        if top - bottom > most {
            return None;
        }
        for row in bottom..=top {
            let [left, right] = self.row(row as f64 * shape.size, shape.size);
            let (left, right) = (shape.cell(left)?, shape.cell(right)?);
            if right - left + buckets.len() as i64 > most {
                return None;
            }
            buckets.extend((left..=right).map(|column| shape.bucket([column, row])));
        }
        Some(buckets)
    }

    /// The ends in x of its part in a row of cells.
    fn row(&self, bottom: f64, height: f64) -> [f64; 2] {
        let ([x, y], [to_x, to_y]) = (self.low, self.high);
        let part = |level: f64| ((level - y) / (to_y - y)).clamp(0.0, 1.0);
        let ends = if to_y - y > self.reach {
            [
                part(bottom - self.reach),
                part(bottom + height + self.reach),
            ]
        } else {
            [0.0, 1.0]
        };
        let [one, other] = ends.map(|part| x + (to_x - x) * part);
        [one.min(other) - self.reach, one.max(other) + self.reach]
    }
}
