//! Orthogonal matrices in binary64.
//!
//! Householder's triangularisation with column pivoting (Golub and Van Loan:
//! Matrix Computations, section 5.4). Nothing here is proven; whoever uses
//! the matrix bounds how far it is from orthogonal.

/// Columns of an orthogonal matrix; the first k span what the k longest
/// `vectors` nearly span, each measured without its part in the span before.
pub(super) fn frame(dimension: usize, vectors: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let measured = vectors
        .into_iter()
        .map(|vector| (dot(&vector, &vector), vector));
    let mut vectors: Vec<_> = measured.collect();
    let mut mirrors: Vec<Mirror> = Vec::with_capacity(dimension);
    while mirrors.len() < dimension {
        let done = mirrors.len();
        let Some(mirror) =
            take_longest(&mut vectors).and_then(|vector| Mirror::of(&vector[done..]))
        else {
            break;
        };
        for (length_squared, vector) in &mut vectors {
            mirror.apply(&mut vector[done..]);
            *length_squared -= vector[done] * vector[done];
        }
        mirrors.push(mirror);
    }
    let columns = 0..dimension;
    columns
        .map(|column| image(column, dimension, &mirrors))
        .collect()
}

/// The longest of vectors that come with their lengths squared.
fn take_longest(vectors: &mut Vec<(f64, Vec<f64>)>) -> Option<Vec<f64>> {
    let lengths = vectors.iter().map(|(length_squared, _)| length_squared);
    let (longest, _) = lengths
        .enumerate()
        .max_by(|one, other| one.1.total_cmp(other.1))?;
    Some(vectors.swap_remove(longest).1)
}

/// Where all mirrors take a unit vector, the last one first.
fn image(column: usize, dimension: usize, mirrors: &[Mirror]) -> Vec<f64> {
    let mut vector = vec![0.0; dimension];
    vector[column] = 1.0;
    for (done, mirror) in mirrors.iter().enumerate().take(column + 1).rev() {
        mirror.apply(&mut vector[done..]);
    }
    vector
}

/// The reflection in the plane with a normal of length √2.
struct Mirror {
    normal: Vec<f64>,
}

impl Mirror {
    /// The mirror that takes a vector to the first axis, unless it is null.
    fn of(vector: &[f64]) -> Option<Self> {
        let mut vector = vector.to_vec();
        let length = dot(&vector, &vector).sqrt();
        let first = vector.first_mut()?;
        *first += length.copysign(*first);
        let factor = (2.0 / dot(&vector, &vector)).sqrt();
        if !(length > 0.0 && factor.is_finite()) {
            return None;
        }
        vector.iter_mut().for_each(|entry| *entry *= factor);
        Some(Self { normal: vector })
    }

    fn apply(&self, vector: &mut [f64]) {
        let along = dot(&self.normal, vector);
        for (entry, normal) in vector.iter_mut().zip(&self.normal) {
            *entry -= along * normal;
        }
    }
}

/// The products that are summed up side by side.
const LANES: usize = 8;

/// A bound of the relative rounding error of [`dot`], as a part of the sum of
/// the products' magnitudes.
pub(super) fn rounding(dimension: usize) -> f64 {
    // A term meets one product, at most this many sums, and 2^-53 each.
    (dimension / LANES + LANES + 4) as f64 * f64::EPSILON
}

/// The scalar product.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut lanes = [0.0; LANES];
    let (a, b) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest: f64 = a
        .remainder()
        .iter()
        .zip(b.remainder())
        .map(|(a, b)| a * b)
        .sum();
    for (a, b) in a.zip(b) {
        for (lane, (a, b)) in lanes.iter_mut().zip(a.iter().zip(b)) {
            *lane += a * b;
        }
    }
    lanes.iter().sum::<f64>() + rest
}
