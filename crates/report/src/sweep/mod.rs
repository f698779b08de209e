//! Contents of the page of a sweep, and its pictures.

mod drawing;
mod legend;
mod panel;
mod row;
mod varied;
mod verdict;

pub use drawing::sweep_plots;
pub(crate) use row::SweepRow;
pub(crate) use verdict::SweepVerdict;

use std::path::Path;

use wholestring::{operation::OperationKind, outcome::Scalar};
use wholestring_results::{ResultsError, Summary, Table};
use wholestring_units::UnitSet;

use crate::{Cell, PageHead, PageTable, Place, run::facts, shown_dimension};

/// A sweep as its page shows it. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// The keys that were varied, as written by the user.
    keys: Vec<String>,
    /// The solutions: a row for each model and operation of each case.
    pub(crate) rows: Vec<SweepRow>,
    /// Whether the rows were checked; results of early versions were not.
    checked: bool,
}

/// A scalar that is drawn and listed for each case.
#[derive(Clone, Copy)]
struct Drawn {
    /// Name of its file.
    name: &'static str,
    scalar: &'static Scalar,
    /// Minimum span of its axis, SI.
    min_span: f64,
}

impl Drawn {
    fn dimension(&self) -> &'static str {
        shown_dimension(self.scalar.quantity.kind)
    }
}

/// The scalars that are drawn, in their order.
const DRAWN: [Drawn; 4] = [
    Drawn { name: "hook-load", scalar: Scalar::declared("hook_load_N"), min_span: 2e4 },
    Drawn { name: "torque", scalar: Scalar::declared("surface_torque_N_m"), min_span: 1e3 },
    Drawn { name: "axial-friction", scalar: Scalar::declared("axial_friction_N"), min_span: 1e4 },
    Drawn { name: "cut-off-depth", scalar: Scalar::declared("cutoff_depth_m"), min_span: 20.0 },
];

impl Sweep {
    /// The page of `sweep.csv`, the file at `path`, which has `varied` leading columns of keys, and
    /// of the summaries of its first case and of its last one, as far as they were kept; it opens in
    /// these units, by default in those of the case. `page` returns the address of a case's page
    /// from the name of its folder, if it has one.
    ///
    /// # Errors
    /// A row with an unknown model or operation.
    pub fn new(
        (table, varied): (&Table, usize),
        ends: [Option<&Summary>; 2],
        page: impl Fn(&str) -> Option<String>,
        units: Option<UnitSet>,
        path: &Path,
    ) -> Result<Self, ResultsError> {
        let (keys, answers) = table.columns().split_at(varied);
        let keys = Table::new(keys.to_vec());
        let values = |row: usize| {
            let words = keys.columns().iter().filter_map(|key| keys.words(&key.name));
            words.map(|words| words[row].clone()).collect()
        };
        let rows = SweepRow::read(&Table::new(answers.to_vec()), values, page, path)?;
        // The last case differs from the first in every key that was varied.
        let [mut common, others] = ends.map(|end| end.map_or_else(Vec::new, facts));
        common.retain(|fact| others.contains(fact));
        let title = ends[0].map_or_else(|| "Sweep".into(), |first| first.case.clone());
        let settings = ends[0].map(|first| &first.settings);
        Ok(Self {
            head: PageHead::new(title, units, settings, common),
            keys: keys.columns().iter().map(|column| column.name.clone()).collect(),
            checked: answers.iter().any(|column| column.name == "errors"),
            rows,
        })
    }

    /// Whether no case has ended yet.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The different values of a key, in the order in which they were given.
    fn values(&self, key: usize) -> Vec<&str> {
        let mut values: Vec<&str> = Vec::new();
        for row in &self.rows {
            let value = row.values[key].as_str();
            if !values.contains(&value) {
                values.push(value);
            }
        }
        values
    }

    /// All numbers, a row for each model and operation of each case.
    pub(crate) fn page_table(&self) -> PageTable {
        let heads =
            |names: &[&str]| -> Vec<String> { names.iter().map(|name| (*name).into()).collect() };
        let whole = self.rows.iter().all(|row| row.status == "complete");
        let judged = self.rows.iter().any(|row| row.errors + row.warnings > 0);
        let paged = self.rows.iter().any(|row| row.page.is_some());
        let quantities: Vec<&Drawn> = DRAWN
            .iter()
            .filter(|plot| {
                self.rows.iter().any(|row| row.numbers.contains_key(plot.scalar.quantity.name))
            })
            .collect();
        let row = |row: &SweepRow| {
            let model = row.model.map_or("", |model| model.method().long_name);
            let mut cells: Vec<Cell> = row.values.iter().cloned().map(Cell::Text).collect();
            cells.push(Cell::Text(model.into()));
            cells.push(Cell::Text(row.operation.map_or("", OperationKind::words).to_owned()));
            for quantity in &quantities {
                let number = |end: &str| {
                    row.numbers.get(&format!("{}{end}", quantity.scalar.quantity.name)).copied()
                };
                cells.push(number("").map_or(Cell::Nothing, |value| Cell::Quantity {
                    value,
                    dimension: quantity.dimension().into(),
                    std: number("_std"),
                }));
            }
            if !whole {
                cells.push(Cell::Text(row.status.clone()));
            }
            if judged {
                cells.push(Cell::Text(judgement(row)));
            }
            if paged {
                cells.push(row.page.as_ref().map_or(Cell::Nothing, |href| Cell::Link {
                    text: "open".into(),
                    href: href.clone(),
                }));
            }
            cells
        };
        let titles = quantities.iter().map(|quantity| quantity.scalar.label.to_owned());
        PageTable {
            place: Place::Cases,
            title: "All cases".into(),
            heads: self
                .keys
                .iter()
                .cloned()
                .chain(heads(&["Model", "Operation"]))
                .chain(titles)
                .chain((!whole).then(|| "Status".to_owned()))
                .chain(judged.then(|| "Checks".to_owned()))
                .chain(paged.then(|| "Report".to_owned()))
                .collect(),
            rows: self.rows.iter().map(row).collect(),
        }
    }
}

/// Numbers of errors and warnings of a row, with marks that need no colour.
fn judgement(row: &SweepRow) -> String {
    let count = |mark: &str, many: usize, name: &str| {
        let end = if many == 1 { "" } else { "s" };
        (many > 0).then(|| format!("{mark} {many} {name}{end}"))
    };
    let parts =
        [count("\u{2716}", row.errors, "error"), count("\u{25b2}", row.warnings, "warning")];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests;
