//! What is counted of each formula, and how it is shown.

use std::hint::black_box;
use std::time::Instant;

use crate::exact::Query;
use crate::queries::Kind;
use crate::whole::Truth;
use crate::{FORMULAS, Formula};

/// The names of the columns.
pub(crate) const HEAD: &str =
    "formula             wrong      %       off    median      worst      ns";

/// How a formula did.
struct Score {
    wrong: usize,
    /// Times that are not the nearest.
    off: usize,
    worst: f64,
    /// In ulps.
    errors: Vec<f32>,
    nanos: f64,
}

impl Score {
    /// Nothing yet but the cost.
    fn new(formula: &Formula, queries: &[Query]) -> Self {
        Self {
            wrong: 0,
            off: 0,
            worst: 0.0,
            errors: Vec::new(),
            nanos: cost(formula, queries),
        }
    }

    fn add(&mut self, time: Option<f64>, truth: &Truth) {
        self.wrong += usize::from(time.is_some() != truth.meets());
        if let Some(error) = time.and_then(|time| truth.ulps(time)) {
            self.off += usize::from(error > 0.5);
            self.worst = self.worst.max(error);
            self.errors.push(error as f32);
        }
    }

    fn print(&mut self, formula: &Formula, count: usize) {
        let percent = 100.0 * self.wrong as f64 / count as f64;
        let verdicts = format!("{:9} {percent:6.2}", self.wrong);
        let median = median(&mut self.errors);
        let times = format!("{:9} {median:9.2e} {:10.3e}", self.off, self.worst);
        println!(
            "  {:14} {verdicts} {times} {:7.1}",
            formula.name, self.nanos
        );
    }
}

/// The time that a query takes in the fastest of some rounds, in nanoseconds.
fn cost(formula: &Formula, queries: &[Query]) -> f64 {
    let rounds = (0..20).map(|_| {
        let began = Instant::now();
        for query in queries {
            black_box((formula.solve)(black_box(query)));
        }
        began.elapsed().as_secs_f64()
    });
    rounds.fold(f64::INFINITY, f64::min) * 1e9 / queries.len() as f64
}

/// The middle one of numbers.
fn median(numbers: &mut [f32]) -> f32 {
    if numbers.is_empty() {
        return 0.0;
    }
    let middle = numbers.len() / 2;
    *numbers.select_nth_unstable_by(middle, f32::total_cmp).1
}

/// How all formulas did.
pub(crate) struct Table {
    scores: [Score; FORMULAS.len()],
    /// How close the queries are to tangency and to contact: powers of two.
    closeness: [Vec<f32>; 2],
}

impl Table {
    /// Of no verdicts yet, with what these queries cost.
    pub(crate) fn new(queries: &[Query]) -> Self {
        let score = |formula: &Formula| Score::new(formula, queries);
        Self {
            scores: FORMULAS.each_ref().map(score),
            closeness: [Vec::new(), Vec::new()],
        }
    }

    /// Judges what all formulas make of a query.
    pub(crate) fn add(&mut self, query: &Query) {
        let truth = Truth::of(query);
        for (score, formula) in self.scores.iter_mut().zip(&FORMULAS) {
            score.add((formula.solve)(query), &truth);
        }
        let sizes = [truth.tangency(), truth.gap()];
        for (powers, size) in self.closeness.iter_mut().zip(sizes) {
            powers.push(size.abs().log2() as f32);
        }
    }

    /// After so many queries of a kind.
    pub(crate) fn print(&mut self, kind: &Kind, count: usize) {
        let [tangency, contact] = self.closeness.each_mut().map(|powers| median(powers));
        println!(
            "{count} {}: 2^{tangency:.0} from tangency, 2^{contact:.0} from contact",
            kind.name
        );
        for (score, formula) in self.scores.iter_mut().zip(&FORMULAS) {
            score.print(formula, count);
        }
    }
}
