//! Contents of the page of a sweep, and its pictures.

mod drawing;
mod figures;
mod legend;
mod panel;
mod varied;
mod verdict;

pub use figures::sweep_plots;
pub(crate) use verdict::SweepVerdict;

use std::collections::BTreeMap;

use wholestring::{
    operation::OperationKind,
    outcome::{ModelKind, Scalar},
};

use crate::{Cell, PageHead, PageTable, Place, shown_dimension};

/// A sweep as its page shows it. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// The keys that were varied, as written by the user.
    pub keys: Vec<String>,
    /// The solutions: a row for each model and operation of each case.
    pub rows: Vec<SweepRow>,
    /// Whether the rows were checked; results of early versions were not.
    pub checked: bool,
}

/// The result of one model for one operation of one case.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepRow {
    /// The values of the keys, as they were written.
    pub values: Vec<String>,
    /// The method; none where the case had no answer.
    pub model: Option<ModelKind>,
    /// The operation; none where the case had no answer.
    pub operation: Option<OperationKind>,
    /// `complete`, `interrupted` or `failed`.
    pub status: String,
    /// Columns of `sweep.csv` that hold a number here.
    pub numbers: BTreeMap<String, f64>,
    /// Number of checks that are errors.
    pub errors: usize,
    /// Number of checks that are warnings.
    pub warnings: usize,
    /// Sentence of the most severe check, in SI, metric and field units; empty where there is none.
    pub check: [String; 3],
    /// The page of the case, relative to that of the sweep; `None` where the case has none.
    pub page: Option<String>,
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
