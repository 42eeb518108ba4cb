//! What a campaign comes to, by family.

use std::collections::BTreeMap;

use carom::scene::generate::Family;
use comfy_table::{CellAlignment, Table, presets};
use schemars::JsonSchema;
use serde::Serialize;

use super::known::Known;
use super::outcome::{Class, Outcome};
use super::shard::Task;
use super::store::Header;

/// A campaign's outcomes, in the order of families and numbers.
pub(super) struct Summary<'a> {
    header: &'a Header,
    outcomes: Vec<(Task, Outcome)>,
    known: &'a [Known],
}

/// What a campaign comes to, `carom/campaign/1`.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Campaign")]
pub(super) struct Report<'a> {
    #[serde(flatten)]
    header: &'a Header,
    families: Vec<Row>,
    /// All findings, also those that are expected.
    findings: Vec<Finding<'a>>,
    /// What was expected and did not come.
    passing: Vec<String>,
}

/// A family, in numbers.
#[derive(Serialize, JsonSchema)]
struct Row {
    family: &'static str,
    scenes: usize,
    /// So many of each class.
    counts: BTreeMap<Class, usize>,
    /// The largest error of a time, as far as the order is right.
    time_error: f64,
}

/// A scene with which something is wrong.
#[derive(Serialize, JsonSchema)]
struct Finding<'a> {
    /// The family, the seed and the number, such as `near-tie-1-7`.
    scene: String,
    #[serde(flatten)]
    outcome: &'a Outcome,
    /// Whether it is expected.
    known: bool,
}

impl<'a> Summary<'a> {
    pub(super) fn new(
        header: &'a Header,
        outcomes: Vec<(Task, Outcome)>,
        known: &'a [Known],
    ) -> Self {
        Self {
            header,
            outcomes,
            known,
        }
    }

    /// What is wrong and not expected.
    pub(super) fn surprises(&self) -> impl Iterator<Item = &(Task, Outcome)> {
        let found = self.outcomes.iter();
        found.filter(|(task, outcome)| outcome.class.is_finding() && !self.is_known(*task, outcome))
    }

    /// What is expected and does not come.
    pub(super) fn passing(&self) -> Vec<String> {
        let classes = self.outcomes.iter();
        let classes: Vec<_> = classes
            .map(|(task, outcome)| (*task, outcome.class))
            .collect();
        let passing = self.known.iter();
        let passing = passing.filter(|entry| entry.is_passing(&classes, self.header.seed));
        passing.map(Known::told).collect()
    }

    fn is_known(&self, task: Task, outcome: &Outcome) -> bool {
        let mut known = self.known.iter();
        known.any(|entry| entry.expects(task, self.header.seed, outcome.class))
    }

    fn rows(&self) -> Vec<Row> {
        let rows = Family::ALL.into_iter().map(|family| {
            let of_family = self
                .outcomes
                .iter()
                .filter(|(task, _)| task.family == family);
            let outcomes: Vec<_> = of_family.map(|(_, outcome)| outcome).collect();
            Row::new(family, &outcomes)
        });
        rows.filter(|row| row.scenes > 0).collect()
    }

    /// A table for people; classes that do not occur have no column.
    pub(super) fn table(&self) -> Table {
        let rows = self.rows();
        let classes = Class::ALL.into_iter();
        let classes: Vec<_> = classes
            .filter(|class| rows.iter().any(|row| row.count(*class) > 0))
            .collect();
        let mut table = Table::new();
        table.load_preset(presets::ASCII_MARKDOWN);
        let names = classes.iter().map(|class| class.name());
        let names = ["family", "scenes"].into_iter().chain(names);
        table.set_header(names.chain(["time error"]));
        for row in &rows {
            let counts = classes.iter().map(|class| row.count(*class).to_string());
            let start = [row.family.to_owned(), row.scenes.to_string()];
            let end = [format!("{:.1e}", row.time_error)];
            table.add_row(start.into_iter().chain(counts).chain(end));
        }
        for column in table.column_iter_mut().skip(1) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        table
    }

    pub(super) fn report(&self) -> Report<'_> {
        let findings = self.outcomes.iter();
        let findings = findings.filter(|(_, outcome)| outcome.class.is_finding());
        Report {
            header: self.header,
            families: self.rows(),
            findings: findings
                .map(|(task, outcome)| Finding {
                    scene: task.name(self.header.seed),
                    known: self.is_known(*task, outcome),
                    outcome,
                })
                .collect(),
            passing: self.passing(),
        }
    }
}

impl Row {
    fn new(family: Family, outcomes: &[&Outcome]) -> Self {
        let count = |class: Class| {
            let of_class = outcomes.iter().filter(|outcome| outcome.class == class);
            (class, of_class.count())
        };
        let errors = outcomes.iter().map(|outcome| outcome.time_error);
        Self {
            family: family.name(),
            scenes: outcomes.len(),
            counts: Class::ALL.into_iter().map(count).collect(),
            time_error: errors.fold(0.0, f64::max),
        }
    }

    fn count(&self, class: Class) -> usize {
        self.counts.get(&class).copied().unwrap_or_default()
    }
}
