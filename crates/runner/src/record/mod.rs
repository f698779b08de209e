//! What a run has solved so far, and its way to the disk.

mod frames;
pub(crate) mod rows;

use std::borrow::Cow;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::{
    dynamics::ScheduleStep,
    findings::Finding,
    operation::Operation,
    outcome::{Cost, ModelKind},
    well::Hole,
};
use wholestring_case::{Case, Records};
use wholestring_results::{
    BOTTOM_HOLE, CONTACT, ENGINE_VERSION, FramesSoFar, GrowingTable, NODES, ResultsError,
    ResultsFolder, SCHEMA_VERSION, SPECTRA, Summary, TIME, Table, TableSoFar, WEAR, digest,
};
use wholestring_units::UnitSet;

use self::frames::Frames;
use crate::{
    findings::{self, Around},
    keep::Keep,
    page::{FILE, PROFILE, Tables, along_the_hole, write_profile},
};

/// What a run has solved to its end, as a checkpoint keeps it. The tables are large: what was
/// written of them is on the disk.
#[derive(Serialize, Deserialize)]
pub(crate) struct Solved<'a> {
    /// The operations of the summary, as JSON.
    operations: String,
    nodes: TableSoFar<'a>,
    time: TableSoFar<'a>,
    wear: TableSoFar<'a>,
    contact: TableSoFar<'a>,
    bottom_hole: Cow<'a, Table>,
    spectra: TableSoFar<'a>,
    /// Frames up to the checkpoint, of the operation under way too.
    frames: Option<Cow<'a, FramesSoFar>>,
}

/// Name of the table of the bottom of the hole, without the ending of its file.
const BOTTOM_HOLE_FILE: &str = "bottom_hole";

/// Everything that a run leaves.
pub(crate) struct Record {
    pub(crate) summary: Summary,
    /// All that the case's answers depend on.
    pub(crate) identity: Value,
    nodes: GrowingTable,
    time: GrowingTable,
    /// Lines of the case's schedule.
    schedule: Vec<ScheduleStep>,
    wear: GrowingTable,
    contact: GrowingTable,
    bottom_hole: Table,
    spectra: GrowingTable,
    /// Frames of the whole string, where the case requires them.
    pub(crate) frames: Option<Frames>,
    records: Records,
    hole: Hole,
    units: UnitSet,
}

impl Record {
    /// Begins anew in the folder; what an earlier run left to continue with goes.
    pub(crate) fn begin(
        case: &Case,
        units: UnitSet,
        folder: &ResultsFolder,
    ) -> Result<Self, ResultsError> {
        folder.remove_checkpoint()?;
        let frames = Frames::begin(case, folder, None)?;
        Ok(Self::empty(case, units, frames))
    }

    /// Begins anew, with no folder: the rows stay in memory, and no frames are kept.
    pub(crate) fn in_memory(case: &Case, units: UnitSet) -> Self {
        Self::empty(case, units, None)
    }

    /// The lines of the schedule where they are not those of the case: some were added.
    pub(crate) fn schedule_is(&mut self, lines: &[ScheduleStep]) {
        self.schedule = lines.to_vec();
    }

    /// The kinetic coefficients of the hole's sections where they are not those of the case.
    pub(crate) fn friction_is(&mut self, kinetic: &[f64]) {
        let of = |section: usize| kinetic.get(section).copied().unwrap_or(f64::NAN);
        if let Ok(hole) = self.hole.with_friction_of(of) {
            self.hole = hole;
        }
    }

    /// Another with the same rows in memory, to be written: rows that are on the disk leave it.
    pub(crate) fn copy_in_memory(&self) -> Self {
        Self {
            summary: self.summary.clone(),
            identity: self.identity.clone(),
            nodes: self.nodes.clone(),
            time: self.time.clone(),
            schedule: self.schedule.clone(),
            wear: self.wear.clone(),
            contact: self.contact.clone(),
            bottom_hole: self.bottom_hole.clone(),
            spectra: self.spectra.clone(),
            frames: None,
            records: self.records.clone(),
            hole: self.hole.clone(),
            units: self.units,
        }
    }

    /// The tables as they are in memory, each with its name.
    pub(crate) fn tables(&self) -> [(&'static str, &Table); 6] {
        let of = |table| (GrowingTable::name(table), GrowingTable::rows(table));
        [
            of(&self.nodes),
            of(&self.time),
            of(&self.wear),
            of(&self.contact),
            (BOTTOM_HOLE_FILE, &self.bottom_hole),
            of(&self.spectra),
        ]
    }

    /// Takes up what was solved before, in the same folder.
    pub(crate) fn resume(
        case: &Case,
        units: UnitSet,
        folder: &ResultsFolder,
        solved: Solved<'_>,
    ) -> Result<Self, String> {
        let frames = solved.frames.map(Cow::into_owned);
        let frames = Frames::begin(case, folder, frames).map_err(|e| e.to_string())?;
        let mut record = Self::empty(case, units, frames);
        if !solved.bottom_hole.is_like(&record.bottom_hole) {
            return Err("the checkpoint is damaged: a table lacks a column".to_owned());
        }
        let operations = serde_json::from_str(&solved.operations);
        record.summary.operations = operations.map_err(|e| e.to_string())?;
        let growing = |empty: &mut GrowingTable, so_far| {
            empty.resume(folder, so_far).map_err(|e| e.to_string())
        };
        growing(&mut record.nodes, solved.nodes)?;
        growing(&mut record.time, solved.time)?;
        growing(&mut record.wear, solved.wear)?;
        growing(&mut record.contact, solved.contact)?;
        record.bottom_hole = solved.bottom_hole.into_owned();
        growing(&mut record.spectra, solved.spectra)?;
        Ok(record)
    }

    fn empty(case: &Case, units: UnitSet, frames: Option<Frames>) -> Self {
        let identity = case.identity();
        Self {
            summary: Summary {
                schema_version: SCHEMA_VERSION,
                engine_version: Some(ENGINE_VERSION.to_owned()),
                case: case.name.clone(),
                identity: Some(digest(&identity)),
                settings: case.settings.clone(),
                operations: Vec::new(),
            },
            identity,
            nodes: GrowingTable::begin("nodes", NODES),
            time: GrowingTable::begin("time", TIME),
            schedule: case.dynamics.schedule.steps.clone(),
            wear: GrowingTable::begin("wear", WEAR),
            contact: GrowingTable::begin("contact", CONTACT),
            bottom_hole: Table::with_columns(BOTTOM_HOLE),
            spectra: GrowingTable::begin("spectra", SPECTRA),
            frames,
            records: case.records.clone(),
            hole: case.model.well.hole.clone(),
            units,
        }
    }

    /// What was solved so far; nothing that was only begun is in it.
    pub(crate) fn solved_so_far(&self) -> Solved<'_> {
        // Every field is named: a new one is either found anew or kept.
        let Self {
            summary,
            identity: _,
            nodes,
            time,
            wear,
            contact,
            bottom_hole,
            schedule: _,
            spectra,
            frames,
            records: _,
            hole: _,
            units: _,
        } = self;
        Solved {
            operations: serde_json::to_string(&summary.operations).expect("numbers and words"),
            nodes: nodes.so_far(),
            time: time.so_far(),
            wear: wear.so_far(),
            contact: contact.so_far(),
            bottom_hole: Cow::Borrowed(bottom_hole),
            spectra: spectra.so_far(),
            frames: frames.as_ref().map(|frames| Cow::Borrowed(frames.so_far())),
        }
    }

    /// Its summary; all else goes.
    pub(crate) fn into_summary(self) -> Summary {
        self.summary
    }

    /// Whether a model has solved an operation already.
    pub(crate) fn has(&self, model: ModelKind, operation: &Operation) -> bool {
        let name = operation.kind.name();
        let mut solved = self.summary.operations.iter();
        solved.any(|solved| solved.model == model && solved.operation == name)
    }

    /// Shows what was found in the answer that was added last.
    pub(crate) fn judge(&mut self, found: &[Finding], case: &Case) {
        if let Some(last) = self.summary.operations.last_mut() {
            let around = Around {
                rig: &case.model.rig,
                has_helix_friction: case.has_helix_friction(last.model),
                units: self.units,
            };
            last.findings = findings::in_words(found, last, &around);
        }
    }

    /// Writes what is kept; what an earlier run left goes.
    pub(crate) fn write(
        &mut self,
        folder: &ResultsFolder,
        keep: Keep,
        csv: bool,
    ) -> Result<(), ResultsError> {
        // Of most bits there is none.
        if keep >= Keep::Tables && self.bottom_hole.rows() > 0 {
            folder.write_table(BOTTOM_HOLE_FILE, &self.bottom_hole, csv)?;
        } else {
            remove_table(folder, BOTTOM_HOLE_FILE)?;
        }
        let [nodes, time, wear, contact] =
            [&mut self.nodes, &mut self.time, &mut self.wear, &mut self.contact];
        for table in [nodes, time, wear, contact] {
            match keep {
                Keep::Summary => table.leave_out(folder)?,
                Keep::Tables | Keep::All => table.write(folder, csv)?,
            }
        }
        if self.records.spectra.is_empty() && self.records.probes.is_empty() {
            remove_table(folder, "spectra")?;
        } else {
            self.spectra.write(folder, csv)?;
        }
        match &mut self.frames {
            Some(frames) => frames.write()?,
            None => folder.remove("frames.parquet")?,
        }
        if keep == Keep::All {
            let tables = Tables::of_folder(folder.path());
            let report = along_the_hole(&tables, &self.summary, Some(self.units))?;
            write_profile(folder, &report)?;
        } else {
            folder.remove(PROFILE)?;
            folder.remove(FILE)?;
        }
        // Last, so that a summary reports tables that are there.
        let solved = &self.summary.operations;
        if keep == Keep::Summary && solved.iter().all(|of| is_cheap(of.model)) {
            folder.write_compact_summary(&self.summary)?;
        } else {
            folder.write_summary(&self.summary)?;
        }
        Ok(())
    }

    /// Removes the tables that are not kept but whose rows a checkpoint counted on: those of a run
    /// that was begun to keep them. Only once there is no checkpoint.
    pub(crate) fn finish(&self, folder: &ResultsFolder, keep: Keep) -> Result<(), ResultsError> {
        if keep == Keep::Summary {
            for table in [&self.nodes, &self.time, &self.wear, &self.contact] {
                remove_table(folder, table.name())?;
            }
        }
        Ok(())
    }
}

/// Whether what a method answers is solved again rather than read back.
fn is_cheap(model: ModelKind) -> bool {
    model.method().cost == Cost::Milliseconds
}

fn remove_table(folder: &ResultsFolder, name: &str) -> Result<(), ResultsError> {
    folder.remove(&format!("{name}.parquet"))?;
    folder.remove(&format!("{name}.csv"))
}

fn friction(hole: &Hole) -> Vec<f64> {
    hole.sections().iter().map(|section| section.friction.kinetic).collect()
}
