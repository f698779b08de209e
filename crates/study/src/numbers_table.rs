//! `[[table]]` as files write it.

use wholestring::{operation::OperationKind, outcome::ModelKind};

use wholestring_config::{
    reader::Reader,
    rule::{List, Prose, Section, Spanned, Text},
    table::{optional, required, table},
};

use crate::{
    chosen::{Choosing, Chosen, MODELS, NAMES, OPERATIONS},
    column::ColumnName,
    file_name::FileName,
    numbers::{NumberTable, Row},
    row_table::RowTable,
    selection::{Selection, SelectionRule},
    sweep::Sweep,
};

table! {
    /// Numbers of the cases compared with given ones, a column for each sweep, model and operation.
    NumbersTable in "[[table]]" {
        /// What stands over it.
        title: String = required(Text);
        /// Name of its files. Default: `table-01` and so on.
        name: String = optional(FileName);
        /// What stands under it on the page.
        caption: String = optional(Prose);
        /// Sweeps that it compares, a column each. Default: all.
        sweeps: Vec<Spanned<String>> = optional(NAMES);
        /// Models that it compares. Default: all that were solved.
        models: Vec<Spanned<ModelKind>> = optional(MODELS);
        /// Operations that it compares. Default: all that were solved.
        operations: Vec<Spanned<OperationKind>> = optional(OPERATIONS);
        /// Cases that its rows are about, by values of varied keys.
        only: Selection = optional(SelectionRule);
        /// Its rows, a number each.
        row: Vec<Spanned<RowTable>> = required(List {
            item: Section::<RowTable>::RULE,
            or_one: false,
            noun: "rows ([[table.row]])",
            most: 1000,
        });
    }
}

impl NumbersTable {
    pub(crate) fn build(
        &self,
        name: String,
        sweeps: &[Sweep],
        columns: &[ColumnName],
        reader: &mut Reader,
    ) -> Option<NumberTable> {
        let choosing = Choosing {
            sweeps: &self.sweeps,
            models: &self.models,
            operations: &self.operations,
            only: &self.only,
        };
        let chosen = choosing.within(&Chosen::all(sweeps), sweeps, reader)?;
        let tables = self.row.get()?;
        let rows: Vec<Row> = tables
            .iter()
            .filter_map(|at| at.value.build(at.place, &chosen, sweeps, columns, reader))
            .collect();
        (rows.len() == tables.len()).then_some(())?;
        Some(NumberTable {
            name,
            title: self.title.get()?.clone(),
            caption: self.caption.text()?,
            rows,
        })
    }
}
