//! The tables of a run.

use std::sync::{Mutex, PoisonError};

use wholestring_case::Records;
use wholestring_results::{
    BOTTOM_HOLE, CONTACT, GrowingTable, NODES, ResultsError, ResultsFolder, SPECTRA, TIME, Table,
    WEAR,
};

use crate::{
    keep::Keep,
    parallel::{in_parallel, lock},
};

/// Name of the table of the bottom of the hole, without its extension.
const BOTTOM_HOLE_FILE: &str = "bottom_hole";

/// Tables of a run, whose rows are collected in memory until they are written.
#[derive(Clone)]
pub(crate) struct RunTables {
    pub(super) nodes: GrowingTable,
    pub(super) time: GrowingTable,
    pub(super) wear: GrowingTable,
    pub(super) contact: GrowingTable,
    pub(super) bottom_hole: Table,
    pub(super) spectra: GrowingTable,
    /// Whether the case requires spectra: their file is then written even without rows.
    with_spectra: bool,
}

impl RunTables {
    /// Creates the tables for these records, without rows.
    pub(super) fn of(records: &Records) -> Self {
        Self::empty(!records.spectra.is_empty() || !records.probes.is_empty())
    }

    fn empty(with_spectra: bool) -> Self {
        Self {
            nodes: GrowingTable::begin("nodes", NODES),
            time: GrowingTable::begin("time", TIME),
            wear: GrowingTable::begin("wear", WEAR),
            contact: GrowingTable::begin("contact", CONTACT),
            bottom_hole: Table::with_columns(BOTTOM_HOLE),
            spectra: GrowingTable::begin("spectra", SPECTRA),
            with_spectra,
        }
    }

    /// Creates the tables from these rows.
    ///
    /// # Errors
    /// The name of a table that a run does not have, or not with these columns.
    pub(crate) fn with(with_spectra: bool, rows: Vec<(String, Table)>) -> Result<Self, String> {
        let mut all = Self::empty(with_spectra);
        let Self { nodes, time, wear, contact, spectra, bottom_hole, .. } = &mut all;
        let mut growing = [nodes, time, wear, contact, spectra];
        for (name, table) in rows {
            let is_taken = match growing.iter_mut().find(|growing| growing.name() == name) {
                Some(growing) => growing.take(table),
                None if name == BOTTOM_HOLE_FILE && table.is_like(bottom_hole) => {
                    *bottom_hole = table;
                    true
                }
                None => false,
            };
            if !is_taken {
                return Err(name);
            }
        }
        Ok(all)
    }

    /// Whether the case requires spectra.
    pub(crate) fn with_spectra(&self) -> bool {
        self.with_spectra
    }

    /// The tables in memory, each with its name.
    pub(crate) fn named(&self) -> [(&'static str, &Table); 6] {
        let entry = |table| (GrowingTable::name(table), GrowingTable::rows(table));
        [
            entry(&self.nodes),
            entry(&self.time),
            entry(&self.wear),
            entry(&self.contact),
            (BOTTOM_HOLE_FILE, &self.bottom_hole),
            entry(&self.spectra),
        ]
    }

    /// Writes the tables that are kept; removes those of an earlier run.
    pub(crate) fn write(
        &mut self,
        folder: &ResultsFolder,
        keep: Keep,
        csv: bool,
    ) -> Result<(), ResultsError> {
        // Most bits leave none.
        if keep >= Keep::Tables && self.bottom_hole.rows() > 0 {
            folder.write_table(BOTTOM_HOLE_FILE, &self.bottom_hole, csv)?;
        } else {
            remove(folder, BOTTOM_HOLE_FILE)?;
        }
        let growing = [&mut self.nodes, &mut self.time, &mut self.wear, &mut self.contact];
        match keep {
            Keep::Summary => growing.into_iter().try_for_each(|table| table.leave_out(folder))?,
            Keep::Tables | Keep::All => write_side_by_side(growing, folder, csv)?,
        }
        if self.with_spectra { self.spectra.write(folder, csv) } else { remove(folder, "spectra") }
    }

    /// Removes tables that are not kept but were written for a checkpoint.
    pub(super) fn remove_all_but_spectra(
        &self,
        folder: &ResultsFolder,
    ) -> Result<(), ResultsError> {
        for table in [&self.nodes, &self.time, &self.wear, &self.contact] {
            remove(folder, table.name())?;
        }
        Ok(())
    }
}

/// Writes tables in parallel, because each waits for the disk and one is much longer than the
/// others.
fn write_side_by_side(
    tables: [&mut GrowingTable; 4],
    folder: &ResultsFolder,
    csv: bool,
) -> Result<(), ResultsError> {
    let tables = tables.map(Mutex::new);
    let written = Mutex::new(Ok(()));
    let order: Vec<usize> = (0..tables.len()).collect();
    in_parallel(tables.len(), &order, |place| {
        if let Err(error) = lock(&tables[place]).write(folder, csv) {
            *lock(&written) = Err(error);
        }
    });
    written.into_inner().unwrap_or_else(PoisonError::into_inner)
}

fn remove(folder: &ResultsFolder, name: &str) -> Result<(), ResultsError> {
    folder.remove(&format!("{name}.parquet"))?;
    folder.remove(&format!("{name}.csv"))
}
