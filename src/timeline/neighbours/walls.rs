//! Which walls a disc may meet from its cell.

use prefetch_index::prefetch_index;

use super::shape::Shape;
use crate::detect::Segment;
use crate::kernel::Kernel;
use crate::scalar::Interval;
use crate::vec2::Vec2;
use crate::world::World;

/// So many buckets have their bits in one word.
const WORD: usize = u32::BITS as usize;

/// The walls near each bucket.
#[derive(Clone, Debug)]
pub(super) struct Walls {
    /// Which buckets have walls near them.
    beside: Vec<Word>,
    /// Where the walls of each of these buckets start, in their order, and where
    /// the last ones end.
    starts: Vec<u32>,
    near: Vec<u32>,
    /// Walls that are near to all.
    everywhere: Vec<u32>,
}

/// A bit for each of some buckets, and how many bits there are in all words before.
#[derive(Clone, Copy, Debug, Default)]
struct Word {
    bits: u32,
    before: u32,
}

impl Walls {
    /// The walls that come within a reach of each cell.
    pub(super) fn new<S: Kernel>(world: &World<S>, shape: &Shape, reach: f64) -> Self {
        let (mut near, mut everywhere) = (Vec::new(), Vec::new());
        for (wall, index) in world.walls.iter().zip(0..) {
            match Band::about(&wall.segment.map(S::hull), reach).buckets(shape) {
                Some(buckets) => near.extend(buckets.into_iter().map(|bucket| (bucket, index))),
                None => everywhere.push(index),
            }
        }
        near.sort_unstable();
        near.dedup();
        let mut walls = Self {
            beside: vec![Word::default(); shape.buckets().div_ceil(WORD)],
            starts: vec![0],
            near: near.iter().map(|(_, wall)| *wall).collect(),
            everywhere,
        };
        for group in near.chunk_by(|one, other| one.0 == other.0) {
            walls.close(group[0].0, group.len());
        }
        walls.count();
        walls
    }

    /// Notes that a bucket has so many walls, after all buckets before it.
    fn close(&mut self, bucket: u32, walls: usize) {
        let start = self.starts[self.starts.len() - 1];
        self.starts.push(start + walls as u32);
        self.beside[bucket as usize / WORD].bits |= 1 << (bucket as usize % WORD);
    }

    fn count(&mut self) {
        let mut before = 0;
        for word in &mut self.beside {
            word.before = before;
            before += word.bits.count_ones();
        }
    }

    /// Fetches whether there are walls near a bucket into the cache.
    #[inline]
    pub(super) fn fetch(&self, bucket: u32) {
        prefetch_index(&self.beside, bucket as usize / WORD);
    }

    /// The walls that a disc in a bucket may meet.
    #[inline]
    pub(super) fn near(&self, bucket: u32) -> impl Iterator<Item = u32> {
        let near = &self.near[self.range(bucket)];
        near.iter().chain(&self.everywhere).copied()
    }

    #[inline]
    fn range(&self, bucket: u32) -> std::ops::Range<usize> {
        let word = self.beside[bucket as usize / WORD];
        let bit = 1 << (bucket as usize % WORD);
        if word.bits & bit == 0 {
            return 0..0;
        }
        let place = (word.before + (word.bits & (bit - 1)).count_ones()) as usize;
        self.starts[place] as usize..self.starts[place + 1] as usize
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
        let middle = |point: &Vec2<Interval>| [point.x.middle(), point.y.middle()];
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
            let [left, right] = self.row(row as f64 * shape.scale.size, shape.scale.size);
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
