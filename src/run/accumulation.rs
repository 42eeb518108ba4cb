//! What a run says of infinitely many impacts, in rationals.

use std::fmt;

use num_rational::BigRational;

use crate::arithmetic::Arithmetic;
use crate::body::Pair;
use crate::timeline;

/// Infinitely many impacts before a finite time, at which a run cannot but
/// end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Accumulation {
    /// The time that they approach: proven bounds, or twice the binary64
    /// number that is expected.
    pub limit: [BigRational; 2],
    /// Whether it is proven that the impacts go on for ever, and between the
    /// bounds.
    pub proven: bool,
    /// The pairs that collide in turn.
    pub word: Vec<Pair>,
}

impl Accumulation {
    /// The middle of the limit's bounds, as the nearest binary64.
    pub fn limit_to_f64(&self) -> f64 {
        let [lo, hi] = &self.limit;
        f64::from_rational((lo + hi) / BigRational::from_integer(2.into()), ())
    }
}

impl<S: Arithmetic> From<&timeline::Accumulation<S>> for Accumulation {
    fn from(found: &timeline::Accumulation<S>) -> Self {
        let [from, to] = &found.limit;
        let bounds = from.enclosure().zip(to.enclosure());
        let proven = bounds.filter(|_| found.proven);
        let expected = || {
            let limit = to.to_f64();
            BigRational::from_float(limit).unwrap_or_default()
        };
        Self {
            proven: proven.is_some(),
            limit: match proven {
                Some(((lo, _), (_, hi))) => [lo, hi],
                None => [expected(), expected()],
            },
            word: found.word.clone(),
        }
    }
}

impl fmt::Display for Accumulation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pairs: Vec<_> = self.word.iter().map(Pair::to_string).collect();
        let (pairs, limit) = (pairs.join(", "), self.limit_to_f64());
        write!(f, "infinitely many impacts of {pairs} before t = {limit}")?;
        match self.proven {
            true => Ok(()),
            false => f.write_str(", which is extrapolated and not proven"),
        }
    }
}
