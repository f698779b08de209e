//! What a run has solved so far, and its way to the disk.

mod rows;

pub(crate) use rows::{Effort, bottom_rows};

use serde::{Deserialize, Serialize};
use wholestring::{
    dynamics::ScheduleStep,
    operation::Operation,
    outcome::{ModelKind, Scalars},
    well::Hole,
};
use wholestring_case::{Case, Records};
use wholestring_report::profile;
use wholestring_results::{
    BOTTOM_HOLE, CONTACT, FramesSoFar, Friction, NODES, OperationSummary, ResultsError,
    ResultsFolder, SCHEMA_VERSION, SPECTRA, Status, Summary, TIME, Table, WEAR,
};
use wholestring_units::{Dimension, UnitSet};

use crate::{failure::Failure, frames::Frames, report::along_the_hole};

/// What a run has solved to its end, as a checkpoint keeps it.
#[derive(Serialize, Deserialize)]
pub(crate) struct Solved {
    /// The operations of the summary, as JSON.
    operations: String,
    nodes: Table,
    time: Table,
    wear: Table,
    contact: Table,
    bottom_hole: Table,
    spectra: Table,
    /// Frames up to the checkpoint, of the operation under way too.
    frames: Option<FramesSoFar>,
}

/// Everything that a run leaves.
pub(crate) struct Record {
    pub(crate) summary: Summary,
    nodes: Table,
    time: Table,
    /// Lines of the case's schedule.
    schedule: Vec<ScheduleStep>,
    wear: Table,
    contact: Table,
    bottom_hole: Table,
    spectra: Table,
    /// Frames of the whole string, where the case asks for them.
    pub(crate) frames: Option<Frames>,
    records: Records,
    hole: Hole,
    units: UnitSet,
}

impl Record {
    /// Begins anew in the folder; what an earlier run left to go on with goes.
    pub(crate) fn begin(
        case: &Case,
        units: UnitSet,
        folder: &ResultsFolder,
    ) -> Result<Self, ResultsError> {
        folder.remove_checkpoint()?;
        let frames = Frames::begin(case, folder, None)?;
        Ok(Self::empty(case, units, frames))
    }

    /// Takes up what was solved before, in the same folder.
    pub(crate) fn resume(
        case: &Case,
        units: UnitSet,
        folder: &ResultsFolder,
        solved: Solved,
    ) -> Result<Self, String> {
        let frames = Frames::begin(case, folder, solved.frames).map_err(|e| e.to_string())?;
        let mut record = Self::empty(case, units, frames);
        let operations = serde_json::from_str(&solved.operations);
        record.summary.operations = operations.map_err(|e| e.to_string())?;
        record.nodes = solved.nodes;
        record.time = solved.time;
        record.wear = solved.wear;
        record.contact = solved.contact;
        record.bottom_hole = solved.bottom_hole;
        record.spectra = solved.spectra;
        Ok(record)
    }

    fn empty(case: &Case, units: UnitSet, frames: Option<Frames>) -> Self {
        Self {
            summary: Summary {
                schema_version: SCHEMA_VERSION,
                case: case.name.clone(),
                settings: case.settings.clone(),
                operations: Vec::new(),
            },
            nodes: Table::with_columns(NODES),
            time: Table::with_columns(TIME),
            schedule: case.dynamics.schedule.steps.clone(),
            wear: Table::with_columns(WEAR),
            contact: Table::with_columns(CONTACT),
            bottom_hole: Table::with_columns(BOTTOM_HOLE),
            spectra: Table::with_columns(SPECTRA),
            frames,
            records: case.records.clone(),
            hole: case.model.well.hole.clone(),
            units,
        }
    }

    /// What was solved so far; nothing that was only begun is in it.
    pub(crate) fn solved_so_far(&self) -> Solved {
        // Every field is named: a new one is either found anew or kept.
        let Self {
            summary,
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
            nodes: nodes.clone(),
            time: time.clone(),
            wear: wear.clone(),
            contact: contact.clone(),
            bottom_hole: bottom_hole.clone(),
            spectra: spectra.clone(),
            frames: frames.as_ref().map(|frames| frames.so_far().clone()),
        }
    }

    /// Whether a model has solved an operation already.
    pub(crate) fn has(&self, model: ModelKind, operation: &Operation) -> bool {
        let name = operation.kind.name();
        let mut solved = self.summary.operations.iter();
        solved.any(|solved| solved.model == model && solved.operation == name)
    }

    /// The summary of an operation that was solved to its end.
    fn solved(
        &self,
        model: ModelKind,
        operation: &Operation,
        scalars: Scalars,
    ) -> OperationSummary {
        OperationSummary {
            model,
            operation: operation.kind.name().into(),
            status: Status::Complete,
            friction: Friction::of(&friction(&self.hole)),
            bit_depth_m: operation.bit_depth_m,
            findings: Vec::new(),
            scalars,
            lift: None,
            hydraulics: None,
            statistics: None,
            indicators: None,
            bit_table: None,
            numerics: None,
        }
    }

    /// Writes everything; what an earlier run left goes.
    pub(crate) fn write(&mut self, folder: &ResultsFolder, csv: bool) -> Result<(), Failure> {
        folder.write_table("nodes", &self.nodes, csv)?;
        folder.write_table("time", &self.time, csv)?;
        folder.write_table("wear", &self.wear, csv)?;
        folder.write_table("contact", &self.contact, csv)?;
        if self.records.spectra.is_empty() && self.records.probes.is_empty() {
            folder.remove("spectra.parquet")?;
            folder.remove("spectra.csv")?;
        } else {
            folder.write_table("spectra", &self.spectra, csv)?;
        }
        if self.bottom_hole.rows() == 0 {
            folder.remove("bottom_hole.parquet")?;
            folder.remove("bottom_hole.csv")?;
        } else {
            folder.write_table("bottom_hole", &self.bottom_hole, csv)?;
        }
        match &mut self.frames {
            Some(frames) => frames.write()?,
            None => folder.remove("frames.parquet")?,
        }
        let report = along_the_hole(&self.nodes, &self.wear, &self.summary, Some(self.units));
        match profile(&report, self.units.name()) {
            Some(figure) => {
                folder.write_file("profile.svg", figure.drawing().svg().as_bytes())?;
            }
            None => folder.remove("profile.svg")?,
        }
        // Last, so that a summary tells of tables that are there.
        folder.write_summary(&self.summary)?;
        Ok(())
    }
}

fn friction(hole: &Hole) -> Vec<f64> {
    hole.sections()
        .iter()
        .map(|section| section.friction.kinetic)
        .collect()
}

/// `bit at 4305 m, friction 0.3, mud 1200 kg/m3`
pub(crate) fn subtitle(case: &Case, units: UnitSet) -> String {
    let depth = case
        .operations
        .first()
        .map_or(0.0, |operation| operation.bit_depth_m);
    let friction = match Friction::of(&friction(&case.model.well.hole)) {
        Friction::Uniform(value) => value.to_string(),
        Friction::BySection(values) => values
            .iter()
            .map(f64::to_string)
            .collect::<Vec<_>>()
            .join(", "),
    };
    format!(
        "bit at {}, friction {friction}, mud {}",
        Dimension::Length.format(depth, units),
        Dimension::Density.format(case.model.mud.density_kg_per_m3, units),
    )
}
