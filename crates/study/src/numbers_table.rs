//! `[[table]]` of study files.

use wholestring_config::prelude::*;

use crate::{
    chosen::{ChoosingKeys, Chosen},
    column::ColumnName,
    file_name::FileName,
    numbers::{NumberTable, Row},
    row_table::RowTable,
    sweep::Sweep,
};

table! {
    /// Numbers of the cases compared with given ones, a column for each sweep, model and operation.
    NumbersTable in "[[table]]" {
        /// Its title.
        title: String = required(Text);
        /// Name of its files. Default: `table-01` and so on.
        name: String = optional(FileName);
        /// Text below it on the page.
        caption: String = optional(Prose);
        ..choosing: ChoosingKeys;
        /// Its rows, one number each.
        row: Vec<Spanned<RowTable>> = required(List::tables::<RowTable>(
            "rows ([[table.row]])", 1000,
        ));
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
        let chosen = self.choosing.within(&Chosen::all(sweeps), sweeps, reader)?;
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
