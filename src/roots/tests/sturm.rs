//! Zeros by Sturm's theorem, in rationals: shares nothing with what it checks.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// By ascending powers.
pub(crate) type Coefficients = Vec<BigRational>;

pub(crate) fn ratio(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

pub(crate) fn value(f: &[BigRational], t: &BigRational) -> BigRational {
    let step = |sum: BigRational, a: &BigRational| sum * t + a;
    f.iter().rev().fold(BigRational::zero(), step)
}

fn trimmed(mut f: Coefficients) -> Coefficients {
    while f.last().is_some_and(Zero::is_zero) {
        f.pop();
    }
    f
}

fn derivative(f: &[BigRational]) -> Coefficients {
    let terms = f.iter().enumerate().skip(1);
    terms.map(|(n, a)| a * ratio(n as i64, 1)).collect()
}

fn negated_remainder(a: &[BigRational], b: &[BigRational]) -> Coefficients {
    let mut rest = a.to_vec();
    while rest.len() >= b.len() {
        let factor = rest.last().unwrap() / b.last().unwrap();
        let place = rest.len() - b.len();
        for (x, y) in rest[place..].iter_mut().zip(b) {
            *x -= &factor * y;
        }
        rest.pop();
        rest = trimmed(rest);
    }
    rest.iter().map(|a| -a).collect()
}

/// What counts zeros.
pub(crate) struct Sturm(Vec<Coefficients>);

impl Sturm {
    pub(crate) fn new(f: &[BigRational]) -> Self {
        let f = trimmed(f.to_vec());
        let mut sequence = vec![f.clone(), trimmed(derivative(&f))];
        while !sequence.last().unwrap().is_empty() {
            let [.., a, b] = &sequence[..] else {
                unreachable!()
            };
            sequence.push(negated_remainder(a, b));
        }
        sequence.pop();
        Self(sequence)
    }

    fn changes(&self, t: &BigRational) -> usize {
        let values = self
            .0
            .iter()
            .map(|f| value(f, t))
            .filter(|value| !value.is_zero());
        let signs: Vec<bool> = values.map(|value| value.is_positive()).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }

    /// How many different zeros lie above one place, which is none, and not above
    /// another one, which is none.
    pub(crate) fn count(&self, from: &BigRational, to: &BigRational) -> usize {
        self.changes(from) - self.changes(to)
    }
}

/// The first descent above 0: between two places that are
/// less than a part in 2^`bits` of 1 apart, and whether it is a graze.
pub(crate) fn descent(f: &[BigRational], bits: usize) -> Option<([BigRational; 2], bool)> {
    let sturm = Sturm::new(f);
    for mut ends in isolated(f, &sturm) {
        let [before, after] = ends.clone().map(|end| value(f, &end).is_positive());
        if !before {
            continue;
        }
        let width = ratio(1, 2).pow(bits as i32);
        while &ends[1] - &ends[0] > width {
            let [low, high] = halves(f, &ends);
            let is_low = match after {
                true => sturm.count(&low[0], &low[1]) > 0,
                false => !value(f, &low[1]).is_positive(),
            };
            ends = if is_low { low } else { high };
        }
        return Some((ends, after));
    }
    None
}

/// Two parts, at a place near the middle that is no zero.
fn halves(f: &[BigRational], [low, high]: &[BigRational; 2]) -> [[BigRational; 2]; 2] {
    let parts = (0..9).map(|n| low + (high - low) * ratio(16 + n, 33));
    let middle = parts.into_iter().find(|t| !value(f, t).is_zero()).unwrap();
    [[low.clone(), middle.clone()], [middle, high.clone()]]
}

/// Parts of the positive numbers with one zero each.
fn isolated(f: &[BigRational], sturm: &Sturm) -> Vec<[BigRational; 2]> {
    let leading = trimmed(f.to_vec()).last().cloned().unwrap_or_default();
    let sum: BigRational = f.iter().map(Signed::abs).sum();
    if leading.is_zero() {
        return Vec::new();
    }
    // Cauchy's bound, and that of the inverses.
    let trailing = f.iter().find(|a| !a.is_zero()).unwrap().abs();
    let high = &sum / leading.abs() + ratio(1, 1);
    let low = (&sum / trailing + ratio(1, 1)).recip();
    let (mut parts, mut found) = (vec![[low, high]], Vec::new());
    while let Some(part) = parts.pop() {
        match sturm.count(&part[0], &part[1]) {
            0 => {}
            1 => found.push(part),
            _ => {
                let [low, high] = halves(f, &part);
                parts.extend([high, low]);
            }
        }
    }
    found
}
