//! Results of a run so far, and writing them to the disk.

mod handed_over;
pub(crate) mod rows;
mod run_tables;

use std::borrow::Cow;

use handed_over::Frames;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::{
    dynamics::{ScheduleStep, Simulation},
    operation::Operation,
    outcome::{Cost, ModelKind},
    well::Hole,
};
use wholestring_case::{Case, Records};
use wholestring_judge::{Checks, Judge};
use wholestring_results::{
    ENGINE_VERSION, FramesSoFar, GrowingTable, ResultsError, ResultsFolder, SCHEMA_VERSION, Status,
    Summary, Table, TableSoFar, digest,
};
use wholestring_units::UnitSet;

use self::handed_over::PART_ROWS;
pub(crate) use self::{handed_over::HandedOver, run_tables::RunTables};
use crate::{
    keep::Keep,
    page::{FILE, PROFILE, write_profile},
};

/// Finished results of a run, as stored in a checkpoint. Tables are large, so those already written
/// remain on the disk.
#[derive(Serialize, Deserialize)]
pub(crate) struct Solved<'a> {
    /// Operations of the summary, as JSON.
    operations: String,
    nodes: TableSoFar<'a>,
    time: TableSoFar<'a>,
    wear: TableSoFar<'a>,
    contact: TableSoFar<'a>,
    bottom_hole: Cow<'a, Table>,
    spectra: TableSoFar<'a>,
    /// Frames up to the checkpoint, including the operation under way.
    frames: Option<Cow<'a, FramesSoFar>>,
}

/// All results of a run.
pub(crate) struct Record {
    pub(crate) summary: Summary,
    /// All settings that the case's answers depend on.
    pub(crate) identity: Value,
    tables: RunTables,
    /// Lines of the case's schedule.
    schedule: Vec<ScheduleStep>,
    /// Frames of the whole string, where the case requires them.
    pub(crate) frames: Option<Frames>,
    records: Records,
    hole: Hole,
    units: UnitSet,
}

impl Record {
    /// Starts a new run in the folder; removes the checkpoint of an earlier run.
    pub(crate) fn begin(
        case: &Case,
        units: UnitSet,
        folder: &ResultsFolder,
    ) -> Result<Self, ResultsError> {
        folder.remove_checkpoint()?;
        let frames = Frames::begin(case, folder, None)?;
        Ok(Self::empty(case, units, frames))
    }

    /// Starts a new run without a folder: rows remain in memory, and no frames are kept.
    pub(crate) fn in_memory(case: &Case, units: UnitSet) -> Self {
        Self::empty(case, units, None)
    }

    /// Replaces the lines of the case's schedule, because some were added.
    pub(crate) fn schedule_is(&mut self, lines: &[ScheduleStep]) {
        self.schedule = lines.to_vec();
    }

    /// Replaces the kinetic friction coefficients of the case's hole sections.
    pub(crate) fn friction_is(&mut self, kinetic: &[f64]) {
        let kinetic = |section: usize| kinetic.get(section).copied().unwrap_or(f64::NAN);
        if let Ok(hole) = self.hole.with_friction_of(kinetic) {
            self.hole = hole;
        }
    }

    /// Returns summary and tables of a run in memory.
    pub(crate) fn into_parts(self) -> (Summary, RunTables) {
        (self.summary, self.tables)
    }

    /// Continues from results solved earlier in the same folder.
    pub(crate) fn resume(
        case: &Case,
        units: UnitSet,
        folder: &ResultsFolder,
        solved: Solved<'_>,
    ) -> Result<Self, String> {
        let frames = solved.frames.map(Cow::into_owned);
        let frames = Frames::begin(case, folder, frames).map_err(|e| e.to_string())?;
        let mut record = Self::empty(case, units, frames);
        let tables = &mut record.tables;
        if !solved.bottom_hole.is_like(&tables.bottom_hole) {
            return Err("the checkpoint is damaged: a table lacks a column".to_owned());
        }
        let operations = serde_json::from_str(&solved.operations);
        record.summary.operations = operations.map_err(|e| e.to_string())?;
        let growing = |empty: &mut GrowingTable, so_far| {
            empty.resume(folder, so_far).map_err(|e| e.to_string())
        };
        growing(&mut tables.nodes, solved.nodes)?;
        growing(&mut tables.time, solved.time)?;
        growing(&mut tables.wear, solved.wear)?;
        growing(&mut tables.contact, solved.contact)?;
        tables.bottom_hole = solved.bottom_hole.into_owned();
        growing(&mut tables.spectra, solved.spectra)?;
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
            tables: RunTables::of(&case.records),
            schedule: case.dynamics.schedule.steps.clone(),
            frames,
            records: case.records.clone(),
            hole: case.model.well.hole.clone(),
            units,
        }
    }

    /// Results of the finished operations; the operation under way is not included.
    pub(crate) fn solved_so_far(&self) -> Solved<'_> {
        // All fields are listed, so that a new field must be either restored or stored.
        let Self {
            summary,
            identity: _,
            tables,
            schedule: _,
            frames,
            records: _,
            hole: _,
            units: _,
        } = self;
        Solved {
            operations: serde_json::to_string(&summary.operations).expect("numbers and words"),
            nodes: tables.nodes.so_far(),
            time: tables.time.so_far(),
            wear: tables.wear.so_far(),
            contact: tables.contact.so_far(),
            bottom_hole: Cow::Borrowed(&tables.bottom_hole),
            spectra: tables.spectra.so_far(),
            frames: frames.as_ref().map(|frames| Cow::Borrowed(frames.so_far())),
        }
    }

    /// Returns the summary and drops the rest.
    pub(crate) fn into_summary(self) -> Summary {
        self.summary
    }

    /// Whether a model has solved an operation already.
    pub(crate) fn has(&self, model: ModelKind, operation: &Operation) -> bool {
        let mut solved = self.summary.operations.iter();
        solved.any(|solved| solved.model == model && solved.operation == operation.kind)
    }

    /// Rows that an operation under way has moved to the disk.
    ///
    /// # Errors
    /// A checkpoint whose operation has moved other rows than those on the disk.
    pub(crate) fn handed_over(
        &self,
        folder: &ResultsFolder,
        simulation: &Simulation,
    ) -> Result<HandedOver, String> {
        let rows = simulation.handed_over();
        let (last, waiting) = self.tables.time.last_part();
        if !rows.is_multiple_of(PART_ROWS) || rows / PART_ROWS > waiting {
            return Err("the checkpoint is damaged: its rows against time".to_owned());
        }
        let parts = last - rows / PART_ROWS + 1..=last;
        let path = |number| self.tables.time.part_path(folder, number);
        Ok(HandedOver::new(parts.map(path).collect()))
    }

    /// Marks the last added answer as failed.
    pub(crate) fn failed(&mut self, reason: String) {
        if let Some(last) = self.summary.operations.last_mut() {
            last.status = Status::Failed(reason);
        }
    }

    /// Adds the checks of the last added answer.
    pub(crate) fn judged(&mut self, checks: Checks) {
        if let Some(last) = self.summary.operations.last_mut() {
            last.checks = checks.governing_of_each_kind();
            last.unchecked = checks.unchecked;
        }
    }

    /// The judge of a case's answers, in the units of the record.
    pub(crate) fn judge(&self, case: &Case) -> Judge {
        case.judge(self.units)
    }

    /// Writes the files that are kept; removes those of an earlier run.
    pub(crate) fn write(
        &mut self,
        folder: &ResultsFolder,
        keep: Keep,
        csv: bool,
    ) -> Result<(), ResultsError> {
        self.tables.write(folder, keep, csv)?;
        match &mut self.frames {
            Some(frames) => frames.write()?,
            None => folder.remove("frames.parquet")?,
        }
        write_summary(folder, keep, &self.summary, self.units)
    }

    /// Removes tables that are not kept but were written for a checkpoint, by a run that was
    /// started to keep them. Called only once there is no checkpoint.
    pub(crate) fn finish(&self, folder: &ResultsFolder, keep: Keep) -> Result<(), ResultsError> {
        match keep {
            Keep::Summary => self.tables.remove_all_but_spectra(folder),
            Keep::Tables | Keep::All => Ok(()),
        }
    }
}

/// Writes the summary, and the profile if all is kept, after the tables.
pub(crate) fn write_summary(
    folder: &ResultsFolder,
    keep: Keep,
    summary: &Summary,
    units: UnitSet,
) -> Result<(), ResultsError> {
    if keep == Keep::All {
        write_profile(folder, summary, units)?;
    } else {
        folder.remove(PROFILE)?;
        folder.remove(FILE)?;
    }
    // Written last, so that the tables that a summary reports exist.
    if keep == Keep::Summary && summary.operations.iter().all(|operation| is_cheap(operation.model))
    {
        folder.write_compact_summary(summary)
    } else {
        folder.write_summary(summary)
    }
}

/// Whether results of a model are solved again instead of read back.
fn is_cheap(model: ModelKind) -> bool {
    model.method().cost == Cost::Milliseconds
}

fn friction(hole: &Hole) -> Vec<f64> {
    hole.sections().iter().map(|section| section.friction.kinetic).collect()
}
