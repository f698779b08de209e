//! What a page tells of a sweep, and its pictures.

mod figures;

use std::collections::BTreeMap;

use crate::{Cell, DisplayUnit, Fact, Place, Plot, Sheet, plots::spoken};

/// A sweep as its page shows it. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// Name and version of the program.
    pub program: String,
    /// Name of the case.
    pub title: String,
    /// Units that the page opens with: `si`, `metric` or `field`.
    pub units: String,
    /// By dimension: its unit in SI, metric and field units.
    pub dimensions: BTreeMap<String, [DisplayUnit; 3]>,
    /// What was asked of all cases alike.
    pub asked: Vec<Fact>,
    /// The keys that were varied, as they were named.
    pub keys: Vec<String>,
    /// What was solved: a row for each model and operation of each case.
    pub rows: Vec<SweepRow>,
}

/// What one model answered for one operation of one case.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepRow {
    /// The values of the keys, as they were written.
    pub values: Vec<String>,
    /// `soft` or `dynamic`; empty where the case had no answer.
    pub model: String,
    /// `trip_out`, `drill`, ...
    pub operation: String,
    /// `complete`, `interrupted` or `failed`.
    pub status: String,
    /// Columns of `sweep.csv` that hold a number here.
    pub numbers: BTreeMap<String, f64>,
}

/// What is drawn and told of each case.
struct Quantity {
    /// Name of its file.
    name: &'static str,
    title: &'static str,
    dimension: &'static str,
    column: &'static str,
}

const QUANTITIES: &[Quantity] = &[
    Quantity {
        name: "hook-load",
        title: "Hook load",
        dimension: "force",
        column: "hook_load_N",
    },
    Quantity {
        name: "torque",
        title: "Surface torque",
        dimension: "torque",
        column: "surface_torque_N_m",
    },
    Quantity {
        name: "axial-friction",
        title: "Axial friction",
        dimension: "force",
        column: "axial_friction_N",
    },
    Quantity {
        name: "cut-off-depth",
        title: "Cut-off depth",
        dimension: "length",
        column: "cutoff_depth_m",
    },
];

/// Every picture of a sweep, in a set of units (`si`, `metric` or `field`): all quantities in one, then each in one of
/// its own; those with nothing to show are left out.
pub fn sweep_plots(sweep: &Sweep, units: &str) -> Vec<Plot> {
    figures::plots(sweep, units)
}

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
    pub(crate) fn sheet(&self) -> Sheet {
        let heads =
            |names: &[&str]| -> Vec<String> { names.iter().map(|name| (*name).into()).collect() };
        let whole = self.rows.iter().all(|row| row.status == "complete");
        let told: Vec<&Quantity> = QUANTITIES
            .iter()
            .filter(|of| {
                self.rows
                    .iter()
                    .any(|row| row.numbers.contains_key(of.column))
            })
            .collect();
        let row = |row: &SweepRow| {
            let model = match row.model.as_str() {
                "soft" => "soft string",
                "dynamic" => "dynamics",
                other => other,
            };
            let mut cells: Vec<Cell> = row.values.iter().cloned().map(Cell::Text).collect();
            cells.push(Cell::Text(model.into()));
            cells.push(Cell::Text(spoken(&row.operation)));
            for of in &told {
                let number = |end: &str| row.numbers.get(&format!("{}{end}", of.column)).copied();
                cells.push(number("").map_or(Cell::Nothing, |value| Cell::Quantity {
                    value,
                    dimension: of.dimension.into(),
                    std: number("_std"),
                }));
            }
            if !whole {
                cells.push(Cell::Text(row.status.clone()));
            }
            cells
        };
        let titles = told.iter().map(|of| of.title.to_owned());
        Sheet {
            place: Place::Cases,
            title: "All cases".into(),
            heads: self
                .keys
                .iter()
                .cloned()
                .chain(heads(&["Model", "Operation"]))
                .chain(titles)
                .chain((!whole).then(|| "Status".to_owned()))
                .collect(),
            rows: self.rows.iter().map(row).collect(),
        }
    }
}

#[cfg(test)]
mod tests;
